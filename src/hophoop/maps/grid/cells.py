"""Cells of the kernel for a whole chunk at once, equal to those of `scenario_at` one by one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.kernel.native import compiled
from hophoop.kernel.records import CELL, Cell, ideal_inertia, mark_refused
from hophoop.kernel.steps import BY_RULE
from hophoop.maps.grid.axes import scenario_at
from hophoop.scenario import InputError, Scenario, Start, cell_of
from hophoop.scenario.paths import ENDS
from hophoop.scenario.scenario import slip_agrees, why_not_in_mode
from hophoop.vocabulary.names import LAW_CODES
from hophoop.vocabulary.parameters import TABLE

Array = NDArray[Any]

_FREE = ("height", "vx", "vy", "omega")  # of a start that does not roll
# Rows of a cell that a parameter sets.
_ROWS: dict[str, tuple[int, ...]] = {
    **{row.path: (CELL.index(row.column),) for row in TABLE if row.column},
    "hoop.load_fraction": (Cell.ECCENTRICITY,),
    "plane.mu": (Cell.MU_STATIC, Cell.MU_KINETIC),
    "plane.impact_law": (Cell.LAW,),
    "plane.painleve": (Cell.PAINLEVE_IMPACT,),
}


def make_cells(base: Scenario, values: Mapping[str, Array], count: int) -> NDArray[np.float64]:
    """Return the kernel's cells of a chunk, shape (len(CELL), count), from the values of the varied parameters by path [SI].

    Rows are those of `records.cells.CELL`; cells with contradictory values are marked.
    """
    cells = np.repeat(np.array(cell_of(base), dtype=float)[:, np.newaxis], count, axis=1)
    hoop = {path: array for path, array in values.items() if path.startswith("hoop.")}
    if hoop and (base.hoop.parts is not None or any(path.startswith("hoop.parts") for path in hoop)):
        _put_hoops(cells, base, hoop)  # radius and mass are those of the parts
        values = {path: array for path, array in values.items() if path not in hoop}
    for path, array in values.items():
        if path == "plane.impact_law":
            array = np.array([LAW_CODES[word] for word in array])
        elif path == "plane.painleve":
            array = array == "impact"
        for row in _ROWS.get(path, ()):
            cells[row] = array
    if "hoop.load_fraction" in values:
        cells[Cell.INERTIA_RATIO] = ideal_inertia(cells[Cell.ECCENTRICITY])
        cells[Cell.IDEAL] = 1.0
    elif "hoop.eccentricity" in values or "hoop.inertia_ratio" in values:
        cells[Cell.IDEAL] = 0.0
    _put_start(cells, base.start, {path.removeprefix("start."): values[path] for path in values if path.startswith("start.")})
    compiled(mark_refused)(cells)
    return cells


def _put_start(cells: Array, start: Start, given: Mapping[str, Array]) -> None:
    """Write what follows from the numbers of the start, and mark the cells that contradict its slip velocity or its mode."""
    radius, vx = cells[Cell.RADIUS], given.get("vx", given.get("speed", start.vx))
    rolls = start.speed is not None or "speed" in given
    if "speed" in given:
        cells[Cell.HEIGHT] = cells[Cell.VY] = 0.0
    if rolls and "omega" not in given:
        cells[Cell.OMEGA] = given.get("speed", start.vx) / radius
    rim = radius * cells[Cell.OMEGA]
    ended = {key for name in given for key in ENDS.get(f"start.{name}", ())}
    if rolls and not given.keys() & set(_FREE):
        cells[Cell.SLIP] = 0.0
    elif start.slip is None or "slip" in ended:
        cells[Cell.SLIP] = vx - rim
    else:
        unit = radius / np.sqrt(radius / np.where(cells[Cell.GRAVITY] > 0.0, cells[Cell.GRAVITY], 1.0))
        cells[Cell.ALLOWED, ~slip_agrees(start.slip, vx, rim, unit)] = 0.0
    if "mode" in ended:
        cells[Cell.MODE] = BY_RULE
    elif start.mode is not None:
        for k in np.flatnonzero(cells[Cell.ALLOWED]).tolist():
            if why_not_in_mode(cells[:, k].tolist()):
                cells[Cell.ALLOWED, k] = 0.0


def _put_hoops(cells: Array, base: Scenario, values: Mapping[str, Array]) -> None:
    """Write hoops made of parts, computing each combination once."""
    combinations, place = np.unique(np.stack(list(values.values())), axis=1, return_inverse=True)
    made = np.ones((6, combinations.shape[1]))
    for column, combination in zip(made.T, combinations.T, strict=True):
        try:
            hoop = scenario_at(base, dict(zip(values, combination, strict=True))).hoop
        except InputError:
            column[-1] = 0.0
        else:
            column[:5] = hoop.radius, hoop.mass, hoop.eccentricity, hoop.inertia_ratio, hoop.load_fraction is not None
    rows = [Cell.RADIUS, Cell.MASS, Cell.ECCENTRICITY, Cell.INERTIA_RATIO, Cell.IDEAL, Cell.ALLOWED]
    cells[rows] = made[:, place.reshape(-1)]
