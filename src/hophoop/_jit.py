"""The Numba decorators of the project: cached, IEEE arithmetic, no fastmath."""

from __future__ import annotations

import contextlib
import hashlib
import os
import sys
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import numba
from numba import types
from numba.core import config

Function = TypeVar("Function", bound=Callable[..., Any])

PACKAGE = Path(__file__).parent
SHARED = ("numerics", "physics", "rigid")  # the rooms whose kernels others are made of


@cache
def source_stamp(room: str = "") -> str:
    """Hash of the source that the kernels of a room are made of.

    Numba does not notice an edited callee in another file. A room stands on the shared ones and on its own files.
    """
    digest = hashlib.sha256(numba.__version__.encode())
    files = [PACKAGE / "_jit.py", PACKAGE / "_collocation.py"]
    for name in sorted({*SHARED, room} - {""}):
        files += sorted(PACKAGE.joinpath(name).rglob("*.py"))
    for path in files:
        digest.update(path.relative_to(PACKAGE).as_posix().encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def room_of(function: Any) -> str:
    """The room (sub-package) of a function where it is none of the shared ones, else nothing."""
    parts = function.__module__.split(".")
    return parts[1] if len(parts) > 2 and parts[0] == "hophoop" and parts[1] not in SHARED else ""


@cache
def cache_folder(room: str = "") -> Path:
    """A writable folder for compiled code, also when the package itself is installed read-only."""
    wanted = os.environ.get("NUMBA_CACHE_DIR")
    candidates = [Path(wanted)] if wanted else []
    home = os.environ.get("XDG_CACHE_HOME")
    with contextlib.suppress(RuntimeError):  # no home directory
        candidates.append((Path(home) if home else Path.home() / ".cache") / "hophoop")
    user = os.getuid() if hasattr(os, "getuid") else os.environ.get("USERNAME", "user")
    candidates.append(Path(tempfile.gettempdir()) / f"hophoop-{user}")
    for candidate in candidates:
        folder = candidate / source_stamp(room)
        try:
            folder.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=folder):
                return folder
        except OSError:
            continue
    return Path(tempfile.mkdtemp(prefix="hophoop-"))


def _compiled(function: Function, **options: Any) -> Function:
    before = config.CACHE_DIR
    # Read by Numba at decoration only, so other packages keep their own setting.
    config.CACHE_DIR = str(cache_folder(room_of(function)))
    try:
        dispatcher = numba.njit(cache=True, error_model="numpy", nogil=True, **options)(function)
    finally:
        config.CACHE_DIR = before
    general = getattr(dispatcher, "get_call_template", None)
    if general is None:  # NUMBA_DISABLE_JIT
        return dispatcher  # type: ignore[no-any-return]

    def get_call_template(arguments: Any, keywords: Any) -> Any:
        # Numba would compile a function anew for each constant that it is called with: a third of the time to compile
        return general(
            [types.unliteral(kind) for kind in arguments],
            {name: types.unliteral(kind) for name, kind in keywords.items()},
        )

    dispatcher.get_call_template = get_call_template
    return dispatcher  # type: ignore[no-any-return]


def jit(function: Function) -> Function:
    """Compile in nopython mode, keep the result on disk, release the interpreter lock."""
    return _compiled(function)


def lean_jit(function: Function) -> Function:
    """`jit` for functions that make no arrays: without reference counts, which cost a fifth of a motion's time."""
    return _compiled(function, _nrt=False)


def inline_jit(function: Function) -> Function:
    """`lean_jit` for what is called at each panel: always part of its caller.

    Handing body, panel and scratch on is some sixty words a call, which costs a quarter of a motion's time.
    """
    return _compiled(function, _nrt=False, forceinline=True)


def parallel_jit(function: Function) -> Function:
    """`jit` with `numba.prange` loops spread over the cores."""
    return _compiled(function, parallel=True)


def announce_compilation(function: Any) -> None:
    """Say on standard error, once a process, that `function` is about to be compiled."""
    if not hasattr(function, "signatures") or function.signatures or function in _announced:
        return
    _announced.add(function)
    name = function.py_func.__name__
    if any(cache_folder(room_of(function.py_func)).rglob(f"*.{name}-*.nbi")):
        return
    print("hophoop compiles its kernel; this takes about half a minute and happens once.", file=sys.stderr)


_announced: set[Any] = set()
