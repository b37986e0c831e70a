"""Calls of the library's functions: arguments are packed into a block of memory, and results are read from it.

A function takes the block's address, as a pointer to doubles, to integers and to pointers. The block holds 8 bytes per number,
and for an array its address and shape; the results follow. A function releases the interpreter lock. Threads share no block.
"""

from __future__ import annotations

import ctypes
import struct
import threading
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any, cast

import numpy as np

MOST_KNOWN, MOST_BYTES = 16, 1 << 20  # cached tables and named tuples per entry, and their maximum size
CODES = {"float": "d", "int": "q", "bool": "?7x"}


class Memory(threading.local):
    """The memory block of an entry in this thread, its address, and the numbers of what is passed repeatedly."""

    def __init__(self, size: int) -> None:
        block = ctypes.create_string_buffer(size)
        self.all = block, ctypes.addressof(block), dict[int, tuple[Any, tuple[int, ...]]]()


def _numbers(array: np.ndarray, dtype: np.dtype[Any], dimensions: int) -> tuple[int, ...]:
    """Return address and shape of an array of this type."""
    if not (array.flags.c_contiguous and array.ndim == dimensions and array.dtype == dtype):
        raise TypeError(f"The compiled kernel takes no such array: {array.dtype} array of shape {array.shape}.")
    if array.size and array.flags.writeable:  # 4 times as fast as `ctypes.data`
        return ctypes.addressof(ctypes.c_char.from_buffer(cast(Any, array))), *array.shape
    return array.ctypes.data, *array.shape


def _remembered(known: dict[int, tuple[Any, tuple[int, ...]]], given: Any, kinds: list[Any]) -> tuple[int, ...]:
    """Return the numbers of a table of records, or of a tuple of arrays, which are passed repeatedly."""
    found = known.get(id(given))
    if found is not None and found[0] is given:
        return found[1]
    arrays = given if isinstance(given, tuple) else (given,)
    numbers = tuple(number for array, kind in zip(arrays, kinds, strict=True) for number in _numbers(array, *kind))
    if sum(array.nbytes for array in arrays) <= MOST_BYTES:
        if len(known) >= MOST_KNOWN:
            known.clear()
        known[id(given)] = given, numbers
    return numbers


def _format(told: Any) -> str:
    """Return the format of a value in the block."""
    if told is None:
        return ""
    if isinstance(told, str):
        return CODES[told]
    return "q" * (1 + told["array"][1]) if "array" in told else "".join(map(_format, told["items"]))


def _kind(told: Any) -> tuple[np.dtype[Any], int]:
    described, dimensions = told["array"]
    return np.dtype(described if isinstance(described, str) else [tuple(field) for field in described]), dimensions


def _packed(told: Any, place: str, kinds: list[Any]) -> str:
    """Return the expression of an argument's numbers."""
    if isinstance(told, str):
        return place
    items = told.get("items", [told])
    if all(isinstance(each, str) for each in items):
        return f"*{place}"
    if not all("array" in each for each in items):
        return ", ".join(_packed(each, f"{place}[{i}]", kinds) for i, each in enumerate(items))
    kinds.append([_kind(each) for each in items])
    if "array" in told and isinstance(told["array"][0], str):
        return f"*numbers({place}, *kinds[{len(kinds) - 1}][0])"
    return f"*remembered(known, {place}, kinds[{len(kinds) - 1}])"


def _unpacked(told: Any, at: Iterator[int], classes: list[Any]) -> str:
    """Return the expression of a result, from the numbers of the block."""
    if isinstance(told, str):
        return f"values[{next(at)}]"
    inner = ", ".join(_unpacked(each, at, classes) for each in told["items"])
    if told["class"] is None:
        return f"({inner},)"
    module, _, name = told["class"].rpartition(".")
    classes.append(getattr(import_module(module), name))
    return f"classes[{len(classes) - 1}]({inner})"


def caller(function: Any, takes: list[Any], gives: Any) -> Callable[..., Any]:
    """Return a Python function that calls a function of the library.

    Parameters
    ----------
    function : ctypes function
    takes : list
        As recorded by the build: 'float', 'int' or 'bool'; {"array": [dtype, dimensions]}; {"items": [...]}.
    gives : str, dict or None
        The same for the result, without arrays and with the "class" of a tuple; None for nothing.

    Returns
    -------
    call : callable
    """
    given, back = struct.Struct("=" + "".join(map(_format, takes))), struct.Struct("=" + _format(gives))
    names, kinds, classes = [f"a{i}" for i in range(len(takes))], list[Any](), list[Any]()
    parts = [_packed(told, name, kinds) for told, name in zip(takes, names, strict=True)]
    result = "None" if gives is None else _unpacked(gives, iter(range(back.size // 8)), classes)
    function.argtypes = (ctypes.c_void_p,) * 3
    function.restype = ctypes.c_int32
    source = f"""
def call({", ".join(names)}):
    block, address, known = local.all
    pack(block, 0, {", ".join(parts)})
    status = function(address, address, address)
    if status:
        raise RuntimeError(f"The compiled kernel ended with status {{status}}.")
    values = unpack(block, {given.size})
    return {result}
"""
    space: dict[str, Any] = {
        "pack": given.pack_into, "unpack": back.unpack_from, "local": Memory(given.size + back.size + 8),
        "function": function, "classes": classes, "kinds": kinds, "numbers": _numbers, "remembered": _remembered,
    }  # fmt: skip
    exec(source, space)
    made: Callable[..., Any] = space["call"]
    return made
