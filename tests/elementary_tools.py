"""Values of the elementary functions, compiled and interpreted, and their errors against mpmath."""

from __future__ import annotations

import math
from functools import cache

import mpmath
import numpy as np
from mpmath import mp, mpf

from elementary_kernels import BOTH, NAMES, TWO, evaluate
from hophoop.kernel.native import mode

EXACT = {
    "sine": mp.sin, "cosine": mp.cos, "tangent": mp.tan, "arcsine": mp.asin, "arccosine": mp.acos, "arctangent": mp.atan,
    "exponential": mp.exp, "logarithm": mp.log, "binary_logarithm": lambda x: mp.log(x) / mp.log(2), "logarithm_1p": mp.log1p,
    "hyperbolic_tangent": mp.tanh, "hyperbolic_sine": mp.sinh, "hyperbolic_cosine": mp.cosh,
    "inverse_hyperbolic_cosine": mp.acosh, "arctangent2": mp.atan2, "hypotenuse": mp.hypot, "power": mp.power,
}  # fmt: skip
# units in the last place
BOUNDS = dict.fromkeys(NAMES, 0.5001) | {"hyperbolic_tangent": 0.51, "hyperbolic_sine": 0.53, "power": 0.51}


@cache
def _evaluate():
    """`evaluate` by Numba; by Python where kernels are interpreted."""
    if mode() == "interpreted":
        return evaluate
    from numba_tools import jitted

    return jitted(evaluate)


def values(x, y=None):
    """The values of all functions by name; `sine_and_cosine` has two rows."""
    x = np.array(x, dtype=float)
    y = np.ones_like(x) if y is None else np.array(y, dtype=float)
    out = np.empty((BOTH + 2, x.size))
    with np.errstate(all="ignore"):
        _evaluate()(x, y, out)
    return dict(zip(NAMES, out, strict=False)) | {"sine_and_cosine": out[BOTH:]}


def interpreted_values(module, name, *arguments):
    """The values of one function in plain Python."""
    function = getattr(module, name)
    with np.errstate(all="ignore"):
        found = [function(*(float(value) for value in point)) for point in zip(*arguments, strict=True)]
    assert all(type(value) is float for item in found for value in (item if isinstance(item, tuple) else (item,)))
    return np.array(found).T


def same_bits(a, b):
    """Whether two arrays have the same bits, but for those of nan."""
    a, b = np.atleast_1d(np.ascontiguousarray(a, dtype=float)), np.atleast_1d(np.ascontiguousarray(b, dtype=float))
    return (a.view(np.int64) == b.view(np.int64)) | (np.isnan(a) & np.isnan(b))


def error(found, exact):
    """The error of a double in units in the last place of the exact value, which is not 0."""
    if math.isinf(found):
        rounded_up = mpf(2) ** 1024 - mpf(2) ** 970
        return 0.0 if exact * math.copysign(1.0, found) >= rounded_up else math.inf
    place = max(mpmath.frexp(abs(exact))[1] - 53, -1074)
    return float(abs(mpf(found) - exact) / mpf(2) ** place)


def precision_of(name, x):
    """The bits with which mpmath has some 60 digits of a result."""
    if name in TWO:
        return 250 if name == "power" else 2400
    return 1400 if abs(x) > 1e6 or abs(x) < 1e-15 else 200


def worst(name, x, y=None):
    """The largest error of a function, and where it is."""
    found = values(x, y)[name]
    largest = (0.0, math.nan)
    for i, value in enumerate(found.tolist()):
        point = (float(x[i]),) if name not in TWO else (float(x[i]), float(y[i]))
        with mp.workprec(precision_of(name, point[0])):
            exact = EXACT[name](*(mpf(number) for number in point))
            if exact == 0:
                assert value == 0.0, (name, point)
            else:
                largest = max(largest, (error(value, exact), point[0]))
    return largest
