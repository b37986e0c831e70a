"""Stamps of the built modules, to check that they match the sources."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

from hophoop.kernel.native.sources import PACKAGE, files, stamp

HERE = Path(__file__).parent
MODULE, FATES, LAYOUT = "hophoop.wasm", "hophoop-fates.wasm", "layout.json"


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
    return files(_tools())


def sources() -> str:
    """Return the hash of the sources of the modules.

    Returns
    -------
    stamp : str
        Equal stamps mean equal sources.
    """
    return stamp(_tools())


def _tools() -> list[str]:
    own = [file.relative_to(PACKAGE).as_posix() for file in HERE.glob("*.py") if file != Path(__file__)]
    return ["kernel/build/browser.py", *own]
