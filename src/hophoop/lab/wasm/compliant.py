"""A motion with compliant contact and its states, over plain memory and in SI units."""

from __future__ import annotations

import math

import numpy as np
from numba import carray

from hophoop.kernel.compliant import sampling
from hophoop.kernel.compliant.parameters import RTOL, chosen_in_si, compliance_of, load_contact
from hophoop.kernel.compliant.records import OM, SIZE, TH, VN, VT, WIDTH, X, Y
from hophoop.kernel.compliant.run import run
from hophoop.kernel.compliant.sampling import sample
from hophoop.kernel.physics.body import Status
from hophoop.kernel.records.cells import body_of, scales_of
from hophoop.kernel.records.layout import ANGLE, CONTACT, DURATION, HEIGHT, MASS, MAX_EVENTS, OMEGA, SEGMENT, SLIP, VY
from hophoop.kernel.records.layout import X as PLACE
from hophoop.kernel.records.times import kernel_times
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
RAW_WIDTH = len(sampling.COLUMNS)
SPRING, DAMPER, KINETIC, POTENTIAL, FRICTION, RESISTED = (
    sampling.COLUMNS.index(name) for name in ("spring", "damping", "kinetic", "potential", "friction", "rolling_resistance")
)


def contact_of(cells, contact, body, scales):
    """Return the parameters of the contact in kernel units."""
    return compliance_of(
        body, scales.length, scales.time, cells[MASS, 0], int(contact[0]), int(contact[1]),
        contact[2], contact[3], contact[4], contact[5], contact[6],
    )  # fmt: skip


def start_at(cells, scales):
    """Return the start in kernel units, before the contact is loaded."""
    speed = scales.speed
    start = np.zeros(SIZE)
    start[X] = cells[PLACE, 0] / scales.length
    start[Y] = cells[HEIGHT, 0] / scales.length
    start[TH] = cells[ANGLE, 0]
    start[VT] = cells[SLIP, 0] / speed
    start[VN] = cells[VY, 0] / speed
    start[OM] = cells[OMEGA, 0] * scales.time
    return start


def compliance(given, contact, out):
    """Write the derived parameters of the contact, in the order of `layout.CHOSEN`."""
    cells = carray(given, (FIELDS, 1))
    asked = carray(contact, (CONTACT_WIDTH,))
    row = carray(out, (CHOSEN_COUNT,))
    scales = scales_of(cells, 0)
    body = body_of(cells, 0)
    comp = contact_of(cells, asked, body, scales)
    row[0], row[1] = chosen_in_si(comp, scales.length, scales.time, cells[MASS, 0])


def compliant_motion(given, contact, events, most_events, most_steps, rows, most_rows, table, heads):
    """Compute a motion with compliant contact.

    If `rows` is too short for `compliant_samples`, the status is `buffer` and the number of segments is the required length.
    """
    cells = carray(given, (FIELDS, 1))
    asked = carray(contact, (CONTACT_WIDTH,))
    records = carray(events, (min(most_events, int(cells[MAX_EVENTS, 0])),))
    kept = carray(rows, (most_rows, WIDTH))
    lines = carray(table, (most_events, EVENT_WIDTH))
    head = carray(heads, (HEAD_COUNT,))
    scales = scales_of(cells, 0)
    body = body_of(cells, 0)
    comp = contact_of(cells, asked, body, scales)
    start = start_at(cells, scales)
    touching = load_contact(body, comp, start)
    duration = cells[DURATION, 0]
    t_end = duration / scales.time
    rtol = RTOL if math.isnan(asked[7]) else asked[7]
    none = np.empty(0, SEGMENT)
    status, count, found, pieces = run(body, comp, start, touching, t_end, rtol, most_steps, records, none, np.zeros(1))
    for k in range(count):
        write_event(records[k], scales, seconds(records[k]["t"], t_end, duration, scales.time), lines[k])
    for k in range(min(pieces, most_rows)):
        kept[k] = found[k]
    head[0] = Status.BUFFER if pieces > most_rows else status
    head[1] = count
    head[2] = pieces
    head[3] = seconds(records[count - 1]["t"], t_end, duration, scales.time)
    head[4] = math.nan
    head[5] = pieces
    first = np.empty((1, RAW_WIDTH))
    last = np.empty((1, RAW_WIDTH))
    if pieces > 0:
        sample(body, comp, found[:pieces], np.zeros(1), True, first)
        sample(body, comp, found[:pieces], np.full(1, records[count - 1]["t"]), False, last)
    else:
        first[:] = 0.0
        last[:] = 0.0
    end = last[0]  # many steps may share the last digit of a late time: take the state after all of them
    energies = (end[KINETIC], end[POTENTIAL], end[SPRING], end[DAMPER], end[FRICTION], end[RESISTED])
    write_energies(body, scales, records[0], records[count - 1], energies, first[0, SPRING], head)


def compliant_samples(given, contact, rows, count, times, n, left, out):
    """Write the states of a motion with compliant contact at times in s."""
    cells = carray(given, (FIELDS, 1))
    kept = carray(rows, (count, WIDTH))
    when = carray(times, (n,))
    states = carray(out, (n, SAMPLE_WIDTH))
    scales = scales_of(cells, 0)
    body = body_of(cells, 0)
    comp = contact_of(cells, carray(contact, (CONTACT_WIDTH,)), body, scales)
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
