"""Rolling and slipping, step by step, up to the first event."""

from __future__ import annotations

from enum import Enum, auto
from typing import NamedTuple

from hophoop.kernel.physics.body import Status
from hophoop.precise.jam import NEAR, approach, ending, missing_angle
from hophoop.precise.phases import Step, expand, order_for, travel, work_of_friction, work_of_resistance
from hophoop.precise.problem import Body, Number, PreciseState
from hophoop.precise.rules import cone_margins, direction, tie_exponent
from hophoop.precise.series import Judge, MorePrecision, sign_changes, stretched, value

ESTIMATE_ORDER = 14
MOST_STEPS = 1_000_000


class Advance(Enum):
    """The ends of a phase of contact, in the order of precedence of simultaneous ones."""

    CONE_AHEAD = auto()
    CONE_BACK = auto()
    LIFT = auto()
    STOP = auto()
    TURN = auto()
    JAM = auto()
    LIMIT = auto()


class Done(NamedTuple):
    """The end of an advance and the state there."""

    what: Advance
    state: PreciseState


class Stopped(Exception):
    """The motion has come to an end that is asked for or that the physics sets."""

    def __init__(self, status: Status) -> None:
        super().__init__(status.name)
        self.status = status


class Stiff(Exception):
    """Slip runs into p_σ = 0: its steps have shrunk to nothing."""


def advance(body: Body, judge: Judge, mode: int, state: PreciseState, zeros: int, t_end: Number, rolled: bool) -> Done:
    """Roll or slip from the start of a phase, or from a turning point in it, up to the next event.

    Parameters
    ----------
    zeros : int
        How many leading coefficients of v_t are zero at the start of a slip phase.
    rolled : bool
        Whether the phase goes on from a turning point: its margins are not zero there.
    """
    sigma = direction(mode)
    order = order_for(body.bits)
    fresh = True
    exponent = _first_exponent(body, sigma, state)
    begin = state
    tried = body.ctx.mpf(NEAR)
    while True:
        if sigma != 0 and state.om != 0:
            missing = missing_angle(body, state, sigma)
            if 0 < missing < tried:
                tried = missing / 4
                ahead = approach(body, state, sigma)
                reached = ending(ahead) if ahead is not None else None
                if reached is not None and reached[1].t <= t_end:
                    return Done(Advance.JAM if reached[0] else Advance.STOP, reached[1])
                if ahead is not None:
                    tried = body.zero  # time is over before, or the slip
        step = expand(body, sigma, state, exponent, order)
        while step is None or step.reach < 1 << (body.bits - 2):
            exponent -= 1 if step is not None else 4
            _check_step(body, judge, exponent)
            step = expand(body, sigma, state, exponent, order)
        _check_step(body, judge, exponent)
        part = min(step.reach, 1 << body.bits)
        left = t_end - state.t
        limit = body.integer(body.ctx.ldexp(left, -exponent))
        final = limit <= part
        if final:
            part = max(limit, 0)
        found = first_event(body, judge, sigma, state, step, part, fresh, zeros) if part > 0 else None
        if found is not None:
            what, where = found
            return Done(what, _settled(what, at(body, sigma, state, step, where), body))
        if final:
            return Done(Advance.LIMIT, at(body, sigma, state, step, part)._replace(t=t_end))
        following = at(body, sigma, state, step, part)
        if sigma == 0 and body.gt == 0 and body.resist == 0 and _turned(body, begin, following):
            following = _whole_turns(body, begin, state, step, part, following, t_end)
            begin = begin._replace(om=body.zero)  # once is enough
        state = following
        exponent += step.room
        fresh, zeros = False, 0


def _check_step(body: Body, judge: Judge, exponent: int) -> None:
    """Refuse steps whose angle has lost half of its digits: near p_σ = 0 they need more."""
    if exponent < -body.bits // 2 and not judge.last:
        raise MorePrecision
    if exponent < -2 * body.bits:
        raise Stiff


def _first_exponent(body: Body, sigma: int, state: PreciseState) -> int:
    """A step from the decay of a short series."""
    exponent = tie_exponent(state.om)
    while True:
        step = expand(body, sigma, state, exponent, ESTIMATE_ORDER)
        if step is not None:
            break
        exponent -= 4
        if exponent < -2 * body.bits:
            raise Stiff
    size = body.integer(1 + abs(state.om))
    worst = -4.0
    for series in (step.omega, step.normal):
        for k in range(len(series) // 2, len(series)):
            if series[k]:
                worst = max(worst, (abs(series[k]).bit_length() - size.bit_length()) / k)
    # terms are to shrink by e² each
    return exponent - int(worst + 2.9 + 1000.5) + 1000


def first_event(
    body: Body, judge: Judge, sigma: int, state: PreciseState, step: Step, part: int, fresh: bool, zeros: int
) -> tuple[Advance, int] | None:
    """(what, s) of the first event with s ≤ part."""
    bits = body.bits
    scale = max(body.integer(body.gn + abs(body.gt) + state.om * state.om), 1)
    watched: list[tuple[Advance, list[int], int, int]] = []  # (what, series, sign just after 0, zeros divided out)
    if sigma == 0:
        margins = cone_margins(body, step.normal, step.friction)
        for what, margin in zip((Advance.CONE_AHEAD, Advance.CONE_BACK), margins, strict=False):
            known, sign = judge.leading(margin, scale) if fresh else (0, 1)
            if sign > 0:  # a margin that stays zero (rest without friction) is no event
                watched.append((what, margin, 1, known))
    else:
        known, sign = judge.leading(step.normal, scale) if fresh else (0, 1)
        watched.append((Advance.LIFT, list(step.normal), 1, known))
        if zeros:
            known, sign = judge.leading(step.slip, scale, zeros)
        else:
            known = 0
        watched.append((Advance.STOP, list(step.slip), sigma, known))
    if state.om == 0:
        known, sign = judge.leading(step.omega, scale, 1)
    else:
        known, sign = 0, 1 if state.om > 0 else -1
    if sign:
        watched.append((Advance.TURN, list(step.omega), sign, known))
    events: list[tuple[int, int, Advance]] = []
    for rank, (what, series, sign, known) in enumerate(watched):
        rest = series[known:]
        # most series show at once that they stay away from zero
        if sign * rest[0] > sum(map(abs, rest)) - abs(rest[0]):
            continue
        roots = sign_changes(stretched(rest, part, bits), sign, bits, judge)
        if roots:
            events.append((roots[0] * part >> bits, rank, what))
    if not events:
        return None
    events.sort()
    first = events[0]
    for other in events[1:]:
        if judge.sign(other[0] - first[0], 1 << bits) == 0 and other[1] < first[1]:
            first = other
    return first[2], first[0]


def at(body: Body, sigma: int, state: PreciseState, step: Step, s: int) -> PreciseState:
    """State at s of a step."""
    bits, ctx = body.bits, body.ctx
    tau = ctx.ldexp(ctx.mpf(s), step.exponent - bits)
    turned = body.of_integer(value(step.angle, s, bits))
    om = body.of_integer(value(step.omega, s, bits))
    if body.resist > 0:
        rho = body.integer(body.resistance(state.th, state.om, sigma))
        state = state._replace(resisted=state.resisted + body.of_integer(work_of_resistance(step, rho, body.fixed, s)))
    if sigma == 0:
        return state._replace(t=state.t + tau, x=state.x + turned, th=state.th + turned, om=om)
    slid = body.of_integer(travel(step, body.fixed, s))
    lost = body.of_integer(work_of_friction(step, body.fixed, s))
    return state._replace(
        t=state.t + tau,
        x=state.x + turned + slid,
        th=state.th + turned,
        vt=body.of_integer(value(step.slip, s, bits)),
        om=om,
        friction=state.friction + lost,
    )


def _settled(what: Advance, state: PreciseState, body: Body) -> PreciseState:
    """The state with the quantity of the event set to 0."""
    if what == Advance.STOP:
        return state._replace(vt=body.zero)
    if what == Advance.TURN:
        return state._replace(om=body.zero)
    return state


def _turned(body: Body, begin: PreciseState, state: PreciseState) -> bool:
    """Return True if rolling has gone through a revolution since the phase began; False once that has been used."""
    return bool(begin.om != 0 and abs(state.th - begin.th) >= 2 * body.ctx.pi)


def _whole_turns(
    body: Body, begin: PreciseState, state: PreciseState, step: Step, part: int, following: PreciseState, t_end: Number
) -> PreciseState:
    """Rolling on the level without an event in a whole turn has none in any: go on by as many turns as there is time for."""
    ctx, bits = body.ctx, body.bits
    way = 1 if begin.om > 0 else -1
    ahead = body.integer(begin.th + 2 * ctx.pi * way - state.th)
    series = [angle * -way for angle in step.angle]
    series[0] += ahead * way
    (where, *_) = sign_changes(stretched(series, part, bits), 1, bits, Judge(bits, True)) or [1 << bits]
    turn = state.t + ctx.ldexp(ctx.mpf(where * part >> bits), step.exponent - bits) - begin.t
    count = int(ctx.floor((t_end - following.t) / turn))
    if count < 1:
        return following
    angle = 2 * ctx.pi * way * count
    return following._replace(t=following.t + turn * count, x=following.x + angle, th=following.th + angle)
