"""All elementary functions in one kernel; a module of its own, so that another process can import it."""

from __future__ import annotations

from hophoop.kernel.numerics.arcs import arccosine, arcsine, arctangent, arctangent2, hypotenuse
from hophoop.kernel.numerics.circular import cosine, sine, sine_and_cosine, tangent
from hophoop.kernel.numerics.exponentials import (
    binary_logarithm,
    exponential,
    hyperbolic_cosine,
    hyperbolic_sine,
    hyperbolic_tangent,
    inverse_hyperbolic_cosine,
    logarithm,
    logarithm_1p,
    power,
)

# the rows of what `evaluate` writes
ONE = [
    "sine", "cosine", "tangent", "arcsine", "arccosine", "arctangent", "exponential", "logarithm", "binary_logarithm",
    "logarithm_1p", "hyperbolic_tangent", "hyperbolic_sine", "hyperbolic_cosine", "inverse_hyperbolic_cosine",
]  # fmt: skip
TWO = ["arctangent2", "hypotenuse", "power"]
NAMES = [*ONE, *TWO]
BOTH = len(NAMES)  # the two rows of sine_and_cosine


def evaluate(x, y, out):
    """All functions of every x, or of x and y."""
    for i in range(x.shape[0]):
        a = x[i]
        b = y[i]
        out[0, i] = sine(a)
        out[1, i] = cosine(a)
        out[2, i] = tangent(a)
        out[3, i] = arcsine(a)
        out[4, i] = arccosine(a)
        out[5, i] = arctangent(a)
        out[6, i] = exponential(a)
        out[7, i] = logarithm(a)
        out[8, i] = binary_logarithm(a)
        out[9, i] = logarithm_1p(a)
        out[10, i] = hyperbolic_tangent(a)
        out[11, i] = hyperbolic_sine(a)
        out[12, i] = hyperbolic_cosine(a)
        out[13, i] = inverse_hyperbolic_cosine(a)
        out[14, i] = arctangent2(a, b)
        out[15, i] = hypotenuse(a, b)
        out[16, i] = power(a, b)
        out[17, i], out[18, i] = sine_and_cosine(a)
