"""The event loop of a proof: phases whose first event is enclosed, and events whose inequalities are shown."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.precise.impact import impact
from hophoop.precise.problem import Problem
from hophoop.prove._flint import Ball, Undecided, arb, sign
from hophoop.prove.deadline import Deadline, Late
from hophoop.prove.phases.contact import Ended, Limits, roll, travel
from hophoop.prove.phases.flight import Flight
from hophoop.prove.phases.rolling import TURN
from hophoop.prove.phases.trail_recorder import bracket
from hophoop.prove.physics.equations import Model, State, Still
from hophoop.prove.physics.mode_rule import (
    INCONSISTENT,
    INDETERMINATE,
    TIE_ORDER,
    UNDETERMINED,
    Certain,
    contact_at,
    free_opening,
    next_mode,
    opening_sign,
    slip_mode,
)

CLOSING = "1e-12"  # bounces are closed when their rest takes less than this part of the time so far
GAIN_FLOOR = "1e-14"  # relative to the energy of an impact: less is no gain
DURATION, REVOLUTION = "duration", "revolution"


@dataclass(frozen=True)
class Fact:
    """An event that is proved, in units of R, m and √(R/g), with the state just after it."""

    kind: Event
    before_mode: int | None
    after_mode: int
    state: State
    p_n: Ball | None = None
    p_t: Ball | None = None


@dataclass
class Run:
    """One motion until it ends or something cannot be shown.

    Parameters
    ----------
    problem : Problem
    free : mapping of str to Ball, optional
        Balls in the place of parameters.
    until : str, optional
        'duration', or 'revolution': the first of a whole turn, a turning point and a take-off.
    timed : bool, optional
        Whether times are wanted; a revolution can do without those of rolling.
    max_events : int, optional
        More are not looked at.
    deadline : Deadline, optional
        What is not shown by then stays undecided.
    """

    problem: Problem
    free: Mapping[str, Ball] | None = None
    until: str = DURATION
    timed: bool = True
    max_events: int = 4000
    deadline: Deadline | None = None
    model: Model = field(init=False)
    facts: list[Fact] = field(init=False, default_factory=list)
    witnesses: list[dict[str, Any]] = field(init=False, default_factory=list)
    status: int = field(init=False, default=int(Status.COMPLETED))
    ending: str = field(init=False, default="duration")
    why: str = field(init=False, default="")
    done: bool = field(init=False, default=False)

    def __post_init__(self) -> None:
        self.model = Model(self.problem, self.free, self.deadline)
        self.state = self.model.start()
        self.origin = self.state.th
        self.mode = int(Mode.FLIGHT)
        self.zeros = 0  # slip: known zeros of v_t at its start; flight: of the gap
        self.last_bounce: Ball = arb(0)
        self.energy: Ball | None = None
        duration = self.until == DURATION
        self.limits = Limits(self.model.t_end if duration else None, None if duration else self.origin, self.timed)

    @property
    def proved(self) -> bool:
        """True if every step is proved."""
        return not self.why

    def run(self) -> Run:
        """Go through the motion; `facts` are what is proved, `why` what stopped it."""
        try:
            if self.model.kap.is_zero():
                raise Undecided("the massless hoop has closed forms of its own, which are not covered")
            self.begin()
            while not self.done:
                self.phase()
        except (Undecided, Late) as reason:
            self.why = str(reason)
        except ZeroDivisionError:
            self.why = "a divisor may be zero"
        return self

    # --- events --------------------------------------------------------------------------------

    def note(self, kind: Event, before: int | None, after: int, **extra: Any) -> None:
        """Append an event in the present state."""
        if len(self.facts) >= self.max_events:
            self.finish(Status.EVENT_LIMIT, "event_limit")
            raise _Full
        self.facts.append(Fact(kind, before, after, self.state, **extra))

    def finish(self, status: Status, ending: str) -> None:
        """The motion ends."""
        self.status, self.ending, self.done = int(status), ending, True

    def end(self, status: Status, ending: str) -> None:
        """End the motion with an `end` event."""
        last = self.facts[-1].after_mode
        self.note(Event.END, last, last)
        self.finish(status, ending)

    def begin(self) -> None:
        """The start, with the impact of a hoop that starts into the plane."""
        state = self.state
        if not (state.y.is_zero() and state.vn.is_zero()):
            self.note(Event.START, int(Mode.FLIGHT), int(Mode.FLIGHT))
            if state.y.is_zero() and state.vn < 0:
                self.land()
            else:
                self.zeros = 1 if state.y.is_zero() else 0
        else:
            self.settle(Event.START, None)

    def settle(self, kind: Event, before: int | None, blow: dict[str, Any] | None = None) -> None:
        """Apply the mode rule after an event, writing it and every paradox met on the way."""
        model = self.model
        for _ in range(8):
            extra = dict(blow or {})
            gain = extra.pop("gain", False)
            if sign(self.state.vn, "v_n after an impact") > 0:
                self.note(kind, before, int(Mode.FLIGHT), **extra)
                self.note_gain(gain, int(Mode.FLIGHT))
                self.enter(int(Mode.FLIGHT))
                return
            mode = next_mode(model, self.state)
            if kind == Event.STICK and mode == before:  # slip that has stopped never resumes in the same direction
                raise Undecided("slip would go on where it stops")
            named = mode
            if mode > Mode.SKIM:
                way = sign(self.state.vt, "v_t")
                named = int(Mode.ROLL) if way == 0 else slip_mode(way)
            if kind == Event.STICK and named != Mode.ROLL:
                kind = Event.TAKEOFF if named == Mode.FLIGHT else Event.SLIP_REVERSAL
            self.note(kind, before, named, **extra)
            self.note_gain(gain, named)
            if mode == UNDETERMINED:
                self.mode = UNDETERMINED
                self.end(Status.UNDETERMINED, "undetermined")
                return
            if mode <= Mode.SKIM:
                self.enter(mode)
                return
            if mode == INDETERMINATE:
                strike = self.problem.strike
                self.note(Event.PAINLEVE_INDETERMINATE, named, named if strike else int(Mode.FLIGHT))
                if not strike:
                    self.enter(int(Mode.FLIGHT))
                    return
            else:
                assert mode == INCONSISTENT
                self.note(Event.PAINLEVE_INCONSISTENT, named, named)
            kind, before = Event.IMPACT, named
            blow = self.collide(model.rest)
        raise Undecided("impacts without collision follow one another")

    def note_gain(self, gain: bool, mode: int) -> None:
        """Kane's gain of energy after an impact under Newton's law."""
        if gain:
            self.note(Event.KANE_GAIN, mode, mode)

    def enter(self, mode: int) -> None:
        """Begin a phase in the present state."""
        self.mode, state = mode, self.state
        if mode == Mode.FLIGHT:
            if not state.vn.is_zero():
                self.zeros = 1
            else:
                self.zeros = 2 if sign(free_opening(self.model, state.th, state.om), "f_n at a take-off") > 0 else 3
        else:
            self.zeros = 0
            if mode != Mode.ROLL and state.vt.is_zero():
                _, _, slips, _ = self.model.candidate(state.th, state.om, 1 if mode == Mode.SKID else -1, TIE_ORDER)
                self.zeros = 1 + next((k for k, value in enumerate(slips) if not value.is_zero()), 0)

    def collide(self, rest: Ball) -> dict[str, Any]:
        """Go through an impact; return the fields of its event."""
        before, self.energy = self.state, None
        blow = impact(contact_at(self.model, before.th), Certain(), rest, before.vt, before.vn)
        self.state = replace(before, vt=blow.vt, vn=blow.vn, om=before.om + blow.spin, y=arb(0))
        size = abs(blow.work_n) + abs(blow.work_t) + before.vn * before.vn
        excess = blow.work_n + blow.work_t - arb(GAIN_FLOOR) * size
        if not (excess > 0 or excess < 0):
            raise Undecided("whether an impact creates energy is not certain")
        return {"p_n": blow.p_n, "p_t": blow.p_t, "gain": bool(excess > 0)}

    def land(self) -> None:
        """The impact at the end of a flight, which closes the bounces where they are endless and nearly over."""
        before = self.state
        blow = self.collide(self.model.rest)
        kind = Event.IMPACT
        if self.is_last_bounce(before):
            self.state, kind = before, Event.BOUNCE_LIMIT
            blow = self.collide(arb(0))
            if not self.state.vn.is_zero():
                raise Undecided("a close of bounces on infinite friction is not covered")
            blow["gain"] = False
        self.last_bounce = self.state.vn
        self.settle(kind, int(Mode.FLIGHT), blow)

    def is_last_bounce(self, before: State) -> bool:
        """Return True if the bounces that would follow take less than the part of the time so far that closes them."""
        state, last = self.state, self.last_bounce
        closing = -free_opening(self.model, state.th, state.om)
        rises = sign(state.vn, "v_n after an impact") > 0
        if not (rises and sign(closing, "f_n at a bounce") > 0):
            return False
        if not last > 0 or not _less(state.vn, last, "whether bounces shrink"):
            return False
        left = 2 * state.vn / (closing * (1 - state.vn / last))
        so_far = before.t if _less(arb(1), before.t, "whether bounces are closed") else arb(1)
        return _less(left, arb(CLOSING) * so_far, "whether bounces are closed")

    # --- phases --------------------------------------------------------------------------------

    def phase(self) -> None:
        """One phase, or a part of it up to an event that leaves the mode as it is."""
        try:
            if self.mode == Mode.FLIGHT:
                self.fly()
            elif self.mode == Mode.ROLL:
                self.contact(0)
            else:
                self.contact(1 if self.mode == Mode.SKID else -1)
        except _Full:
            return

    def fly(self) -> None:
        """A flight and its landing."""
        self.energy = None
        if self.until == REVOLUTION:
            self.end(Status.COMPLETED, "takeoff")
            return
        begin, longest = self.state, self.model.t_end - self.state.t
        flight = Flight(self.model, begin, self.zeros)
        if flight.hovers():
            self.witnesses.append({"mode": "H", "to": None, "apex": None})
            self.finish_flight(flight, longest)
            return
        landing = flight.lands(longest)
        tau = None if landing is None else landing.x
        if tau is not None and not tau < longest:
            raise Undecided("a landing and the end of the time come together")
        try:
            top = flight.apex(longest if tau is None else tau)
        except Undecided:  # an apex is no change of mode: an undecided one is left out
            top = None
        if top is not None:
            self.state = replace(top[0], vn=arb(0))
            self.note(Event.APEX, int(Mode.FLIGHT), int(Mode.FLIGHT))
        brackets = [None if root is None else bracket(root.x, root.low, root.high) for root in (landing, top and top[1])]
        self.witnesses.append({"mode": "H", "to": brackets[0], "apex": brackets[1]})
        if tau is None:
            self.finish_flight(flight, longest)
            return
        self.state = replace(flight.state(tau), y=arb(0))
        self.land()

    def finish_flight(self, flight: Flight, longest: Ball) -> None:
        """Time is over in flight."""
        self.state = flight.state(longest)
        self.end(Status.COMPLETED, "duration")

    def contact(self, sigma: int) -> None:
        """Roll or slip up to the next event."""
        closed = sigma == 0 and not self.model.resisted
        pieces = roll(self) if closed else travel(self, sigma)
        for ended in pieces:
            self.state, self.energy = ended.state, ended.energy
            if ended.witness:
                self.witnesses.append(ended.witness)
            if ended.what != TURN:
                self.after(ended)
            elif self.model.resisted:
                self.turned()
            else:
                self.turn()
            if self.done:
                return

    def turn(self) -> None:
        """θ̇ = 0."""
        self.note(Event.TURN, self.mode, self.mode)
        if self.until != DURATION:
            self.end(Status.COMPLETED, "reversal")

    def turned(self) -> None:
        """θ̇ = 0 with rolling resistance: the couple, and with it the contact force, jumps there."""
        was, mode = self.mode, next_mode(self.model, self.state)
        held = isinstance(self.model.after(self.state.th, self.state.om, 0), Still)
        if was == mode == Mode.ROLL and held:
            return  # rest, which is the next phase
        paradox = was != Mode.ROLL and mode > Mode.SKIM
        if not paradox or self.until != DURATION:
            self.turn()
        if self.done:
            return
        self.zeros = 0
        if mode != was:
            rolled = Event.TAKEOFF if mode == Mode.FLIGHT else Event.SLIP_START
            self.settle(Event.TURN if paradox else rolled if was == Mode.ROLL else Event.STICK, was)

    def after(self, ended: Ended) -> None:
        """Go through the event that ends a phase."""
        was = self.mode
        if ended.what == "rest":
            self.note(Event.REST, was, was)
            self.state = replace(self.state, t=self.model.t_end)
            self.end(Status.AT_REST, "rest")
        elif ended.what in ("limit", "span"):
            self.end(Status.COMPLETED, "duration" if ended.what == "limit" else "revolutions")
        elif ended.what == "lift":
            self.note(Event.TAKEOFF, was, int(Mode.FLIGHT))
            self.mode, self.zeros = int(Mode.FLIGHT), 3
        elif ended.what == "stop":
            self.settle(Event.STICK, was)
        else:
            self.leave_cone(ended.what)

    def leave_cone(self, what: str) -> None:
        """Rule 2: slip against the friction that was at its limit, at μk; or flight."""
        if opening_sign(self.model, self.state) >= 0:
            self.note(Event.TAKEOFF, int(Mode.ROLL), int(Mode.FLIGHT))
            self.enter(int(Mode.FLIGHT))
        elif what == "open":
            self.mode = UNDETERMINED
            self.end(Status.UNDETERMINED, "undetermined")
        else:
            mode = slip_mode(-1 if what == "ahead" else 1)
            self.note(Event.SLIP_START, int(Mode.ROLL), mode)
            self.mode = mode
            self.zeros = 2 if self.model.equal_friction else 1


class _Full(Exception):
    """There are as many events as are wanted."""


def _less(a: Ball, b: Ball, what: str) -> bool:
    if a < b:
        return True
    if b <= a:
        return False
    raise Undecided(f"{what} is not certain")
