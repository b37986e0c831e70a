"""Derivatives of a motion's events with respect to parameters, over plain memory and in SI units; a separate module."""

from __future__ import annotations

import math

import numpy as np
from numba import carray

from hophoop.derivatives.directions import direction
from hophoop.derivatives.events.ending import propagate_motion
from hophoop.derivatives.layout import PARAMETERS, STATE_ROWS
from hophoop.derivatives.units import UNIT_OF_ROW, sizes_and_rates
from hophoop.derivatives.workspace import KnownMotion, new_solution, new_workspace
from hophoop.kernel.records import Cell, body_of, kernel_times, new_scratch, scales_of
from hophoop.lab.wasm.layout import CHANGE_COLUMNS
from hophoop.lab.wasm.motions import FIELDS

WIDTH = len(CHANGE_COLUMNS)
TURNING, SLIP, VX = (CHANGE_COLUMNS.index(name) for name in ("omega", "slip", "vx"))


def directions_of(cell, more, sign, changes, start, units):
    """Convert a cell and its derivatives to directions in kernel units."""
    for k in range(more.shape[1]):
        of_body, of_start, of_units = direction(cell, more[:, k])
        for i in range(PARAMETERS):
            changes[i, k] = sign * of_body[i]
        for i in range(STATE_ROWS):
            start[i, k] = sign * of_start[i]
        for i in range(3):
            units[i, k] = of_units[i]


def write_changes(row, scales, units, sign, event_tangents, out):
    """Write the derivatives of an event's quantities and their units, in SI units, in the order of `layout.CHANGE_COLUMNS`."""
    values = (
        row["t"], row["x"], row["height"], row["angle"], row["omega"], row["slip"], row["vy"],
        row["impact_normal"], row["impact_tangential"], row["rolling_resistance"],
    )  # fmt: skip
    sizes, by_units = sizes_and_rates(scales, units)
    for k in range(out.shape[1]):
        for i in range(STATE_ROWS):
            of = UNIT_OF_ROW[i]
            out[i, k] = sizes[of] * (sign * event_tangents[i, k] + values[i] * by_units[of, k])
        # ẋ = v_t + R θ̇
        of = UNIT_OF_ROW[SLIP]
        changed = sign * event_tangents[SLIP, k] + sign * event_tangents[TURNING, k]
        out[VX, k] = sizes[of] * (changed + (row["slip"] + row["omega"]) * by_units[of, k])


def changes(given, rates, n, sign, events, count, segments, pieces, doubt, out, told):
    """Write the derivatives of all events of a motion computed by `motion`, with respect to n parameters.

    `rates` holds, for each parameter, the derivatives of the cell `given`. With `sign` = −1 the left-sided derivatives are
    computed, in the sign convention of the right-sided ones. `doubt` is the time until which double precision suffices [s], nan
    if it always does. `told` receives for each parameter the reason why a derivative does not exist, and the first event
    without one.
    """
    cell = carray(given, (FIELDS,))
    table = carray(out, (count, WIDTH, n))
    answers = carray(told, (2, n))
    rows = carray(events, (count,))
    parts = carray(segments, (pieces,))
    scales = scales_of(cell)
    body = body_of(cell)
    by = np.empty((PARAMETERS, n))
    start = np.empty((STATE_ROWS, n))
    units = np.empty((3, n))
    directions_of(cell, carray(rates, (FIELDS, n)), sign, by, start, units)
    solution = new_solution(count, pieces, n)
    when = np.full(1, math.inf)
    if pieces > 0 and not math.isnan(doubt):
        kernel_times(parts["t"], parts[-1]["t_end"], np.full(1, doubt), scales.time, when)
    motion = KnownMotion(rows, parts, cell[Cell.DURATION] / scales.time, when[0])
    propagate_motion(body, motion, by, start, solution, new_workspace(new_scratch(), n))
    for i in range(count):
        write_changes(rows[i], scales, units, sign, solution.at_events[i], table[i])
    for k in range(n):
        answers[0, k] = solution.reasons[k]
        answers[1, k] = solution.failed[k]
