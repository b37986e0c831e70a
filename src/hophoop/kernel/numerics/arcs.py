"""Inverse trigonometric functions with the same bits on every machine, from + − × ÷ √ and integer operations.

All of them return the angle of a point (x, y). With t = j/64 near y/x,

    arctan(y/x) = arctan t + arctan v,   v = (y − t x)/(x + t y),   abs(v) ≤ 1/128.

arctan t comes from a double-double table, v is a double-double, and arctan v = v − v³/3 + …. An arcsine is the angle of (√(1 −
x²), x), with a double-double root. Errors stay below 0.5001 units in the last place.

References: S. Gal and B. Bachelis, An accurate elementary mathematical library for the IEEE floating point standard (1991);
P. T. P. Tang, Table-lookup algorithms for elementary functions and their error analysis (1991); T. J. Dekker, A floating-point
technique for extending the available precision (1971).
"""

from __future__ import annotations

import math

from hophoop.kernel.native import inline, noinline
from hophoop.kernel.numerics.arithmetic import quick_sum, two_product, two_sum
from hophoop.kernel.numerics.tables import ARCTANGENTS, PI_HIGH, PI_LOW

HALF_PI_HIGH, HALF_PI_LOW = 0.5 * PI_HIGH, 0.5 * PI_LOW
A3, A5, A7, A9 = -1.0 / 3.0, 0.2, -1.0 / 7.0, 1.0 / 9.0
SMALL_RATIO = 9.094947017729282e-13  # 2^−40: up to here arctan t = t in double precision
SMALL_SINE = 1e-8  # up to here arcsin x = x in double precision
LARGE, DOWN = 2.0**500, 2.0**-600  # from LARGE on both lengths are scaled down by the factor DOWN
SMALL, UP = 2.0**-400, 2.0**600


@inline
def angle_beyond(y, y_low, x, x_low, t, high, low):
    """Return the angle of (x + x_low, y + y_low) as a double-double; high + low is arctan t."""
    product, error = two_product(t, x)
    above, above_low = two_sum(y, -product)
    above_low = (above_low - error) + (y_low - t * x_low)
    product, error = two_product(t, y)
    below, below_low = quick_sum(x, product)
    below_low = (below_low + error) + (x_low + t * y_low)
    v = above / below
    product, error = two_product(v, below)
    v_low = (((above - product) - error) + (above_low - v * below_low)) / below
    z = v * v
    total, error = quick_sum(high, v)
    return total, error + (low + (v_low + v * z * (A3 + z * (A5 + z * (A7 + z * A9)))))


@noinline
def _angle(y, y_low, x, x_low):
    """Return the angle of (x + x_low, y + y_low) as a double-double, for 0 ≤ y ≤ x of moderate size."""
    j = int(64.0 * (y / x) + 0.5)
    return angle_beyond(y, y_low, x, x_low, 0.015625 * j, float(ARCTANGENTS[j, 0]), float(ARCTANGENTS[j, 1]))


@inline
def less(high, low, angle, rest):
    """Return (high + low) − (angle + rest) as a double-double, for high ≥ angle."""
    total, error = quick_sum(high, -angle)
    return total, error + (low - rest)


@inline
def _first_quadrant(y, y_low, x, x_low):
    """Return the angle of (x, y) as a double-double, for x and y not negative and not both 0."""
    if y <= x:
        return _angle(y, y_low, x, x_low)
    angle, low = _angle(x, x_low, y, y_low)
    return less(HALF_PI_HIGH, HALF_PI_LOW, angle, low)


@inline
def root_near(root, high, low):
    """Return √(high + low) as a double-double, given root = √high."""
    product, error = two_product(root, root)
    return quick_sum(root, (((high - product) - error) + low) / (2.0 * root))


@inline
def root_of(high, low):
    """Return √(high + low) as a double-double, for a sum that is not 0."""
    return root_near(math.sqrt(high), high, low)


@inline
def complement_of(size):
    """Return 1 − x² as a double-double, for 0 ≤ x < 1."""
    square, error = two_product(size, size)
    high, low = quick_sum(1.0, -square)
    return quick_sum(high, low - error)


def arcsine(x):
    """Return the arcsine [rad]; nan outside of [−1, 1]."""
    size = abs(x)
    if size < SMALL_SINE:
        return x
    if not size < 1.0:
        return math.copysign(HALF_PI_HIGH, x) if size == 1.0 else math.nan
    high, low = complement_of(size)
    root, low = root_of(high, low)
    angle, rest = _first_quadrant(size, 0.0, root, low)
    return math.copysign(angle + rest, x)


def arccosine(x):
    """Return the arccosine [rad]; nan outside of [−1, 1]."""
    size = abs(x)
    if not size < 1.0:
        return (0.0 if x > 0.0 else PI_HIGH) if size == 1.0 else math.nan
    high, low = complement_of(size)
    root, low = root_of(high, low)
    angle, rest = _first_quadrant(root, low, size, 0.0)
    if x < 0.0:
        angle, rest = less(PI_HIGH, PI_LOW, angle, rest)
    return angle + rest


@noinline
def arctangent2(y, x):
    """Return the angle of the point (x, y), from −π to π [rad], with the special values of C's atan2."""
    if x != x or y != y:
        return math.nan
    high, width = abs(y), abs(x)
    behind = math.copysign(1.0, x) < 0.0
    if high == math.inf or width == math.inf:
        # both infinite: the angle of a corner
        high, width = (1.0 if high == math.inf else 0.0), (1.0 if width == math.inf else 0.0)
    if high == 0.0:
        return math.copysign(PI_HIGH if behind else 0.0, y)
    if not behind and high < SMALL_RATIO * width:
        return math.copysign(high / width, y)
    longest = max(high, width)
    if longest > LARGE:
        high *= DOWN
        width *= DOWN
    elif longest < SMALL:
        high *= UP
        width *= UP
    angle, rest = _first_quadrant(high, 0.0, width, 0.0)
    if behind:
        angle, rest = less(PI_HIGH, PI_LOW, angle, rest)
    return math.copysign(angle + rest, y)


def arctangent(t):
    """Return the arctangent [rad]."""
    return arctangent2(t, 1.0)


@inline
def square_of_length(long, short):
    """Return long² + short² as a double-double, for long ≥ short."""
    square, error = two_product(long, long)
    other, other_error = two_product(short, short)
    total, more = quick_sum(square, other)
    return total, more + (error + other_error)


@noinline
def hypotenuse(x, y):
    """Return √(x² + y²) without intermediate overflow or underflow; inf if x or y is infinite, even if the other is nan."""
    long, short = abs(x), abs(y)
    if long == math.inf or short == math.inf:
        return math.inf
    if x != x or y != y:
        return math.nan
    if short > long:
        long, short = short, long
    if short == 0.0:
        return long
    scale = 1.0
    if long > LARGE:
        scale = UP
        long *= DOWN
        short *= DOWN
    elif long < SMALL:
        scale = DOWN
        long *= UP
        short *= UP
    high, low = square_of_length(long, short)
    root, rest = root_of(high, low)
    return (root + rest) * scale
