"""The arrays that a kernel works in."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from hophoop.numerics.collocation import ORDER
from hophoop.numerics.roots import DEPTH
from hophoop.panels.panel import ROWS

# Panels solved for one motion, those given up for narrower ones included: a few seconds, and 70 MB where all are kept.
MOST_PANELS = 500_000

STACK_ROWS, STACK_COLUMNS = DEPTH + 3, ORDER + 2  # what `first_fall` needs


class Scratch(NamedTuple):
    """Arrays that the kernel works in; one set a thread."""

    work: np.ndarray
    values: np.ndarray
    series: np.ndarray
    weights: np.ndarray
    stack: np.ndarray
    doubt: np.ndarray  # begin and end of the first doubt of a motion, nan while there is none
    written: np.ndarray  # numbers of events, segments and panels of the motion; and how many panels it may have


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


class Stop:
    """A flag in memory that ends the motions which a thread computes: set by another thread, seen at the next panel."""

    def __init__(self) -> None:
        self._scratches: list[Scratch] = []
        self._stopped = False

    @property
    def stopped(self) -> bool:
        """Whether it has been set."""
        return self._stopped

    def stop(self) -> None:
        """End what is computed under it; such a motion has the status `event_limit`, with the run so far."""
        self._stopped = True
        for scratch in self._scratches:
            scratch.written[3] = 0

    @contextlib.contextmanager
    def guards(self) -> Iterator[None]:
        """Let it end what this thread computes inside."""
        before = getattr(_own, "scratch", None)
        own: Scratch = new_scratch()
        self._scratches.append(own)
        if self._stopped:
            own.written[3] = 0
        _own.scratch = own
        try:
            yield
        finally:
            self._scratches.remove(own)
            if before is None:
                del _own.scratch
            else:
                _own.scratch = before
