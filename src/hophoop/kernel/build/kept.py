"""Results of earlier builds, kept in files under names that contain a hash of all that determines them."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

MOST_BYTES = 500_000_000  # kept in all; then the folder is emptied


def folder() -> Path:
    """Return the folder of kept files: HOPHOOP_BUILD_CACHE, or one of the user's."""
    try:
        usual = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    except RuntimeError:  # no home directory
        usual = Path(tempfile.gettempdir())
    return Path(os.environ.get("HOPHOOP_BUILD_CACHE") or usual / "hophoop-kernels")


def kept(name: str, make: Callable[[], bytes]) -> bytes:
    """Return the content of a kept file, which is made if there is none."""
    file = folder() / name
    if not file.exists():
        write(file, make())
    return file.read_bytes()


def write(file: Path, content: bytes) -> None:
    """Write a file beside its place and rename it: nobody reads a part of it, and who has the earlier one open keeps it."""
    file.parent.mkdir(parents=True, exist_ok=True)
    part = file.with_name(f".{file.name}.{os.getpid()}")
    try:
        part.write_bytes(content)
        part.replace(file)
    finally:
        part.unlink(missing_ok=True)


def limit() -> None:
    """Empty the folder if it has become large."""
    if sum(file.stat().st_size for file in folder().glob("*")) > MOST_BYTES:
        shutil.rmtree(folder(), ignore_errors=True)
