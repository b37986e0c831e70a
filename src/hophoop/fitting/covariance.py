"""Covariance of the parameters, with robust loss and correlated errors."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.fitting.channels import LONGEST, NONE, Autocorrelation, Channel
from hophoop.fitting.losses import influence, influence_slope
from hophoop.fitting.problem import Problem

Floats = NDArray[np.float64]

FEWEST = 30  # residuals for an estimate of the autocorrelation
CERTAIN = 3.0  # standard deviations of a significant autocorrelation
FIRST = 5  # lags that are tested


def covariance_of(problem: Problem, jacobian: Floats, residuals: Floats, robust: bool) -> Floats:
    """Covariance of parameters: A⁻¹ B A⁻¹ of an estimator whose equations have the slopes A and the variance B.

    ψ is the slope of half the loss. A = Jᵀ ψ' J with the residuals, and B = E[ψ²] Jᵀ P J for residuals as large as the data's
    errors. P has the correlations of errors in a quantity.

    jacobian: shape (count, n); residuals: shape (count,), at the minimum [standard deviations]; robust: whether outliers count
    less; covariance: shape (n, n), infinite where the data have no information [products of the parameters' units].
    """
    information, square = jacobian.T @ jacobian, 1.0
    if robust:
        nodes, weights = np.polynomial.hermite_e.hermegauss(40)
        weights = weights / weights.sum()
        information = jacobian.T @ (influence_slope(residuals)[:, None] * jacobian)
        square, slope = float(weights @ influence(nodes) ** 2), float(weights @ influence_slope(nodes))
        information, square = information / slope, square / slope**2
    known = inverse(information)
    memory = autocorrelations(problem, residuals, robust)
    if not any(one.share for one in memory) or not np.isfinite(known).all():
        return known * square
    variance = information.copy()
    for piece, one in zip(problem.pieces, memory, strict=True):
        own = jacobian[piece.part]
        variance += own.T @ _from_neighbours(piece.channel, own, one)
    return known @ variance @ known * square


def autocorrelations(problem: Problem, residuals: Floats, robust: bool) -> list[Autocorrelation]:
    """Autocorrelation of the errors of each of the problem's pieces.

    residuals: shape (count,) [standard deviations]; robust: whether outliers count less; autocorrelations: that of the channel
    if none is significant, or with fewer than 30 residuals [1].
    """
    result, pulls = [], influence(residuals) if robust else residuals
    for _, channel, part in problem.pieces:
        own = np.full(int(channel.rows[-1] - channel.rows[0]) + 1, np.nan)
        own[channel.rows - channel.rows[0]] = pulls[part]
        result.append(max(_autocorrelation_of(own), channel.autocorrelation, key=lambda one: one.frames))
    return result


def _autocorrelation_of(values: Floats) -> Autocorrelation:
    """Estimate from the sum of the correlations up to the first pair of lags without any, and the lag of its middle."""
    known = np.isfinite(values)
    count, size = int(known.sum()), float(np.nanmean(values**2))
    if count < FEWEST or not size > 0:
        return NONE
    alike = []
    for lag in range(1, max(count // 4, FIRST + 1)):
        both = values[lag:] * values[:-lag]
        alike.append(float(np.nanmean(both)) / size if np.isfinite(both).sum() >= FEWEST // 2 else 0.0)
    first = float(np.mean(alike[:FIRST]))
    if max(alike[0] * np.sqrt(count), first * np.sqrt(FIRST * count)) < CERTAIN or first <= 0.0:
        return NONE
    pairs = np.array(alike[: len(alike) // 2 * 2]).reshape(-1, 2).sum(axis=1)
    gone = pairs <= np.sqrt(2.0 / count)  # the level of chance
    until = 2 * (int(np.argmax(gone)) if gone.any() else len(pairs))
    kept = np.array(alike[: max(until, 1)])
    whole = float(kept.sum())
    fade = float(np.clip(1.0 - whole / float((np.arange(1, len(kept) + 1) * kept).sum()), 0.05, LONGEST))
    share = Autocorrelation(float(np.clip(whole * (1.0 - fade) / fade, 0.0, 1.0)), fade)
    # if all of it fades, the first lag gives the rate; the sum is cut at the level of chance and a little too small
    all_of_it = Autocorrelation(1.0, float(np.clip(alike[0], 0.0, LONGEST)))
    return max(share, all_of_it, key=lambda one: one.frames)


def _from_neighbours(channel: Channel, columns: Floats, memory: Autocorrelation) -> Floats:
    """Return (P − 1) times columns, P_ij = share × fade^|i − j|."""
    rows = channel.rows - channel.rows[0]
    whole = np.zeros((rows[-1] + 1, columns.shape[1]))
    whole[rows] = columns
    fading = memory.share * memory.fade ** np.arange(len(whole), dtype=float)
    fading[0] = 0.0
    return np.asarray(need("scipy.linalg", "fit").matmul_toeplitz(fading, whole)[rows])


def inverse(information: Floats) -> Floats:
    """Return the inverse, scaled so that units do not matter; infinite where nothing is known.

    information shape (n, n) [1 over products of the parameters' units]; covariance shape (n, n) [products of the parameters'
    units].
    """
    size = np.sqrt(np.maximum(np.diag(information), 1e-300))
    try:
        inverse = np.linalg.inv(information / np.outer(size, size))
    except np.linalg.LinAlgError:
        inverse = np.full_like(information, np.inf)
    return np.asarray(inverse / np.outer(size, size), dtype=float)
