"""Rolling and slipping, step by step, up to the first event."""

from __future__ import annotations

from collections.abc import Sequence

from hophoop.kernel.model import cone_weights, resistance_arm
from hophoop.kernel.records import State
from hophoop.kernel.steps import Ending
from hophoop.precise.jam import NEAR, approach, ending, missing_angle
from hophoop.precise.kernels import Number
from hophoop.precise.phases import Step, expand, integral_to, order_for, work
from hophoop.precise.problem import Body
from hophoop.precise.series import Judge, MorePrecision, sign_changes, stretched, value

ESTIMATE_ORDER = 14


class Stiff(Exception):
    """Slip runs into p_σ = 0: its steps have shrunk to nothing."""


def advance(body: Body, judge: Judge, sigma: int, state: State, zeros: int, t_end: Number) -> tuple[Ending, State]:
    """Roll or slip from the start of a phase, or from a turning point in it, up to the next event.

    Parameters
    ----------
    zeros : int
        How many leading coefficients of v_t are zero at the start of a slip phase.

    Returns
    -------
    ending : Ending
        SINGULAR: the motion ends in the dynamic jam.
    state : State
    """
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
                    return Ending.SINGULAR if reached[0] else Ending.SLIP_END, reached[1]
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
            return what, _settled(what, at(body, sigma, state, step, where), body)
        following = at(body, sigma, state, step, part)
        if final:
            return Ending.TIME_LIMIT, following._replace(t=t_end)
        endless = sigma == 0 and body.gt == 0 and body.resist == 0 and begin.om != 0
        if endless and abs(following.th - begin.th) >= 2 * body.ctx.pi:
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


def _first_exponent(body: Body, sigma: int, state: State) -> int:
    """A step from the decay of a short series."""
    exponent = -2 - int(abs(state.om)).bit_length()
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
    body: Body, judge: Judge, sigma: int, state: State, step: Step, part: int, fresh: bool, zeros: int
) -> tuple[Ending, int] | None:
    """(what, s) of the first event with s ≤ part."""
    bits = body.bits
    scale = max(body.integer(body.gn + abs(body.gt) + state.om * state.om), 1)
    watched: list[tuple[Ending, Sequence[int], int, int]] = []  # (what, series, sign just after 0, zeros divided out)
    if sigma == 0:
        margins = _cone_margins(body, step)
        for what, margin in zip((Ending.CONE_FORWARD, Ending.CONE_BACKWARD), margins, strict=False):
            known, sign = judge.leading(margin, scale) if fresh else (0, 1)
            if sign > 0:  # a margin that stays zero (rest without friction) is no event
                watched.append((what, margin, 1, known))
    else:
        watched.append((Ending.LIFT_OFF, step.normal, 1, judge.leading(step.normal, scale)[0] if fresh else 0))
        watched.append((Ending.SLIP_END, step.slip, sigma, judge.leading(step.slip, scale, zeros)[0] if zeros else 0))
    if state.om == 0:
        known, sign = judge.leading(step.omega, scale, 1)
    else:
        known, sign = 0, 1 if state.om > 0 else -1
    if sign:
        watched.append((Ending.TURNING_POINT, step.omega, sign, known))
    events: list[tuple[int, int, Ending]] = []
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


def at(body: Body, sigma: int, state: State, step: Step, s: int) -> State:
    """State at s of a step."""
    bits, ctx = body.bits, body.ctx
    tau = ctx.ldexp(ctx.mpf(s), step.exponent - bits)
    turned = body.of_integer(value(step.angle, s, bits))
    if body.resist > 0:
        cosine, sine = ctx.cos_sin(state.th)
        rho = body.kernels(resistance_arm)(body, sine, cosine, state.om, sigma)
        state = state._replace(rolling_loss=state.rolling_loss + rho * body.of_integer(work(step, step.omega, bits, s)))
    state = state._replace(
        t=state.t + tau, x=state.x + turned, th=state.th + turned, om=body.of_integer(value(step.omega, s, bits))
    )
    if sigma == 0:
        return state
    lost = sigma * body.mu_k * body.of_integer(work(step, step.slip, bits, s))
    return state._replace(
        x=state.x + body.of_integer(integral_to(step, step.slip, bits, s)),
        vt=body.of_integer(value(step.slip, s, bits)),
        friction=state.friction + lost,
    )


def _settled(what: Ending, state: State, body: Body) -> State:
    """The state with the quantity of the event set to 0."""
    if what == Ending.SLIP_END:
        return state._replace(vt=body.zero)
    if what == Ending.TURNING_POINT:
        return state._replace(om=body.zero)
    return state


def _cone_margins(body: Body, step: Step) -> list[list[int]]:
    """(μs N − F, μs N + F), over √(1 + μs²) so that neither part outweighs the other; N where μ is infinite."""
    if body.ctx.isinf(body.mu_s):
        return [list(step.normal)]
    a, b = map(body.integer, body.kernels(cone_weights)(body.mu_s))
    pairs = [(a * n, b * f) for n, f in zip(step.normal, step.friction, strict=True)]
    return [[(n - f) >> body.bits for n, f in pairs], [(n + f) >> body.bits for n, f in pairs]]


def _whole_turns(body: Body, begin: State, state: State, step: Step, part: int, following: State, t_end: Number) -> State:
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
