"""Diagnostics of a fit: correlations, shares of sequences, runs of residuals."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence
from contextlib import suppress
from typing import Any

import numpy as np

from hophoop.fitting.channels import Floats, Values
from hophoop.fitting.covariance import ROUNDING
from hophoop.fitting.problem import Problem
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory

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


def correlations(names: Sequence[str], covariance: Floats, known: Collection[str]) -> list[tuple[str, str, float]]:
    """Return pairs of parameters that the data hardly distinguish, with their correlation [1], the strongest first.

    names: of the covariance; known: parameters with priors; two of these are no pair.
    """
    with np.errstate(divide="ignore", invalid="ignore"):  # a singular problem has negative variances
        size = np.sqrt(np.diag(covariance))
        matrix = covariance / np.outer(size, size)
    strong = np.argwhere(np.abs(np.tril(matrix, -1)) > CORRELATED)
    pairs = [(names[i], names[j], float(matrix[i, j])) for i, j in strong if not {names[i], names[j]} <= set(known)]
    return sorted(pairs, key=lambda pair: -abs(pair[2]))


def shares(problem: Problem, values: Values, free: Sequence[str], covariance: Floats) -> Values:
    """Return the sequences of motions within the uncertainties, with their shares [1], the largest first.

    free: names of the covariance.
    """
    drawn: list[Values] = []
    if free and np.isfinite(covariance).all():
        place, rng = [values[name] for name in free], np.random.default_rng(0)
        places = rng.multivariate_normal(place, covariance, DRAWS, check_valid="ignore", method="eigh")
        drawn = [values | dict(zip(free, place.tolist(), strict=True)) for place in places]
    found: Counter[str] = Counter()
    for one in (*drawn, values):
        with suppress(InputError):
            found[problem.sequence(one)] += 1
    return {name: number / found.total() for name, number in found.most_common()}


def runs_deviation(residuals: Floats) -> float:
    """Return the deviation of the number of runs of one sign from its expectation (Wald–Wolfowitz test).

    deviation: negative if neighbours are alike [standard deviations].
    """
    signs = residuals > 0
    count, above = len(signs), int(signs.sum())
    if above in (0, count):
        return -float(np.sqrt(count))
    usual = 2.0 * above * (count - above) / count + 1.0
    spread = np.sqrt(max((usual - 1.0) * (usual - 2.0) / (count - 1.0), 1e-12))
    return float((1 + np.count_nonzero(np.diff(signs)) - usual) / spread)


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
            square, deviation = float((part**2).mean()), runs_deviation(part)
            if len(part) >= FEWEST and square > ROUNDING and deviation < RUNS:
                spread = square**0.5
                found.append({"run": k, "quantity": channel.name, "phase": word, "deviation": deviation, "spread": spread})
    return found
