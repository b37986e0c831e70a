"""A checksum of datasets, by what they say and not by how a format writes it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Collection, Mapping
from typing import Any

import numpy as np

CHECKSUM = "checksum"  # the attribute that holds it
# Attributes that xarray or a format adds by itself.
_OF_FORMATS = {CHECKSUM, "_FillValue", "_ARRAY_DIMENSIONS", "coordinates"}


def checksum(groups: Mapping[str, Any], without: Collection[str] = ()) -> str:
    """SHA-256 of every name, attribute and number.

    Parameters
    ----------
    groups : mapping of str to xarray.Dataset
        Read without decoding.
    without : collection of str
        Variables whose numbers do not count, but for how many there are and of which type.

    Returns
    -------
    checksum : str
        In hexadecimal digits.
    """
    digest = hashlib.sha256()

    def add(*words: Any) -> None:
        digest.update(json.dumps(words, ensure_ascii=False).encode() + b"\n")

    for group in sorted(groups):
        dataset = groups[group]
        add(group, _attributes(dataset))
        for name in sorted(dataset.variables):
            variable = dataset.variables[name]
            kind = variable.dtype.newbyteorder("<")
            add(name, variable.dims, variable.shape, kind.str, _attributes(variable))
            if name not in without:
                digest.update(np.ascontiguousarray(variable.values).astype(kind).tobytes())
    return digest.hexdigest()


def _attributes(thing: Any) -> list[Any]:
    # a format may give a list of one number back as the number
    return [(name, np.ravel(np.asarray(thing.attrs[name])).tolist()) for name in sorted(thing.attrs) if name not in _OF_FORMATS]
