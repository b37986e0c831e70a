"""Results of earlier builds, kept in files under names that contain a hash of all that determines them."""

from __future__ import annotations

import hashlib
import os
import shutil
from pathlib import Path

MOST_BYTES = 500_000_000  # kept in all; then the folder is emptied
DIGEST = hashlib.sha256().digest_size  # bytes before the content: its hash, which a damaged file does not have


def folder() -> Path | None:
    """Return the folder of kept files: HOPHOOP_BUILD_CACHE, or one of the user's; None if there is no home directory."""
    given = os.environ.get("HOPHOOP_BUILD_CACHE")
    if given:
        return Path(given)
    try:
        return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "hophoop-kernels"
    except RuntimeError:
        return None


def kept(name: str) -> bytes | None:
    """Return the content of a kept file; None if there is none, or a damaged one."""
    place = folder()
    try:
        found = (place / name).read_bytes() if place else b""
    except OSError:
        return None
    content = found[DIGEST:]
    return content if hashlib.sha256(content).digest() == found[:DIGEST] else None


def keep(name: str, content: bytes) -> None:
    """Keep a file; without a home directory nothing is kept."""
    place = folder()
    if place:
        write(place / name, hashlib.sha256(content).digest() + content)


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
    place = folder()
    if place and sum(file.stat().st_size for file in place.glob("*")) > MOST_BYTES:
        shutil.rmtree(place, ignore_errors=True)
