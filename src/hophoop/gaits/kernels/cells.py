"""Fates of many motions, each a column of numbers."""

from __future__ import annotations

import math

from hophoop.gaits.kernels.fates import OPEN, ROLLING_TURNS, angle_between
from hophoop.gaits.kernels.layout import (
    BOTTOM,
    FINAL_HOP_HEIGHT,
    FINAL_LOSS,
    FINAL_OMEGA,
    HIGHEST,
    HOPS,
    LYAPUNOV,
    MEAN_SPEED,
    MODE,
    OMEGA,
    REVOLUTIONS,
    ROLL,
    T,
    X,
)
from hophoop.gaits.kernels.passages import LOST, ROWS, TURNED, follow_passages, lands_no_more, new_buffers
from hophoop.kernel.model import Status, inertia_at_height, kinetic_energy, potential_energy
from hophoop.kernel.native import noinline, replaced
from hophoop.kernel.numerics.arithmetic import PI, TWO_PI
from hophoop.kernel.numerics.exponentials import logarithm
from hophoop.kernel.records import Cell, body_of, mode_of, new_scratch, scales_of, start_of, start_state
from hophoop.kernel.steps import BY_RULE, GOING
from hophoop.theory.kernels.critical import slip_from_rolling
from hophoop.vocabulary.names import FateCode

BATCHES, BATCH = 20, 30  # of passages over which neighbours of an undecided motion are followed
NEIGHBOUR = 1e-7  # relative distance of a neighbour
APART = 36.0  # logarithm of 2⁵²: what two doubles next to each other need to be apart
SURE = 5.0  # standard errors by which the exponent of a chaotic motion is above 0


def judge_cells(cells, request, codes, numbers):
    """Judge cells in SI units: codes of −1 in cells that are not allowed, nan for unknown numbers."""
    buffers, scratch = new_buffers(ROWS), new_scratch()
    bottom = replaced(request, section=BOTTOM)
    numbers[:, :] = math.nan
    for k in range(cells.shape[1]):
        if cells[Cell.ALLOWED, k] == 0.0:
            codes[k, :] = OPEN
            continue
        scales = scales_of(cells[:, k])
        body, start, mode = body_of(cells[:, k]), start_of(cells[:, k], scales.time), mode_of(cells[:, k])
        status, passages, fate, period = follow_passages(body, start, mode, request, buffers, scratch)
        section = request.section
        if lands_no_more(section, status, fate):
            section = BOTTOM
            status, passages, fate, period = follow_passages(body, start, mode, bottom, buffers, scratch)
        codes[k, 1], codes[k, 3], codes[k, 4] = period, passages, status
        numbers[k, REVOLUTIONS] = abs(buffers.memory[TURNED])
        write_numbers(buffers, fate, status, passages, scales, codes[k], numbers[k])
        if fate == FateCode.SLIPS_EVER_LESS:
            numbers[k, FINAL_LOSS] = loss_until_rolling(body, start, scratch) * scales.energy
        row = buffers.numbers[(passages - 1) % ROWS]
        if fate == FateCode.UNDECIDED and status == GOING and section == BOTTOM and row[MODE] == ROLL and body.gt != 0.0:
            mean, error = follow_neighbours(body, row[OMEGA], bottom, buffers, scratch)
            numbers[k, LYAPUNOV] = mean
            if mean > SURE * error and mean * BATCHES * BATCH > APART:
                fate = FateCode.CHAOTIC
        codes[k, 0] = fate


@noinline
def write_numbers(buffers, fate, status, passages, scales, codes, numbers):
    """Write the numbers of a decided motion."""
    rows, memory = buffers.numbers, buffers.memory
    rolls = fate == FateCode.ROLLS_AHEAD or fate == FateCode.ROLLS_BACK
    if rolls or fate == FateCode.GAIT:
        cycle = max(codes[1], 1)
        last, before = rows[(passages - 1) % ROWS], rows[(passages - 1 - cycle) % ROWS]
        numbers[MEAN_SPEED] = (last[X] - before[X]) / (last[T] - before[T]) * scales.speed
        if not rolls:
            codes[2] = int(last[HOPS] - before[HOPS])
            codes[5] = math.floor(abs(angle_between(before, last)) / TWO_PI + 0.5)
            highest = 0.0
            for i in range(cycle):
                highest = max(highest, rows[(passages - 1 - i) % ROWS, HIGHEST])
            numbers[FINAL_HOP_HEIGHT] = highest * scales.length
            if last[MODE] == ROLL:
                numbers[FINAL_OMEGA] = last[OMEGA] * scales.rate
    elif fate == FateCode.RESTS or fate == FateCode.ROCKS:
        numbers[MEAN_SPEED] = 0.0
    swings = fate == FateCode.ROCKS and memory[ROLLING_TURNS] >= 2.0
    if rolls or swings or (fate == FateCode.RESTS and status == Status.AT_REST):
        numbers[FINAL_LOSS] = memory[LOST] * scales.energy


@noinline
def loss_until_rolling(body, start, scratch):
    """Return the energy above that of the fastest rolling on the level: what a motion that slips ever less loses for ever."""
    energy = kinetic_energy(body, start.th, start.om, start.vt, start.vn, start.th_low) + potential_energy(
        body, 0.0, start.y, start.th
    )
    return energy - 0.5 * inertia_at_height(body, 2.0) * slip_from_rolling(body, scratch)[0]


@noinline
def next_omega(body, om, request, buffers, scratch):
    """Return θ̇ at the next passage of the bottom, nan if it is not in rolling."""
    start = start_state(0.0, 0.0, PI, 0.0, 0.0, om)
    _, found, _, _ = follow_passages(body, start, BY_RULE, request, buffers, scratch)
    row = buffers.numbers[0]
    return row[OMEGA] if found == 1 and row[MODE] == ROLL else math.nan


@noinline
def follow_neighbours(body, om, request, buffers, scratch):
    """Return the mean growth of a small difference of θ̇ per passage in rolling, and its standard error; nan without one."""
    one = replaced(request, most=1, stops=False)
    total, squares = 0.0, 0.0
    for _ in range(BATCHES):
        batch = 0.0
        for _ in range(BATCH):
            near = om * (1.0 + NEIGHBOUR)
            after = next_omega(body, om, one, buffers, scratch)
            growth = abs((next_omega(body, near, one, buffers, scratch) - after) / (near - om))
            if not growth > 0.0:
                return math.nan, math.nan
            batch += logarithm(growth)
            om = after
        total += batch / BATCH
        squares += (batch / BATCH) * (batch / BATCH)
    mean = total / BATCHES
    variance = max(squares / BATCHES - mean * mean, 0.0)
    return mean, math.sqrt(variance / (BATCHES - 1))
