"""Sine, 1 − cosine and arcsine of double-doubles."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np

from hophoop.kernel.numerics.arcs import arcsine
from hophoop.kernel.numerics.double_double import add, divide, multiply, negative

_TERMS = 12
_INVERSE = [Fraction(1, math.factorial(k)) for k in range(2 * _TERMS + 2)]
# 1/(2k+1)! and 1/(2k+2)! as double-doubles
_ODD = np.array([[float(q), float(q - Fraction(float(q)))] for q in _INVERSE[1::2]])
_EVEN = np.array([[float(q), float(q - Fraction(float(q)))] for q in _INVERSE[2::2]])
_HALVINGS = 4


def sine_versine(a):
    """Return (sin a, 1 − cos a) of an angle of up to a few revolutions."""
    scale = 0.5**_HALVINGS
    x = (a[0] * scale, a[1] * scale)
    square = multiply(x, x)
    minus = negative(square)
    sine = (0.0, 0.0)
    versine = (0.0, 0.0)
    for k in range(_TERMS - 1, -1, -1):
        sine = add(multiply(sine, minus), (_ODD[k, 0], _ODD[k, 1]))
        versine = add(multiply(versine, minus), (_EVEN[k, 0], _EVEN[k, 1]))
    sine = multiply(sine, x)
    versine = multiply(versine, square)
    for _ in range(_HALVINGS):
        cosine = add((1.0, 0.0), negative(versine))
        doubled = multiply(sine, cosine)
        versine = multiply(sine, sine)
        versine = (2.0 * versine[0], 2.0 * versine[1])
        sine = (2.0 * doubled[0], 2.0 * doubled[1])
    return sine, versine


def arc_sine(a):
    """Return the angle from −π/2 to π/2 whose sine is a, abs(a) < 1; near ±1 as accurate as the sine permits."""
    angle = (arcsine(a[0]), 0.0)
    for _ in range(3):
        sine, versine = sine_versine(angle)
        slope = 1.0 - versine[0]
        if slope <= 0.0:
            return angle
        rest = add(a, negative(sine))
        angle = add(angle, divide(rest, add((1.0, 0.0), negative(versine))))
    return angle
