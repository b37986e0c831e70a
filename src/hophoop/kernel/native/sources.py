"""Source files of the kernels, of which the library and the browser's modules are compiled."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any

PACKAGE = Path(__file__).parents[2]
# Packages that only contain kernels, single files of other packages, and files that control their compilation.
ROOMS = (
    "kernel/numerics", "kernel/physics", "kernel/panels", "kernel/records", "kernel/rigid", "kernel/compliant",
    "theory/kernels", "gaits/kernels", "derivatives", "derivatives/events", "derivatives/pieces",
)  # fmt: skip
FILES = (
    "kernel/numerics/tables.json", "maps/grid/friction_utilization.py", "maps/grid/kernel.py", "kernel/entries.py",
    "kernel/native/marks.py", "lab/wasm/nrt.c", "kernel/build/numba_code.py", "kernel/build/entry_code.py",
    "kernel/build/link.py", "kernel/build/level.c",
)  # fmt: skip


def files() -> list[Path]:
    """Return the sources that determine the library's bytes, sorted."""
    found = {PACKAGE / name for name in FILES}
    for room in ROOMS:
        found.update((PACKAGE / room).glob("*.py"))
    return sorted(found)


def stamp() -> str:
    """Return a hash of these sources: equal stamps mean equal sources."""
    return stamp_of(files())


def stamp_of(sources: Iterable[Path]) -> str:
    """Return a hash of files of the package."""
    digest = hashlib.sha256()
    for file in sources:
        digest.update(f"{file.relative_to(PACKAGE).as_posix()}\n".encode())
        digest.update(file.read_bytes().replace(b"\r\n", b"\n"))
    return digest.hexdigest()[:32]


@cache
def _modules() -> frozenset[str]:
    names = {file.relative_to(PACKAGE).with_suffix("").as_posix() for file in files()}
    names |= {file.relative_to(PACKAGE).with_suffix("").as_posix() for file in (PACKAGE / "lab" / "wasm").glob("*.py")}
    return frozenset(f"hophoop.{name.removesuffix('/__init__').replace('/', '.')}" for name in names)


def is_kernel(value: Any) -> bool:
    """Return True for a function in a kernel's source."""
    return isinstance(value, FunctionType) and value.__module__ in _modules()
