"""Starts of a fit: a guess from the data, and the best of many motions drawn around it, for each sequence."""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.channels import Channel
from hophoop.fitting.problem import Run
from hophoop.scenario import InputError

Floats = NDArray[np.float64]

WIDTH = 0.05  # of the pieces for velocities [s]
LEAST = 5  # minimum frames of such a piece
FIRST = 8  # minimum frames for the start
ROLLING, FLYING = 8, 16  # minimum frames of rolling, or of flight, for the share of the load
LEAST_GAP = 0.01  # height of the rim above the plane, over the radius, that is flight
SLIPS = 4.0  # significant slip over its standard deviation
DRAWS = 160
A_SEQUENCE = 2  # starts of each sequence
SEQUENCES = 4
SPREADS = {"mu_kinetic": (0.05, 1.2), "mu_excess": (0.0, 0.2), "restitution": (0.0, 0.7)}
SPEEDS, NEAR = ("speed", "vx0", "omega0"), 0.02  # parts of the guess, and how far from it they are drawn


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
    half = max(LEAST // 2, round(0.5 * WIDTH / float(np.median(np.diff(t)))))
    rows = []
    for k in range(len(t)):
        near = slice(max(0, k - half), k + half + 1)
        rows.append(_parabola(t[near] - t[k], values[near], errors[near]))
    return Rates(t, *np.array(rows).T)


def _parabola(t: Floats, values: Floats, errors: Floats) -> tuple[float, float, float]:
    """Return value, rate and the rate's standard deviation at t = 0 of the parabola through data."""
    weight = 1.0 / errors
    design = np.column_stack([np.ones_like(t), t, t**2]) * weight[:, None]
    inverse = np.linalg.pinv(design.T @ design)
    found = inverse @ (design.T @ (values * weight))
    return float(found[0]), float(found[1]), float(np.sqrt(max(inverse[1, 1], 0.0)))


def channel_of(run: Run, name: str) -> Channel | None:
    """Return a channel with enough data for rates."""
    return next((channel for channel in run.channels if channel.name == name and len(channel.rows) >= LEAST), None)


def rates_of(run: Run, name: str) -> Rates | None:
    """Return the rates of a channel; None if it was not measured."""
    channel = channel_of(run, name)
    return None if channel is None else rates(run.t[channel.rows], channel.values, channel.errors)


class Initial(NamedTuple):
    """A quantity and its rate in the first frame, from a parabola through the first frames."""

    value: float
    rate: float
    error: float  # of the rate


def initial(run: Run, name: str) -> Initial | None:
    """Return value and rate of a channel in the first frame; None if it was not measured."""
    channel = channel_of(run, name)
    if channel is None:
        return None
    t = run.t[channel.rows]
    near = slice(max(FIRST, int(np.searchsorted(t, t[0] + WIDTH))))
    return Initial(*_parabola(t[near], channel.values[near], channel.errors[near]))


def start_kind(run: Run) -> str:
    """Return the kind of motion in the first frame: 'rolling' unless the data contradict it."""
    x, angle, y = initial(run, "x"), initial(run, "angle"), channel_of(run, "y")
    if x is None or angle is None:
        return "rolling"
    if y is not None:
        gap = y.values[:3] - run.radius
        if (gap > 6.0 * y.errors[:3]).all() and (gap > 3e-3 * run.radius).all():
            return "flying"
    slip = x.rate - run.radius * angle.rate
    error = float(np.hypot(x.error, run.radius * angle.error))
    return "sliding" if abs(slip) > max(SLIPS * error, 0.03 * abs(x.rate)) else "rolling"


def guess(run: Run, values: dict[str, float]) -> dict[str, float]:
    """Guess parameters from the data: the start from the first frames, the share of the load from the energy in rolling.

    values: known and default values.
    """
    result = dict(values)
    x, y, angle = (rates_of(run, name) for name in ("x", "y", "angle"))
    if x is not None and (first := initial(run, "x")) is not None:
        result |= {"x0": first.value, "speed": first.rate, "vx0": first.rate}
    elif (marker := channel_of(run, "marker_x")) is not None:
        speed, place = np.polyfit(run.t[marker.rows], marker.values, 1)  # the marker revolves about the centre
        result |= {"x0": float(place), "speed": float(speed), "vx0": float(speed)}
    if x is not None and y is not None and not values["tilt"] and np.ptp(x.value) > run.radius:
        tilt = float(np.arctan(np.polyfit(x.value, y.value, 1)[0]))
        result["tilt"] = tilt if abs(tilt) > 1e-3 else 0.0
    if y is not None and (first := initial(run, "y")) is not None:
        result |= {"height0": max(first.value - run.radius, 0.0), "vy0": first.rate}
        result["origin_y"] = float(np.quantile(y.value, 0.1)) - run.radius
    load = None
    if angle is not None and (first := initial(run, "angle")) is not None:
        result |= {"angle0": first.value - values["marker_angle"], "omega0": first.rate}
        load = share_in_flight(run, angle, x, y, result) or share_of_load(run, angle, x, result)
    elif (omega := rates_of(run, "omega")) is not None:
        result["omega0"] = float(omega.value[0])
        load, result["angle0"] = load_of_turning(run, omega.t, omega.value)
    if x is None and (angle is not None or channel_of(run, "omega")):
        result["speed"] = result["vx0"] = run.radius * result["omega0"]
    if load is not None:
        result |= {"gamma": load, "eccentricity": load, "inertia_ratio": 1.0 - load**2}
    return {name: result[name] for name in values}


def share_of_load(run: Run, angle: Rates, x: Rates | None, values: dict[str, float]) -> float | None:
    """Return γ from the conserved energy while the hoop rolls: (1 + γ cosθ) R²θ̇² + γ g R cos(θ + β) − g R θ sinβ.

    x: to detect rolling; values: slope and angle of the marker; gamma: None if the data do not determine it [1].
    """
    radius, gravity = run.radius, run.plane.gravity
    theta, slope = angle.value - values["marker_angle"], values["slope"]
    rolls = np.ones(len(theta), dtype=bool)
    if x is not None:
        slip = np.interp(angle.t, x.t, x.rate) - radius * angle.rate
        error = np.hypot(np.interp(angle.t, x.t, x.error), radius * angle.error)
        broken = np.flatnonzero(np.abs(slip) > SLIPS * error + 0.02 * np.abs(radius * angle.rate))
        rolls[broken[0] if len(broken) else len(rolls) :] = False
    if rolls.sum() < ROLLING:
        return None
    square = (radius * angle.rate[rolls]) ** 2
    turning, sinking = np.cos(theta[rolls]) * square, gravity * radius * np.cos(theta[rolls] + slope)
    known = gravity * radius * theta[rolls] * np.sin(slope) - square
    design = np.column_stack([turning + sinking, -np.ones(rolls.sum())])
    found, _, rank, _ = np.linalg.lstsq(design, known, rcond=None)
    return float(np.clip(found[0], 0.05, 0.95)) if rank == 2 else None


def share_in_flight(run: Run, angle: Rates, x: Rates | None, y: Rates | None, values: dict[str, float]) -> float | None:
    """Return γ from the longest flight, in which the centre of gravity goes along a parabola.

    x + γ R sinθ and y + γ R cosθ of the centre have the acceleration of gravity, which is linear in γ.

    values: slope, height of the plane and angle of the marker; gamma: None if the hoop does not fly for long [1].
    """
    if x is None or y is None or len(x.t) != len(angle.t):
        return None
    error = next(float(np.median(channel.errors)) for channel in run.channels if channel.name == "y")
    flies = y.value - values["origin_y"] - run.radius > max(SLIPS * error, LEAST_GAP * run.radius)
    ends = np.flatnonzero(np.diff(np.concatenate([[False], flies, [False]]).astype(int)))
    first, last = max(zip(ends[::2], ends[1::2], strict=True), key=lambda pair: pair[1] - pair[0], default=(0, 0))
    first, last = first + LEAST, last - LEAST  # the pieces at its ends have contact, too
    if last - first < FLYING:
        return None
    t, theta = y.t[first:last], angle.value[first:last] - values["marker_angle"]
    none, one = np.zeros_like(t), np.ones_like(t)
    along = np.column_stack([-run.radius * np.sin(theta), one, t, none, none])
    up = np.column_stack([-run.radius * np.cos(theta), none, none, one, t])
    fall, slope = 0.5 * run.plane.gravity * t**2, values["slope"]
    known = np.concatenate([x.value[first:last] - np.sin(slope) * fall, y.value[first:last] + np.cos(slope) * fall])
    found, *_ = np.linalg.lstsq(np.concatenate([along, up]), known, rcond=None)
    return float(np.clip(found[0], 0.05, 0.95))


def load_of_turning(run: Run, t: Floats, omega: Floats) -> tuple[float, float]:
    """Return γ and the first angle from the angular velocity alone: θ̇² + γ (θ̇² + g/R) cosθ is constant while the hoop rolls.

    With θ = θ0 + the integral of θ̇ that is linear in γ cosθ0, γ sinθ0 and the constant. The hoop may slip from some time on,
    so that of several spans from the start the one counts whose equation holds best.
    """
    turned = np.concatenate([[0.0], np.cumsum(0.5 * (omega[1:] + omega[:-1]) * np.diff(t))])
    weight = omega**2 + run.plane.gravity / run.radius
    design = np.column_stack([weight * np.cos(turned), -weight * np.sin(turned), -np.ones_like(t)])
    found = []
    for share in (0.25, 0.4, 0.6, 0.8, 1.0):
        count = max(int(share * len(t)), ROLLING)
        answer, *_ = np.linalg.lstsq(design[:count], -(omega[:count] ** 2), rcond=None)
        off = design[:count] @ answer + omega[:count] ** 2
        found.append(
            (float(np.std(off)) / share, float(np.hypot(answer[0], answer[1])), float(np.arctan2(answer[1], answer[0])))
        )
    _, load, angle = min(found)
    return float(np.clip(load, 0.05, 0.95)), angle


def merge_bounces(sequence: str) -> str:
    """Merge bounces in a row into one 'H+': their number depends on the last digit."""
    return re.sub("HH+", "H+", sequence)


class Candidate(NamedTuple):
    """Start of a fit."""

    values: dict[str, float]
    sequence: str
    cost: float


def candidates(run: Run, first: dict[str, float], free: set[str], seed: int = 0, draws: int = DRAWS) -> list[Candidate]:
    """Return the best motions of each sequence, of many drawn around a guess.

    The sum of squares has a basin for each sequence, and descent from one basin does not lead into another.

    first: the guess; free: parameters that may differ from it; seed, draws: seed and number of the draws [1];
    candidates: the best first.
    """
    rng = np.random.default_rng(seed)
    measured = {channel.name for channel in run.channels}
    found: list[Candidate] = []
    for k in range(draws):
        values = dict(first)
        if k:
            drawn = {name: float(rng.uniform(*ends)) for name, ends in SPREADS.items() if name in free}
            drawn |= {name: values[name] * float(1.0 + NEAR * rng.uniform(-1, 1)) for name in SPEEDS if name in free}
            if "gamma" in free and rng.random() < 0.5:
                drawn["gamma"] = float(np.clip(first["gamma"] + 0.1 * rng.uniform(-1, 1), 0.05, 0.95))
            if "omega" in measured and rng.random() < 0.5:
                drawn["angle0"] = first["angle0"] + float(rng.normal(0.0, 0.3))
            elif not measured & {"angle", "omega"}:
                drawn |= {"angle0": float(rng.uniform(-np.pi, np.pi)), "gamma": float(rng.uniform(0.2, 0.9))}
            values |= {name: value for name, value in drawn.items() if name in free}
        try:
            motion = run.motion(values)
        except InputError:
            continue
        off = run.distances(run.places(motion, values), values)
        # cut large residuals: the part of the film that agrees counts
        found.append(Candidate(values, merge_bounces(motion.sequence), float(np.log1p(off**2).sum())))
    best: dict[str, list[Candidate]] = {}
    for one in sorted(found, key=lambda candidate: candidate.cost):
        group = best.setdefault(one.sequence[:12], [])
        if len(group) < A_SEQUENCE:
            group.append(one)
    few = list(best.values())[:SEQUENCES]
    return sorted((one for group in few for one in group), key=lambda candidate: candidate.cost)
