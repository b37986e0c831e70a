"""Whether a map fits into memory, asked before it is computed: a system that runs out of memory kills without a word."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from hophoop.scenario import InputError

# Beside the result: cells, numbers and events of a chunk on every core.
WORKING = 200e6


def free_memory() -> float:
    """Memory that can still be had; infinite where the system does not say.

    Returns
    -------
    bytes : float
        [1].
    """
    try:
        for line in Path("/proc/meminfo").read_text(encoding="ascii").splitlines():
            if line.startswith("MemAvailable:"):
                return 1024.0 * float(line.split()[1])
    except (OSError, ValueError, IndexError):
        pass
    try:
        return float(os.sysconf("SC_PHYS_PAGES")) * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, ValueError, OSError):
        return math.inf


def check_memory(shape: Sequence[int], kinds: Iterable[str], advice: str) -> None:
    """Refuse a map that does not fit into memory.

    Parameters
    ----------
    shape : sequence of int
        Cells along its axes.
    kinds : iterable of str
        Types of its arrays.
    advice : str
        What to do instead.

    Raises
    ------
    ValueError
        If it does not fit.
    """
    motions = math.prod(int(count) for count in shape)
    needed = motions * sum(np.dtype(kind).itemsize for kind in kinds) + WORKING
    free = free_memory()
    if needed > free:
        raise InputError(
            f"axes make {motions:,} motions, which need {needed / 1e9:,.1f} GB of memory where {free / 1e9:,.1f} GB "
            f"are free: {advice}."
        )
