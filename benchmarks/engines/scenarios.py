"""The motions of the benchmark as scenarios of hophoop, from which make_truth.py makes its data."""

from __future__ import annotations

import math
from dataclasses import dataclass

from task import Task

from hophoop.scenario import Hoop, Plane, Scenario, Start


@dataclass(frozen=True)
class BenchScenario:
    """One motion: its name, title, what it asks of an engine, all numbers, and whether it counts.

    The others are shown, because rigid contact has no one answer there, or all but none.
    """

    name: str
    title: str
    why: str
    scenario: Scenario
    scored: bool = True


def _article(speed: float, duration: float, mu: float = 1.0, slope: float = 0.0) -> Scenario:
    return Scenario(
        hoop=Hoop.ideal(0.75),
        plane=Plane(mu=mu, slope=slope),
        start=Start.rolling(speed),
        duration=duration,
    )


MOTIONS = (
    BenchScenario("rolling", "pure rolling, v₀ = 2 m/s", "Nothing slips and no energy may be lost.", _article(2.0, 3.0)),
    BenchScenario(
        "slip",
        "slip without a hop, v₀ = 2.8 m/s",
        "Four times from rolling to slip, ahead and behind, and back, without leaving the plane.",
        _article(2.8, 2.5),
    ),
    BenchScenario(
        "hop",
        "the hop, v₀ = 3.1 m/s",
        "The article's motion: it rolls, skids, rolls, spins, takes off, lands without a bounce and rolls.",
        _article(3.1, 2.0),
    ),
    BenchScenario(
        "rocking",
        "rocking on low friction, v₀ = 0.1 m/s, μ = 0.3",
        "A slow start from the top, seven changes between rolling and slip, and a turning point.",
        _article(0.1, 5.0, mu=0.3),
    ),
    BenchScenario(
        "slope", "down a slope of 10°, v₀ = 1.5 m/s, μ = 0.8", "Gravity has a part along the plane.",
        _article(1.5, 2.25, mu=0.8, slope=math.radians(10.0)),
    ),
    BenchScenario(
        "bounces",
        "bounces with e = 0.6",
        "Newton's law of restitution, which most engines state as theirs, at a contact off the centre of gravity.",
        Scenario(
            hoop=Hoop.ideal(0.75),
            plane=Plane(mu=0.4, restitution=0.6, impact_law="newton"),
            start=Start(height=0.5, angle=0.4, vx=0.2, omega=2.0),
            duration=2.0,
        ),
    ),
    BenchScenario(
        "drop",
        "a drop with spin, e = 0",
        "One landing off the centre of gravity, with slip that it stops.",
        Scenario(
            hoop=Hoop.ideal(0.75),
            plane=Plane(mu=0.5),
            start=Start(height=0.5, angle=0.7, vx=0.3, omega=6.0),
            duration=2.0,
        ),
    ),
    BenchScenario(
        "painleve",
        "Painlevé's paradox at the start",
        "Slip that no contact force can carry: here an impact without collision resolves it, others may choose otherwise.",
        Scenario(hoop=Hoop.ideal(0.75), plane=Plane(), start=Start(angle=-math.acos(0.75), vx=1.0), duration=0.375),
        scored=False,
    ),
    BenchScenario(
        "border",
        "close to the boundary of hopping, v₀ = 2.909 m/s",
        "Below 2.90816 m/s it does not leave the plane; here it hops by 0.25 mm.",
        _article(2.909, 2.0),
        scored=False,
    ),
)  # fmt: skip
SCENARIOS = {one.name: one for one in MOTIONS}


def task_of(bench: BenchScenario) -> Task:
    """Return the task of a motion."""
    scenario = bench.scenario
    hoop, plane, start = scenario.hoop, scenario.plane, scenario.start.state(scenario.hoop)
    return Task(
        name=bench.name,
        radius=hoop.radius,
        mass=hoop.mass,
        eccentricity=hoop.eccentricity,
        inertia=hoop.inertia_ratio * hoop.mass * hoop.radius**2,
        gravity=plane.gravity,
        slope=plane.slope,
        mu=plane.mu_kinetic,
        restitution=plane.restitution,
        x=start.x,
        height=start.height,
        angle=start.angle,
        vx=start.vx,
        vy=start.vy,
        omega=start.omega,
        duration=scenario.duration,
    )
