"""The derivatives of the page, in Node with the WebAssembly module, are those of Python: every bit of them."""

from __future__ import annotations

import json
import math

import numpy as np

import hophoop as hh
from bits_tools import kept_scenarios
from hophoop.derivatives.parameters import PATHS, allowed_sides, value_of
from hophoop.derivatives.results.propagation import propagate
from hophoop.lab.wasm.layout import CHANGE_COLUMNS
from model.test_page_model import answers
from module.module_tools import rates_of, same
from web_tools import needs_node

pytestmark = needs_node

RING, LOAD = hh.Ring(0.5, 0.45, 0.5), hh.PointMass(0.5, at=0.45)
EDGES = [
    "plane.gravity=0", "plane.mu=inf", "hoop.load_fraction=0", "hoop.load_fraction=1", "plane.restitution=1",
    "plane.mu_static=inf&plane.mu_kinetic=0.5", "plane.mu_static=0.6&plane.mu_kinetic=0.5", "start.speed=0",
    "plane.slope=1.57", "start.vx=1&start.omega=-0.0&hoop.radius=0.3", "hoop.mass=1e12",
    "hoop.eccentricity=1&hoop.inertia_ratio=0", "hoop.eccentricity=0&hoop.inertia_ratio=1", "plane.rolling_resistance=0.02",
    "hoop.eccentricity=0.3&hoop.inertia_ratio=1e-12",
]  # fmt: skip
PARTS = hh.Scenario(hoop=hh.Hoop.from_parts(0.5, [RING, LOAD]), duration=2.0)


def scenarios() -> list[hh.Scenario]:
    found = [each.scenario for each in kept_scenarios(every=12)] + [hh.Scenario.from_query(query) for query in EDGES]
    found += [PARTS, PARTS.replace("start", hh.Start(vx=1.0, omega=2.0))]
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


# motions that doubles decide, with parameters that go to one side, to both alike and to both with other derivatives
MOVED = [
    "duration=2", "start.height=0.3&start.vx=1&start.omega=2&plane.mu=0.3&plane.restitution=0.5&duration=1.2",
    "plane.rolling_resistance=0.02&duration=3", "plane.mu_static=0.6&plane.mu_kinetic=0.5&duration=2&plane.slope=0.1",
    "start.vx=1&start.omega=1&start.angle=1&plane.mu=0.1&duration=0.7", "plane.gravity=0&start.speed=1",
    "hoop.load_fraction=0.75&plane.restitution=1&duration=2", "hoop.load_fraction=1&start.speed=0.7&plane.mu=0.3",
]  # fmt: skip


def test_derivatives_of_all_events_are_those_of_python() -> None:
    asked = [(scenario, path) for scenario in [*map(hh.Scenario.from_query, MOVED), PARTS] for path in PATHS]
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
                events = [[side.at_event(k, field).rates[0] for field in CHANGE_COLUMNS] for k in range(len(motion.events))]
                assert same(decoded(found[name]), np.ravel(events)), f"{path} {name} of {scenario.to_query()}"
                compared += 1
    assert compared > 150
