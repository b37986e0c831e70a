"""Powers with integer exponents as products, whose bits do not depend on a C library."""

from __future__ import annotations

from hophoop._jit import lean_jit


@lean_jit
def integer_power(base, exponent):
    """Return base^exponent, from left to right; a negative exponent divides 1 by the product."""
    result = 1.0
    for _ in range(abs(exponent)):
        result *= base
    return result if exponent >= 0 else 1.0 / result


@lean_jit
def unit_size(length, time, mass, exponents):
    """Return the size of a unit from those of length, time and mass and their exponents."""
    return integer_power(length, exponents[0]) * integer_power(time, exponents[1]) * integer_power(mass, exponents[2])
