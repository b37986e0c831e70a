"""Scenarios of the reference data: plain numbers, so that each oracle and the program read the same ones."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Case:
    """One scenario in SI units and radians; the numbers are taken as the exact values of the doubles."""

    name: str
    radius: float = 1.0
    mass: float = 1.0
    eccentricity: float = 0.75
    inertia_ratio: float = 0.4375
    gravity: float = 9.81
    slope: float = 0.0
    mu_static: float = 1.0
    mu_kinetic: float = 1.0
    restitution: float = 0.0
    impact_law: str = "stronge"
    painleve: str = "flight"
    x: float = 0.0
    height: float = 0.0
    angle: float = 0.0
    vx: float = 0.0
    vy: float = 0.0
    omega: float = 0.0
    rolling: bool = False  # omega is then exactly vx / radius, whatever its field says
    duration: float = 6.0
    rest_below: float = 0.0  # slower impacts [m/s] are plastic: this ends an accumulation of bounces
    rolling_resistance: float = 0.0  # lever arm of N over R
    max_events: int = 40  # state changes, impacts, turns and apexes together


def rolling(name: str, speed: float, mu: float, **others: float | str) -> Case:
    """A start in pure rolling with the given speed of the centre."""
    return Case(name, vx=speed, rolling=True, mu_static=mu, mu_kinetic=mu, **others)  # type: ignore[arg-type]


ARTICLE = (
    rolling("article_v0.1_mu1", 0.1, 1.0),
    rolling("article_v2_mu1", 2.0, 1.0),
    rolling("article_v2.8_mu1", 2.8, 1.0),
    rolling("article_v3.1_mu1", 3.1, 1.0),
    rolling("article_v0.1_mu0.3", 0.1, 0.3),
)

OTHERS = (
    rolling("slope_10deg", 1.5, 0.8, slope=math.radians(10.0), duration=4.0),
    Case("static_above_kinetic", vx=2.0, rolling=True, mu_static=0.6, mu_kinetic=0.4),
    rolling("general_body", 3.5, 0.5, eccentricity=0.4, inertia_ratio=0.5),
    rolling("scaled_body", 1.3, 0.4, radius=0.35, mass=2.2, eccentricity=0.6, inertia_ratio=0.3, duration=3.0),
    Case("dropped_with_spin", height=0.5, angle=0.7, vx=0.3, omega=6.0, mu_static=0.5, mu_kinetic=0.5),
    *(
        Case(
            f"bounces_{law}",
            height=0.5,
            angle=0.4,
            vx=0.2,
            omega=2.0,
            mu_static=0.4,
            mu_kinetic=0.4,
            restitution=0.5,
            impact_law=law,
            duration=3.0,
            max_events=17,
        )
        for law in ("newton", "poisson", "stronge")
    ),
    # bounces without end in finite time, closed where they are 1e-17 m/s small, and what follows them
    *(
        Case(
            f"accumulation_{law}",
            height=0.3,
            angle=angle,
            vx=0.5,
            omega=2.0,
            slope=slope,
            mu_static=mu,
            mu_kinetic=mu,
            restitution=restitution,
            impact_law=law,
            rest_below=1e-17,
            duration=duration,
            max_events=3000,
        )
        for law, restitution, mu, angle, slope, duration in (
            ("newton", 0.5, 0.4, 0.4, 0.0, 2.0),
            ("poisson", 0.8, 0.1, 2.0, 0.1, 3.0),
            ("stronge", 0.9, 0.3, 2.5, 0.0, 5.0),
        )
    ),
    rolling("rolling_back", -1.0, 1.0, angle=2.0),
    Case("spinning_start", angle=math.pi, omega=8.0, mu_static=0.5, mu_kinetic=0.5),
    Case("spinning_start_hops_at_once", omega=8.0, mu_static=0.5, mu_kinetic=0.5),
    Case("skidding_start", angle=5.0, vx=4.0, omega=-1.0, mu_static=0.3, mu_kinetic=0.2),
    rolling("immediate_hop", 4.0, 1.0),
    # not from the top: there the slip velocity would graze zero once a turn, and a graze is not a test of
    # digits
    rolling("frictionless", 0.5, 0.0, angle=0.2),
    rolling("frictionless_fast", 3.3, 0.0, angle=1.0, duration=4.0),
    Case(
        "impact_without_collision",
        angle=-0.7,
        vx=3.0,
        omega=1.0,
        mu_static=1.2,
        mu_kinetic=1.2,
        restitution=0.3,
        impact_law="poisson",
        duration=2.0,
        max_events=6,
    ),
    Case(
        "indeterminate_as_impact",
        angle=-0.7,
        vx=8.0,
        omega=5.0,
        mu_static=1.2,
        mu_kinetic=1.2,
        painleve="impact",
        duration=2.0,
    ),
    # slip comes within a hair of p = 0, the edge of the Painlevé region, and stops there in time: no jam
    Case(
        "narrow_escape_ideal",
        angle=-1.76,
        vx=22.16,
        omega=1.985,
        mu_static=1.365,
        mu_kinetic=1.365,
        duration=0.6,
    ),
    Case(
        "narrow_escape_fast",
        angle=-1.896,
        vx=26.62,
        omega=5.9,
        mu_static=1.352,
        mu_kinetic=1.352,
        duration=0.6,
    ),
    Case(
        "narrow_escape_slope",
        eccentricity=0.79594489775011,
        inertia_ratio=0.020647517490374176,
        slope=0.4075715758006839,
        mu_static=0.5235644207101874,
        mu_kinetic=0.3855999705760886,
        angle=1.1526905230864948,
        vx=2.3598820998676766,
        omega=-0.4148122693817507,
        duration=2.5,
    ),
    Case(
        "reversal_in_impact",
        height=0.05,
        angle=-1.2,
        vx=0.6,
        omega=-0.5,
        eccentricity=0.8,
        inertia_ratio=0.1,
        mu_static=0.15,
        mu_kinetic=0.1,
        restitution=0.4,
        duration=1.5,
        max_events=13,
    ),
)

CASES = ARTICLE + OTHERS

# A dynamic jam: p and the free acceleration vanish together. Without reference data: the solution has no
# digits to give beyond the instant that it comes to, which is known in closed form.
JAM = Case(
    "jam",
    angle=-2.312,
    vx=30.37,
    omega=5.654,
    mu_static=1.219,
    mu_kinetic=1.219,
    duration=1.0,
)


def by_name(name: str) -> Case:
    """The case of that name."""
    for case in CASES:
        if case.name == name:
            return case
    raise KeyError(name)


def case_of(hoop: Any, plane: Any, **start: float) -> Case:
    """The same hoop and plane as the oracles take them."""
    return Case(
        "theory",
        radius=hoop.radius,
        mass=hoop.mass,
        eccentricity=hoop.eccentricity,
        inertia_ratio=hoop.inertia_ratio,
        gravity=plane.gravity,
        slope=plane.slope,
        mu_static=plane.mu_static,
        mu_kinetic=plane.mu_kinetic,
        **start,
    )
