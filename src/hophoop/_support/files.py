"""Files that are written whole or not at all."""

from __future__ import annotations

import contextlib
import errno
import os
import re
import shutil
import stat
import sys
import uuid
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from hophoop._support.stopping import temporary, temporary_folder


@contextmanager
def ignore_foreign_zarr_files() -> Iterator[None]:
    """Silence Zarr's warnings about foreign files in a store."""
    with warnings.catch_warnings():
        # no more than these: filters are of the whole process, also of its other threads
        warnings.filterwarnings("ignore", "Object at .* is not recognized as a component of a Zarr hierarchy", UserWarning)
        yield


@contextmanager
def replacing(target: Path) -> Iterator[Path]:
    """A path beside the target to write to; it takes the target's place when all went well.

    So a file, or a folder that is a Zarr store, is there whole or not at all, and what was there before stays until
    the new one is whole. A link stays, and the file that it names is replaced, or made. A file keeps its mode, and its
    owner where that is allowed. Its other names (hard links) keep the old content: writing in place could stop half way.
    A device or a pipe is never replaced; it gets the bytes once they are complete. Disks and sockets are refused.

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
        If the target is a folder of another kind, a disk or a socket, or cannot be written.
    """
    if target.is_dir() and not any((target / name).exists() for name in ("zarr.json", ".zgroup")):
        # someone's folder, which only an older Zarr store is not
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(target))
    there = _status(target)
    through = there is not None and (_descriptor(target) is not None or _is_stream(there, target))
    place = Path(os.path.realpath(target)) if target.is_symlink() and not through else target
    require_folder_of(place, target)
    with (
        temporary_folder() if through else contextlib.nullcontext(place.parent) as folder,
        temporary(folder / f".{uuid.uuid4().hex[:12]}.{target.name}") as fresh,
    ):
        try:
            yield fresh
            if through:
                _pour(fresh, target)
            elif fresh.is_dir():
                _put_folder(fresh, place)
            else:
                if there is not None:
                    _keep(there, fresh)
                os.replace(fresh, place)
        except OSError as error:
            raise _named(error, fresh, target) from None


def require_folder_of(place: Path, target: Path) -> None:
    """Refuse a file in a folder that is missing: only folders for output are made, never the folder of a file."""
    if not place.absolute().parent.is_dir():  # netCDF would say 'Permission denied'
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(target))


def _status(target: Path) -> os.stat_result | None:
    """The status of what is there, behind all links."""
    try:
        return target.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None


def _is_stream(there: os.stat_result, target: Path) -> bool:
    """Whether it is a device or a pipe, which takes bytes but is no file to replace."""
    if stat.S_ISBLK(there.st_mode) or stat.S_ISSOCK(there.st_mode):
        raise PermissionError(errno.EPERM, os.strerror(errno.EPERM), str(target))
    return not stat.S_ISREG(there.st_mode) and not stat.S_ISDIR(there.st_mode)


def _descriptor(target: Path) -> Path | None:
    """The entry of an open file that a path such as /dev/stdout names, since replacing that file would cut it off."""
    path = target.absolute()
    for _ in range(40):  # as many links as Linux follows
        path = Path(os.path.realpath(path.parent)) / path.name
        if path.name.isdigit() and re.fullmatch(r"/dev/fd|/proc/\d+(/task/\d+)?/fd", str(path.parent)):
            return path
        if not path.is_symlink():
            return None
        path = path.parent / os.readlink(path)
    return None


def _pour(fresh: Path, target: Path) -> None:
    """Write all bytes of a file into a device, a pipe or an open file."""
    if fresh.is_dir():
        raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR), str(target))
    entry = _descriptor(target)
    if entry is not None and str(entry).startswith(("/dev/fd/", f"/proc/{os.getpid()}/")):
        number = os.dup(int(entry.name))  # opened anew, a file would be written over from its start
    else:
        number = os.open(target, os.O_WRONLY | os.O_APPEND | getattr(os, "O_BINARY", 0))  # never made anew
    with fresh.open("rb") as source, open(number, "wb") as sink:
        shutil.copyfileobj(source, sink)


def _keep(there: os.stat_result, fresh: Path) -> None:
    """Give a file the owner and the mode of the one that it replaces."""
    mode = stat.S_IMODE(there.st_mode) & 0o777
    try:
        if hasattr(os, "chown"):
            os.chown(fresh, there.st_uid, there.st_gid)
    except OSError:
        with contextlib.suppress(OSError):
            os.chown(fresh, -1, there.st_gid)
        if fresh.stat().st_gid != there.st_gid:
            # another group gets no more than all others had
            mode = mode & ~0o070 | (mode & 0o070) & (mode & 0o007) << 3
    with contextlib.suppress(OSError):  # a file system without modes
        fresh.chmod(mode)


def _named(error: OSError, fresh: Path, target: Path) -> OSError:
    """The error with the path that the caller gave."""
    if error.errno is None:
        return OSError(str(error).replace(str(fresh), str(target)))
    ours = error.filename is None or fresh.name.removesuffix(target.name) in str(error.filename)
    return OSError(error.errno, error.strerror, str(target)) if ours else error


def _put_folder(fresh: Path, target: Path) -> None:
    """Put a folder in the place of another, which then goes; others may do the same at once."""
    for _ in range(1000):
        if _exchange(fresh, target):
            shutil.rmtree(fresh, ignore_errors=True)
            return
        old = target.with_name(f".{uuid.uuid4().hex[:12]}.old")
        try:
            with contextlib.suppress(FileNotFoundError):
                target.rename(old)
            fresh.rename(target)
            return
        except OSError as error:
            # another process was there first
            if error.errno not in (errno.ENOTEMPTY, errno.EEXIST):
                raise
        finally:
            if old.exists() and not target.exists():  # it was stopped between the two
                old.rename(target)
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
