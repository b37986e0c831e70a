"""End of a flight: the first zero of the gap, searched from one inflection of the gap to the next.

The second derivative of the gap is −g_n + ε θ̇² cos θ. So the gap is convex while the load is within arccos(g_n/(ε θ̇²)) of the
top, and concave elsewhere. Between two inflections there is at most one downcrossing and at most one maximum, and the values at
both inflections show whether it exists.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.arcs import arccosine
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.physics.closed_forms import LARGE_ROTATION, flight_rates

MOST_BENDS = 20_000  # maximum of arcs between inflections per flight: about 10,000 revolutions close to the plane
MANY = 3_000.0  # rad: in a longer flight, times are skipped at which the rim is too high to land at any angle
MOST_STEPS = 200  # towards a root; a step that leaves the bracket is replaced by a halving
NEAR = 9.0  # rad before the apex and before the plane at which the search starts: more than one revolution
RESOLVED_TIME = 2e-16  # relative accuracy of a root


class Flight(NamedTuple):
    """Start of a flight."""

    s: float
    c: float
    om: float
    y: float
    vn: float
    fn: float  # exactly 0 after a lift-off from slip


class Moment(NamedTuple):
    """The gap and its derivatives at one time of a flight."""

    tau: float
    gap: float
    rate: float
    bend: float
    jerk: float


@inline
def moment_of(body, flight, tau):
    """Return the gap and its derivatives at the time tau."""
    gap, rate, bend, jerk = flight_rates(body, flight.s, flight.c, flight.om, flight.y, flight.vn, flight.fn, tau)
    return Moment(tau, gap, rate, bend, jerk)


@inline
def parabola_downcrossing(value, rate, bend):
    """Return the time t > 0 at which value + rate t + bend t²/2 falls through zero; nan if there is none."""
    square = rate * rate - 2.0 * bend * value
    if square < 0.0:
        return math.nan
    if rate < 0.0:
        return 2.0 * value / (math.sqrt(square) - rate)
    return (rate + math.sqrt(square)) / -bend if bend < 0.0 else math.nan


@inline
def halley_step(value, slope, bend):
    """Return Halley's correction (third order) for a zero of a function, to be subtracted."""
    if slope == 0.0:
        return math.inf
    step = value / slope
    return step * (1.0 + 0.5 * step * (bend / slope))


@inline
def has_converged(moved, before, tau):
    """Return True if Halley's steps have converged: the next step, about moved³/before³ times this one, would be rounding."""
    if moved <= RESOLVED_TIME * tau:
        return True
    if before == 0.0:
        return False
    part = moved / before
    if moved <= 1e-4 * tau and moved * (part * part * part) <= 0.05 * RESOLVED_TIME * tau:
        return True
    return moved < 1e-13 * tau and part >= 0.5  # limit set by the rounding of the gap


@inline
def target_function(moment, level, direction):
    """Return the function whose downcrossing is searched and two derivatives: the gap, or ± its rate if `level`."""
    if level:
        return direction * moment.rate, direction * moment.bend, direction * moment.jerk
    return moment.gap, moment.rate, moment.bend


@noinline
def downcrossing_between(body, flight, first, last, level):
    """Return the time of the only zero of the gap, or of its rate if `level`, between two moments.

    The gap falls. Its rate falls through zero at a maximum of the gap and rises through zero at a minimum.
    """
    direction = -1.0 if level and not first.rate > 0.0 else 1.0
    low = first.tau
    high = last.tau
    value, slope, bend = target_function(first, level, direction)
    tau = low + parabola_downcrossing(value, slope, bend)
    if not low < tau < high:
        drop = value - target_function(last, level, direction)[0]
        # both ends of an arc may have the same gap
        tau = low + (high - low) * (value / drop) if drop > 0.0 else low
    before = 0.0
    for _ in range(MOST_STEPS):
        value, slope, bend = target_function(moment_of(body, flight, tau), level, direction)
        if value > 0.0:
            low = tau
        else:
            high = tau
        better = tau - halley_step(value, slope, bend)
        halved = not (low <= better <= high and slope < 0.0)
        if halved:
            better = 0.5 * (low + high)
        moved = abs(better - tau)
        if has_converged(moved, before, better):
            return better
        before = 0.0 if halved else moved
        tau = better
    return tau


@noinline
def touches(body, flight, lowest):
    """Return True if a minimum of the gap is zero within rounding: a contact without approach."""
    tau = lowest.tau
    size = flight.y + body.eps + abs(flight.vn * tau) + abs(flight.fn) * tau * tau
    if abs(flight.om * tau) > LARGE_ROTATION:  # the sum as in `flight_rates`
        size = flight.y + body.eps + abs(flight.vn - body.eps * flight.om * flight.s) * tau + body.gn * tau * tau
    return lowest.gap > -4e-16 * size


@noinline
def landing_in_convex_arc(body, flight, first, last):
    """Return the time of landing in a convex arc of the gap; −1 if its minimum is not below the plane."""
    if first.rate >= 0.0:
        return -1.0
    if last.rate <= 0.0:
        return -1.0 if last.gap > 0.0 else downcrossing_between(body, flight, first, last, False)
    # the gap is above its tangents at both ends, and so above the plane if they meet above it
    meet = first.gap + first.rate * ((last.gap - first.gap - last.rate * (last.tau - first.tau)) / (first.rate - last.rate))
    if meet > 0.0:
        return -1.0
    lowest = moment_of(body, flight, downcrossing_between(body, flight, first, last, True))
    if lowest.gap > 0.0 or touches(body, flight, lowest):
        return -1.0
    return downcrossing_between(body, flight, first, lowest, False)


@inline
def landing_time_bound(body, flight, rise):
    """Return an upper bound of the landing time: from then on G's parabola stays below −2ε; `rise` is its initial velocity."""
    reach = 2.0 * body.eps + flight.y
    if body.gn > 0.0:
        root = math.sqrt(rise * rise + 2.0 * body.gn * reach)
        drop = (rise + root) / body.gn if rise > 0.0 else 2.0 * reach / (root - rise) if root > 0.0 else 0.0
        return 1.001 * drop + 1e-300
    if rise > 0.0:
        return 2.0 * reach / rise + 1e-300
    if rise < 0.0:
        return 1.001 * reach / -rise + 1e-300
    return 7.0 / abs(flight.om) if flight.om != 0.0 else 0.0


@noinline
def search_start(body, flight, rise, start, never):
    """Return the time at which the search in a flight of many revolutions starts: near the apex, or when the rim can land.

    `rise` is the velocity of the centre of gravity away from the plane; its parabola minus ε is a lower bound of the gap.
    """
    clear = flight.y + body.eps * (flight.c - 1.0)
    if not clear + start * (rise - 0.5 * body.gn * start) > 0.0:
        return start
    near = NEAR / abs(flight.om)
    if body.gn == 0.0:
        down = never if rise >= 0.0 else clear / -rise
    else:
        root = math.sqrt(max(rise * rise + 2.0 * body.gn * clear, 0.0))
        down = (rise + root) / body.gn
        top = rise / body.gn
        if start <= top + near:
            return max(start, top - near)
    return max(start, (1.0 - 1e-12) * down - near)


@inline
def angle_from_top(angle):
    """Return the angle reduced to within half a revolution of the top."""
    return angle - 2.0 * math.pi * math.floor(angle / (2.0 * math.pi) + 0.5)


@noinline
def first_landing(body, th, om, y, vn, fn, order, limit):
    """Find the first contact of a flight and the maximum height of the centre.

    Parameters
    ----------
    order : int
        Number of leading derivatives of the gap that vanish at the start (0 for a start above the plane).
    limit : float
        Maximum time to search.

    Returns
    -------
    landing : float
        Time of the first contact with approach, or -1.
    apex : float
        Time at which the centre is highest up to the landing, which may be after `limit`, or -1 if that is at an end of the
        flight or after `limit`.
    seen : float
        Time up to which the flight was searched: `limit`, or less if that takes more than `MOST_BENDS` arcs.
    """
    s, c = sine_and_cosine(th)
    flight = Flight(s, c, om, y, vn, fn)
    rise = vn - body.eps * flight.s * om
    # the arcs depend on this bound and not on the time limit, so that a motion has the same bits for any duration
    never = landing_time_bound(body, flight, rise)
    turned = abs(om)
    high = body.eps * om * om
    # within this angle of the top the gap is convex
    half = arccosine(body.gn / high) if high > body.gn else 0.0
    angle = angle_from_top(th if om > 0.0 else -th)
    if order >= 2:
        # the rim leaves the plane because the gap becomes convex; rounding may hide this
        if half == 0.0:
            return (-1.0 if body.gn == 0.0 else 0.0), -1.0, limit
        if abs(angle) >= half:
            angle = -half
    apex = -1.0
    highest = y
    begin = Moment(0.0, y, vn, fn, -high * om * flight.s)
    passed = 0.0  # angle since the start
    for _ in range(MOST_BENDS):
        last = limit if begin.tau < limit else never
        if turned * (min(never, last) - begin.tau) > MANY:
            start = search_start(body, flight, rise, begin.tau, never)
            if start > begin.tau:
                begin = moment_of(body, flight, start)
                passed = turned * start
                angle = angle_from_top((th if om > 0.0 else -th) + passed)
        if not begin.tau < min(never, last) or (begin.tau >= limit and not 0.0 <= apex < limit):
            return -1.0, apex, limit
        bends_up = -half <= angle < half
        if bends_up:
            passed += half - angle
            angle = half
        else:
            passed += (2.0 * math.pi if angle >= half else 0.0) - half - angle
            angle = -half
        end = moment_of(body, flight, min(passed / turned, never) if half > 0.0 else never)
        landing = -1.0
        if bends_up:
            landing = landing_in_convex_arc(body, flight, begin, end)
        else:
            top = begin
            if begin.rate > 0.0 and end.rate < 0.0:
                top = moment_of(body, flight, downcrossing_between(body, flight, begin, end, True))
            if end.gap <= 0.0:
                landing = downcrossing_between(body, flight, top, end, False)
            if top.tau > begin.tau and top.gap > highest:
                highest = top.gap
                apex = top.tau
        if landing >= 0.0:
            return landing, apex, limit
        begin = end
    return -1.0, apex, min(begin.tau, limit)
