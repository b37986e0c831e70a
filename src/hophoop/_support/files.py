"""Files that are written completely or not at all."""

from __future__ import annotations

import contextlib
import errno
import os
import re
import shutil
import stat
import uuid
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from hophoop._support.extras import need
from hophoop._support.stopping import temporary, temporary_folder


@contextmanager
def ignore_foreign_zarr_files() -> Iterator[None]:
    """Silence Zarr's warnings about foreign files in a store, such as notes of the system."""
    with warnings.catch_warnings():
        # only these: filters are global and affect other threads too
        warnings.filterwarnings("ignore", "Object at .* is not recognized as a component of a Zarr hierarchy", UserWarning)
        yield


def consolidate(store: Path) -> None:
    """Copy the metadata of a Zarr store to its root, where other programs look first."""
    with ignore_foreign_zarr_files():
        warnings.filterwarnings("ignore", "Consolidated metadata is currently not part in the Zarr format 3", UserWarning)
        need("zarr", "maps").consolidate_metadata(str(store))


@contextmanager
def replacing(target: Path) -> Iterator[Path]:
    """Context with a temporary path next to the target, which replaces the target at the end if no error occurred.

    So a file, or a folder that is a Zarr store, is never incomplete, and an earlier one remains until the new one is complete.
    A link remains, and the file that it points to is replaced or created. A file keeps its mode; its other names (hard links)
    keep the old content, because writing in place could be interrupted. A device or a pipe is never replaced; it receives the
    bytes once they are complete. A disk is refused.

    path: with the target's ending, because libraries choose the format by it; its name starts with a dot.
    """
    if target.is_dir() and not any((target / name).exists() for name in ("zarr.json", ".zgroup")):
        # a user's folder; an existing Zarr store may be replaced
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(target))
    through = _descriptor(target) is not None or _is_stream(target)
    place = Path(os.path.realpath(target)) if target.is_symlink() and not through else target
    require_folder_of(place, target)
    name = f".{uuid.uuid4().hex[:12]}.{target.name}"
    try:
        with (
            temporary_folder() if through else contextlib.nullcontext(place.parent) as folder,
            temporary(folder / name) as fresh,
        ):
            yield fresh
            if through:
                _pour(fresh, target)
            elif fresh.is_dir():
                _put_folder(fresh, place)
            else:
                if place.exists():
                    fresh.chmod(stat.S_IMODE(place.stat().st_mode) & 0o777)
                os.replace(fresh, place)
    except OSError as error:
        raise _named(error, name, target) from None


@contextmanager
def netcdf_errors(file: Path) -> Iterator[None]:
    """Context in which an error of netCDF becomes the system's: netCDF calls a full disk 'Permission denied' or 'HDF error'."""
    try:
        yield
    except (OSError, RuntimeError) as error:
        with file.open("ab") as probe:  # raises what the system says
            probe.write(bytes(1 << 16))
        if isinstance(error, OSError):
            raise
        raise OSError(f"{file} cannot be written: {error}.") from None


def require_folder_of(place: Path, target: Path) -> None:
    """Refuse a file in a missing folder: only output folders are created, never the folder of a file."""
    if not place.absolute().parent.is_dir():  # otherwise netCDF would report 'Permission denied'
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(target))


def _is_stream(target: Path) -> bool:
    """Return True for a device or a pipe, which accepts bytes but cannot be replaced."""
    try:
        mode = target.stat().st_mode
    except (FileNotFoundError, NotADirectoryError):
        return False
    if stat.S_ISBLK(mode):
        raise PermissionError(errno.EPERM, os.strerror(errno.EPERM), str(target))
    return not stat.S_ISREG(mode) and not stat.S_ISDIR(mode)


def _descriptor(target: Path) -> Path | None:
    """Return the entry of an open file that a path such as /dev/stdout names; replacing that file would truncate it."""
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
    """Write all bytes of a file to a device, a pipe or an open file."""
    if fresh.is_dir():
        raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR), str(target))
    entry = _descriptor(target)
    if entry is not None and str(entry).startswith(("/dev/fd/", f"/proc/{os.getpid()}/")):
        number = os.dup(int(entry.name))  # a file opened again would be overwritten from its start
    else:
        number = os.open(target, os.O_WRONLY | os.O_APPEND | getattr(os, "O_BINARY", 0))  # without creating it
    with fresh.open("rb") as source, open(number, "wb") as sink:
        shutil.copyfileobj(source, sink)


def _named(error: OSError, name: str, target: Path) -> OSError:
    """Return the error with the path that the caller gave, in place of the temporary one."""
    if error.errno is None:
        return OSError(str(error).replace(name, target.name))
    ours = error.filename is None or name.removesuffix(target.name) in str(error.filename)
    return OSError(error.errno, error.strerror, str(target)) if ours else error


def _put_folder(fresh: Path, target: Path) -> None:
    """Replace a folder by another one and delete it."""
    if target.exists() and not target.is_dir():  # a user's file
        raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR), str(target))
    old = target.with_name(f".{uuid.uuid4().hex[:12]}.old")
    try:
        with contextlib.suppress(FileNotFoundError):
            target.rename(old)
        fresh.rename(target)
    finally:
        if old.exists() and not target.exists():  # stopped between the two renames
            old.rename(target)
        shutil.rmtree(old, ignore_errors=True)
