"""Starts of a fit: a guess from the data, and the best of many motions drawn around it, for each sequence."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from operator import attrgetter, itemgetter
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.channels import Floats, Values, rotation_of
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


def rates_of(run: Run, name: str) -> Rates | None:
    """Return values and rates of a channel, from a parabola around each; None if it was not measured, or too seldom."""
    channel = run.channel(name)
    if channel is None or len(channel.rows) < LEAST:
        return None
    t, values, errors = run.t[channel.rows], channel.values, channel.errors
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


def slips(run: Run, x: Rates, angle: Rates) -> NDArray[np.bool_]:
    """Return True at times of the angle at which the hoop slips, by more than its errors."""
    slip = np.interp(angle.t, x.t, x.rate) - run.radius * angle.rate
    error = np.hypot(np.interp(angle.t, x.t, x.error), run.radius * angle.error)
    return np.abs(slip) > SLIPS * error + 0.02 * np.abs(run.radius * angle.rate)


def start_kind(run: Run) -> str:
    """Return the kind of motion in the first frame: 'rolling' unless the data contradict it."""
    x, y, angle = rates_of(run, "x"), run.channel("y"), rates_of(run, "angle")
    if x is None or angle is None:
        return "rolling"
    if y is not None and (y.values - run.radius > np.maximum(6.0 * y.errors, 3e-3 * run.radius))[:3].all():
        return "flying"
    return "sliding" if slips(run, x, angle)[0] else "rolling"


def guess(run: Run, values: Values, free: Collection[str]) -> Values:
    """Guess parameters from the data: the start from the first frames, the share of the load from the energy in rolling.

    values: known and default values; free: parameters that are guessed.
    """
    result: dict[str, Any] = {name: PARAMETERS[name].usual for name in ("gamma", "speed")} | values
    x, y, angle, omega, marker = (rates_of(run, name) for name in ("x", "y", "angle", "omega", "marker_x"))
    if angle is not None:
        turned, spans = angle.value - values["marker_angle"], SPANS
        if x is not None:
            rolled = int(np.argmax([*slips(run, x, angle), True]))
            spans = (max(rolled, ROLLING) / len(angle.t),)
        result |= load_of_turning(run, turned, angle.rate, spans, values["slope"], True)
    elif omega is not None:
        result |= load_of_turning(run, rotation_of(omega.t, omega.value), omega.value, SPANS, values["slope"], False)
    if x is not None and y is not None:
        result |= {"x0": x.value[0], "speed": x.rate[0], "height0": max(y.value[0] - run.radius, 0.0), "vy0": y.rate[0]}
        tilt = np.arctan(np.polyfit(x.value, y.value, 1)[0])
        seen = abs(tilt) > 1e-3 and np.ptp(x.value) > run.radius
        result |= {"origin_y": np.quantile(y.value, 0.1) - run.radius, "tilt": tilt if seen else 0.0}
    elif marker is not None:
        result["speed"], result["x0"] = np.polyfit(marker.t, marker.value, 1)  # the marker revolves about the centre
    result |= {"vx0": result["speed"], "eccentricity": result["gamma"], "inertia_ratio": 1.0 - result["gamma"] ** 2}
    return {name: float(result[name]) if name in free else value for name, value in values.items()}


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
        found.append((np.std(design[:count] @ answer - right[:count]) / share, answer))
    _, (cos, _, *sin) = min(found, key=itemgetter(0))
    load, angle = (np.hypot(cos, sin[0]), np.arctan2(sin[0], cos)) if sin else (cos, turned[0])
    return {"gamma": np.clip(load, *SHARES), "angle0": angle, "omega0": omega[0], "speed": run.radius * omega[0]}


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
        values = first | _drawn(run, first, free, rng) if k else first
        try:
            motion = run.motion(values)
        except InputError:
            continue
        off = run.distances(run.places(motion, values), values)
        # cut large residuals: the part of the film that agrees counts
        found.append(Candidate(values, merge_bounces(motion.sequence), np.log1p(off**2).sum()))
    best: dict[str, list[Candidate]] = {}
    for one in sorted(found, key=COST):
        best.setdefault(one.sequence[:12], []).append(one)
    return sorted((one for group in list(best.values())[:SEQUENCES] for one in group[:A_SEQUENCE]), key=COST)


def _drawn(run: Run, first: Values, free: set[str], rng: np.random.Generator) -> Values:
    """Draw free parameters around a guess, or from all that is usual where the data do not show them at once."""
    drawn = {name: rng.uniform(*ends) for name, ends in SPREADS.items() if name in free}
    drawn |= {name: first[name] * (1.0 + NEAR * rng.uniform(-1, 1)) for name in SPEEDS if name in free}
    # a hoop that hops at once does not roll for long enough to guess the load
    if "gamma" in free and (width := rng.choice([0.0, 0.1, 0.9])):
        drawn["gamma"] = float(np.clip(first["gamma"] + width * rng.uniform(-1, 1), *SHARES))
    if "omega" in run.measured and rng.random() < 0.5:
        drawn["angle0"] = first["angle0"] + rng.normal(0.0, 0.3)
    elif not run.measured & {"angle", "omega"}:
        drawn |= {"angle0": rng.uniform(-np.pi, np.pi), "gamma": rng.uniform(0.2, 0.9)}
    return {name: value for name, value in drawn.items() if name in free}
