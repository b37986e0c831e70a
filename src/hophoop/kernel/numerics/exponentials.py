"""Exponentials, logarithms, powers and hyperbolic functions from + − × ÷ and integer operations: the same bits everywhere.

The exponent is split into k ln 2/64 and a remainder r, and exp r = 1 + r + r²/2 + … is multiplied by a power of 2 from a table
(Tang 1989). The table's values have 26 bits and a remainder, so that the largest product is exact (Dekker). The other terms are
below 2^−15 of the result, so the errors of `exponential` are at most 0.5003 units in the last place, also for subnormal
results.

A logarithm is e ln 2 − log c + log(1 + r), where c is near 1/m and has 10 bits, so that r = m c − 1 is exact as a double-double
(Tang 1990, with a table of 1/m). It has about 65 bits before it is rounded; a power uses those of y log x.

Hyperbolic functions come from double-double exponentials and logarithms; errors stay below 0.55 units in the last place.

References: P. T. P. Tang, Table-driven implementation of the exponential function (1989) and of the logarithm function
(1990) in IEEE floating-point arithmetic. J.-M. Muller, Elementary functions (3rd edition, 2016), chapter 6.
"""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.arcs import root_of
from hophoop.kernel.numerics.arithmetic import (
    SPLITTER,
    add,
    divide,
    multiply,
    octave,
    plus,
    power_of_two,
    quick_sum,
    scaled,
    two_product,
    two_sum,
    word_of,
)
from hophoop.kernel.numerics.circular import INTEGER, INTEGER_WORD
from hophoop.kernel.numerics.tables import (
    LN2_HIGH,
    LN2_LOW,
    LOG2_E_HIGH,
    LOG2_E_LOW,
    LOGARITHMS,
    OCTAVE_1,
    OCTAVE_2,
    OCTAVE_INVERSE,
    POWERS,
    SINH_SERIES,
    TANH_SERIES,
)

LEAST, MOST = -708.0, 709.0  # the result is normal between them
LARGEST_EXPONENT = 709.782712893384  # of a double
SMALLEST_EXPONENT = -745.1332191019412  # from here down exp x rounds to 0
E2, E3, E4, E5, E6 = 0.5, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0
L3, L4, L5, L6, L7, L8, L9, L10 = (-1.0 / 3.0, -0.25, -0.2, -1.0 / 6.0, -1.0 / 7.0, -0.125, -1.0 / 9.0, -0.1)
L3, L5, L7, L9 = -L3, -L5, -L7, -L9
FIRST = 90  # row of LOGARITHMS for m = 90/128
ROOT_TWO = 1.4142135623730951
COARSE = 3145728.0  # 1.5 · 2^21: adding and subtracting it rounds to a multiple of 2^−31
SMALL_1P = 1e-9  # up to here log(1 + u) = u − u²/2 in double precision
LARGE_POWER = 1.8446744073709552e19  # 2^64


@inline
def growth_at(x, k, t1, t2):
    """Return exp(x − k ln 2/64) (t1 + t2) as a double-double."""
    a = x - k * OCTAVE_1
    b = k * OCTAVE_2
    r = a - b
    part = SPLITTER * r
    r1 = part - (part - r)
    r2 = (r - r1) + ((a - r) - b)
    z = r * r
    curve = z * ((E2 + r * E3) + z * ((E4 + r * E5) + z * E6))
    product = t1 * r1
    total = t1 + product
    error = product - (total - t1)
    return total, error + (t2 + ((t1 * r2 + t2 * r) + (t1 + t2) * curve))


@inline
def growth(x):
    """Return (m, high, rest) with exp x = 2^m (high + rest), for abs(x) < 800."""
    count = x * OCTAVE_INVERSE + INTEGER
    whole = word_of(count) - INTEGER_WORD
    j = whole & 63
    high, rest = growth_at(x, count - INTEGER, float(POWERS[j, 0]), float(POWERS[j, 1]))
    return whole >> 6, high, rest


@noinline
def rounded(m, high, rest):
    """Return 2^m (high + rest), 1 ≤ high + rest < 2, rounded once, also if it is subnormal or overflows."""
    if m > 1022:
        return (high + rest) * power_of_two(1022) * power_of_two(min(m - 1022, 1000))
    if m >= -1022:
        return (high + rest) * power_of_two(m)
    if m < -1076:
        return 0.0
    # a number whose last bit is the last bit of the result
    large = power_of_two(-1022 - m)
    total = large + high
    error = high - (total - large)
    return scaled((total + (error + rest)) - large, m)


@noinline
def _exponential_rare(x):
    """Return exp x of nan, or where the result is subnormal, 0 or infinite."""
    if x != x:
        return x
    if x > LARGEST_EXPONENT:
        return math.inf
    if x < SMALLEST_EXPONENT:
        return 0.0
    m, high, rest = growth(x)
    return rounded(m, high, rest)


@noinline
def exponential(x):
    """Return exp x."""
    if not LEAST < x < MOST:
        return _exponential_rare(x)
    m, high, rest = growth(x)
    return (high + rest) * power_of_two(m)


@inline
def logarithm_at(power, m, inverse, high, low):
    """Return log(2^power m) as a double-double; high + low is −log(inverse)."""
    # r = m c − 1
    m_high = (m + COARSE) - COARSE
    r, r_low = two_sum(m_high * inverse - 1.0, (m - m_high) * inverse)
    square, square_low = two_product(r, r)
    series = ((L3 + r * L4) + square * (L5 + r * L6)) + square * square * ((L7 + r * L8) + square * (L9 + r * L10))
    total, error = two_sum(power * LN2_HIGH + high, r)
    total, more = two_sum(total, -0.5 * square)
    rest = (power * LN2_LOW + low) + ((r_low - (r * r_low + 0.5 * square_low)) + r * square * series)
    return quick_sum(total, (error + more) + rest)


@noinline
def logarithm_parts(x):
    """Return log x as a double-double with about 65 bits, for finite x > 0."""
    e, m = octave(x)
    if m > ROOT_TWO:
        m *= 0.5
        e += 1
    j = int(128.0 * m + 0.5) - FIRST
    return logarithm_at(1.0 * e, m, float(LOGARITHMS[j, 0]), float(LOGARITHMS[j, 1]), float(LOGARITHMS[j, 2]))


def logarithm(x):
    """Return the natural logarithm of x."""
    if not 0.0 < x < math.inf:
        return _logarithm_rare(x)
    high, low = logarithm_parts(x)
    return high + low


@inline
def _logarithm_rare(x):
    """Return the logarithm of an argument that is not finite and positive."""
    if x == 0.0:
        return -math.inf
    return x if x > 0.0 else math.nan


def binary_logarithm(x):
    """Return the logarithm of x to the base 2, exact for powers of 2."""
    if not 0.0 < x < math.inf:
        return _logarithm_rare(x)
    high, low = multiply(logarithm_parts(x), (LOG2_E_HIGH, LOG2_E_LOW))
    return high + low


def logarithm_1p(u):
    """Return log(1 + u), with all digits also for small u."""
    if abs(u) < SMALL_1P:
        return u - 0.5 * u * u if u != 0.0 else u
    if not -1.0 < u < math.inf:
        return _logarithm_rare(1.0 + u)
    total, error = two_sum(1.0, u)
    high, low = logarithm_parts(total)
    return high + (low + error / total)


@inline
def _is_integer(y):
    """Return True for an integer."""
    return abs(y) >= 4503599627370496.0 or 1.0 * math.floor(y) == y


@inline
def _is_odd(y):
    """Return True for an odd integer."""
    return abs(y) < 9007199254740992.0 and _is_integer(y) and not _is_integer(0.5 * y)


@inline
def _power_rare(size, y):
    """Return size^y if one of them is 0 or inf, or the result overflows or underflows."""
    if size == 1.0:
        return 1.0
    return math.inf if (size > 1.0) == (y > 0.0) else 0.0


@noinline
def power(x, y):
    """Return x^y, with the special values of C's pow. For y = 0, 1, 2 and 1/2 it is as accurate as × and √."""
    if y == 0.0 or x == 1.0:
        return 1.0
    if x != x or y != y:
        return math.nan
    if y == 1.0:
        return 1.0 * x
    if y == 2.0:
        return x * x
    if y == 0.5 and x >= 0.0:
        return math.sqrt(abs(x))
    size = abs(x)
    sign = 1.0
    if math.copysign(1.0, x) < 0.0:
        if -math.inf < x < 0.0 and abs(y) < math.inf and not _is_integer(y):
            return math.nan
        if abs(y) < math.inf and _is_odd(y):
            sign = -1.0
    if not 0.0 < size < math.inf or abs(y) > LARGE_POWER:
        return sign * _power_rare(size, y)
    exponent, low = multiply(logarithm_parts(size), (y, 0.0))
    if abs(exponent) > 750.0:
        return sign * _power_rare(size, y)
    m, high, rest = growth(exponent)
    return sign * rounded(m, high, rest + high * low)


# --- hyperbolic functions

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


@noinline
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
