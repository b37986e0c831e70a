"""Arithmetic with the same bits on every machine: doubles as words, double-doubles, integer powers, sums in a fixed order."""

from __future__ import annotations

import math
import struct
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.kernel.native import inline, interpreted_as

# --- doubles as 64-bit words: exponents and powers of 2 without the C library

_DOUBLE, _WORD = struct.Struct("<d"), struct.Struct("<q")
FRACTION = 0xFFFFFFFFFFFFF  # bits of a double after its leading bit
HIDDEN = 0x10000000000000  # the leading bit
SMALLEST_NORMAL = 2.2250738585072014e-308
TWO_54 = 18014398509481984.0


def _word_of_float(x):
    """Return the bits of a double as an integer."""
    return _WORD.unpack(_DOUBLE.pack(x))[0]


def _float_of_word(word):
    """Return the double with these bits."""
    return _DOUBLE.unpack(_WORD.pack(word))[0]


@interpreted_as(_word_of_float)
@inline
def word_of(x):
    """Return the bits of a double as an integer."""
    return np.int64(np.float64(x).view(np.int64))


@interpreted_as(_float_of_word)
@inline
def double_of(word):
    """Return the double with these bits."""
    return float(np.int64(word).view(np.float64))


def _power_of_two_by_floats(exponent):
    """Return 2^exponent."""
    return math.ldexp(1.0, exponent)


@interpreted_as(_power_of_two_by_floats)
@inline
def power_of_two(exponent):
    """Return 2^exponent, from −1022 to 1023."""
    return double_of((exponent + 1023) << 52)


def _scaled_by_floats(x, exponent):
    """Return x 2^exponent."""
    return math.ldexp(x, exponent)


@interpreted_as(_scaled_by_floats)
@inline
def scaled(x, exponent):
    """Return x 2^exponent for exponents from −2044 to 2046, if that is exact."""
    first = exponent >> 1
    return x * power_of_two(first) * power_of_two(exponent - first)


def _octave_by_floats(x):
    """Return (e, m) with x = 2^e m and 1 ≤ m < 2."""
    significand, exponent = math.frexp(x)
    return exponent - 1, 2.0 * significand


@interpreted_as(_octave_by_floats)
@inline
def octave(x):
    """Return (e, m) with x = 2^e m and 1 ≤ m < 2, for finite x > 0."""
    shift = 1023
    if x < SMALLEST_NORMAL:
        x *= TWO_54
        shift = 1077
    word = word_of(x)
    return (word >> 52) - shift, double_of((word & FRACTION) | 0x3FF0000000000000)


# --- double-doubles, about 32 digits, for angles, times and positions that accumulate many small changes
# A number is (high, low) with abs(low) at most half a unit in the last place of high. Products need no fused multiply-add
# (Dekker's splitting), so that every machine gives the same bits.

SPLITTER = 134217729.0  # 2^27 + 1

# π to 49 digits, for π and 2π as double-doubles
_PI = Fraction(3141592653589793238462643383279502884197169399375, 10**48)
PI, TWO_PI = math.pi, 2.0 * math.pi
MANY = 1099511627776.0  # 2^40: a larger quotient has too few fractional bits to be rounded
WHOLE = 4503599627370496.0  # 2^52: from here on every double is an integer, and adding 0.5 would be rounded
PI_LOW = float(_PI - Fraction(PI))
TWO_PI_LOW = 2.0 * PI_LOW


@inline
def two_sum(a, b):
    """Return a + b and its rounding error."""
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


@inline
def quick_sum(a, b):
    """Return a + b and its rounding error, for abs(a) ≥ abs(b)."""
    total = a + b
    return total, b - (total - a)


def two_product(a, b):
    """Return a b and its rounding error."""
    product = a * b
    part = SPLITTER * a
    a_high = part - (part - a)
    a_low = a - a_high
    part = SPLITTER * b
    b_high = part - (part - b)
    b_low = b - b_high
    return product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low


@inline
def plus(high, low, value):
    """Return (high, low) + a double."""
    total, error = two_sum(high, value)
    return quick_sum(total, error + low)


@inline
def add(a, b):
    """Return the sum of two double-doubles."""
    total, error = two_sum(a[0], b[0])
    low, rest = two_sum(a[1], b[1])
    total, error = quick_sum(total, error + low)
    return quick_sum(total, error + rest)


def negative(a):
    """Return −a."""
    return -a[0], -a[1]


def multiply(a, b):
    """Return the product of two double-doubles."""
    product, error = two_product(a[0], b[0])
    return quick_sum(product, error + (a[0] * b[1] + a[1] * b[0]))


def divide(a, b):
    """Return a / b."""
    first = a[0] / b[0]
    rest = add(a, negative(multiply(b, (first, 0.0))))
    second = rest[0] / b[0]
    rest = add(rest, negative(multiply(b, (second, 0.0))))
    return add(quick_sum(first, second), (rest[0] / b[0], 0.0))


def _minus_revolutions(revolutions, angle):
    """Return the angle minus whole revolutions."""
    high, error = two_product(revolutions, TWO_PI)
    rest = add(angle, (-high, -error))
    return add(rest, (-(revolutions * TWO_PI_LOW), 0.0))


@inline
def nearest_whole(number):
    """Return the integer nearest to a double, as a double; a compiled `math.floor` fails beyond 2^63."""
    return 1.0 * math.floor(number + 0.5) if abs(number) < WHOLE else number


def revolutions_and_rest(angle):
    """Return (whole revolutions, rest as a double-double from −π to π) of an angle, taken as exact.

    The number of revolutions is a double and is rounded beyond 2^53, where the rest stays correct. Beyond 2^100 rad the rest is
    rounding, but still an angle from −π to π.
    """
    revolutions = angle / TWO_PI
    direction = 1.0
    if abs(revolutions) >= MANY:
        direction = math.copysign(1.0, angle)  # symmetric to the last bit
        angle *= direction
        revolutions *= direction
    revolutions = nearest_whole(revolutions)
    rest = _minus_revolutions(revolutions, (angle, 0.0))
    if revolutions >= MANY:  # the quotient may be one off
        more = nearest_whole(rest[0] / TWO_PI)
        while abs(more) > 0.0:  # each pass smaller by 2^50
            rest = _minus_revolutions(more, rest)
            revolutions += more
            more = nearest_whole(rest[0] / TWO_PI)
    return direction * revolutions, direction * rest[0], direction * rest[1]


# --- powers and sums


def integer_power(base, exponent):
    """Return base^exponent, from left to right; a negative exponent divides 1 by the product."""
    result = 1.0
    for _ in range(abs(exponent)):
        result *= base
    return result if exponent >= 0 else 1.0 / result


Floats = NDArray[np.float64]


def weighted_sum(weights: Sequence[Any] | Floats, values: Sequence[Any] | Floats) -> Any:
    """Return Σ weights[k] · values[k], from left to right; the entries may be arrays that broadcast."""
    total = weights[0] * values[0]
    for weight, value in zip(weights[1:], values[1:], strict=True):
        total = total + weight * value
    return total


def matrix_product(one: Floats, other: Floats) -> Floats:
    """Return the product of two matrices, each entry summed from left to right."""
    result: Floats = np.zeros((one.shape[0], other.shape[1]))
    for k in range(one.shape[1]):
        result = result + one[:, k, None] * other[None, k, :]
    return result
