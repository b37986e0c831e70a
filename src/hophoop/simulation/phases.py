"""Reasons why each phase of a rigid motion starts and ends: the kernel's steps, one at a time, with their margins."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from hophoop._version import __version__
from hophoop.kernel.physics.body import MODE_LETTERS, Body, Mode, Status
from hophoop.kernel.records.cells import mode_of, start_of
from hophoop.kernel.records.layout import EVENT, EVENTS, SEGMENT
from hophoop.kernel.records.scratch import new_scratch
from hophoop.kernel.records.state import State, whole_angle
from hophoop.kernel.records.writing import has_room, new_log
from hophoop.kernel.rigid.ending import Ending
from hophoop.kernel.rigid.limits import limits_of
from hophoop.kernel.rigid.margins import MARGINS, margins_of
from hophoop.kernel.rigid.phase import GOING, Phase
from hophoop.kernel.rigid.run import begin, step
from hophoop.results.records import EventRecord
from hophoop.results.units import Units
from hophoop.scenario import InputError, Rigid, Scenario
from hophoop.scenario.scenario import cell_of, to_body
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
        Events at its end, and an apex inside it.
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

    These are the steps of the kernel that `simulate` runs, one at a time.

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
    contact = scenario.contact
    if not isinstance(contact, Rigid):
        raise InputError.of_field("contact.model", contact.model, "'rigid': these rules do not apply to a compliant contact")
    return _phases(scenario, contact)


def _phases(scenario: Scenario, contact: Rigid) -> Iterator[PhaseRecord]:
    body = to_body(scenario.hoop, scenario.plane)
    units = Units.of_scenario(scenario)
    scratch = new_scratch()
    cells = np.array([cell_of(scenario)], dtype=object).T  # Python floats, not NumPy scalars
    start = start_of(cells, 0, units.time)
    log = new_log(np.empty(contact.max_events, EVENT), np.empty(0, SEGMENT), scratch)
    limits = limits_of(start, scenario.duration / units.time, math.nan, 0)
    with np.errstate(all="ignore"):
        phase = begin(body, start, mode_of(cells, 0), log, scratch)
    seen = 0
    while phase.status == GOING and has_room(log):
        with np.errstate(all="ignore"):
            after = step(body, phase, limits, log, scratch)
        count = int(log.counts[EVENTS]) if has_room(log) else len(log.events)
        found = Trajectory(scenario, 0, log.events[seen:count], log.segments, __version__).events
        yield _record(body, units, phase, after, found)
        seen = count
        phase = after


def _record(body: Body, units: Units, phase: Phase, after: Phase, events: tuple[EventRecord[float], ...]) -> PhaseRecord:
    letter = MODE_LETTERS[phase.mode]
    reached = _before(after.state, events, units) if after.what == Ending.LANDING else after.state
    last = margins(body, units, phase.mode, reached)
    state = phase.state
    turning = state.om if state.om != 0.0 else after.state.om
    return PhaseRecord(
        mode=letter,
        word=mode_word(letter, turning),
        t_begin=state.t * units.time,
        t_end=after.state.t * units.time,
        angle_begin=whole_angle(state),
        angle_end=whole_angle(after.state),
        begin=margins(body, units, phase.mode, state),
        end=last,
        ended_by=_ended_by(body, phase, after, last, events),
        then=_then(body, units, after),
        events=events,
    )


def _before(state: State, events: tuple[EventRecord[float], ...], units: Units) -> State:
    """Return the state with the velocities before the impact."""
    hit = next(event for event in events if event.kind in ("impact", "bounce_limit"))
    speed = units.length / units.time
    return state._replace(vt=hit.before.slip / speed, vn=hit.before.vy / speed, om=hit.before.omega * units.time)


def margins(body: Body, units: Units, mode: int, state: State) -> Margins:
    """Return the margins of a mode in a state.

    Parameters
    ----------
    body : Body
    units : Units
    mode : int
        A Mode.
    state : State
        In kernel units.

    Returns
    -------
    margins : Margins
    """
    found = margins_of(body, mode, state.th, state.th_low, state.om, state.vt, state.y)
    named = dict(zip(MARGINS, found, strict=True))
    force = units.of("normal_force")
    return Margins(
        normal_force=named["normal_force"] * force,
        friction_force=named["friction_force"] * force,
        friction_limit=named["friction_limit"] * force,
        free_acceleration=named["free_acceleration"] * units.scales.acceleration,
        slip=named["slip"] * units.of("slip"),
        height=named["height"] * units.length,
        p_sigma=named["p_sigma"],
    )


_REASONS = {
    Ending.CONE_FORWARD: "Rolling needs the friction F = {friction:.6g} N, all of μs N.",
    Ending.CONE_BACKWARD: "Rolling needs the friction F = {friction:.6g} N, all of μs N.",
    Ending.LIFT_OFF: "Contact is lost: N = 0, and the rim is free to leave the plane.",
    Ending.SLIP_END: "Slip ends: v_t = 0.",
    Ending.LANDING: "The gap closes, with v_n = {vn:.6g} m/s.",
    Ending.LOAD_STRIKE: "The load strikes the plane.",
    Ending.ANGLE_LIMIT: "The angle span is reached.",
    Ending.TIME_LIMIT: "The time is over.",
    Ending.TURNING_POINT: "θ̇ = 0: the hoop turns back, in the same mode.",
    Ending.REST: "The hoop rests in {equilibrium} equilibrium.",
    Ending.SINGULAR: "The motion cannot be computed any further.",
    Ending.SEARCH_LIMIT: "The motion cannot be computed any further.",
}


def _ended_by(body: Body, phase: Phase, after: Phase, last: Margins, events: tuple[EventRecord[float], ...]) -> str:
    what = Ending(after.what)
    kinds: dict[str, EventRecord[float]] = {event.kind: event for event in events}
    if what in (Ending.CONE_FORWARD, Ending.CONE_BACKWARD) and not last.normal_force > 1e-9 * abs(last.friction_force):
        return "N = 0: to roll on, the plane would have to pull."
    if what == Ending.SLIP_END and "slip_reversal" in kinds:
        return "Slip reverses: v_t = 0."
    if what == Ending.TURNING_POINT and after.mode != phase.mode:
        return "θ̇ = 0: rolling ends."
    if what == Ending.REST and body.resist > 0.0:
        return "θ̇ = 0: rolling resistance holds the hoop."
    if after.status == Status.JAMMED:
        return "Slip reaches p_σ = 0 with N → ∞: it jams."
    if what == Ending.SINGULAR and after.status == GOING:
        return "Slip reaches p_σ = 0 with N → ∞: an impulse follows."
    hit = kinds.get("impact") or kinds.get("bounce_limit")
    rest = kinds.get("rest")
    return _REASONS[what].format(
        friction=last.friction_force,
        vn=hit.before.vy if hit else math.nan,
        equilibrium="a stable" if rest and rest.stable else "an unstable",
    )


def _then(body: Body, units: Units, after: Phase) -> str:
    if after.status != GOING or after.what == Ending.TURNING_POINT:
        return ""
    letter = MODE_LETTERS[after.mode]
    found = margins(body, units, after.mode, after.state)
    verb = WORDS[mode_word(letter, after.state.om)].verb
    if after.mode == Mode.ROLL:
        limit = "infinite friction" if math.isinf(body.mu_s) else f"μs N = {found.friction_limit:.6g} N"
        return f"It {verb}: that needs F = {found.friction_force:.6g} N of {limit}, with N > 0."
    if after.mode == Mode.FLIGHT:
        if after.state.vn > 0.0:
            return f"It {verb}: the rim leaves the plane with v_n = {after.state.vn * units.of('vy'):.6g} m/s."
        opening = 0.0 if after.what == Ending.LIFT_OFF else found.free_acceleration  # 0 within rounding
        return f"It {verb}: without contact the rim would not penetrate the plane, f_n = {opening:.6g} m/s²."
    if after.mode == Mode.SKIM:
        return f"It {verb}: the load falls freely, and the rim has no mass."
    need = margins(body, units, int(Mode.ROLL), after.state)
    if after.state.vt == 0.0 and need.normal_force > 0.0:
        return f"It {verb}: rolling would need F/N = {need.friction_force / need.normal_force:.6g}, with μs = {body.mu_s:.6g}."
    return f"It {verb}: v_t = {found.slip:.6g} m/s, with p_σ = {found.p_sigma:.6g} > 0 and N = {found.normal_force:.6g} N."
