"""Cells of the kernel for a whole chunk at once, equal to those of `scenario_at` one by one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.kernel.native import compiled
from hophoop.kernel.records import CELL, Cell, ideal_inertia, mark_refused
from hophoop.kernel.steps import BY_RULE
from hophoop.maps.grid.axes import ordered, scenario_at
from hophoop.scenario import InputError, Scenario, cell_of
from hophoop.scenario.scenario import slip_agrees, why_not_in_mode
from hophoop.vocabulary.names import LAW_CODES
from hophoop.vocabulary.parameters import TABLE, section_of

Array = NDArray[Any]

_FREE = ("height", "vx", "vy", "omega")  # of a start that does not roll
# Parameters whose value is one number of the cell.
_PLAIN = {
    row.path: CELL.index(row.column)
    for row in TABLE
    if row.column and not (section_of(row) == "start" and row.path.removeprefix("start.") in _FREE)
}


def make_cells(base: Scenario, values: Mapping[str, Array], count: int) -> NDArray[np.float64]:
    """Return the kernel's cells of a chunk, shape (len(CELL), count), from the values of the varied parameters by path [SI].

    Rows are those of `records.cells.CELL`; cells with contradictory values are marked.
    """
    cells = np.repeat(np.array(cell_of(base), dtype=float)[:, np.newaxis], count, axis=1)
    paths = ordered(list(values))
    hoop = [path for path in paths if path.startswith("hoop.")]
    if hoop and _is_made_of_parts(base, hoop):
        _put_hoops(cells, base, {path: values[path] for path in hoop})
        paths = [path for path in paths if path not in hoop]
    start = base.start
    rolling = start.speed is not None
    free: dict[str, Any] = {name: getattr(start, name) for name in _FREE}
    for path in paths:
        array = values[path]
        if path in _PLAIN:
            cells[_PLAIN[path]] = array
            if path in ("hoop.eccentricity", "hoop.inertia_ratio"):
                cells[Cell.IDEAL] = 0.0
        elif path == "hoop.load_fraction":
            cells[Cell.ECCENTRICITY] = array
            cells[Cell.INERTIA_RATIO] = ideal_inertia(array)
            cells[Cell.IDEAL] = 1.0
        elif path == "plane.mu":
            cells[Cell.MU_STATIC] = array
            cells[Cell.MU_KINETIC] = array
        elif path == "plane.impact_law":
            cells[Cell.LAW] = [LAW_CODES[word] for word in array]
        elif path == "plane.painleve":
            cells[Cell.PAINLEVE_IMPACT] = array == "impact"
        elif path == "start.speed":
            rolling = True
            free["vx"] = array
        else:
            if rolling:  # a rolling start becomes a free one with one number changed
                free |= {"height": 0.0, "vy": 0.0, "omega": free["vx"] / cells[Cell.RADIUS]}
            rolling = False
            free[path.partition(".")[2]] = array
    if rolling:
        cells[Cell.HEIGHT] = 0.0
        cells[Cell.VY] = 0.0
        cells[Cell.OMEGA] = free["vx"] / cells[Cell.RADIUS]
        cells[Cell.SLIP] = 0.0
    elif start.slip is None or any(path.startswith("start.") for path in paths):
        cells[Cell.HEIGHT] = free["height"]
        cells[Cell.VY] = free["vy"]
        cells[Cell.OMEGA] = free["omega"]
        cells[Cell.SLIP] = free["vx"] - cells[Cell.RADIUS] * cells[Cell.OMEGA]
        cells[Cell.MODE] = BY_RULE
    else:
        _mark_starts(cells, base)
    compiled(mark_refused)(cells)
    return cells


def _mark_starts(cells: Array, base: Scenario) -> None:
    """Mark the cells that contradict the slip velocity or the mode of the start."""
    start = base.start
    assert start.slip is not None
    seconds = np.sqrt(cells[Cell.RADIUS] / np.where(cells[Cell.GRAVITY] > 0.0, cells[Cell.GRAVITY], 1.0))
    rim = cells[Cell.RADIUS] * (start.omega or 0.0)
    cells[Cell.ALLOWED, ~slip_agrees(start.slip, start.vx, rim, cells[Cell.RADIUS] / seconds)] = 0.0
    if start.mode is not None:
        for k in np.flatnonzero(cells[Cell.ALLOWED]).tolist():
            if why_not_in_mode(cells[:, k].tolist()):
                cells[Cell.ALLOWED, k] = 0.0


def _is_made_of_parts(base: Scenario, paths: Sequence[str]) -> bool:
    """Return True if radius and mass are those of parts, from which ε and κ follow."""
    if any(path.startswith("hoop.parts") for path in paths):
        return True
    return base.hoop.parts is not None


def _put_hoops(cells: Array, base: Scenario, values: Mapping[str, Array]) -> None:
    """Write hoops made of parts, computing each combination once."""
    table = np.stack(list(values.values()))
    combinations, place = np.unique(table, axis=1, return_inverse=True)
    made = np.ones((6, combinations.shape[1]))
    for i, combination in enumerate(combinations.T):
        try:
            hoop = scenario_at(base, dict(zip(values, combination, strict=True))).hoop
        except InputError:
            made[-1, i] = 0.0
            continue
        made[:5, i] = hoop.radius, hoop.mass, hoop.eccentricity, hoop.inertia_ratio, hoop.load_fraction is not None
    place = place.reshape(-1)
    rows = (Cell.RADIUS, Cell.MASS, Cell.ECCENTRICITY, Cell.INERTIA_RATIO, Cell.IDEAL, Cell.ALLOWED)
    for row, column in zip(rows, made, strict=True):
        cells[row] = column[place]
