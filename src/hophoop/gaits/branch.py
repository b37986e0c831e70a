"""Branches of gaits over a parameter with their special points: what `Gait.follow` returns."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.gaits.gait import Gait
from hophoop.gaits.points import Point
from hophoop.gaits.results import dataset
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
        about = parameter(self.path)
        columns = (
            ("parameter", self.parameter, about.unit or "1", about.description),
            ("omega", self.omega, "rad/s", "Angular velocity at the passage"),
            ("multiplier", self.multiplier, "1", "Multiplier of the period"),
            ("sequence", np.array(self.sequences), "1", "Phases of a period"),
        )
        return dataset(columns, ("point",), {"path": self.path, "period": self.period})

    def __repr__(self) -> str:
        kinds = ", ".join(one.kind for one in self.special)
        return (
            f"<Branch: {len(self.parameter)} gaits over {self.path} from {self.parameter.min():.6g} to "
            f"{self.parameter.max():.6g}; {kinds}>"
        )
