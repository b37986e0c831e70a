"""Cells of the kernel for a whole chunk at once, equal to those of `scenario_at` one by one."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.kernel.native import compiled
from hophoop.kernel.records import CELL, Cell, ideal_inertia, mark_refused
from hophoop.kernel.steps import BY_RULE
from hophoop.maps.grid.axes import ordered, scenario_at
from hophoop.scenario import InputError, Scenario, cell_of
from hophoop.scenario.paths import ENDS
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
    hoop = {path: values[path] for path in paths if path.startswith("hoop.")}
    if hoop and (base.hoop.parts is not None or any(path.startswith("hoop.parts") for path in hoop)):
        _put_hoops(cells, base, hoop)  # radius and mass are those of the parts
        paths = [path for path in paths if path not in hoop]
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
    _put_start(cells, base, {path.removeprefix("start."): values[path] for path in paths if path.startswith("start.")})
    compiled(mark_refused)(cells)
    return cells


def _put_start(cells: Array, base: Scenario, given: Mapping[str, Array]) -> None:
    """Write the start with other numbers, and mark the cells that contradict its slip velocity or its mode."""
    start, radius = base.start, cells[Cell.RADIUS]
    speed = given.get("speed", start.speed)
    state: dict[str, Any] = {name: getattr(start, name) for name in _FREE}
    if speed is not None:
        state = {"height": 0.0, "vx": speed, "vy": 0.0, "omega": speed / radius}
    free = {name: given[name] for name in _FREE if name in given}
    state |= free
    cells[Cell.HEIGHT], cells[Cell.VY], cells[Cell.OMEGA] = state["height"], state["vy"], state["omega"]
    rim = radius * cells[Cell.OMEGA]
    ended = {key for name in given for key in ENDS.get(f"start.{name}", ())}
    if speed is not None and not free:
        cells[Cell.SLIP] = 0.0
    elif start.slip is None or "slip" in ended:
        cells[Cell.SLIP] = state["vx"] - rim
    else:
        unit = radius / np.sqrt(radius / np.where(cells[Cell.GRAVITY] > 0.0, cells[Cell.GRAVITY], 1.0))
        cells[Cell.ALLOWED, ~slip_agrees(start.slip, state["vx"], rim, unit)] = 0.0
    if "mode" in ended:
        cells[Cell.MODE] = BY_RULE
    elif start.mode is not None:
        for k in np.flatnonzero(cells[Cell.ALLOWED]).tolist():
            if why_not_in_mode(cells[:, k].tolist()):
                cells[Cell.ALLOWED, k] = 0.0


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
