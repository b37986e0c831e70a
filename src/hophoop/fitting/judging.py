"""What a fit is worth: goodness, correlations, the sequence's share, residuals that run together."""

from __future__ import annotations

from collections.abc import Collection
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.guess import gathered
from hophoop.fitting.problem import Problem
from hophoop.fitting.solving import Solution
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory

Floats = NDArray[np.float64]

CORRELATED = 0.95
RUNS = -4.0  # standard deviations by which residuals of one sign run together more than chance has it
FEWEST = 16  # residuals of a phase that are tested
DRAWS = 100


def correlations(solution: Solution, known: Collection[str] = ()) -> list[tuple[str, str, float]]:
    """Pairs of parameters that the data can hardly tell apart, the strongest first.

    Parameters
    ----------
    solution : Solution
    known : collection of str, optional
        Parameters of which more is known than the data say; two of these are no pair.

    Returns
    -------
    pairs : list of (str, str, float)
        With their correlation [1].
    """
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
    """Sequences that motions within the uncertainties have, with their shares.

    Parameters
    ----------
    problem : Problem
    solution : Solution
    scale : float
        By which the errors are enlarged [1].
    seed : int, default 0
        [1]

    Returns
    -------
    shares : dict of float
        By sequence, bounces in a row as one 'H+', the greatest first [1].
    """
    rng = np.random.default_rng(seed)
    found: dict[str, int] = {}
    covariance = solution.covariance * scale**2
    if not len(solution.free) or not np.isfinite(covariance).all():
        return {gathered(problem.motion(solution.values).sequence): 1.0}
    values, vectors = np.linalg.eigh(0.5 * (covariance + covariance.T))
    root = vectors * np.sqrt(np.maximum(values, 0.0))
    centre = np.array([solution.values[name] for name in solution.free])
    for _ in range(DRAWS):
        drawn = dict(solution.values) | dict(
            zip(solution.free, (centre + root @ rng.normal(size=len(centre))).tolist(), strict=True)
        )
        try:
            sequence = gathered(problem.motion(drawn).sequence)
        except InputError:
            continue
        found[sequence] = found.get(sequence, 0) + 1
    total = sum(found.values())
    if not total:
        return {gathered(problem.motion(solution.values).sequence): 1.0}
    return {name: number / total for name, number in sorted(found.items(), key=lambda item: -item[1])}


def runs(residuals: Floats) -> float:
    """How many standard deviations the number of runs of one sign is from chance (after Wald and Wolfowitz).

    Parameters
    ----------
    residuals : ndarray, shape (n,)
        [1]

    Returns
    -------
    deviation : float
        Negative where neighbours are alike; 0 where all have one sign by need [1].
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


def lacking(problem: Problem, motion: Trajectory, residuals: Floats) -> list[dict[str, Any]]:
    """Quantities and phases in which residuals run together, which says that the model lacks something there.

    Parameters
    ----------
    problem : Problem
    motion : Trajectory
    residuals : ndarray, shape (count,)
        [1]

    Returns
    -------
    places : list of dict
        ``quantity``, ``phase``, ``deviation`` of the number of runs, ``spread`` of the residuals.
    """
    modes = motion.at(np.clip(problem.t, 0.0, motion.duration)).mode
    found, begin = [], 0
    for channel in problem.channels:
        own = residuals[begin : begin + len(channel.rows)]
        begin += len(channel.rows)
        phase = np.array([PHASES[letter] for letter in modes[channel.rows]])
        for word in dict.fromkeys(phase.tolist()):
            part = own[phase == word]
            if len(part) >= FEWEST and (deviation := runs(part)) < RUNS:
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
    """The greatest abs(F)/N while the hoop rolls: friction that never slips must be at least this.

    Parameters
    ----------
    motion : Trajectory
    points : int, default 2000
        How many times are looked at [1].

    Returns
    -------
    friction : float
        [1]
    """
    state = motion.at(motion.times(points))
    rolling = (state.mode == "R") & (state.normal_force > 0)
    if not rolling.any():
        return 0.0
    return float(np.max(np.abs(state.friction_force[rolling]) / state.normal_force[rolling]))
