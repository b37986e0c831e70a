"""JSON and arrays in one block of bytes, for page and widget."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Mapping
from typing import Any

import numpy as np

# Positions and times need all digits in a long motion; other columns are only drawn, as f4.
PRECISE = ("t", "x", "height", "angle")


def pack(header: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> bytes:
    """Return one block of bytes: length of the header, header in JSON, arrays.

    Parameters
    ----------
    header : dict
        Any JSON object; the names, types, shapes and offsets of the arrays are added under `arrays`.
    arrays : dict of ndarray
        Numeric arrays.

    Returns
    -------
    block : bytes
        Little-endian; each array starts at a multiple of 8 bytes, counted from the end of the header.
    """
    listing, blocks, place = [], [], 0
    for name, array in arrays.items():
        kind = "f8" if name in PRECISE else "u1" if array.dtype == np.uint8 else "f4"
        with np.errstate(over="ignore"):  # values beyond the range of f4 become infinite, and are not drawn
            block = np.ascontiguousarray(array, "<" + kind).tobytes()
        listing.append({"name": name, "type": kind, "shape": list(array.shape), "place": place})
        block += bytes(-len(block) % 8)
        blocks.append(block)
        place += len(block)
    text = json.dumps({**finite(header), "arrays": listing}, allow_nan=False, separators=(",", ":")).encode()
    text += b" " * (-(len(text) + 4) % 8)
    return struct.pack("<I", len(text)) + text + b"".join(blocks)


def finite(value: Any) -> Any:
    """Replace infinity and nan by None, because JSON has neither."""
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [finite(item) for item in value]
    return value


def unpack(block: bytes) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """Return the header and the arrays of a block made by `pack`.

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
