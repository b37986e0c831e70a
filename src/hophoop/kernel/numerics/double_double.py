"""Double-double arithmetic, about 32 digits, for angles, times and positions that accumulate many small changes.

A number is (high, low) with abs(low) at most half a unit in the last place of high. Products need no fused multiply-add
(Dekker's splitting), so that every machine gives the same bits.
"""

from __future__ import annotations

import math
from fractions import Fraction

from hophoop.kernel.native import inline

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


def square_root(a):
    """Return √a for a ≥ 0."""
    if a[0] <= 0.0:
        return 0.0, 0.0
    root = math.sqrt(a[0])
    rest = add(a, negative(two_product(root, root)))
    first = quick_sum(root, rest[0] / (2.0 * root))
    rest = add(a, negative(multiply(first, first)))
    return add(first, (rest[0] / (2.0 * root), 0.0))


def _minus_turns(turns, angle):
    """Return the angle minus whole revolutions."""
    high, error = two_product(turns, TWO_PI)
    rest = add(angle, (-high, -error))
    return add(rest, (-(turns * TWO_PI_LOW), 0.0))


@inline
def nearest_whole(number):
    """Return the integer nearest to a double, as a double; a compiled `math.floor` fails beyond 2^63."""
    return 1.0 * math.floor(number + 0.5) if abs(number) < WHOLE else number


def turns_and_rest(angle):
    """Return (whole revolutions, rest as a double-double from −π to π) of an angle, taken as exact.

    The number of revolutions is a double and is rounded beyond 2^53, where the rest stays correct. Beyond 2^100 rad the rest is
    rounding, but still an angle from −π to π.
    """
    turns = angle / TWO_PI
    way = 1.0
    if abs(turns) >= MANY:
        way = math.copysign(1.0, angle)  # symmetric to the last bit
        angle *= way
        turns *= way
    turns = nearest_whole(turns)
    rest = _minus_turns(turns, (angle, 0.0))
    if turns >= MANY:  # the quotient may be one off
        more = nearest_whole(rest[0] / TWO_PI)
        while abs(more) > 0.0:  # each pass smaller by 2^50
            rest = _minus_turns(more, rest)
            turns += more
            more = nearest_whole(rest[0] / TWO_PI)
    return way * turns, way * rest[0], way * rest[1]
