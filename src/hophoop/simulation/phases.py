"""Reasons why each phase of a rigid motion starts and ends, with their margins: a view of its events."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from hophoop._support.errors import check_type
from hophoop.kernel.model import MODE_LETTERS, PASSING, Body, Event, Mode
from hophoop.kernel.steps import MARGINS, margins_of
from hophoop.results.records import EventRecord
from hophoop.results.units import Units
from hophoop.scenario import InputError, Rigid, Scenario
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary.names import WORDS, mode_word


@dataclass(frozen=True)
class Margins:
    """Quantities that decide whether a mode lasts.

    Attributes
    ----------
    normal_force, friction_force : float
        N and F in the mode; in rolling F is the required friction [N].
    friction_limit : float
        μ N with μs in rolling and μk in slip [N].
    free_acceleration : float
        f_n, the acceleration of the lowest rim point away from the plane without contact force [m/s²].
    slip : float
        v_t [m/s].
    height : float
        Gap between rim and plane [m].
    p_sigma : float
        Normal acceleration per normal force in slip, times the mass; Painlevé's paradox occurs if it is not positive. nan
        outside of slip [1].
    """

    normal_force: float
    friction_force: float
    friction_limit: float
    free_acceleration: float
    slip: float
    height: float
    p_sigma: float

    def __repr__(self) -> str:
        forces = f"N = {self.normal_force:.6g} N, F = {self.friction_force:.6g} N of {self.friction_limit:.6g} N"
        return f"<Margins: {forces}, slip {self.slip:.6g} m/s, gap {self.height:.6g} m>"


@dataclass(frozen=True)
class PhaseRecord:
    """One phase, or the part of a phase up to a turning point.

    Attributes
    ----------
    mode : str
        R roll, S and K slip with v_t < 0 and > 0, H flight, M skim.
    word : str
        Name of the mode, which depends on the rotation: roll, spin, skid, flight or skim.
    t_begin, t_end : float
        Start and end [s].
    angle_begin, angle_end : float
        θ [rad].
    begin, end : Margins
        At the start of the phase, and at its end before anything changes.
    ended_by : str
        The reason for its end, in a sentence with numbers.
    then : str
        The next mode and the reason, in a sentence; empty if the motion ends.
    events : tuple of EventRecord
        Events at its end, and those inside it that leave the mode as it is.
    """

    mode: str
    word: str
    t_begin: float
    t_end: float
    angle_begin: float
    angle_end: float
    begin: Margins
    end: Margins
    ended_by: str
    then: str
    events: tuple[EventRecord[float], ...]

    def __repr__(self) -> str:
        head = f"{self.word} ({self.mode}) from {self.t_begin:.9g} to {self.t_end:.9g} s"
        return "\n".join([f"<{head}>", *(f"  {line}" for line in (self.ended_by, self.then) if line)])


def phases(scenario: Scenario) -> Iterator[PhaseRecord]:
    """Return the phases of a motion, one after the other, and the reason for the end of each.

    Parameters
    ----------
    scenario : Scenario
        With rigid contact.

    Yields
    ------
    phase : PhaseRecord

    Raises
    ------
    ValueError
        If the contact is compliant: these rules do not apply to its phases.

    Examples
    --------
    >>> import hophoop as hh
    >>> scenario = hh.Scenario(start=hh.Start.rolling(3.1), duration=2.0)
    >>> for phase in hh.phases(scenario):
    ...     print(phase.mode, phase.ended_by)
    R Rolling needs the friction F = -0.940603 N, all of μs N.
    K Slip ends: v_t = 0.
    R Rolling needs the friction F = 11.8112 N, all of μs N.
    S Contact is lost: N = 0, and the rim is free to leave the plane.
    H The gap closes, with v_n = -3.21948 m/s.
    R The time is over.
    """
    check_type("scenario", scenario, Scenario)
    if not isinstance(scenario.contact, Rigid):
        raise InputError.of_field(
            "contact.model", scenario.contact.model, "'rigid': these rules do not apply to a compliant contact"
        )
    return _phases(simulate(scenario))


_PARADOX = (Event.PAINLEVE_INCONSISTENT, Event.PAINLEVE_INDETERMINATE)


def _phases(motion: Trajectory) -> Iterator[PhaseRecord]:
    rows, records = motion.tables["events"], motion.events
    end = len(rows) - 1  # the row of END
    begin, seen = _last_of_event(rows, 0), 0
    if rows[0]["after_mode"] == Mode.FLIGHT and rows[1]["kind"] == Event.IMPACT and rows[1]["t"] == rows[0]["t"]:
        begin = _last_of_event(rows, 1)  # it starts with a landing
    while begin < end:
        first = begin + 1
        while rows[first]["kind"] in PASSING and rows[first]["kind"] != Event.TURN:
            first += 1
        if first == end and rows[first]["t"] == rows[begin]["t"]:
            return  # the motion ended with its last event
        last = _last_of_event(rows, first)
        upto = end if first == end else last + 1
        yield _record(motion, begin, first, last, tuple(records[seen:upto]))
        begin, seen = last, upto


def _last_of_event(rows: np.ndarray, first: int) -> int:
    """Return the last of the rows that an event writes: a paradox, the impact that resolves it, a gain of energy."""
    last = first
    while last + 1 < len(rows):
        kind, collision = int(rows[last + 1]["kind"]), int(rows[last + 1]["collision"])
        resolves = kind == Event.IMPACT and collision == 0 and rows[last]["kind"] in _PARADOX
        at_once = rows[last + 1]["t"] == rows[last]["t"]
        if not (at_once and (resolves or kind in _PARADOX or kind == Event.KANE_GAIN)):
            break
        last += 1
    return last


def _record(motion: Trajectory, begin: int, first: int, last: int, events: tuple[EventRecord[float], ...]) -> PhaseRecord:
    """Return the phase from one row of the events to another, the first that the end of the phase writes."""
    body, units, rows, records = motion.scenario.to_body(), motion.units, motion.tables["events"], motion.events
    mode = int(rows[begin]["after_mode"])
    letter = MODE_LETTERS[mode]
    turning = records[begin].omega if records[begin].omega != 0.0 else records[first].omega
    reached = margins(body, units, mode, rows[first], before=True)
    return PhaseRecord(
        mode=letter,
        word=mode_word(letter, turning),
        t_begin=records[begin].t,
        t_end=records[first].t,
        angle_begin=records[begin].angle,
        angle_end=records[first].angle,
        begin=margins(body, units, mode, rows[begin]),
        end=reached,
        ended_by=_ended_by(motion, mode, records[first], reached, events),
        then="" if last >= len(rows) - 2 and _is_over(motion, rows, last) else _then(body, units, rows[first], rows[last]),
        events=events,
    )


def _is_over(motion: Trajectory, rows: np.ndarray, last: int) -> bool:
    """Return True if the motion ends with this row: it is END, or END follows at once."""
    return last == len(rows) - 1 or (motion.status != "completed" and rows[last]["t"] == rows[-1]["t"])


def margins(body: Body, units: Units, mode: int, row: np.void, before: bool = False) -> Margins:
    """Return the margins of a mode in the state of a row of events: after the event, or with the velocities before it."""
    name = "before_" if before else ""
    theta, low, omega, slip, height = (
        float(row[each]) for each in ("theta", "theta_low", f"{name}omega", f"{name}slip", "height")
    )
    force = units.of("normal_force")
    factors = (force, force, force, units.scales.acceleration, units.of("slip"), units.length, 1.0)
    found = zip(MARGINS, margins_of(body, mode, theta, low, omega, slip, height), factors, strict=True)
    return Margins(**{name: value * factor for name, value, factor in found})


def _ended_by(
    motion: Trajectory, mode: int, end: EventRecord[float], last: Margins, events: tuple[EventRecord[float], ...]
) -> str:
    rest = next((event for event in events if event.kind == "rest"), None)
    if rest is not None:
        if motion.scenario.plane.rolling_resistance > 0.0:
            return "θ̇ = 0: rolling resistance holds the hoop."
        return f"The hoop rests in {'a stable' if rest.stable else 'an unstable'} equilibrium."
    if end.kind == "end":
        return "The time is over." if motion.status == "completed" else "The motion cannot be computed any further."
    if end.kind == "jam":
        return "Slip reaches p_σ = 0 with N → ∞: it jams."
    if end.kind == "turn":
        return "θ̇ = 0: the hoop turns back, in the same mode." if end.to_mode == MODE_LETTERS[mode] else "θ̇ = 0: rolling ends."
    if end.kind == "slip_reversal":
        return "Slip reverses: v_t = 0."
    if mode == Mode.FLIGHT:
        return f"The gap closes, with v_n = {end.before.vy:.6g} m/s."
    if mode == Mode.SKIM:
        return "The load strikes the plane."
    if mode == Mode.ROLL:
        if not last.normal_force > 1e-9 * abs(last.friction_force):
            return "N = 0: to roll on, the plane would have to pull."
        return f"Rolling needs the friction F = {last.friction_force:.6g} N, all of μs N."
    if end.kind == "impact":
        return "Slip reaches p_σ = 0 with N → ∞: an impulse follows."
    if end.kind == "takeoff" and end.before.slip != 0.0:
        return "Contact is lost: N = 0, and the rim is free to leave the plane."
    return "Slip ends: v_t = 0."


def _then(body: Body, units: Units, end: np.void, row: np.void) -> str:
    """Return the next mode and its reason, after the first and the last row of what ended the phase."""
    mode = int(row["after_mode"])
    if end["kind"] == Event.TURN:
        return ""
    found = margins(body, units, mode, row)
    verb = WORDS[mode_word(MODE_LETTERS[mode], float(row["omega"]))].verb
    if mode == Mode.ROLL:
        limit = "infinite friction" if math.isinf(body.mu_s) else f"μs N = {found.friction_limit:.6g} N"
        return f"It {verb}: that needs F = {found.friction_force:.6g} N of {limit}, with N > 0."
    if mode == Mode.FLIGHT:
        if row["vy"] > 0.0:
            return f"It {verb}: the rim leaves the plane with v_n = {row['vy'] * units.of('vy'):.6g} m/s."
        lifts = end["before_mode"] in (Mode.SPIN, Mode.SKID) and end["before_slip"] != 0.0
        opening = 0.0 if lifts else found.free_acceleration  # 0 within rounding
        return f"It {verb}: without contact the rim would not penetrate the plane, f_n = {opening:.6g} m/s²."
    if mode == Mode.SKIM:
        return f"It {verb}: the load falls freely, and the rim has no mass."
    need = margins(body, units, Mode.ROLL, row)
    if row["slip"] == 0.0 and need.normal_force > 0.0:
        return f"It {verb}: rolling would need F/N = {need.friction_force / need.normal_force:.6g}, with μs = {body.mu_s:.6g}."
    return f"It {verb}: v_t = {found.slip:.6g} m/s, with p_σ = {found.p_sigma:.6g} > 0 and N = {found.normal_force:.6g} N."
