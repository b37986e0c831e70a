"""Small systems of linear equations, real and complex, by Gaussian elimination with partial pivoting.

Complex products and quotients are written out, because compilers and NumPy add their terms in different orders.
"""

from __future__ import annotations

import math


def product(a, b):
    """Return a b of complex numbers."""
    return complex(a.real * b.real - a.imag * b.imag, a.real * b.imag + a.imag * b.real)


def scaled(a, factor):
    """Return a complex number times a real one."""
    return complex(a.real * factor, a.imag * factor)


def divided(a, divisor):
    """Return a complex number divided by a real one."""
    return complex(a.real / divisor, a.imag / divisor)


def reciprocal(a):
    """Return 1/a of a complex number."""
    square = a.real * a.real + a.imag * a.imag
    return complex(a.real / square, -a.imag / square)


def exchange_rows(matrix, one, other):
    """Exchange two rows in place."""
    for j in range(matrix.shape[1]):
        matrix[one, j], matrix[other, j] = matrix[other, j], matrix[one, j]


def exchange_entries(side, pivots):
    """Permute the right-hand side like the rows of the factors."""
    for k in range(side.shape[0]):
        best = pivots[k]
        if best != k:
            side[k], side[best] = side[best], side[k]


def factor(matrix, pivots):
    """Compute LU factors of a small real matrix in place; return False if it is singular."""
    n = matrix.shape[0]
    for k in range(n):
        best = k
        size = abs(matrix[k, k])
        for i in range(k + 1, n):
            if abs(matrix[i, k]) > size:
                best = i
                size = abs(matrix[i, k])
        pivots[k] = best
        if not 0.0 < size < math.inf:
            return False
        if best != k:
            exchange_rows(matrix, k, best)
        inverse = 1.0 / matrix[k, k]
        for i in range(k + 1, n):
            matrix[i, k] *= inverse
            for j in range(k + 1, n):
                matrix[i, j] -= matrix[i, k] * matrix[k, j]
    return True


def solve(matrix, pivots, side):
    """Solve with the factors, in place."""
    n = matrix.shape[0]
    exchange_entries(side, pivots)
    for i in range(1, n):
        for j in range(i):
            side[i] -= matrix[i, j] * side[j]
    for i in range(n - 1, -1, -1):
        for j in range(i + 1, n):
            side[i] -= matrix[i, j] * side[j]
        side[i] /= matrix[i, i]


def size_of(a):
    """Return abs(Re a) + abs(Im a), the size for the choice of pivots."""
    return abs(a.real) + abs(a.imag)


def factor_complex(matrix, pivots):
    """Compute LU factors of a small complex matrix in place, with reciprocal pivots; return False if it is singular."""
    n = matrix.shape[0]
    for k in range(n):
        best = k
        size = size_of(matrix[k, k])
        for i in range(k + 1, n):
            other = size_of(matrix[i, k])
            if other > size:
                best = i
                size = other
        pivots[k] = best
        if not 0.0 < size < math.inf:
            return False
        if best != k:
            exchange_rows(matrix, k, best)
        matrix[k, k] = reciprocal(matrix[k, k])
        for i in range(k + 1, n):
            matrix[i, k] = product(matrix[i, k], matrix[k, k])
            for j in range(k + 1, n):
                matrix[i, j] -= product(matrix[i, k], matrix[k, j])
    return True


def solve_complex(matrix, pivots, side):
    """Solve with the complex factors, in place."""
    n = matrix.shape[0]
    exchange_entries(side, pivots)
    for i in range(1, n):
        for j in range(i):
            side[i] -= product(matrix[i, j], side[j])
    for i in range(n - 1, -1, -1):
        for j in range(i + 1, n):
            side[i] -= product(matrix[i, j], side[j])
        side[i] = product(side[i], matrix[i, i])
