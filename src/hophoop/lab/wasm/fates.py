"""What becomes of a motion in the end, over plain memory; in the separate module."""

from __future__ import annotations

import numpy as np
from numba import carray

from hophoop.gaits.kernels.cells import judge_cells
from hophoop.gaits.kernels.layout import BOTTOM, CODES, NUMBERS, Request
from hophoop.lab.wasm.layout import FATE_COLUMNS
from hophoop.lab.wasm.motions import FIELDS

CODE_COUNT, NUMBER_COUNT, WIDTH = len(CODES), len(NUMBERS), len(FATE_COLUMNS)


def fate(given, most, out):
    """Write the fate of a scenario and its numbers, in the order of `layout.FATE_COLUMNS`, after at most so many passages."""
    cells = carray(given, (FIELDS, 1))
    row = carray(out, (WIDTH,))
    codes, numbers = np.zeros((1, CODE_COUNT), np.int64), np.empty((1, NUMBER_COUNT))
    judge_cells(cells, Request(BOTTOM, most, True), codes, numbers)
    for i in range(CODE_COUNT):
        row[i] = codes[0, i]
    for i in range(NUMBER_COUNT):
        row[CODE_COUNT + i] = numbers[0, i]
