"""What a kernel is made of, whoever runs it: the function, its options, the names that it calls."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import update_wrapper
from types import CellType, FunctionType
from typing import Any, NamedTuple, cast

import numpy as np


class Options(NamedTuple):
    """How Numba compiles a kernel."""

    nrt: bool = True  # reference counts
    forceinline: bool = False
    unit: bool = False  # compiled by itself, whoever calls it
    outer: bool = False  # optimised only as a part of the whole
    apart: bool = False  # never inlined


class Source:
    """A function that Numba can compile."""

    def __init__(self, function: Callable[..., Any], options: Options) -> None:
        update_wrapper(cast(Any, self), function)
        self.py_func = cast(FunctionType, function)
        self.options = options
        self.by_arrays: Callable[..., Any] | None = None  # what runs instead where the kernel is interpreted

    def __reduce__(self) -> str:
        return self.py_func.__qualname__

    def __repr__(self) -> str:
        return f"<kernel {self.py_func.__module__}.{self.py_func.__qualname__}>"


def describe(value: Any) -> Any:
    """What Numba's type of a value depends on, as something that can be compared, hashed and pickled."""
    if isinstance(value, np.ndarray):
        flags = value.flags
        layout = "C" if flags.c_contiguous else "F" if flags.f_contiguous else "A"
        return "array", value.dtype.str if value.dtype.names is None else value.dtype, value.ndim, layout, flags.writeable
    if isinstance(value, tuple):
        return "tuple", type(value), tuple(describe(item) for item in value)
    return "scalar", type(value)


class Namespaces:
    """Copies of modules' names in which every kernel stands as something else: a plain function, or a dispatcher.

    So the code of a kernel is one, and what it calls is of its own kind.
    """

    def __init__(self, made: Callable[[Source, FunctionType], Any]) -> None:
        self._make = made
        self._names: dict[int, dict[str, Any]] = {}
        self._made: dict[Source, Any] = {}
        self._lock = threading.RLock()

    def of(self, kernel: Source) -> Any:
        """What stands for a kernel."""
        with self._lock:
            if kernel not in self._made:
                self._made[kernel] = self._make(kernel, self.copied(kernel.py_func))
                self.fill(kernel.py_func)
            return self._made[kernel]

    def copied(self, function: FunctionType) -> FunctionType:
        """The function with the names of this kind."""
        with self._lock:
            names = self._names.setdefault(id(function.__globals__), {})
            cells = tuple(CellType(self._replaced(cell.cell_contents)) for cell in function.__closure__ or ())
            copy = FunctionType(function.__code__, names, function.__name__, function.__defaults__, cells or None)
            copy.__kwdefaults__ = function.__kwdefaults__
            copy.__qualname__ = function.__qualname__
            copy.__module__ = function.__module__
            copy.__doc__ = function.__doc__
            return copy

    def fill(self, function: FunctionType) -> None:
        """See to it that the names that a copied function uses are there."""
        given = function.__globals__
        names = self._names[id(given)]
        if len(names) != len(given):  # new, or the module has got more names since
            names.update(given)
            for name, value in given.items():
                names[name] = self._replaced(value)

    def _replaced(self, value: Any) -> Any:
        return self.of(value) if isinstance(value, Source) else value
