"""The kernel of a GPU's threads. Importing this needs `numba.cuda`, so `gpu` imports it on request."""

from __future__ import annotations

from typing import Any

from numba import cuda, float64, int64
from numba.core import config

from hophoop.kernel.jit import jitted
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.panels.panel import ROWS
from hophoop.kernel.records.layout import MOST_PANELS, PANEL_LIMIT, MapRequest, MapResults
from hophoop.kernel.records.scratch import STACK_COLUMNS, STACK_ROWS, Scratch
from hophoop.maps.grid import kernel as cells_kernel
from hophoop.maps.grid.kernel import Workspace

# CUDA's simulator runs Python.
evaluate_cell: Any = cells_kernel.evaluate_cell if config.ENABLE_CUDASIM else jitted(cells_kernel.evaluate_cell)

FLIGHT_EVENTS = 2  # events that a cell needs in addition to the motion's own


def evaluate_thread(
    cells: Any, todo: Any, request: MapRequest, events: Any, segments: Any, results: MapResults, finished: Any
) -> None:
    """Compute the cell that `todo` names for this thread; `finished` becomes 0 where it has too many events.

    The scratch arrays are local memory, which the hardware interleaves: neighbouring threads access neighbouring memory.
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
        most = events.shape[1] - FLIGHT_EVENTS
        workspace = Workspace(events[thread, most:], segments[:0], scratch)
        done = evaluate_cell(cells, todo[thread], request, events[thread, :most], workspace, events[thread, :0], results)
        finished[thread] = 1 if done else 0


# Optimising again at the link takes a minute and gains nothing with a single module.
kernel = cuda.jit(evaluate_thread) if config.ENABLE_CUDASIM else cuda.jit(evaluate_thread, lto=False)
