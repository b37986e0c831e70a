"""Branches of gaits over a parameter with their special points: what `Gait.follow` returns."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.gaits.computing import passages
from hophoop.gaits.differences import Floats
from hophoop.gaits.gait import Gait
from hophoop.gaits.maps import Image, SectionMap, eigenvalues
from hophoop.scenario.paths import parameter

if TYPE_CHECKING:
    import xarray

FOLD, DOUBLING, BORDER, JOINS, TOP, END, LIMIT = (
    "fold", "period doubling", "border collision", "joins a shorter period", "top of the hill", "end", "limit of the range",
)  # fmt: skip


class Special(NamedTuple):
    """A special point of a branch.

    Attributes
    ----------
    kind : str
        'fold', 'period doubling', 'border collision', 'joins a shorter period', 'top of the hill', 'end' or 'limit of
        the range'.
    event : str
        Of a border collision the boundary ('hop vanishes', 'phase vanishes', 'impact: slip just stops' or 'slip at the
        section') and the sequences on both sides; of an end the boundary that is met there, if one is; else empty.
    path : str
        Of the parameter.
    parameter : float
        [SI].
    omega : float
        θ̇ at the section [rad/s].
    multipliers : tuple of float
        Before and after it along the branch; one where they are the same [1].
    gait : Gait
        At or just before it.
    """

    kind: str
    event: str
    path: str
    parameter: float
    omega: float
    multipliers: tuple[float, ...]
    gait: Gait

    def __repr__(self) -> str:
        event = f" ({self.event})" if self.event else ""
        factors = " to ".join(f"{one:.6g}" for one in self.multipliers)
        return f"<{self.kind}{event} at {self.path} = {self.parameter:.12g}, multiplier {factors}>"


@dataclass(frozen=True, eq=False)
class Point:
    """A gait of a branch.

    Attributes
    ----------
    map : SectionMap
    place : ndarray
        Coordinates and scaled parameter.
    image : Image
        Of the place.
    """

    map: SectionMap
    place: Floats
    image: Image

    @cached_property
    def rates(self) -> Floats:
        """Derivative of the map by the place."""
        return self.map.rates(self.image, self.place)

    @cached_property
    def exact_rates(self) -> Floats:
        """The same from wider differences."""
        return self.map.rates(self.image, self.place, exact=True)

    @property
    def exact_multiplier(self) -> float:
        """The multiplier from them, of a complex pair its real part [1]."""
        return float(eigenvalues(self.exact_rates[:, :-1])[0].real)

    @property
    def known(self) -> bool:
        """Whether the derivative exists."""
        return bool(np.isfinite(self.rates).all())

    @cached_property
    def multiplier(self) -> complex:
        """The eigenvalue of the largest modulus [1]."""
        return complex(eigenvalues(self.rates[:, :-1])[0])

    @property
    def omega(self) -> float:
        """θ̇ at the section [rad/s]."""
        return self.map.omega(self.place)

    @property
    def parameter(self) -> float:
        """The parameter [SI]."""
        return float(self.place[-1]) * self.map.scale

    @property
    def gait(self) -> Gait:
        """The gait."""
        return Gait(passages(self.map.at(self.place), self.map.period, section=self.map.section))

    @cached_property
    def tangent(self) -> Floats:
        """Unit vector along the branch."""
        found: Floats = np.linalg.svd(self.rates - np.eye(*self.rates.shape))[2][-1]
        return found

    @property
    def apart(self) -> float:
        """Difference of the state from that after a part of the period."""
        return self.map.apart(self.image, self.place)

    def off(self, critical: float, *, exact: bool = False) -> float:
        """Return det(derivative − critical), which is 0 where a multiplier has this value; nan without a derivative."""
        if not self.known:
            return math.nan
        rates = self.exact_rates if exact else self.rates
        return float(np.linalg.det(rates[:, :-1] - critical * np.eye(len(rates))))

    def near(self, guess: Floats, normal: Floats) -> Point | None:
        """Return the gait near a guess, on the plane through it with a normal."""
        found = self.map.solve(guess, normal, self.rates if self.known else None)
        return None if found is None else Point(self.map, *found)

    def ahead(self, way: Floats, step: float) -> Point | None:
        """Return the gait a step further along a direction."""
        return self.near(self.place + step * way, way)

    def distance(self, other: Point) -> float:
        """Return the distance of another point in θ̇ and the parameter, which all modes have."""
        return math.hypot((other.omega - self.omega) / self.map.unit, other.place[-1] - self.place[-1])


@dataclass(frozen=True)
class Branch:
    """A branch of gaits; made by `Gait.follow`.

    Attributes
    ----------
    points : tuple of Point, length n
        In the order along the branch.
    special : tuple of Special
        In the order along the branch.
    complete : bool
        False if it was stopped.
    """

    points: tuple[Point, ...]
    special: tuple[Special, ...]
    complete: bool = True

    @property
    def path(self) -> str:
        """Path of the parameter."""
        return self.points[0].map.path

    @property
    def period(self) -> int:
        """Passages of a period [1]."""
        return self.points[0].map.period

    @property
    def section(self) -> str:
        """The section, 'bottom' or 'landing'."""
        return self.points[0].map.section

    @cached_property
    def parameter(self) -> NDArray[np.float64]:
        """The parameter, shape (n,) [SI]."""
        return np.array([point.parameter for point in self.points])

    @cached_property
    def omega(self) -> NDArray[np.float64]:
        """θ̇ at the section, shape (n,) [rad/s]."""
        return np.array([point.omega for point in self.points])

    @cached_property
    def multiplier(self) -> NDArray[np.float64]:
        """The multiplier of the largest modulus, of a complex pair its real part, shape (n,) [1]."""
        return np.array([point.multiplier.real for point in self.points])

    @property
    def sequences(self) -> tuple[str, ...]:
        """Phases of a period as in `Gait`, length n."""
        return tuple(point.image.sequence for point in self.points)

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Where the gait is stable, shape (n,)."""
        return np.array([abs(point.multiplier) < 1.0 for point in self.points])

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
        return self.points[index].gait

    def to_dict(self) -> dict[str, Any]:
        """Return all numbers as a dict for JSON, in SI units.

        Returns
        -------
        numbers : dict
        """
        names = ("kind", "event", "parameter", "omega", "multipliers")
        special = [{name: getattr(one, name) for name in names} for one in self.special]
        columns = {name: getattr(self, name).tolist() for name in ("parameter", "omega", "multiplier")}
        about = {"path": self.path, "period": self.period}
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
        about = parameter(self.path)
        columns = (
            ("parameter", self.parameter, about.unit or "1", about.description),
            ("omega", self.omega, "rad/s", "Angular velocity at the passage"),
            ("multiplier", self.multiplier, "1", "Multiplier of the period"),
            ("sequence", np.array(self.sequences), "1", "Phases of a period"),
        )
        variables = {name: ("point", values, {"units": unit, "long_name": told}) for name, values, unit, told in columns}
        dataset: xarray.Dataset = xr.Dataset(variables, attrs={"path": self.path, "period": self.period})
        return dataset

    def __repr__(self) -> str:
        kinds = ", ".join(one.kind for one in self.special)
        return (
            f"<Branch: {len(self.parameter)} gaits over {self.path} from {self.parameter.min():.6g} to "
            f"{self.parameter.max():.6g}; {kinds}>"
        )
