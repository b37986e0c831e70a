"""Thresholds of theory, regions of the phase plane, cells of maps and hoops made of parts, over plain memory."""

from __future__ import annotations

import math

from numba import carray

from hophoop.kernel.model import Mode
from hophoop.kernel.records import (
    AT,
    CELL,
    CONTACT,
    FIRST,
    SECOND,
    SHAPE,
    MapRequest,
    MapResults,
    body_of,
    combined,
    ideal_inertia,
    mark_refused,
    new_scratch,
    part_reach,
    refusal,
    scales_of,
)
from hophoop.kernel.steps import equilibrium_is_stable
from hophoop.lab.wasm.layout import PART, THRESHOLDS
from hophoop.lab.wasm.motions import FIELDS
from hophoop.maps.grid.kernel import INTEGERS, NUMBERS, WORDS, evaluate_block
from hophoop.theory.kernels.arcs import TURN, first_valley
from hophoop.theory.kernels.critical import hop_speed, slip_speed
from hophoop.theory.kernels.painleve import border, minimum, region
from hophoop.theory.kernels.phase_plane import lift_off, mode_without_slip
from hophoop.theory.kernels.rolling import contact_loss, needed_friction

ROWS, NUMBER_COUNT, WORD_COUNT, ANSWERS = len(CELL), len(NUMBERS), len(WORDS), len(THRESHOLDS)
PART_WIDTH, CONTACT_WIDTH = len(PART), len(CONTACT)


def write_jams(body, out):
    """Write the angles of the dynamic jam, in order."""
    count = 0
    for side in range(2):
        first = border(body, body.mu_k, side == 1)
        if math.isnan(first):
            continue
        for angle in (first, TURN - first):
            if lift_off(body, angle) < math.inf:
                place = count
                while place > 0 and out[place - 1] > angle:
                    out[place] = out[place - 1]
                    place -= 1
                out[place] = angle
                count += 1


def thresholds(given, speed, out):
    """Write the thresholds of theory for a hoop that starts from θ = 0 with `speed` [m/s] (nan: not given)."""
    cell = carray(given, (FIELDS,))
    row = carray(out, (ANSWERS,))
    scales = scales_of(cell)
    body = body_of(cell)
    unit = scales.length / scales.time
    row[:] = math.nan
    row[2] = lift_off(body, 0.0) * unit
    if body.resist > 0.0:
        return  # no closed form is known
    weighs = body.gn > 0.0
    if body.kap > 0.0:
        row[5], row[6] = minimum(body)
        if weighs and body.eps > 0.0 and body.mu_k < math.inf:
            write_jams(body, row[7:11])
        if body.gt >= 0.0:
            row[0] = slip_speed(body) * unit
            row[1] = hop_speed(body, 1) * unit
    if not math.isnan(speed):
        row[3], row[4] = needed_friction(body, speed / unit, new_scratch())
        if body.kap == 0.0 and weighs:
            angle, _, by_friction = contact_loss(body, speed / unit)
            row[12] = angle
            row[13] = 1.0 if by_friction else 0.0
    valley = first_valley(body)
    if not math.isnan(valley) and equilibrium_is_stable(body, valley):
        row[11] = valley % TURN


def regions(given, left, right, bottom, top, columns, lines, modes, paradox):
    """Write the mode that follows each state of contact without slip, as an index into `vocabulary.names.MODE_WORDS`."""
    cell = carray(given, (FIELDS,))
    codes = carray(modes, (lines, columns))
    sides = carray(paradox, (2, columns))  # for θ̇ < 0 and θ̇ > 0, which differ with rolling resistance
    scales = scales_of(cell)
    body = body_of(cell)
    for i in range(columns):
        angle = left + (i + 0.5) * ((right - left) / columns)
        for turning in range(2):
            sides[turning, i] = 0
            if body.kap > 0.0 and body.mu_k < math.inf:
                sides[turning, i] = region(body, angle, 2.0 * turning - 1.0)
        for j in range(lines):
            omega = bottom + (j + 0.5) * ((top - bottom) / lines)
            mode = mode_without_slip(body, angle, omega * scales.time)
            if mode in (Mode.SPIN, Mode.SKID):  # the word of a slip depends on sign(v_t θ̇)
                ahead = (mode == Mode.SPIN and omega > 0.0) or (mode == Mode.SKID and omega < 0.0)
                mode = Mode.SPIN if ahead else Mode.SKID
            codes[j, i] = mode


def map_cells(cells, n, span, stop, timed, quantities, numbers, words, sequences):
    """Compute reduced quantities of n motions, each a column of `records.cells.CELL`; `span` is in rad, nan for none."""
    columns = carray(cells, (ROWS, n))
    mark_refused(columns)
    results = MapResults(carray(numbers, (n, NUMBER_COUNT)), carray(words, (n, WORD_COUNT)), carray(sequences, (n, INTEGERS)))
    evaluate_block(columns, 0, n, MapRequest(span, stop, timed != 0, quantities), results)


def ideal_hoop(load_fraction, out):
    """Write κ of the ideal hoop."""
    carray(out, (1,))[0] = ideal_inertia(load_fraction)


def refused(given, contact, rigid, out):
    """Write the code of the rule that a scenario breaks (0 for none) and the number that its sentence needs."""
    asked = carray(contact, (CONTACT_WIDTH,))
    row = carray(out, (2,))
    row[0], row[1] = refusal(carray(given, (ROWS,)), asked[:0] if rigid != 0 else asked)


def hoop_of_parts(radius, parts, count, out, reaches):
    """Write mass, ε and κ of parts (rows of `layout.PART`), and the distance of each part's farthest point from C."""
    table = carray(parts, (count, PART_WIDTH))
    made = carray(out, (3,))
    made[0], made[1], made[2] = combined(radius, table)
    far = carray(reaches, (count,))
    for k in range(count):
        far[k] = part_reach(table[k, SHAPE], table[k, FIRST], table[k, SECOND], table[k, AT])
