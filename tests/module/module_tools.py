"""Scenarios as the numbers that the module takes, and what the library itself computes of them."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np

import hophoop as hh
from hophoop.maps.grid.cells import make_cells
from oracle_program import simulate
from oracles.cases import Case
from random_scenarios import draw, scenario_of

DATA = Path(__file__).parents[1] / "data"
SEED = 20261122


def same(found: Any, expected: Any) -> bool:
    """Whether all bits are equal; every nan is one."""
    one, other = np.asarray(found, float), np.asarray(expected, float)
    nan = np.isnan(one)
    if one.shape != other.shape or (nan != np.isnan(other)).any():
        return False
    return bool((one[~nan].view(np.int64) == other[~nan].view(np.int64)).all())


def cell_of(scenario: hh.Scenario) -> np.ndarray:
    """The row of `records.cells.CELL` of one scenario."""
    cell: np.ndarray = make_cells(scenario, {}, 1)[:, 0]
    return cell


def given_of(scenario: hh.Scenario) -> dict[str, Any]:
    """A scenario as the page hands it to the kernel (`Given` of web/types.d.ts)."""
    hoop, plane, start = scenario.hoop, scenario.plane, scenario.start
    state = start.state(hoop)
    return {
        "radius": hoop.radius, "mass": hoop.mass, "eccentricity": hoop.eccentricity, "inertia_ratio": hoop.inertia_ratio,
        "ideal": hoop.load_fraction is not None, "gravity": plane.gravity, "slope": plane.slope,
        "rolling_resistance": plane.rolling_resistance,
        "mu_static": plane.mu_static if math.isfinite(plane.mu_static) else "inf",
        "mu_kinetic": plane.mu_kinetic if math.isfinite(plane.mu_kinetic) else "inf",
        "restitution": plane.restitution, "impact_law": plane.impact_law, "painleve": plane.painleve,
        "x": state.x, "height": state.height, "angle": state.angle, "vx": state.vx, "vy": state.vy, "omega": state.omega,
        "slip": state.slip, "rolling": start.speed is not None, "duration": scenario.duration,
        "max_events": scenario.contact.max_events, "contact": contact_of(scenario.contact),
    }  # fmt: skip


def contact_of(contact: hh.Rigid | hh.Compliant) -> dict[str, Any] | None:
    if isinstance(contact, hh.Rigid):
        return None
    names = (
        "stiffness", "damping", "restitution", "law", "friction", "slip_speed", "tangential_stiffness", "rtol",
    )  # fmt: skip
    return {name: getattr(contact, name) for name in names}


def drawn(count: int, first: int = 0) -> list[hh.Scenario]:
    """Random scenarios of every kind; those that are not allowed are left out."""
    found = []
    for index in range(first, first + count):
        try:
            found.append(scenario_of(draw(SEED, index), max_events=500))
        except ValueError:
            continue
    return found


def references() -> list[hh.Scenario]:
    """The scenarios of the files that hold solutions in 40 digits."""
    found = []
    for file in sorted(DATA.glob("*.json")):
        content = json.loads(file.read_text(encoding="utf-8"))
        if "case" in content and "events" in content:
            found.append(simulate(Case(**content["case"])).scenario)
    return found
