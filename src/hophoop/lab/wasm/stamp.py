"""The built modules, and whether they are those of the sources beside them."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

from hophoop.kernel.native.sources import PACKAGE, ROOMS, stamp_of

HERE = Path(__file__).parent
MODULE, DERIVATIVES, LAYOUT = "hophoop.wasm", "hophoop-derivatives.wasm", "layout.json"
# What decides the modules' bytes, apart from the rooms of the kernels: files of other rooms, and how they are compiled.
FILES = (
    "maps/grid/friction_utilization.py", "maps/grid/kernel.py", "kernel/native/marks.py", "lab/wasm/nrt.c",
    "kernel/build/browser.py", "kernel/build/link.py", "kernel/build/numba_code.py",
)  # fmt: skip


@cache
def built() -> dict[str, Any]:
    """What is told of the modules that are built: their sources, their hashes, how they are called.

    Returns
    -------
    told : dict
        The content of `LAYOUT`.
    """
    told: dict[str, Any] = json.loads((HERE / LAYOUT).read_text(encoding="utf-8"))
    return told


def stamped() -> list[Path]:
    """The sources that decide the modules' bytes.

    Returns
    -------
    files : list of Path
        Sorted.
    """
    files = {PACKAGE / name for name in FILES}
    for room in (*ROOMS, "lab/wasm"):
        files.update((PACKAGE / room).glob("*.py"))
    return sorted(files - {Path(__file__)})


def sources() -> str:
    """Hash of the sources that the modules are made of.

    Returns
    -------
    stamp : str
        Equal stamps, equal sources.
    """
    return stamp_of(stamped())
