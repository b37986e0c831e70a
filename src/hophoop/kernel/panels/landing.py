"""The end of a flight: the first place where the gap closes, from one inflection of the gap to the next.

The second derivative of the gap is −g_n + ε θ̇² cos θ, so that it is known where the gap bends up and where down: up while the
load is within arccos(g_n/(ε θ̇²)) of the top. Between two such places a fall through zero, or a top, is the only one of its
kind, and the values at both ends tell whether it is there.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.arcs import arccosine
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.double_double import turns_and_rest
from hophoop.kernel.physics.flight import MANY_TURNS, flight_rates

MOST_BENDS = 20_000  # looked at in one flight: some 10,000 turns close to the plane
MANY = 3_000.0  # rad: a longer flight is not looked at where the rim is too high to land whatever its angle
MOST_STEPS = 200  # towards a root: halvings of a bracket, where the steps leave it
MANY_RADIANS = 1e15  # an angle so large has too few digits for the whole turns to be taken off in doubles
NEAR = 9.0  # rad before the top of a flight and before the plane, from where on it is looked at: more than a turn
RESOLVED_TIME = 2e-16  # of a time, to which a root is found


class Flight(NamedTuple):
    """The begin of a flight."""

    s: float
    c: float
    om: float
    y: float
    vn: float
    fn: float  # exactly 0 after a lift-off from slip


class Moment(NamedTuple):
    """The gap and its derivatives at a time of a flight."""

    tau: float
    gap: float
    rate: float
    bend: float
    jerk: float


@inline
def moment_of(body, flight, tau):
    """The flight at the time tau."""
    gap, rate, bend, jerk = flight_rates(body, flight.s, flight.c, flight.om, flight.y, flight.vn, flight.fn, tau)
    return Moment(tau, gap, rate, bend, jerk)


@inline
def parabola_fall(value, rate, bend):
    """Where value + rate t + bend t²/2 falls through zero at t > 0; nan where it does not."""
    square = rate * rate - 2.0 * bend * value
    if square < 0.0:
        return math.nan
    if rate < 0.0:
        return 2.0 * value / (math.sqrt(square) - rate)
    return (rate + math.sqrt(square)) / -bend if bend < 0.0 else math.nan


@inline
def halley_step(value, slope, bend):
    """How far back a step of third order goes towards the zero of a function."""
    if slope == 0.0:
        return math.inf
    step = value / slope
    return step * (1.0 + 0.5 * step * (bend / slope))


@inline
def is_found(moved, before, tau):
    """Whether steps of third order have come to a root: the next one, smaller by moved³/before³, would be rounding."""
    if moved <= RESOLVED_TIME * tau:
        return True
    if before == 0.0:
        return False
    part = moved / before
    if moved <= 1e-4 * tau and moved * (part * part * part) <= 0.05 * RESOLVED_TIME * tau:
        return True
    return moved < 1e-13 * tau and part >= 0.5  # as near as the rounding of the gap lets the steps come


@inline
def target_function(moment, level, way):
    """What is to fall through zero, and its first two derivatives: the gap, or its rate times `way` where `level` is asked."""
    if level:
        return way * moment.rate, way * moment.bend, way * moment.jerk
    return moment.gap, moment.rate, moment.bend


@apart
def fall_between(body, flight, first, last, level):
    """When the gap, or its rate where `level` is asked, is zero, once, between two moments.

    The gap falls; the rate falls to a top, and rises to the lowest place of a stretch that bends up.
    """
    way = -1.0 if level and not first.rate > 0.0 else 1.0
    low = first.tau
    high = last.tau
    value, slope, bend = target_function(first, level, way)
    tau = low + parabola_fall(value, slope, bend)
    if not low < tau < high:
        drop = value - target_function(last, level, way)[0]
        # the times of a flight of 10¹⁶ rad may be the same at both ends
        tau = low + (high - low) * (value / drop) if drop > 0.0 else low
    before = 0.0
    for _ in range(MOST_STEPS):
        value, slope, bend = target_function(moment_of(body, flight, tau), level, way)
        if value > 0.0:
            low = tau
        else:
            high = tau
        better = tau - halley_step(value, slope, bend)
        halved = not (low <= better <= high and slope < 0.0)
        if halved:
            better = 0.5 * (low + high)
        moved = abs(better - tau)
        if is_found(moved, before, better):
            return better
        before = 0.0 if halved else moved
        tau = better
    return tau


@apart
def touches(body, flight, lowest):
    """Whether the gap at its lowest is zero but for rounding: a touch without approach."""
    tau = lowest.tau
    size = flight.y + body.eps + abs(flight.vn * tau) + abs(flight.fn) * tau * tau
    if abs(flight.om * tau) > MANY_TURNS:  # as `flight_rates` adds it up
        size = flight.y + body.eps + abs(flight.vn - body.eps * flight.om * flight.s) * tau + body.gn * tau * tau
    return lowest.gap > -4e-16 * size


@apart
def landing_in_convex_arc(body, flight, first, last):
    """When the rim lands in a stretch that bends up, or −1: only where its lowest place is below the plane."""
    if first.rate >= 0.0:
        return -1.0
    if last.rate <= 0.0:
        return -1.0 if last.gap > 0.0 else fall_between(body, flight, first, last, False)
    # the tangents at both ends are below the gap: where they meet above the plane, so is the gap
    meet = first.gap + first.rate * ((last.gap - first.gap - last.rate * (last.tau - first.tau)) / (first.rate - last.rate))
    if meet > 0.0:
        return -1.0
    lowest = moment_of(body, flight, fall_between(body, flight, first, last, True))
    if lowest.gap > 0.0 or touches(body, flight, lowest):
        return -1.0
    return fall_between(body, flight, first, lowest, False)


@inline
def landing_time_bound(body, flight, rise):
    """When the parabola of the centre of gravity, which rises at first by `rise`, has left the reach of the cosine for good."""
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


@apart
def worth_looking(body, flight, rise, start, never):
    """From where on a flight of many turns is to be looked at: beside its top, and where the rim can reach the plane.

    `rise` is the speed of the centre of gravity away from the plane, whose parabola less ε is below the gap.
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
def from_top(angle):
    """The angle less the whole turns that bring it nearest to the top."""
    if abs(angle) < MANY_RADIANS:
        return angle - 2.0 * math.pi * math.floor(angle / (2.0 * math.pi) + 0.5)
    return turns_and_rest(angle)[1]


@apart
def first_landing(body, th, om, y, vn, fn, order, limit):
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
        Time up to which the flight was looked at: `limit`, or less where that would take more than `MOST_BENDS`.
    """
    s, c = sine_and_cosine(th)
    flight = Flight(s, c, om, y, vn, fn)
    rise = vn - body.eps * flight.s * om
    # Stretches depend on this and not on the limit of time, so that a motion has the same bits however long it is followed.
    never = landing_time_bound(body, flight, rise)
    turned = abs(om)
    high = body.eps * om * om
    # within this angle of the top the gap bends up
    half = arccosine(body.gn / high) if high > body.gn else 0.0
    angle = from_top(th if om > 0.0 else -th)
    if order >= 2:
        # the rim leaves the plane because the gap begins to bend up, of which rounding may leave nothing
        if half == 0.0:
            return (-1.0 if body.gn == 0.0 else 0.0), -1.0, limit
        if abs(angle) >= half:
            angle = -half
    apex = -1.0
    highest = y
    begin = Moment(0.0, y, vn, fn, -high * om * flight.s)
    passed = 0.0  # angle since the start
    for _ in range(MOST_BENDS):
        if turned * (min(never, limit) - begin.tau) > MANY:
            start = worth_looking(body, flight, rise, begin.tau, never)
            if start > begin.tau:
                begin = moment_of(body, flight, start)
                passed = turned * start
                angle = from_top((th if om > 0.0 else -th) + passed)
        if not begin.tau < min(never, limit):
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
                top = moment_of(body, flight, fall_between(body, flight, begin, end, True))
            if end.gap <= 0.0:
                landing = fall_between(body, flight, top, end, False)
            if top.tau > begin.tau and top.gap > highest:
                highest = top.gap
                apex = top.tau
        if landing >= 0.0:
            return landing, apex, limit
        begin = end
    return -1.0, apex, min(begin.tau, limit)
