"""Tangents of elementary functions: of arguments and their tangents, (result, its tangent)."""

from __future__ import annotations

import math

from hophoop.kernel.native import inline
from hophoop.kernel.numerics.arcs import arcsine
from hophoop.kernel.numerics.circular import (
    cosine,
    series_remainders,
    sine,
    sine_and_cosine,
    sine_and_versine,
    versine_of,
)


@inline
def d_abs(x, dx):
    """abs(x)."""
    return abs(x), math.copysign(1.0, x) * dx


@inline
def d_min(a, b, da, db):
    """min(a, b)."""
    return min(a, b), da if a <= b else db


@inline
def d_max(a, b, da, db):
    """max(a, b)."""
    return max(a, b), da if a >= b else db


@inline
def d_copysign(x, sign, dx, _):
    """The size of x with the sign of another number."""
    return math.copysign(x, sign), math.copysign(1.0, x) * math.copysign(1.0, sign) * dx


@inline
def d_sqrt(x, dx):
    """√x; at 0 it has no derivative."""
    root = math.sqrt(x)
    return root, 0.5 * dx / root if root > 0.0 else math.nan


@inline
def d_sine(x, dx):
    """sin x."""
    return sine(x), cosine(x) * dx


@inline
def d_cosine(x, dx):
    """cos x."""
    return cosine(x), -sine(x) * dx


@inline
def d_sine_and_cosine(x, dx):
    """(sin x, cos x)."""
    s, c = sine_and_cosine(x)
    return (s, c), (c * dx, -s * dx)


@inline
def d_versine_of(x, dx):
    """1 − cos x."""
    return versine_of(x), sine(x) * dx


@inline
def d_sine_and_versine(x, dx):
    """(sin x, 1 − cos x)."""
    s, versine = sine_and_versine(x)
    return (s, versine), ((1.0 - versine) * dx, s * dx)


@inline
def d_series_remainders(x, dx):
    """(x − sin x, cos x − 1 + x²/2, 1 − cos x)."""
    odd, even, versine = series_remainders(x)
    return (odd, even, versine), (versine * dx, odd * dx, (x - odd) * dx)


@inline
def d_arcsine(x, dx):
    """arcsin x; at ±1 it has no derivative."""
    slope = math.sqrt((1.0 - x) * (1.0 + x))
    return arcsine(x), dx / slope if slope > 0.0 else math.nan


RULES = {
    abs: d_abs, min: d_min, max: d_max, math.copysign: d_copysign, math.sqrt: d_sqrt, sine: d_sine, cosine: d_cosine,
    sine_and_cosine: d_sine_and_cosine, versine_of: d_versine_of, sine_and_versine: d_sine_and_versine,
    series_remainders: d_series_remainders, arcsine: d_arcsine,
}  # fmt: skip
