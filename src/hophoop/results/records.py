"""Records of a motion: events, samples and the energy ledger, in SI units."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, Generic, Literal, Protocol, TypeAlias, TypeVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support import tables
from hophoop.kernel.model import EVENT_NAMES, MODE_LETTERS, utilizations
from hophoop.kernel.native import compiled
from hophoop.results.event_table import change_of, text_table
from hophoop.results.units import Units
from hophoop.scenario import Plane, Scenario
from hophoop.vocabulary.quantities import EVENT_NUMBERS, FRICTION_LOSS, QUANTITIES, held_by

Side = Literal["left", "right"]
Number = TypeVar("Number", float, Decimal)
Numbers = TypeVar("Numbers", float, NDArray[np.float64])
Letters = TypeVar("Letters", str, NDArray[np.str_])
Record = TypeVar("Record")


def documented(kind: str) -> Callable[[type[Record]], type[Record]]:
    """Return a decorator that lists the numbers of a record in its docstring, as the table of quantities describes them.

    kind: type of the numbers, in words.
    """

    def documented_record(record: type[Record]) -> type[Record]:
        held = [QUANTITIES[name] for name in record.__annotations__ if name in QUANTITIES and name != "mode"]
        lines = "".join(f"    {one.name} : {kind}\n        {one.meaning} [{one.unit}].\n" for one in held)
        text = (record.__doc__ or "").rstrip()
        head = "" if "Attributes\n" in text else "\n\n    Attributes\n    ----------"
        record.__doc__ = f"{text}{head}\n{lines}    "
        return record

    return documented_record


@documented("float or Decimal")
@dataclass(frozen=True)
class Velocity(Generic[Number]):
    """Velocities just before an event."""

    vx: Number
    vy: Number
    omega: Number
    slip: Number


@documented("float or Decimal")
@dataclass(frozen=True)
class EventRecord(Generic[Number]):
    """An event, with the state just after it: floats, or Decimals in a motion with `digits`.

    Attributes
    ----------
    kind : str
        Kind of event, such as 'slip_start'.
    from_mode : str or None
        Letter of the mode before; None at the start.
    to_mode : str
        Letter of the mode after.
    before : Velocity
        Velocities just before.
    collision : bool or None
        For an impact: True if the rim approached the plane, False for an impact without collision.
    stable : bool or None
        For a `rest`: True if the equilibrium is stable.
    digits_right : int or None
        With `digits`: how many of them two working precisions have in common, each number relative to itself or to its unit
        made of R, g and m, whichever is larger.
    """

    t: Number
    kind: str
    from_mode: str | None
    to_mode: str
    x: Number
    height: Number
    angle: Number
    vx: Number
    vy: Number
    omega: Number
    slip: Number
    before: Velocity[Number]
    impulse_normal: Number
    impulse_tangential: Number
    friction: Number
    impact_normal: Number
    impact_tangential: Number
    rolling_resistance: Number
    collision: bool | None
    gain: Number
    stable: bool | None
    digits_right: int | None = None

    def __repr__(self) -> str:
        if self.digits_right is not None:
            return f"<{self.kind} at t = {self.t} s, {change_of(self)}: x = {self.x} m, angle = {self.angle} rad>"
        return f"<{self.kind} at t = {self.t:.9g} s, {change_of(self)}: {_numbers(self, (*_STATE, 'slip'))}>"

    def state_to_dict(self) -> dict[str, float | str | None]:
        """Return the state just after the event for JSON.

        Returns
        -------
        state : dict of float
            x, height [m], angle [rad], vx, vy [m/s] and omega [rad/s]; None for a value that is not finite.
        """
        return {name: json_number(getattr(self, name)) for name in _STATE}

    def to_dict(self) -> dict[str, Any]:
        """Return the event as the JSON of the file format.

        Returns
        -------
        event : dict
            Ready for `json.dumps`; SI units and radians.
        """
        result: dict[str, Any] = {
            "t": json_number(self.t),
            "kind": self.kind,
            "from": self.from_mode,
            "to": self.to_mode,
            **self.state_to_dict(),
            "before": {name: json_number(getattr(self.before, name)) for name in ("vx", "vy", "omega")},
            "impulse": {"normal": json_number(self.impulse_normal), "tangential": json_number(self.impulse_tangential)},
        }
        if self.digits_right is not None:
            result["digits_right"] = self.digits_right
        if self.collision is False:
            result["collision"] = False
        if self.kind == "kane_gain":
            result["gain"] = json_number(self.gain)
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


def event_record(row: np.void, unit: Units, t: float) -> EventRecord[float]:
    """Return a row of the kernel's events as a record, with its time `t` in seconds."""
    numbers: dict[str, Any] = {name: float(row[name]) * unit.of(name) for name in EVENT_NUMBERS if name != "t"}
    before = Velocity(**{name: float(row[f"before_{name}"]) * unit.of(name) for name in held_by("Velocity")})
    return EventRecord(
        t=t,
        **names_of(int(row["kind"]), int(row["before_mode"]), int(row["after_mode"])),
        before=before,
        collision=None if row["collision"] < 0 else bool(row["collision"]),
        stable=None if row["stable"] < 0 else bool(row["stable"]),
        **numbers,
    )


def names_of(kind: int, before_mode: int, after_mode: int) -> dict[str, Any]:
    """Return kind and letters of an event from the kernel's codes; a mode of −1 is none."""
    before = MODE_LETTERS[before_mode] if before_mode >= 0 else None
    return {"kind": EVENT_NAMES[kind], "from_mode": before, "to_mode": MODE_LETTERS[after_mode]}


class Events(tuple[EventRecord[float], ...]):
    """Events of a motion in order: a tuple that prints as a table."""

    __slots__ = ()

    def __repr__(self) -> str:
        return text_table(self) if self else "()"


def json_number(value: float | Decimal) -> float | str | None:
    """Return a number for JSON: text for a Decimal, None for what is not finite, as θ̇ of a massless ring whose load strikes."""
    if not math.isfinite(value):
        return None
    return str(value) if isinstance(value, Decimal) else value


@documented("float or ndarray")
@dataclass(frozen=True)
class Sample(Generic[Numbers, Letters]):
    """The state at one time or many; every field is a scalar or an array of the shape of t.

    Attributes
    ----------
    mode : str or ndarray of str
        Letter of the mode: R roll, S and K slip with v_t < 0 and > 0, H flight, M skim.
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


@documented("ndarray, shape (n,)")
@dataclass(frozen=True)
class EventErrors:
    """Estimated errors of the events of a motion, one value per event; inf without derivatives, and from `doubt` on."""

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
    def events(self) -> tuple[EventRecord[float], ...]:
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

    def at(self, t: Any, side: Side = "right") -> Sample[Any, Any]:
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


@documented("float")
@dataclass(frozen=True)
class Ledger:
    """Energy balance of a motion, from its start to its end."""

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
