"""Records of a motion: events, samples and the energy ledger, in SI units."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Generic, Literal, Protocol, TypeAlias, TypeVar, cast, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support import tables
from hophoop.kernel.native import compiled
from hophoop.kernel.physics.body import EVENT_NAMES, MODE_LETTERS
from hophoop.kernel.physics.friction import utilizations
from hophoop.results.event_table import change_of, text_table
from hophoop.results.units import Units
from hophoop.scenario import Plane, Scenario
from hophoop.vocabulary.quantities import EVENT_NUMBERS, FRICTION_LOSS, QUANTITIES, held_by

Side = Literal["left", "right"]
Numbers = TypeVar("Numbers", float, NDArray[np.float64])
Letters = TypeVar("Letters", str, NDArray[np.str_])
Record = TypeVar("Record")


@dataclass(frozen=True)
class Velocity:
    """Velocities just before an event.

    Attributes
    ----------
    vx : float
        Velocity of the centre along the plane [m/s].
    vy : float
        Velocity of the centre away from the plane [m/s].
    omega : float
        Angular velocity θ̇ [rad/s].
    slip : float
        Slip velocity v_t of the lowest point [m/s].
    """

    vx: float
    vy: float
    omega: float
    slip: float


@dataclass(frozen=True)
class EventRecord:
    """An event, with the state just after it.

    Attributes
    ----------
    t : float
        Time [s].
    kind : str
        Kind of event, such as 'slip_start'.
    from_mode : str or None
        Letter of the mode before; None at the start.
    to_mode : str
        Letter of the mode after.
    x : float
        Position of the centre along the plane [m].
    height : float
        Gap between rim and plane [m].
    angle : float
        θ, from the plane's outward normal to C→G, clockwise; it counts whole revolutions [rad].
    vx : float
        Velocity of the centre along the plane [m/s].
    vy : float
        Velocity of the centre away from the plane [m/s].
    omega : float
        Angular velocity θ̇ [rad/s].
    slip : float
        Slip velocity v_t of the lowest point [m/s].
    before : Velocity
        Velocities just before.
    impulse_normal : float
        Normal impulse of an impact, else 0 [N s].
    impulse_tangential : float
        Impulse of an impact along the plane, else 0 [N s].
    friction : float
        Energy lost in slip, from the start to just after the event [J].
    impact_normal : float
        Energy lost so far in impacts, normal to the plane [J].
    impact_tangential : float
        Energy lost so far in impacts, along the plane [J].
    rolling_resistance : float
        Energy lost so far to rolling resistance [J].
    collision : bool or None
        For an impact: True if the rim approached the plane, False for an impact without collision.
    gain : float
        Energy created by Newton's law in a `kane_gain`, else 0 [J].
    stable : bool or None
        For a `rest`: True if the equilibrium is stable.
    """

    t: float
    kind: str
    from_mode: str | None
    to_mode: str
    x: float
    height: float
    angle: float
    vx: float
    vy: float
    omega: float
    slip: float
    before: Velocity
    impulse_normal: float
    impulse_tangential: float
    friction: float
    impact_normal: float
    impact_tangential: float
    rolling_resistance: float
    collision: bool | None
    gain: float
    stable: bool | None

    def __repr__(self) -> str:
        numbers = _numbers(self, (*_STATE, "slip"))
        return f"<{self.kind} at t = {self.t:.9g} s, {change_of(self)}: {numbers}>"

    def state_to_dict(self) -> dict[str, float | None]:
        """Return the state just after the event for JSON.

        Returns
        -------
        state : dict of float
            x, height [m], angle [rad], vx, vy [m/s] and omega [rad/s]; None for a value that is not finite.
        """
        return {name: _finite(getattr(self, name)) for name in _STATE}

    def to_dict(self) -> dict[str, Any]:
        """Return the event as the JSON of the file format.

        Returns
        -------
        event : dict
            Ready for `json.dumps`; SI units and radians.
        """
        result: dict[str, Any] = {
            "t": self.t,
            "kind": self.kind,
            "from": self.from_mode,
            "to": self.to_mode,
            **self.state_to_dict(),
            "before": {name: _finite(getattr(self.before, name)) for name in ("vx", "vy", "omega")},
            "impulse": {"normal": self.impulse_normal, "tangential": self.impulse_tangential},
        }
        if self.collision is False:
            result["collision"] = False
        if self.kind == "kane_gain":
            result["gain"] = self.gain
        if self.stable is not None:
            result["stable"] = self.stable
        return result


_STATE = ("x", "height", "angle", "vx", "vy", "omega")
_LINES = (  # of a sample's text
    ("x", "height", "angle"), ("vx", "vy", "omega", "slip"), ("friction_force", "normal_force"), ("kinetic", "potential"),
    ("friction", "impact_normal", "impact_tangential", "rolling_resistance", "spring", "damping"),
)  # fmt: skip
_FIRST, _LAST = 3, 2  # rows of the text of samples at many times


def _numbers(thing: Any, names: Iterable[str]) -> str:
    return ", ".join(f"{name} = {getattr(thing, name):.6g} {QUANTITIES[name].unit}" for name in names)


def event_record(row: np.void, unit: Units, t: float) -> EventRecord:
    """Return a row of the kernel's events as a record, with its time `t` in seconds."""
    value = {name: float(row[name]) * unit.of(name) for name in EVENT_NUMBERS if name != "t"}
    before = Velocity(**{name: float(row[f"before_{name}"]) * unit.of(name) for name in held_by("Velocity")})
    before_mode = int(row["before_mode"])
    return EventRecord(
        t=t,
        kind=EVENT_NAMES[row["kind"]],
        from_mode=MODE_LETTERS[before_mode] if before_mode >= 0 else None,
        to_mode=MODE_LETTERS[row["after_mode"]],
        before=before,
        collision=None if row["collision"] < 0 else bool(row["collision"]),
        stable=None if row["stable"] < 0 else bool(row["stable"]),
        **value,
    )


class Events(tuple[EventRecord, ...]):
    """Events of a motion in order: a tuple that prints as a table."""

    __slots__ = ()

    def __repr__(self) -> str:
        return text_table(self) if self else "()"


def _finite(value: float) -> float | None:
    # θ̇ of a massless ring is unbounded as its load strikes; JSON has no infinity
    return value if math.isfinite(value) else None


@dataclass(frozen=True)
class Sample(Generic[Numbers, Letters]):
    """The state at one time or many; every field is a scalar or an array of the shape of t.

    Attributes
    ----------
    t : float or ndarray
        Time [s].
    mode : str or ndarray of str
        Letter of the mode: R roll, S and K slip with v_t < 0 and > 0, H flight, M skim.
    x : float or ndarray
        Position of the centre along the plane [m].
    height : float or ndarray
        Gap between rim and plane [m].
    angle : float or ndarray
        θ, from the plane's outward normal to C→G, clockwise; it counts whole revolutions [rad].
    vx : float or ndarray
        Velocity of the centre along the plane [m/s].
    vy : float or ndarray
        Velocity of the centre away from the plane [m/s].
    omega : float or ndarray
        Angular velocity θ̇ [rad/s].
    slip : float or ndarray
        Slip velocity v_t of the lowest point [m/s].
    friction_force : float or ndarray
        Friction F along +x [N].
    normal_force : float or ndarray
        Normal force N [N].
    kinetic : float or ndarray
        Kinetic energy [J].
    potential : float or ndarray
        Potential energy, zero with the load at the top in contact at x = 0 [J].
    friction : float or ndarray
        Energy lost so far in slip; `friction_loss` is this and what friction takes in impacts [J].
    impact_normal : float or ndarray
        Energy lost so far in impacts, normal to the plane [J].
    impact_tangential : float or ndarray
        Energy lost so far in impacts, along the plane [J].
    rolling_resistance : float or ndarray
        Energy lost so far to rolling resistance [J].
    spring : float or ndarray
        Energy stored in a compliant contact; 0 in rigid contact [J].
    damping : float or ndarray
        Energy lost so far in the damper of a compliant contact; 0 in rigid contact [J].
    """

    t: Numbers
    mode: Letters
    x: Numbers
    height: Numbers
    angle: Numbers
    vx: Numbers
    vy: Numbers
    omega: Numbers
    slip: Numbers
    friction_force: Numbers
    normal_force: Numbers
    kinetic: Numbers
    potential: Numbers
    friction: Numbers
    impact_normal: Numbers
    impact_tangential: Numbers
    rolling_resistance: Numbers
    spring: Numbers
    damping: Numbers

    def __repr__(self) -> str:
        if np.ndim(self.t) == 0:
            lines = [[name for name in names if names is not _LINES[-1] or getattr(self, name)] for names in _LINES]
            text = "".join(f"\n  {_numbers(self, names)}" for names in lines if names)
            return f"<Sample at t = {self.t:.9g} s, mode {self.mode}>{text}"
        head = f"Sample at {np.size(self.t):,} times"
        if not np.size(self.t):
            return f"<{head}>"
        return tables.report(f"{head}, {np.min(self.t):.6g} to {np.max(self.t):.6g} s", _rows_of(self, _FIRST, _LAST), left=())

    def _repr_html_(self) -> str:
        if np.ndim(self.t):
            titles, *rows = _rows_of(self, 2 * _FIRST, 2 * _FIRST)
            return tables.html(rows, titles, left=())
        rows = [
            [name, f"{getattr(self, name):.6g} {QUANTITIES[name].unit}", QUANTITIES[name].meaning]
            for name in ("t", *(name for names in _LINES for name in names))
        ]
        return tables.html([["mode", str(self.mode), "Mode"], *rows], left=(0, 2))

    @property
    def total(self) -> Numbers:
        """Kinetic and potential energy [J]."""
        return self.kinetic + self.potential

    @property
    def friction_loss(self) -> Numbers:
        """Energy lost to friction so far, in slip and along the plane in impacts [J]."""
        return self.friction + self.impact_tangential

    @property
    def normal_loss(self) -> Numbers:
        """Energy lost normal to the plane so far, in impacts or in a compliant contact's damper [J]."""
        return self.impact_normal + self.damping

    def utilization(self, plane: Plane, signed: bool = False) -> Numbers:
        """Return the friction utilization: abs(F)/(μ N) with μk in slip, else μs.

        Parameters
        ----------
        plane : Plane
            The plane, with the friction coefficients.
        signed : bool, default False
            True for the sign of F.

        Returns
        -------
        utilization : float or ndarray
            From 0 to 1 [1]: 1 in slip with friction, nan in flight.
        """
        share = utilization_of(
            np.isin(self.mode, ("S", "K")), self.friction_force, self.normal_force, plane.mu_static, plane.mu_kinetic
        )
        if signed:
            # in slip the mode gives the sign, even if F vanishes with N
            sign = np.select([np.equal(self.mode, "S"), np.equal(self.mode, "K")], [1.0, -1.0], np.sign(self.friction_force))
            share = share * sign
        return cast("Numbers", share if share.ndim else float(share))


def _rows_of(sample: Any, first: int, last: int) -> list[list[str]]:
    """Return titles and the rows of the first and the last times."""
    names: tuple[str, ...] = ("t", *_STATE, "slip")
    rows = [["mode", *(f"{name} ({QUANTITIES[name].unit})" for name in names)]]
    size = int(np.size(sample.t))
    shown: list[int | None] = [*range(size)]
    if size > first + last:
        shown = [*range(first), None, *range(size - last, size)]
    modes = np.ravel(sample.mode)
    fields = [np.ravel(getattr(sample, name)) for name in names]
    for k in shown:
        rows.append(["…"] * len(rows[0]) if k is None else [str(modes[k]), *(f"{field[k]:.6g}" for field in fields)])
    return rows


ScalarSample: TypeAlias = Sample[float, str]
ArraySample: TypeAlias = Sample[NDArray[np.float64], NDArray[np.str_]]


@dataclass(frozen=True)
class EventErrors:
    """Estimated errors of the events of a motion, one value per event; inf if rounding may change what follows.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Error of the time [s].
    x : ndarray, shape (n,)
        Error of the position of the centre along the plane [m].
    height : ndarray, shape (n,)
        Error of the gap between rim and plane [m].
    angle : ndarray, shape (n,)
        Error of θ [rad].
    vx : ndarray, shape (n,)
        Error of the velocity of the centre along the plane [m/s].
    vy : ndarray, shape (n,)
        Error of the velocity of the centre away from the plane [m/s].
    omega : ndarray, shape (n,)
        Error of θ̇ [rad/s].
    slip : ndarray, shape (n,)
        Error of the slip velocity [m/s].
    """

    t: NDArray[np.float64]
    x: NDArray[np.float64]
    height: NDArray[np.float64]
    angle: NDArray[np.float64]
    vx: NDArray[np.float64]
    vy: NDArray[np.float64]
    omega: NDArray[np.float64]
    slip: NDArray[np.float64]

    def __repr__(self) -> str:
        rows = [(name, f"{np.max(getattr(self, name)):.1e} {QUANTITIES[name].unit}") for name in ("t", *_STATE, "slip")]
        return tables.report(f"Errors of {len(self.t)} events, at most", rows if len(self.t) else [], left=(0, 1))


class Motion(Protocol):
    """Protocol of a computed motion for code that shows or writes it: the public members of `hophoop.Trajectory`."""

    scenario: Scenario
    version: str
    until: str | None

    @property
    def status(self) -> str:
        """How the motion ended."""

    @property
    def sequence(self) -> str:
        """One letter per phase."""

    @property
    def fingerprint(self) -> str:
        """Hash of the bits of all events."""

    @property
    def duration(self) -> float:
        """Duration of the motion [s]."""

    @property
    def events(self) -> tuple[EventRecord, ...]:
        """All events in order."""

    @property
    def tables(self) -> dict[str, np.ndarray]:
        """Events and segments as the kernel wrote them, in its own units."""

    @property
    def units(self) -> Units:
        """SI values of the kernel units."""

    @property
    def kernel_doubt(self) -> float:
        """Time from which double precision cannot decide the motion, in kernel units; inf if everything is certain."""

    @overload
    def at(self, t: float, side: Side = ...) -> ScalarSample: ...

    @overload
    def at(self, t: NDArray[np.float64] | Sequence[float], side: Side = ...) -> ArraySample: ...

    @overload
    def at(self, t: ArrayLike, side: Side = ...) -> Sample[Any, Any]: ...

    def at(self, t: ArrayLike, side: Side = "right") -> Sample[Any, Any]:
        """Return the state at any time."""

    def times(self, n: int = 1000) -> NDArray[np.float64]:
        """Return equally spaced times over the motion [s]."""

    def to_dict(self) -> dict[str, Any]:
        """Return the motion as JSON."""


def utilization_of(
    slips: ArrayLike, friction: ArrayLike, normal: ArrayLike, mu_static: ArrayLike, mu_kinetic: ArrayLike
) -> NDArray[np.float64]:
    """Return the friction utilization, in slip or not; see `Sample.utilization`.

    friction, normal: F and N, in any one unit [N]; mu_static, mu_kinetic: μs and μk [1]; utilization: abs(F)/(μ N) [1].
    """
    numbers = (np.asarray(each, float) for each in (friction, normal, mu_static, mu_kinetic))
    columns = np.broadcast_arrays(np.asarray(slips, bool), *numbers)
    share = np.empty(columns[0].shape)
    slipping, force, pressure, mu_s, mu_k = (np.array(column).reshape(-1) for column in columns)
    compiled(utilizations)(slipping, force, pressure, mu_s, mu_k, share.reshape(-1))
    return share


@dataclass(frozen=True)
class Ledger:
    """Energy balance of a motion, from its start to its end.

    Attributes
    ----------
    kinetic : float
        Kinetic energy at the end [J].
    potential : float
        Potential energy at the end, zero with the load at the top in contact at x = 0 [J].
    friction : float
        Lost in slip; `friction_loss` is this and what friction takes in impacts [J].
    impact_normal : float
        Lost in impacts, in the direction normal to the plane; may be negative under Newton's and Poisson's laws [J].
    impact_tangential : float
        Lost in impacts, along the plane [J].
    rolling_resistance : float
        Lost to rolling resistance [J].
    spring : float
        Stored in a compliant contact at the end; 0 in rigid contact [J].
    damping : float
        Lost in the damper of a compliant contact; 0 in rigid contact [J].
    residual : float
        Residual: kinetic + potential + spring + losses at the end, minus kinetic + potential at the start [J].
    range : float
        Scale of the energies that took part, for comparison with the residual [J].
    """

    kinetic: float
    potential: float
    friction: float
    impact_normal: float
    impact_tangential: float
    rolling_resistance: float
    spring: float
    damping: float
    residual: float
    range: float

    def __repr__(self) -> str:
        return tables.report("Ledger of a motion", self._rows(), left=(0, 2))

    def _repr_html_(self) -> str:
        return tables.html(self._rows(), left=(0, 2))

    def _rows(self) -> list[tuple[str, str, str]]:
        meanings = {name: QUANTITIES[name].meaning for name in held_by("Ledger")}
        names = list(meanings)
        meanings["friction_loss"] = FRICTION_LOSS
        names.insert(names.index("impact_tangential") + 1, "friction_loss")
        always = ("kinetic", "potential", "residual")
        return [
            (name, f"{getattr(self, name):.6g} J", meanings[name]) for name in names if name in always or getattr(self, name)
        ]

    @property
    def friction_loss(self) -> float:
        """Energy lost to friction, in slip and along the plane in impacts [J]."""
        return self.friction + self.impact_tangential

    @property
    def normal_loss(self) -> float:
        """Energy lost normal to the plane, in impacts or in a compliant contact's damper [J]."""
        return self.impact_normal + self.damping
