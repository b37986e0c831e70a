"""A precise motion with its events in decimal numbers and SI units."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from functools import cached_property
from typing import Any

from hophoop.kernel.model import EVENT_NAMES, STATUS_NAMES, kinetic_energy, potential_energy
from hophoop.precise.kernels import Number
from hophoop.precise.motion import Record
from hophoop.precise.problem import Body
from hophoop.precise.solver import Solution, solve
from hophoop.results.event_table import change_of
from hophoop.results.records import EventRecord, Velocity, json_number, names_of
from hophoop.scenario import InputError, Scenario
from hophoop.vocabulary.names import STATUSES, sequence_of
from hophoop.vocabulary.quantities import QUANTITIES


@dataclass(frozen=True)
class PreciseMotion:
    """A motion in as many digits as asked; made by `hophoop.simulate` with ``digits=``.

    Attributes
    ----------
    scenario : Scenario
        Its doubles are taken as the exact numbers that they are.
    digits : int
        Digits asked for [1].
    status : str
        How the motion ended: completed, at_rest, jammed, undetermined or event_limit.
    sequence : str
        One letter per phase: R roll, S spin, K skid, H flight (hop), M skim.
    events : tuple of EventRecord
        All events in order.
    energy : dict of Decimal
        Energies at the end, all that was lost on the way, and the residual that does not add up [J].
    version : str
        Of hophoop.
    ending : str
        What ended the motion: 'duration', what ``until`` asked for, such as 'landings:2', or else its status.
    """

    scenario: Scenario
    digits: int
    status: str
    sequence: str
    events: tuple[EventRecord[Decimal], ...]
    energy: dict[str, Decimal]
    version: str
    ending: str = "duration"

    @property
    def ok(self) -> bool:
        """True if the motion reached its end: completed or at rest."""
        return STATUSES[self.status].ok

    @property
    def duration(self) -> Decimal:
        """Time from the start to the end of the motion, however it ended [s]."""
        return self.events[-1].t

    @cached_property
    def digits_right(self) -> int:
        """Digits that every event has [1]; fewer than asked where more precision did not help."""
        return min((event.digits_right or 0 for event in self.events), default=0)

    def find(self, kind: str) -> tuple[EventRecord[Decimal], ...]:
        """The events of one kind.

        Parameters
        ----------
        kind : str
            Such as 'takeoff'.

        Returns
        -------
        events : tuple of EventRecord

        Raises
        ------
        ValueError
            If there is no such kind.
        """
        if kind not in EVENT_NAMES:
            raise InputError.of_field("kind", kind, ", ".join(EVENT_NAMES), rule="is not one of")
        return tuple(event for event in self.events if event.kind == kind)

    def to_dict(self) -> dict[str, Any]:
        """The motion as the JSON of the file format, with decimal strings for numbers and ``digits``.

        Returns
        -------
        result : dict
            Ready for `json.dumps`; SI units and radians.
        """
        final = self.events[-1]
        return {
            "schema": "hophoop/1",
            "version": self.version,
            "digits": self.digits,
            "digits_right": self.digits_right,
            "scenario": self.scenario.to_dict(),
            "status": self.status,
            "sequence": self.sequence,
            "events": [event.to_dict() for event in self.events],
            "final": {"t": json_number(final.t), "mode": final.to_mode, **final.state_to_dict()},
            "energy": {name: json_number(value) for name, value in self.energy.items()},
        }

    def __repr__(self) -> str:
        lines = [
            f"<PreciseMotion {self.sequence} {self.status}: {len(self.events)} events in {self.duration:.6g} s, "
            f"{self.digits} digits asked, {self.digits_right} right>"
        ]
        for event in self.events[:40]:
            lines.append(f"  {event.kind:<22} {change_of(event):<6} t = {event.t} s, θ = {event.angle}")
        if len(self.events) > 40:
            lines.append(f"  … and {len(self.events) - 40} more")
        return "\n".join(lines)


class Units:
    """SI values of R, m and √(R/g) at the working precision, and decimals of so many digits."""

    def __init__(self, body: Body, digits: int) -> None:
        self.ctx = body.ctx
        self.digits = digits
        speed = body.length / body.time
        self.energy = body.mass * speed * speed
        self._scales = {
            "time": body.time,
            "length": body.length,
            "angle": 1,
            "speed": speed,
            "rate": 1 / body.time,
            "impulse": body.mass * speed,
            "energy": self.energy,
        }

    def of(self, name: str) -> Number:
        """Unit of a quantity."""
        return self._scales[QUANTITIES[name].scale]

    def decimal(self, value: Number, unit: Number) -> Decimal:
        """A number in SI units, rounded to the digits."""
        if not self.ctx.isfinite(value):
            return Decimal("NaN" if self.ctx.isnan(value) else "Infinity" if value > 0 else "-Infinity")
        if value == 0:
            return Decimal(0)
        return Decimal(self.ctx.nstr(value * unit, self.digits, strip_zeros=False, min_fixed=-5, max_fixed=self.digits))


def event_of(record: Record, right: int, units: Units) -> EventRecord[Decimal]:
    state = record.state

    def decimal(name: str, value: Number) -> Decimal:
        return units.decimal(value, units.of(name))

    numbers: dict[str, Any] = {
        "t": state.t,
        "x": state.x,
        "height": state.y,
        "angle": state.th,
        "vx": state.vt + state.om,
        "vy": state.vn,
        "omega": state.om,
        "slip": state.vt,
        "impulse_normal": record.p_n,
        "impulse_tangential": record.p_t,
        "friction": state.friction,
        "impact_normal": state.impact_n,
        "impact_tangential": state.impact_t,
        "rolling_resistance": state.rolling_loss,
        "gain": record.gain,
    }
    numbers = {name: decimal(name, value) for name, value in numbers.items()}
    before: dict[str, Number] = {
        "vx": record.before_vt + record.before_om,
        "vy": record.before_vn,
        "omega": record.before_om,
        "slip": record.before_vt,
    }
    return EventRecord(
        **names_of(record.kind, -1 if record.before_mode is None else record.before_mode, record.after_mode),
        before=Velocity(**{name: decimal(name, value) for name, value in before.items()}),
        collision=record.collision,
        stable=record.stable,
        digits_right=right,
        **numbers,
    )


def ledger(solution: Solution) -> dict[str, Number]:
    """Energies at the end, what was lost on the way, and what does not add up, in units of m g R."""
    body, first, last = solution.body, solution.records[0], solution.records[-1]
    kinetic_of, potential_of = body.kernels(kinetic_energy), body.kernels(potential_energy)
    state, start = last.state, first.state
    kinetic = kinetic_of(body, state.th, state.om, state.vt, state.vn, body.zero)
    potential = potential_of(body, state.x, state.y, state.th)
    begin = kinetic_of(body, start.th, first.before_om, first.before_vt, first.before_vn, body.zero)
    begin += potential_of(body, start.x, start.y, start.th)
    lost = state.friction + state.impact_n + state.impact_t + state.rolling_loss
    return {
        "kinetic": kinetic,
        "potential": potential,
        "friction": state.friction,
        "impact_normal": state.impact_n,
        "impact_tangential": state.impact_t,
        "rolling_resistance": state.rolling_loss,
        "residual": kinetic + potential + lost - begin,
    }


def simulate_precisely(scenario: Scenario, digits: int, version: str) -> PreciseMotion:
    """The motion of a scenario to a number of digits, in SI units.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact.
    digits : int
        From 15 to 1000 [1].
    version : str
        Of hophoop, to be written into the result.

    Returns
    -------
    motion : PreciseMotion

    Raises
    ------
    ValueError
        If digits is not a whole number in its range, or the contact is compliant.
    """
    return motion_of(scenario, solve(scenario, digits), digits, version)


def motion_of(scenario: Scenario, solution: Solution, digits: int, version: str, ending: str | None = None) -> PreciseMotion:
    """A solution in SI units.

    Parameters
    ----------
    scenario : Scenario
    solution : Solution
    digits : int
        [1].
    version : str
        Of hophoop.
    ending : str, optional
        What ended the motion; by default its duration or its status.

    Returns
    -------
    motion : PreciseMotion
    """
    units = Units(solution.body, digits)
    events = tuple(
        event_of(record, right, units) for record, right in zip(solution.records, solution.digits_right, strict=True)
    )
    energy = {name: units.decimal(value, units.energy) for name, value in ledger(solution).items()}
    status = STATUS_NAMES[solution.status]
    kinds, modes = [record.kind for record in solution.records], [record.after_mode for record in solution.records]
    sequence = sequence_of(kinds, modes, [record.state.t for record in solution.records])
    if ending is None:
        ending = "duration" if status == "completed" else str(status)
    return PreciseMotion(scenario, digits, status, sequence, events, energy, version, ending)
