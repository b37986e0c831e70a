"""Covariance of the parameters, with robust loss and correlated errors."""

from __future__ import annotations

import numpy as np

from hophoop.fitting.channels import Floats
from hophoop.fitting.losses import influence
from hophoop.fitting.problem import Problem

FEWEST = 30  # residuals for an estimate of the autocorrelation
CERTAIN = 3.0  # standard deviations of a significant autocorrelation
FIRST = 5  # lags that are tested
LONGEST = 0.98  # maximum correlation of errors from one frame to the next
ROUNDING = 1e-6  # mean square of residuals that are rounding
WINDOW = 5.0  # lags that are summed, over the sum: later ones add chance
ROBUST = 1.05  # variance with the robust loss over that of least squares, for normal errors


def covariance_of(problem: Problem, jacobian: Floats, residuals: Floats) -> Floats:
    """Covariance of parameters: A⁻¹ B A⁻¹ of equations with the slopes A = Jᵀ J and the variance B = Jᵀ D J.

    D has for each number how many of them have the information of one of independent errors.

    jacobian: shape (count, n); residuals: shape (count,), at the minimum [standard deviations]; covariance: shape (n, n),
    infinite where the data have no information [products of the parameters' units].
    """
    known, memory = inverse(jacobian.T @ jacobian), np.ones(len(jacobian))
    for piece, frames in zip(problem.pieces, correlated_frames(problem, residuals), strict=True):
        memory[piece.part] = frames
    if (memory > 1.0).any() and np.isfinite(known).all():
        known = known @ (jacobian.T @ (memory[:, None] * jacobian)) @ known
    return known * (ROBUST if problem.robust else 1.0)


def correlated_frames(problem: Problem, residuals: Floats) -> list[float]:
    """Return for each of the problem's pieces the number of frames with the information of one of independent errors [1].

    residuals: shape (count,) [standard deviations]; frames: at least the channel's.
    """
    result, pulls = [], influence(residuals) if problem.robust else residuals
    for _, channel, part in problem.pieces:
        own = np.full(int(channel.rows[-1] - channel.rows[0]) + 1, np.nan)
        own[channel.rows - channel.rows[0]] = pulls[part]
        result.append(max(autocorrelation_time(own), channel.frames))
    return result


def autocorrelation_time(values: Floats) -> float:
    """Return the sum of the autocorrelations at all lags, by Sokal's window; 1 if it is not significant [frames].

    values: shape (n,), nan where missing.
    """
    count, size = int(np.isfinite(values).sum()), float(np.nanmean(values**2))
    if count < FEWEST or size < ROUNDING:
        return 1.0
    pairs = [values[lag:] * values[:-lag] for lag in range(1, count // 4)]
    # where every second frame is missing, only even lags have pairs
    alike = np.array([np.nanmean(both) / size for both in pairs if np.isfinite(both).any()])
    lags = np.arange(1, len(alike) + 1)
    early = alike[:FIRST]
    if max(early[0] * np.sqrt(count), early.mean() * np.sqrt(FIRST * count)) < CERTAIN:
        return 1.0
    sums = 1.0 + 2.0 * np.cumsum(alike)
    until = int(np.argmax([*(lags[:-1] >= WINDOW * sums[:-1]), True]))
    # if all of the errors fade at one rate, the first lag gives their sum; that of residuals is too small
    first = float(np.clip(early[0], 0.0, LONGEST))
    return max(float(sums[until]), (1.0 + first) / (1.0 - first))


def inverse(information: Floats) -> Floats:
    """Return the inverse, scaled so that units do not matter; infinite where nothing is known.

    information shape (n, n) [1 over products of the parameters' units]; covariance shape (n, n) [products of the parameters'
    units].
    """
    size = np.sqrt(np.maximum(np.diag(information), 1e-300))
    try:
        inverse = np.linalg.inv(information / np.outer(size, size))
        known = bool((np.diag(inverse) > 0.0).all())  # rounding makes a nearly singular matrix indefinite
    except np.linalg.LinAlgError:
        known = False
    if not known:
        inverse = np.full_like(information, np.inf)
    return np.asarray(inverse / np.outer(size, size), dtype=float)
