"""Calls of the library's functions: arguments are packed into a memory block, and results are read from it.

A function takes one address. The block holds 8 bytes per number, and for an array its address and shape; the results follow. A
function releases the interpreter lock, and threads share no block.
"""

from __future__ import annotations

import ctypes
import struct
import threading
from collections.abc import Callable
from importlib import import_module
from typing import Any, cast

import numpy as np

MOST_KNOWN, MOST_BYTES = 16, 1 << 20  # cached tables and named tuples per entry, and their maximum size
CODES = {"float": "d", "int": "q", "bool": "?7x"}


def _address(array: np.ndarray) -> int:
    if array.size and array.flags.writeable:  # 4 times as fast as `ctypes.data`
        return ctypes.addressof(ctypes.c_char.from_buffer(cast(Any, array)))
    return int(array.ctypes.data)


class Memory:
    """The memory block of an entry, and a cache of arrays that are passed repeatedly."""

    def __init__(self, size: int) -> None:
        self.block = ctypes.create_string_buffer(size)
        self.address = ctypes.addressof(self.block)
        self.known: dict[int, tuple[Any, tuple[int, ...]]] = {}

    def numbers_of(self, array: np.ndarray, dtype: np.dtype[Any], dimensions: int) -> tuple[int, ...]:
        """Return address and shape of an array of this type."""
        if dtype.names is not None:  # only tables of records are passed repeatedly
            known = self.known.get(id(array))
            if known is not None and known[0] is array:
                return known[1]
        if not (array.flags.c_contiguous and array.ndim == dimensions and array.dtype == dtype):
            raise TypeError(f"The compiled kernel takes no such array: {array.dtype} array of shape {array.shape}.")
        found = (_address(array), *array.shape)
        if dtype.names is not None and array.nbytes <= MOST_BYTES:
            self._remember(array, found)
        return found

    def numbers_of_all(self, arrays: Any, kinds: tuple[tuple[np.dtype[Any], int], ...]) -> tuple[int, ...]:
        """Return addresses and shapes of the arrays of a named tuple that is passed repeatedly."""
        known = self.known.get(id(arrays))
        if known is None or known[0] is not arrays:
            found: tuple[int, ...] = ()
            for array, kind in zip(arrays, kinds, strict=True):
                found += self.numbers_of(array, *kind)
            if sum(array.nbytes for array in arrays) <= MOST_BYTES:
                self._remember(arrays, found)
            return found
        return known[1]

    def _remember(self, given: Any, found: tuple[int, ...]) -> None:
        if len(self.known) >= MOST_KNOWN:
            self.known.clear()
        self.known[id(given)] = given, found


class ThreadMemory(threading.local):
    """The memory of an entry in this thread."""

    def __init__(self, size: int) -> None:
        self.memory = Memory(size)


class Packing:
    """Packing of an entry's arguments: their formats, their expressions, and the types of arrays.

    Parameters
    ----------
    takes : list
        As recorded by the build: 'float', 'int' or 'bool'; {"array": [dtype, dimensions]}; {"tuple": [...]}.
    """

    def __init__(self, takes: list[Any]) -> None:
        self.codes: list[str] = []
        self.parts: list[str] = []
        self.kinds: list[Any] = []  # (dtype, dimensions) of each array, or those of all arrays in a named tuple
        self.names = [f"a{i}" for i in range(len(takes))]
        for name, kind in zip(self.names, takes, strict=True):
            self._add(kind, name)

    def _add(self, kind: Any, place: str) -> None:
        if isinstance(kind, str):
            self.codes.append(CODES[kind])
            self.parts.append(place)
            return
        if "array" in kind:
            self.codes.append("q" * (1 + kind["array"][1]))
            self.parts.append(f"*memory.numbers_of({place}, *kinds[{len(self.kinds)}])")
            self.kinds.append(_kind(kind))
            return
        items = kind["tuple"]
        if all(isinstance(each, dict) and "array" in each for each in items):
            self.codes.extend("q" * (1 + each["array"][1]) for each in items)
            self.parts.append(f"*memory.numbers_of_all({place}, kinds[{len(self.kinds)}])")
            self.kinds.append(tuple(_kind(each) for each in items))
            return
        plain = next((i for i, each in enumerate(items) if not isinstance(each, str)), len(items))
        self.codes.extend(CODES[each] for each in items[:plain])
        self.parts.append(f"*{place}" if plain == len(items) else f"*{place}[:{plain}]")
        for i, each in enumerate(items[plain:], plain):
            self._add(each, f"{place}[{i}]")


def _kind(told: dict[str, Any]) -> tuple[np.dtype[Any], int]:
    described, dimensions = told["array"]
    return np.dtype(described if isinstance(described, str) else [tuple(field) for field in described]), dimensions


def _unpacked(told: Any, values: str, at: list[int], classes: list[Any]) -> str:
    """Return the expression of a result, from the numbers of the block."""
    if isinstance(told, dict):
        inner = ", ".join(_unpacked(each, values, at, classes) for each in told["items"])
        if told["class"] is None:
            return f"({inner},)"
        module, _, name = told["class"].partition(":")
        classes.append(getattr(import_module(module), name))
        return f"classes[{len(classes) - 1}]({inner})"
    at[0] += 1
    return f"{values}[{at[0] - 1}]"


def _codes(told: Any) -> str:
    if isinstance(told, dict):
        return "".join(_codes(each) for each in told["items"])
    return str(told)


def caller(function: Any, takes: list[Any], gives: Any) -> Callable[..., Any]:
    """Return a Python function that calls a function of the library.

    Parameters
    ----------
    function : ctypes function
    takes : list
        As `Packing` takes it.
    gives : str, dict or None
        'd', 'q' or '?7x'; several with their class; None for nothing.

    Returns
    -------
    call : callable
    """
    packing = Packing(takes)
    given = struct.Struct("=" + "".join(packing.codes))
    back = struct.Struct("=" + (_codes(gives) if gives is not None else ""))
    classes: list[Any] = []
    result = _unpacked(gives, "values", [0], classes) if gives is not None else "None"
    if isinstance(gives, dict) and not any(isinstance(each, dict) for each in gives["items"]):
        result = "classes[0]._make(values)" if classes else "values"  # half the time of one number after the other
    function.argtypes = (ctypes.c_void_p,)
    function.restype = ctypes.c_int32
    names = ", ".join(packing.names)
    lines = [f"def call({names}):", "    memory = local.memory"]
    lines += [f"    pack(memory.block, 0, {', '.join(packing.parts)})"]
    lines += ["    status = function(memory.address)", "    if status:", "        fail(status)"]
    if gives is not None:
        lines += [f"    values = unpack(memory.block, {given.size})"]
    lines += [f"    return {result}"]
    space: dict[str, Any] = {
        "pack": given.pack_into, "unpack": back.unpack_from, "local": ThreadMemory(given.size + back.size + 8),
        "function": function, "classes": classes, "kinds": packing.kinds, "fail": _fail,
    }  # fmt: skip
    exec("\n".join(lines), space)
    made: Callable[..., Any] = space["call"]
    return made


def _fail(status: int) -> None:
    raise RuntimeError(f"The compiled kernel ended with status {status}.")
