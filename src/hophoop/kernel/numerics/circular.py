"""Sine, cosine and tangent with the same bits on every machine.

They only use + − × ÷ and integer operations. The angle is split into k π/256 and a remainder r, abs(r) ≤ π/512: after Cody and
Waite, and from `NEAR` on after Payne and Hanek, with the digits of 1/2π that the angle needs. So every double is reduced with
about 100 bits. Then, after Tang,

    sin(k π/256 + r) = S + C r + (S (cos r − 1) + C (sin r − r)).

The table holds S and C as 26 bits and a remainder. r is split in the same way, so that the largest product, C r, and the error
of its sum with S (Dekker) are exact. All other terms are below 2^−15 of S, and the result is never below S/2. So their rounding
is at most 2^−65 of the result, and the error stays below 0.501 units in the last place.

References: W. J. Cody and W. Waite, Software manual for the elementary functions (1980). M. Payne and R. Hanek, Radian
reduction for trigonometric functions (1983). P. T. P. Tang, Table-driven implementation of the exponential function in IEEE
floating-point arithmetic (1989). T. J. Dekker, A floating-point technique for extending the available precision (1971).
J.-M. Muller, Elementary functions (3rd edition, 2016), chapters 6 and 11.
"""

from __future__ import annotations

import math

import numpy as np

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.arithmetic import (
    FRACTION,
    HIDDEN,
    SPLITTER,
    TWO_PI,
    TWO_PI_LOW,
    multiply,
    plus,
    two_product,
    two_sum,
    word_of,
)
from hophoop.kernel.numerics.tables import ANGLE_1, ANGLE_2, ANGLE_3, ANGLE_INVERSE, REVOLUTIONS, SINES

INTEGER = 6755399441055744.0  # 1.5 · 2^52: adding and subtracting it rounds to an integer, which is in the last bits of the sum
INTEGER_WORD = 0x4338000000000000  # its bits
NEAR = 200.0  # rad: below this, k is below 2^14, and k · ANGLE_1 is exact
TINY = 7.450580596923828e-09  # 2^−27: below this, sin x = x and cos x = 1 in double precision
# sin r = r + r³ (S3 + S5 r² + …), cos r = 1 + r² (C2 + C4 r² + …)
S3, S5, S7 = -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0
C2, C4, C6 = -0.5, 1.0 / 24.0, -1.0 / 720.0
DIGIT = 1073741823  # 2^30 − 1
SMALL_60, SMALL_90, SMALL_120, SMALL_150, SMALL_180 = 2.0**-60, 2.0**-90, 2.0**-120, 2.0**-150, 2.0**-180


@inline
def rest_of(x, k):
    """Return (r, low) with x = k π/256 + r + low, for abs(x) < NEAR."""
    a = x - k * ANGLE_1
    b = k * ANGLE_2
    r = a - b
    return r, ((a - r) - b) - k * ANGLE_3


@inline
def reduced(x):
    """Return (k, r, low) with x = k π/256 + r + low, for abs(x) < NEAR; only the last bits of k."""
    count = x * ANGLE_INVERSE + INTEGER
    r, low = rest_of(x, count - INTEGER)
    return word_of(count), r, low


@inline
def revolution_rest(d0, d1, d2, d3, d4, d5):
    """Return (k, r, low) with k π/256 + r + low = 2π (d0 2^−30 + d1 2^−60 + …) for integer digits."""
    k = (d0 + 1048576) >> 21
    high = 1.0 * (((d0 - (k << 21)) << 30) + d1) * SMALL_60
    high, low = two_sum(high, 1.0 * d2 * SMALL_90)
    high, low = plus(high, low, 1.0 * d3 * SMALL_120)
    high, low = plus(high, low, 1.0 * d4 * SMALL_150)
    high, low = plus(high, low, 1.0 * d5 * SMALL_180)
    high, low = multiply((high, low), (TWO_PI, TWO_PI_LOW))
    return k, high, low


@noinline
def reduced_far(x):
    """Return `reduced` of any finite x ≥ 1, with about 100 bits of the remainder."""
    word = word_of(x)
    exponent = (word >> 52) - 1015  # of the last bit, plus 60
    first = exponent // 30
    shift = exponent - 30 * first
    # the significand times 2^shift, in 30-bit digits
    significand = (word & FRACTION) | HIDDEN
    m0 = (significand & DIGIT) << shift
    m1 = ((significand >> 30) << shift) + (m0 >> 30)
    m2 = m1 >> 30
    m0 &= DIGIT
    m1 &= DIGIT
    # the fractional part of x/2π in 30-bit digits; the integer part is whole revolutions
    d0 = d1 = d2 = d3 = d4 = d5 = 0
    carry = 0
    for i in range(7, 0, -1):
        place = first + i
        carry += m0 * int(REVOLUTIONS[place - 1]) + m1 * int(REVOLUTIONS[place]) + m2 * int(REVOLUTIONS[place + 1])
        d5, d4, d3, d2, d1, d0 = d4, d3, d2, d1, d0, carry & DIGIT
        carry >>= 30
    return revolution_rest(d0, d1, d2, d3, d4, d5)


@inline
def _curves(r):
    """Return (the leading bits of r, sin r − r, cos r − 1)."""
    part = SPLITTER * r
    z = r * r
    return part - (part - r), r * z * (S3 + z * (S5 + z * S7)), z * (C2 + z * (C4 + z * C6))


@inline
def _sum(s1, s2, c1, c2, r1, r2, r, sine, cosine):
    """Return S + C r + (S (cos r − 1) + C (sin r − r)) as a double-double."""
    product = c1 * r1
    total = s1 + product
    error = product - (total - s1)
    return total, error + (s2 + ((c1 * r2 + c2 * r) + ((c1 + c2) * sine + (s1 + s2) * cosine)))


@inline
def sums(s1, s2, c1, c2, r, low):
    """Return (sine, its low half, cosine, its low half) of a + r + low, where s1 + s2 and c1 + c2 are sin a and cos a."""
    r1, sine, cosine = _curves(r)
    r2 = (r - r1) + low
    s, s_rest = _sum(s1, s2, c1, c2, r1, r2, r, sine, cosine)
    c, c_rest = _sum(c1, c2, s1, s2, -r1, -r2, -r, -sine, cosine)
    return s, s_rest, c, c_rest


@inline
def _sine_at(quarter, j, r, low):
    """Return the sine of quarter π/2 + j π/256 + r + low."""
    if quarter & 1:
        j = 128 - j
        r = -r
        low = -low
    i = 128 - j
    s1, s2, c1, c2 = float(SINES[j, 0]), float(SINES[j, 1]), float(SINES[i, 0]), float(SINES[i, 1])
    r1, sine, cosine = _curves(r)
    total, rest = _sum(s1, s2, c1, c2, r1, (r - r1) + low, r, sine, cosine)
    value = total + rest
    return -value if quarter & 2 else value


@inline
def both_at(k, r, low):
    """Return (sine, its low half, cosine, its low half) of k π/256 + r + low."""
    j = k & 127
    i = 128 - j
    s1, s2, c1, c2 = float(SINES[j, 0]), float(SINES[j, 1]), float(SINES[i, 0]), float(SINES[i, 1])
    s, s_rest, c, c_rest = sums(s1, s2, c1, c2, r, low)
    if k & 128:
        s, s_rest, c, c_rest = c, c_rest, -s, -s_rest
    if k & 256:
        s, s_rest, c, c_rest = -s, -s_rest, -c, -c_rest
    return s, s_rest, c, c_rest


@inline
def quotient_of(s, s_rest, c, c_rest):
    """Return (s + s_rest)/(c + c_rest)."""
    high = c + c_rest
    quotient = (s + s_rest) / high
    product, error = two_product(quotient, high)
    return quotient + (((s - product) - error) + s_rest - quotient * (c_rest - (high - c))) / high


@noinline
def rare(x):
    """Return (sine, its low half, cosine, its low half) if x is tiny, large, infinite or nan."""
    size = abs(x)
    if size <= TINY:
        return x, -0.0, 1.0, 0.0  # x − 0 keeps the sign of x = −0
    if not size < math.inf:
        return math.nan, 0.0, math.nan, 0.0
    k, r, low = reduced_far(size)
    s, s_rest, c, c_rest = both_at(k, r, low)
    if x < 0.0:
        return -s, -s_rest, c, c_rest
    return s, s_rest, c, c_rest


@noinline
def sine_and_cosine(x):
    """Return (sin x, cos x) of an angle [rad]."""
    if not TINY < abs(x) < NEAR:
        s, s_rest, c, c_rest = rare(x)
        return s + s_rest, c + c_rest
    k, r, low = reduced(x)
    s, s_rest, c, c_rest = both_at(k, r, low)
    return s + s_rest, c + c_rest


@noinline
def sine(x):
    """Return sin x of an angle [rad]."""
    if not TINY < abs(x) < NEAR:
        s, s_rest, _, _ = rare(x)
        return s + s_rest
    k, r, low = reduced(x)
    return _sine_at(k >> 7, k & 127, r, low)


@noinline
def cosine(x):
    """Return cos x of an angle [rad]."""
    if not TINY < abs(x) < NEAR:
        _, _, c, c_rest = rare(x)
        return c + c_rest
    k, r, low = reduced(x)
    return _sine_at((k >> 7) + 1, k & 127, r, low)


@noinline
def tangent(x):
    """Return tan x of an angle [rad]."""
    if TINY < abs(x) < NEAR:
        k, r, low = reduced(x)
        s, s_rest, c, c_rest = both_at(k, r, low)
    elif abs(x) <= TINY:
        return x
    else:
        s, s_rest, c, c_rest = rare(x)
    return quotient_of(s, s_rest, c, c_rest)


# --- differences from the leading terms, without cancellation

SMALL = 0.9  # rad: up to here 9 terms of the series are exact to rounding
_SINE_TERMS = np.array([(-1.0) ** k / math.factorial(2 * k + 3) for k in range(9)])
_COSINE_TERMS = np.array([(-1.0) ** k / math.factorial(2 * k + 4) for k in range(9)])


@inline
def versine_of(angle):
    """Return 1 − cos with all digits; as a product, since interpreted code rounds a power differently."""
    half = sine(0.5 * angle)
    return 2.0 * half * half


@inline
def sine_and_versine(angle):
    """Return (sin, 1 − cos) with all digits of both, in one evaluation."""
    s, c = sine_and_cosine(angle)
    return s, s * s / (1.0 + c) if c > 0.0 else 1.0 - c


@inline
def small_series_remainders(phi):
    """Return `series_remainders` up to `SMALL`, by a series that vectorizes over several angles."""
    square = phi * phi
    odd = 0.0
    even = 0.0
    for k in range(8, -1, -1):
        odd = odd * square + _SINE_TERMS[k]
        even = even * square + _COSINE_TERMS[k]
    even *= square * square
    return odd * square * phi, even, 0.5 * square - even


@inline
def series_remainders(phi):
    """Return (φ − sin φ, cos φ − 1 + φ²/2, 1 − cos φ) without cancellation."""
    if abs(phi) > SMALL:
        s, versine = sine_and_versine(phi)
        return phi - s, 0.5 * phi * phi - versine, versine
    return small_series_remainders(phi)


@inline
def sine_cosine(th, low):
    """Return (sin, cos) of a double-double angle, with all digits of both, also near multiples of π/2."""
    s, c = sine_and_cosine(th)
    return s + low * c, c - low * s


@inline
def sine_cosine_change(s, c, angle):
    """Return (sin, cos) of θ + angle minus those of θ, without cancellation."""
    sine, versine = sine_and_versine(angle)
    return sine_cosine_change_by(s, c, sine, versine)


@inline
def sine_cosine_change_by(s, c, sine, versine):
    """Return `sine_cosine_change` for an angle given by its sine and 1 − cosine."""
    return c * sine - s * versine, -s * sine - c * versine
