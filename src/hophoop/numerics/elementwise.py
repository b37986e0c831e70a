"""The elementary functions for NumPy's arrays, with the bits of those that the kernels use.

Each computes the usual arguments as whole arrays, with the formulas of the kernels and nothing of NumPy but + − × ÷ √ and
integer operations. Rare arguments, as infinite ones, are computed one by one. A number gives a float, an array an array of
the same shape.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from hophoop._jit import interpreted
from hophoop.numerics import arcs, circular, exponentials, hyperbolic
from hophoop.numerics.double_double import multiply, two_sum
from hophoop.numerics.elementary_constants import (
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
from hophoop.numerics.words import FRACTION, HIDDEN, SMALLEST_NORMAL, TWO_54

Arrays = Any  # a float, or an array of them

_rest_of, _revolution_rest, _sums = (interpreted(f) for f in (circular.rest_of, circular.revolution_rest, circular.sums))
_quotient_of, _growth_at, _logarithm_at = (
    interpreted(f) for f in (circular.quotient_of, exponentials.growth_at, exponentials.logarithm_at)
)
_angle_beyond, _less, _root_near, _complement_of, _square_of_length = (
    interpreted(f) for f in (arcs.angle_beyond, arcs.less, arcs.root_near, arcs.complement_of, arcs.square_of_length)
)
_series_of, _tangent_of, _half_sum_of = (
    interpreted(f) for f in (hyperbolic.series_of, hyperbolic.tangent_of, hyperbolic.half_sum_of)
)
_square_less_one, _grown_by = interpreted(hyperbolic.square_less_one), interpreted(hyperbolic.grown_by)
_multiply, _two_sum = interpreted(multiply), interpreted(two_sum)
_sine, _cosine, _both, _tangent = (
    interpreted(f) for f in (circular.sine, circular.cosine, circular.sine_and_cosine, circular.tangent)
)
_CHUNK = 8192  # numbers at a time, which stay in the processor's cache


def _elementwise(
    scalar: Any, whole: Callable[..., Any], common: Callable[..., Any], safe: float, arguments: tuple[Arrays, ...]
) -> Any:
    """Apply a function to common arguments as whole arrays, to the others one by one; `safe` stands in for these meanwhile."""
    one = interpreted(scalar)
    given = [np.asarray(value, dtype=np.float64) for value in arguments]
    if all(value.ndim == 0 for value in given):
        return _one(one, *(float(value) for value in given))
    shape = np.broadcast_shapes(*(value.shape for value in given))
    flat = [np.ascontiguousarray(np.broadcast_to(value, shape)).reshape(-1) for value in given]
    result = np.empty(flat[0].shape)
    for begin in range(0, result.size, _CHUNK):
        parts = [value[begin : begin + _CHUNK] for value in flat]
        usual = common(*parts)
        rare = np.flatnonzero(~usual)
        values = whole(*(np.where(usual, part, safe) for part in parts) if rare.size else parts)
        for i in rare.tolist():
            values[i] = _one(one, *(float(part[i]) for part in parts))
        result[begin : begin + _CHUNK] = values
    return result.reshape(shape)


def _one(one: Callable[..., float], *arguments: float) -> float:
    with np.errstate(all="ignore"):
        return float(one(*arguments))


def _power_of_two(exponents: np.ndarray) -> np.ndarray:
    return ((exponents + 1023) << 52).view(np.float64)


def _placed(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    count = x * ANGLE_INVERSE + circular.INTEGER
    return (count.view(np.int64), *_rest_of(x, count - circular.INTEGER))


def _placed_far(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """`circular.reduced_far` for arrays."""
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
    return _revolution_rest(*digits[:0:-1])


def _turned(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return (sine, rest, cosine, rest) of finite angles that are 0 or not tiny."""
    size = np.abs(x)
    far = np.flatnonzero(~(size < circular.NEAR))
    k, r, low = _placed(np.where(size < circular.NEAR, x, 0.0) if far.size else x)
    if far.size:
        k[far], r[far], low[far] = _placed_far(size[far])
    sines, cosines = SINES[k & 127], SINES[128 - (k & 127)]
    s, s_rest, c, c_rest = _sums(sines[:, 0], sines[:, 1], cosines[:, 0], cosines[:, 1], r, low)
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


def _turns(x: np.ndarray) -> np.ndarray:
    size = np.abs(x)
    return ((size > circular.TINY) | (x == 0.0)) & (size < np.inf)


def _sines(x: np.ndarray) -> np.ndarray:
    s, s_rest, _, _ = _turned(x)
    return np.where(x == 0.0, x, s + s_rest)


def _cosines(x: np.ndarray) -> np.ndarray:
    _, _, c, c_rest = _turned(x)
    return c + c_rest


def _tangents(x: np.ndarray) -> np.ndarray:
    return np.where(x == 0.0, x, _quotient_of(*_turned(x)))


def sine(x: Arrays) -> Any:
    """Sine.

    Parameters
    ----------
    x : float or ndarray
        Angle [rad].

    Returns
    -------
    sine : float or ndarray
    """
    return _elementwise(circular.sine, _sines, _turns, 0.0, (x,))


def cosine(x: Arrays) -> Any:
    """Cosine.

    Parameters
    ----------
    x : float or ndarray
        Angle [rad].

    Returns
    -------
    cosine : float or ndarray
    """
    return _elementwise(circular.cosine, _cosines, _turns, 0.0, (x,))


def sine_and_cosine(x: Arrays) -> tuple[Any, Any]:
    """Sine and cosine.

    Parameters
    ----------
    x : float or ndarray
        Angle [rad].

    Returns
    -------
    sine, cosine : float or ndarray
    """
    given = np.asarray(x, dtype=np.float64)
    if given.ndim == 0:
        return _both(float(given))
    flat = np.ascontiguousarray(given).reshape(-1)
    both = np.empty((2, flat.size))
    for begin in range(0, flat.size, _CHUNK):
        part = flat[begin : begin + _CHUNK]
        usual = _turns(part)
        angle = np.where(usual, part, 0.0)
        s, s_rest, c, c_rest = _turned(angle)
        values = both[:, begin : begin + _CHUNK]
        values[0], values[1] = np.where(angle == 0.0, angle, s + s_rest), c + c_rest
        for i in np.flatnonzero(~usual).tolist():
            values[:, i] = _both(float(part[i]))
    return both[0].reshape(given.shape), both[1].reshape(given.shape)


def tangent(x: Arrays) -> Any:
    """Tangent.

    Parameters
    ----------
    x : float or ndarray
        Angle [rad].

    Returns
    -------
    tangent : float or ndarray
    """
    return _elementwise(circular.tangent, _tangents, _turns, 0.0, (x,))


def _grown(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """`exponentials.growth` for arrays."""
    count = x * OCTAVE_INVERSE + circular.INTEGER
    whole = count.view(np.int64) - circular.INTEGER_WORD
    powers = POWERS[whole & 63]
    return (whole >> 6, *_growth_at(x, count - circular.INTEGER, powers[:, 0], powers[:, 1]))


def _exponentials(x: np.ndarray) -> np.ndarray:
    m, high, rest = _grown(x)
    return (high + rest) * _power_of_two(m)


def exponential(x: Arrays) -> Any:
    """Exponential.

    Parameters
    ----------
    x : float or ndarray

    Returns
    -------
    exponential : float or ndarray
    """
    return _elementwise(
        exponentials.exponential, _exponentials, lambda x: (x > exponentials.LEAST) & (x < exponentials.MOST), 0.0, (x,)
    )


def _logarithm_parts(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """`exponentials.logarithm_parts` for arrays."""
    small = x < SMALLEST_NORMAL
    words = np.where(small, x * np.where(small, TWO_54, 1.0), x).view(np.int64)
    e = (words >> 52) - np.where(small, 1077, 1023)
    m = ((words & FRACTION) | 0x3FF0000000000000).view(np.float64)
    above = m > exponentials.ROOT_TWO
    m, e = np.where(above, 0.5 * m, m), np.where(above, e + 1, e)
    row = LOGARITHMS[(128.0 * m + 0.5).astype(np.int64) - exponentials.FIRST]
    high, low = _logarithm_at(1.0 * e, m, row[:, 0], row[:, 1], row[:, 2])
    return high, low


def _positive(x: np.ndarray) -> np.ndarray:
    return (x > 0.0) & (x < np.inf)


def _logarithms(x: np.ndarray) -> np.ndarray:
    high, low = _logarithm_parts(x)
    return high + low


def logarithm(x: Arrays) -> Any:
    """Natural logarithm.

    Parameters
    ----------
    x : float or ndarray

    Returns
    -------
    logarithm : float or ndarray
        −inf at 0, nan below.
    """
    return _elementwise(exponentials.logarithm, _logarithms, _positive, 1.0, (x,))


def _binary_logarithms(x: np.ndarray) -> np.ndarray:
    high, low = _multiply(_logarithm_parts(x), (LOG2_E_HIGH, LOG2_E_LOW))
    return np.asarray(high + low)


def binary_logarithm(x: Arrays) -> Any:
    """Logarithm to the base 2, exact for powers of two.

    Parameters
    ----------
    x : float or ndarray

    Returns
    -------
    logarithm : float or ndarray
        −inf at 0, nan below.
    """
    return _elementwise(exponentials.binary_logarithm, _binary_logarithms, _positive, 1.0, (x,))


def _logarithms_1p(u: np.ndarray) -> np.ndarray:
    total, error = _two_sum(1.0, u)
    high, low = _logarithm_parts(total)
    return np.asarray(high + (low + error / total))


def logarithm_1p(u: Arrays) -> Any:
    """Logarithm of 1 + u, with all digits also where u is small.

    Parameters
    ----------
    u : float or ndarray

    Returns
    -------
    logarithm : float or ndarray
        −inf at −1, nan below.
    """
    return _elementwise(
        exponentials.logarithm_1p, _logarithms_1p, lambda u: (np.abs(u) >= 1e-9) & (u > -1.0) & (u < np.inf), 1.0, (u,)
    )


def _powers(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    exponent, low = _multiply(_logarithm_parts(x), (y, 0.0))
    usual = np.abs(exponent) < 700.0
    rare = np.flatnonzero(~usual)
    m, high, rest = _grown(np.where(usual, exponent, 0.0))
    values = (high + (rest + high * low)) * _power_of_two(m)
    one = interpreted(exponentials.power)
    for i in rare.tolist():
        values[i] = _one(one, float(x[i]), float(y[i]))
    return np.asarray(values)


def _plain_powers(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    special = (y == 0.0) | (y == 1.0) | (y == 2.0) | (y == 0.5) | (x == 1.0)
    return _positive(x) & (np.abs(y) < 1e6) & ~special


def power(x: Arrays, y: Arrays) -> Any:
    """x to the power of y.

    Parameters
    ----------
    x, y : float or ndarray

    Returns
    -------
    power : float or ndarray
    """
    return _elementwise(exponentials.power, _powers, _plain_powers, 1.5, (x, y))


def _angles(y: np.ndarray, y_low: Any, x: np.ndarray, x_low: Any) -> tuple[np.ndarray, np.ndarray]:
    """`arcs._first_quadrant` for arrays."""
    steep = ~(y <= x)
    y_low, x_low = np.broadcast_to(y_low, y.shape), np.broadcast_to(x_low, x.shape)
    short, short_low = np.where(steep, x, y), np.where(steep, x_low, y_low)
    long, long_low = np.where(steep, y, x), np.where(steep, y_low, x_low)
    j = (64.0 * (short / long) + 0.5).astype(np.int64)
    row = ARCTANGENTS[j]
    angle, rest = _angle_beyond(short, short_low, long, long_low, 0.015625 * j, row[:, 0], row[:, 1])
    other, other_rest = _less(arcs.HALF_PI_HIGH, arcs.HALF_PI_LOW, angle, rest)
    return np.where(steep, other, angle), np.where(steep, other_rest, rest)


def _root_of(high: np.ndarray, low: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    root, rest = _root_near(np.sqrt(high), high, low)
    return root, rest


def _arcsines(x: np.ndarray) -> np.ndarray:
    size = np.abs(x)
    angle, rest = _angles(size, 0.0, *_root_of(*_complement_of(size)))
    return np.copysign(angle + rest, x)


def arcsine(x: Arrays) -> Any:
    """Arcsine.

    Parameters
    ----------
    x : float or ndarray

    Returns
    -------
    angle : float or ndarray
        From −π/2 to π/2 [rad]; nan outside of [−1, 1].
    """
    return _elementwise(arcs.arcsine, _arcsines, lambda x: (np.abs(x) >= 1e-8) & (np.abs(x) < 1.0), 0.5, (x,))


def _arccosines(x: np.ndarray) -> np.ndarray:
    size = np.abs(x)
    angle, rest = _angles(*_root_of(*_complement_of(size)), size, 0.0)
    other, other_rest = _less(PI_HIGH, PI_LOW, angle, rest)
    return np.where(x < 0.0, other + other_rest, angle + rest)


def arccosine(x: Arrays) -> Any:
    """Arccosine.

    Parameters
    ----------
    x : float or ndarray

    Returns
    -------
    angle : float or ndarray
        From 0 to π [rad]; nan outside of [−1, 1].
    """
    return _elementwise(arcs.arccosine, _arccosines, lambda x: np.abs(x) < 1.0, 0.5, (x,))


def _points(y: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Where `arctangent2` is computed without a scale."""
    high, width = np.abs(y), np.abs(x)
    longest = np.maximum(high, width)
    behind = np.copysign(1.0, x) < 0.0
    return (longest <= arcs.LARGE) & (longest >= arcs.SMALL) & ((high == 0.0) | behind | (high >= arcs.SMALL_RATIO * width))


def _arctangents2(y: np.ndarray, x: np.ndarray) -> np.ndarray:
    angle, rest = _angles(np.abs(y), 0.0, np.abs(x), 0.0)
    behind = np.copysign(1.0, x) < 0.0
    other, other_rest = _less(PI_HIGH, PI_LOW, angle, rest)
    value = np.where(behind, other + other_rest, angle + rest)
    return np.copysign(np.where(y == 0.0, np.where(behind, PI_HIGH, 0.0), value), y)


def arctangent2(y: Arrays, x: Arrays) -> Any:
    """Angle of the point (x, y).

    Parameters
    ----------
    y, x : float or ndarray

    Returns
    -------
    angle : float or ndarray
        From −π to π [rad].
    """
    return _elementwise(arcs.arctangent2, _arctangents2, _points, 1.0, (y, x))


def arctangent(t: Arrays) -> Any:
    """Arctangent.

    Parameters
    ----------
    t : float or ndarray

    Returns
    -------
    angle : float or ndarray
        From −π/2 to π/2 [rad].
    """
    return arctangent2(t, 1.0)


def _lengths(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    high, width = np.abs(y), np.abs(x)
    root, rest = _root_of(*_square_of_length(np.maximum(high, width), np.minimum(high, width)))
    return root + rest


def _usual_lengths(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    high, width = np.abs(y), np.abs(x)
    longest = np.maximum(high, width)
    return (longest <= arcs.LARGE) & (longest >= arcs.SMALL) & (np.minimum(high, width) > 0.0)


def hypotenuse(x: Arrays, y: Arrays) -> Any:
    """Distance of the point (x, y) from the origin.

    Parameters
    ----------
    x, y : float or ndarray

    Returns
    -------
    distance : float or ndarray
        In the unit of x and y.
    """
    return _elementwise(arcs.hypotenuse, _lengths, _usual_lengths, 1.0, (x, y))


def _hyperbolic_tangents(x: np.ndarray) -> np.ndarray:
    size = np.abs(x)
    small = size < hyperbolic.SMALL_TANGENT
    m, high, rest = _grown(2.0 * size)
    value = np.copysign(_tangent_of(high, rest, _power_of_two(m)), x)
    return np.where(x == 0.0, x, np.where(small, _series_of(np.where(small, x, 0.0), TANH_SERIES), value))


def hyperbolic_tangent(x: Arrays) -> Any:
    """Hyperbolic tangent.

    Parameters
    ----------
    x : float or ndarray

    Returns
    -------
    tangent : float or ndarray
    """
    return _elementwise(
        hyperbolic.hyperbolic_tangent,
        _hyperbolic_tangents,
        lambda x: np.abs(x) < hyperbolic.LARGE_TANGENT,
        1.0,
        (x,),
    )


def _half_sums(size: np.ndarray, sign: float) -> np.ndarray:
    m, high, rest = _grown(size)
    return np.asarray(_half_sum_of(high, rest, _power_of_two(-2 * m), sign) * _power_of_two(m - 1))


def _hyperbolic_sines(x: np.ndarray) -> np.ndarray:
    size = np.abs(x)
    small = size < hyperbolic.SMALL_SINE
    value = np.copysign(_half_sums(size, -1.0), x)
    return np.where(x == 0.0, x, np.where(small, _series_of(np.where(small, x, 0.0), SINH_SERIES), value))


def hyperbolic_sine(x: Arrays) -> Any:
    """Hyperbolic sine.

    Parameters
    ----------
    x : float or ndarray

    Returns
    -------
    sine : float or ndarray
    """
    return _elementwise(
        hyperbolic.hyperbolic_sine,
        _hyperbolic_sines,
        lambda x: np.abs(x) <= hyperbolic.ALONE,
        1.0,
        (x,),
    )


def hyperbolic_cosine(x: Arrays) -> Any:
    """Hyperbolic cosine.

    Parameters
    ----------
    x : float or ndarray

    Returns
    -------
    cosine : float or ndarray
    """
    return _elementwise(
        hyperbolic.hyperbolic_cosine,
        lambda x: _half_sums(np.abs(x), 1.0),
        lambda x: np.abs(x) <= hyperbolic.ALONE,
        1.0,
        (x,),
    )


def _inverse_hyperbolic_cosines(x: np.ndarray) -> np.ndarray:
    total, rest = _grown_by(x, *_root_of(*_square_less_one(x)))
    high, low = _logarithm_parts(total)
    return np.asarray(high + (low + rest / total))


def inverse_hyperbolic_cosine(x: Arrays) -> Any:
    """Inverse hyperbolic cosine.

    Parameters
    ----------
    x : float or ndarray

    Returns
    -------
    value : float or ndarray
        nan below 1.
    """
    return _elementwise(
        hyperbolic.inverse_hyperbolic_cosine,
        _inverse_hyperbolic_cosines,
        lambda x: (x > 1.0) & (x <= hyperbolic.FAR),
        2.0,
        (x,),
    )
