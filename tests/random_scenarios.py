"""Scenarios of every kind drawn at random, for tests and benchmarks alike; (seed, index) alone tells which."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import hophoop as hh
from hophoop.vocabulary.names import LAW_CODES

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
        "impact_law": str(random.choice(list(LAW_CODES))),
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


BORDERS = ("immediate hop", "first slip", "friction needed", "equilibrium", "hilltop", "Painlevé")


def draw_beside_a_border(seed: int, index: int) -> tuple[str, dict[str, Any]]:
    """(name of the border, sections of a scenario) of a motion that starts within a few roundings of a border of theory.

    Where theory has no such border for the hoop that is drawn, the next one is taken.
    """
    random = np.random.default_rng([seed, index, 1])
    radius = float(10 ** random.uniform(-1, 0.5))
    gamma = float(random.random() ** 0.5 * 0.99)
    mu = float(10 ** random.uniform(-1.5, 0.5))
    static = mu * (1.0 if random.random() < 0.7 else 1.0 + float(random.random()))
    slope = 0.0 if random.random() < 0.6 else float(random.uniform(-0.6, 0.6))
    hoop = {"radius": radius, "mass": 1.0, "load_fraction": gamma}
    plane: dict[str, Any] = {
        "gravity": 9.81, "slope": 0.0, "mu_static": static, "mu_kinetic": mu,
        "restitution": float(random.choice([0.0, 0.5])), "impact_law": "stronge", "painleve": "flight",
    }  # fmt: skip
    roundings = int(random.integers(-4, 5))

    def beside(value: float) -> float:
        return value + roundings * float(np.spacing(abs(value)))

    start: dict[str, Any] = {}
    for border in np.roll(BORDERS, -int(random.integers(len(BORDERS)))):
        start = {}
        if border == "immediate hop":
            start = {"speed": beside(math.sqrt(9.81 * radius / gamma)), "angle": 0.0}
        elif border == "first slip":
            speed = float(hh.theory.first_slip_speed(hh.Hoop(**hoop), hh.Plane(**plane)))
            if math.isfinite(speed) and speed > 0.0:
                start = {"speed": beside(speed), "angle": 0.0}
        elif border == "friction needed":
            speed = float(random.uniform(0.1, 0.9)) * math.sqrt(9.81 * radius / gamma)
            need = float(hh.theory.needed_friction(hh.Hoop(**hoop), speed, hh.Plane(**plane)).mu)
            if math.isfinite(need):
                plane["mu_static"] = plane["mu_kinetic"] = beside(need)
                start = {"speed": speed, "angle": 0.0}
        elif border == "equilibrium":
            plane["slope"] = slope
            found = hh.theory.equilibria(hh.Hoop(**hoop), hh.Plane(**plane))
            if found:
                start = {"speed": 0.0, "angle": beside(found[int(random.integers(len(found)))].angle)}
        elif border == "hilltop":
            start = {"speed": float(10 ** random.uniform(-20, -1)), "angle": 0.0}
        elif border == "Painlevé":
            angle = -float(random.uniform(0.2, 1.5))
            threshold = (1 - gamma * math.cos(angle)) / (gamma * math.sin(-angle))
            plane["mu_static"] = plane["mu_kinetic"] = beside(threshold)
            start = {"vx": float(random.uniform(1, 6)), "omega": float(random.uniform(-1, 3)), "angle": angle}
        if start:
            break
    duration = 6.0 * math.sqrt(radius / 9.81)
    return str(border), {"hoop": hoop, "plane": plane, "start": start, "duration": duration}
