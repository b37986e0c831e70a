"""One step of the implicit method: simplified Newton iteration, error estimate, dense output."""

from __future__ import annotations

import math

from hophoop._jit import jit
from hophoop.compliant.motion import jacobian, powers, rates, stored
from hophoop.compliant.records import DYNAMIC, MEASURED, OM, SIZE, VN, VT, X
from hophoop.compliant.tableau import (
    DEFECT,
    ERROR,
    FROM_PAIR,
    FROM_REAL,
    GAMMA,
    LAMBDA,
    NODES,
    PAIRS,
    POWERS,
    STAGES,
    TO_PAIR,
    TO_REAL,
    A,
)

ITERATIONS = 10
NEWTON = 1e-3  # of the tolerance: what Newton's iteration may leave
LEDGER = 0.1  # of rtol: how much of the energy a step may leave out of the ledger
ROUNDING = 4e-16  # of an energy, beside the speeds that it is a difference of
FAILED = 1e300  # an error that no step may have


@jit
def factor(matrix, pivots):
    """LU factors of a small matrix in place, with partial pivoting; False where it is singular."""
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
            for j in range(n):
                matrix[k, j], matrix[best, j] = matrix[best, j], matrix[k, j]
        inverse = 1.0 / matrix[k, k]
        for i in range(k + 1, n):
            matrix[i, k] *= inverse
            for j in range(k + 1, n):
                matrix[i, j] -= matrix[i, k] * matrix[k, j]
    return True


@jit
def solve(matrix, pivots, side):
    """Solve with the factors, in place."""
    n = matrix.shape[0]
    for k in range(n):
        best = pivots[k]
        if best != k:
            side[k], side[best] = side[best], side[k]
    for i in range(1, n):
        for j in range(i):
            side[i] -= matrix[i, j] * side[j]
    for i in range(n - 1, -1, -1):
        for j in range(i + 1, n):
            side[i] -= matrix[i, j] * side[j]
        side[i] /= matrix[i, i]


@jit
def predict(work, begin, stretch):
    """Start Newton's iteration from the polynomial in `work.poly`: its values at begin + stretch c_i."""
    for m in range(DYNAMIC):
        base = poly_value(work.poly, m, begin)
        for i in range(STAGES):
            work.stages[i, m] = poly_value(work.poly, m, begin + stretch * NODES[i]) - base


@jit
def poly_value(poly, m, s):
    """Variable m of the dense output."""
    result = poly[m, STAGES]
    for j in range(STAGES - 1, -1, -1):
        result = result * s + poly[m, j]
    return result


@jit
def form_of(work):
    """The stages in the eigenvectors of A⁻¹."""
    for m in range(DYNAMIC):
        total = 0.0
        for i in range(STAGES):
            total += TO_REAL[i] * work.stages[i, m]
        work.real_form[m] = total
        for k in range(PAIRS):
            pair = 0.0j
            for i in range(STAGES):
                pair += TO_PAIR[k, i] * work.stages[i, m]
            work.pair_form[k, m] = pair


@jit
def newton(body, comp, regime, work, start, h):
    """Solve for the stages; True if the iteration converged."""
    form_of(work)
    before = 0.0
    rate = 0.9
    for iteration in range(ITERATIONS):
        for i in range(STAGES):
            for m in range(DYNAMIC):
                work.trial[m] = start[m] + work.stages[i, m]
            rates(body, comp, regime, work.trial, work.rates[i])
        size = 0.0
        for m in range(DYNAMIC):
            total = 0.0
            for i in range(STAGES):
                total += TO_REAL[i] * work.rates[i, m]
            work.real_side[m] = total - GAMMA / h * work.real_form[m]
        solve(work.real, work.real_pivots, work.real_side)
        for m in range(DYNAMIC):
            work.real_form[m] += work.real_side[m]
            size += (work.real_side[m] / work.scale[m]) ** 2
        for k in range(PAIRS):
            eigenvalue = LAMBDA[k] / h
            for m in range(DYNAMIC):
                pair = 0.0j
                for i in range(STAGES):
                    pair += TO_PAIR[k, i] * work.rates[i, m]
                work.pair_side[m] = pair - eigenvalue * work.pair_form[k, m]
            solve(work.pairs[k], work.pair_pivots[k], work.pair_side)
            for m in range(DYNAMIC):
                work.pair_form[k, m] += work.pair_side[m]
                part = work.pair_side[m] / work.scale[m]
                size += part.real * part.real + part.imag * part.imag
        for i in range(STAGES):
            for m in range(DYNAMIC):
                total = FROM_REAL[i] * work.real_form[m]
                for k in range(PAIRS):
                    total += (FROM_PAIR[i, k] * work.pair_form[k, m]).real
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
            if rate < 1.0 and rate ** (ITERATIONS - 1 - iteration) / (1.0 - rate) * size > NEWTON:
                return False
        if size <= 1e-2 * NEWTON:
            return True
        before = size
    return False


@jit
def attempt(body, comp, regime, work, start, h, rtol):
    """Try a step of length h from `start`, with `work.stages` as the first guess.

    Leaves the stages, the integrals and the dense output in `work`; returns the error over the tolerance,
    FAILED where Newton's iteration does not converge.
    """
    for m in range(SIZE):
        work.scale[m] = rtol * (work.atol[m] + abs(start[m]))
    jacobian(body, comp, regime, start, work.jacobian)
    for i in range(DYNAMIC):
        for j in range(DYNAMIC):
            work.real[i, j] = -work.jacobian[i, j]
            for k in range(PAIRS):
                work.pairs[k, i, j] = -work.jacobian[i, j]
        work.real[i, i] += GAMMA / h
        for k in range(PAIRS):
            work.pairs[k, i, i] += LAMBDA[k] / h
    if not factor(work.real, work.real_pivots):
        return FAILED
    for k in range(PAIRS):
        if not factor(work.pairs[k], work.pair_pivots[k]):
            return FAILED
    if not newton(body, comp, regime, work, start, h):
        return FAILED
    # the integrals, by the same collocation
    for i in range(STAGES):
        for m in range(DYNAMIC):
            work.trial[m] = start[m] + work.stages[i, m]
        powers(body, comp, regime, work.trial, work.powers[i], 0)
    rates(body, comp, regime, start, work.start_rate)
    powers(body, comp, regime, start, work.start_rate, DYNAMIC)
    total = 0.0
    for m in range(SIZE - DYNAMIC):
        error = work.start_rate[DYNAMIC + m] / GAMMA
        for i in range(STAGES):
            error += DEFECT[i] * work.powers[i, m]
            value = 0.0
            for j in range(STAGES):
                value += A[i, j] * work.powers[j, m]
            work.integrals[i, m] = h * value
        total += (h * error / work.scale[DYNAMIC + m]) ** 2
    for m in range(DYNAMIC):
        stages = 0.0
        for i in range(STAGES):
            stages += ERROR[i] * work.stages[i, m]
        work.error[m] = stages * GAMMA / h
        work.real_side[m] = work.start_rate[m] + work.error[m]
    solve(work.real, work.real_pivots, work.real_side)
    size = 0.0
    for m in range(DYNAMIC):
        size += (work.real_side[m] / work.scale[m]) ** 2
    if size + total > MEASURED:
        # filtered once more, which stiff components need (Hairer & Wanner, IV.8)
        for m in range(DYNAMIC):
            work.trial[m] = start[m] + work.real_side[m]
        rates(body, comp, regime, work.trial, work.real_side)
        for m in range(DYNAMIC):
            work.real_side[m] += work.error[m]
        solve(work.real, work.real_pivots, work.real_side)
        size = 0.0
        for m in range(DYNAMIC):
            size += (work.real_side[m] / work.scale[m]) ** 2
    result = math.sqrt((size + total) / MEASURED)
    if not result < FAILED:
        return FAILED
    if result <= 1.0:  # of a light ring the estimate says too little
        result = max(result, ledger_error(body, comp, work, start, rtol))
    return result


@jit
def ledger_error(body, comp, work, start, rtol):
    """What the ledger does not close by over a step, over its tolerance."""
    end = work.trial
    for m in range(DYNAMIC):
        end[m] = start[m] + work.stages[STAGES - 1, m]
    lost = 0.0
    for m in range(SIZE - DYNAMIC):
        if m != X - DYNAMIC:
            lost += work.integrals[STAGES - 1, m]
    before, height = stored(body, comp, start)
    after, higher = stored(body, comp, end)
    gain = (after - before) + (higher - height) + lost - body.gt * work.integrals[STAGES - 1, X - DYNAMIC]
    rounding = (abs(end[VT]) + abs(end[VN]) + abs(end[OM])) * math.sqrt(after)
    return abs(gain) / (LEDGER * rtol * (1.0 + before + after) + ROUNDING * rounding)


@jit
def make_poly(work, start):
    """Write the dense output of the step in the stages to `work.poly`."""
    for m in range(SIZE):
        work.poly[m, 0] = start[m]
        for j in range(STAGES):
            total = 0.0
            for i in range(STAGES):
                increment = work.stages[i, m] if m < DYNAMIC else work.integrals[i, m - DYNAMIC]
                total += POWERS[j, i] * increment
            work.poly[m, j + 1] = total
