"""Diagnostics of a fit: correlations, shares of sequences, runs of residuals."""

from __future__ import annotations

from collections.abc import Collection
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.guess import merge_bounces
from hophoop.fitting.problem import Problem
from hophoop.fitting.solving import Solution
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory

Floats = NDArray[np.float64]

CORRELATED = 0.95
RUNS = -4.0  # deviation of the runs test that shows a misfit
FEWEST = 16  # residuals of a phase for the test
DRAWS = 100


def correlations(solution: Solution, known: Collection[str] = ()) -> list[tuple[str, str, float]]:
    """Return pairs of parameters that the data hardly distinguish, the strongest first.

    known: parameters with priors; two of these are no pair; pairs: with their correlation [1].
    """
    with np.errstate(invalid="ignore"):  # a singular problem has negative variances
        size = np.sqrt(np.diag(solution.covariance))
    with np.errstate(divide="ignore", invalid="ignore"):
        matrix = solution.covariance / np.outer(size, size)
    names = solution.free
    pairs = [
        (names[i], names[j], float(matrix[i, j]))
        for i in range(len(names))
        for j in range(i)
        if abs(matrix[i, j]) > CORRELATED and not {names[i], names[j]} <= set(known)
    ]
    return sorted(pairs, key=lambda pair: -abs(pair[2]))


def shares(problem: Problem, solution: Solution, scale: float, seed: int = 0) -> dict[str, float]:
    """Return the sequences of motions within the uncertainties, with their shares.

    scale: factor of the errors [1]; shares: by sequence, bounces in a row as one 'H+', the largest first [1].
    """
    rng = np.random.default_rng(seed)
    found: dict[str, int] = {}
    covariance = solution.covariance * scale**2
    if not len(solution.free) or not np.isfinite(covariance).all():
        return {merge_bounces(problem.motion(solution.values).sequence): 1.0}
    values, vectors = np.linalg.eigh(0.5 * (covariance + covariance.T))
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    centre = np.array([solution.values[name] for name in solution.free])
    for _ in range(DRAWS):
        drawn = dict(solution.values) | dict(
            zip(solution.free, (centre + root @ rng.normal(size=len(centre))).tolist(), strict=True)
        )
        try:
            sequence = merge_bounces(problem.motion(drawn).sequence)
        except InputError:
            continue
        found[sequence] = found.get(sequence, 0) + 1
    total = sum(found.values())
    if not total:
        return {merge_bounces(problem.motion(solution.values).sequence): 1.0}
    return {name: number / total for name, number in sorted(found.items(), key=lambda item: -item[1])}


def runs_deviation(residuals: Floats) -> float:
    """Return the deviation of the number of runs of one sign from its expectation (Wald–Wolfowitz test).

    residuals shape (n,) [1]; deviation: negative if neighbours are alike; 0 if all must have one sign [standard deviations].
    """
    signs = residuals > 0
    above, below = int(signs.sum()), int((~signs).sum())
    count = above + below
    if above == 0 or below == 0:
        return -np.sqrt(count) if count > 1 else 0.0
    usual = 2.0 * above * below / count + 1.0
    spread = np.sqrt(max((usual - 1.0) * (usual - 2.0) / (count - 1.0), 1e-12))
    return float((sum(1 for _ in groupby(signs)) - usual) / spread)


PHASES = {"R": "rolling", "S": "slip", "K": "slip", "H": "flight", "M": "skimming"}
WORDS = {"x": "x", "y": "y", "angle": "the angle", "marker_x": "x of the marker", "marker_y": "y of the marker"}


def misfits(problem: Problem, motion: Trajectory, residuals: Floats) -> list[dict[str, Any]]:
    """Return quantities and phases in which residuals have too few runs: the model lacks something there.

    residuals shape (count,) [1]; places: ``quantity``, ``phase``, ``deviation`` of the number of runs, ``spread`` of the
    residuals.
    """
    modes = motion.at(np.clip(problem.t, 0.0, motion.duration)).mode
    found, begin = [], 0
    for channel in problem.channels:
        own = residuals[begin : begin + len(channel.rows)]
        begin += len(channel.rows)
        phase = np.array([PHASES[letter] for letter in modes[channel.rows]])
        for word in dict.fromkeys(phase.tolist()):
            part = own[phase == word]
            if len(part) >= FEWEST and (deviation := runs_deviation(part)) < RUNS:
                found.append(
                    {
                        "quantity": channel.name,
                        "phase": word,
                        "deviation": deviation,
                        "spread": float(np.sqrt((part**2).mean())),
                    }
                )
    return found


def least_static_friction(motion: Trajectory, points: int = 2000) -> float:
    """Return the maximum of abs(F)/N while the hoop rolls, the friction that it needs at least.

    points: number of times [1].
    """
    state = motion.at(motion.times(points))
    rolling = (state.mode == "R") & (state.normal_force > 0)
    if not rolling.any():
        return 0.0
    return float(np.max(np.abs(state.friction_force[rolling]) / state.normal_force[rolling]))
