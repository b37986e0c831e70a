"""Files of motions, read back; what writes them is `export`, whose functions are offered here as well."""

from __future__ import annotations

import errno
import json
import os
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from hophoop._support.checksum import CHECKSUM, checksum, is_broken
from hophoop._support.extras import need
from hophoop._support.files import ignore_foreign_zarr_files
from hophoop._version import __version__
from hophoop.kernel.model import Status
from hophoop.results.save import (
    FINGERPRINT,
    SCHEMA,
    TABLES,
    format_of,
    save,
    to_xarray,
    write_csv,
    write_events_csv,
    write_json,
)
from hophoop.scenario import InputError, Scenario
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory

__all__ = ["load", "save", "to_xarray", "write_csv", "write_events_csv", "write_json"]


def load(path: str | Path, *, check_fingerprint: bool = False) -> Trajectory:
    """Read a motion that `save` wrote.

    Parameters
    ----------
    path : str or Path
        Ends in .nc, .zarr or .zarr.zip.
    check_fingerprint : bool, default False
        Also compute the motion again and compare fingerprints: whether this machine gets the same bits.

    Returns
    -------
    motion : Trajectory
        It samples like the one that was saved, to the last bit. Where another version of hophoop wrote the
        file, a warning says so.

    Raises
    ------
    ValueError
        If the file is not a saved motion, is damaged, or one that this version cannot read; with `check_fingerprint`
        also if this machine gets other bits.
    OSError
        If the file cannot be read.
    ImportError
        If xarray or the library that reads the format is missing.
    """
    file = Path(path)
    kind = format_of(file)
    if not file.exists():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(file))
    motion = _load(file, kind)
    if check_fingerprint:
        _check_reproduced(motion, file)
    return motion


# --- inside ----------------------------------------------------------------------------------------

DAMAGED = "{} is damaged: its checksum is not that of its content."


def _load(file: Path, kind: str) -> Trajectory:
    groups = _read(file, kind)
    attributes = groups["/"].attrs
    if {group.attrs.get(CHECKSUM) for group in groups.values()} != {checksum(groups)}:
        raise InputError(DAMAGED.format(file))
    version = str(attributes.get("version"))
    try:
        motion = Trajectory(
            Scenario.from_dict(json.loads(attributes["scenario"])),
            int(Status[attributes["status"].upper()]),
            _unpacked(groups["events"]),
            _unpacked(groups["segments"]),
            str(attributes["version"]),
            until=attributes.get("until"),
        )
    except (KeyError, ValueError, TypeError, AttributeError, RecursionError) as error:
        if version != __version__ and isinstance(error, InputError):
            raise InputError(f"{file} was written by hophoop {version}: {error}") from None
        raise InputError(f"{file} is damaged: {_first_line(error)}.") from None
    said = attributes.get(FINGERPRINT)
    if said != motion.fingerprint:
        raise InputError(f"{file} is damaged: its fingerprint {said!r} is not that of its events, {motion.fingerprint!r}.")
    if version != __version__:
        said = f"{file} was written by hophoop {version}; samples may differ from its own in the last digits."
        warnings.warn(said, UserWarning, stacklevel=3)
    return motion


def _check_reproduced(motion: Trajectory, file: Path) -> None:
    """Refuse a motion that this machine does not compute to the same bits."""
    now = simulate(motion.scenario, until=motion.until).fingerprint
    if now != motion.fingerprint:
        raise InputError(
            f"{file} was written by hophoop {motion.version} with the fingerprint {motion.fingerprint}; "
            f"hophoop {__version__} on this machine gets {now}."
        )


def _first_line(error: BaseException) -> str:
    """What an error says, fit for the end of a sentence."""
    lines = str(error).strip().splitlines()
    return lines[0].rstrip(".: ") if lines else type(error).__name__


def _unpacked(dataset: Any) -> np.ndarray:
    """The structured array that `_packed` took apart."""
    layout = [(name, kind) for name, kind, _ in json.loads(dataset.attrs["layout"])]  # each is one number
    first = dataset[layout[0][0]]
    table = np.empty(first.shape[0], dtype=np.dtype(layout))
    for name, _ in layout:
        table[name] = dataset[name].values
    return table


def _read(file: Path, kind: str) -> dict[str, Any]:
    """The groups of a file as it has them, not decoded."""
    xr = need("xarray", "maps")
    if kind == "netcdf":
        need("netCDF4", "maps")
    else:
        need("zarr", "maps")
    words = "netCDF" if kind == "netcdf" else "Zarr"
    if kind == "netcdf" and is_broken(file):
        raise InputError(DAMAGED.format(file))
    groups: dict[str, Any] = {}
    store: Any = str(file)
    if kind == "zip":
        try:
            store = need("zarr", "maps").storage.ZipStore(file, mode="r")
            store._sync_open()
        except Exception as error:
            raise InputError(f"{file} cannot be read as {words}: {_first_line(error)}.") from None
    options: dict[str, Any] = {"decode_cf": False}
    options |= {"engine": "netcdf4"} if kind == "netcdf" else {"engine": "zarr", "consolidated": False}
    try:
        for name in ("/", *TABLES):
            try:
                with ignore_foreign_zarr_files(), xr.open_dataset(store, group=name, **options) as dataset:
                    if name == "/":  # what another schema has further on is not known here
                        _check_schema(file, dataset.attrs)
                    groups[name] = dataset.load()
            except InputError:
                raise
            except Exception as error:  # whatever a library makes of bytes that are not its format
                raise InputError(f"{file} cannot be read as {words}: {_first_line(error)}.") from None
    finally:
        if kind == "zip":
            store.close()
    return groups


def _check_schema(file: Path, attributes: Mapping[str, Any]) -> None:
    schema = attributes.get("schema")
    if not isinstance(schema, str) or not schema.startswith("hophoop/"):
        raise InputError(f"{file} is not a saved motion of hophoop.")
    if schema != SCHEMA:
        raise InputError(f"{file} has the schema {schema!r}, but this version of hophoop reads {SCHEMA!r} only.")
    if CHECKSUM not in attributes:
        raise InputError(f"{file} is not whole: it has the samples of a motion, but not the tables that `save` writes.")
