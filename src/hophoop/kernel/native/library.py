"""The library of compiled kernels: whether there is one for this machine and these sources, and its functions.

The environment variable HOPHOOP_LEVEL, such as `v2`, takes the library for older processors.
"""

from __future__ import annotations

import ctypes
import hashlib
import json
import os
import platform
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from hophoop._support.errors import InputError
from hophoop.kernel.native.calls import caller
from hophoop.kernel.native.sources import PACKAGE, stamp

HERE = Path(os.environ.get("HOPHOOP_LIBRARY") or PACKAGE / "kernel" / "library")
TOLD = "kernels.json"
BUILD = "python -m hophoop.kernel.build"


class Library:
    """A library that is loaded.

    Attributes
    ----------
    told : dict
        What the build has written about it.
    level : str
        Which kind of processor it is made for.
    """

    def __init__(self, told: dict[str, Any], level: str, loaded: ctypes.CDLL) -> None:
        self.told, self.level = told, level
        self._loaded = loaded
        self._calls: dict[str, Callable[..., Any]] = {}

    def call(self, name: str) -> Callable[..., Any]:
        """What calls an entry.

        Raises
        ------
        KeyError
            If the library has none of this name.
        """
        if name not in self._calls:
            entry = self.told["entries"][name]
            self._calls[name] = caller(getattr(self._loaded, entry["symbol"]), entry["takes"], entry["gives"])
        return self._calls[name]


def _levels(told: dict[str, Any]) -> list[str]:
    """The libraries from the one that asks most of the processor to the one that asks least, up to HOPHOOP_LEVEL."""
    levels = sorted(told["files"], reverse=True)
    most = os.environ.get("HOPHOOP_LEVEL") or levels[0]
    if most not in levels:
        raise InputError.of_field("HOPHOOP_LEVEL", most, f"one of {', '.join(reversed(levels))}")
    return levels[levels.index(most) :]


@cache
def library(quiet: bool = False) -> Library | None:
    """The library of this machine, loaded; None where there is none, which is told of once, with what that costs."""
    found = _found()
    if isinstance(found, str):
        from multiprocessing import parent_process

        if not quiet and sys.stderr is not None and parent_process() is None:
            print(f"{found} Without them a motion takes some milliseconds, a hundred times as long.", file=sys.stderr)
        return None
    return found


def why_none() -> str:
    """Why there is no library; empty where there is one."""
    found = _found()
    return found if isinstance(found, str) else ""


def _loaded(name: str) -> ctypes.CDLL:
    """A file of the library, if it has the bytes that its name tells: one that is cut short may end the process.

    Raises
    ------
    OSError
        If it has not, or cannot be loaded.
    """
    file = HERE / name
    if hashlib.sha256(file.read_bytes()).hexdigest()[:12] not in name:
        raise OSError(f"{name} is damaged")
    return ctypes.CDLL(str(file))


@cache
def _found() -> Library | str:
    try:
        told = json.loads((HERE / TOLD).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return f"hophoop was installed without compiled kernels. To build them: {BUILD}."
    if not {"machine", "sources", "files", "entries"} <= set(told):
        return f"The library of compiled kernels is not whole. To build it anew: {BUILD}."
    if told["machine"] != [sys.platform, platform.machine().lower()]:
        return f"The compiled kernels are for {' '.join(told['machine'])}. To build them for this machine: {BUILD}."
    if told["sources"] != stamp():
        return f"The compiled kernels are older than their sources. To build them anew: {BUILD}."
    levels = _levels(told)
    try:
        loaded = _loaded(told["files"][levels[-1]])
        able = loaded.hophoop_level()
        if able < int(levels[-1][1:]):
            return "The compiled kernels ask more than this processor has."
        best = next(level for level in levels if int(level[1:]) <= able)
        if best != levels[-1]:
            loaded = _loaded(told["files"][best])
    except OSError as error:
        return f"The compiled kernels cannot be loaded ({error}). To build them anew: {BUILD}."
    return Library(told, best, loaded)
