"""Numbers in the text of the report, formatted, all from computed motions."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Sequence
from importlib.resources import files
from typing import Any

from hophoop import theory
from hophoop.article.runs import Runs
from hophoop.article.statement import Statement, Texts
from hophoop.scenario import Hoop, Plane, PointMass, Ring, Start
from hophoop.simulation.simulate import simulate

TEXTS: dict[str, str] = tomllib.loads(files("hophoop.article").joinpath("facts.toml").read_text("utf-8"))


def facts(statements: Sequence[Statement], runs: Runs) -> dict[str, str]:
    """Return the numbers in the text of the report, by name; the statements are checked ones."""
    values = {one.key: one.numbers for one in statements} | _motions(runs) | _bodies()
    # no line break between number and unit
    return {name: Texts().format(text, **values).replace(" ", "\u00a0") for name, text in TEXTS.items()}


def _motions(runs: Runs) -> dict[str, Any]:
    hoop, plane, hop = runs.hoop, runs.plane, runs.motion("hop")
    off, down = hop.find("takeoff")[0], hop.find("impact")[0]
    return {
        "bottom_force": runs.extremes("slow", "normal_force")[1],
        "weight": hoop.mass * plane.gravity,
        "spin": runs.motion("slipping").find("slip_start")[1],
        "hop_slips": hop.find("slip_start"),
        "down": down,
        "flight_time": down.t - off.t,
        "flight_turn": down.angle - off.angle,
        "fall_speed": hoop.eccentricity * down.before.omega * math.sin(down.angle) - down.before.vy,  # of G
        "roll_rate": theory.rolling_speed(off.angle, hoop, 3.1, plane),
        "roll_hop_speed": theory.immediate_hop_speed(hoop, plane),
    }


def _bodies() -> dict[str, Any]:
    """Numbers for the article's comments: a hoop made of parts, and another radius and mass."""
    made = Hoop.from_parts(1.0, [Ring(mass=0.25, inner_radius=1.0, outer_radius=1.0), PointMass(mass=0.75, at=1.0)])
    hoop, small = Hoop.ideal(0.75), Hoop.ideal(0.75, radius=0.3, mass=2.0)
    speed = 3.1 * math.sqrt(small.radius)
    large, scaled = (
        simulate(one, Plane(), Start.rolling(v), duration=2.5).find("takeoff")[0] for one, v in ((hoop, 3.1), (small, speed))
    )
    wrong = Hoop(eccentricity=0.75, inertia_ratio=0.25)
    return {
        "made": made,
        "small": small,
        "small_speed": speed,
        "large": large,
        "scaled": scaled,
        "with_load": theory.max_rolling_speed(hoop, 0.1),
        "without_load": theory.max_rolling_speed(wrong, 0.1),
    }
