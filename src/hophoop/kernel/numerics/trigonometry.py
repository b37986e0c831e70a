"""Sines, cosines and their differences from their leading terms, without cancellation."""

from __future__ import annotations

import math

import numpy as np

from hophoop.kernel.native import inline
from hophoop.kernel.numerics.circular import sine, sine_and_cosine

SMALL = 0.9  # rad: up to here 9 terms of the series are exact to rounding
_SINE_TERMS = np.array([(-1.0) ** k / math.factorial(2 * k + 3) for k in range(9)])
_COSINE_TERMS = np.array([(-1.0) ** k / math.factorial(2 * k + 4) for k in range(9)])


@inline
def versine_of(angle):
    """Return 1 − cos with all digits; as a product, since interpreted code rounds a power differently."""
    half = sine(0.5 * angle)
    return 2.0 * half * half


@inline
def sine_and_versine(angle):
    """Return (sin, 1 − cos) with all digits of both, in one evaluation."""
    s, c = sine_and_cosine(angle)
    return s, s * s / (1.0 + c) if c > 0.0 else 1.0 - c


@inline
def small_turn_deficits(phi):
    """Return `turn_deficits` up to `SMALL`, by a series that vectorizes over several angles."""
    square = phi * phi
    odd = 0.0
    even = 0.0
    for k in range(8, -1, -1):
        odd = odd * square + _SINE_TERMS[k]
        even = even * square + _COSINE_TERMS[k]
    even *= square * square
    return odd * square * phi, even, 0.5 * square - even


@inline
def turn_deficits(phi):
    """Return (φ − sin φ, cos φ − 1 + φ²/2, 1 − cos φ) without cancellation."""
    if abs(phi) > SMALL:
        s, versine = sine_and_versine(phi)
        return phi - s, 0.5 * phi * phi - versine, versine
    return small_turn_deficits(phi)


@inline
def sine_cosine(th, low):
    """Return (sin, cos) of a double-double angle, with all digits of both, also near multiples of π/2."""
    s, c = sine_and_cosine(th)
    return s + low * c, c - low * s


@inline
def turn(s, c, angle):
    """Return (sin, cos) of θ + angle minus those of θ, without cancellation."""
    sine, versine = sine_and_versine(angle)
    return rotated(s, c, sine, versine)


@inline
def rotated(s, c, sine, versine):
    """Return `turn` for an angle given by its sine and 1 − cosine."""
    return c * sine - s * versine, -s * sine - c * versine
