"""How uncertain the parameters are: outliers say little, and errors that last over several frames say the same again."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.channels import Channel
from hophoop.fitting.losses import influence, influence_slope
from hophoop.fitting.problem import Problem

Floats = NDArray[np.float64]

FEWEST = 30  # residuals of which the correlation of neighbours is taken
CERTAIN = 3.0  # standard deviations from which it is believed
LONGEST = 0.99  # correlation of neighbours at most


def covariance_of(problem: Problem, jacobian: Floats, residuals: Floats, soft: bool) -> Floats:
    """Covariance of parameters: A⁻¹ B A⁻¹ of an estimator whose equations have the slopes A and the variance B.

    With ψ the slope of half the loss, A = Jᵀ ψ' J with the residuals found, which is E[ψ'] times what the data would say
    without outliers, and B = E[ψ²] Jᵀ P J for residuals as large as the data say; P holds the correlations of errors in a
    quantity, ρ to the power of the number of frames between them.

    Parameters
    ----------
    problem : Problem
    jacobian : ndarray, shape (count, n)
    residuals : ndarray, shape (count,)
        At the minimum [standard deviations].
    soft : bool
        Whether outliers count less.

    Returns
    -------
    covariance : ndarray, shape (n, n)
        Infinite where the data say nothing [products of the parameters' units].
    """
    pulls, information, square = residuals, jacobian.T @ jacobian, 1.0
    if soft:
        nodes, weights = np.polynomial.hermite_e.hermegauss(40)
        weights = weights / weights.sum()
        pulls = influence(residuals)
        information = jacobian.T @ (influence_slope(residuals)[:, None] * jacobian)
        square, slope = float(weights @ influence(nodes) ** 2), float(weights @ influence_slope(nodes))
        information, square = information / slope, square / slope**2
    known = inverse(information)
    memory = memories(problem, pulls)
    if not any(memory.values()) or not np.isfinite(known).all():
        return known * square
    variance, begin = information.copy(), 0
    for channel in problem.channels:
        own = jacobian[begin : begin + len(channel.rows)]
        begin += len(channel.rows)
        variance += own.T @ _from_neighbours(channel, own, memory[channel.name])
    return known @ variance @ known * square


def memories(problem: Problem, pulls: Floats) -> dict[str, float]:
    """By how much the errors of neighbouring frames are alike.

    Parameters
    ----------
    problem : Problem
    pulls : ndarray, shape (count,)
        Residuals, or how much they pull [1].

    Returns
    -------
    correlations : dict of float
        By quantity: 0 where they are not alike beyond what chance has, or fewer than 30 [1].
    """
    result, begin = {}, 0
    for channel in problem.channels:
        own = pulls[begin : begin + len(channel.rows)]
        begin += len(channel.rows)
        pairs = np.flatnonzero(np.diff(channel.rows) == 1)
        size = float((own**2).mean()) if len(own) else 0.0
        alike = float((own[pairs] * own[pairs + 1]).mean() / size) if len(pairs) >= FEWEST and size > 0 else 0.0
        believed = alike * np.sqrt(max(len(pairs), 1)) > CERTAIN
        result[channel.name] = min(alike, LONGEST) if believed else 0.0
    return result


def _from_neighbours(channel: Channel, columns: Floats, alike: float) -> Floats:
    """P − 1 times columns, P_ij = ρ^|i − j|, by going through the frames once forwards and once backwards."""
    fading = alike ** np.diff(channel.rows).astype(float)
    before, after = np.zeros_like(columns), np.zeros_like(columns)
    for k in range(1, len(columns)):
        before[k] = fading[k - 1] * (before[k - 1] + columns[k - 1])
        after[-1 - k] = fading[-k] * (after[-k] + columns[-k])
    return before + after


def inverse(information: Floats) -> Floats:
    """The inverse, scaled so that units do not matter; infinite where there is nothing known.

    Parameters
    ----------
    information : ndarray, shape (n, n)
        [1 over products of the parameters' units]

    Returns
    -------
    covariance : ndarray, shape (n, n)
        [products of the parameters' units]
    """
    size = np.sqrt(np.maximum(np.diag(information), 1e-300))
    try:
        inverse = np.linalg.inv(information / np.outer(size, size))
    except np.linalg.LinAlgError:
        inverse = np.full_like(information, np.inf)
    return np.asarray(inverse / np.outer(size, size), dtype=float)
