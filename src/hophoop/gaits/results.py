"""The passages of a section as a table in SI units, and what they say about the motion."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.gaits.kernels.layout import COLUMNS
from hophoop.kernel.model import MODE_LETTERS
from hophoop.kernel.numerics.arithmetic import TWO_PI, TWO_PI_LOW
from hophoop.kernel.records import unpacked_sequence
from hophoop.results.units import Units
from hophoop.scenario import InputError, Scenario, Start
from hophoop.vocabulary.names import Fate
from hophoop.vocabulary.quantities import LOSSES

if TYPE_CHECKING:
    import xarray

Floats = NDArray[np.float64]
ENOUGH = 500  # passages from which on a motion may be called chaotic
SURE = 5.0  # standard errors by which its exponent must be above 0
SEPARATED = 36.0  # ln 2⁵²: neighbouring doubles must have come apart, also next to a gait that is hardly unstable


class Lyapunov(NamedTuple):
    """Mean rate at which near motions separate.

    Attributes
    ----------
    value : float
        Mean of the logarithm of the growth per passage [1].
    error : float
        Its standard error, from the scatter of batches of successive passages [1].
    passages : int
        Passages that it is the mean of.
    """

    value: float
    error: float
    passages: int

    @property
    def is_chaotic(self) -> bool:
        """Whether it is above 0 by 5 standard errors, and near doubles separate within so many passages."""
        return self.value > SURE * self.error > 0.0 and self.value * self.passages > SEPARATED


def dataset(columns: Iterable[tuple[str, Any, str, str]], axes: Sequence[str], attributes: dict[str, Any]) -> xarray.Dataset:
    """Return columns of name, values, unit and meaning over the same axes as an xarray.Dataset."""
    xr = need("xarray", "maps")
    variables = {name: (axes, values, {"units": unit, "long_name": meaning}) for name, values, unit, meaning in columns}
    found: xarray.Dataset = xr.Dataset(variables, attrs=attributes)
    return found


_VARIABLES = (
    ("t", "s", "Time of the passage"),
    ("x", "m", "Position of the centre along the plane"),
    ("height", "m", "Gap between rim and plane"),
    ("angle", "rad", "Angle from the plane's normal to the centre of gravity"),
    ("omega", "rad/s", "Angular velocity"),
    ("slip", "m/s", "Slip velocity of the lowest point"),
    ("vy", "m/s", "Velocity of the centre away from the plane"),
    ("hops", "1", "Hops since the last passage"),
    ("distance", "m", "Distance since the last passage"),
    ("friction", "J", "Energy lost in slip since the last passage"),
    ("impact_normal", "J", "Energy lost in impacts, normal to the plane, since the last passage"),
    ("impact_tangential", "J", "Energy lost in impacts, along the plane, since the last passage"),
    ("rolling_resistance", "J", "Energy lost to rolling resistance since the last passage"),
)


def _si(name: str, about: str) -> property:
    """Return a property of `Passages`: a column of the kernel in SI units."""
    return property(lambda passages: passages._column(name) * passages._unit.of(name), doc=about)


@dataclass(frozen=True)
class Passages:
    """Passages of a section, one row each; made by `hophoop.passages`.

    Attributes
    ----------
    scenario : Scenario
    section : {'bottom', 'landing'}
    numbers : ndarray, shape (n, len(COLUMNS))
        The kernel's rows, in units of R, m and √(R/g) [1].
    packed : ndarray of int, shape (n, 2)
        The kernel's words [1].
    status : str
        How the motion ended: 'going' if it goes on.
    decided : Fate
        The fate that physics decides, without the Lyapunov exponent.
    period : int
        Of a gait, in passages; else 0, also of a gait that passes the section no more [1].
    """

    scenario: Scenario
    section: str
    numbers: Floats
    packed: NDArray[np.uint64]
    status: str
    decided: Fate
    period: int

    def __len__(self) -> int:
        return len(self.numbers)

    # --- columns -----------------------------------------------------------------------------------

    def _column(self, name: str) -> Floats:
        found: Floats = self.numbers[:, COLUMNS.index(name)]
        return found

    def _since(self, name: str) -> Floats:
        """Return the change of an energy since the last passage, for the first one since the start."""
        found: Floats = np.diff(self._column(name), prepend=0.0) * self._unit.of(name)
        return found

    @cached_property
    def _unit(self) -> Units:
        return Units.of_scenario(self.scenario)

    t = _si("t", "Times since the start [s].")
    x = _si("x", "Positions of the centre along the plane [m].")
    height = _si("height", "Gaps between rim and plane [m].")
    omega = _si("omega", "Angular velocities θ̇ [rad/s].")
    slip = _si("slip", "Slip velocities v_t [m/s].")
    vy = _si("vy", "Velocities of the centre away from the plane [m/s].")

    @property
    def angle(self) -> Floats:
        """θ with all its revolutions [rad]."""
        turns = self._column("turns")
        return turns * TWO_PI + (self._column("theta") + (self._column("theta_low") + turns * TWO_PI_LOW))

    @property
    def hops(self) -> NDArray[np.int64]:
        """Hops since the last passage [1]."""
        return np.diff(self._column("hops"), prepend=0.0).astype(np.int64)

    @property
    def distance(self) -> Floats:
        """Distances along the plane since the last passage [m]."""
        found: Floats = np.diff(self.x, prepend=self.scenario.start.x)
        return found

    @property
    def doubt(self) -> float:
        """Time from which double precision does not decide the motion; inf if it always does [s]."""
        return float(np.nanmin(self._column("doubt"), initial=np.inf)) * self._unit.time

    @cached_property
    def mode(self) -> tuple[str, ...]:
        """Letters of the modes at the passages."""
        return tuple(MODE_LETTERS[int(code)] for code in self._column("mode"))

    @cached_property
    def sequences(self) -> tuple[str, ...]:
        """Phases since the last passage, one letter each, such as 'RSHKR'; a very long sequence ends in '+'."""
        known = {key: unpacked_sequence(key) for key in {tuple(row) for row in self.packed.tolist()}}
        return tuple(known[tuple(row)] for row in self.packed.tolist())

    def loss(self, name: str) -> Floats:
        """Return what was lost since the last passage.

        Parameters
        ----------
        name : {'friction', 'impact_normal', 'impact_tangential', 'rolling_resistance'}

        Returns
        -------
        loss : ndarray, shape (n,)
            [J].

        Raises
        ------
        ValueError
            If it is none of them.
        """
        if name not in LOSSES:
            raise InputError.of_field("name", name, f"one of {', '.join(LOSSES)}")
        return self._since(name)

    def start(self, index: int) -> Start:
        """Return the start that goes on from a passage.

        Parameters
        ----------
        index : int
            Of the passage; −1 for the last one.

        Returns
        -------
        start : Start
            With its slip velocity and mode.

        Raises
        ------
        ValueError
            If there is no such passage.
        """
        if not -len(self) <= index < len(self):
            raise InputError.of_field("index", index, f"of one of {len(self)} passages")
        state = {name: float(getattr(self, name)[index]) for name in ("x", "height", "angle", "vy", "omega", "slip")}
        return Start(**state, vx=state["slip"] + self.scenario.hoop.radius * state["omega"], mode=self.mode[index])

    # --- what becomes of it ------------------------------------------------------------------------

    @cached_property
    def fate(self) -> Fate:
        """What becomes of the motion in the end; 'undecided' if the run was too short to say."""
        if self.decided != Fate.UNDECIDED or self.status != "going" or len(self) < ENOUGH or not self.scenario.plane.slope:
            return self.decided
        return Fate.CHAOTIC if self.lyapunov.is_chaotic else Fate.UNDECIDED

    @cached_property
    def lyapunov(self) -> Lyapunov:
        """Mean rate at which near motions separate, per passage, after the first tenth of the passages."""
        from hophoop.gaits.maps import lyapunov_of

        return lyapunov_of(self)

    def to_xarray(self) -> xarray.Dataset:
        """Return the passages as an xarray.Dataset, one entry per passage.

        Returns
        -------
        dataset : xarray.Dataset
            Every variable has units and long_name.

        Raises
        ------
        ImportError
            If xarray is missing.
        """
        columns = [
            (name, self._since(name) if name in LOSSES else getattr(self, name), unit, meaning)
            for name, unit, meaning in _VARIABLES
        ]
        columns.append(("mode", np.array(self.mode, dtype=str), "1", "Mode at the passage"))
        columns.append(("sequence", np.array(self.sequences, dtype=str), "1", "Phases since the last passage"))
        attributes = {
            "Conventions": "CF-1.11",
            "title": f"Passages of a loaded hoop: {self.fate}",
            "section": self.section,
            "fate": str(self.fate),
            "period": self.period,
            "scenario": str(self.scenario.to_query()),
        }
        return dataset(columns, ("passage",), attributes)

    def __repr__(self) -> str:
        fate = f"gait of period {self.period}" if self.period else str(self.decided)
        last = ", ".join(self.sequences[-3:])
        return f"<Passages: {len(self)} of section {self.section!r}, {fate}{'; last sequences ' + last if last else ''}>"
