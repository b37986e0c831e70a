"""Elementary functions of numbers and of NumPy arrays, by a compiled loop over the kernels' own functions: the same bits.

A number gives a float, an array an array of the same shape. Angles are in radians.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from hophoop.kernel.native import compiled, noinline
from hophoop.kernel.numerics.arcs import arcsine as arcsine_of
from hophoop.kernel.numerics.arcs import arctangent2 as arctangent2_of
from hophoop.kernel.numerics.arcs import hypotenuse as hypotenuse_of
from hophoop.kernel.numerics.circular import cosine as cosine_of
from hophoop.kernel.numerics.circular import sine as sine_of
from hophoop.kernel.numerics.circular import sine_and_cosine as sine_and_cosine_of
from hophoop.kernel.numerics.circular import tangent as tangent_of
from hophoop.kernel.numerics.exponentials import exponential as exponential_of
from hophoop.kernel.numerics.exponentials import logarithm as logarithm_of

Arrays = Any  # a float, or an array of floats


SINE, COSINE, TANGENT, ARCSINE, ARCTANGENT2, HYPOTENUSE, EXPONENTIAL, LOGARITHM = range(8)


@noinline
def value(function, x, y):
    """Return the value of a function at x, or at x and y."""
    if function == SINE:
        return sine_of(x)
    if function == COSINE:
        return cosine_of(x)
    if function == TANGENT:
        return tangent_of(x)
    if function == ARCSINE:
        return arcsine_of(x)
    if function == ARCTANGENT2:
        return arctangent2_of(x, y)
    if function == HYPOTENUSE:
        return hypotenuse_of(x, y)
    if function == EXPONENTIAL:
        return exponential_of(x)
    return logarithm_of(x)


def fill(function, x, y, out):
    """Fill `out` with the values of a function at each x, or at each x and y."""
    for i in range(out.shape[0]):
        out[i] = value(function, x[i], y[i])


def _values(function: int, x: Arrays, y: Arrays = 0.0) -> Any:
    """Return a function's values for numbers or arrays that broadcast."""
    if isinstance(x, float | int) and isinstance(y, float | int):
        return value(function, float(x), float(y))
    shape = np.broadcast_shapes(np.shape(x), np.shape(y))
    first, second, out = np.empty(shape), np.empty(shape), np.empty(shape)
    first[...], second[...] = x, y
    compiled(fill)(function, first.reshape(-1), second.reshape(-1), out.reshape(-1))
    return out if shape else float(out)


def sine(x: Arrays) -> Any:
    """Return sin x."""
    return _values(SINE, x)


def cosine(x: Arrays) -> Any:
    """Return cos x."""
    return _values(COSINE, x)


def sine_and_cosine(x: Arrays) -> tuple[Any, Any]:
    """Return (sin x, cos x)."""
    if isinstance(x, float | int):
        both: tuple[float, float] = sine_and_cosine_of(float(x))
        return both
    return sine(x), cosine(x)


def tangent(x: Arrays) -> Any:
    """Return tan x."""
    return _values(TANGENT, x)


def arcsine(x: Arrays) -> Any:
    """Return the angle from −π/2 to π/2 with this sine; nan outside of [−1, 1]."""
    return _values(ARCSINE, x)


def arctangent2(y: Arrays, x: Arrays) -> Any:
    """Return the angle of the point (x, y), from −π to π."""
    return _values(ARCTANGENT2, y, x)


def hypotenuse(x: Arrays, y: Arrays) -> Any:
    """Return √(x² + y²)."""
    return _values(HYPOTENUSE, x, y)


def exponential(x: Arrays) -> Any:
    """Return exp x."""
    return _values(EXPONENTIAL, x)


def logarithm(x: Arrays) -> Any:
    """Return the natural logarithm; −inf at 0, nan below."""
    return _values(LOGARITHM, x)
