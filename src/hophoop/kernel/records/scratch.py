"""The arrays that a kernel works in."""

from __future__ import annotations

import threading
from typing import NamedTuple

import numpy as np

from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.numerics.roots import DEPTH
from hophoop.kernel.panels.panel import ROWS
from hophoop.kernel.records.layout import MOST_PANELS

STACK_ROWS, STACK_COLUMNS = DEPTH + 3, ORDER + 2  # what `first_fall` needs


class Scratch(NamedTuple):
    """Arrays that the kernel works in; one set a thread."""

    work: np.ndarray
    values: np.ndarray
    series: np.ndarray
    weights: np.ndarray
    stack: np.ndarray
    doubt: np.ndarray  # begin and end of the first doubt of a motion, nan while there is none
    counts: np.ndarray  # events, segments and panels of the motion, and how many panels it may have; see records.layout


def new_scratch():
    """A fresh set of scratch arrays."""
    return Scratch(
        np.zeros((ROWS, ORDER)),
        np.zeros((2, ORDER)),
        np.zeros(ORDER),
        np.zeros(ORDER),
        np.zeros((STACK_ROWS, STACK_COLUMNS)),
        np.full(2, np.nan),
        np.array([0, 0, 0, MOST_PANELS]),
    )


_own = threading.local()


def thread_scratch() -> Scratch:
    """The scratch arrays of this thread: making them takes a tenth of a short motion."""
    if not hasattr(_own, "scratch"):
        _own.scratch = new_scratch()
    scratch: Scratch = _own.scratch
    return scratch
