"""A gait: a motion that repeats itself after some passages of its section."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support import tables
from hophoop._support.errors import check_whole
from hophoop.gaits.points import Point, SectionDerivative, derivative, point_of
from hophoop.gaits.results import Passages
from hophoop.scenario import Scenario
from hophoop.scenario.start import StartState
from hophoop.simulation.phases import PhaseRecord, phases
from hophoop.simulation.simulate import simulate
from hophoop.vocabulary.quantities import LOSSES

if TYPE_CHECKING:
    from hophoop.gaits.branch import Branch
    from hophoop.gaits.digits import PreciseGait
    from hophoop.simulation.trajectory import Trajectory

MOST_PERIODS = 100_000
NARROW = 2.0**-27  # distance at which another piece of the map is next to a gait
LONGER = 1.001  # of the time to the last landing, which is looked for


@dataclass(frozen=True, eq=False)
class Gait:
    """A periodic gait; made by `hophoop.gaits.find`.

    Attributes
    ----------
    passages : Passages
        Those of one period, from a start on the gait.
    """

    passages: Passages

    @cached_property
    def scenario(self) -> Scenario:
        """It starts on the gait, at a passage of the section, and lasts a period."""
        return self.passages.scenario.replace("duration", self.time)

    @property
    def section(self) -> str:
        """The section, 'bottom' or 'landing', as in `hophoop.passages`."""
        return self.passages.section

    @property
    def period(self) -> int:
        """Passages after which the motion repeats itself [1]."""
        return len(self.passages)

    @property
    def state(self) -> StartState:
        """The state at the passage from which the gait starts, in SI units."""
        return self.scenario.start.state(self.scenario.hoop)

    @property
    def sequence(self) -> str:
        """Phases of a period, with a point at each passage within it, such as 'RSHKR' or 'RSRKR·RSHKR'."""
        return "·".join(self.passages.sequences)

    @cached_property
    def derivative(self) -> SectionDerivative:
        """Derivative of the return map over the whole period."""
        return derivative(self.scenario, self.period, section=self.section)

    @cached_property
    def _point(self) -> Point:
        return point_of(self.passages)

    @property
    def multipliers(self) -> NDArray[np.float64] | NDArray[np.complex128]:
        """Factors by which small differences change in a period, the largest first; complex only in pairs [1]."""
        return self._point.multipliers(exact=True)

    @property
    def stable(self) -> bool:
        """Whether small differences shrink, on both sides of a corner of the map."""
        across = (abs(other.multiplier) for other in self._point.beside(NARROW) if other.comes_back)
        return bool(abs(self.multipliers[0]) < 1.0) and not any(other >= 1.0 for other in across)

    @property
    def time(self) -> float:
        """Time of a period [s]."""
        return float(self.passages.t[-1])

    @property
    def distance(self) -> float:
        """Distance along the plane in a period [m]."""
        return float(self.passages.x[-1]) - self.state.x

    @property
    def revolutions(self) -> int:
        """Revolutions in a period."""
        return round((float(self.passages.angle[-1]) - self.state.angle) / (2.0 * math.pi))

    @property
    def speed(self) -> float:
        """Mean velocity of the centre along the plane [m/s]."""
        return self.distance / self.time

    @property
    def hops(self) -> int:
        """Hops in a period."""
        return int(self.passages.hops.sum())

    @cached_property
    def hop_height(self) -> float:
        """Height of the highest hop: gap between rim and plane [m]; 0 without hops."""
        return max((event.height for event in self.motion().find("apex") if event.to_mode == "H"), default=0.0)

    @cached_property
    def losses(self) -> dict[str, float]:
        """Energy lost in a period, by cause; the sum is what the slope gives [J]."""
        return {name: float(self.passages.loss(name).sum()) for name in LOSSES}

    @property
    def phases(self) -> Iterator[PhaseRecord]:
        """Phases of a period with their margins, and why each ends: see `hophoop.phases`."""
        return phases(self.scenario)

    @property
    def residual(self) -> float:
        """Largest difference of the states a period apart, in units of R and √(g/R) relative to 1 + θ̇ [1]."""
        return self._point.off()

    def motion(self, periods: int = 1) -> Trajectory:
        """Return the motion of some periods.

        Parameters
        ----------
        periods : int, default 1
            From 1 to 100,000.

        Returns
        -------
        motion : Trajectory

        Raises
        ------
        ValueError
            If the number is not allowed.
        """
        check_whole("periods", periods, 1, MOST_PERIODS)
        whole = periods * self.time
        if self.section == "landing":  # to include the last landing
            return simulate(self.scenario.replace("duration", whole * LONGER), until=f"landings:{periods * self.period}")
        return simulate(self.scenario.replace("duration", whole))

    def follow(self, path: str, bounds: tuple[float, float], progress: Callable[[float], object] | None = None) -> Branch:
        """Follow the gait over a parameter of hoop or plane, through folds and boundaries of its sequence.

        Parameters
        ----------
        path : str
            Of the parameter, such as 'plane.slope'.
        bounds : (float, float)
            Its range, around the gait's value [SI].
        progress : callable, optional
            Called with the computed share, 0 to 1.

        Returns
        -------
        branch : Branch
            Its gaits and special points. Stopped by Ctrl-C, it holds what is done.

        Raises
        ------
        ValueError
            If the path is no parameter that can be followed, or the range does not hold the gait's value.
        """
        from hophoop.gaits.following import follow

        return follow(self, path, bounds, progress)

    def to_dict(self) -> dict[str, Any]:
        """Return all numbers as a dict for JSON, in SI units.

        Returns
        -------
        numbers : dict
        """
        names = ("time", "distance", "speed", "revolutions", "hops", "hop_height", "losses")
        return {
            "section": self.section,
            "period": self.period,
            "sequence": self.sequence,
            "state": {name: float(value) for name, value in self.state._asdict().items()},
            "multipliers": [[float(one.real), float(one.imag)] for one in self.multipliers],
            "stable": self.stable,
            **{name: getattr(self, name) for name in names},
            "scenario": self.scenario.to_dict(),
        }

    def digits(self, digits: int = 30) -> PreciseGait:
        """Compute the gait in arbitrary precision, by a method independent of the kernel's.

        Parameters
        ----------
        digits : int, default 30
            From 16 to 40 [1].

        Returns
        -------
        precise : PreciseGait

        Raises
        ------
        ValueError
            If digits is not allowed, or the motion in arbitrary precision does not come back to the section.
        """
        from hophoop.gaits.digits import precise_gait

        return precise_gait(self, digits)

    def __repr__(self) -> str:
        kind = "stable" if self.stable else "unstable"
        return (
            f"<Gait: {self.sequence}, {kind}, multiplier {self.multipliers[0]:.6g}, {self.speed:.6g} m/s, "
            f"{_counted(self.hops, 'hop')} in {_counted(abs(self.revolutions), 'revolution')}>"
        )

    def _repr_html_(self) -> str:
        """The gait in a notebook: its numbers, and a picture of one period."""
        rows = {
            "sequence": self.sequence,
            "multiplier": f"{self.multipliers[0]:.9g}",
            "stable": "yes" if self.stable else "no",
            "mean speed": f"{self.speed:.6g} m/s",
            "time of a period": f"{self.time:.6g} s",
            "hops": f"{self.hops} in {_counted(abs(self.revolutions), 'revolution')}, up to {self.hop_height:.4g} m",
        }
        return tables.html(list(rows.items()), left=(0, 1)) + self.motion()._repr_html_()


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
