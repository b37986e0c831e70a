"""Files of motions, read back; what writes them is `export`, whose functions are offered here as well."""

from __future__ import annotations

import errno
import json
import os
import warnings
from pathlib import Path
from typing import Any

import numpy as np

import hophoop
from hophoop._extras import need
from hophoop.export import SCHEMA, TABLES, format_of, save, to_xarray, write_csv, write_events_csv, write_json
from hophoop.physics.body import Status
from hophoop.scenario import InputError, Scenario
from hophoop.trajectory import Trajectory

__all__ = ["load", "save", "to_xarray", "write_csv", "write_events_csv", "write_json"]


def load(path: str | Path) -> Trajectory:
    """Read a motion that `save` wrote.

    Parameters
    ----------
    path : str or Path
        Ends in .nc, .zarr or .zarr.zip.

    Returns
    -------
    motion : Trajectory
        It samples like the one that was saved, to the last bit. Where another version of hophoop wrote the
        file, a warning says so.

    Raises
    ------
    ValueError
        If the file is not a saved motion, or one that this version cannot read.
    OSError
        If the file cannot be read.
    ImportError
        If xarray or the library that reads the format is missing.
    """
    file = Path(path)
    kind = format_of(file)
    if not file.exists():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), str(file))
    attributes, tables = _read(file, kind)
    schema = attributes.get("schema")
    if not isinstance(schema, str) or not schema.startswith("hophoop/"):
        raise InputError(f"{file} is not a saved motion of hophoop.")
    if schema != SCHEMA:
        raise InputError(f"{file} has the schema {schema!r}, but this version of hophoop reads {SCHEMA!r} only.")
    if any(name not in tables for name in TABLES):
        raise InputError(f"{file} is not whole: a table of the motion is missing.")
    version = str(attributes["version"])
    motion = Trajectory(
        Scenario.from_dict(json.loads(attributes["scenario"])),
        int(Status[attributes["status"].upper()]),
        tables["events"],
        tables["segments"],
        version,
    )
    if version != hophoop.__version__:
        _check_other_version(motion, file, tables["/"])
    return motion


# --- inside ----------------------------------------------------------------------------------------


def _unpacked(dataset: Any) -> np.ndarray:
    """The structured array that `_packed` took apart."""
    layout = [(name, kind, tuple(shape)) for name, kind, shape in json.loads(dataset.attrs["layout"])]
    first = dataset[layout[0][0]]
    table = np.empty(first.shape[0], dtype=np.dtype(layout))
    for name, *_ in layout:
        table[name] = dataset[name].values
    return table


def _read(file: Path, kind: str) -> tuple[dict[str, Any], dict[str, Any]]:
    """The attributes of a file and its tables; a table that is not there is left out."""
    xr = need("xarray", "maps")
    if kind == "netcdf":
        need("netCDF4", "maps")
    else:
        need("zarr", "maps")
    tables: dict[str, Any] = {}
    attributes: dict[str, Any] = {}
    store: Any = str(file)
    if kind == "zip":
        try:
            store = need("zarr", "maps").storage.ZipStore(file, mode="r")
            store._sync_open()
        except Exception as error:
            raise InputError(f"{file} cannot be read as Zarr: {error}.") from None
    options: dict[str, Any] = {"decode_cf": False}
    options |= {"engine": "netcdf4"} if kind == "netcdf" else {"engine": "zarr", "consolidated": False}
    try:
        for name in ("/", *TABLES):
            try:
                dataset = xr.open_dataset(store, group=name, **options)
            except Exception as error:
                if name == "/":
                    words = "netCDF" if kind == "netcdf" else "Zarr"
                    raise InputError(f"{file} cannot be read as {words}: {error}.") from None
                continue
            with dataset:
                if name == "/":
                    attributes = dict(dataset.attrs)
                    tables[name] = dataset.load()
                elif "layout" in dataset.attrs:
                    tables[name] = _unpacked(dataset)
    finally:
        if kind == "zip":
            store.close()
    return attributes, tables


def _check_other_version(motion: Trajectory, file: Path, samples: Any) -> None:
    """Refuse a file whose segments mean something else to this version than to the one that wrote it."""
    said = f"{file} was written by hophoop {motion.version}"
    times = samples["time"].values
    try:
        now = motion.at(times)
        alike = all(
            np.allclose(getattr(now, name), samples[name].values, rtol=1e-9, atol=1e-9, equal_nan=True)
            for name in ("x", "height", "angle", "omega")
        )
    except (KeyError, ValueError, IndexError, TypeError, AttributeError):
        alike = False
    if not alike:
        raise InputError(f"{said}, whose segments this version {hophoop.__version__} cannot sample.")
    warnings.warn(f"{said}; samples may differ from its own in the last digits.", UserWarning, stacklevel=3)
