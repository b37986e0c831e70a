"""Entries of the modules, and the types of their arguments."""

from __future__ import annotations

from typing import Any

from numba import from_dtype, types

from hophoop.kernel.records import EVENT, SEGMENT
from hophoop.lab.wasm import answers, compliant, fates, motions

FLOATS, WORDS, KEYS = (types.CPointer(kind) for kind in (types.float64, types.int32, types.uint64))
BYTES, SIGNS = types.CPointer(types.uint8), types.CPointer(types.int8)
EVENTS, SEGMENTS = types.CPointer(from_dtype(EVENT)), types.CPointer(from_dtype(SEGMENT))
COUNT, NUMBER = types.int64, types.float64

Entries = dict[str, tuple[Any, tuple[Any, ...]]]

ENTRIES: Entries = {
    "motion": (motions.motion, (FLOATS, EVENTS, COUNT, SEGMENTS, COUNT, FLOATS, FLOATS)),
    "samples": (motions.samples, (FLOATS, SEGMENTS, COUNT, FLOATS, COUNT, COUNT, FLOATS)),
    "compliance": (compliant.compliance, (FLOATS, FLOATS, FLOATS)),
    "compliant_motion": (
        compliant.compliant_motion,
        (FLOATS, FLOATS, EVENTS, COUNT, COUNT, FLOATS, COUNT, FLOATS, FLOATS),
    ),
    "compliant_samples": (compliant.compliant_samples, (FLOATS, FLOATS, FLOATS, COUNT, FLOATS, COUNT, COUNT, FLOATS)),
    "thresholds": (answers.thresholds, (FLOATS, NUMBER, FLOATS)),
    "regions": (answers.regions, (FLOATS, NUMBER, NUMBER, NUMBER, NUMBER, COUNT, COUNT, BYTES, SIGNS)),
    "ideal_hoop": (answers.ideal_hoop, (NUMBER, FLOATS)),
    "refused": (answers.refused, (FLOATS, FLOATS, COUNT, FLOATS)),
    "hoop_of_parts": (answers.hoop_of_parts, (NUMBER, FLOATS, COUNT, FLOATS, FLOATS)),
    "map_cells": (
        answers.map_cells,
        (FLOATS, COUNT, NUMBER, COUNT, COUNT, COUNT, FLOATS, WORDS, KEYS),
    ),
}
"""Name → (kernel, Numba types of its arguments)."""

# In a separate module, which a page loads when fates are needed.
FATE_ENTRIES: Entries = {"fate": (fates.fate, (FLOATS, COUNT, FLOATS))}
