"""Branches of gaits over a parameter, through folds and boundaries of the sequence, with their special points."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.gaits.continuation import Follower, Point
from hophoop.gaits.equation import GaitEquation, bounds_around, value_of
from hophoop.gaits.gait import Gait
from hophoop.gaits.section import check_no_unit
from hophoop.gaits.special import Special
from hophoop.scenario import InputError, Scenario
from hophoop.scenario.paths import parameter

if TYPE_CHECKING:
    import xarray

Progress = Callable[[float], object]
TENTH = 0.1


@dataclass(frozen=True)
class Branch:
    """A branch of gaits; made by `Gait.follow`.

    Attributes
    ----------
    points : tuple of Point, length n
        Coordinates, map and equation of each gait, in the order along the branch.
    special : tuple of Special
        In the order along the branch.
    complete : bool
        False if it was stopped.
    """

    points: tuple[Point, ...]
    special: tuple[Special, ...]
    complete: bool = True

    @property
    def equation(self) -> GaitEquation:
        """The equation at its beginning."""
        return self.points[0].equation

    @cached_property
    def parameter(self) -> NDArray[np.float64]:
        """The parameter, shape (n,) [SI]."""
        return np.array([point.equation.parameter(point.place) for point in self.points])

    @cached_property
    def omega(self) -> NDArray[np.float64]:
        """θ̇ at the section, shape (n,) [rad/s]."""
        return np.array([point.equation.omega(point.place) for point in self.points])

    @cached_property
    def multiplier(self) -> NDArray[np.float64]:
        """The multiplier of the largest modulus, of a complex pair its real part, shape (n,) [1]."""
        return np.array([point.values.multiplier for point in self.points])

    @property
    def sequences(self) -> tuple[str, ...]:
        """Phases of a period as in `Gait`, length n."""
        return tuple(point.values.sequence for point in self.points)

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Where the gait is stable, shape (n,)."""
        return np.array([point.values.radius < 1.0 for point in self.points])

    @property
    def hops(self) -> NDArray[np.int64]:
        """Hops of a period, shape (n,)."""
        return np.array([sum("H" in part for part in sequence.split("·")) for sequence in self.sequences])

    def gait(self, index: int) -> Gait:
        """Return the gait of a point.

        Parameters
        ----------
        index : int

        Returns
        -------
        gait : Gait
        """
        return self.points[index].equation.gait(self.points[index].place)

    def to_dict(self) -> dict[str, Any]:
        """Return all numbers as a dict for JSON, in SI units.

        Returns
        -------
        numbers : dict
        """
        names = ("kind", "event", "parameter", "omega")
        special = [
            {name: getattr(one, name) for name in names} | {"multipliers": list(one.multipliers)} for one in self.special
        ]
        columns = {name: getattr(self, name).tolist() for name in ("parameter", "omega", "multiplier")}
        about = {"path": self.equation.path, "period": self.equation.period}
        return {**about, **columns, "sequence": list(self.sequences), "special": special}

    def to_xarray(self) -> xarray.Dataset:
        """Return the branch as an xarray.Dataset over its points.

        Returns
        -------
        dataset : xarray.Dataset

        Raises
        ------
        ImportError
            If xarray is missing.
        """
        xr = need("xarray", "maps")
        about = parameter(self.equation.path)
        variables: dict[str, Any] = {
            "parameter": ("point", self.parameter, {"units": about.unit or "1", "long_name": about.description}),
            "omega": ("point", self.omega, {"units": "rad/s", "long_name": "Angular velocity at the passage"}),
            "multiplier": ("point", self.multiplier, {"units": "1", "long_name": "Multiplier of the period"}),
            "sequence": ("point", np.array(self.sequences, dtype=str), {"units": "1", "long_name": "Phases of a period"}),
        }
        dataset: xarray.Dataset = xr.Dataset(variables, attrs={"path": self.equation.path, "period": self.equation.period})
        return dataset

    def __repr__(self) -> str:
        kinds = ", ".join(one.kind for one in self.special)
        return (
            f"<Branch: {len(self.parameter)} gaits over {self.equation.path} from {self.parameter.min():.6g} to "
            f"{self.parameter.max():.6g}; {kinds}>"
        )


def follow(gait: Gait, path: str, bounds: tuple[float, float], progress: Progress | None = None) -> Branch:
    """Follow a gait over a parameter, from the branch's end below it to that above; `Gait.follow` calls and describes this."""
    value, low, high = range_of(gait.scenario, path, bounds)
    equation = GaitEquation(gait.scenario, gait.period, path, TENTH * (high - low), gait.section, gait.passages.mode[-1])
    place = equation.place(gait.state, value)
    found = equation.solve(place, np.eye(len(place))[-1], float(place[-1]))
    if found is None:
        raise InputError.of_field("path", path, "a parameter whose derivative exists at this gait")
    first = Point(*found, equation)
    halves = [Follower(first, (low / equation.scale, high / equation.scale)) for _ in range(2)]
    complete = True
    try:
        for k, half in enumerate(halves):
            sign = 1.0 if (first.values.tangent[-1] > 0.0) == (k == 1) else -1.0
            half.run(sign * first.values.tangent)
            if progress is not None:
                progress(0.5 * (k + 1))
    except KeyboardInterrupt:
        complete = False
    back, ahead = halves
    points = [*reversed(back.points), *ahead.points[1:]]
    special = [_turned(one) for one in reversed(back.special)] + ahead.special
    return Branch(tuple(points), tuple(special), complete)


def range_of(scenario: Scenario, path: str, bounds: tuple[float, float]) -> tuple[float, float, float]:
    """Return a scenario's value of a parameter, and the bounds between which its gaits are followed; refuse others."""
    value = value_of(scenario, path)
    check_no_unit(scenario, path)
    low, high = bounds_around(path, value, bounds)
    if path == "plane.slope" and low < 0.0 < high:
        raise InputError.of_field("bounds", bounds, "slopes of one sign: on the level there is no gait")
    return value, low, high


def _turned(special: Special) -> Special:
    """Return a special point met in the other direction."""
    event = special.event
    if " | " in event:
        boundary, _, words = event.rpartition(": ")
        one, _, other = words.partition(" | ")
        event = f"{boundary}: {other} | {one}"
    return special._replace(multipliers=special.multipliers[::-1], event=event)
