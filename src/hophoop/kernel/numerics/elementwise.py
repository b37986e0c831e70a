"""Elementary functions of NumPy arrays, with the same bits as the kernels' functions.

Common arguments are computed as whole arrays (`whole_arrays`), rare ones, such as infinite ones, one by one. A number gives a
float, an array gives an array of the same shape.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from hophoop.kernel.numerics import arcs, circular, exponentials, hyperbolic, whole_arrays

Arrays = Any  # a float, or an array of floats

_both = circular.sine_and_cosine
_CHUNK = 8192  # numbers per chunk, which fits the processor's cache


def _elementwise(
    scalar: Any, whole: Callable[..., Any], common: Callable[..., Any], safe: float, arguments: tuple[Arrays, ...]
) -> Any:
    """Apply a function to common arguments as whole arrays and to the others one by one, with `safe` as their placeholder."""
    one = scalar
    if all(isinstance(value, float | int) for value in arguments):
        return whole_arrays.single(one, *(float(value) for value in arguments))
    given = [np.asarray(value, dtype=np.float64) for value in arguments]
    if all(value.ndim == 0 for value in given):
        return whole_arrays.single(one, *(float(value) for value in given))
    shape = np.broadcast_shapes(*(value.shape for value in given))
    flat = [np.ascontiguousarray(np.broadcast_to(value, shape)).reshape(-1) for value in given]
    result = np.empty(flat[0].shape)
    for begin in range(0, result.size, _CHUNK):
        parts = [value[begin : begin + _CHUNK] for value in flat]
        usual = common(*parts)
        rare = np.flatnonzero(~usual)
        values = whole(*(np.where(usual, part, safe) for part in parts) if rare.size else parts)
        for i in rare.tolist():
            values[i] = whole_arrays.single(one, *(float(part[i]) for part in parts))
        result[begin : begin + _CHUNK] = values
    return result.reshape(shape)


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
    return _elementwise(circular.sine, whole_arrays.sines, whole_arrays.turns, 0.0, (x,))


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
    return _elementwise(circular.cosine, whole_arrays.cosines, whole_arrays.turns, 0.0, (x,))


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
    if isinstance(x, float | int):
        return _both(float(x))
    given = np.asarray(x, dtype=np.float64)
    if given.ndim == 0:
        return _both(float(given))
    flat = np.ascontiguousarray(given).reshape(-1)
    both = np.empty((2, flat.size))
    for begin in range(0, flat.size, _CHUNK):
        part = flat[begin : begin + _CHUNK]
        usual = whole_arrays.turns(part)
        angle = np.where(usual, part, 0.0)
        s, s_rest, c, c_rest = whole_arrays.turned(angle)
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
    return _elementwise(circular.tangent, whole_arrays.tangents, whole_arrays.turns, 0.0, (x,))


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
        exponentials.exponential,
        whole_arrays.growths,
        lambda x: (x > exponentials.LEAST) & (x < exponentials.MOST),
        0.0,
        (x,),
    )


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
    return _elementwise(exponentials.logarithm, whole_arrays.logarithms, whole_arrays.positive, 1.0, (x,))


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
    return _elementwise(exponentials.binary_logarithm, whole_arrays.binary_logarithms, whole_arrays.positive, 1.0, (x,))


def logarithm_1p(u: Arrays) -> Any:
    """Logarithm of 1 + u, with all digits also for small u.

    Parameters
    ----------
    u : float or ndarray

    Returns
    -------
    logarithm : float or ndarray
        −inf at −1, nan below.
    """
    return _elementwise(
        exponentials.logarithm_1p,
        whole_arrays.logarithms_1p,
        lambda u: (np.abs(u) >= 1e-9) & (u > -1.0) & (u < np.inf),
        1.0,
        (u,),
    )


def power(x: Arrays, y: Arrays) -> Any:
    """x to the power y.

    Parameters
    ----------
    x, y : float or ndarray

    Returns
    -------
    power : float or ndarray
    """
    return _elementwise(exponentials.power, whole_arrays.powers, whole_arrays.plain_powers, 1.5, (x, y))


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
    return _elementwise(arcs.arcsine, whole_arrays.arcsines, whole_arrays.inside, 0.5, (x,))


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
    return _elementwise(arcs.arccosine, whole_arrays.arccosines, lambda x: np.abs(x) < 1.0, 0.5, (x,))


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
    return _elementwise(arcs.arctangent2, whole_arrays.arctangents2, whole_arrays.points, 1.0, (y, x))


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
    return _elementwise(arcs.hypotenuse, whole_arrays.lengths, whole_arrays.usual_lengths, 1.0, (x, y))


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
        whole_arrays.hyperbolic_tangents,
        lambda x: np.abs(x) < hyperbolic.LARGE_TANGENT,
        1.0,
        (x,),
    )


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
        whole_arrays.hyperbolic_sines,
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
        lambda x: whole_arrays.half_sums(np.abs(x), 1.0),
        lambda x: np.abs(x) <= hyperbolic.ALONE,
        1.0,
        (x,),
    )


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
        whole_arrays.inverse_hyperbolic_cosines,
        lambda x: (x > 1.0) & (x <= hyperbolic.FAR),
        2.0,
        (x,),
    )
