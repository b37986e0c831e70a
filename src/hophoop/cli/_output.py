"""Files that a command writes: whole or not at all."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from hophoop.scenario import InputError


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """A path beside `path`, with its ending, to write to; at the end it takes the other's place.

    Raises
    ------
    ValueError
        If `path` is a folder that is no Zarr store, or its own folder is missing.
    """
    path = Path(path)
    if not path.parent.is_dir():
        raise InputError(f"{path.parent} is not a folder: {path} cannot be written.")
    if path.is_dir() and not any((path / name).exists() for name in ("zarr.json", ".zgroup")):
        raise InputError(f"{path} is a folder.")
    room = Path(tempfile.mkdtemp(prefix=f".{path.name}-", dir=path.parent))
    try:
        fresh = room / path.name
        yield fresh
        if fresh.is_dir() and path.exists():  # folders cannot be replaced in one step
            os.replace(path, room / "old")
        os.replace(fresh, path)
    finally:
        shutil.rmtree(room, ignore_errors=True)


def write_text(path: Path, text: str) -> None:
    """Write a text file, whole or not at all."""
    with replacing(path) as fresh:
        fresh.write_text(text, encoding="utf-8")


def check_ending(option: str, path: Path, endings: tuple[str, ...]) -> None:
    """Refuse a name that does not tell a known format, before anything is computed."""
    if path.suffix.lower() not in endings:
        raise InputError(f"{option} = {path} must end in {', '.join(endings[:-1])} or {endings[-1]}.")
