"""Diagnostics of a fit: correlations, shares of sequences, runs of residuals."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.covariance import ROUNDING
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
PHASES = {"R": "rolling", "S": "slip", "K": "slip", "H": "flight", "M": "skimming"}
WORDS = {
    "x": "x",
    "y": "y",
    "angle": "the angle",
    "marker_x": "x of the marker",
    "marker_y": "y of the marker",
    "omega": "the angular velocity",
}


def correlations(solution: Solution, known: Collection[str] = ()) -> list[tuple[str, str, float]]:
    """Return pairs of parameters that the data hardly distinguish, with their correlation [1], the strongest first.

    known: parameters with priors; two of these are no pair.
    """
    with np.errstate(divide="ignore", invalid="ignore"):  # a singular problem has negative variances
        size = np.sqrt(np.diag(solution.covariance))
        matrix = solution.covariance / np.outer(size, size)
    names = solution.free
    pairs = [
        (names[i], names[j], float(matrix[i, j]))
        for i in range(len(names))
        for j in range(i)
        if abs(matrix[i, j]) > CORRELATED and not {names[i], names[j]} <= set(known)
    ]
    return sorted(pairs, key=lambda pair: -abs(pair[2]))


def sequence_of(problem: Problem, values: Mapping[str, float]) -> str:
    """Return the sequence of each run, bounces in a row as one 'H+'."""
    return ", ".join(merge_bounces(motion.sequence) for motion in problem.motions(values))


def shares(problem: Problem, solution: Solution, scale: float, seed: int = 0) -> dict[str, float]:
    """Return the sequences of motions within the uncertainties, with their shares [1], the largest first.

    scale: factor of the errors [1].
    """
    values = solution.minimum.values
    covariance = solution.covariance * scale**2
    drawn: list[dict[str, float]] = []
    if solution.free and np.isfinite(covariance).all():
        place = np.array([values[name] for name in solution.free])
        rng = np.random.default_rng(seed)
        places = rng.multivariate_normal(place, covariance, DRAWS, check_valid="ignore", method="eigh")
        drawn = [values | dict(zip(solution.free, place.tolist(), strict=True)) for place in places]
    found: dict[str, int] = {}
    for one in (*drawn, values):
        try:
            sequence = sequence_of(problem, one)
        except InputError:
            continue
        found[sequence] = found.get(sequence, 0) + 1
    total = sum(found.values())
    return {name: number / total for name, number in sorted(found.items(), key=lambda item: -item[1])}


def runs_deviation(residuals: Floats) -> float:
    """Return the deviation of the number of runs of one sign from its expectation (Wald–Wolfowitz test).

    deviation: negative if neighbours are alike; 0 if all must have one sign [standard deviations].
    """
    signs = residuals > 0
    above, below = int(signs.sum()), int((~signs).sum())
    count = above + below
    if above == 0 or below == 0:
        return -np.sqrt(count) if count > 1 else 0.0
    usual = 2.0 * above * below / count + 1.0
    spread = np.sqrt(max((usual - 1.0) * (usual - 2.0) / (count - 1.0), 1e-12))
    return float((sum(1 for _ in groupby(signs)) - usual) / spread)


def misfits(problem: Problem, motions: list[Trajectory], residuals: Floats) -> list[dict[str, Any]]:
    """Return quantities and phases in which residuals have too few runs: the model lacks something there.

    places: ``run``, ``quantity``, ``phase``, ``deviation`` of the number of runs, ``spread`` of the residuals.
    """
    found = []
    for k, channel, piece in problem.pieces:
        modes = motions[k].at(np.clip(problem.runs[k].t[channel.rows], 0.0, motions[k].duration)).mode
        phase = np.array([PHASES[letter] for letter in modes])
        for word in dict.fromkeys(phase.tolist()):
            part = residuals[piece][phase == word]
            if len(part) >= FEWEST and (part**2).mean() > ROUNDING and (deviation := runs_deviation(part)) < RUNS:
                spread = float(np.sqrt((part**2).mean()))
                found.append({"run": k, "quantity": channel.name, "phase": word, "deviation": deviation, "spread": spread})
    return found


def least_static_friction(motion: Trajectory, points: int = 2000) -> float:
    """Return the maximum of abs(F)/N while the hoop rolls, the friction that it needs at least."""
    state = motion.at(motion.times(points))
    rolling = (state.mode == "R") & (state.normal_force > 0)
    if not rolling.any():
        return 0.0
    return float(np.max(np.abs(state.friction_force[rolling]) / state.normal_force[rolling]))
