"""The fingerprint of a motion: a short hash of the bits of its events, for comparing machines and versions."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike

STATE = ("t", "x", "height", "angle", "vx", "vy", "omega", "slip")  # fields of an event that are hashed, in this order
DIGITS = 16  # hexadecimal: among 10⁸ motions two have the same fingerprint by chance with a probability of 3e-4
_NAN = 0x7FF8_0000_0000_0000


def fingerprint(kinds: Iterable[str], states: ArrayLike) -> str:
    """First 16 hexadecimal digits of the SHA-256 of events.

    For each event in order: the name of its kind in UTF-8, then its numbers as little-endian binary64. −0 is hashed as 0
    and any nan as the quiet nan 0x7ff8000000000000, whose signs and payloads depend on the machine.

    kinds: kind of each event; states: shape (n, 8), one row per event: the numbers of `STATE` [SI]; fingerprint: lower case.
    """
    numbers = np.array(states, dtype="<f8").reshape(-1, len(STATE)) + 0.0  # −0 + 0 is 0
    bits = np.ascontiguousarray(numbers, dtype="<f8").view("<u8")
    bits[np.isnan(numbers)] = _NAN
    digest = hashlib.sha256()
    for kind, row in zip(kinds, bits, strict=True):
        digest.update(kind.encode())
        digest.update(row.tobytes())
    return digest.hexdigest()[:DIGITS]


def is_fingerprint(text: str) -> bool:
    """Return True if a text has the form of a fingerprint, in either case."""
    return re.fullmatch(rf"[0-9a-fA-F]{{{DIGITS}}}", text) is not None
