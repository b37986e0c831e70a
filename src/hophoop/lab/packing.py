"""JSON and arrays in one block of bytes, as page and widget take them."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Mapping
from typing import Any

import numpy as np

# Positions and times need all digits where a motion is long; the rest is drawn only.
PRECISE = ("t", "x", "height", "angle")


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
