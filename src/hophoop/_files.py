"""Files that are written whole or not at all."""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
import sys
import uuid
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def strangers_unsaid() -> Iterator[None]:
    """Without the warnings of Zarr about what stands in a store and is not its own: a damaged name, a note of the system."""
    with warnings.catch_warnings():
        # no more than these: filters are of the whole process, also of its other threads
        warnings.filterwarnings("ignore", "Object at .* is not recognized as a component of a Zarr hierarchy", UserWarning)
        yield


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
    if not target.absolute().parent.is_dir():  # netCDF would say 'Permission denied'
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(target))
    temporary = target.with_name(f".{uuid.uuid4().hex[:12]}.{target.name}")
    try:
        yield temporary
        if temporary.is_dir():
            _put_folder(temporary, target)
        else:
            os.replace(temporary, target)
    except OSError as error:
        raise _named(error, temporary, target) from None
    finally:
        if temporary.is_dir():
            shutil.rmtree(temporary)
        else:
            temporary.unlink(missing_ok=True)


def _named(error: OSError, temporary: Path, target: Path) -> OSError:
    """The error with the path that the caller gave."""
    if error.errno is None:
        return OSError(str(error).replace(str(temporary), str(target)))
    ours = error.filename is None or temporary.name.removesuffix(target.name) in str(error.filename)
    return OSError(error.errno, error.strerror, str(target)) if ours else error


def _put_folder(fresh: Path, target: Path) -> None:
    """Put a folder in the place of another, which then goes; others may do the same at once."""
    for _ in range(1000):
        if _exchange(fresh, target):
            shutil.rmtree(fresh, ignore_errors=True)
            return
        old = target.with_name(f".{uuid.uuid4().hex[:12]}.old")
        with contextlib.suppress(FileNotFoundError):
            target.rename(old)
        try:
            fresh.rename(target)
            return
        except OSError as error:
            # another process was there first
            if error.errno not in (errno.ENOTEMPTY, errno.EEXIST):
                if old.exists():
                    old.rename(target)
                raise
        finally:
            shutil.rmtree(old, ignore_errors=True)


def _exchange(one: Path, other: Path) -> bool:
    """Let two folders change names in one step, where the system can."""
    if not sys.platform.startswith("linux"):
        return False
    import ctypes

    at_working_folder, exchange = -100, 2
    try:
        rename = ctypes.CDLL(None).renameat2
        return bool(rename(at_working_folder, os.fsencode(one), at_working_folder, os.fsencode(other), exchange) == 0)
    except (AttributeError, OSError):
        return False
