"""The derivatives of the page, in Node with the WebAssembly module, are those of Python: every bit of them."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np

import hophoop as hh
from hophoop.derivatives.parameters import PATHS, allowed_sides, value_of
from hophoop.derivatives.results.propagation import propagate
from hophoop.lab.site import presets
from hophoop.lab.wasm.layout import CHANGE_COLUMNS
from model.test_page_model import answers
from module.module_tools import drawn, rates_of, references, same
from web_tools import needs_node

pytestmark = needs_node

RING, LOAD = hh.Ring(0.5, 0.45, 0.5), hh.PointMass(0.5, at=0.45)
EDGES = [
    "plane.gravity=0", "plane.mu=0", "plane.mu=inf", "hoop.load_fraction=0", "hoop.load_fraction=1", "plane.restitution=1",
    "plane.mu_static=inf&plane.mu_kinetic=0.5", "plane.mu_static=0.6&plane.mu_kinetic=0.5", "start.speed=0",
    "plane.slope=1.57", "start.vx=1&start.omega=0", "start.vx=1&start.omega=-0.0&hoop.radius=0.3",
    "start.speed=-1e6&duration=1e-9", "hoop.mass=1e12", "hoop.eccentricity=1&hoop.inertia_ratio=0",
    "hoop.eccentricity=0&hoop.inertia_ratio=1", "plane.rolling_resistance=0.02",
    "plane.gravity=1e-6&hoop.radius=1e-6&start.speed=0.1",
    "hoop.eccentricity=0.3&hoop.inertia_ratio=1e-12", "hoop.eccentricity=0.3&hoop.inertia_ratio=1e6",
]  # fmt: skip


def scenarios() -> list[hh.Scenario]:
    found = [preset.scenario for preset in presets.presets()] + references() + drawn(80)
    found += [hh.Scenario.from_query(query) for query in EDGES]
    found += [hh.Scenario(hoop=hh.Hoop.from_parts(radius, [RING, LOAD]), start=start)
              for radius in (0.5, 0.63) for start in (hh.Start.rolling(1.3), hh.Start(vx=1.0, omega=2.0))]  # fmt: skip
    return [scenario for scenario in found if scenario.contact.model == "rigid"]


def decoded(written: str) -> np.ndarray:
    """Doubles of the page, as their bytes in hexadecimal digits."""
    return np.frombuffer(bytes.fromhex(written), "<f8")


def of_python(scenario: hh.Scenario, path: str) -> tuple[np.ndarray, bool, bool] | None:
    """Rates of the cell, and to which sides the parameter may go; nothing where there is no derivative to any side."""
    try:
        rates = rates_of(scenario, (path,))[:, 0]
    except ValueError:
        return None
    smaller, larger = allowed_sides(scenario, path, value_of(scenario, path))
    return (rates, smaller, larger) if smaller or larger else None


def test_rates_of_a_scenario_are_those_of_python() -> None:
    asked = [(scenario, path) for scenario in scenarios() for path in PATHS]
    bodies = [{"scenario": scenario.to_dict(), "path": path} for scenario, path in asked]
    none = sides = 0
    for (scenario, path), answer in zip(asked, answers("rates", json.loads(json.dumps(bodies))), strict=True):
        found, expected = answer["value"], of_python(scenario, path)
        what = f"{path} of {scenario.to_query()}"
        if expected is None or found is None:
            assert found is expected, what
            none += 1
            continue
        rates, smaller, larger = expected
        assert same(decoded(found["rates"]), rates), what
        assert (found["smaller"], found["larger"]) == (smaller, larger), what
        sides += not (smaller and larger)
    assert none > 100
    assert sides > 100


def moved() -> list[tuple[hh.Scenario, str]]:
    """Motions that doubles decide, with parameters that go to one side, to both alike and to both with other derivatives."""
    queries = (
        "duration=2", "start.height=0.3&start.vx=1&start.omega=2&plane.mu=0.3&plane.restitution=0.5&duration=1.2",
        "plane.rolling_resistance=0.02&duration=3", "plane.mu_static=0.6&plane.mu_kinetic=0.5&duration=2&plane.slope=0.1",
        "start.vx=1&start.omega=1&start.angle=1&plane.mu=0.1&duration=0.7", "plane.gravity=0&start.speed=1",
        "hoop.load_fraction=0.75&plane.restitution=1&duration=2", "hoop.load_fraction=1&start.speed=0.7&plane.mu=0.3",
    )  # fmt: skip
    found = [hh.Scenario.from_query(query) for query in queries]
    found += [hh.Scenario(hoop=hh.Hoop.from_parts(0.5, [RING, LOAD]), duration=2.0)]
    return [(scenario, path) for scenario in found for path in PATHS]


def test_derivatives_of_all_events_are_those_of_python() -> None:
    asked = moved()
    bodies = [{"scenario": scenario.to_dict(), "path": path} for scenario, path in asked]
    compared = 0
    for (scenario, path), answer in zip(asked, answers("changes", bodies), strict=True):
        found, expected = answer["value"], of_python(scenario, path)
        if expected is None or found is None:
            assert found is expected, f"{path} of {scenario.to_query()}"
            continue
        motion = hh.simulate(scenario)
        assert math.isinf(motion.doubt)
        _, smaller, larger = expected
        upward = propagate(motion, (path,))
        downward = propagate(motion, (path,), -1.0) if upward.one_sided else upward
        assert found["count"] == len(motion.events)
        for name, side, allowed in (("larger", upward, larger), ("smaller", downward, smaller)):
            assert (found[name] is not None) == allowed
            if allowed:
                assert same(decoded(found[name]), table(side, len(motion.events))), f"{path} {name} of {scenario.to_query()}"
                compared += 1
    assert compared > 150


def table(carried: Any, count: int) -> np.ndarray:
    """Rates of all events, a row each, as the module gives them."""
    return np.array([carried.at_event(k, field).rates[0] for k in range(count) for field in CHANGE_COLUMNS])
