"""Certified roots: the first place where a Chebyshev series falls through zero.

Intervals are thrown away only when the series proves them free of roots, and halved otherwise.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.collocation import ORDER, end_values, product, value_slope_bend
from hophoop.kernel.numerics.constants import LEFT_T, RIGHT_T

MOST_INTERVALS = 4096  # looked at in one search; a polynomial that is more than noise needs some tens
DEPTH = 60  # halvings of a panel before a multiple root is given up
NOT_FOUND = 2.0  # a ξ outside the panel


@apart
def halves(series, left, right):
    """The series on the left and on the right half of its interval."""
    product(RIGHT_T, series, right)
    product(LEFT_T, series, left)


@inline
def _spread(series):
    """How far the series can be from its mean, the first coefficient: the sum of the others, four side by side."""
    r0, r1, r2, r3 = 0.0, abs(series[1]), abs(series[2]), abs(series[3])
    for k in range(4, ORDER, 4):
        r0 += abs(series[k])
        r1 += abs(series[k + 1])
        r2 += abs(series[k + 2])
        r3 += abs(series[k + 3])
    return (r0 + r1) + (r2 + r3)


@inline
def _bracketed(series, f_low, f_middle, f_high):
    """Root of a monotone series with series(−1) > 0 ≥ series(1): steps of third order kept inside the bracket."""
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
        # to rounding; or so near that the next step, which is smaller by moved³ / before³, would be less than that;
        # or as near as the rounding of the series lets the steps come
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
    """First ξ in [−1, 1] where the series falls through zero, or `NOT_FOUND`.

    Roots where it rises, and falls after which it rises again before it comes to −`floor`, are passed over. `stack` is
    scratch of shape (DEPTH + 3, ORDER + 2).
    """
    return first_downcrossing_after(series, -2.0, floor, stack)


@apart
def first_downcrossing_after(series, begin, floor, stack):
    """`first_fall`, of those beyond ξ = `begin`.

    Intervals are looked at from left to right. A root at the end that two of them share may be in neither: rounding may
    leave the left one above zero there and the right one not. So what counts is that the series has been above zero.
    """
    spread = _spread(series)
    if abs(series[0]) > spread or spread == 0.0 or not spread < math.inf:
        return NOT_FOUND  # also of nan, which no halving would get rid of
    for k in range(ORDER):
        stack[0, k] = series[k]
    stack[0, ORDER] = -1.0
    stack[0, ORDER + 1] = 1.0
    top = 0
    above = False  # the series is above zero left of the interval
    fallen = NOT_FOUND  # where it has come to zero, as long as it has not risen again
    for looked in range(MOST_INTERVALS):
        if top < 0:
            break
        row = stack[top]
        low = row[ORDER]
        high = row[ORDER + 1]
        one_sign = False
        if top > 0 or looked > 0:  # of the whole series it is known
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
            # the series of the derivative, from the top coefficient down, the odd and the even ones side by side
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
