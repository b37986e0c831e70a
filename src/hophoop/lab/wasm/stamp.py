"""Stamps of the built modules, to check that they match the sources."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

from hophoop.kernel.native.sources import PACKAGE, ROOMS, stamp_of

HERE = Path(__file__).parent
MODULE, DERIVATIVES, LAYOUT = "hophoop.wasm", "hophoop-derivatives.wasm", "layout.json"
# Files of other packages that determine the modules' bytes, and files that control their compilation.
FILES = (
    "kernel/numerics/tables.json", "maps/grid/friction_utilization.py", "maps/grid/kernel.py", "kernel/native/marks.py",
    "lab/wasm/nrt.c", "kernel/build/browser.py", "kernel/build/link.py", "kernel/build/numba_code.py",
)  # fmt: skip


@cache
def built() -> dict[str, Any]:
    """Return the description of the built modules: sources, hashes, signatures.

    Returns
    -------
    told : dict
        The content of `LAYOUT`.
    """
    told: dict[str, Any] = json.loads((HERE / LAYOUT).read_text(encoding="utf-8"))
    return told


def stamped() -> list[Path]:
    """Return the sources that determine the modules' bytes.

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
    """Return the hash of the sources of the modules.

    Returns
    -------
    stamp : str
        Equal stamps mean equal sources.
    """
    return stamp_of(stamped())
