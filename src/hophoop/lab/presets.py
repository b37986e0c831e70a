"""Presets: motions worth starting from: the article's, Littlewood's hoop, the paradoxes of rigid contact, ends of motions."""

from __future__ import annotations

import math
from functools import cache
from typing import NamedTuple

from hophoop.article import scenarios
from hophoop.scenario import Hoop, Plane, Scenario, Start


class Preset(NamedTuple):
    """A scenario with a name and a description.

    Attributes
    ----------
    key : str
        Short name for links and code.
    title : str
    text : str
        What to look for.
    scenario : Scenario
    """

    key: str
    title: str
    text: str
    scenario: Scenario


FIRST = 8  # presets before those that the menu lists under "More"


def _rolling(speed: float, mu: float = 1.0, duration: float = 6.0, **hoop: float) -> Scenario:
    return Scenario(hoop=Hoop(**hoop), plane=Plane(mu=mu), start=Start.rolling(speed), duration=duration)


def _downhill(speed: float, degrees: float, gamma: float, duration: float) -> Scenario:
    plane = Plane(slope=math.radians(degrees))
    return Scenario(hoop=Hoop.ideal(gamma), plane=plane, start=Start.rolling(speed), duration=duration)


@cache
def presets() -> tuple[Preset, ...]:
    """Return all presets, in the order of the menu.

    Returns
    -------
    presets : tuple of Preset
    """
    article = scenarios()
    return (
        Preset(
            "hop", "It hops: 3.1 m/s",
            "Slips twice, then leaves the plane just before a full turn and flies for 0.76 s.",
            article["hop"],
        ),
        Preset(
            "slip", "It slips: 2.8 m/s",
            "Friction is used up twice a turn; each slip is weaker than the one before, and none is the last.",
            article["slipping"],
        ),
        Preset(
            "roll", "It rolls: 2 m/s",
            "Pure rolling, faster and more even than after a slow start, and close to the limit of friction.",
            article["faster"],
        ),
        Preset(
            "slow", "The smallest push: 0.1 m/s",
            "Nearly at rest with the load up, fast with the load down; 38 % of the friction is used.",
            article["slow"],
        ),
        Preset(
            "slippery", "Low friction: 0.1 m/s, μ = 0.3",
            "Slipping costs the energy that a full turn needs: the hoop rocks to and fro.",
            article["low_friction"],
        ),
        Preset(
            "littlewood", "All mass in the load",
            "A massless ring: at 90° no contact force is left; the load falls, the rim skims the plane.",
            _rolling(0.1, duration=3.0, load_fraction=1.0),
        ),
        Preset(
            "hops-for-ever", "It hops for ever: 3°, γ = 0.5",
            "It soon hops once in every revolution, always at the same place: a gait.",
            _downhill(4.0, 3.0, 0.5, 10.0),
        ),
        Preset(
            "moon", "On the Moon",
            "The article's hop under lunar gravity: everything is slower by a factor of 2.46.",
            Scenario(
                plane=Plane(gravity=1.62),
                start=Start.rolling(3.1 * math.sqrt(1.62 / 9.81)),
                duration=15.0,
            ),
        ),
        Preset(
            "littlewood-fast", "All mass in the load, pushed",
            "With a push the contact force is gone earlier, at cos θ = v₀²/(gR).",
            _rolling(2.0, duration=3.0, load_fraction=1.0),
        ),
        Preset(
            "nearly-massless", "Nearly all mass in the load",
            "γ = 0.99: what a real ring does instead of Littlewood's hop.",
            _rolling(0.1, duration=6.0, load_fraction=0.99),
        ),
        Preset(
            "inconsistent", "Painlevé: no solution",
            "No contact force agrees with this slip. An impact without collision stops it at once.",
            Scenario(plane=Plane(mu=1.2), start=Start(angle=-0.7, vx=3.0, omega=1.0), duration=3.0),
        ),
        Preset(
            "indeterminate", "Painlevé: two solutions",
            "Flight and impact both agree with the laws. "
            "Choose one under ‘Advanced’ (in the simple view, press ‘Everything’ first).",
            Scenario(plane=Plane(mu=1.2), start=Start(angle=-0.7, vx=8.0, omega=5.0), duration=3.0),
        ),
        Preset(
            "jam", "Dynamic jam",
            "A fast slide after a hop: the contact force grows without bound in finite time, and "
            "no law says what follows.",
            Scenario(hoop=Hoop.ideal(0.9), start=Start(angle=5.14, vx=23.0, omega=5.6), duration=3.0),
        ),
        Preset(
            "kane", "Kane: energy out of nothing",
            "Newton's law of impact with friction creates two joules. Stronge's law does not.",
            Scenario(
                plane=Plane(mu=0.6, restitution=0.8, impact_law="newton"),
                start=Start(angle=1.45, vx=2.16, omega=-6.44, height=0.3),
                duration=1.5,
            ),
        ),
        Preset(
            "gear", "Second gear: 3°, γ = 0.15",
            "One hop in two revolutions, for ever. A slower start settles in first gear: one hop in each.",
            _downhill(16.5, 3.0, 0.15, 6.0),
        ),
        Preset(
            "chaos", "Chaos: 4°",
            "It goes on for ever and never repeats itself: sometimes it hops, sometimes it does not.",
            _downhill(2.0, 4.0, 0.75, 20.0),
        ),
        Preset(
            "standstill", "Stopped by a hop: 10°",
            "The landing takes so much energy that the load never gets over the top again: the hoop rocks on the slope.",
            _downhill(1.5, 10.0, 0.75, 12.0),
        ),
        Preset(
            "worksheet", "The worksheet's hoop: 0.4 m",
            "R = 0.4 m, γ = 0.75, μ = 1: change the speed, and fill in the table.",
            _rolling(1.0, duration=1.5, radius=0.4),
        ),
        Preset(
            "downhill", "Downhill",
            "On a slope of 10° the hoop gains speed from turn to turn, until it hops.",
            Scenario(plane=Plane(mu=0.8, slope=math.radians(10.0)), start=Start.rolling(1.5), duration=5.0),
        ),
        Preset(
            "bounces", "Bounces without number",
            "Dropped with spin and restitution 0.5: infinitely many bounces in finite time.",
            Scenario(
                plane=Plane(mu=0.4, restitution=0.5),
                start=Start(height=0.5, angle=0.4, vx=0.2, omega=2.0),
                duration=4.0,
            ),
        ),
    )  # fmt: skip
