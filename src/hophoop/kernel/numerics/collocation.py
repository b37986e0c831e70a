"""Functions on a panel: 16 Gauss–Legendre nodes, integrals, series, interpolation and roots.

A smooth function on ξ ∈ [−1, 1] is represented by its values at the nodes. `antiderivative` gives its integral from −1 to every
node, `WEIGHTS` the integral over the panel (exact to degree 31), `coefficients` its Chebyshev series.
"""

from __future__ import annotations

import math

import numpy as np

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.exponentials import exponential
from hophoop.kernel.numerics.tables import ANTIDERIVATIVE_T, LEFT_T, NODES, RIGHT_T, SERIES, WEIGHTS

ORDER = len(NODES)
PARTS = 0.5 * (1.0 + NODES)  # fraction of the panel before each node

# ANTIDERIVATIVE_T is transposed, so that products run as sums of columns, which vectorise without reassociation. REMAINDER_T
# integrates from every node to the end of the panel.
REMAINDER_T = np.ascontiguousarray(ANTIDERIVATIVE_T[::-1, ::-1])
SERIES_T = np.ascontiguousarray(SERIES.T)
TAIL = np.ascontiguousarray(SERIES[ORDER - 3 :])
EXP_3, EXP_4, EXP_5, EXP_6, EXP_7, EXP_8, EXP_9, EXP_10 = (1.0 / math.factorial(k) for k in range(3, 11))
EXP_11, EXP_12, EXP_13, EXP_14, EXP_15, EXP_16, EXP_17, EXP_18 = (1.0 / math.factorial(k) for k in range(11, 19))


@inline
def product(matrix_t, values, out):
    """Compute out = matrix · values for a transposed matrix; 8 columns per pass keep the sums in registers.

    Inlined, so that each caller's matrix is known to the compiler.
    """
    for j in range(0, ORDER, 8):
        v0, v1, v2, v3 = values[j], values[j + 1], values[j + 2], values[j + 3]
        v4, v5, v6, v7 = values[j + 4], values[j + 5], values[j + 6], values[j + 7]
        for i in range(ORDER):
            low = (matrix_t[j, i] * v0 + matrix_t[j + 1, i] * v1) + (matrix_t[j + 2, i] * v2 + matrix_t[j + 3, i] * v3)
            high = (matrix_t[j + 4, i] * v4 + matrix_t[j + 5, i] * v5) + (matrix_t[j + 6, i] * v6 + matrix_t[j + 7, i] * v7)
            out[i] = low + high if j == 0 else out[i] + (low + high)


@inline
def dot(a, b):
    """Return the sum of products in a fixed order: 4 partial sums that do not wait for each other."""
    r0 = 0.0
    r1 = 0.0
    r2 = 0.0
    r3 = 0.0
    for i in range(0, ORDER, 4):
        r0 += a[i] * b[i]
        r1 += a[i + 1] * b[i + 1]
        r2 += a[i + 2] * b[i + 2]
        r3 += a[i + 3] * b[i + 3]
    return (r0 + r1) + (r2 + r3)


@inline
def extremes(values):
    """Return the smallest and the largest value, in 4 parallel chains."""
    l0 = h0 = values[0]
    l1 = h1 = values[1]
    l2 = h2 = values[2]
    l3 = h3 = values[3]
    for i in range(4, ORDER, 4):
        l0 = min(l0, values[i])
        l1 = min(l1, values[i + 1])
        l2 = min(l2, values[i + 2])
        l3 = min(l3, values[i + 3])
        h0 = max(h0, values[i])
        h1 = max(h1, values[i + 1])
        h2 = max(h2, values[i + 2])
        h3 = max(h3, values[i + 3])
    return min(min(l0, l1), min(l2, l3)), max(max(h0, h1), max(h2, h3))


@inline
def _small_exponential(x):
    """Return exp x for abs(x) ≤ 1 by a series that vectorizes over the nodes."""
    square = x * x
    even = EXP_18
    odd = EXP_17
    even = even * square + EXP_16
    odd = odd * square + EXP_15
    even = even * square + EXP_14
    odd = odd * square + EXP_13
    even = even * square + EXP_12
    odd = odd * square + EXP_11
    even = even * square + EXP_10
    odd = odd * square + EXP_9
    even = even * square + EXP_8
    odd = odd * square + EXP_7
    even = even * square + EXP_6
    odd = odd * square + EXP_5
    even = even * square + EXP_4
    odd = odd * square + EXP_3
    # leading terms last, so that only their rounding remains
    return 1.0 + (x + (0.5 * square + square * (even * square + odd * x)))


@inline
def _largest(values):
    """Return the largest absolute value at the nodes."""
    largest = 0.0
    for i in range(ORDER):
        largest = max(largest, abs(values[i]))
    return largest


@inline
def exponentials(values, out):
    """Compute out = exp(values)."""
    if not _largest(values) <= 1.0:
        for i in range(ORDER):
            out[i] = exponential(values[i])
        return
    for i in range(ORDER):
        out[i] = _small_exponential(values[i])


@inline
def divided_by_exponentials(values, out, row, quotient):
    """Compute out = exp(values) and quotient = row/out, in one loop that vectorizes over the nodes."""
    if not _largest(values) <= 1.0:
        for i in range(ORDER):
            out[i] = exponential(values[i])
            quotient[i] = row[i] / out[i]
        return
    for i in range(ORDER):
        grown = _small_exponential(values[i])
        out[i] = grown
        quotient[i] = row[i] / grown


@inline
def total(values):
    """Return the integral of the function over the panel, by Gauss quadrature."""
    return dot(WEIGHTS, values)


@noinline
def integrals(values, out):
    """Compute the integrals of the function from −1 to every node."""
    product(ANTIDERIVATIVE_T, values, out)


@noinline
def remainders(values, out):
    """Compute the integrals of the function from every node to 1."""
    product(REMAINDER_T, values, out)


@inline
def antiderivative(values, out):
    """Compute the integrals of the function from −1 to every node; return the integral over the panel."""
    integrals(values, out)
    return total(values)


@noinline
def coefficients(values, out):
    """Compute the Chebyshev coefficients of the function with these values at the nodes."""
    product(SERIES_T, values, out)


@inline
def truncation_error(values, scale):
    """Return the size of the last 3 Chebyshev coefficients relative to `scale` or the largest value; inf for nan."""
    a = 0.0
    b = 0.0
    c = 0.0
    for i in range(ORDER):
        value = values[i]
        scale = max(scale, abs(value))
        a += TAIL[0, i] * value
        b += TAIL[1, i] * value
        c += TAIL[2, i] * value
    ratio = max(abs(a), abs(b), abs(c)) / scale
    return ratio if ratio < np.inf else np.inf


def series_value(series, xi):
    """Return the Chebyshev series at ξ, by Clenshaw's recurrence."""
    b1 = 0.0
    b2 = 0.0
    double = 2.0 * xi
    for k in range(ORDER - 1, 0, -1):
        b1, b2 = double * b1 + (series[k] - b2), b1
    return xi * b1 - b2 + series[0]


@inline
def end_values(series):
    """Return the series at ξ = −1, 0 and 1: sums of every fourth coefficient, in parallel."""
    r0, r1, r2, r3 = series[0], series[1], series[2], series[3]
    for k in range(4, ORDER, 4):
        r0 += series[k]
        r1 += series[k + 1]
        r2 += series[k + 2]
        r3 += series[k + 3]
    even = r0 + r2
    odd = r1 + r3
    return even - odd, r0 - r2, even + odd


@inline
def left_value(series):
    """Return the series at ξ = −1."""
    return end_values(series)[0]


@inline
def lagrange(xi, out):
    """Compute the weights that interpolate node values at ξ: the rows of `SERIES`, each times its T_k(ξ).

    7 rows per pass, so that it vectorizes over the nodes.
    """
    double = 2.0 * xi
    t0 = 1.0
    t1 = xi
    for i in range(ORDER):
        out[i] = SERIES[0, i] + xi * SERIES[1, i]
    for k in range(2, ORDER, 7):
        t2 = double * t1 - t0
        t3 = double * t2 - t1
        t4 = double * t3 - t2
        t5 = double * t4 - t3
        t6 = double * t5 - t4
        t7 = double * t6 - t5
        t8 = double * t7 - t6
        for i in range(ORDER):
            low = out[i] + t2 * SERIES[k, i] + t3 * SERIES[k + 1, i] + t4 * SERIES[k + 2, i]
            out[i] = low + t5 * SERIES[k + 3, i] + t6 * SERIES[k + 4, i] + t7 * SERIES[k + 5, i] + t8 * SERIES[k + 6, i]
        t0, t1 = t7, t8


@inline
def value_slope_bend(series, xi):
    """Return the Chebyshev series and its first two derivatives at ξ, by one pass of Clenshaw's recurrence.

    The even part is a series in T_k(y), the odd part ξ times a series in V_k(y), with y = 2 ξ² − 1. Computed in parallel they
    take half the time. V_k has the recurrence of T_k, starting from 1 and 2 y − 1.
    """
    e1 = e2 = o1 = o2 = 0.0
    de1 = de2 = do1 = do2 = 0.0
    dde1 = dde2 = ddo1 = ddo2 = 0.0
    double = 4.0 * xi * xi - 2.0
    for k in range(ORDER - 2, 0, -2):
        # summed so that a step only waits for one product and one sum of the previous step
        dde1, dde2 = double * dde1 + (4.0 * de1 - dde2), dde1
        ddo1, ddo2 = double * ddo1 + (4.0 * do1 - ddo2), ddo1
        de1, de2 = double * de1 + (2.0 * e1 - de2), de1
        do1, do2 = double * do1 + (2.0 * o1 - do2), do1
        e1, e2 = double * e1 + (series[k] - e2), e1
        o1, o2 = double * o1 + (series[k + 1] - o2), o1
    even = 0.5 * double * e1 - e2 + series[0]
    odd = double * o1 - o2 + (series[1] - o1)
    even_slope = 0.5 * double * de1 - de2 + e1
    odd_slope = double * do1 - do2 + (2.0 * o1 - do1)
    even_bend = 0.5 * double * dde1 - dde2 + 2.0 * de1
    odd_bend = double * ddo1 - ddo2 + (4.0 * do1 - ddo1)
    slope = 4.0 * xi * (even_slope + xi * odd_slope) + odd
    bend = 4.0 * (even_slope + 3.0 * xi * odd_slope) + 16.0 * xi * xi * (even_bend + xi * odd_bend)
    return even + xi * odd, slope, bend


# --- certified roots: the first ξ at which a Chebyshev series falls through zero
# Intervals are dropped only if the series proves that they contain no root, and are halved otherwise.

MOST_INTERVALS = 4096  # maximum per search; a polynomial above rounding needs a few tens
DEPTH = 60  # halvings of a panel before a multiple root is given up
NOT_FOUND = 2.0  # a ξ outside the panel


@noinline
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


@noinline
def first_downcrossing(series, floor, stack):
    """Return the first ξ in [−1, 1] where the series falls through zero, or `NOT_FOUND`.

    Upcrossings are ignored, and so are downcrossings after which the series rises again before it reaches −`floor`. `stack` is
    scratch of shape (DEPTH + 3, ORDER + 2).
    """
    return first_downcrossing_after(series, -2.0, floor, stack)


@noinline
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


# If the minimum at the nodes exceeds this fraction of the range, the margin has no zero on the panel: between the nodes and at
# the ends a resolved function overshoots by less than 10 % of the range.
FAR_FROM_ZERO = 0.25
NEARBY = 0.015  # relative to the range of a margin on a panel: (half the distance of two nodes)² / half the panel's width


@inline
def margin_downcrossing(row, begins, floor, scratch):
    """Find ξ where a margin falls through zero; ξ = −1 if it is below zero at the start.

    Values within ±`floor` count as zero, as they would be without rounding. A margin that starts there counts as below zero if
    the first node outside ±`floor` is below, so that the sign of rounding at the start decides nothing.

    Returns
    -------
    xi : float
    near : bool
        True if the margin may touch zero between the nodes: at a node next to a tangency it is below NEARBY of its range.
    """
    lowest, highest = extremes(row)
    if lowest > FAR_FROM_ZERO * (highest - lowest):
        return NOT_FOUND, False
    near = abs(lowest) < NEARBY * (highest - lowest)
    coefficients(row, scratch.series)
    if not begins:
        start = left_value(scratch.series)
        if start < -floor or (start <= 0.0 and floor == 0.0):
            return -1.0, near
        if start <= floor:
            for i in range(ORDER):
                if row[i] < -floor:
                    return -1.0, near
                if row[i] > floor:
                    break
    return first_downcrossing(scratch.series, floor, scratch.stack), near
