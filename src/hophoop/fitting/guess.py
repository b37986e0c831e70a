"""Starts of a fit: a guess from the data, and the best of many motions drawn around it, for each sequence."""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.problem import Problem
from hophoop.scenario import InputError

Floats = NDArray[np.float64]

WIDTH = 0.05  # of the pieces for velocities [s]
LEAST = 5  # minimum frames of such a piece
FIRST = 8  # minimum frames for the start
SLIPS = 4.0  # significant slip over its standard deviation
DRAWS = 160
A_SEQUENCE = 2  # starts of each sequence
SEQUENCES = 4


class Rates(NamedTuple):
    """A quantity and its rate, from parabolas through pieces of the data."""

    t: Floats
    value: Floats
    rate: Floats
    error: Floats  # of the rate


def rates(t: Floats, values: Floats, errors: Floats) -> Rates:
    """Return values and rates at times, from a parabola through the data around each.

    t, values, errors: shape (n,), times [s], data and their standard deviations [1].
    """
    step = float(np.median(np.diff(t)))
    half = max(LEAST // 2, round(0.5 * WIDTH / step))
    rows = []
    for k in range(len(t)):
        near = slice(max(0, k - half), min(len(t), k + half + 1))
        at, weight = t[near] - t[k], 1.0 / errors[near]
        design = np.column_stack([np.ones_like(at), at, at**2]) * weight[:, None]
        inverse = np.linalg.pinv(design.T @ design)
        found = inverse @ (design.T @ (values[near] * weight))
        rows.append((found[0], found[1], float(np.sqrt(max(inverse[1, 1], 0.0)))))
    table = np.array(rows)
    return Rates(t, table[:, 0], table[:, 1], table[:, 2])


def rates_of(problem: Problem, name: str) -> Rates | None:
    """Return the rates of a channel.

    rates: None if it was not measured.
    """
    for channel in problem.channels:
        if channel.name == name and len(channel.rows) >= LEAST:
            return rates(problem.t[channel.rows], channel.values, channel.errors)
    return None


def start_kind(problem: Problem) -> str:
    """Return the kind of motion in the first frame.

    start: 'rolling' unless the data contradict it.
    """
    x, angle, y = (initial_rate(problem, name) for name in ("x", "angle", "y"))
    if x is None or angle is None:
        return "rolling"
    if y is not None:
        gap = y.values[:3] - problem.radius
        if (gap > 6.0 * y.errors[:3]).all() and (gap > 3e-3 * problem.radius).all():
            return "flying"
    slip = x.rate - problem.radius * angle.rate
    error = float(np.hypot(x.error, problem.radius * angle.error))
    return "sliding" if abs(slip) > max(SLIPS * error, 0.03 * abs(x.rate)) else "rolling"


class InitialRate(NamedTuple):
    """A quantity and its rate in the first frame, from a parabola through the first frames."""

    value: float
    rate: float
    error: float  # of the rate
    values: Floats  # data of the first frames
    errors: Floats


def initial_rate(problem: Problem, name: str) -> InitialRate | None:
    """Return value and rate of a quantity in the first frame.

    name: of a channel; rate: None if it was not measured.
    """
    for channel in problem.channels:
        if channel.name == name and len(channel.rows) >= LEAST:
            t = problem.t[channel.rows]
            count = max(FIRST, int(np.searchsorted(t, t[0] + WIDTH)))
            at, weight = t[:count], 1.0 / channel.errors[:count]
            design = np.column_stack([np.ones_like(at), at, at**2]) * weight[:, None]
            inverse = np.linalg.pinv(design.T @ design)
            found = inverse @ (design.T @ (channel.values[:count] * weight))
            error = float(np.sqrt(max(inverse[1, 1], 0.0)))
            return InitialRate(float(found[0]), float(found[1]), error, channel.values[:count], channel.errors[:count])
    return None


def guess(problem: Problem, values: dict[str, float]) -> dict[str, float]:
    """Guess parameters from the data: the start from the first frames, the share of the load from the energy in rolling.

    values: known and default values.
    """
    result = dict(values)
    x, y, angle = (rates_of(problem, name) for name in ("x", "y", "angle"))
    if x is None and (marker := rates_of(problem, "marker_x")) is not None:
        travel = np.polyfit(marker.t, marker.value, 1)  # the marker revolves about the centre
        x = Rates(
            marker.t,
            np.asarray(np.polyval(travel, marker.t), dtype=float),
            np.full(len(marker.t), travel[0]),
            np.full(len(marker.t), 1.0),
        )
    if x is not None:
        first = initial_rate(problem, "x")
        place, rate = (float(x.value[0]), float(x.rate[0])) if first is None else (first.value, first.rate)
        result |= {"x0": place, "speed": rate, "vx0": rate}
    if "tilt" in values and x is not None and y is not None and not values["tilt"] and np.ptp(x.value) > problem.radius:
        line = np.polyfit(x.value, y.value, 1)
        if abs(line[0]) > 1e-3:
            result["tilt"] = float(np.arctan(line[0]))
    if y is not None:
        above = initial_rate(problem, "y")
        if above is not None:
            result |= {"height0": max(above.value - problem.radius, 0.0), "vy0": above.rate}
        result["origin_y"] = float(np.quantile(y.value, 0.1)) - problem.radius if "origin_y" in values else 0.0
    if angle is not None:
        turning = initial_rate(problem, "angle")
        assert turning is not None
        result |= {"angle0": turning.value - values["marker_angle"], "omega0": turning.rate}
        if x is None:
            result["speed"] = problem.radius * result["omega0"]
        found = share_of_load(problem, angle, x, result)
        if found is not None and "gamma" in result:
            result["gamma"] = found
        elif found is not None and "eccentricity" in result:
            result |= {"eccentricity": found, "inertia_ratio": 1.0 - found**2}
    return {name: result[name] for name in values}


def share_of_load(problem: Problem, angle: Rates, x: Rates | None, values: dict[str, float]) -> float | None:
    """Return γ from the conserved energy while the hoop rolls: (1 + γ cosθ) R²θ̇² + γ g R cos(θ + β) − g R θ sinβ.

    x: to detect rolling; values: slope and angle of the marker; gamma: None if the data do not determine it [1].
    """
    radius, gravity = problem.radius, problem.plane.gravity
    theta, slope = angle.value - values["marker_angle"], values["slope"]
    rolls = np.ones(len(theta), dtype=bool)
    if x is not None:
        slip = np.interp(angle.t, x.t, x.rate) - radius * angle.rate
        error = np.hypot(np.interp(angle.t, x.t, x.error), radius * angle.error)
        broken = np.flatnonzero(np.abs(slip) > SLIPS * error + 0.02 * np.abs(radius * angle.rate))
        rolls[broken[0] if len(broken) else len(rolls) :] = False
    if rolls.sum() < 8:
        return None
    square = (radius * angle.rate[rolls]) ** 2
    turning, sinking = np.cos(theta[rolls]) * square, gravity * radius * np.cos(theta[rolls] + slope)
    known = gravity * radius * theta[rolls] * np.sin(slope) - square
    design = np.column_stack([turning + sinking, -np.ones(rolls.sum())])
    found, _, rank, _ = np.linalg.lstsq(design, known, rcond=None)
    return float(np.clip(found[0], 0.05, 0.95)) if rank == 2 else None


def merge_bounces(sequence: str) -> str:
    """Merge bounces in a row into one 'H+': their number depends on the last digit."""
    return re.sub("HH+", "H+", sequence)


class Candidate(NamedTuple):
    """Start of a fit."""

    values: dict[str, float]
    sequence: str
    cost: float


def candidates(problem: Problem, first: dict[str, float], free: set[str], seed: int = 0) -> list[Candidate]:
    """Return the best motions of each sequence, of many drawn around a guess.

    The sum of squares has a basin for each sequence, and descent from one basin does not lead into another.

    first: the guess; free: parameters that may differ from it; seed: seed of the draws [1]; candidates: the best first.
    """
    rng = np.random.default_rng(seed)
    measured = {channel.name for channel in problem.channels}
    found: list[Candidate] = []
    for k in range(DRAWS):
        values = dict(first)
        if k:
            for name, (low, high) in SPREADS.items():
                if name in free:
                    values[name] = float(rng.uniform(low, high))
            for name, part in NEAR.items():
                if name in free:
                    values[name] *= float(1.0 + part * rng.uniform(-1, 1))
            if "gamma" in free and rng.random() < 0.5:
                values["gamma"] = float(np.clip(first["gamma"] + 0.1 * rng.uniform(-1, 1), 0.05, 0.95))
            if "angle" not in measured and "angle0" in free:
                values |= (
                    {"angle0": float(rng.uniform(-np.pi, np.pi)), "gamma": float(rng.uniform(0.2, 0.9))}
                    if ("gamma" in free)
                    else {"angle0": float(rng.uniform(-np.pi, np.pi))}
                )
        try:
            motion = problem.motion(values)
        except InputError:
            continue
        off = problem.distances(problem.places(motion, values), values)
        # cut large residuals: the part of the film that agrees counts
        found.append(Candidate(values, motion.sequence, float(np.log1p(off**2).sum())))
    best: dict[str, list[Candidate]] = {}
    for one in sorted(found, key=lambda candidate: candidate.cost):
        group = best.setdefault(merge_bounces(one.sequence)[:12], [])
        if len(group) < A_SEQUENCE:
            group.append(one)
    few = list(best.values())[:SEQUENCES]
    return sorted((one for group in few for one in group), key=lambda candidate: candidate.cost)


SPREADS = {"mu_kinetic": (0.05, 1.2), "mu_excess": (0.0, 0.2), "restitution": (0.0, 0.7)}
NEAR = {"speed": 0.02, "vx0": 0.02, "omega0": 0.02}
