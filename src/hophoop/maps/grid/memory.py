"""Check that a map fits in memory before it is computed: a system without memory kills processes without a message."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from hophoop._support.extras import need
from hophoop.scenario import InputError

# In addition to the result: cells, numbers and events of a chunk on every core [bytes].
WORKING = 200e6


def check_memory(shape: Sequence[int], kinds: Iterable[str], advice: str) -> None:
    """Refuse a map that does not fit into memory; `kinds` are the types of its arrays, `advice` the alternatives."""
    motions = math.prod(int(count) for count in shape)
    needed = motions * sum(np.dtype(kind).itemsize for kind in kinds) + WORKING
    free = need("psutil", "maps").virtual_memory().available  # also what the system can free without swapping
    if needed > free:
        raise InputError(
            f"axes make {motions:,} motions, which need {needed / 1e9:,.1f} GB of memory where {free / 1e9:,.1f} GB "
            f"are free: {advice}."
        )
