"""Scenarios of every kind drawn at random, for tests and benchmarks alike; (seed, index) alone tells which."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import hophoop as hh

EVENTS = 2000  # beyond these an elastic or nearly elastic bouncing is cut off


def draw(seed: int, index: int) -> tuple[int, dict[str, Any]]:
    """(kind of hoop, sections of a scenario) of a motion."""
    random = np.random.default_rng([seed, index])
    kind = int(random.choice(3, p=[0.48, 0.47, 0.05]))
    hoop: dict[str, Any] = {"radius": float(10 ** random.uniform(-1, 0.5)), "mass": float(10 ** random.uniform(-1, 1))}
    if kind == 0:
        hoop["load_fraction"] = float(random.random() ** 0.5 * 0.999)
    elif kind == 1:
        eccentricity = float(random.random())
        hoop["eccentricity"] = eccentricity
        within = float(random.random() * (1 - eccentricity**2))
        spread = float(10 ** random.uniform(-4, 0.5))
        hoop["inertia_ratio"] = max(within if random.random() < 0.7 else spread, 1e-6)
    else:
        hoop["load_fraction"] = 1.0 - float(10 ** random.uniform(-12, -3))
    static = float(10 ** random.uniform(-2, 1))
    near = random.random()
    if near < 0.1:
        static = 0.0
    elif near < 0.2 and kind == 0:  # just beside the least friction of Painlevé's paradox
        gamma = max(hoop["load_fraction"], 0.1)
        static = math.sqrt(1 - gamma**2) / gamma * (1 + float(random.normal()) * 10 ** float(random.uniform(-8, -1)))
    elif near < 0.23:
        static = math.inf
    plane: dict[str, Any] = {
        "gravity": 0.0 if random.random() < 0.1 else 9.81,
        "slope": 0.0 if random.random() < 0.6 else float(random.uniform(-1.2, 1.2)),
        "mu_static": static,
        "mu_kinetic": static * (float(random.random()) if random.random() < 0.3 and math.isfinite(static) else 1.0),
        "restitution": float(random.choice([0.0, random.random(), 1.0], p=[0.5, 0.4, 0.1])),
        "impact_law": str(random.choice(["stronge", "newton", "poisson"])),
        "painleve": str(random.choice(["flight", "impact"])),
    }
    speed = math.sqrt(hoop["radius"] * 9.81)
    angle = float(random.choice([0.0, random.uniform(-4, 4)], p=[0.2, 0.8]))
    state = {"angle": angle, "vx": float(random.normal() * 1.3 * speed)}
    spin = float(random.normal() * 1.6 * speed / hoop["radius"])
    chosen = random.random()
    if chosen < 0.35:
        start = {"speed": state["vx"], "angle": angle}
    elif chosen < 0.7:
        start = {**state, "omega": spin}
    else:
        height = 0.0 if random.random() < 0.3 else float(random.random() * 2 * hoop["radius"])
        start = {**state, "omega": spin, "height": height, "vy": float(random.normal() * speed)}
    duration = float(random.choice([6.0, 20.0])) * math.sqrt(hoop["radius"] / 9.81)
    return kind, {"hoop": hoop, "plane": plane, "start": start, "duration": duration}


def scenario_of(sections: dict[str, Any], max_events: int = EVENTS) -> hh.Scenario:
    """The sections as a scenario for `simulate`."""
    return hh.Scenario(
        hoop=hh.Hoop(**sections["hoop"]),
        plane=hh.Plane(**sections["plane"]),
        start=hh.Start(**sections["start"]),
        duration=sections["duration"],
        contact=hh.Rigid(max_events=max_events),
    )
