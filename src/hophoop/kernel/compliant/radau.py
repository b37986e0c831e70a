"""Radau IIA with 5 stages, order 9 (Hairer & Wanner, IV.8): simplified Newton iteration, error estimate, dense output.

RADAU_GAMMA is the real eigenvalue of A⁻¹, RADAU_LAMBDA holds one member of each of its two conjugate pairs. RADAU_FROM_PAIR is
twice the eigenvectors, to include the conjugates. RADAU_DEFECT and RADAU_ERROR belong to the solution of order 5 that also uses
f at the start with weight 1/γ; its difference from the method estimates the error:

    h f(y0)/γ + Σ DEFECT_i h f_i = h f(y0)/γ + Σ ERROR_i Z_i.

RADAU_POWERS gives the coefficients of s, s², …, s⁵ of the polynomial through (0, 0) and (c_i, Z_i).
"""

from __future__ import annotations

import math

import numpy as np

from hophoop.kernel.compliant.motion import dissipation, energies, jacobian, rates
from hophoop.kernel.compliant.records import BLOCKS, DYNAMIC, MEASURED, OM, SIZE, STAGES, VN, VT, X
from hophoop.kernel.numerics.arithmetic import integer_power
from hophoop.kernel.numerics.tables import (
    RADAU_A,
    RADAU_DEFECT,
    RADAU_ERROR,
    RADAU_FROM_PAIR,
    RADAU_FROM_REAL,
    RADAU_GAMMA,
    RADAU_LAMBDA,
    RADAU_NODES,
    RADAU_POWERS,
    RADAU_TO_PAIR,
    RADAU_TO_REAL,
)

# --- small systems of linear equations, by Gaussian elimination with partial pivoting
# Complex products and quotients are written out, because compilers and NumPy add their terms in different orders.


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


def size_of(a):
    """Return abs(Re a) + abs(Im a), the size for the choice of pivots."""
    return abs(a.real) + abs(a.imag)


def factor(matrix, pivots):
    """Compute LU factors of a small matrix in place, with reciprocal pivots; return False if it is singular."""
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


def solve(matrix, pivots, side):
    """Solve with the factors, in place."""
    n = matrix.shape[0]
    exchange_entries(side, pivots)
    for i in range(1, n):
        for j in range(i):
            side[i] -= product(matrix[i, j], side[j])
    for i in range(n - 1, -1, -1):
        for j in range(i + 1, n):
            side[i] -= product(matrix[i, j], side[j])
        side[i] = product(side[i], matrix[i, i])


# --- one step

# The real eigenvalue of A⁻¹ and one of each conjugate pair
EIGENVALUES = np.array([RADAU_GAMMA, *RADAU_LAMBDA])
TO = np.vstack((RADAU_TO_REAL, RADAU_TO_PAIR))
FROM = np.column_stack((RADAU_FROM_REAL, RADAU_FROM_PAIR))
ITERATIONS = 10
NEWTON = 1e-3  # relative to the tolerance: accepted residual of Newton's iteration
LEDGER = 0.1  # relative to rtol: accepted error of the energy ledger per step
ROUNDING = 4e-16  # of an energy, relative to the speeds whose squares it is a difference of
FAILED = 1e300  # error of a failed step


def predict(work, begin, stretch):
    """Extrapolate Newton's first guess from the polynomial in `work.poly`: its values at begin + stretch c_i."""
    for m in range(DYNAMIC):
        base = poly_value(work.poly, m, begin)
        for i in range(STAGES):
            work.stages[i, m] = poly_value(work.poly, m, begin + stretch * RADAU_NODES[i]) - base


def poly_value(poly, m, s):
    """Return variable m of the dense output."""
    result = poly[m, STAGES]
    for j in range(STAGES - 1, -1, -1):
        result = result * s + poly[m, j]
    return result


def newton(body, comp, regime, work, start, h):
    """Solve for the stages; return True if the iteration converged."""
    for k in range(BLOCKS):  # the stages in the eigenbasis of A⁻¹
        for m in range(DYNAMIC):
            total = 0.0j
            for i in range(STAGES):
                total += scaled(TO[k, i], work.stages[i, m])
            work.forms[k, m] = total
    before = 0.0
    rate = 0.9
    for iteration in range(ITERATIONS):
        for i in range(STAGES):
            for m in range(DYNAMIC):
                work.trial[m] = start[m] + work.stages[i, m]
            rates(body, comp, regime, work.trial, work.rates[i])
        size = 0.0
        for k in range(BLOCKS):
            eigenvalue = divided(EIGENVALUES[k], h)
            for m in range(DYNAMIC):
                total = 0.0j
                for i in range(STAGES):
                    total += scaled(TO[k, i], work.rates[i, m])
                work.side[m] = total - product(eigenvalue, work.forms[k, m])
            solve(work.blocks[k], work.pivots[k], work.side)
            for m in range(DYNAMIC):
                work.forms[k, m] += work.side[m]
                shift = divided(work.side[m], work.scale[m])
                size += shift.real * shift.real + shift.imag * shift.imag
        for i in range(STAGES):
            for m in range(DYNAMIC):
                total = 0.0
                for k in range(BLOCKS):
                    total += product(FROM[i, k], work.forms[k, m]).real
                work.stages[i, m] = total
        size = math.sqrt(size / (STAGES * DYNAMIC))
        if not size < 1e100:
            return False
        if iteration > 0:
            rate = size / before if before > 0.0 else 0.0
            if rate >= 1.0 and size > NEWTON:
                return False
            if rate < 1.0 and rate / (1.0 - rate) * size <= NEWTON:
                return True
            if rate < 1.0 and integer_power(rate, ITERATIONS - 1 - iteration) / (1.0 - rate) * size > NEWTON:
                return False
        if size <= 1e-2 * NEWTON:
            return True
        before = size
    return False


def filtered_square(work):
    """Return the sum of squares over the scales of the right-hand side, solved with the first block."""
    for m in range(DYNAMIC):
        work.side[m] = complex(work.trial[m], 0.0)
    solve(work.blocks[0], work.pivots[0], work.side)
    total = 0.0
    for m in range(DYNAMIC):
        part = work.side[m].real / work.scale[m]
        total += part * part
    return total


def attempt(body, comp, regime, work, start, h, rtol):
    """Try a step of length h from `start`, with `work.stages` as the first guess.

    Leaves the stages and integrals in `work`. Returns the error over the tolerance, FAILED if Newton's iteration does not
    converge.
    """
    for m in range(SIZE):
        work.scale[m] = rtol * (work.atol[m] + abs(start[m]))
    jacobian(body, comp, regime, start, work.jacobian)
    for k in range(BLOCKS):
        for i in range(DYNAMIC):
            for j in range(DYNAMIC):
                work.blocks[k, i, j] = complex(-work.jacobian[i, j], 0.0)
            work.blocks[k, i, i] += divided(EIGENVALUES[k], h)
        if not factor(work.blocks[k], work.pivots[k]):
            return FAILED
    if not newton(body, comp, regime, work, start, h):
        return FAILED
    # the integrals, by the same collocation
    for i in range(STAGES):
        for m in range(DYNAMIC):
            work.trial[m] = start[m] + work.stages[i, m]
        dissipation(body, comp, regime, work.trial, work.powers[i], 0)
    rates(body, comp, regime, start, work.start_rate)
    dissipation(body, comp, regime, start, work.start_rate, DYNAMIC)
    total = 0.0
    for m in range(SIZE - DYNAMIC):
        error = work.start_rate[DYNAMIC + m] / RADAU_GAMMA
        for i in range(STAGES):
            error += RADAU_DEFECT[i] * work.powers[i, m]
            value = 0.0
            for j in range(STAGES):
                value += RADAU_A[i, j] * work.powers[j, m]
            work.integrals[i, m] = h * value
        part = h * error / work.scale[DYNAMIC + m]
        total += part * part
    for m in range(DYNAMIC):
        stages = 0.0
        for i in range(STAGES):
            stages += RADAU_ERROR[i] * work.stages[i, m]
        work.error[m] = stages * RADAU_GAMMA / h
        work.trial[m] = work.start_rate[m] + work.error[m]
    size = filtered_square(work)
    if size + total > MEASURED:
        # filtered once more for stiff components (Hairer & Wanner, IV.8)
        for m in range(DYNAMIC):
            work.trial[m] = start[m] + work.side[m].real
        rates(body, comp, regime, work.trial, work.rates[0])
        for m in range(DYNAMIC):
            work.trial[m] = work.rates[0, m] + work.error[m]
        size = filtered_square(work)
    result = math.sqrt((size + total) / MEASURED)
    if not result < FAILED:
        return FAILED
    if result <= 1.0:  # for a light ring the estimate is too small
        result = max(result, ledger_error(body, comp, work, start, rtol))
    return result


def ledger_error(body, comp, work, start, rtol):
    """Return the error of the energy ledger over a step, relative to its tolerance."""
    end = work.trial
    for m in range(DYNAMIC):
        end[m] = start[m] + work.stages[STAGES - 1, m]
    lost = 0.0
    for m in range(SIZE - DYNAMIC):
        if m != X - DYNAMIC:
            lost += work.integrals[STAGES - 1, m]
    before, height = energies(body, comp, start)
    after, higher = energies(body, comp, end)
    gain = (after - before) + (higher - height) + lost - body.gt * work.integrals[STAGES - 1, X - DYNAMIC]
    rounding = (abs(end[VT]) + abs(end[VN]) + abs(end[OM])) * math.sqrt(after)
    return abs(gain) / (LEDGER * rtol * (1.0 + before + after) + ROUNDING * rounding)


def make_poly(work, start):
    """Write the dense output of the step to `work.poly`."""
    for m in range(SIZE):
        work.poly[m, 0] = start[m]
        for j in range(STAGES):
            total = 0.0
            for i in range(STAGES):
                increment = work.stages[i, m] if m < DYNAMIC else work.integrals[i, m - DYNAMIC]
                total += RADAU_POWERS[j, i] * increment
            work.poly[m, j + 1] = total
