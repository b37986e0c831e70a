"""Hyperbolic functions with the same bits on every machine, from double-double exponentials and logarithms.

Errors stay below 0.55 units in the last place.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import apart, inline
from hophoop.kernel.numerics.arcs import root_of
from hophoop.kernel.numerics.double_double import add, divide, multiply, plus, quick_sum, two_product, two_sum
from hophoop.kernel.numerics.exponentials import growth, logarithm_parts, rounded
from hophoop.kernel.numerics.tables import LN2_HIGH, LN2_LOW, SINH_SERIES, TANH_SERIES
from hophoop.kernel.numerics.words import power_of_two

SMALL_TANGENT = 0.125
SMALL_SINE = 0.25
LARGE_TANGENT = 20.0  # from here on tanh x = 1 in double precision
ALONE = 40.0  # from here on exp(−x) does not change exp x
OVERFLOW = 711.0
FAR = 268435456.0  # 2^28: from here on arcosh x = log 2x in double precision


@inline
def series_of(x, coefficients):
    """Return x + x³ (c0 + c1 x² + …)."""
    z = x * x
    total = float(coefficients[coefficients.shape[0] - 1])
    for k in range(coefficients.shape[0] - 2, -1, -1):
        total = total * z + float(coefficients[k])
    return x + x * z * total


@inline
def tangent_of(high, rest, scale):
    """Return (e − 1)/(e + 1), e = scale (high + rest)."""
    grown, low = quick_sum(high, rest)
    above, above_low = plus(scale * grown, scale * low, -1.0)
    below, below_low = plus(scale * grown, scale * low, 1.0)
    quotient = above / below
    product, error = two_product(quotient, below)
    return quotient + (((above - product) - error) + (above_low - quotient * below_low)) / below


def hyperbolic_tangent(x):
    """Return tanh x."""
    size = abs(x)
    if size < SMALL_TANGENT:
        return series_of(x, TANH_SERIES) if x != 0.0 else x
    if not size < LARGE_TANGENT:
        return x if x != x else math.copysign(1.0, x)
    m, high, rest = growth(2.0 * size)
    return math.copysign(tangent_of(high, rest, power_of_two(m)), x)


@inline
def half_sum_of(high, rest, scale, sign):
    """Return e + sign scale/e, e = high + rest."""
    grown = quick_sum(high, rest)
    inverse = divide((sign, 0.0), grown)
    total, rest = add(grown, (inverse[0] * scale, inverse[1] * scale))
    return total + rest


@apart
def _half_sum(size, sign):
    """Return (exp x ± exp −x)/2, 0 ≤ x."""
    if not size < OVERFLOW:
        return size if size != size else math.inf
    m, high, rest = growth(size)
    if size > ALONE:
        return rounded(m - 1, high, rest)
    return half_sum_of(high, rest, power_of_two(-2 * m), sign) * power_of_two(m - 1)


def hyperbolic_sine(x):
    """Return sinh x."""
    if abs(x) < SMALL_SINE:
        return series_of(x, SINH_SERIES) if x != 0.0 else x
    return math.copysign(_half_sum(abs(x), -1.0), x)


def hyperbolic_cosine(x):
    """Return cosh x."""
    return _half_sum(abs(x), 1.0)


@inline
def square_less_one(x):
    """Return x² − 1 as a double-double, x > 1."""
    return multiply(two_sum(x, -1.0), two_sum(x, 1.0))


@inline
def grown_by(x, root, root_low):
    """Return x + root + root_low as a double-double."""
    high, low = add(two_sum(x, -1.0), (root, root_low))
    return plus(high, low, 1.0)


def inverse_hyperbolic_cosine(x):
    """Return arcosh x; nan below 1."""
    if not 1.0 < x < math.inf:
        return 0.0 if x == 1.0 else (x if x > 1.0 else math.nan)
    if x > FAR:
        high, low = logarithm_parts(x)
        total, error = two_sum(high, LN2_HIGH)
        return total + (error + (low + LN2_LOW))
    high, low = square_less_one(x)
    root, root_low = root_of(high, low)
    total, rest = grown_by(x, root, root_low)
    high, low = logarithm_parts(total)
    return high + (low + rest / total)
