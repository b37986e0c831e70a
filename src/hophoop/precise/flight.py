"""Flight: the gap is a parabola minus a cosine, an entire function of time; its Taylor series has no limit of its own."""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.kernel.model import flight_displacement, free_acceleration
from hophoop.kernel.records import State
from hophoop.kernel.steps import Flight, landing_time_bound
from hophoop.precise.kernels import Number
from hophoop.precise.phases import gap_series
from hophoop.precise.problem import Body
from hophoop.precise.series import Judge, sign_changes, slope_at, stretched, value


class Landing(NamedTuple):
    """The end of a flight: the state there, whether it lands, and the state where the centre is highest."""

    state: State
    lands: bool
    apex: State | None


class Step(NamedTuple):
    """A step of flight: its start, and the series of the gap over 2^exponent with coefficients in units of 2^−bits."""

    state: State
    series: list[int]
    bits: int
    exponent: int


def fly(body: Body, judge: Judge, state: State, lifted: bool, t_end: Number) -> Landing:
    """Fly until the rim meets the plane or time is over.

    Parameters
    ----------
    lifted : bool
        Whether the hoop has just left the plane from slip with N → 0, so that f_n is zero.
    """
    known = 0 if state.y > 0 else 1 if state.vn != 0 else 3 if lifted else 2
    apex: State | None = None
    highest = state.y
    while True:
        opening = body.zero if known == 3 else opening_at(body, state)
        left = t_end - state.t
        if left <= 0:
            return Landing(state._replace(t=t_end), False, apex)
        exponent = _exponent(body, state, opening, left)
        bits = body.bits + max(0, -3 * exponent) + 16
        body.work.take(bits)
        series = gap_series(body, state, opening, exponent, _order(body, state, exponent, bits), bits)
        scale = max(map(abs, series))
        judge_here = Judge(body.bits, judge.last)
        if scale == 0:
            return Landing(_moved(body, state, left, state.y, state.vn)._replace(t=t_end), False, apex)
        zeros, sign = judge_here.leading(series, scale, known, len(series)) if known else (0, 1)
        if sign == 0:  # nothing ever lifts it: it hovers on the plane
            return Landing(_moved(body, state, left, state.y, state.vn)._replace(t=t_end), False, apex)
        part = 1 << bits
        limit = int(body.ctx.floor(body.ctx.ldexp(left, bits - exponent)))
        final = limit <= part
        part = min(part, limit)
        where = part
        roots = sign_changes(stretched(series[zeros:], part, bits), sign, bits, judge_here) if sign > 0 else [0]
        lands = bool(roots)
        if lands:
            where = roots[0] * part >> bits
        step = Step(state, series, bits, exponent)
        top = _highest(body, judge_here, step, known, where, highest)
        if top is not None:
            apex, highest = top, top.y
        after = _at(body, step, where)
        if lands:
            vn = min(after.vn, body.zero)
            return Landing(after._replace(y=body.zero, vn=vn), True, apex)
        if final:
            kept = apex is not None and not _rises_above(body, judge, after, apex)
            return Landing(after._replace(t=t_end), False, apex if kept else None)
        state, known = after, 0


def _rises_above(body: Body, judge: Judge, state: State, apex: State) -> bool:
    """Return True if the rest of a flight that is cut has a higher apex."""
    cosine, sine = body.ctx.cos_sin(state.th)
    flight = Flight(sine, cosine, state.om, state.y, state.vn, opening_at(body, state))
    rise = state.vn - body.eps * sine * state.om
    longest = body.kernels(landing_time_bound)(body, flight, rise)
    later = fly(body, judge, state, False, state.t + longest).apex
    return later is not None and later.y > apex.y


def opening_at(body: Body, state: State) -> Number:
    """f_n: acceleration of the lowest point off the plane without contact force."""
    cosine, sine = body.ctx.cos_sin(state.th)
    return body.kernels(free_acceleration)(body, sine, cosine, state.om * state.om)[1]


def _exponent(body: Body, state: State, opening: Number, left: Number) -> int:
    """h = 2^exponent: at most half a turn, and not much beyond where a parabola would land."""
    ctx = body.ctx
    sizes = [left]
    if state.om != 0:
        sizes.append(2 / abs(state.om))
    if opening < 0:
        root = ctx.sqrt(state.vn * state.vn - 2 * opening * state.y)
        fall = (state.vn + root) / -opening if state.vn > 0 else 2 * state.y / (root - state.vn) if state.y else 0
        if fall > 0:
            sizes.append(fall * 5 / 4)
    return int(ctx.ceil(ctx.log(min(sizes), 2)))


def _order(body: Body, state: State, exponent: int, bits: int) -> int:
    """Terms until those of the cosine are below rounding."""
    turned = float(abs(body.ctx.ldexp(state.om, exponent)))
    k, small = 3, 0.0
    while turned > 0.0 and small <= bits and k < 4000:
        small -= math.log2(turned / k)  # noqa: TID251 - how long a step is
        k += 1
    return k + 1


def _highest(body: Body, judge: Judge, step: Step, known: int, where: int, best: Number) -> State | None:
    """The highest apex of the gap in a step, if it is higher than the best of the flight so far."""
    state, bits = step.state, step.bits
    rate = [k * step.series[k] for k in range(1, len(step.series))]
    scale = max(map(abs, rate))
    zeros = max(known - 1, 1 if state.vn == 0 and known == 0 else 0)
    if scale == 0 or where == 0:
        return None
    zeros, sign = judge.leading(rate, scale, zeros, len(rate))
    if sign == 0:
        return None
    found = None
    for root in sign_changes(stretched(rate[zeros:], where, bits), sign, bits, judge, first=False):
        sign = -sign
        if sign < 0:
            top = _at(body, step, root * where >> bits)._replace(vn=body.zero)
            if top.y > best:
                best, found = top.y, top
    return found


def _at(body: Body, step: Step, s: int) -> State:
    """State at s of a step of flight."""
    ctx = body.ctx
    state, series, bits, exponent = step
    tau = ctx.ldexp(ctx.mpf(s), exponent - bits)
    y = ctx.ldexp(ctx.mpf(value(series, s, bits)), -bits)
    vn = ctx.ldexp(ctx.mpf(slope_at(series, s, bits)), -bits - exponent)
    return _moved(body, state, tau, y, vn)


def _moved(body: Body, state: State, tau: Number, y: Number, vn: Number) -> State:
    """The state after τ with this gap: G is a projectile and θ̇ is constant."""
    cosine, sine = body.ctx.cos_sin(state.th)
    along, vt = body.kernels(flight_displacement)(body, state.vt, state.om, sine, cosine, tau)
    return state._replace(t=state.t + tau, x=state.x + along, y=y, th=state.th + state.om * tau, vt=vt, vn=vn)
