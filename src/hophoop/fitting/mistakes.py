"""Likely mistakes in data that no motion explains: units, directions of axes and angles, slow motion."""

from __future__ import annotations

from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.guess import LEAST, SLIPS, Rates, rates_of
from hophoop.fitting.problem import Run

Floats = NDArray[np.float64]

FAR_OFF = 8.0  # factor by which lengths or gravity are off that no loss of energy explains
LEAST_RISE = 0.02  # of the centre, over the radius, that is a hop
LEAST_SWING = 0.1  # of the angular velocity over a revolution, over its mean
ASIDE = 60.0  # angle between fastest rotation and the bottom that is no effect of slip [degrees]
LEAST_ARC = 1.5  # of rolling, for an estimate of gravity [rad]


def likely_mistakes(problem: Run) -> list[str]:
    """Ask about usual mistakes. Every hoop has x ≈ R θ, hops upwards and is fastest with its load at the bottom.

    questions: at most one sentence; empty if nothing is conspicuous.
    """
    x, y, angle = (rates_of(problem, name) for name in ("x", "y", "angle"))
    if x is None or angle is None:
        return []
    if y is not None and np.ptp(y.value) > max(2.0 * problem.radius, np.ptp(x.value)):
        return ["The centre moves more along y than along x: is the film sideways, or are x and y exchanged?"]
    if y is not None and _hops_down(y.value, problem):
        return ["The centre jumps down and not up: does y count downwards, or is the film upside down? y is the height."]
    place = np.interp(angle.t, x.t, x.value)
    ratio = float(np.polyfit(angle.value, place, 1)[0]) / problem.radius if np.ptp(angle.value) else np.inf
    return _of_units(ratio) or _of_the_angle(angle, ratio) or _of_gravity(problem, x, angle)


def _hops_down(height: Floats, problem: Run) -> bool:
    """True if the centre leaves its usual height downwards."""
    low, usual, high = np.quantile(height, [0.02, 0.5, 0.98])
    noise = next(float(np.median(one.errors)) for one in problem.channels if one.name == "y")
    return bool(usual - low > max(2.0 * (high - usual), LEAST_RISE * problem.radius, SLIPS * noise))


def _of_units(ratio: float) -> list[str]:
    """Ask about lengths and degrees; `ratio` is the way of the centre over radius and angle, about 1."""
    if abs(ratio) > FAR_OFF:
        return [
            f"The centre goes {abs(ratio):.2g} times as far as radius and angle let it: are lengths in cm or pixels? "
            "Name the columns x (cm), y (cm); the radius is in m."
        ]
    if abs(ratio) < 1.0 / FAR_OFF:
        return [
            f"The angle goes {1.0 / max(abs(ratio), 1e-9):.2g} times as far as radius and x let it: is it in degrees "
            "(--angle-unit deg), or the radius in cm? The radius is in m."
        ]
    return []


def _of_the_angle(angle: Rates, ratio: float) -> list[str]:
    """Ask about the direction and the zero of the angle."""
    if ratio < 0:
        return ["x grows while the angle falls: the angle counts clockwise if x counts to the right. Does yours?"]
    design = np.column_stack([np.ones_like(angle.t), np.cos(angle.value), np.sin(angle.value)])
    mean, cosine, sine = np.linalg.lstsq(design, angle.rate, rcond=None)[0] * np.sign(np.median(angle.rate))
    fastest = float(np.degrees(np.arctan2(sine, cosine))) % 360.0
    if np.hypot(cosine, sine) > LEAST_SWING * abs(mean) and abs(fastest - 180.0) > ASIDE:
        return [
            f"The hoop turns fastest at about {10 * round(fastest / 10)}°, but it should at 180°, with the load at the bottom: "
            "is your angle zero with the load at the top? A known difference is --fix marker_angle=…, in rad."
        ]
    return []


def _of_gravity(problem: Run, x: Rates, angle: Rates) -> list[str]:
    """Ask about time and the radius, from the energy while the hoop rolls: θ̇² (1 + γ cosθ) + γ g/R cosθ is constant."""
    slip = np.interp(angle.t, x.t, x.rate) - problem.radius * angle.rate
    error = np.hypot(np.interp(angle.t, x.t, x.error), problem.radius * angle.error)
    rolls = np.abs(slip) < SLIPS * error + 0.03 * np.abs(problem.radius * angle.rate)
    pieces = [[k for k, _ in group] for rolling, group in groupby(enumerate(rolls), key=lambda pair: pair[1]) if rolling]
    pieces = [piece for piece in pieces if len(piece) > LEAST]
    if sum(np.ptp(angle.value[piece]) for piece in pieces) < LEAST_ARC:
        return []
    rows, square = np.concatenate(pieces), angle.rate**2
    own = np.concatenate([np.full(len(piece), k) for k, piece in enumerate(pieces)])
    cosine = np.cos(angle.value[rows])
    design = np.column_stack([square[rows] * cosine, cosine, *(np.where(own == k, -1.0, 0.0) for k in range(len(pieces)))])
    gamma, sinking = np.linalg.lstsq(design, -square[rows], rcond=None)[0][:2]
    if not (0.02 < gamma < 1.0 and sinking > 0):
        return []
    found, known = float(sinking / gamma) * problem.radius, problem.plane.gravity
    said = f"Gravity in the data is about {float(f'{found:.1g}'):g} m/s², not {known:g}:"
    if found < known / FAR_OFF:
        return [
            f"{said} is the film in slow motion? Give the frames per second as taken, hophoop track --rate 240, "
            "or correct the times."
        ]
    if found > known * FAR_OFF:
        return [f"{said} is the radius in m, and are times in s?"]
    return []
