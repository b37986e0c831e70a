"""The end of a flight: the first place where the gap closes, panel by panel."""

from __future__ import annotations

import math

from hophoop._jit import apart_jit, inline_jit
from hophoop.numerics.collocation import NODES, ORDER, coefficients, left_value
from hophoop.numerics.roots import NOT_FOUND, first_fall_after
from hophoop.physics.flight import MANY_TURNS, flight_gap

MOST_PANELS = 20_000  # looked at in one flight: some thousand turns close to the plane
MANY = 1_000.0  # panels: a longer flight is not looked at where the rim is too high to land whatever its angle
PHASE = 3.0  # rad of rotation in one panel: the first coefficient left out, J₁₆(1.5), is 5e-16


@apart_jit
def polished(body, s, c, om, y, vn, fn, tau, reach):
    """A landing time improved on the gap itself, by Newton; left alone where a step would be large."""
    for _ in range(3):
        gap, rate = flight_gap(body, s, c, om, y, vn, fn, tau)
        if rate >= 0.0:
            return tau
        better = tau - gap / rate
        if not abs(better - tau) < reach or better <= 0.0:
            return tau
        if better == tau:
            return tau
        tau = better
    return tau


@apart_jit
def grazes(body, s, c, th, om, y, vn, fn, tau):
    """Whether the gap has a minimum at or beside tau that is zero but for rounding: a touch without approach."""
    gap, rate = flight_gap(body, s, c, om, y, vn, fn, tau)
    bend = -body.gn + body.eps * om * om * math.cos(th + om * tau)
    if bend <= 0.0:
        return rate >= 0.0  # without gravity the gap may stay zero
    size = y + body.eps + abs(vn * tau) + abs(fn) * tau * tau
    if abs(om * tau) > MANY_TURNS:  # as `flight_gap` adds it up
        size = y + body.eps + abs(vn - body.eps * om * s) * tau + body.gn * tau * tau
    return gap - 0.5 * rate * rate / bend > -4e-16 * size


@inline_jit
def worth_looking(body, c, om, y, rise, start, never):
    """From where on a flight of many turns is to be looked at: beside its top, and where the rim can reach the plane.

    `rise` is the speed of the centre of gravity away from the plane, whose parabola less ε is below the gap.
    """
    clear = y + body.eps * (c - 1.0)
    if not clear + start * (rise - 0.5 * body.gn * start) > 0.0:
        return start
    near = 3.0 * PHASE / abs(om)
    if body.gn == 0.0:
        down = never if rise >= 0.0 else clear / -rise
    else:
        root = math.sqrt(max(rise * rise + 2.0 * body.gn * clear, 0.0))
        down = (rise + root) / body.gn
        top = rise / body.gn
        if start <= top + near:
            return max(start, top - near)
    return max(start, (1.0 - 1e-12) * down - near)


@apart_jit
def first_landing(body, th, om, y, vn, fn, order, limit, values, series, stack):
    """First contact of a flight and its highest centre.

    Parameters
    ----------
    order : int
        How many leading derivatives of the gap vanish at the start (0 for a start above the plane).
    limit : float
        Longest time to look at.

    Returns
    -------
    landing : float
        Time of the first contact with approach, or -1.
    apex : float
        Time at which the centre is highest, or -1 if it is so at an end of the flight.
    seen : float
        Time up to which the flight was looked at: `limit`, or less where that would take more than `MOST_PANELS`.
    """
    s = math.sin(th)
    c = math.cos(th)
    apex = -1.0
    highest = y
    # Beyond `never` the parabola has left the reach of the cosine for good. Panels depend on it and not on the limit
    # of time where they can, so that a motion has the same bits however long it is followed.
    rise = vn - body.eps * s * om
    reach = 2.0 * body.eps + y
    never = limit
    if body.gn > 0.0:
        root = math.sqrt(rise * rise + 2.0 * body.gn * reach)
        drop = (rise + root) / body.gn if rise > 0.0 else 2.0 * reach / (root - rise) if root > 0.0 else 0.0
        never = 1.001 * drop + 1e-300
    elif rise > 0.0:
        never = 2.0 * reach / rise + 1e-300
    elif rise == 0.0 and om != 0.0:
        never = 7.0 / abs(om)
    spread = vn * vn - 2.0 * fn * y
    if order <= 1 and spread >= 0.0 and (vn < 0.0 or fn < 0.0):
        # a flight too short for rounding to leave a panel its beginning: nearly a parabola
        if vn < 0.0:
            landing = 2.0 * y / (math.sqrt(spread) - vn)
        else:
            landing = (vn + math.sqrt(spread)) / -fn
        turned = abs(om) * landing
        bends = body.eps * om * om * turned
        if 0.0 < landing < never and turned < 1e-2 and bends < 1e-4 * (abs(fn) + abs(vn) / landing):
            if vn > 0.0:
                apex = -vn / fn
                for _ in range(3):
                    bend = -body.gn + body.eps * om * om * math.cos(th + om * apex)
                    apex -= flight_gap(body, s, c, om, y, vn, fn, apex)[1] / bend
            return polished(body, s, c, om, y, vn, fn, landing, 0.1 * landing), apex, limit
    start = 0.0
    for _ in range(MOST_PANELS):
        if abs(om) * (min(never, limit) - start) > MANY * PHASE:
            start = worth_looking(body, c, om, y, rise, start, never)
        if not start < min(never, limit):
            return -1.0, apex, limit
        length = never - start
        if om != 0.0:
            length = min(length, PHASE / abs(om))
        end = start + length
        for i in range(ORDER):
            tau = start + 0.5 * length * (1.0 + NODES[i])
            gap, rate = flight_gap(body, s, c, om, y, vn, fn, tau)
            # known leading zeros are divided out on the first panel
            scale = 1.0
            if start == 0.0:
                for _ in range(order):
                    scale *= 0.5 * (1.0 + NODES[i])
            values[0, i] = gap / scale
            if start == 0.0 and order > 0:
                scale /= 0.5 * (1.0 + NODES[i])
            values[1, i] = rate / scale
        coefficients(values[0], series)
        if start > 0.0 and left_value(series) <= 0.0 and not grazes(body, s, c, th, om, y, vn, fn, start):
            return start, apex, limit
        landing = -1.0
        begin = -2.0
        while True:
            xi = first_fall_after(series, begin, 0.0, stack)
            if xi == NOT_FOUND:
                break
            tau = start + 0.5 * length * (1.0 + xi)
            tau = polished(body, s, c, om, y, vn, fn, tau, 0.01 * length)
            if not grazes(body, s, c, th, om, y, vn, fn, tau):
                landing = tau
                break
            begin = xi
        # A panel turns by less than 2π, so the rate, a line plus a sine, falls through zero at most twice.
        coefficients(values[1], series)
        begin = -2.0
        for _ in range(2):
            xi = first_fall_after(series, begin, 0.0, stack)
            if xi == NOT_FOUND:
                break
            begin = xi
            top = start + 0.5 * length * (1.0 + xi)
            if landing >= 0.0 and top >= landing:
                break
            for _ in range(2):
                bend = -body.gn + body.eps * om * om * math.cos(th + om * top)
                better = top - flight_gap(body, s, c, om, y, vn, fn, top)[1] / bend
                if abs(better - top) < 0.01 * length:
                    top = better
            gap = flight_gap(body, s, c, om, y, vn, fn, top)[0]
            if gap > highest:
                highest = gap
                apex = top
        if landing >= 0.0:
            return landing, apex, limit
        start = end
    return -1.0, apex, min(start, limit)
