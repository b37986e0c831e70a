"""Starts of a fit: a guess from the data, and the best of many motions drawn around it, for each sequence."""

from __future__ import annotations

from collections.abc import Sequence
from operator import attrgetter, itemgetter
from typing import NamedTuple

import numpy as np

from hophoop.fitting.channels import Floats, Values
from hophoop.fitting.parameters import PARAMETERS
from hophoop.fitting.problem import Run, merge_bounces
from hophoop.scenario import InputError

WIDTH = 0.05  # of the pieces for velocities [s]
LEAST = 5  # minimum frames of such a piece
BLOCK = 10_000  # frames whose pieces are in memory at a time
ROLLING = 8  # minimum frames of rolling for the share of the load
SHARES = (0.05, 0.95)  # of the load that are tried
SPANS: Sequence[float] = (0.25, 0.4, 0.6, 0.8, 1.0)  # of the data from their start
SLIPS = 4.0  # significant slip over its standard deviation
COST = attrgetter("cost")
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
    width = min(2 * half + 1, len(t))
    found = []
    for rows in np.array_split(np.arange(len(t)), 1 + len(t) // BLOCK):
        near = np.clip(rows - half, 0, len(t) - width)[:, None] + np.arange(width)
        powers = (t[near] - t[rows, None])[..., None] ** np.arange(3)
        inverse = np.linalg.pinv(powers / errors[near][..., None])  # shape (rows, 3, width)
        value, rate, _ = np.einsum("kij,kj->ik", inverse, values[near] / errors[near])
        found.append((value, rate, np.linalg.norm(inverse[:, 1], axis=-1)))
    return Rates(t, *np.concatenate(found, axis=1))


def rates_of(run: Run, name: str) -> Rates | None:
    """Return the rates of a channel; None if it was not measured, or too seldom."""
    channel = run.channel(name)
    if channel is None or len(channel.rows) < LEAST:
        return None
    return rates(run.t[channel.rows], channel.values, channel.errors)


def slip_of(run: Run, x: Rates, angle: Rates) -> tuple[Floats, Floats]:
    """Return the slip velocity at the times of the angle, and its standard deviation [m/s]."""
    slip = np.interp(angle.t, x.t, x.rate) - run.radius * angle.rate
    return slip, np.hypot(np.interp(angle.t, x.t, x.error), run.radius * angle.error)


def start_kind(run: Run) -> str:
    """Return the kind of motion in the first frame: 'rolling' unless the data contradict it."""
    x, y, angle = rates_of(run, "x"), run.channel("y"), rates_of(run, "angle")
    if x is None or angle is None:
        return "rolling"
    if y is not None and (y.values - run.radius > np.maximum(6.0 * y.errors, 3e-3 * run.radius))[:3].all():
        return "flying"
    slip, error = slip_of(run, x, angle)
    return "sliding" if abs(slip[0]) > max(SLIPS * error[0], 0.03 * abs(x.rate[0])) else "rolling"


def guess(run: Run, values: Values) -> Values:
    """Guess parameters from the data: the start from the first frames, the share of the load from the energy in rolling.

    values: known and default values.
    """
    result = {name: one.usual for name, one in PARAMETERS.items()} | values
    x, y, angle, omega, marker = (rates_of(run, name) for name in ("x", "y", "angle", "omega", "marker_x"))
    if x is not None:
        result |= {"x0": x.value[0], "speed": x.rate[0]}
    elif marker is not None:
        result["speed"], result["x0"] = np.polyfit(marker.t, marker.value, 1)  # the marker revolves about the centre
    if y is not None:
        result |= {"height0": max(y.value[0] - run.radius, 0.0), "vy0": y.rate[0]}
        result["origin_y"] = np.quantile(y.value, 0.1) - run.radius
        if x is not None and not values["tilt"] and np.ptp(x.value) > run.radius:
            tilt = np.arctan(np.polyfit(x.value, y.value, 1)[0])
            result["tilt"] = tilt if abs(tilt) > 1e-3 else 0.0
    if angle is not None:
        turned, rate, spans = angle.value - values["marker_angle"], angle.rate, SPANS
        if x is not None:
            slip, error = slip_of(run, x, angle)
            slips = np.abs(slip) > SLIPS * error + 0.02 * np.abs(run.radius * rate)
            spans = (max(int(np.argmax([*slips, True])), ROLLING) / len(slips),)
        result |= load_of_turning(run, turned, rate, spans, values["slope"], True)
    elif omega is not None:
        turned = np.cumsum(0.5 * (omega.value[1:] + omega.value[:-1]) * np.diff(omega.t))
        result |= load_of_turning(run, np.concatenate([[0.0], turned]), omega.value, SPANS, values["slope"], False)
    if x is None and (angle is not None or omega is not None):
        result["speed"] = run.radius * result["omega0"]
    result |= {"vx0": result["speed"], "eccentricity": result["gamma"], "inertia_ratio": 1.0 - result["gamma"] ** 2}
    return {name: float(result[name]) for name in values}


def load_of_turning(run: Run, turned: Floats, omega: Floats, spans: Sequence[float], slope: float, known: bool) -> Values:
    """Return γ, the first angle and angular velocity from the energy, constant in rolling.

    (1 + γ cosθ) θ̇² + (g/R) (γ cos(θ + β) − θ sinβ) with θ = θ0 + the rotation since then is linear in γ cosθ0, γ sinθ0 and the
    constant. The hoop may slip from some time on, so that of several spans from the start the one counts whose equation holds
    best.

    turned: θ, or the rotation since the first frame [rad]; spans: parts of the data from their start [1];
    known: whether it is θ itself.
    """
    gravity = run.plane.gravity / run.radius
    along = omega**2 * np.cos(turned) + gravity * np.cos(turned + slope)
    across = omega**2 * np.sin(turned) + gravity * np.sin(turned + slope)
    design = np.column_stack([along, -np.ones_like(omega), *([] if known else [-across])])
    right = gravity * turned * np.sin(slope) - omega**2
    found = []
    for share in spans:
        count = max(round(share * len(omega)), ROLLING)
        answer, *_ = np.linalg.lstsq(design[:count], right[:count], rcond=None)
        found.append((float(np.std(design[:count] @ answer - right[:count])) / share, answer))
    _, (cos, _, *sin) = min(found, key=itemgetter(0))
    load, angle = (np.hypot(cos, sin[0]), np.arctan2(sin[0], cos)) if sin else (cos, turned[0])
    return {"gamma": float(np.clip(load, *SHARES)), "angle0": float(angle), "omega0": float(omega[0])}


class Candidate(NamedTuple):
    """Start of a fit."""

    values: Values
    sequence: str
    cost: float


def candidates(run: Run, first: Values, free: set[str], seed: int = 0, draws: int = DRAWS) -> list[Candidate]:
    """Return the best motions of each sequence, of many drawn around a guess.

    The sum of squares has a basin for each sequence, and descent from one basin does not lead into another.

    first: the guess; free: parameters that may differ from it; seed, draws: seed and number of the draws [1];
    candidates: the best first.
    """
    rng = np.random.default_rng(seed)
    found: list[Candidate] = []
    for k in range(draws):
        values = dict(first)
        if k:
            drawn = {name: float(rng.uniform(*ends)) for name, ends in SPREADS.items() if name in free}
            drawn |= {name: values[name] * float(1.0 + NEAR * rng.uniform(-1, 1)) for name in SPEEDS if name in free}
            # a hoop that hops at once does not roll for long enough to guess the load
            if "gamma" in free and (width := rng.choice([0.0, 0.1, 0.9])):
                drawn["gamma"] = float(np.clip(first["gamma"] + width * rng.uniform(-1, 1), *SHARES))
            if "omega" in run.measured and rng.random() < 0.5:
                drawn["angle0"] = first["angle0"] + float(rng.normal(0.0, 0.3))
            elif not run.measured & {"angle", "omega"}:
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
    for one in sorted(found, key=COST):
        best.setdefault(one.sequence[:12], []).append(one)
    return sorted((one for group in list(best.values())[:SEQUENCES] for one in group[:A_SEQUENCE]), key=COST)
