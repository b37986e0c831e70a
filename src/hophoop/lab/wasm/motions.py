"""A motion and its states, over plain memory and in SI units."""

from __future__ import annotations

import math

import numpy as np
from numba import carray

from hophoop.kernel.model import Mode, energies_after, utilization
from hophoop.kernel.records import CELL, COLUMNS, PANELS, Cell, body_of, kernel_times, mode_of, new_scratch, scales_of, start_of
from hophoop.kernel.steps import run, sample
from hophoop.lab.wasm.layout import EVENT_COLUMNS, HEADS, SAMPLE_COLUMNS

FIELDS, HEAD_COUNT, EVENT_WIDTH, SAMPLE_WIDTH = len(CELL), len(HEADS), len(EVENT_COLUMNS), len(SAMPLE_COLUMNS)
RAW_WIDTH = len(COLUMNS)
ROLLING_LOSS, KINETIC, POTENTIAL = (COLUMNS.index(name) for name in ("rolling_resistance", "kinetic", "potential"))


def seconds(t, t_end, duration, second):
    """Return a time in s; the end of the motion is the given duration, without its rounding through kernel units."""
    return duration if t == t_end else t * second


def write_event(row, scales, t, out):
    """Write an event in SI units, in the order of `layout.EVENT_COLUMNS`."""
    length, speed, rate, impulse = scales.length, scales.speed, scales.rate, scales.impulse
    out[0] = t
    out[1] = row["kind"]
    out[2] = row["before_mode"]
    out[3] = row["after_mode"]
    out[4] = row["x"] * length
    out[5] = row["height"] * length
    out[6] = row["angle"]
    out[7] = row["vx"] * speed
    out[8] = row["vy"] * speed
    out[9] = row["omega"] * rate
    out[10] = row["slip"] * speed
    out[11] = row["before_vx"] * speed
    out[12] = row["before_vy"] * speed
    out[13] = row["before_omega"] * rate
    out[14] = row["before_slip"] * speed
    out[15] = row["impulse_normal"] * impulse
    out[16] = row["impulse_tangential"] * impulse
    out[17] = row["friction"] * scales.energy
    out[18] = row["impact_normal"] * scales.energy
    out[19] = row["impact_tangential"] * scales.energy
    out[20] = row["gain"] * scales.energy
    out[21] = row["collision"]
    out[22] = row["stable"]
    out[23] = row["rolling_resistance"] * scales.energy


def write_energies(body, scales, first, last, energies, first_spring, head):
    """Write the energies of a motion in the order of `layout.HEADS`, as `Trajectory.ledger` sums them.

    `first` and `last` are its events; `energies` are kinetic, potential, spring, damping, friction and rolling resistance at
    the end.
    """
    unit = scales.energy
    begin_kinetic, begin_potential = energies_after(body, first)
    kinetic, potential, spring, damping, friction, rolling = energies
    head[6] = kinetic * unit
    head[7] = potential * unit
    head[8] = spring * unit
    head[9] = damping * unit
    head[10] = friction * unit
    head[11] = last["impact_normal"] * unit
    head[12] = last["impact_tangential"] * unit
    head[14] = rolling * unit
    now = head[6] + head[7] + head[8] + head[9] + head[10] + head[11] + head[12] + head[14]
    head[13] = now - (begin_kinetic * unit + begin_potential * unit + first_spring * unit)


def motion(given, events, most_events, segments, most_segments, table, heads):
    """Compute a motion.

    `given` holds a scenario's numbers in the order of `records.cells.CELL`; `table` receives the events and `heads` the values
    of `layout.HEADS`. Segments are needed by `samples`. If their table is too short, the status is `buffer`; if that of the
    events is, it is `event_limit`, with fewer events than the scenario allows.
    """
    cell = carray(given, (FIELDS,))
    records = carray(events, (min(most_events, int(cell[Cell.MAX_EVENTS])),))
    pieces = carray(segments, (most_segments,))
    rows = carray(table, (most_events, EVENT_WIDTH))
    head = carray(heads, (HEAD_COUNT,))
    scales = scales_of(cell)
    body = body_of(cell)
    duration = cell[Cell.DURATION]
    t_end = duration / scales.time
    scratch = new_scratch()
    start = start_of(cell, scales.time)
    status, count, length = run(body, start, mode_of(cell), t_end, math.nan, 0, records, pieces, scratch)
    for k in range(count):
        write_event(records[k], scales, seconds(records[k]["t"], t_end, duration, scales.time), rows[k])
    head[0] = status
    head[1] = count
    head[2] = length
    head[3] = seconds(records[count - 1]["t"], t_end, duration, scales.time)
    head[4] = scratch.doubt[0] * scales.time
    head[5] = scratch.counts[PANELS]
    final = records[count - 1]
    end_kinetic, end_potential = energies_after(body, final)
    energies = (end_kinetic, end_potential, 0.0, 0.0, final["friction"], final["rolling_resistance"])
    write_energies(body, scales, records[0], final, energies, 0.0, head)


def write_state(body, scales, raw, row):
    """Write a state in SI units, in the order of `layout.SAMPLE_COLUMNS`, without the energies of a contact model."""
    length, speed, force, unit = scales.length, scales.speed, scales.force, scales.energy
    mode = int(raw[0])
    row[0] = mode
    row[1] = raw[1] * length
    row[2] = raw[2] * length
    row[3] = raw[3]
    row[4] = raw[4] * speed
    row[5] = raw[5] * speed
    row[6] = raw[6] * scales.rate
    row[7] = raw[7] * speed
    row[8] = raw[8] * force
    row[9] = raw[9] * force
    row[10] = raw[10] * unit
    row[11] = raw[11] * unit
    row[12] = raw[12] * unit
    slips = mode in (Mode.SPIN, Mode.SKID)
    row[17] = utilization(slips, row[8], row[9], body.mu_s, body.mu_k)
    row[18] = raw[ROLLING_LOSS] * unit  # the same column in both contact models


def samples(given, segments, count, times, n, left, out):
    """Write the states of a motion at times in s, from its segments; `left` is 1 for the state just before an impact."""
    cell = carray(given, (FIELDS,))
    rows = carray(out, (n, SAMPLE_WIDTH))
    scales = scales_of(cell)
    body = body_of(cell)
    pieces = carray(segments, (count,))
    asked = np.empty(n)
    kernel_times(pieces["t"], pieces[-1]["t_end"], carray(times, (n,)), scales.time, asked)
    raw = np.empty((n, RAW_WIDTH))
    sample(body, pieces, asked, left != 0, raw)
    for k in range(n):
        line = raw[k]
        write_state(body, scales, line, rows[k])
        rows[k, 13] = 0.0
        rows[k, 14] = 0.0
        rows[k, 15] = line[KINETIC] * scales.energy
        rows[k, 16] = line[POTENTIAL] * scales.energy
