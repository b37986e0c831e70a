"""Where compiled kernels are kept, under names that say what they are made of. Numba is not imported here."""

from __future__ import annotations

import contextlib
import hashlib
import os
import stat
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from importlib.metadata import version
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

import numpy as np

from hophoop._jit.kernels import Source

HERE = Path(__file__).parent  # what decides how a kernel is compiled, beside its own code


@cache
def root_folder() -> Path:
    """A writable folder for compiled code, also when the package itself is installed read-only.

    What is in it is run. The folder of NUMBA_CACHE_DIR is trusted; any other one in a place that all users share is used
    only where nobody else can have put anything into it.
    """
    wanted = os.environ.get("NUMBA_CACHE_DIR")
    if wanted and _is_writable(Path(wanted), 0o777):
        return Path(wanted)
    home = os.environ.get("XDG_CACHE_HOME")
    candidates = []
    with contextlib.suppress(RuntimeError):  # no home directory
        candidates.append((Path(home) if home else Path.home() / ".cache") / "hophoop")
    user = os.getuid() if hasattr(os, "getuid") else os.environ.get("USERNAME", "user")
    temporary = Path(tempfile.gettempdir()) / f"hophoop-{user}"
    for candidate in (*candidates, temporary):
        if _is_writable(candidate, 0o700) and (is_private(candidate) or (candidate != temporary and not is_shared(candidate))):
            return candidate
    return Path(tempfile.mkdtemp(prefix="hophoop-"))


def _is_writable(folder: Path, mode: int) -> bool:
    """Whether files can be made in a folder, which is itself made where it is not there."""
    try:
        folder.mkdir(mode, parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return True
    except OSError:
        return False


def is_private(folder: Path) -> bool:
    """Whether only this user can have put files into a folder, or the folder itself into its place."""
    if not hasattr(os, "getuid"):  # Windows: the temporary folder is of the user
        return True
    try:
        there = folder.lstat()
        if not stat.S_ISDIR(there.st_mode) or there.st_uid != os.getuid() or there.st_mode & 0o022:
            return False
        for above in folder.resolve().parents:
            there = above.stat()
            if there.st_uid not in (0, os.getuid()):
                return False
            if there.st_mode & 0o002:
                # in a shared folder with the sticky bit only its owner takes away what is another's
                return bool(there.st_mode & stat.S_ISVTX)
            if there.st_mode & 0o020:
                return False
    except OSError:
        return False
    return True


def is_shared(folder: Path) -> bool:
    """Whether a folder is in a place that all users can write to, such as that for temporary files."""
    if not hasattr(os, "getuid"):
        return False
    try:
        # the name may be a link out of a shared place, or into one
        around = {*folder.absolute().parents, folder.resolve(), *folder.resolve().parents}
        return any(above.stat().st_mode & 0o002 for above in around)
    except OSError:
        return True


def folder_of(kernel: Source) -> Path:
    """The folder for the compiled code of a kernel, named by what it is made of."""
    return root_folder() / stamp(kernel)


@cache
def stamp(kernel: Source) -> str:
    """Hash of all that the compiled code of a kernel is made of.

    Numba does not notice an edited function or constant in another file. This follows a kernel to the kernels that it
    calls, and takes their code and the values of the constants in them.
    """
    digest = hashlib.sha256(f"{version('numba')} {version('numpy')} {sys.version}".encode())
    for name in ("kernels.py", "dispatchers.py"):
        digest.update((HERE / name).read_bytes())
    for part in reachable(kernel):
        digest.update(f"{part!r} {part.options}".encode())
        _add_code(digest, part.py_func.__code__)
        _add_value(digest, part.py_func.__defaults__)
        for name, value in _names_of(part):
            digest.update(f" {name}=".encode())
            _add_value(digest, value)
    return digest.hexdigest()[:16]


def reachable(kernel: Source) -> list[Source]:
    """The kernel and all that it calls, itself or through others, each once."""
    found = {kernel: None}
    waiting = [kernel]
    while waiting:
        for _, value in _names_of(waiting.pop()):
            if isinstance(value, Source) and value not in found:
                found[value] = None
                waiting.append(value)
    return list(found)


def _names_of(kernel: Source) -> Iterator[tuple[str, Any]]:
    function = kernel.py_func
    for name in sorted(set(_code_names(function.__code__))):
        if name in function.__globals__:
            yield name, function.__globals__[name]
    for name, cell in zip(function.__code__.co_freevars, function.__closure__ or (), strict=True):
        yield name, cell.cell_contents


def _code_names(code: CodeType) -> Iterator[str]:
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _code_names(constant)


def _add_code(digest: Any, code: CodeType) -> None:
    digest.update(code.co_code)
    digest.update(repr((code.co_names, code.co_varnames, code.co_freevars)).encode())
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            _add_code(digest, constant)
        else:
            _add_value(digest, constant)


def _add_value(digest: Any, value: Any) -> None:
    if isinstance(value, Source):
        digest.update(repr(value).encode())
    elif isinstance(value, np.ndarray):
        digest.update(repr((value.dtype, value.shape)).encode())
        digest.update(value.tobytes())
    elif isinstance(value, tuple):
        digest.update(f"{type(value).__name__} {len(value)}".encode())
        for item in value:
            _add_value(digest, item)
    elif isinstance(value, ModuleType):
        digest.update(value.__name__.encode())
    elif isinstance(value, type) or callable(value):
        digest.update(f"{getattr(value, '__qualname__', type(value))} {getattr(value, '_fields', '')}".encode())
        digest.update(repr(getattr(value, "__annotations__", "")).encode())
    else:  # numbers, strings, dtypes
        digest.update(f"{type(value).__name__} {value!r}".encode())


@cache
def _mark(kernel: Source, kinds: Any) -> Path:
    # another processor gets code of its own
    made = hashlib.sha256(f"{kinds!r} {_processor()}".encode()).hexdigest()[:16]
    return folder_of(kernel) / f"{kernel.py_func.__name__}-{made}.ready"


@cache
def _processor() -> str:
    with contextlib.suppress(OSError), open("/proc/cpuinfo", encoding="utf-8") as file:
        lines = {line for line in file if line.startswith(("model name", "flags", "Features", "CPU part"))}
        return "".join(sorted(lines))
    import platform

    return f"{platform.machine()} {platform.processor()}"


def is_ready(kernel: Source, kinds: Any) -> bool:
    """Whether compiled code is on disk."""
    return _mark(kernel, kinds).exists()


def note_ready(kernel: Source, kinds: Any) -> None:
    """Say that compiled code is on disk."""
    with contextlib.suppress(OSError):  # the folder may have been cleared away
        _mark(kernel, kinds).touch()
