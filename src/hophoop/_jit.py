"""The one Numba decorator of the project: cached, IEEE arithmetic, no fastmath."""

from __future__ import annotations

import hashlib
import os
import sys
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import numba
from numba.core import config

Function = TypeVar("Function", bound=Callable[..., Any])

PACKAGE = Path(__file__).parent
COMPILED = ("physics", "rigid", "compliant", "maps", "theory")  # the rooms that hold kernels


@cache
def source_stamp() -> str:
    """Hash of the source that kernels are made of: Numba does not notice an edited callee in another file."""
    digest = hashlib.sha256(numba.__version__.encode())
    rooms = [PACKAGE.glob("*.py"), *(PACKAGE.joinpath(room).rglob("*.py") for room in COMPILED)]
    for path in sorted(file for room in rooms for file in room):
        digest.update(path.relative_to(PACKAGE).as_posix().encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


@cache
def cache_folder() -> Path:
    """A writable folder for compiled code, also when the package itself is installed read-only."""
    wanted = os.environ.get("NUMBA_CACHE_DIR")
    candidates = [Path(wanted)] if wanted else []
    home = os.environ.get("XDG_CACHE_HOME")
    try:
        candidates.append((Path(home) if home else Path.home() / ".cache") / "hophoop")
    except RuntimeError:  # no home directory
        pass
    user = os.getuid() if hasattr(os, "getuid") else os.environ.get("USERNAME", "user")
    candidates.append(Path(tempfile.gettempdir()) / f"hophoop-{user}")
    for candidate in candidates:
        folder = candidate / source_stamp()
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
    config.CACHE_DIR = str(cache_folder())
    try:
        return numba.njit(  # type: ignore[no-any-return]
            cache=True, error_model="numpy", nogil=True, **options
        )(function)
    finally:
        config.CACHE_DIR = before


def jit(function: Function) -> Function:
    """Compile in nopython mode, keep the result on disk, release the interpreter lock."""
    return _compiled(function)


def lean_jit(function: Function) -> Function:
    """`jit` for functions that make no arrays: without reference counts, which cost a fifth of a motion's time."""
    return _compiled(function, _nrt=False)


def parallel_jit(function: Function) -> Function:
    """`jit` with `numba.prange` loops spread over the cores."""
    return _compiled(function, parallel=True)


def announce_compilation(function: Any) -> None:
    """Say on standard error, once a process, that `function` is about to be compiled."""
    if not hasattr(function, "signatures") or function.signatures or function in _announced:
        return
    _announced.add(function)
    name = function.py_func.__name__
    if any(cache_folder().rglob(f"*.{name}-*.nbi")):
        return
    print("hophoop compiles its kernel; this takes some 20 seconds and happens once.", file=sys.stderr)


_announced: set[Any] = set()
