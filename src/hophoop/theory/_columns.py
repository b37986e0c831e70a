"""Arguments of theory, broadcast against each other and put into the kernels' units."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop.kernel.physics.body import Body
from hophoop.kernel.records.layout import BODY
from hophoop.scenario import Hoop, InputError, Plane, time_unit, to_body

Floats = NDArray[np.float64]
# One hoop or plane, or an array of them.
Hoops = Hoop | Sequence[Hoop] | NDArray[np.object_]
Planes = Plane | Sequence[Plane] | NDArray[np.object_]


class Columns:
    """Hoops, planes and numbers of one common shape, one row for each case.

    `body` has a record of `Body` for each; `length`, `time` and `mass` are the kernels' units in SI. With `resisted` planes may
    have rolling resistance.
    """

    def __init__(self, hoop: Hoops, plane: Planes, *, resisted: bool = False, **numbers: ArrayLike) -> None:
        hoops, planes = _models(hoop, Hoop, "hoop"), _models(plane, Plane, "plane")
        if not resisted:
            for one in planes.ravel():
                require_no_resistance(one)
        values = {name: _finite(name, value) for name, value in numbers.items()}
        try:
            self.shape = np.broadcast_shapes(hoops.shape, planes.shape, *(value.shape for value in values.values()))
        except ValueError:
            shapes = {"hoop": hoops.shape, "plane": planes.shape}
            shapes |= {name: value.shape for name, value in values.items()}
            said = ", ".join(f"{name} {shape}" for name, shape in shapes.items())
            raise InputError(f"The shapes of the arguments do not go together: {said}.") from None
        rows, units = [], []
        # Models are few compared with numbers: each pair is translated once, then broadcast.
        pairs = np.broadcast_arrays(hoops, planes)
        for one, other in zip(pairs[0].ravel(), pairs[1].ravel(), strict=True):
            rows.append(to_body(one, other))
            units.append((one.radius, time_unit(one, other), one.mass))
        pair_shape = pairs[0].shape
        self.body = self._spread(np.array(rows, BODY).reshape(pair_shape), ())
        self.length, self.time, self.mass = np.moveaxis(
            self._spread(np.array(units, dtype=float).reshape((*pair_shape, 3)), (3,)), -1, 0
        )
        self._values = {name: self._spread(value, ()) for name, value in values.items()}

    def _spread(self, values: NDArray[Any], tail: tuple[int, ...]) -> NDArray[Any]:
        whole = np.broadcast_to(values, (*self.shape, *tail)).reshape((-1, *tail))
        return np.ascontiguousarray(whole)

    def __getitem__(self, name: str) -> Floats:
        return self._values[name]

    def bodies(self) -> list[Body]:
        """The Body of each case."""
        return [Body(*row) for row in self.body.tolist()]

    @property
    def speed(self) -> Floats:
        """Unit of speed [m/s]."""
        result: Floats = self.length / self.time
        return result

    @property
    def force(self) -> Floats:
        """Unit of force [N]."""
        result: Floats = self.mass * self.length / (self.time * self.time)
        return result

    def of_speed(self, name: str) -> Floats:
        """A speed in the kernels' units."""
        result: Floats = self._values[name] / self.speed
        return result

    def new(self, *tail: int) -> Floats:
        """An array for a result, one row for each case."""
        return np.empty((self.body.shape[0], *tail))

    def shaped(self, values: Any) -> Any:
        """A result in the common shape; a plain number where all arguments were."""
        whole = np.asarray(values).reshape(self.shape)
        return whole.item() if whole.ndim == 0 else whole

    def require(self, good: Callable[[Any], Any], column: str, sentence: str) -> None:
        """Refuse cases; `column` is a field of Body, and the sentence has a place {} for its value."""
        values = self.body[column]
        bad = ~np.asarray(good(values), dtype=bool)
        if bad.any():
            raise InputError(sentence.format(f"{values[bad][0].item()!r}"))


def require_no_resistance(plane: Plane) -> None:
    """Refuse rolling resistance, with which no closed form is known."""
    given = plane.rolling_resistance
    if given > 0.0:
        raise InputError.of_field("plane.rolling_resistance", given, "0 here: with rolling resistance this is not known")


def _models(value: Any, kind: type, name: str) -> NDArray[np.object_]:
    if isinstance(value, kind):
        single = np.empty((), dtype=object)
        single[()] = value
        return single
    many = np.array(value, dtype=object)
    for one in many.ravel():
        if not isinstance(one, kind):
            raise InputError.of_field(name, one, f"a {kind.__name__}, or an array of them")
    return many


def _finite(name: str, value: ArrayLike) -> Floats:
    try:
        numbers = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise InputError.of_field(name, value, "a number or an array of numbers") from None
    if not np.isfinite(numbers).all():
        raise InputError.of_field(name, numbers[~np.isfinite(numbers)].flat[0], "a finite number")
    return numbers
