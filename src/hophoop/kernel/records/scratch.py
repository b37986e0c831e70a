"""Scratch arrays of the kernels."""

from __future__ import annotations

import threading
from typing import NamedTuple

import numpy as np

from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.numerics.roots import DEPTH
from hophoop.kernel.panels.panel import ROWS
from hophoop.kernel.records.layout import MOST_PANELS

STACK_ROWS, STACK_COLUMNS = DEPTH + 3, ORDER + 2  # size of the stack of `first_downcrossing`


class Scratch(NamedTuple):
    """Scratch arrays of a kernel; one set per thread."""

    work: np.ndarray
    values: np.ndarray
    series: np.ndarray
    weights: np.ndarray
    stack: np.ndarray
    doubt: np.ndarray  # time of the first doubt of a motion, nan if there is none
    counts: np.ndarray  # numbers of events, segments and panels, and the limit of panels; see records.layout


def new_scratch():
    """Return a new set of scratch arrays."""
    return Scratch(
        np.zeros((ROWS, ORDER)),
        np.zeros((2, ORDER)),
        np.zeros(ORDER),
        np.zeros(ORDER),
        np.zeros((STACK_ROWS, STACK_COLUMNS)),
        np.full(1, np.nan),
        np.array([0, 0, 0, MOST_PANELS]),
    )


_own = threading.local()


def thread_scratch() -> Scratch:
    """Return the scratch arrays of this thread; allocating them takes 10 % of a short motion."""
    if not hasattr(_own, "scratch"):
        _own.scratch = new_scratch()
    scratch: Scratch = _own.scratch
    return scratch
