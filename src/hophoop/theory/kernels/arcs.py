"""Arcs of pure rolling: how far the hoop gets, by θ̇²(θ), which `physics.closed_forms` has."""

from __future__ import annotations

import math

from hophoop.kernel.model import rolling_u
from hophoop.kernel.steps import has_equilibria, rolling_stable_equilibrium, rolling_unstable_equilibrium

TURN = 2.0 * math.pi


# --- hills and turning points ----------------------------------------------------------------------


def first_maximum(body):
    """Angle of the potential's maximum between −π and π, nan if the slope is too steep for one.

    Maxima are one per revolution, each lower than the one uphill by the same amount.
    """
    if not has_equilibria(body):
        return math.nan
    return rolling_unstable_equilibrium(body)


def first_valley(body):
    """Angle of the valley after `first_maximum`."""
    if not has_equilibria(body):
        return math.nan
    return rolling_stable_equilibrium(body, rolling_unstable_equilibrium(body), 1.0)


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
