"""Doubles as 64-bit words: exponents and powers of 2 without the C library."""

from __future__ import annotations

import math
import struct

import numpy as np

from hophoop.kernel.native import inline, interpreted_as

_DOUBLE, _WORD = struct.Struct("<d"), struct.Struct("<q")
FRACTION = 0xFFFFFFFFFFFFF  # bits of a double after its leading bit
HIDDEN = 0x10000000000000  # the leading bit
SMALLEST_NORMAL = 2.2250738585072014e-308
TWO_54 = 18014398509481984.0


def _word_of_float(x):
    return _WORD.unpack(_DOUBLE.pack(x))[0]


def _float_of_word(word):
    return _DOUBLE.unpack(_WORD.pack(word))[0]


@interpreted_as(_word_of_float)
@inline
def word_of(x):
    """Return the bits of a double as an integer."""
    return np.int64(np.float64(x).view(np.int64))


@interpreted_as(_float_of_word)
@inline
def double_of(word):
    """Return the double with these bits."""
    return float(np.int64(word).view(np.float64))


def _power_of_two_by_floats(exponent):
    return math.ldexp(1.0, exponent)


@interpreted_as(_power_of_two_by_floats)
@inline
def power_of_two(exponent):
    """Return 2^exponent, from −1022 to 1023."""
    return double_of((exponent + 1023) << 52)


def _scaled_by_floats(x, exponent):
    return math.ldexp(x, exponent)


@interpreted_as(_scaled_by_floats)
@inline
def scaled(x, exponent):
    """Return x 2^exponent for exponents from −2044 to 2046, if that is exact."""
    first = exponent >> 1
    return x * power_of_two(first) * power_of_two(exponent - first)


def _octave_by_floats(x):
    significand, exponent = math.frexp(x)
    return exponent - 1, 2.0 * significand


@interpreted_as(_octave_by_floats)
@inline
def octave(x):
    """Return (e, m) with x = 2^e m and 1 ≤ m < 2, for finite x > 0."""
    shift = 1023
    if x < SMALLEST_NORMAL:
        x *= TWO_54
        shift = 1077
    word = word_of(x)
    return (word >> 52) - shift, double_of((word & FRACTION) | 0x3FF0000000000000)
