"""Arguments of theory, broadcast and put into the kernels' units."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop.scenario import Hoop, InputError, Plane, time_unit, to_body

Floats = NDArray[np.float64]


class Columns:
    """Numbers of one common shape, one for each case, with one hoop and one plane.

    `body` is in the kernels' units; `length`, `time` and `mass` are these units in SI. With `resisted` the plane may have
    rolling resistance.
    """

    def __init__(self, hoop: Hoop, plane: Plane, *, resisted: bool = False, **numbers: ArrayLike) -> None:
        for name, value, kind in (("hoop", hoop, Hoop), ("plane", plane, Plane)):
            if not isinstance(value, kind):
                raise InputError.of_field(name, value, f"a {kind.__name__}")
        if not resisted:
            require_no_resistance(plane)
        values = {name: _finite(name, value) for name, value in numbers.items()}
        try:
            self.shape = np.broadcast_shapes(*(value.shape for value in values.values()))
        except ValueError:
            said = ", ".join(f"{name} {value.shape}" for name, value in values.items())
            raise InputError(f"The shapes of the arguments do not go together: {said}.") from None
        self.length, self.time, self.mass = hoop.radius, time_unit(hoop, plane), hoop.mass
        self.body = to_body(hoop, plane)
        self._values = {name: np.broadcast_to(value, self.shape).flatten() for name, value in values.items()}

    def __getitem__(self, name: str) -> Floats:
        return self._values[name]

    @property
    def speed(self) -> float:
        """Unit of speed [m/s]."""
        return self.length / self.time

    @property
    def force(self) -> float:
        """Unit of force [N]."""
        return self.mass * self.length / (self.time * self.time)

    def of_speed(self, name: str) -> Floats:
        """A speed in the kernels' units."""
        result: Floats = self._values[name] / self.speed
        return result

    def new(self, *tail: int) -> Floats:
        """An array for a result, one row for each case."""
        return np.empty((math.prod(self.shape), *tail))

    def shaped(self, values: Any) -> Any:
        """A result in the common shape; a plain number where all arguments were."""
        whole = np.asarray(values).reshape(self.shape)
        return whole.item() if whole.ndim == 0 else whole

    def require(self, good: Callable[[Any], Any], column: str, sentence: str) -> None:
        """Refuse a hoop or plane; `column` is a field of Body, and the sentence has a place {} for its value."""
        value = getattr(self.body, column)
        if not good(value):
            raise InputError(sentence.format(f"{value!r}"))


def require_no_resistance(plane: Plane) -> None:
    """Refuse rolling resistance, with which no closed form is known."""
    given = plane.rolling_resistance
    if given > 0.0:
        raise InputError.of_field("plane.rolling_resistance", given, "0 here: with rolling resistance this is not known")


def _finite(name: str, value: ArrayLike) -> Floats:
    try:
        numbers = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise InputError.of_field(name, value, "a number or an array of numbers") from None
    if not np.isfinite(numbers).all():
        raise InputError.of_field(name, numbers[~np.isfinite(numbers)].flat[0], "a finite number")
    return numbers
