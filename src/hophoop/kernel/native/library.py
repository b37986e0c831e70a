"""The library of compiled kernels: search for one that fits this machine and these sources, and calls of its functions.

`compiled` calls a kernel of the library, or interprets its source; both give the same bits. The environment variable
HOPHOOP_KERNELS can force one: `interpreted` always runs the sources, `compiled` fails without a library. HOPHOOP_LEVEL, such as
`v2`, selects the library for older processors.
"""

from __future__ import annotations

import contextlib
import ctypes
import hashlib
import json
import os
import platform
import re
import sys
from collections.abc import Callable, Iterator
from functools import cache, cached_property
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from hophoop._support.errors import InputError
from hophoop.kernel.native.calls import caller
from hophoop.kernel.native.sources import PACKAGE, stamp

HERE = Path(os.environ.get("HOPHOOP_LIBRARY") or PACKAGE / "kernel" / "library")
MANIFEST = "kernels.json"
BUILD = "python -m hophoop.kernel.build"
DAMAGED = f"The library of compiled kernels is damaged. To rebuild it: {BUILD}."


class Library:
    """A loaded library.

    Attributes
    ----------
    told : dict
        The build's description of it.
    level : str
        Kind of processor that it is compiled for.
    """

    def __init__(self, told: dict[str, Any], level: str, loaded: ctypes.CDLL) -> None:
        self.told, self.level = told, level
        self._loaded = loaded
        self._calls: dict[str, Callable[..., Any]] = {}

    def call(self, name: str) -> Callable[..., Any]:
        """Return a callable for an entry.

        Raises
        ------
        OSError
            If the library's description of the entry is missing or damaged.
        """
        if name not in self._calls:
            try:
                entry = self.told["entries"][name]
                self._calls[name] = caller(getattr(self._loaded, entry["symbol"]), entry["takes"], entry["gives"])
            except (LookupError, TypeError, ValueError, AttributeError, ImportError, SyntaxError):
                raise OSError(DAMAGED) from None
        return self._calls[name]


def _levels(told: dict[str, Any]) -> list[str]:
    """Return the levels of the library's files, highest processor requirements first, up to HOPHOOP_LEVEL."""
    levels = sorted(told["files"], reverse=True)
    most = os.environ.get("HOPHOOP_LEVEL") or levels[0]
    if most not in levels:
        raise InputError.of_field("HOPHOOP_LEVEL", most, f"one of {', '.join(reversed(levels))}")
    return levels[levels.index(most) :]


@cache
def library(quiet: bool = False) -> Library | None:
    """Return the library of this machine; None, with one message on stderr unless `quiet`, if there is none."""
    found = _found()
    if isinstance(found, str):
        if not quiet:
            say_missing(found)
        return None
    return found


@cache
def say_missing(why: str) -> None:
    """Print once on stderr why kernels are interpreted, and what this costs; child processes print nothing."""
    from multiprocessing import parent_process

    if sys.stderr is not None and parent_process() is None:
        print(f"{why} Without them a motion takes about 100 times as long (some milliseconds).", file=sys.stderr)


def why_missing() -> str:
    """Return why there is no library; empty if there is one."""
    found = _found()
    return found if isinstance(found, str) else ""


def _loaded(name: str) -> ctypes.CDLL:
    """Load a file of the library if its bytes match the hash in its name; a truncated file could crash the process.

    Raises
    ------
    OSError
        If the hash differs, or the file cannot be loaded.
    """
    file = HERE / name
    if hashlib.sha256(file.read_bytes()).hexdigest()[:12] not in name:
        raise OSError(f"{name} is damaged")
    return ctypes.CDLL(str(file))


def _is_complete(told: Any) -> bool:
    """Return True for a description with all that the build writes."""
    kinds = {"machine": list, "sources": str, "code": str, "files": dict, "entries": dict}
    return (
        isinstance(told, dict)
        and all(isinstance(told.get(key), kind) for key, kind in kinds.items())
        and all(isinstance(word, str) for word in told["machine"])
        and bool(told["files"])
        and all(re.fullmatch(r"v\d+", level) and isinstance(name, str) for level, name in told["files"].items())
    )


def _code() -> str:
    """Return the hash of the entries' code in the present sources; empty if they cannot be imported."""
    try:
        from hophoop.kernel.entries import code_hash

        return code_hash()
    except Exception:  # a source that is being written
        return ""


@cache
def _found() -> Library | str:
    try:
        told = json.loads((HERE / MANIFEST).read_bytes())
    except FileNotFoundError:
        return f"hophoop was installed without compiled kernels. To build them: {BUILD}."
    except (OSError, ValueError, RecursionError):
        return DAMAGED
    if not _is_complete(told):
        return DAMAGED
    if told["machine"] != [sys.platform, platform.machine().lower()]:
        return f"The compiled kernels are for {' '.join(told['machine'])}. To build them for this machine: {BUILD}."
    if told["sources"] != stamp() and told["code"] != _code():
        return f"The compiled kernels are older than their sources. To rebuild them: {BUILD}."
    levels = _levels(told)
    try:
        loaded = _loaded(told["files"][levels[-1]])
        able = loaded.hophoop_level()
        if able < int(levels[-1][1:]):
            return "The compiled kernels need a newer processor."
        best = next(level for level in levels if int(level[1:]) <= able)
        if best != levels[-1]:
            loaded = _loaded(told["files"][best])
    except (OSError, ValueError, AttributeError) as error:
        return f"The compiled kernels cannot be loaded ({error}). To rebuild them: {BUILD}."
    return Library(told, best, loaded)


# --- calls from Python

MODES = ("auto", "compiled", "interpreted")


def mode() -> str:
    """Return the mode that the environment asks for: auto, compiled or interpreted.

    Raises
    ------
    ValueError
        If HOPHOOP_KERNELS has another value.
    """
    wanted = os.environ.get("HOPHOOP_KERNELS") or "auto"
    if wanted not in MODES:
        raise InputError.of_field("HOPHOOP_KERNELS", wanted, f"one of {', '.join(MODES)}")
    return wanted


class Entry:
    """A kernel that Python can call."""

    def __init__(self, name: str) -> None:
        self.name = name
        self._call: Callable[..., Any] = self._choose

    def __call__(self, *arguments: Any) -> Any:
        return self._call(*arguments)

    def __repr__(self) -> str:
        return f"<kernel {self.name}>"

    def _choose(self, *arguments: Any) -> Any:
        self._call = self._chosen()
        return self._call(*arguments)

    def _chosen(self) -> Callable[..., Any]:
        wanted = mode()
        if wanted == "interpreted":
            return self._interpret
        found = library(quiet=wanted == "compiled")
        why = why_missing()
        if found is not None:
            try:
                return found.call(self.name)
            except OSError as error:
                why = str(error)
        if wanted == "compiled":
            raise InputError(f"HOPHOOP_KERNELS = 'compiled': {why}", field="HOPHOOP_KERNELS", value=wanted)
        say_missing(why)
        return self._interpret

    def _interpret(self, *arguments: Any) -> Any:
        with np.errstate(all="ignore"):
            return self.kernel(*arguments)

    @cached_property
    def kernel(self) -> Callable[..., Any]:
        """The kernel's source, imported only if it is interpreted."""
        module, _, function = self.name.rpartition(".")
        found: Callable[..., Any] = getattr(import_module(module), function)
        return found


_entries: dict[Callable[..., Any] | str, Entry] = {}


def compiled(kernel: Callable[..., Any] | str) -> Callable[..., Any]:
    """Return a kernel of `kernel.entries` as compiled code, or interpreted if there is none.

    Parameters
    ----------
    kernel : function or str
        Or its dotted name; its module is then imported only if there is no library.

    Returns
    -------
    call : callable
        A callable with the kernel's arguments.
    """
    found = _entries.get(kernel)
    if found is None:
        name = kernel if isinstance(kernel, str) else f"{kernel.__module__}.{kernel.__qualname__}"
        found = _entries[kernel] = _entries.setdefault(name, Entry(name))
    return found


@contextlib.contextmanager
def forced(wanted: str) -> Iterator[None]:
    """Context in which all kernels run as `wanted` (a value of HOPHOOP_KERNELS); for tests and measurements."""
    before = os.environ.get("HOPHOOP_KERNELS")
    os.environ["HOPHOOP_KERNELS"] = wanted
    _choose_again()
    try:
        yield
    finally:
        if before is None:
            del os.environ["HOPHOOP_KERNELS"]
        else:
            os.environ["HOPHOOP_KERNELS"] = before
        _choose_again()


def _choose_again() -> None:
    for entry in list(_entries.values()):
        entry._call = entry._choose
