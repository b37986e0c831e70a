"""Derivatives of events from motions in 30 digits, by differences of four points: `python tests/oracles/derivatives.py`.

Writes tests/data/derivatives.json. It knows nothing of how derivatives are computed: it only changes a parameter a
little, in doubles that are exactly a power of two apart, and solves each motion by the series of `hophoop.precise`.
With a step of 2⁻²⁰ of the parameter the differences have some 20 digits right.
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Sequence
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import Any

import hophoop as hh
from hophoop.derivatives.parameters import value_of

FILE = Path(__file__).parents[1] / "data" / "derivatives.json"
STEP = -20  # power of two, beside the parameter
FIELDS = ("t", "x", "height", "angle", "omega", "slip", "vy", "impact_normal", "impact_tangential", "friction")
RESISTED = "rolling_resistance"  # where there is some
OF_IMPACT = ("before_omega", "before_slip", "before_vy", "impulse_normal", "impulse_tangential")
REPEATED = ("impact", "apex")  # doubles close endless bounces sooner

ROLLING = ("start.speed", "hoop.load_fraction", "plane.mu", "plane.gravity", "hoop.radius", "start.angle")
ROUGH = ("start.speed", "hoop.eccentricity", "hoop.inertia_ratio", "plane.mu_static", "plane.mu_kinetic")
FREE = ("start.vx", "start.omega", "start.angle", "hoop.eccentricity", "hoop.inertia_ratio", "plane.mu_kinetic")
THROWN = (*FREE, "start.height", "start.vy", "plane.restitution")
TILTED = ("start.speed", "plane.slope", "hoop.load_fraction", "plane.mu")
RESISTANCE = "plane.rolling_resistance"

# Name: the scenario as a query, and the parameters.
CASES: dict[str, tuple[str, tuple[str, ...]]] = {
    "hop": (
        "duration=2&start.speed=3.1&start.angle=0.1",
        (*ROLLING, "hoop.mass", "duration"),
    ),
    "slope": (
        "duration=2&start.speed=3.1&plane.slope=0.1&plane.mu=0.6",
        TILTED,
    ),
    "static_above_kinetic": (
        "duration=2&start.speed=3.1&plane.mu_static=0.9&plane.mu_kinetic=0.6",
        ROUGH,
    ),
    "many_slips": (
        "duration=5&start.speed=0.5&plane.mu=0.3",
        ("start.speed", "hoop.load_fraction", "plane.mu"),
    ),
    "oscillation": (
        "duration=5&hoop.load_fraction=0.5&start.speed=0.3&start.angle=2",
        ("start.speed", "hoop.load_fraction", "plane.mu", "start.angle"),
    ),
    "slip_from_rest": (
        "duration=5&hoop.load_fraction=0.5&start.speed=0&start.angle=1&plane.mu=0.15",
        ("start.speed", "hoop.load_fraction", "plane.mu", "start.angle"),
    ),
    "roll_from_rest": (
        "duration=3&start.speed=0&start.angle=1&plane.mu=1",
        ("start.speed", "hoop.load_fraction", "plane.mu", "start.angle"),
    ),
    "over_the_top": (
        "duration=6&start.speed=-2.6&start.angle=2&plane.mu=inf",
        ("start.speed", "hoop.load_fraction", "start.angle"),
    ),
    "skid": (
        "duration=2&start.vx=4&start.omega=1&start.angle=0.3&plane.mu_static=0.5&plane.mu_kinetic=0.4",
        (*FREE, "hoop.radius"),
    ),
    "spin_hops_at_once": (
        "duration=2&start.vx=-1&start.omega=5&start.angle=0.3&plane.slope=-0.1&plane.mu=0.4",
        ("start.vx", "start.omega", "start.angle", "hoop.eccentricity", "hoop.inertia_ratio", "plane.slope", "plane.mu"),
    ),
    "hop_at_once": (
        "duration=0.6&start.speed=3.9",
        ("start.speed", "hoop.load_fraction", "plane.mu"),
    ),
    "rolls_off": (
        "duration=2&hoop.load_fraction=0.71&plane.slope=0.84&plane.mu=2.8&start.angle=2.04&start.speed=0.74",
        TILTED,
    ),
    "quasi_jump": (
        "duration=2&start.speed=3.1&plane.mu=inf",
        ("start.speed", "hoop.load_fraction"),
    ),
    "stronge": (
        "duration=1.2&start.height=0.5&start.vx=4&start.vy=0.3&start.omega=-3&start.angle=0.9"
        "&plane.restitution=0.7&plane.mu_static=0.6&plane.mu_kinetic=0.4",
        THROWN,
    ),
    "newton": (
        "duration=0.9&start.height=0.5&start.vx=1&start.vy=0.3&start.omega=3&start.angle=0.3&plane.restitution=0.6"
        "&plane.impact_law=newton&plane.mu_static=0.4&plane.mu_kinetic=0.3",
        THROWN,
    ),
    "poisson": (
        "duration=1&start.height=0.5&start.vx=2&start.vy=0.3&start.omega=-1&start.angle=1.3&plane.restitution=0.4"
        "&plane.impact_law=poisson&plane.mu_static=0.6&plane.mu_kinetic=0.5",
        THROWN,
    ),
    "reversal_in_impact": (
        "duration=0.4&start.height=0.05&start.angle=-1.2&start.vx=0.6&start.vy=0.1&start.omega=-0.5"
        "&hoop.eccentricity=0.8&hoop.inertia_ratio=0.1&plane.mu_static=0.15&plane.mu_kinetic=0.1"
        "&plane.restitution=0.4",
        THROWN,
    ),
    "endless_bounces": (
        "duration=2.5&start.height=0.3&start.vx=1&start.vy=0.3&start.omega=3&start.angle=2.9&plane.restitution=0.5"
        "&plane.mu=0.3",
        ("start.omega", "plane.restitution", "hoop.load_fraction"),
    ),
    "infinite_friction": (
        "duration=0.9&start.height=0.3&start.vx=1&start.vy=0.3&start.omega=3&start.angle=0.9&plane.restitution=0.5"
        "&plane.mu=inf",
        ("start.omega", "plane.restitution", "start.angle", "hoop.eccentricity"),
    ),
    "impact_without_collision": (
        "duration=0.9&start.angle=-0.7&start.vx=3&start.omega=1&plane.mu_static=1.3&plane.mu_kinetic=1.2"
        "&plane.restitution=0.3&plane.impact_law=poisson",
        (*FREE, "plane.restitution"),
    ),
    "indeterminate_as_impact": (
        "duration=0.9&start.angle=-0.7&start.vx=8&start.omega=5&plane.mu_static=1.3&plane.mu_kinetic=1.2&plane.painleve=impact",
        FREE,
    ),
    "jam": (
        "duration=1&start.angle=-2.312&start.vx=30.37&start.omega=5.654&plane.mu_static=1.219&plane.mu_kinetic=1.21",
        FREE,
    ),
    "massless_sticks": (
        "duration=3&hoop.load_fraction=1&start.speed=1&plane.mu=0.9",
        ("start.speed", "start.angle", "plane.gravity"),
    ),
    "massless_slides": (
        "duration=3&hoop.load_fraction=1&start.speed=2&start.angle=0.2&plane.mu=0.3",
        ("start.speed", "plane.mu", "start.angle"),
    ),
    "rest_in_the_valley": (
        "duration=2&plane.slope=0.1&start.speed=0&start.angle=3.0&plane.mu=0.05",
        TILTED,
    ),
    "rest_on_the_hilltop": (
        "duration=1.5&start.speed=0",
        ROLLING,
    ),
    "frictionless": (
        "duration=2&start.speed=0.5&start.angle=0.2&plane.mu=0",
        ("start.speed", "start.angle", "hoop.load_fraction"),
    ),
    "no_gravity": (
        "duration=2&start.vx=3&start.omega=2&start.angle=2.2&plane.gravity=0&plane.mu_static=0.4&plane.mu_kinetic=0.3",
        FREE,
    ),
    "backwards": (
        "duration=3&start.speed=-2.9&start.angle=-1&plane.slope=0.05&plane.mu=0.7",
        TILTED,
    ),
    "resisted_hop": (
        "duration=2&start.speed=3.1&start.angle=0.1&plane.rolling_resistance=0.005",
        ("start.speed", "hoop.load_fraction", "plane.mu", "plane.gravity", "hoop.radius", "hoop.mass", RESISTANCE),
    ),
    "resisted_slope": (
        "duration=3&start.speed=3.1&plane.slope=0.1&plane.mu_static=0.6&plane.mu_kinetic=0.5&plane.rolling_resistance=0.02",
        ("plane.slope", "plane.mu_static", "plane.mu_kinetic", RESISTANCE),
    ),
    "rocks_to_rest": (
        "duration=8&hoop.load_fraction=0.5&start.speed=0.3&start.angle=2&plane.rolling_resistance=0.1",
        ("start.speed", "hoop.load_fraction", RESISTANCE),
    ),
    "turns_slipping": (
        "duration=4&hoop.load_fraction=0.5&start.speed=0&start.angle=1&plane.mu=0.15&plane.rolling_resistance=0.01",
        ("hoop.load_fraction", "plane.mu", "start.angle", RESISTANCE),
    ),
    "turns_into_slip": (
        "duration=3&hoop.eccentricity=0.1&hoop.inertia_ratio=0.9&start.speed=-2&plane.slope=0.3"
        "&plane.mu=0.15&plane.rolling_resistance=0.1",
        ("start.speed", "plane.slope", RESISTANCE),
    ),
    "slides_without_turning": (
        "duration=3&hoop.eccentricity=0.3&hoop.inertia_ratio=0.8&start.vx=3&start.omega=-2&start.angle=3"
        "&plane.mu_static=0.18&plane.mu_kinetic=0.1&plane.rolling_resistance=0.2",
        ("start.omega", "hoop.inertia_ratio", "plane.mu_kinetic", RESISTANCE),
    ),
    "slides_to_rest": (
        "duration=3&hoop.eccentricity=0.02&hoop.inertia_ratio=0.8&start.vx=2&start.omega=-1&start.angle=3"
        "&plane.mu_static=0.3&plane.mu_kinetic=0.1&plane.rolling_resistance=0.2",
        ("start.vx", "hoop.eccentricity", "plane.mu_kinetic", RESISTANCE),
    ),
    "resisted_bounces": (
        "duration=2.5&start.height=0.3&start.vx=1&start.vy=0.3&start.omega=3&start.angle=2.9&plane.restitution=0.5"
        "&plane.mu=0.3&plane.rolling_resistance=0.03",
        ("start.omega", "plane.restitution", RESISTANCE),
    ),
    "resisted_rolling": (
        "duration=2&start.speed=2.5&start.angle=0.2&plane.mu=inf&plane.rolling_resistance=0.02",
        ("start.speed", "hoop.eccentricity", RESISTANCE),
    ),
    "resisted_jam": (
        "duration=1&start.angle=-2.312&start.vx=30.37&start.omega=5.654&plane.mu_static=1.219&plane.mu_kinetic=1.21"
        "&plane.rolling_resistance=0.001",
        ("start.angle", "hoop.eccentricity", RESISTANCE),
    ),
    "resisted_without_gravity": (
        "duration=2&start.vx=3&start.omega=2&start.angle=2.2&plane.gravity=0&plane.mu_static=0.4&plane.mu_kinetic=0.3"
        "&plane.rolling_resistance=0.02",
        ("start.vx", RESISTANCE),
    ),
}
PARTS = ("hoop.parts.0.mass", "hoop.parts.0.inner_radius", "hoop.parts.1.at", "hoop.parts.1.radius", "hoop.parts.2.length")


def scenario_of(name: str) -> hh.Scenario:
    """The scenario of a case."""
    if name == "parts":
        parts = [hh.Ring(0.25, 0.4375, 0.5), hh.Disk(0.75, 0.0625, at=0.375), hh.Rod(0.125, 0.5, at=0.125)]
        return hh.Scenario(duration=1.5, hoop=hh.Hoop.from_parts(0.5, parts), start=hh.Start.rolling(3.0))
    return hh.Scenario.from_query(CASES[name][0])


def neighbours(scenario: hh.Scenario, path: str) -> tuple[Decimal, list[Any]]:
    """The step and the four motions beside this one."""
    value = value_of(scenario, path)
    step = 2.0 ** ((math.floor(math.log2(abs(value))) if value else 0) + STEP)
    motions = []
    for side in (-2, -1, 1, 2):
        changed = scenario.with_values({path: value + side * step})
        assert value_of(changed, path) - value == side * step
        motions.append(hh.simulate(changed, digits=30))
    return Decimal(step), motions


def differences(scenario: hh.Scenario, path: str) -> dict[str, dict[str, str]]:
    """Derivatives of each event that all four motions have, by "kind place" and field."""
    step, motions = neighbours(scenario, path)
    found: dict[str, dict[str, str]] = {}
    for kind in dict.fromkeys(event.kind for event in motions[0].events):
        columns = [motion.find(kind) for motion in motions]
        counts = {len(column) for column in columns}
        if len(counts) > 1 and kind not in REPEATED:
            continue
        for place in range(min(min(counts), 5) if kind in REPEATED else min(counts)):
            events = [column[place] for column in columns]
            key = f"{kind} {place}"
            found[key] = {}
            lost = (RESISTED,) if scenario.plane.rolling_resistance else ()
            for field in FIELDS + lost + (OF_IMPACT if kind in ("impact", "bounce_limit") else ()):
                low, less, more, high = (number_of(event, field) for event in events)
                rate = (low - 8 * less + 8 * more - high) / (12 * step)
                if rate.is_finite():
                    found[key][field] = f"{rate:.17e}" if rate else "0"
    return found


@cache
def solved(scenario: hh.Scenario) -> Any:
    """A motion in 30 digits; derivatives of several quantities are read from the same ones."""
    return hh.simulate(scenario, digits=30)


def one_sided(scenario: hh.Scenario, path: str, step: float, of: Sequence[str]) -> list[float]:
    """Derivatives to one side, from five motions, of fields of the last events of a kind such as "turn.t"."""
    weights = (Decimal(-25) / 12, Decimal(4), Decimal(-3), Decimal(4) / 3, Decimal(-1) / 4)
    value = value_of(scenario, path)
    motions = [solved(scenario.with_values({path: value + n * step})) for n in range(5)]
    names = [name.split(".") for name in of]
    columns = [[getattr(each.find(kind)[-1], field) for each in motions] for kind, field in names]
    return [float(sum(w * one for w, one in zip(weights, column, strict=True)) / Decimal(step)) for column in columns]


def number_of(event: Any, field: str) -> Any:
    """A number of an event; `before_omega` is one of the velocities just before."""
    return getattr(event.before, field.removeprefix("before_")) if field.startswith("before_") else getattr(event, field)


def main(names: list[str]) -> None:
    """Write the derivatives of some cases, or of all."""
    data = json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}
    for name in names or [*CASES, "parts"]:
        scenario = scenario_of(name)
        paths = PARTS if name == "parts" else CASES[name][1]
        data[name] = {path: differences(scenario, path) for path in paths}
        FILE.write_text(json.dumps(data, indent=0, sort_keys=True) + "\n", encoding="utf-8")
        print(name, hh.simulate(scenario).sequence, flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
