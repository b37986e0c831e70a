"""One motion at one working precision: the kernel's steps from event to event, with Taylor series for what lies between."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from hophoop.kernel.model import Event, Mode, Status, acceleration_in_contact, next_mode, slip_direction
from hophoop.kernel.records import PendingEvent, State, event_without_jump
from hophoop.kernel.steps import (
    BY_RULE,
    GOING,
    NONE,
    Ending,
    Limits,
    Phase,
    begin,
    contact_step,
    end_motion,
    land,
    limits_of,
    vanishing_slip_derivatives,
)
from hophoop.precise.contact import advance
from hophoop.precise.flight import fly
from hophoop.precise.kernels import Kernels, Number, numbers_of
from hophoop.precise.problem import Body, Problem
from hophoop.precise.series import Judge, Work


@dataclass
class Record:
    """One event in units of R, m and √(R/g); the state is the one just after it, the modes are those of `Mode`.

    `before_mode` is None at the start of a contact, `collision` and `stable` are None where they do not apply.
    """

    kind: Event
    before_mode: int | None
    after_mode: int
    state: State
    before_vt: Number
    before_vn: Number
    before_om: Number
    p_n: Number
    p_t: Number
    gain: Number
    collision: bool | None = None
    stable: bool | None = None


class _TooManyEvents(Exception):
    """The motion has as many events as are allowed."""


class Run:
    """One motion at one working precision; it is also the log that the kernel's steps write their events to.

    Parameters
    ----------
    problem : Problem
    bits : int
        Working precision.
    last : bool
        True if a quantity that is indistinguishable from 0 counts as 0.
    closing : float
        A sequence of bounces is closed when its rest takes less than this part of the time so far.
    until : Number, optional
        End of time, in units of √(R/g), if it is not the scenario's.
    max_events : int, optional
        The motion stops after so many events, if it is not the scenario's number.
    work : Work, optional
        What its steps are taken from; without end by default.
    """

    def __init__(
        self,
        problem: Problem,
        bits: int,
        last: bool,
        closing: Any,
        until: Any = None,
        max_events: int | None = None,
        work: Work | None = None,
    ) -> None:
        self.doubt = None  # for `record_doubt`
        self.problem = problem
        self.body = Body(problem, bits, work)
        self.judge = Judge(bits, last)
        ctx = self.body.ctx
        self.t_end = self.body.number(problem.duration) / self.body.time if until is None else ctx.mpf(until)
        self.max_events = problem.max_events if max_events is None else max_events
        self.records: list[Record] = []
        self.turns: list[State] = []  # turning points of the present phase of rolling
        self.status, self.ending = Status.COMPLETED, Ending.CONTINUES
        self.tie = ctx.ldexp(ctx.one, -(bits // 2))
        self.kernels = Kernels(ctx.mpf, numbers_of(ctx) | self.steps_of() | {"CLOSING": ctx.mpf(closing)})

    def steps_of(self) -> dict[str, Any]:
        """What the kernel's steps from event to event find under these names: this solver, and what zero is here."""
        zero = self.body.zero
        return {
            "advance_contact": self.advance,
            "is_equilibrium": self.is_equilibrium,
            "next_mode": self.next_mode,
            "resolve_painleve_singularity": self.jam,
            "write_event": self.write,
            "write_segment": lambda *arguments: None,
            "rolling_anchor": lambda body, state, s, c: NONE,
            "doubt_rest": lambda body, sigma, state, until, log: None,
            "mode_is_in_doubt": lambda body, state: False,
            "record_doubt": lambda doubt, t: None,
            "sign_beyond": self.judge.sign_beyond,
            **dict.fromkeys(("TIE", "ZERO", "GAIN_FLOOR"), self.tie),
            **dict.fromkeys(("ROUNDING", "SMALLEST_SQUARE", "SLOWEST_BOUNCE"), zero),
        }

    def run(self) -> Run:
        """Compute the motion; `records` and `status` hold it then."""
        body, given = self.body, self.problem.mode
        limits = self.limits()
        try:
            phase = self.kernels(begin)(body, body.start(), BY_RULE if given is None else given, self)
            while phase.status == GOING:
                phase = self.flight(phase) if phase.mode == Mode.FLIGHT else self.contact(phase, limits)
            self.status, self.ending = Status(phase.status), Ending(phase.ending)
            self.write_passing(Event.END, self.records[-1].after_mode, phase.state)
        except _TooManyEvents:
            self.status = Status.EVENT_LIMIT
        return self

    def limits(self) -> Limits:
        """What the motion ends with."""
        limits: Limits = limits_of(self.body.start(), self.t_end, math.nan, 0, 0)
        return limits

    def write(self, log: Any, cause: PendingEvent, mode: int, state: State, gain: Number, stable: int) -> None:
        """Append an event."""
        if len(self.records) >= self.max_events:
            raise _TooManyEvents
        before = None if cause.mode < 0 else cause.mode
        whether = [None if flag < 0 else bool(flag) for flag in (cause.collision, stable)]
        jump = (cause.vt, cause.vn, cause.om, cause.p_n, cause.p_t)
        self.records.append(Record(Event(cause.kind), before, mode, state, *jump, gain, *whether))

    def write_passing(self, kind: Event, mode: int, state: State) -> None:
        """Append an event that leaves velocities and mode as they are."""
        self.write(self, event_without_jump(kind, mode, state), mode, state, self.body.zero, -1)

    def next_mode(self, body: Body, th: Number, th_low: Number, om: Number, vt: Number) -> int:
        """The mode that follows a state in contact, where a slip that is indistinguishable from 0 is none."""
        slips = vt != 0 and self.judge.sign_beyond(vt, self.tie * (1 + abs(om))) != 0
        mode: int = self.kernels(next_mode)(body, th, th_low, om, vt if slips else body.zero)
        return mode

    def is_equilibrium(self, body: Body, sigma: int, state: State) -> bool:
        """Return True if a hoop with θ̇ = 0 stays so."""
        cosine, sine = body.ctx.cos_sin(state.th)
        alpha = body.kernels(acceleration_in_contact)(body, sine, cosine, body.zero, sigma)
        size = body.gn + abs(body.gt) + (body.mu_k * body.gn if sigma != 0 else 0)
        return self.judge.sign_beyond(alpha, self.tie * size) == 0

    # --- phases --------------------------------------------------------------------------------

    def flight(self, phase: Phase) -> Phase:
        """Fly until the landing and its impact, or the end."""
        body = self.body
        landing = fly(body, self.judge, phase.state, phase.ending == Ending.LIFT_OFF, self.t_end)
        if landing.apex is not None:
            self.write_passing(Event.APEX, Mode.FLIGHT, landing.apex)
        following: Phase = (
            self.kernels(land)(body, landing.state, self)
            if landing.lands
            else end_motion(phase, Mode.FLIGHT, landing.state, Ending.TIME_LIMIT, Status.COMPLETED)
        )
        return following

    def contact(self, phase: Phase, limits: Limits) -> Phase:
        """Roll or slip up to the next event, with the step that follows from it."""
        following: Phase = self.kernels(contact_step)(self.body, phase, limits, self, None)
        if not (following.ending == Ending.TURNING_POINT and following.mode == Mode.ROLL and self.body.resist == 0):
            self.turns = []
            return following
        self.turns.append(following.state)
        if len(self.turns) == 2:
            following = following._replace(state=self.swing())
        return following

    def advance(self, body: Body, phase: Phase, limits: Limits, log: Any, scratch: Any) -> Phase:
        """Return what `contact_step` asks for: the phase with the state at the end of a contact."""
        sigma, state = slip_direction(phase.mode), phase.state
        if state.om == 0 and self.is_equilibrium(body, sigma, state):
            return phase._replace(state=state, ending=Ending.REST)
        zeros = 0
        if sigma == 0:
            state = state._replace(vt=body.zero)
        elif phase.begins:
            zeros = vanishing_slip_derivatives(body, phase)
            if zeros == 1 and len(self.records) == 1 and self.problem.mode is not None:  # it has just left the cone
                zeros = 2 if body.mu_s == body.mu_k else 1
        ending, state = advance(body, self.judge, sigma, state, zeros, limits.t_end)
        return phase._replace(state=state, ending=ending, begins=False)

    def jam(self, body: Body, mode: int, state: State, log: Any) -> tuple[bool, int, State]:
        """Return what follows slip that has run into p_σ = 0 with N → ∞: nothing."""
        self.write_passing(Event.JAM, mode, state)
        return True, mode, state

    def swing(self) -> State:
        """Rolling to and fro between two turning points goes on as it went once: only its turns have to be written."""
        first, second = self.turns
        half = second.t - first.t
        while second.t + half <= self.t_end:
            first, second = second, first._replace(t=second.t + half)
            self.write_passing(Event.TURN, Mode.ROLL, second)
        return second
