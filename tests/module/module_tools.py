"""Scenarios as the numbers that the module takes, and what the library itself computes of them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

import hophoop as hh
from hophoop.maps.grid.cells import make_cells
from random_scenarios import draw, scenario_of

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
    hoop, plane, start, contact = scenario.hoop, scenario.plane, scenario.start, scenario.contact
    bound: dict[str, Any] | None = None
    if contact.model == "compliant":
        names = ("stiffness", "damping", "restitution", "law", "friction", "slip_speed", "tangential_stiffness", "rtol")
        bound = {name: getattr(contact, name) for name in names}
    numbers = {
        **{name: getattr(hoop, name) for name in ("radius", "mass", "eccentricity", "inertia_ratio")},
        "ideal": hoop.load_fraction is not None,
        **{name: getattr(plane, name) for name in hh.Plane.model_fields if name != "mu"},
        **start.state(hoop)._asdict(),
        "mode": start.mode,
        "rolling": start.speed is not None,
        "duration": scenario.duration,
        "max_events": contact.max_events,
        "contact": bound,
    }
    return {name: "inf" if one == math.inf else one for name, one in numbers.items()}


def drawn(count: int, first: int = 0) -> list[hh.Scenario]:
    """Random scenarios of every kind; those that are not allowed are left out."""
    found = []
    for index in range(first, first + count):
        try:
            found.append(scenario_of(draw(SEED, index), max_events=500))
        except ValueError:
            continue
    return found
