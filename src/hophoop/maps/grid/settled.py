"""What becomes of the motions of a map in the end: quantities of the span `settled`."""

from __future__ import annotations

from typing import Final

import numpy as np
from numpy.typing import NDArray

from hophoop.gaits.computing import judged
from hophoop.gaits.kernels.layout import CODES, NUMBERS, SECTIONS, Request
from hophoop.kernel.records import MapResults
from hophoop.vocabulary.names import FATE_CODES, identifier

SPANS: Final = {"settled": "bottom", "settled:landing": "landing"}
"""Spans of this kind, with the section at whose passages a motion is looked at."""

WORDS: Final = tuple(identifier(fate) for fate in FATE_CODES)
COUNTS: Final = ("period", "hops")
COLUMNS: Final = (*COUNTS, *NUMBERS)
PASSAGES = 2_000  # after which a motion is undecided


def evaluate_settled(cells: NDArray[np.float64], low: int, high: int, span: str, results: MapResults) -> None:
    """Compute the cells from `low` to `high`: numbers in the order of `COLUMNS`, and the code of the fate."""
    request = Request(SECTIONS.index(SPANS[span]), PASSAGES, True)
    codes, numbers = judged(cells[:, low:high], request)
    fates, counts = codes[:, CODES.index("fate")], codes[:, [CODES.index(name) for name in COUNTS]]
    results.words[low:high, 0] = fates
    results.numbers[low:high, : len(COLUMNS)] = np.column_stack([np.where(fates[:, np.newaxis] < 0, np.nan, counts), numbers])
