"""The event loop: phases between events and events between phases, at one working precision."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.precise.contact import Advance, Stopped, advance
from hophoop.precise.flight import fly
from hophoop.precise.impact import impact
from hophoop.precise.problem import Body, Number, PreciseState, Problem
from hophoop.precise.rules import (
    INCONSISTENT,
    INDETERMINATE,
    UNDECIDED,
    Judged,
    contact_at,
    free_opening,
    next_mode,
    sign,
    slip_mode,
    turning_acceleration,
)
from hophoop.precise.series import Judge, Work


@dataclass
class Record:
    """One event in units of R, m and √(R/g); the state is the one just after it, the modes are those of `Mode`.

    `before_mode` is None at the start of a contact, `collision` and `stable` are None where they do not apply.
    """

    kind: Event
    before_mode: int | None
    after_mode: int
    state: PreciseState
    before_vt: Number
    before_vn: Number
    before_om: Number
    p_n: Number
    p_t: Number
    gain: Number
    collision: bool | None = None
    stable: bool | None = None


class Run:
    """One motion at one working precision.

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
        self.problem = problem
        self.body = Body(problem, bits, work)
        self.judge = Judge(bits, last)
        ctx = self.body.ctx
        self.closing = ctx.mpf(closing)
        self.t_end = self.body.number(problem.duration) / self.body.time if until is None else ctx.mpf(until)
        self.max_events = problem.max_events if max_events is None else max_events
        self.records: list[Record] = []
        self.state = self.body.start()
        self.origin = self.state
        self.mode: int = Mode.FLIGHT
        self.lifted = False  # in flight: whether it began with N → 0 in slip
        self.slip_zeros = 0  # of v_t at the start of a new slip phase, as far as known
        self.last_bounce = self.body.zero
        self.turns: list[PreciseState] = []  # turning points of the present phase of rolling
        self.status = Status.COMPLETED

    # --- events --------------------------------------------------------------------------------

    def write(self, kind: Event, before: int | None, after: int, cause: PreciseState | None = None, **details: Any) -> None:
        """Append an event in the present state; `cause` has the velocities before it, `details` are other fields of Record."""
        zero = self.body.zero
        was = self.state if cause is None else cause
        if len(self.records) >= self.max_events:
            raise Stopped(Status.EVENT_LIMIT)
        fields = {"p_n": zero, "p_t": zero, "gain": zero} | details
        self.records.append(Record(kind, before, after, self.state, was.vt, was.vn, was.om, **fields))

    def write_cause(self, kind: Event, before: int | None, after: int, cause: dict[str, Any]) -> None:
        """The event, and Kane's gain after it where there is one."""
        gain = cause.pop("gain", None)
        self.write(kind, before, after, **cause)
        if gain:
            self.write(Event.KANE_GAIN, after, after, gain=gain)

    def settle(self, kind: Event, before: int | None, **cause: Any) -> None:
        """Apply the mode rule after an event, writing it and every paradox met on the way."""
        body, judge = self.body, self.judge
        for _ in range(8):
            if self.state.vn > 0:
                self.write_cause(kind, before, Mode.FLIGHT, cause)
                self.enter(Mode.FLIGHT)
                return
            mode = next_mode(body, judge, self.state)
            named = mode
            if mode > Mode.SKIM:
                named = Mode.ROLL if self.state.vt == 0 else slip_mode(1 if self.state.vt > 0 else -1)
            if kind == Event.STICK and named != Mode.ROLL:
                kind = Event.TAKEOFF if named == Mode.FLIGHT else Event.SLIP_REVERSAL
            self.write_cause(kind, before, named, cause)
            if mode <= Mode.SKIM:
                self.enter(mode)
                return
            if mode == UNDECIDED:
                self.mode = UNDECIDED
                raise Stopped(Status.UNDETERMINED)
            if mode == INDETERMINATE:
                after = named if self.problem.painleve_impact else Mode.FLIGHT
                self.write(Event.PAINLEVE_INDETERMINATE, named, after)
                if not self.problem.painleve_impact:
                    self.enter(Mode.FLIGHT)
                    return
            else:
                assert mode == INCONSISTENT
                self.write(Event.PAINLEVE_INCONSISTENT, named, named)
            kind, before = Event.IMPACT, named
            cause = self.collide(body.rest, False)
        raise Stopped(Status.UNDETERMINED)

    def enter(self, mode: int) -> None:
        """Begin a phase in the present state."""
        self.mode = mode
        self.lifted = False
        self.turns = []
        vt = self.state.vt
        self.slip_zeros = 1 if vt == 0 else 0
        if mode == Mode.ROLL and vt != 0:
            self.state = self.state._replace(vt=self.body.zero)

    def collide(self, rest: Number, collision: bool) -> dict[str, Any]:
        """Go through an impact; return the fields of its event."""
        body, before = self.body, self.state
        blow = impact(contact_at(body, before.th), Judged(body, self.judge), rest, before.vt, before.vn)
        self.state = before._replace(
            vt=blow.vt,
            vn=blow.vn,
            om=before.om + blow.spin,
            impact_n=before.impact_n - blow.work_n,
            impact_t=before.impact_t - blow.work_t,
        )
        gain = blow.work_n + blow.work_t
        size = abs(blow.work_n) + abs(blow.work_t) + before.vn * before.vn
        if gain <= body.ctx.ldexp(size, -body.bits // 2):
            gain = body.zero
        return {"cause": before, "p_n": blow.p_n, "p_t": blow.p_t, "gain": gain, "collision": collision}

    # --- bounces -------------------------------------------------------------------------------

    def land(self) -> None:
        """The impact at the end of a flight; it closes the bounces where they are endless and nearly over."""
        before = self.state
        cause = self.collide(self.body.rest, True)
        kind = Event.IMPACT
        if self.is_last_bounce():
            self.state = before
            kind, cause = Event.BOUNCE_LIMIT, self.close_bounces()
        self.last_bounce = self.state.vn
        self.settle(kind, Mode.FLIGHT, **cause)

    def is_last_bounce(self) -> bool:
        """Return True if the bounces that would follow take less than the part of the time so far that closes them."""
        state, last = self.state, self.last_bounce
        closing = -free_opening(self.body, state.th, state.om)
        if not (state.vn > 0 and closing > 0 and state.vn < last):
            return False
        left: Number = 2 * state.vn / (closing * (1 - state.vn / last))
        return bool(left < self.closing * max(state.t, self.body.one))

    def close_bounces(self) -> dict[str, Any]:
        """The impact with e = 0 that ends endless bounces, without a jerk along the plane that lifts the rim again."""
        body = self.body
        cause = self.collide(body.zero, True)
        state = self.state
        if state.vn > 0:
            # μ = ∞: what stops the slip throws the rim up; an impulse that pulls it back has as little work in it
            cosine, sine = body.ctx.cos_sin(state.th)
            arm, lever = 1 + body.eps * cosine, body.eps * sine
            denominator = body.kap + arm * arm
            p_n = -state.vn / (1 + lever * lever / denominator)
            self.state = state._replace(
                vt=body.zero,
                vn=body.zero,
                om=state.om + lever / denominator * p_n,
                impact_n=state.impact_n - state.vn * p_n / 2,
            )
            cause["p_n"] += p_n
            cause["p_t"] += arm * lever / denominator * p_n
        cause["gain"] = body.zero
        return cause

    # --- the loop ------------------------------------------------------------------------------

    def run(self) -> Run:
        """Compute the motion; `records`, `state`, `mode` and `status` hold it then."""
        try:
            self.begin()
            while True:
                self.phase()
        except Stopped as end:
            self.status = end.status
        if self.status != Status.EVENT_LIMIT:
            last = self.records[-1].after_mode
            try:
                self.write(Event.END, last, last)
            except Stopped as end:
                self.status = end.status
        return self

    def begin(self) -> None:
        """The start, with the impact of a hoop that starts into the plane."""
        state = self.state
        if self.problem.mode is not None:
            self.write(Event.START, None, self.problem.mode)
            self.enter(self.problem.mode)
            if state.vt == 0 and self.mode in (Mode.SPIN, Mode.SKID):  # it has just left the cone
                self.slip_zeros = 2 if self.problem.mu_s == self.problem.mu_k else 1
        elif state.y > 0 or state.vn != 0:
            self.write(Event.START, Mode.FLIGHT, Mode.FLIGHT)
            if state.y == 0 and state.vn < 0:
                self.land()
        else:
            self.settle(Event.START, None)

    def phase(self) -> None:
        """One phase, or a part of it up to an event that leaves the mode as it is."""
        if self.mode == Mode.FLIGHT:
            landing = fly(self.body, self.judge, self.state, self.lifted, self.t_end)
            if landing.apex is not None:
                self.state = landing.apex
                self.write(Event.APEX, Mode.FLIGHT, Mode.FLIGHT)
            self.state = landing.state
            if not landing.lands:
                raise Stopped(Status.COMPLETED)
            self.land()
            return
        if self.state.om == 0 and self.is_still():
            self.stand()
            return
        self.contact()

    def is_still(self) -> bool:
        """Return True if a hoop with θ̇ = 0 stays so."""
        body, sigma = self.body, {Mode.SKID: 1, Mode.SPIN: -1}.get(Mode(self.mode), 0)
        alpha = turning_acceleration(body, self.state.th, body.zero, sigma)
        return sign(body, self.judge, alpha, body.gn + abs(body.gt) + (0 if sigma == 0 else body.mu_k * body.gn)) == 0

    def stand(self) -> None:
        """Rest, or slip without rotation."""
        body, state = self.body, self.state
        if self.mode == Mode.ROLL:
            cosine, sine = body.ctx.cos_sin(state.th)
            stable = bool(body.eps * (body.gn * cosine - body.gt * sine) < 0)
            if body.resist > 0:  # held by less than all that the couple can give
                stable |= bool(abs(body.resistance(state.th, body.zero, 0)) < body.resist)
            self.write(Event.REST, Mode.ROLL, Mode.ROLL, stable=stable)
            self.state = state._replace(t=self.t_end)
            raise Stopped(Status.AT_REST)
        if self.slide():
            self.settle(Event.STICK, self.mode)

    def slide(self) -> bool:
        """Slip at a constant angle; whether it stops before time is over."""
        body, state = self.body, self.state
        sigma = 1 if self.mode == Mode.SKID else -1
        rate = body.gt - sigma * body.mu_k * body.gn
        left = self.t_end - state.t
        until = -state.vt / rate if state.vt * rate < 0 else body.ctx.inf
        stops = bool(until <= left)
        tau = until if stops else left
        slid = state.vt * tau + rate * tau * tau / 2
        self.state = state._replace(
            t=state.t + tau if stops else self.t_end,
            x=state.x + slid,
            vt=body.zero if stops else state.vt + rate * tau,
            friction=state.friction + sigma * body.mu_k * body.gn * slid,
        )
        if not stops:
            raise Stopped(Status.COMPLETED)
        return stops

    def contact(self) -> None:
        """Roll or slip up to the next event."""
        was = self.mode
        done = advance(self.body, self.judge, was, self.state, self.slip_zeros, self.t_end, bool(self.turns))
        self.state = done.state
        if done.what == Advance.LIMIT:
            raise Stopped(Status.COMPLETED)
        if done.what == Advance.TURN and self.body.resist > 0:
            self.turned(was)
        elif done.what == Advance.TURN:
            self.write(Event.TURN, was, was)
            self.slip_zeros = 0
            if was == Mode.ROLL:
                self.turns.append(self.state)
                if len(self.turns) == 2:
                    self.swing()
        elif done.what == Advance.LIFT:
            self.write(Event.TAKEOFF, was, Mode.FLIGHT)
            self.enter(Mode.FLIGHT)
            self.lifted = True
        elif done.what == Advance.STOP:
            self.settle(Event.STICK, was)
        elif done.what == Advance.JAM:
            self.write(Event.JAM, was, was)
            raise Stopped(Status.JAMMED)
        else:
            self.leave_cone(done.what)

    def turned(self, was: int) -> None:
        """Go on from θ̇ = 0 with rolling resistance: the couple, and with it the contact force, jumps there."""
        mode = next_mode(self.body, self.judge, self.state)
        if was == mode == Mode.ROLL and self.is_still():
            self.stand()
        elif was != Mode.ROLL and mode > Mode.SKIM:
            self.settle(Event.TURN, was)
        else:
            self.write(Event.TURN, was, was)
            self.slip_zeros = 0
            if mode != was:
                if was != Mode.ROLL and mode != Mode.FLIGHT:
                    self.state = self.state._replace(vt=self.body.zero)  # v_t and θ̇ come to zero together
                rolled = Event.TAKEOFF if mode == Mode.FLIGHT else Event.SLIP_START
                self.settle(rolled if was == Mode.ROLL else Event.STICK, was)

    def leave_cone(self, what: Advance) -> None:
        """Rule 2: slip against the friction that was at its limit, at μk; or flight."""
        body, state = self.body, self.state
        opens = free_opening(body, state.th, state.om)
        if sign(body, self.judge, opens, body.gn + state.om * state.om) >= 0:
            self.write(Event.TAKEOFF, Mode.ROLL, Mode.FLIGHT)
            self.enter(Mode.FLIGHT)
        elif body.fixed.mu_s is None:
            self.mode = UNDECIDED  # the quasi-jump: N = 0, but free motion would enter the plane
            raise Stopped(Status.UNDETERMINED)
        else:
            mode = slip_mode(-1 if what == Advance.CONE_AHEAD else 1)
            self.write(Event.SLIP_START, Mode.ROLL, mode)
            self.enter(mode)
            self.slip_zeros = 2 if self.problem.mu_s == self.problem.mu_k else 1

    def swing(self) -> None:
        """Rolling to and fro between two turning points goes on as it went once: only its turns have to be written."""
        first, second = self.turns
        half = second.t - first.t
        while second.t + half <= self.t_end:
            first, second = second, first._replace(t=second.t + half)
            self.state = second
            self.write(Event.TURN, Mode.ROLL, Mode.ROLL)
        self.state = second
