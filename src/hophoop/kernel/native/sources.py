"""Sources of the compiled kernels: the hash of their files, and the hash of what is compiled of them."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Iterator, Mapping
from enum import EnumType
from functools import cache
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any

import numpy as np

from hophoop.kernel.native.marks import mark_of, replaced, source_of

PACKAGE = Path(__file__).parents[2]
# Packages and single files with kernels and their constants, and files that control their compilation.
ROOMS = (
    "kernel/numerics", "kernel/physics", "kernel/panels", "kernel/records", "kernel/rigid", "kernel/compliant",
    "theory/kernels", "gaits/kernels", "derivatives", "derivatives/events", "derivatives/pieces",
)  # fmt: skip
FILES = (
    "kernel/numerics/tables.json", "maps/grid/friction_utilization.py", "maps/grid/kernel.py", "kernel/entries.py",
    "kernel/native/marks.py",
)  # fmt: skip
TOOLS = ("kernel/build/lowering.py", "kernel/build/link.py", "lab/wasm/nrt.c")
LIBRARY_TOOLS = ("kernel/build/level.c",)


def files(others: Iterable[str] = LIBRARY_TOOLS) -> list[Path]:
    """Return the sources of the library, or of other code that `others` make of the same kernels, sorted."""
    found = {PACKAGE / name for name in (*FILES, *TOOLS, *others)}
    for room in ROOMS:
        found.update((PACKAGE / room).glob("*.py"))
    return sorted(found)


def stamp(others: Iterable[str] = LIBRARY_TOOLS) -> str:
    """Return a hash of these files: equal stamps mean equal sources."""
    digest = hashlib.sha256()
    for file in files(others):
        digest.update(f"{file.relative_to(PACKAGE).as_posix()}\n".encode())
        digest.update(file.read_bytes().replace(b"\r\n", b"\n"))
    return digest.hexdigest()[:32]


# --- what is compiled of a kernel ------------------------------------------------------------------------------------


def is_kernel(value: Any) -> bool:
    """Return True for a function of this package; a kernel calls nothing else of it, apart from `replaced`."""
    return isinstance(value, FunctionType) and value.__module__.startswith("hophoop.") and value is not replaced


def used(kernel: Any) -> Iterator[tuple[str, Any]]:
    """Yield the names of kernels and constants that a kernel uses, with their values."""
    function = source_of(kernel)
    for name in function.__code__.co_names:
        if name in function.__globals__:
            yield name, function.__globals__[name]


def called(kernel: Any) -> list[Any]:
    """Return the kernels that a kernel calls directly."""
    return [value for _, value in used(kernel) if is_kernel(value)]


def name_of(kernel: Any) -> str:
    """Return the dotted name of a kernel."""
    return f"{kernel.__module__}.{kernel.__qualname__}"


@cache
def own_hash(kernel: Any) -> str:
    """Return a hash of a kernel alone: its instructions, its constants, and the names and arguments of its callees."""
    function = source_of(kernel)
    lines = [f"{name_of(kernel)} {mark_of(kernel)} {_arguments(kernel)} {_text(function.__code__, function.__doc__)}"]
    for name, value in used(kernel):
        lines.append(f"{name} {f'{name_of(value)} {_arguments(value)}' if is_kernel(value) else _text(value)}")
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:32]


def _arguments(kernel: Any) -> str:
    function = source_of(kernel)
    return f"{function.__code__.co_varnames[: function.__code__.co_argcount]} {function.__defaults__}"


def reached(kernels: Iterable[Any]) -> set[Any]:
    """Return kernels with all that they call, directly or not."""
    found, waiting = set[Any](), list(kernels)
    while waiting:
        kernel = waiting.pop()
        if kernel not in found:
            found.add(kernel)
            waiting += called(kernel)
    return found


def _text(value: Any, docstring: str | None = None) -> str:
    """Return a text of a constant that changes with its value; that of code does not change with lines and comments."""
    if isinstance(value, CodeType):
        constants = [_text(each) for place, each in enumerate(value.co_consts) if place or each != docstring]
        return f"{value.co_code.hex()} {value.co_names} {value.co_varnames} {value.co_argcount} {constants}"
    if isinstance(value, np.ndarray):
        return f"{value.dtype} {value.shape} {value.tobytes().hex()}"
    if isinstance(value, EnumType):
        return str(list(value))
    if isinstance(value, type):
        return f"{value.__module__}.{value.__qualname__} {getattr(value, '_fields', '')}"
    return value.__name__ if isinstance(value, (ModuleType, FunctionType)) else repr(value)


def hash_of(entries: Mapping[Any, Any], tools: Iterable[str]) -> str:
    """Return a hash of kernels with the types of their arguments, and of files that compile them, without comments."""
    lines = [*(f"{name_of(kernel)} {kinds}" for kernel, kinds in entries.items()), *sorted(map(own_hash, reached(entries)))]
    digest = hashlib.sha256("\n".join(lines).encode())
    for name in tools:
        content = (PACKAGE / name).read_bytes()
        digest.update(_text(compile(content, name, "exec", optimize=2)).encode() if name.endswith(".py") else content)
    return digest.hexdigest()[:32]
