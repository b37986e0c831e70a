"""A motion as the player takes it: states at enough times, both sides of every event, packed as bytes."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Mapping
from typing import Any

import numpy as np

from hophoop.trajectory import Floats, Trajectory
from hophoop.vocabulary.words import MODES, coming_rotation, mode_words

# Positions and times need all digits where a motion is long; the rest is drawn only.
PRECISE = ("t", "x", "height", "angle")
DRAWN = (
    "vx", "vy", "omega", "slip", "friction_force", "normal_force", "kinetic", "potential",
    "friction", "impact_normal", "impact_tangential", "spring", "damping", "utilization", "mode",
)  # fmt: skip


def columns(motion: Trajectory, rate: float = 150.0, most: int = 6000) -> dict[str, Floats]:
    """The motion at a steady rate and at both sides of each event, in order of time.

    Parameters
    ----------
    motion : Trajectory
    rate : float, default 150
        Samples a second of motion [1/s].
    most : int, default 6000
        Most samples between events [1].

    Returns
    -------
    columns : dict of ndarray
        Equal lengths; `mode` is the code of the mode's word, see `codes_of`: words and colours follow it.
    """
    duration = motion.duration
    count = min(max(math.ceil(duration * rate), 240), most)
    steady = np.linspace(0.0, duration, count + 1) if duration > 0.0 else np.zeros(1)
    # the end of the last piece can lie a rounding beyond the duration
    marks = np.unique(np.minimum([event.t for event in motion.events], duration))
    times = np.union1d(steady, marks)
    after = motion.at(times)
    before = motion.at(marks[marks > 0.0], side="left")
    order = np.argsort(np.concatenate([before.t, times]), kind="stable")
    joined: dict[str, Floats] = {}
    plane = motion.scenario.plane
    for name in (*PRECISE, *DRAWN):
        if name == "mode":
            continue
        if name == "utilization":
            pair = [before.utilization(plane), after.utilization(plane)]
        else:
            pair = [getattr(before, name), getattr(after, name)]
        joined[name] = np.concatenate(pair)[order]
    letters = np.concatenate([before.mode, after.mode])[order]
    joined["mode"] = codes_of(mode_words(letters, coming_rotation(joined["omega"])))
    return joined


def codes_of(words: np.ndarray) -> Floats:
    """The code of each mode's word: its place in `vocabulary.words.MODES`, or their number for another word.

    Parameters
    ----------
    words : ndarray of str

    Returns
    -------
    codes : ndarray
        [1].
    """
    codes = np.full(words.shape, float(len(MODES)))
    for code, word in enumerate(MODES):
        codes[words == word] = code
    return codes


def pack(header: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> bytes:
    """One block of bytes: length of the header, header in JSON, arrays.

    Parameters
    ----------
    header : dict
        Anything JSON holds; under `arrays` the names, types, shapes and places of the arrays are added.
    arrays : dict of ndarray
        Of numbers.

    Returns
    -------
    block : bytes
        Little-endian; each array starts at a multiple of 8 bytes, counted from the end of the header.
    """
    listing, blocks, place = [], [], 0
    for name, array in arrays.items():
        kind = "f8" if name in PRECISE else "u1" if array.dtype == np.uint8 else "f4"
        with np.errstate(over="ignore"):  # beyond the range of f4 is infinite, and not drawn
            block = np.ascontiguousarray(array, "<" + kind).tobytes()
        listing.append({"name": name, "type": kind, "shape": list(array.shape), "place": place})
        block += bytes(-len(block) % 8)
        blocks.append(block)
        place += len(block)
    text = json.dumps({**header, "arrays": listing}, allow_nan=False, separators=(",", ":")).encode()
    text += b" " * (-(len(text) + 4) % 8)
    return struct.pack("<I", len(text)) + text + b"".join(blocks)


def unpack(block: bytes) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """The header and the arrays that `pack` wrote.

    Parameters
    ----------
    block : bytes

    Returns
    -------
    header, arrays : tuple of dict
    """
    (length,) = struct.unpack_from("<I", block)
    header = json.loads(block[4 : 4 + length])
    arrays = {}
    for entry in header.pop("arrays"):
        shape = tuple(entry["shape"])
        arrays[entry["name"]] = np.frombuffer(
            block, "<" + entry["type"], math.prod(shape), 4 + length + entry["place"]
        ).reshape(shape)
    return header, arrays
