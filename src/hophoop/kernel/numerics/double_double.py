"""Numbers of two doubles, some 32 digits: for angles, times and places that must not lose what is added to them.

A number is (high, low) with abs(low) at most half a unit in the last place of high. The products need no fused
multiply-add (Dekker's splitting), so that every machine gives the same bits.
"""

from __future__ import annotations

import math
from fractions import Fraction

from hophoop.kernel.native import inline

SPLITTER = 134217729.0  # 2^27 + 1

# π to 49 digits, for the two parts of it and of 2π
_PI = Fraction(3141592653589793238462643383279502884197169399375, 10**48)
PI, TWO_PI = math.pi, 2.0 * math.pi
MANY = 1099511627776.0  # 2^40: a quotient so large has too few digits after the point to be rounded
WHOLE = 4503599627370496.0  # 2^52: from here on a double is a whole number, and a half more would be rounded
PI_LOW = float(_PI - Fraction(PI))
TWO_PI_LOW = 2.0 * PI_LOW


@inline
def two_sum(a, b):
    """a + b and its rounding error."""
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


@inline
def quick_sum(a, b):
    """a + b and its rounding error, where abs(a) ≥ abs(b)."""
    total = a + b
    return total, b - (total - a)


def two_product(a, b):
    """a b and its rounding error."""
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
    """(high, low) + a double."""
    total, error = two_sum(high, value)
    return quick_sum(total, error + low)


@inline
def add(a, b):
    """Sum of two such numbers."""
    total, error = two_sum(a[0], b[0])
    low, rest = two_sum(a[1], b[1])
    total, error = quick_sum(total, error + low)
    return quick_sum(total, error + rest)


def negative(a):
    """−a."""
    return -a[0], -a[1]


def multiply(a, b):
    """Product of two such numbers."""
    product, error = two_product(a[0], b[0])
    return quick_sum(product, error + (a[0] * b[1] + a[1] * b[0]))


def divide(a, b):
    """a / b."""
    first = a[0] / b[0]
    rest = add(a, negative(multiply(b, (first, 0.0))))
    second = rest[0] / b[0]
    rest = add(rest, negative(multiply(b, (second, 0.0))))
    return add(quick_sum(first, second), (rest[0] / b[0], 0.0))


def square_root(a):
    """√a, of a number that is not negative."""
    if a[0] <= 0.0:
        return 0.0, 0.0
    root = math.sqrt(a[0])
    rest = add(a, negative(two_product(root, root)))
    first = quick_sum(root, rest[0] / (2.0 * root))
    rest = add(a, negative(multiply(first, first)))
    return add(first, (rest[0] / (2.0 * root), 0.0))


def _without(turns, angle):
    """The angle less whole turns."""
    high, error = two_product(turns, TWO_PI)
    rest = add(angle, (-high, -error))
    return add(rest, (-(turns * TWO_PI_LOW), 0.0))


@inline
def nearest_whole(number):
    """The whole number nearest to a double, as a double; a compiled `math.floor` ends at 2^63."""
    return 1.0 * math.floor(number + 0.5) if abs(number) < WHOLE else number


def turns_and_rest(angle):
    """(whole turns, rest as two doubles from −π to π) of an angle that is a double, taken as exact.

    The number of turns is a double as well: beyond 2^53 it is rounded, and the rest stays right. Beyond 2^100 rad, where the
    rest is rounding, it still is an angle from −π to π.
    """
    turns = angle / TWO_PI
    way = 1.0
    if abs(turns) >= MANY:
        way = math.copysign(1.0, angle)  # so that left and right are alike to the last bit
        angle *= way
        turns *= way
    turns = nearest_whole(turns)
    rest = _without(turns, (angle, 0.0))
    if turns >= MANY:  # the quotient may be next to the right number
        more = nearest_whole(rest[0] / TWO_PI)
        while abs(more) > 0.0:  # each time smaller by 2^50
            rest = _without(more, rest)
            turns += more
            more = nearest_whole(rest[0] / TWO_PI)
    return way * turns, way * rest[0], way * rest[1]
