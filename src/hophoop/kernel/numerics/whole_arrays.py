"""Formulas of the elementary functions for whole arrays of common arguments, as selected by `elementwise`.

They use the kernels' own formulas, and of NumPy only + − × ÷ √ and integer operations.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from hophoop.kernel.numerics import arcs, circular, exponentials, hyperbolic
from hophoop.kernel.numerics.double_double import multiply, two_sum
from hophoop.kernel.numerics.elementary_constants import (
    ANGLE_INVERSE,
    ARCTANGENTS,
    LOG2_E_HIGH,
    LOG2_E_LOW,
    LOGARITHMS,
    OCTAVE_INVERSE,
    PI_HIGH,
    PI_LOW,
    POWERS,
    REVOLUTIONS,
    SINES,
    SINH_SERIES,
    TANH_SERIES,
)
from hophoop.kernel.numerics.words import FRACTION, HIDDEN, SMALLEST_NORMAL, TWO_54


def single(function: Callable[..., float], *arguments: float) -> float:
    """Return the value of one interpreted function, without warnings."""
    with np.errstate(all="ignore"):
        return float(function(*arguments))


def power_of_two(exponents: np.ndarray) -> np.ndarray:
    return ((exponents + 1023) << 52).view(np.float64)


def placed(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    count = x * ANGLE_INVERSE + circular.INTEGER
    return (count.view(np.int64), *circular.rest_of(x, count - circular.INTEGER))


def placed_far(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Reduce angles as `circular.reduced_far` does, for arrays."""
    words = x.view(np.int64)
    exponents = (words >> 52) - 1015
    first = exponents // 30
    shift = exponents - 30 * first
    significand = (words & FRACTION) | HIDDEN
    m0 = (significand & circular.DIGIT) << shift
    m1 = ((significand >> 30) << shift) + (m0 >> 30)
    m2 = m1 >> 30
    m0 &= circular.DIGIT
    m1 &= circular.DIGIT
    digits = []
    carry = np.zeros_like(words)
    for i in range(7, 0, -1):
        column = m0 * REVOLUTIONS[first + i - 1] + m1 * REVOLUTIONS[first + i] + m2 * REVOLUTIONS[first + i + 1] + carry
        digits.append(column & circular.DIGIT)
        carry = column >> 30
    return circular.revolution_rest(*digits[:0:-1])


def turned(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return (sine, its low half, cosine, its low half) of finite angles that are 0 or not tiny."""
    size = np.abs(x)
    far = np.flatnonzero(~(size < circular.NEAR))
    k, r, low = placed(np.where(size < circular.NEAR, x, 0.0) if far.size else x)
    if far.size:
        k[far], r[far], low[far] = placed_far(size[far])
    sines, cosines = SINES[k & 127], SINES[128 - (k & 127)]
    s, s_rest, c, c_rest = circular.sums(sines[:, 0], sines[:, 1], cosines[:, 0], cosines[:, 1], r, low)
    odd = (k & 128) != 0
    s, s_rest, c, c_rest = (
        np.where(odd, c, s),
        np.where(odd, c_rest, s_rest),
        np.where(odd, -s, c),
        np.where(odd, -s_rest, c_rest),
    )
    way = np.where((k & 256) != 0, -1.0, 1.0)
    back = way * np.where((x < 0.0) & ~(size < circular.NEAR), -1.0, 1.0)
    return back * s, back * s_rest, way * c, way * c_rest


def turns(x: np.ndarray) -> np.ndarray:
    size = np.abs(x)
    return ((size > circular.TINY) | (x == 0.0)) & (size < np.inf)


def sines(x: np.ndarray) -> np.ndarray:
    s, s_rest, _, _ = turned(x)
    return np.where(x == 0.0, x, s + s_rest)


def cosines(x: np.ndarray) -> np.ndarray:
    _, _, c, c_rest = turned(x)
    return c + c_rest


def tangents(x: np.ndarray) -> np.ndarray:
    return np.where(x == 0.0, x, circular.quotient_of(*turned(x)))


def grown(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return `exponentials.growth` for arrays."""
    count = x * OCTAVE_INVERSE + circular.INTEGER
    whole = count.view(np.int64) - circular.INTEGER_WORD
    powers = POWERS[whole & 63]
    return (whole >> 6, *exponentials.growth_at(x, count - circular.INTEGER, powers[:, 0], powers[:, 1]))


def grow(x: np.ndarray) -> np.ndarray:
    """Return where the exponential is a normal number."""
    return (x > exponentials.LEAST) & (x < exponentials.MOST)


def growths(x: np.ndarray) -> np.ndarray:
    m, high, rest = grown(x)
    return (high + rest) * power_of_two(m)


def logarithm_parts(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return `exponentials.logarithm_parts` for arrays."""
    small = x < SMALLEST_NORMAL
    words = np.where(small, x * np.where(small, TWO_54, 1.0), x).view(np.int64)
    e = (words >> 52) - np.where(small, 1077, 1023)
    m = ((words & FRACTION) | 0x3FF0000000000000).view(np.float64)
    above = m > exponentials.ROOT_TWO
    m, e = np.where(above, 0.5 * m, m), np.where(above, e + 1, e)
    row = LOGARITHMS[(128.0 * m + 0.5).astype(np.int64) - exponentials.FIRST]
    high, low = exponentials.logarithm_at(1.0 * e, m, row[:, 0], row[:, 1], row[:, 2])
    return high, low


def positive(x: np.ndarray) -> np.ndarray:
    return (x > 0.0) & (x < np.inf)


def logarithms(x: np.ndarray) -> np.ndarray:
    high, low = logarithm_parts(x)
    return high + low


def binary_logarithms(x: np.ndarray) -> np.ndarray:
    high, low = multiply(logarithm_parts(x), (LOG2_E_HIGH, LOG2_E_LOW))
    return np.asarray(high + low)


def above_minus_one(u: np.ndarray) -> np.ndarray:
    """Return where `logarithm_1p` is finite and not nearly u."""
    return (np.abs(u) >= exponentials.SMALL_1P) & (u > -1.0) & (u < np.inf)


def logarithms_1p(u: np.ndarray) -> np.ndarray:
    total, error = two_sum(1.0, u)
    high, low = logarithm_parts(total)
    return np.asarray(high + (low + error / total))


def powers(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    exponent, low = multiply(logarithm_parts(x), (y, 0.0))
    usual = np.abs(exponent) < 700.0
    rare = np.flatnonzero(~usual)
    m, high, rest = grown(np.where(usual, exponent, 0.0))
    values = (high + (rest + high * low)) * power_of_two(m)
    one = exponentials.power
    for i in rare.tolist():
        values[i] = single(one, float(x[i]), float(y[i]))
    return np.asarray(values)


def plain_powers(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    special = (y == 0.0) | (y == 1.0) | (y == 2.0) | (y == 0.5) | (x == 1.0)
    return positive(x) & (np.abs(y) < 1e6) & ~special


def angles(y: np.ndarray, y_low: Any, x: np.ndarray, x_low: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return `arcs._first_quadrant` for arrays."""
    steep = ~(y <= x)
    y_low, x_low = np.broadcast_to(y_low, y.shape), np.broadcast_to(x_low, x.shape)
    short, short_low = np.where(steep, x, y), np.where(steep, x_low, y_low)
    long, long_low = np.where(steep, y, x), np.where(steep, y_low, x_low)
    j = (64.0 * (short / long) + 0.5).astype(np.int64)
    row = ARCTANGENTS[j]
    angle, rest = arcs.angle_beyond(short, short_low, long, long_low, 0.015625 * j, row[:, 0], row[:, 1])
    other, other_rest = arcs.less(arcs.HALF_PI_HIGH, arcs.HALF_PI_LOW, angle, rest)
    return np.where(steep, other, angle), np.where(steep, other_rest, rest)


def root_of(high: np.ndarray, low: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    root, rest = arcs.root_near(np.sqrt(high), high, low)
    return root, rest


def inside(x: np.ndarray) -> np.ndarray:
    """Return where `arcsine` is neither x nor ±π/2 nor nan."""
    return (np.abs(x) >= arcs.SMALL_SINE) & (np.abs(x) < 1.0)


def arcsines(x: np.ndarray) -> np.ndarray:
    size = np.abs(x)
    angle, rest = angles(size, 0.0, *root_of(*arcs.complement_of(size)))
    return np.copysign(angle + rest, x)


def arccosines(x: np.ndarray) -> np.ndarray:
    size = np.abs(x)
    angle, rest = angles(*root_of(*arcs.complement_of(size)), size, 0.0)
    other, other_rest = arcs.less(PI_HIGH, PI_LOW, angle, rest)
    return np.where(x < 0.0, other + other_rest, angle + rest)


def points(y: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Return where `arctangent2` needs no scaling."""
    high, width = np.abs(y), np.abs(x)
    longest = np.maximum(high, width)
    behind = np.copysign(1.0, x) < 0.0
    return (longest <= arcs.LARGE) & (longest >= arcs.SMALL) & ((high == 0.0) | behind | (high >= arcs.SMALL_RATIO * width))


def arctangents2(y: np.ndarray, x: np.ndarray) -> np.ndarray:
    angle, rest = angles(np.abs(y), 0.0, np.abs(x), 0.0)
    behind = np.copysign(1.0, x) < 0.0
    other, other_rest = arcs.less(PI_HIGH, PI_LOW, angle, rest)
    value = np.where(behind, other + other_rest, angle + rest)
    return np.copysign(np.where(y == 0.0, np.where(behind, PI_HIGH, 0.0), value), y)


def lengths(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    high, width = np.abs(y), np.abs(x)
    root, rest = root_of(*arcs.square_of_length(np.maximum(high, width), np.minimum(high, width)))
    return root + rest


def usual_lengths(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    high, width = np.abs(y), np.abs(x)
    longest = np.maximum(high, width)
    return (longest <= arcs.LARGE) & (longest >= arcs.SMALL) & (np.minimum(high, width) > 0.0)


def hyperbolic_tangents(x: np.ndarray) -> np.ndarray:
    size = np.abs(x)
    small = size < hyperbolic.SMALL_TANGENT
    m, high, rest = grown(2.0 * size)
    value = np.copysign(hyperbolic.tangent_of(high, rest, power_of_two(m)), x)
    return np.where(x == 0.0, x, np.where(small, hyperbolic.series_of(np.where(small, x, 0.0), TANH_SERIES), value))


def half_sums(size: np.ndarray, sign: float) -> np.ndarray:
    m, high, rest = grown(size)
    return np.asarray(hyperbolic.half_sum_of(high, rest, power_of_two(-2 * m), sign) * power_of_two(m - 1))


def hyperbolic_sines(x: np.ndarray) -> np.ndarray:
    size = np.abs(x)
    small = size < hyperbolic.SMALL_SINE
    value = np.copysign(half_sums(size, -1.0), x)
    return np.where(x == 0.0, x, np.where(small, hyperbolic.series_of(np.where(small, x, 0.0), SINH_SERIES), value))


def inverse_hyperbolic_cosines(x: np.ndarray) -> np.ndarray:
    total, rest = hyperbolic.grown_by(x, *root_of(*hyperbolic.square_less_one(x)))
    high, low = logarithm_parts(total)
    return np.asarray(high + (low + rest / total))
