"""What a thread of a GPU does. Importing this needs `numba.cuda`, so `gpu` does it where a GPU is wanted."""

from __future__ import annotations

from typing import Any

from numba import cuda, float64, int64
from numba.core import config

from hophoop.kernel.jit import jitted
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.panels.panel import ROWS
from hophoop.kernel.records.layout import MOST_PANELS, PANEL_LIMIT
from hophoop.kernel.records.scratch import STACK_COLUMNS, STACK_ROWS, Scratch
from hophoop.maps.grid import kernel as cells_kernel

# What CUDA's simulator runs is Python.
evaluate_cell: Any = cells_kernel.evaluate_cell if config.ENABLE_CUDASIM else jitted(cells_kernel.evaluate_cell)

FLIGHT_EVENTS = 2  # events that a cell needs beside the motion's own


def evaluate_thread(
    cells: Any,
    todo: Any,
    angle_span: float,
    stop: int,
    timed: bool,
    wanted: int,
    events: Any,
    segments: Any,
    numbers: Any,
    words: Any,
    keys: Any,
    finished: Any,
) -> None:
    """The cell that `todo` names for this thread; `finished` becomes 0 where its events are too many.

    The scratch arrays are local memory, which the hardware lays out so that threads side by side find theirs
    side by side.
    """
    thread = cuda.grid(1)
    if thread < todo.shape[0]:
        scratch = Scratch(
            cuda.local.array((ROWS, ORDER), float64),
            cuda.local.array((2, ORDER), float64),
            cuda.local.array(ORDER, float64),
            cuda.local.array(ORDER, float64),
            cuda.local.array((STACK_ROWS, STACK_COLUMNS), float64),
            cuda.local.array(2, float64),
            cuda.local.array(4, int64),
        )
        scratch.counts[PANEL_LIMIT] = MOST_PANELS
        room = events.shape[1] - FLIGHT_EVENTS
        done = evaluate_cell(
            cells,
            todo[thread],
            angle_span,
            stop,
            timed,
            wanted,
            events[thread, :room],
            events[thread, room:],
            segments[:0],
            scratch,
            events[thread, :0],
            numbers,
            words,
            keys,
        )
        finished[thread] = 1 if done else 0


# Optimising again at the link takes a minute and has nothing to gain from a single module.
kernel = cuda.jit(evaluate_thread) if config.ENABLE_CUDASIM else cuda.jit(evaluate_thread, lto=False)
