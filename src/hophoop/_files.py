"""Files that are written whole or not at all."""

from __future__ import annotations

import errno
import os
import shutil
import uuid
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def replacing(target: Path) -> Iterator[Path]:
    """A path beside the target to write to; it takes the target's place when all went well.

    So a file, or a folder that is a Zarr store, is there whole or not at all, and what was there before stays until
    the new one is whole.

    Parameters
    ----------
    target : Path

    Yields
    ------
    path : Path
        With the target's ending, since libraries choose the format by it; its name begins with a dot.

    Raises
    ------
    OSError
        If the target is a folder of another kind, or cannot be written.
    """
    if target.is_dir() and not any((target / name).exists() for name in ("zarr.json", ".zgroup")):
        # someone's folder, which only an older Zarr store is not
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(target))
    temporary = target.with_name(f".{uuid.uuid4().hex[:12]}.{target.name}")
    try:
        yield temporary
        if target.is_dir():  # a folder cannot be replaced in one step
            old = target.with_name(f".{uuid.uuid4().hex[:12]}.old")
            target.rename(old)
            temporary.rename(target)
            shutil.rmtree(old)
        else:
            os.replace(temporary, target)
    except FileNotFoundError as error:
        # name the path that the caller gave
        raise FileNotFoundError(error.errno, error.strerror, str(target)) from None
    finally:
        if temporary.is_dir():
            shutil.rmtree(temporary)
        else:
            temporary.unlink(missing_ok=True)
