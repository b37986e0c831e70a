"""One motion at one working precision: the kernel's steps from event to event over balls."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from fractions import Fraction
from typing import Any

from hophoop.kernel.steps import NONE
from hophoop.precise import motion, problem
from hophoop.precise.problem import Problem
from hophoop.prove.contact import advance
from hophoop.prove.flight import Flight
from hophoop.prove.formulas import (
    STOP_AT_TAKEOFF,
    STOP_AT_TURN,
    Ending,
    Event,
    Formulas,
    ImpactLaw,
    Limits,
    Mode,
    PendingEvent,
    State,
    Status,
    end_motion,
    limits_of,
    names_of_balls,
    slip_direction,
)
from hophoop.prove.numbers import Number, Unclear, arb, ball, rational, raw, root, sign

SPREAD = 1000  # of the box about bounces to come, over the first estimate of how far they go


def never(*given: Any) -> Any:
    """What balls do not need."""
    raise Unclear("the slip stays away from p_σ = 0")


class Body(problem.Body):
    """Hoop and plane as balls, in units of R, m and √(R/g).

    Parameters
    ----------
    exact : Problem
    look_at_clock : callable
        Raises where the time is over.
    """

    of: Any  # the kernel's formulas

    def __init__(self, exact: Problem, look_at_clock: Callable[[], None]) -> None:
        self.look_at_clock, self.ctx, self.zero = look_at_clock, None, ball(0)
        self.names = names_of_balls()
        self.sine_cosine = self.names["sine_and_cosine"]
        self.take(exact, ball(math.inf), root, self.sine_cosine)

    def number(self, value: Fraction) -> Number:
        """The ball of a rational number."""
        return rational(value)

    def energy(self, state: State) -> Number:
        """Kinetic and potential energy."""
        kinetic = self.of.kinetic_energy(self, state.th, state.om, state.vt, state.vn, ball(0))
        return kinetic + self.of.potential_energy(self, state.x, state.y, state.th)


class Run(motion.Run):
    """One motion at the present working precision; it is also the log that the kernel's steps write their events to.

    Parameters
    ----------
    problem : Problem
    closing : Number
        Bounces are closed when those to come are shown to take less than this part of the time so far.
    revolution : bool
        The motion ends with a revolution, a turning point or a take-off, and not with its duration.
    max_events : int
        The motion stops after so many events.
    look_at_clock : callable
        Raises where the time is over.
    """

    body: Any

    def __init__(
        self, problem: Problem, closing: Number, revolution: bool, max_events: int, look_at_clock: Callable[[], None]
    ) -> None:
        self.doubt, self.problem, self.max_events, self.closing = None, problem, max_events, closing
        self.body = body = Body(problem, look_at_clock)
        self.t_end = rational(problem.duration) / body.time
        self.revolution, self.status, self.ending = revolution, Status.COMPLETED, Ending.CONTINUES
        self.records: list[motion.Record] = []
        self.turns: list[State] = []
        names = body.names | {
            "advance_contact": self.advance, "is_equilibrium": self.is_equilibrium, "is_last_bounce": self.is_last_bounce,
            "end_bounces": self.end_bounces, "resolve_painleve_singularity": never,
            "begin_massless": never, "begin_skim": never, "rolling_anchor": lambda body, state, s, c: NONE,
            "doubt_rest": lambda body, sigma, state, until, log: None,
            "write_event": self.write, "write_segment": lambda *given: None, "mode_is_in_doubt": lambda body, state: False,
            "record_doubt": lambda doubt, t: None,
        }  # fmt: skip
        self.kernels = body.of = Formulas(names)
        self.rest: tuple[State, Number, Number] | None = None  # of endless bounces

    def limits(self) -> Limits:
        """What the motion ends with."""
        stop = STOP_AT_TURN + STOP_AT_TAKEOFF if self.revolution else 0
        limits: Limits = limits_of(self.body.start(), self.t_end, math.nan, stop, 0)
        return limits

    def is_equilibrium(self, body: Any, sigma: int, state: State) -> bool:
        """Return True if a hoop with θ̇ = 0 stays so."""
        of, (s, c) = body.of, body.sine_cosine(state.th)
        if body.resist > 0:
            torque = of.torque_at_rest(body, s, c) if sigma == 0 else of.slip_torque_arm(body, s, c, sigma) * body.gn
            return bool(abs(torque) <= body.resist * body.gn)
        return bool(of.acceleration_in_contact(body, s, c, ball(0), sigma) == 0)

    def flight(self, phase: Any) -> Any:
        """Fly until the landing and its impact, or the end."""
        if self.revolution:
            return end_motion(phase, Mode.FLIGHT, phase.state, Ending.LIFT_OFF, Status.COMPLETED)
        flight = Flight(self.body, phase.state, phase.ending == Ending.LIFT_OFF)
        state, lands, apex = flight.fly(raw(self.t_end - phase.state.t))
        if apex is not None:
            self.write_passing(Event.APEX, Mode.FLIGHT, apex)
        if lands:
            return self.body.of.land(self.body, state, self)
        return end_motion(phase, Mode.FLIGHT, state._replace(t=self.t_end), Ending.TIME_LIMIT, Status.COMPLETED)

    def advance(self, body: Any, phase: Any, limits: Any, log: Any, scratch: Any) -> Any:
        """What `contact_step` asks for."""
        sigma, state = slip_direction(phase.mode), phase.state
        if state.om == 0 and self.is_equilibrium(body, sigma, state):
            return phase._replace(ending=Ending.REST)
        if sigma == 0:
            state = state._replace(vt=ball(0))
        zeros = self.body.of.vanishing_slip_derivatives(body, phase) if sigma and phase.begins else 0
        end, origin = (ball(math.inf), rational(self.problem.angle)) if self.revolution else (self.t_end, None)
        ending, state = advance(body, sigma, state, zeros, end, origin)
        return phase._replace(state=state, ending=ending, begins=False)

    # --- endless bounces -----------------------------------------------------------------------

    def is_last_bounce(self, body: Any, state: State, after: State) -> bool:
        """Return True if all bounces to come are shown to take less than `closing` of the time so far."""
        if not after.vn > 0:
            return False
        try:
            self.rest = self.after_bounces(after)
        except Unclear:
            self.rest = None
        return self.rest is not None

    def end_bounces(self, body: Any, state: State) -> tuple[State, PendingEvent]:
        """The state after all bounces, and their impulse with that of the present impact."""
        _, cause = body.of.collide(body, body.rest, state, Event.BOUNCE_LIMIT, Mode.FLIGHT, 1)
        assert self.rest is not None
        end, p_n, p_t = self.rest
        return end, cause._replace(p_n=cause.p_n + p_n, p_t=cause.p_t + p_t, gain=ball(0))

    def after_bounces(self, after: State) -> tuple[State, Number, Number] | None:
        """(state after all bounces, their impulses) from the state after an impact; None if they are not known to be short.

        As long as the motion stays in a box about θ, θ̇ and v_t, −f_n and the rates of an impact are bounded there. So v_n
        shrinks by a factor at least from bounce to bounce, and all changes are geometric series (docs/method.md).
        """
        body, of, v = self.body, self.body.of, after.vn
        s, c = body.sine_cosine(after.th)
        fall = -of.free_acceleration(body, s, c, after.om * after.om)[1]
        longest = self.closing * (after.t if after.t > 1 else ball(1))
        if not fall > 0 or not v < fall * longest or body.mu_s == math.inf:
            return None
        size = SPREAD * v / fall * (1 + abs(after.om) + abs(body.gt))
        if after.om == 0 and after.vt == 0 and s == 0 and body.gt == 0:  # a vertical bounce changes nothing else
            size = ball(0)
        th, om, vt = (one + within(size) for one in (after.th, after.om, after.vt))
        f_t, f_n = of.free_acceleration(body, *body.sine_cosine(th), om * om)
        least, most = ball(raw(-f_n).lower()), ball(raw(-f_n).upper())
        arm, lever = of.contact_arms(body, *body.sine_cosine(th))
        slides = 0 if after.vt == 0 else sign(vt)
        sides = (slides,) if slides else tuple(side for side in (1, -1) if not raw(side * f_t) <= 0)  # of slip at a landing
        slips = [of.slip_rates(body, arm, lever, -side * body.mu_k) for side in sides]
        ratio, turn, lift = of.stick_rates(body, arm, lever)
        sticks = [] if slides else [(turn, ball(0), lift)]
        turns, slows, lifts = zip(*slips, *sticks, strict=True)
        low, high = ball(min(raw(one).lower() for one in lifts)), ball(max(raw(one).upper() for one in lifts))
        if not (least > 0 and low > 0):
            return None
        spread = {ImpactLaw.NEWTON: ball(1), ImpactLaw.POISSON: high / low, ImpactLaw.STRONGE: root(high / low)}[body.law]
        grow, q = root(most / least), body.rest if slides else body.rest * spread
        if not q * grow < 1:
            return None
        if not slides:  # slip that a flight has made stops while the hoop still approaches, and the contact sticks then
            soon = root(least / most) / high
            stops = all(-side * one[1] * least * soon > 2 * abs(f_t) for side, one in zip(sides, slips, strict=True))
            if not (stops and abs(ratio) < body.mu_s):
                return None
        whole = v / (1 - q * grow)  # the sum of v_n after all impacts
        time, p_n = 2 * whole / least, (1 + q) * grow * whole / low
        p_t, change_om = body.mu_s * p_n, largest(turns) * p_n
        change_vt, change_th = largest(slows) * p_n + abs(f_t) * time, (abs(after.om) + change_om) * time
        if not (
            change_om <= size and change_vt <= size and change_th <= size and time < longest and after.t + time < self.t_end
        ):
            return None
        loss = within((1 + q) * grow * grow * v * whole / low + (abs(after.vt) + change_vt) * p_t)
        later = ball(arb(0.5, 0.5))
        end = after._replace(
            t=after.t + later * time, x=after.x + within((abs(vt) + abs(om)) * time), th=after.th + within(change_th),
            vt=after.vt + within(change_vt) if slides else ball(0), vn=ball(0), om=after.om + within(change_om),
            impact_n=after.impact_n + loss, impact_t=after.impact_t + loss,
        )  # fmt: skip
        return end, later * p_n, within(p_t)


def within(bound: Number) -> Number:
    """Any number that is no larger."""
    return ball(arb(0, raw(bound).abs_upper()))


def largest(values: Iterable[Number]) -> Number:
    """An upper bound of the sizes."""
    return ball(max(raw(one).abs_upper() for one in values))
