"""Scenarios as the numbers that the module takes, and what the library itself computes of them."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np

import hophoop as hh
from hophoop.derivatives.parameters import change_of
from hophoop.maps.cells import make_cells
from hophoop.maps.kernel import CELL
from hophoop.physics.body import EVENT_NAMES, MODE_LETTERS
from oracle_program import simulate
from oracles.cases import Case
from random_scenarios import draw, scenario_of

DATA = Path(__file__).parents[1] / "data"
SEED = 20261122


def cell_of(scenario: hh.Scenario) -> np.ndarray:
    """The row of `maps.kernel.CELL` of one scenario."""
    cell: np.ndarray = make_cells(scenario, {}, 1)[:, 0]
    return cell


def rates_of(scenario: hh.Scenario, paths: tuple[str, ...]) -> np.ndarray:
    """How the cell of a scenario changes with each parameter."""
    rates = np.zeros((len(CELL), len(paths)))
    for k, path in enumerate(paths):
        change = change_of(scenario, path)
        for i, name in enumerate(CELL):
            rates[i, k] = change.start.get(name, 0.0) if name in change.start else getattr(change, name, 0.0)
    return rates


def drawn(count: int, first: int = 0) -> list[hh.Scenario]:
    """Random scenarios of every kind; those that are not allowed are left out."""
    found = []
    for index in range(first, first + count):
        try:
            found.append(scenario_of(draw(SEED, index)[1], max_events=500))
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


def worst_time(events: np.ndarray, motion: hh.Trajectory) -> float:
    """Largest difference of an event's time, beside the duration; infinite where kinds or modes differ."""
    if len(events) != len(motion.events):
        return math.inf
    worst = 0.0
    for row, event in zip(events, motion.events, strict=True):
        if EVENT_NAMES[int(row[1])] != event.kind or MODE_LETTERS[int(row[3])] != event.to_mode:
            return math.inf
        worst = max(worst, abs(float(row[0]) - event.t))
    return worst / motion.scenario.duration
