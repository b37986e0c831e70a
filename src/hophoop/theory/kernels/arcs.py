"""Arcs of pure rolling: how far the hoop gets, and how long it takes.

Everything follows from θ̇²(θ), which `physics.closed_forms` has. Times are quadratures on Gauss
panels that are halved until their Chebyshev series is resolved.
"""

from __future__ import annotations

import math

import numpy as np

from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.numerics.collocation import ORDER, coefficients
from hophoop.kernel.numerics.tables import NODES, WEIGHTS
from hophoop.kernel.physics import rolling_acceleration, rolling_u
from hophoop.kernel.steps import has_equilibria, rolling_stable_equilibrium, rolling_unstable_equilibrium

TURN = 2.0 * math.pi
RESOLVED = 1e-13
NOISE = 1e-6  # last coefficients below this that halving does not lower are rounding
SMALLEST = 1e-300
MOST_PANELS = 1_000_000


def relative_tail(series, scale):
    """The last coefficients of a Chebyshev series relative to the largest one or `scale`; nan where one is."""
    end = 0.0
    for k in range(ORDER):
        size = abs(series[k])
        if not size < np.inf:
            return math.nan
        scale = max(scale, size)
        if k >= ORDER - 3:
            end = max(end, size)
    return end / scale if scale > 0.0 else 0.0


# --- hills and turning points ----------------------------------------------------------------------


def first_maximum(body):
    """Angle of the potential's maximum between −π and π, nan if the slope is too steep for one.

    Maxima are one per revolution, each lower than the one uphill by the same amount.
    """
    if not has_equilibria(body):
        return math.nan
    angle, low = rolling_unstable_equilibrium(body)
    return angle + low


def first_valley(body):
    """Angle of the valley after `first_maximum`."""
    if not has_equilibria(body):
        return math.nan
    angle, low = rolling_stable_equilibrium(body, rolling_unstable_equilibrium(body), 1.0)
    return angle + low


def next_of(angle, start, way):
    """The first of angle + 2πk strictly beyond `start` in the direction `way`."""
    place = angle + TURN * math.floor((start - angle) / TURN)
    for _ in range(4):
        if way * (place - start) > 0.0:
            break
        place += way * TURN
    if way * (place - way * TURN - start) > 0.0:
        place -= way * TURN
    return place


def blocking(body, ref, u_ref, end):
    """The first maximum between `ref` and `end`, or the end, that the hoop does not reach; nan if none.

    The highest maximum on the way is the first one or, uphill, the last one.
    """
    way = 1.0 if end > ref else -1.0
    maximum = first_maximum(body)
    if not math.isnan(maximum):
        place = next_of(maximum, ref, way)
        if way * (end - place) > 0.0:
            if rolling_u(body, ref, u_ref, place - ref) < 0.0:
                return place
            # downhill or on the level the first is the highest; uphill the last, and the search halves the turns between
            low, high = 0.0, math.ceil(way * (end - place) / TURN) - 1.0
            if way * body.gt < 0.0 and rolling_u(body, ref, u_ref, place + way * high * TURN - ref) < 0.0:
                middle = math.floor(0.5 * high)
                while low < middle < high:
                    if rolling_u(body, ref, u_ref, place + way * middle * TURN - ref) < 0.0:
                        high = middle
                    else:
                        low = middle
                    middle = math.floor(0.5 * (low + high))
                return place + way * high * TURN
    if rolling_u(body, ref, u_ref, end - ref) < 0.0:
        return end
    return math.nan


def turning_point(body, ref, u_ref, blocked):
    """The turning point before an angle that the hoop does not reach, by bisection to the last bit."""
    way = 1.0 if blocked > ref else -1.0
    low = ref
    valley = first_valley(body)
    if not math.isnan(valley):
        before = next_of(valley, blocked, -way)
        if way * (before - ref) > 0.0:
            low = before
    high = blocked
    while True:
        middle = 0.5 * (low + high)
        if middle in (low, high):
            return low
        if rolling_u(body, ref, u_ref, middle - ref) >= 0.0:
            low = middle
        else:
            high = middle


# --- times -----------------------------------------------------------------------------------------


def _rate(body, ref, u_ref, way, at):
    """dt over d(offset); from rest the variable is the root of the offset, which is smooth."""
    if u_ref == 0.0:
        return 2.0 * at / math.sqrt(rolling_u(body, ref, 0.0, way * at * at))
    return 1.0 / math.sqrt(rolling_u(body, ref, u_ref, way * at))


def travel_time(body, ref, u_ref, way, distance):
    """Time to roll this far from θ = ref with θ̇² = u_ref (0: from rest); nan where it does not get there."""
    if distance == 0.0:
        return 0.0
    values = np.empty(ORDER)
    series = np.empty(ORDER)
    end = math.sqrt(distance) if u_ref == 0.0 else distance
    total = 0.0
    low = 0.0
    width = 0.25 * end
    before = math.inf
    for _ in range(MOST_PANELS):
        width = min(width, end - low)
        last = width == end - low
        part = 0.0
        for i in range(ORDER):
            values[i] = _rate(body, ref, u_ref, way, low + 0.5 * width * (1.0 + NODES[i]))
            part += WEIGHTS[i] * values[i]
        coefficients(values, series)
        tail = relative_tail(series, 0.0)
        if not (tail <= RESOLVED or 0.25 * before < tail < NOISE):
            before = tail
            width *= 0.5
            if width < SMALLEST or low + width == low:
                return math.nan
            continue
        before = math.inf
        total += 0.5 * width * part
        if last:
            return total
        low += width
        width *= 2.0
    return math.nan


def time_from_top(body, w, angle):
    """Time from θ = 0, passed with θ̇² = w, to an angle; a past angle has a negative one if w > 0."""
    way = 1.0 if angle > 0.0 else -1.0
    if w == 0.0:
        start = rolling_acceleration(body, 0.0, 1.0, 0.0, 0.0)
        if start == 0.0:
            return math.inf
        if start * angle < 0.0:
            return math.nan
    if body.gt == 0.0:
        # each half turn is alike, and only from the top down are offsets exact where the hoop is slow
        distance = abs(angle)
        turns = math.floor(distance / TURN)
        rest = distance - turns * TURN
        half = travel_time(body, 0.0, w, 1.0, math.pi) if distance > math.pi else 0.0
        if rest <= math.pi:
            return 2.0 * half * turns + travel_time(body, 0.0, w, 1.0, rest)
        return 2.0 * half * (turns + 1.0) - travel_time(body, 0.0, w, 1.0, max(TURN - rest, 0.0))
    if w > 0.0:
        # near a turning point ahead the time to it is known better than θ̇ is
        blocked = blocking(body, 0.0, w, angle + way * TURN)
        if not math.isnan(blocked):
            far = turning_point(body, 0.0, w, blocked)
            left = abs(far - angle)
            if left < abs(angle):
                whole = travel_time(body, far, 0.0, -way, abs(far))
                return whole - travel_time(body, far, 0.0, -way, left)
    return travel_time(body, 0.0, w, way, abs(angle))


def rocking_time(body, angle):
    """Period of rocking from rest at an angle; inf in an equilibrium, nan where the hoop rolls away."""
    s, c = sine_and_cosine(angle)
    start = rolling_acceleration(body, s, c, 0.0, 0.0)
    if start == 0.0:
        return math.inf
    valley = first_valley(body)
    if math.isnan(valley):
        return math.nan
    way = 1.0 if start > 0.0 else -1.0
    bottom = next_of(valley, angle, way)
    maximum = next_of(first_maximum(body), bottom, way)
    if not rolling_u(body, angle, 0.0, maximum - angle) < 0.0:
        return math.nan if body.gt != 0.0 else math.inf
    down = travel_time(body, angle, 0.0, way, abs(bottom - angle))
    if body.gt == 0.0:
        return 4.0 * down
    far = turning_point(body, angle, 0.0, maximum)
    return 2.0 * (down + travel_time(body, far, 0.0, -way, abs(far - bottom)))
