"""A motion with compliant contact and its states, over plain memory and in SI units."""

from __future__ import annotations

import math

import numpy as np
from numba import carray

from hophoop.kernel.compliant import (
    COLUMNS,
    OM,
    RTOL,
    SIZE,
    TH,
    VN,
    VT,
    WIDTH,
    X,
    Y,
    chosen_in_si,
    compliance_of,
    load_contact,
    run,
    sample,
)
from hophoop.kernel.model import Status
from hophoop.kernel.records import CONTACT, Cell, body_of, kernel_times, scales_of
from hophoop.lab.wasm.layout import CHOSEN, EVENT_COLUMNS, HEADS
from hophoop.lab.wasm.motions import (
    FIELDS,
    SAMPLE_WIDTH,
    seconds,
    write_energies,
    write_event,
    write_state,
)

CONTACT_WIDTH, HEAD_COUNT, EVENT_WIDTH, CHOSEN_COUNT = len(CONTACT), len(HEADS), len(EVENT_COLUMNS), len(CHOSEN)
RAW_WIDTH = len(COLUMNS)
SPRING, DAMPER, KINETIC, POTENTIAL, FRICTION, ROLLING_LOSS = (
    COLUMNS.index(name) for name in ("spring", "damping", "kinetic", "potential", "friction", "rolling_resistance")
)


def contact_of(cell, contact, body, scales):
    """Return the parameters of the contact in kernel units."""
    return compliance_of(
        body, scales.length, scales.time, cell[Cell.MASS], int(contact[0]), int(contact[1]),
        contact[2], contact[3], contact[4], contact[5], contact[6],
    )  # fmt: skip


def start_at(cell, scales):
    """Return the start in kernel units, before the contact is loaded."""
    speed = scales.speed
    start = np.zeros(SIZE)
    start[X] = cell[Cell.X] / scales.length
    start[Y] = cell[Cell.HEIGHT] / scales.length
    start[TH] = cell[Cell.ANGLE]
    start[VT] = cell[Cell.SLIP] / speed
    start[VN] = cell[Cell.VY] / speed
    start[OM] = cell[Cell.OMEGA] * scales.time
    return start


def compliance(given, contact, out):
    """Write the derived parameters of the contact, in the order of `layout.CHOSEN`."""
    cell = carray(given, (FIELDS,))
    asked = carray(contact, (CONTACT_WIDTH,))
    row = carray(out, (CHOSEN_COUNT,))
    scales = scales_of(cell)
    body = body_of(cell)
    comp = contact_of(cell, asked, body, scales)
    row[0], row[1] = chosen_in_si(comp, scales.length, scales.time, cell[Cell.MASS])


def compliant_motion(given, contact, events, most_events, most_steps, rows, most_rows, table, heads):
    """Compute a motion with compliant contact.

    If `rows` is too short for `compliant_samples`, the status is `buffer` and the number of segments is the required length.
    """
    cell = carray(given, (FIELDS,))
    asked = carray(contact, (CONTACT_WIDTH,))
    records = carray(events, (min(most_events, int(cell[Cell.MAX_EVENTS])),))
    kept = carray(rows, (most_rows, WIDTH))
    lines = carray(table, (most_events, EVENT_WIDTH))
    head = carray(heads, (HEAD_COUNT,))
    scales = scales_of(cell)
    body = body_of(cell)
    comp = contact_of(cell, asked, body, scales)
    start = start_at(cell, scales)
    touching = load_contact(body, comp, start)
    duration = cell[Cell.DURATION]
    t_end = duration / scales.time
    rtol = RTOL if math.isnan(asked[7]) else asked[7]
    status, count, pieces = run(body, comp, start, touching, t_end, rtol, most_steps, records, kept, np.zeros(1))
    for k in range(count):
        write_event(records[k], scales, seconds(records[k]["t"], t_end, duration, scales.time), lines[k])
    head[0] = Status.BUFFER if pieces > most_rows else status
    head[1] = count
    head[2] = pieces
    head[3] = seconds(records[count - 1]["t"], t_end, duration, scales.time)
    head[4] = math.nan
    head[5] = pieces
    first = np.empty((1, RAW_WIDTH))
    last = np.empty((1, RAW_WIDTH))
    if 0 < pieces <= most_rows:
        sample(body, comp, kept[:pieces], np.zeros(1), True, first)
        sample(body, comp, kept[:pieces], np.full(1, records[count - 1]["t"]), False, last)
    else:
        first[:] = 0.0
        last[:] = 0.0
    end = last[0]  # many steps may share the last digit of a late time: take the state after all of them
    energies = (end[KINETIC], end[POTENTIAL], end[SPRING], end[DAMPER], end[FRICTION], end[ROLLING_LOSS])
    write_energies(body, scales, records[0], records[count - 1], energies, first[0, SPRING], head)


def compliant_samples(given, contact, rows, count, times, n, left, out):
    """Write the states of a motion with compliant contact at times in s."""
    cell = carray(given, (FIELDS,))
    kept = carray(rows, (count, WIDTH))
    when = carray(times, (n,))
    states = carray(out, (n, SAMPLE_WIDTH))
    scales = scales_of(cell)
    body = body_of(cell)
    comp = contact_of(cell, carray(contact, (CONTACT_WIDTH,)), body, scales)
    asked = np.empty(n)
    kernel_times(kept[:, 0], kept[count - 1, 1], when, scales.time, asked)
    raw = np.empty((n, RAW_WIDTH))
    sample(body, comp, kept, asked, left != 0, raw)
    for k in range(n):
        line = raw[k]
        write_state(body, scales, line, states[k])
        states[k, 13] = line[SPRING] * scales.energy
        states[k, 14] = line[DAMPER] * scales.energy
        states[k, 15] = line[KINETIC] * scales.energy
        states[k, 16] = line[POTENTIAL] * scales.energy
