"""Certified roots: the first ξ at which a Chebyshev series falls through zero.

Intervals are dropped only if the series proves that they contain no root, and are halved otherwise.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.collocation import ORDER, end_values, product, value_slope_bend
from hophoop.kernel.numerics.tables import LEFT_T, RIGHT_T

MOST_INTERVALS = 4096  # maximum per search; a polynomial above rounding needs a few tens
DEPTH = 60  # halvings of a panel before a multiple root is given up
NOT_FOUND = 2.0  # a ξ outside the panel


@apart
def halves(series, left, right):
    """Compute the series on the left and on the right half of its interval."""
    product(RIGHT_T, series, right)
    product(LEFT_T, series, left)


@inline
def _spread(series):
    """Return the sum of absolute coefficients except the first: the maximum deviation of the series from its mean."""
    r0, r1, r2, r3 = 0.0, abs(series[1]), abs(series[2]), abs(series[3])
    for k in range(4, ORDER, 4):
        r0 += abs(series[k])
        r1 += abs(series[k + 1])
        r2 += abs(series[k + 2])
        r3 += abs(series[k + 3])
    return (r0 + r1) + (r2 + r3)


@inline
def _bracketed(series, f_low, f_middle, f_high):
    """Return the root of a monotone series with series(−1) > 0 ≥ series(1), by Halley's method in a bracket."""
    low = -1.0
    high = 1.0
    # from the parabola through both ends and the middle
    bend = 0.5 * (f_low + f_high) - f_middle
    fall = 0.5 * (f_low - f_high)
    xi = 2.0 * f_middle / (fall + math.sqrt(max(fall * fall - 4.0 * bend * f_middle, 0.0)))
    if not -1.0 <= xi <= 1.0:
        xi = low + (high - low) * f_low / (f_low - f_high)
    before = 0.0
    for _ in range(100):
        value, slope, bend = value_slope_bend(series, xi)
        if value > 0.0:
            low = xi
        else:
            high = xi
        step = value / slope
        better = xi - step * (1.0 + 0.5 * step * (bend / slope))
        halved = not low <= better <= high
        if halved:
            better = 0.5 * (low + high)
        moved = abs(better - xi)
        cube = before * before * before
        # converged: the step is rounding; or the next step, smaller by moved³ / before³, would be; or the series' own rounding
        # limits the steps
        if (
            moved <= 2e-16
            or (moved <= 1e-4 and moved * moved * moved * moved <= 1e-17 * cube)
            or (moved < 1e-13 and moved >= 0.5 * before)
        ):
            return better
        before = 0.0 if halved else moved
        xi = better
    return xi


@apart
def first_downcrossing(series, floor, stack):
    """Return the first ξ in [−1, 1] where the series falls through zero, or `NOT_FOUND`.

    Upcrossings are ignored, and so are downcrossings after which the series rises again before it reaches −`floor`. `stack` is
    scratch of shape (DEPTH + 3, ORDER + 2).
    """
    return first_downcrossing_after(series, -2.0, floor, stack)


@apart
def first_downcrossing_after(series, begin, floor, stack):
    """Return the first downcrossing beyond ξ = `begin`; see `first_downcrossing`.

    Intervals are searched from left to right. Rounding may hide a root at the common end of two intervals from both: the series
    is above zero at the end of the left one and below at the start of the right one. So the search remembers whether the series
    has been above zero.
    """
    spread = _spread(series)
    if abs(series[0]) > spread or spread == 0.0 or not spread < math.inf:
        return NOT_FOUND  # also for nan, which halving would never resolve
    for k in range(ORDER):
        stack[0, k] = series[k]
    stack[0, ORDER] = -1.0
    stack[0, ORDER + 1] = 1.0
    top = 0
    above = False  # the series is above zero left of the interval
    fallen = NOT_FOUND  # ξ of the last downcrossing, until the series rises again
    for looked in range(MOST_INTERVALS):
        if top < 0:
            break
        row = stack[top]
        low = row[ORDER]
        high = row[ORDER + 1]
        one_sign = False
        if top > 0 or looked > 0:  # for the whole series it is known already
            spread = _spread(row)
            one_sign = abs(row[0]) > spread or spread == 0.0
            if one_sign and row[0] > 0.0:
                above = True
                fallen = NOT_FOUND
                top -= 1
                continue
            if one_sign and not above and fallen == NOT_FOUND:
                top -= 1
                continue
        f_low, f_middle, f_high = end_values(row)
        first = 0.0
        slope = 0.0
        if not one_sign:
            # the series of the derivative, from the top coefficient down, odd and even coefficients in parallel
            even = 0.0
            odd = 0.0
            even_slope = 0.0
            odd_slope = 0.0
            for k in range(ORDER - 1, 1, -2):
                even += 2.0 * k * row[k]
                odd += 2.0 * (k - 1) * row[k - 1]
                even_slope += abs(even)
                odd_slope += abs(odd)
            first = 0.5 * even + row[1]
            slope = even_slope + odd_slope
        if one_sign or abs(first) > slope or high - low < 1e-15 or top >= DEPTH:
            if f_high > 0.0:
                above = True
                fallen = NOT_FOUND
            else:
                if f_low > 0.0:
                    fallen = low + 0.5 * (1.0 + _bracketed(row, f_low, f_middle, f_high)) * (high - low)
                elif above:
                    fallen = low
                above = False
                if min(f_low, f_high) <= -floor and fallen != NOT_FOUND:
                    if fallen > begin + 1e-14:
                        return fallen
                    fallen = NOT_FOUND
            top -= 1
            continue
        middle = 0.5 * (low + high)
        halves(row, stack[top + 2], stack[top + 1])
        for k in range(ORDER):
            left = stack[top + 2, k]
            stack[top, k] = stack[top + 1, k]
            stack[top + 1, k] = left
        stack[top, ORDER] = middle
        stack[top, ORDER + 1] = high
        stack[top + 1, ORDER] = low
        stack[top + 1, ORDER + 1] = middle
        top += 1
    return NOT_FOUND
