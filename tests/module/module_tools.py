"""Scenarios as the numbers that the module takes, and what the library itself computes of them."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

import hophoop as hh
from hophoop.derivatives.parameters import change_of
from hophoop.maps.cells import make_cells
from hophoop.maps.kernel import CELL
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
