"""Powers with integer exponents as products, whose bits do not depend on a C library."""

from __future__ import annotations


def integer_power(base, exponent):
    """Return base^exponent, from left to right; a negative exponent divides 1 by the product."""
    result = 1.0
    for _ in range(abs(exponent)):
        result *= base
    return result if exponent >= 0 else 1.0 / result
