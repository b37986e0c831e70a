"""Functions on a panel: 16 Gauss–Legendre nodes, integrals, interpolation and certified roots.

A smooth function on ξ ∈ [−1, 1] is known by its values at the nodes. `antiderivative` gives its
integral from −1 to every node, `WEIGHTS` the integral over the panel (exact to degree 31), `coefficients`
its Chebyshev series, and `first_fall` the first place where that series changes from positive to
negative: intervals are thrown away only when the series proves them free of roots, and halved otherwise.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.polynomial import chebyshev, legendre

from hophoop._jit import jit

ORDER = 16
NODES, WEIGHTS = legendre.leggauss(ORDER)


def _antiderivative_matrix() -> np.ndarray:
    values = legendre.legvander(NODES, ORDER)
    integrals = np.empty((ORDER, ORDER))
    integrals[:, 0] = NODES + 1.0
    for k in range(1, ORDER):
        integrals[:, k] = (values[:, k + 1] - values[:, k - 1]) / (2 * k + 1)
    norms = (2 * np.arange(ORDER) + 1) / 2
    return (integrals * norms) @ (values[:, :ORDER] * WEIGHTS[:, None]).T


def _halving_matrices() -> tuple[np.ndarray, np.ndarray]:
    points = chebyshev.chebpts1(ORDER)
    to_series = np.linalg.inv(chebyshev.chebvander(points, ORDER - 1))
    left = to_series @ chebyshev.chebvander((points - 1) / 2, ORDER - 1)
    right = to_series @ chebyshev.chebvander((points + 1) / 2, ORDER - 1)
    return left, right


# Transposed and contiguous, so that products run as sums of columns, which vectorise without reassociation.
ANTIDERIVATIVE_T = np.ascontiguousarray(_antiderivative_matrix().T)
# The integral from every node to the end of the panel.
REMAINDER_T = np.ascontiguousarray(ANTIDERIVATIVE_T[::-1, ::-1])
SERIES_T = np.ascontiguousarray(np.linalg.inv(chebyshev.chebvander(NODES, ORDER - 1)).T)
TAIL = np.ascontiguousarray(SERIES_T.T[ORDER - 3 :])
LEFT_T, RIGHT_T = (np.ascontiguousarray(matrix.T) for matrix in _halving_matrices())

DEPTH = 60  # halvings of a panel before a multiple root is given up
NOT_FOUND = 2.0  # a ξ outside the panel


@jit
def product(matrix_t, values, out):
    """out = matrix · values, with the matrix given transposed."""
    for i in range(ORDER):
        out[i] = 0.0
    for j in range(ORDER):
        factor = values[j]
        for i in range(ORDER):
            out[i] += matrix_t[j, i] * factor


@jit
def antiderivative(values, out):
    """Integrals of the function from −1 to every node; returns the one over the whole panel."""
    product(ANTIDERIVATIVE_T, values, out)
    total = 0.0
    for i in range(ORDER):
        total += WEIGHTS[i] * values[i]
    return total


@jit
def coefficients(values, out):
    """Chebyshev coefficients of the function with these values at the nodes."""
    product(SERIES_T, values, out)


@jit
def tail(values, scale):
    """Size of the last three Chebyshev coefficients beside `scale` or the largest value; inf for nan."""
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


@jit
def series_value(series, xi):
    """Clenshaw's sum of the Chebyshev series at ξ."""
    b1 = 0.0
    b2 = 0.0
    for k in range(ORDER - 1, 0, -1):
        b1, b2 = 2.0 * xi * b1 - b2 + series[k], b1
    return xi * b1 - b2 + series[0]


@jit
def lagrange(xi, out):
    """Weights that interpolate node values at ξ."""
    before = 1.0
    current = xi
    for j in range(ORDER):
        out[j] = SERIES_T[j, 0] + xi * SERIES_T[j, 1]
    for k in range(2, ORDER):
        before, current = current, 2.0 * xi * current - before
        for j in range(ORDER):
            out[j] += current * SERIES_T[j, k]


@jit
def dot(a, b):
    """Sum of products in a fixed order."""
    total = 0.0
    for i in range(ORDER):
        total += a[i] * b[i]
    return total


@jit
def _bracketed(series, low, high):
    """Root of a monotone series with series(low) > 0 ≥ series(high): secant steps kept inside the bracket."""
    f_low = series_value(series, low)
    f_high = series_value(series, high)
    side = 0
    for _ in range(200):
        if f_high == 0.0:
            return high
        middle = (low * f_high - high * f_low) / (f_high - f_low)
        if not low < middle < high:
            middle = 0.5 * (low + high)
            if not low < middle < high:
                return high
        f_middle = series_value(series, middle)
        if f_middle > 0.0:
            if high - middle < 1e-16:
                return middle
            low, f_low = middle, f_middle
            if side == 1:
                f_high *= 0.5  # Illinois
            side = 1
        else:
            if f_middle == 0.0 or middle - low < 1e-16:
                return middle
            high, f_high = middle, f_middle
            if side == -1:
                f_low *= 0.5
            side = -1
    return high


@jit
def first_fall(series, floor, stack):
    """First ξ in [−1, 1] where the series falls through zero, or `NOT_FOUND`.

    Roots where it rises, and falls that stay above −`floor`, are passed over. `stack` is scratch of
    shape (DEPTH + 2, ORDER + 2).
    """
    return first_fall_after(series, -2.0, floor, stack)


@jit
def first_fall_after(series, begin, floor, stack):
    """`first_fall`, of those beyond ξ = `begin`."""
    total = 0.0
    for k in range(1, ORDER):
        total += abs(series[k])
    if abs(series[0]) > total:
        return NOT_FOUND
    for k in range(ORDER):
        stack[0, k] = series[k]
    stack[0, ORDER] = -1.0
    stack[0, ORDER + 1] = 1.0
    top = 0
    while top >= 0:
        row = stack[top]
        low = row[ORDER]
        high = row[ORDER + 1]
        total = 0.0
        for k in range(1, ORDER):
            total += abs(row[k])
        if abs(row[0]) > total:
            top -= 1
            continue
        # derivative series, from the top coefficient down
        d2 = 0.0
        d1 = 0.0
        slope = 0.0
        for k in range(ORDER - 1, 0, -1):
            d0 = d2 + 2.0 * k * row[k]
            if k > 1:
                slope += abs(d0)
            else:
                first = 0.5 * d0
            d2, d1 = d1, d0
        f_low = series_value(row, -1.0)
        f_high = series_value(row, 1.0)
        width = high - low
        if abs(first) > slope or width < 1e-15 or top >= DEPTH:
            if f_low > 0.0 and f_high <= 0.0 and f_high <= -floor:
                root = low + 0.5 * (1.0 + _bracketed(row, -1.0, 1.0)) * width
                if root > begin + 1e-14:
                    return root
            top -= 1
            continue
        middle = 0.5 * (low + high)
        product(RIGHT_T, row, stack[top + 1])
        product(LEFT_T, row, stack[top + 2])
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


WIDEST = 0.9  # rad
LEVELS = 96  # widths WIDEST · 2^(−k/2)
WIDTHS = WIDEST * 0.5 ** (np.arange(LEVELS) / 2)
_offsets = WIDTHS[:, None] * (1.0 + NODES[None, :]) / 2
SINES = np.sin(_offsets)
VERSINES = 2.0 * np.sin(_offsets / 2) ** 2


@jit
def sine_deficit(phi):
    """φ − sin φ without cancellation."""
    if abs(phi) > 0.9:
        return phi - math.sin(phi)
    square = phi * phi
    term = phi * square / 6.0
    total = term
    for k in range(2, 10):
        term *= -square / ((2 * k) * (2 * k + 1))
        total += term
    return total


@jit
def cosine_deficit(phi):
    """cos φ − 1 + φ²/2 without cancellation."""
    if abs(phi) > 0.9:
        return math.cos(phi) - 1.0 + 0.5 * phi * phi
    square = phi * phi
    term = square * square / 24.0
    total = term
    for k in range(3, 11):
        term *= -square / ((2 * k - 1) * (2 * k))
        total += term
    return total
