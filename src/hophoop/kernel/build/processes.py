"""Two processes that compile entries of the library, and optimize their code."""

from __future__ import annotations

import gc
import multiprocessing
import os
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager


def begin() -> None:
    """Prepare a process that compiles: kernels are its data, and Numba leaves their code unoptimized."""
    os.environ.update(HOPHOOP_KERNELS="interpreted", NUMBA_OPT="0")
    gc.disable()  # Numba creates millions of permanent objects, and collecting garbage among them takes about 15 % of the time


@contextmanager
def workers() -> Iterator[Executor]:
    """Context of two processes that compile; what they print is the build's."""
    with ProcessPoolExecutor(2, multiprocessing.get_context("spawn"), begin) as pool:
        try:
            yield pool
        finally:
            pool.shutdown(cancel_futures=True)
