"""Fates of many motions, each a column of numbers."""

from __future__ import annotations

import numpy as np

from hophoop.gaits.kernels.fates import OPEN
from hophoop.gaits.kernels.layout import COLUMNS, FEW_EVENTS, INTEGERS, Buffers
from hophoop.gaits.kernels.passages import ROWS, SIZE, follow_passages, hops_in
from hophoop.kernel.records.cells import body_of, second_of, start_of
from hophoop.kernel.records.layout import ALLOWED, EVENT, SEGMENT
from hophoop.kernel.records.scratch import new_scratch


def judge_cells(cells, low, high, request, codes):
    """Judge the cells from `low` to `high`.

    Parameters
    ----------
    cells : ndarray, shape (len(CELL), n)
        [SI].
    low, high : int
    request : Request
    codes : ndarray of int, shape (n, len(CODES))
        Filled; −1 in a cell that is not allowed.
    """
    buffers = Buffers(
        np.empty((ROWS, len(COLUMNS))), np.empty((ROWS, INTEGERS), np.int64), np.empty(SIZE), np.empty(FEW_EVENTS, EVENT),
        np.empty(0, SEGMENT),
    )  # fmt: skip
    script = np.empty(0, EVENT)
    scratch = new_scratch()
    for k in range(low, high):
        if cells[ALLOWED, k] == 0.0:
            for i in range(codes.shape[1]):
                codes[k, i] = OPEN
            continue
        start = start_of(cells, k, second_of(cells, k))
        status, passages, fate, period = follow_passages(body_of(cells, k), start, 0.0, request, buffers, scratch, script)
        codes[k, 0] = fate
        codes[k, 1] = period
        codes[k, 2] = hops_in(buffers.numbers, passages, period)
        codes[k, 3] = passages
        codes[k, 4] = status
