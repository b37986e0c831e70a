"""The strips beside a skid that just does not carry over the top.

A skid that ends in a reversal and the same skid that carries over the top differ by more than one coincidence. Between
them lies the slip's own saddle before the top, where ε sinθ = −μ (1 + ε cosθ). A hoop that all but stops there parts
from it as exp(λ t), λ² = (ε g/κR) (cosθ − μ sinθ), while friction takes v_t away at the rate μ g. So it sticks before it
leaves, and rolls: back, or over the top. The strips '…KR' of both endings lie between the two skids.

How wide they are: δ, the way from the saddle when the hoop sticks, must not reach the top, which is δ = θs, and the
hoop then comes back if δ (1 + λ/λr) < θs, with λr of rolling at the top. Where the hoop moves on at λδ as it sticks, v_t
is R (1 + ε) λδ less than where it stands, and so it sticks sooner. With δ0 per speed of the start, as the hoop arrives with
v_t, both strips together are θs/δ0 exp((1 + ε) λ² R θs/(μ g) − λ v_t/(μ g)) wide; the first exponent is (1 + ε)²/κ where
friction is little.
"""

from __future__ import annotations

import itertools
import math
from typing import NamedTuple

import numpy as np

from hophoop.kernel.numerics.elementwise import (
    arcsine,
    arctangent,
    cosine,
    exponential,
    hypotenuse,
    logarithm,
    logarithm_1p,
    sine,
)
from hophoop.maps.survey.coincidences import REVERSAL, REVOLUTIONS, Class
from hophoop.scenario import InputError, Scenario
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory

APPROACH = 0.03  # rad before the saddle at which a hoop has arrived
BESIDE = 1e-7  # parts of a parameter, for a difference
ZOOMS = 9  # each 64 times as close


def across(sequence: str) -> tuple[Class, Class, Class, Class]:
    """What follows one another across the border of a skid: its reversal, its two strips, its way over the top."""
    endings = (REVERSAL, REVERSAL, REVOLUTIONS, REVOLUTIONS)
    return tuple(zip((sequence, f"{sequence}R", f"{sequence}R", sequence), endings, strict=True))  # type: ignore[return-value]


def may_hold_strips(one: Class, other: Class) -> bool:
    """Whether a strip may lie between two classes: both are of the four across one skid's border."""
    skid = min(one[0], other[0], key=len).rstrip("R")
    return skid.endswith("K") and one in across(skid) and other in across(skid)


def saddle_of_skid(eccentricity: float, inertia_ratio: float, mu: float) -> tuple[float, float]:
    """Where a skid's saddle before the top is, and the rate at which motions part from it.

    Parameters
    ----------
    eccentricity, inertia_ratio, mu : float
        ε, κ and μ [1].

    Returns
    -------
    angle : float
        θ, from −π/2 to 0 [rad].
    rate : float
        λ in units of √(g/R) [1].

    Raises
    ------
    ValueError
        If friction is so high that a skidding hoop is braked everywhere.
    """
    # ε (sinθ + μ cosθ) = −μ
    size = mu / (eccentricity * hypotenuse(1.0, mu))
    if not size < 1.0:
        raise InputError.of_field("mu", mu, "below ε/√(1 − ε²): a skid has no saddle otherwise")
    angle = -arcsine(size) - arctangent(mu)
    return angle, math.sqrt(eccentricity / inertia_ratio * (cosine(angle) - mu * sine(angle)))


class Strips(NamedTuple):
    """How wide the two strips beside one place of a skid's border are, by theory.

    Attributes
    ----------
    reversal, revolutions : float
        Decimal logarithms of the widths, along a parameter in SI units: far smaller ones are there than numbers can be
        [1].
    """

    reversal: float
    revolutions: float


def strips_at(scenario: Scenario, path: str = "start.speed") -> Strips:
    """The strips beside a start on the border of a skid over its saddle.

    Parameters
    ----------
    scenario : Scenario
        A level plane, and a rolling start at the top on the border between a skid that comes back before the top and
        the same skid over it.
    path : str, default 'start.speed'
        The parameter along which they are measured, one that does not change the hoop: start.speed or plane.mu.

    Returns
    -------
    strips : Strips

    Raises
    ------
    ValueError
        If the motion does not come to the saddle in a skid.
    """
    value = scenario.start.speed if path == "start.speed" else scenario.plane.mu_kinetic
    if value is None:
        raise InputError("start must be a rolling one at the top, such as start.speed = 1.")
    arrivals = _arrivals([scenario.replace(path, value * (1.0 + way * BESIDE)) for way in (-1.0, 1.0)])
    # as far before the saddle, half of what differs in θ̇/λ grows, and the other half decays
    growing = abs(arrivals[1].turning - arrivals[0].turning) / (4.0 * BESIDE * value)
    if growing == 0.0:
        raise InputError.of_field(
            "start.speed", scenario.start.speed, "a skid that all but stops at its saddle", rule="must lead to"
        )
    hoop, plane = scenario.hoop, scenario.plane
    angle, rate = saddle_of_skid(hoop.eccentricity, hoop.inertia_ratio, plane.mu_kinetic)
    # of the saddle at the top, in rolling
    arm = 1.0 + hoop.eccentricity
    rolling = math.sqrt(hoop.eccentricity / (arm * arm + hoop.inertia_ratio))
    ways = -angle / (1.0 + rate / rolling), -angle
    # a hoop that moves on at λδ sticks before one that stands, by λδ (1 + ε) R/(μ g)
    sooner = rate * rate * arm / plane.mu_kinetic
    grown = 0.5 * (arrivals[0].growth + arrivals[1].growth)
    reversal, both = (logarithm(way / growing) + sooner * way - grown for way in ways)
    revolutions = both + logarithm_1p(-exponential(reversal - both))
    return Strips(reversal / logarithm(10.0), revolutions / logarithm(10.0))


class _Arrival(NamedTuple):
    """A hoop shortly before its saddle: λ v_t/(μ g) if its rotation were stopped, and θ̇/λ."""

    growth: float
    turning: float


def _arrivals(sides: list[Scenario]) -> list[_Arrival]:
    """Two starts beside a border, as far before their saddles."""
    saddles = [saddle_of_skid(one.hoop.eccentricity, one.hoop.inertia_ratio, one.plane.mu_kinetic) for one in sides]
    skids = [_skid_to(one, 2.0 * math.pi + angle) for one, (angle, _) in zip(sides, saddles, strict=True)]
    ways = [2.0 * math.pi + angle - begin for (angle, _), (_, begin, _, _) in zip(saddles, skids, strict=True)]
    approach = min(APPROACH, 0.5 * min(ways))
    found = []
    for one, (saddle, rate), (motion, _, low, high) in zip(sides, saddles, skids, strict=True):
        hoop, plane = one.hoop, one.plane
        target = 2.0 * math.pi + saddle - approach
        for _ in range(ZOOMS):
            times = np.linspace(low, high, 65)
            k = int(np.clip(np.searchsorted(motion.at(times).angle, target), 1, 64))
            low, high = float(times[k - 1]), float(times[k])
        here = motion.at(high)
        # ẋ_G + μ ẏ_G loses μ g t and nothing else; without rotation it is v_t
        lever = cosine(here.angle) - plane.mu_kinetic * sine(here.angle)
        slip = float(here.vx) + hoop.eccentricity * hoop.radius * float(here.omega) * lever
        rate *= math.sqrt(plane.gravity / hoop.radius)
        found.append(_Arrival(rate * slip / (plane.mu_kinetic * plane.gravity), float(here.omega) / rate))
    return found


def _skid_to(scenario: Scenario, saddle: float) -> tuple[Trajectory, float, float, float]:
    """The motion, and the angle at which the skid to its saddle begins, when, and until when it is one."""
    motion = simulate(scenario)
    for event, following in itertools.pairwise(motion.events):
        arrives = saddle - min(APPROACH, 0.5 * (saddle - event.angle))
        if event.to_mode == "K" and event.angle < arrives < following.angle:
            return motion, event.angle, event.t, following.t
    raise InputError.of_field("start.speed", scenario.start.speed, "a skid that comes to its saddle", rule="must lead to")
