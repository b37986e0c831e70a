"""Writing of motions to files: netCDF and Zarr, which load to the same bits, and CSV and JSON for other programs.

A saved motion holds three tables. The group ``/`` is the motion sampled over time, for any reader of netCDF or Zarr. The groups
``/events`` and ``/segments`` hold the kernel's tables in its own units, from which a loaded motion gives the same samples to
the last bit. Each group has the checksum of all three.
"""

from __future__ import annotations

import csv
import json
import platform
import shutil
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support.checksum import CHECKSUM, checksum, seal
from hophoop._support.extras import need
from hophoop._support.files import consolidate, netcdf_errors, replacing
from hophoop.kernel.model import EVENT_NAMES, MODE_LETTERS
from hophoop.kernel.native.sources import stamp
from hophoop.results.records import ArraySample, Motion
from hophoop.scenario import InputError
from hophoop.vocabulary.names import MODE_WORDS
from hophoop.vocabulary.quantities import COLUMNS, EVENT_NUMBERS, EVENT_UNITS, held_by

if TYPE_CHECKING:
    import xarray

SCHEMA = "hophoop/1"
FINGERPRINT = "fingerprint"  # name of the attribute
TABLES = ("events", "segments")
_ENDINGS = "must end in .nc (netCDF), .zarr or .zarr.zip (Zarr)"


def to_xarray(motion: Motion, times: ArrayLike | None = None) -> xarray.Dataset:
    """Return a motion as an xarray.Dataset over time.

    Parameters
    ----------
    motion : Trajectory
    times : array_like, optional
        Times within the motion; 1000 equally spaced ones by default [s].

    Returns
    -------
    dataset : xarray.Dataset
        Every variable has units and long_name; the mode is a code with CF's flag_meanings. The attributes
        hold the scenario as JSON, the status, the sequence, the fingerprint, the version and the schema.

    Raises
    ------
    ValueError
        If a time is outside the motion.
    ImportError
        If xarray is missing.

    Examples
    --------
    >>> import hophoop as hh
    >>> motion = hh.simulate(hh.Hoop(), hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
    >>> dataset = to_xarray(motion, times=[0.0, 1.2, 2.0])
    >>> dataset.angle.attrs["units"], dataset.height.values.round(6)
    ('rad', array([0.      , 0.020767, 0.      ]))
    """
    xr = need("xarray", "maps")
    grid = _grid(motion, times)
    sample = motion.at(grid)
    variables = {
        name: ("time", _column(sample, name), {"units": quantity.unit, "long_name": quantity.meaning})
        for name, quantity in COLUMNS.items()
    }
    variables["mode"][2].update(_flags(MODE_WORDS, np.int8), flag_letters=" ".join(MODE_LETTERS))
    time = ("time", grid, {"units": "s", "long_name": "Time"})
    dataset: xarray.Dataset = xr.Dataset(variables, coords={"time": time}, attrs=_attributes(motion))
    return dataset


def save(motion: Motion, path: str | Path, n: int = 1000) -> None:
    """Write a motion to a file that `load` reads back, with the same samples to the last bit.

    Parameters
    ----------
    motion : Trajectory
    path : str or Path
        Ends in .nc (netCDF), .zarr (a folder) or .zarr.zip. An existing file is replaced only when the new one is complete.
    n : int, default 1000
        Number of equally spaced times in the table for other readers, at least 2.

    Raises
    ------
    ValueError
        If the path has another ending or n is below 2.
    OSError
        If the file cannot be written.
    ImportError
        If xarray or the library that writes the format is missing.
    """
    target = Path(path)
    kind = format_of(target)
    xr = need("xarray", "maps")
    groups: dict[str, Any] = {"/": to_xarray(motion, motion.times(n))}
    for name in TABLES:
        groups[name] = _packed(xr, motion.tables[name], name.removesuffix("s"))
    _describe_events(groups["events"], motion)
    content = checksum(groups)
    for group in groups.values():
        group.attrs[CHECKSUM] = content
    with replacing(target) as temporary:
        if kind == "netcdf":
            _write_netcdf(groups, temporary)
        else:
            need("zarr", "maps")
            folder = temporary.with_suffix("") if kind == "zip" else temporary
            try:
                for name, group in groups.items():
                    mode = "w" if name == "/" else "a"
                    group.to_zarr(str(folder), group=name, mode=mode, consolidated=False)
                consolidate(folder)
                if kind == "zip":
                    _zip(folder, temporary)
            finally:
                if kind == "zip":
                    shutil.rmtree(folder, ignore_errors=True)


def write_csv(motion: Motion, path: str | Path, times: ArrayLike | None = None) -> None:
    """Write the motion over time as CSV, one row per time.

    Parameters
    ----------
    motion : Trajectory
    path : str or Path
    times : array_like, optional
        Times within the motion; 1000 equally spaced ones by default [s].

    Raises
    ------
    ValueError
        If a time is outside the motion.
    OSError
        If the file cannot be written.
    """
    grid = _grid(motion, times)
    sample = motion.at(grid)
    header = ["t [s]"] + [name if one.unit == "1" else f"{name} [{one.unit}]" for name, one in COLUMNS.items()]
    columns = [grid] + [getattr(sample, name) for name in COLUMNS]
    _write_rows(Path(path), header, zip(*(column.tolist() for column in columns), strict=True))


def write_events_csv(motion: Motion, path: str | Path) -> None:
    """Write the events as CSV, one row per event.

    Parameters
    ----------
    motion : Trajectory
    path : str or Path

    Raises
    ------
    OSError
        If the file cannot be written.
    """
    names = [name for name in EVENT_NUMBERS if name != "t"]
    before = held_by("Velocity")
    header = ["t [s]", "kind", "from", "to", *(f"{name} [{EVENT_UNITS[name]}]" for name in names)]
    header += [f"before_{name} [{EVENT_UNITS[name]}]" for name in before] + ["collision", "stable"]
    rows = (
        [event.t, event.kind, event.from_mode, event.to_mode]
        + [getattr(event, name) for name in names]
        + [getattr(event.before, name) for name in before]
        + [event.collision, event.stable]
        for event in motion.events
    )
    _write_rows(Path(path), header, rows)


def write_json(motion: Motion, path: str | Path, more: Mapping[str, Any] | None = None) -> None:
    """Write scenario, events, final state and energy as JSON, in full double precision.

    Parameters
    ----------
    motion : Trajectory
    path : str or Path
    more : mapping of str to Any, optional
        Further keys of the result, such as ``{"sensitivity": motion.sensitivity(…).to_dict()}``.

    Raises
    ------
    OSError
        If the file cannot be written.
    """
    text = json.dumps(motion.to_dict() | dict(more or {}), indent=2, ensure_ascii=False, allow_nan=False)
    with replacing(Path(path)) as temporary:
        temporary.write_text(text + "\n", encoding="utf-8")


# --- internal ---------------------------------------------------------------------------------------


def _write_netcdf(groups: dict[str, Any], file: Path) -> None:
    need("netCDF4", "maps")
    with netcdf_errors(file):
        for name, group in groups.items():
            exact = {key: {"_FillValue": None} for key in group.variables}
            group.to_netcdf(file, mode="w" if name == "/" else "a", group=name, engine="netcdf4", encoding=exact)
    seal(file)


def _zip(folder: Path, target: Path) -> None:
    # Zarr's own store would write some members twice
    with zipfile.ZipFile(target, "w") as archive:
        for file in sorted(folder.rglob("*")):
            if file.is_file():
                archive.write(file, file.relative_to(folder).as_posix())


def _grid(motion: Motion, times: ArrayLike | None) -> NDArray[np.float64]:
    return motion.times() if times is None else np.atleast_1d(np.asarray(times, dtype=float))


def format_of(path: Path) -> str:
    """Return the format of a saved motion, from the ending of its name.

    Parameters
    ----------
    path : Path

    Returns
    -------
    format : {'netcdf', 'zarr', 'zip'}

    Raises
    ------
    ValueError
        If the name has another ending.
    """
    name = path.name.lower()
    for ending, kind in ((".nc", "netcdf"), (".zarr", "zarr"), (".zarr.zip", "zip")):
        if name.endswith(ending):
            return kind
    raise InputError(f"{path} {_ENDINGS}.")


def _column(sample: ArraySample, name: str) -> np.ndarray:
    values = np.asarray(getattr(sample, name))
    if name == "mode":
        return np.array([MODE_LETTERS.index(letter) for letter in values], dtype=np.int8)
    return values


def _flags(names: tuple[str, ...], kind: Any) -> dict[str, Any]:
    return {"flag_values": np.arange(len(names), dtype=kind), "flag_meanings": " ".join(names)}


def _attributes(motion: Motion) -> dict[str, str]:
    return {
        "Conventions": "CF-1.11",
        "title": f"Motion of a loaded hoop: {motion.sequence}",
        "schema": SCHEMA,
        "version": motion.version,
        "source": f"hophoop {motion.version}",
        "provenance": json.dumps(
            {
                "python": platform.python_version(),
                "numpy": np.__version__,
                "kernels": stamp(),
                "machine": f"{platform.system()} {platform.machine()}",
            }
        ),
        "scenario": json.dumps(motion.scenario.to_dict(), ensure_ascii=False),
        "status": motion.status,
        "sequence": motion.sequence,
        FINGERPRINT: motion.fingerprint,
        **({} if motion.until is None else {"until": motion.until}),
    }


def _packed(xr: Any, table: np.ndarray, dimension: str) -> xarray.Dataset:
    """Return a structured array as a Dataset, one variable per field."""
    names = table.dtype.names or ()
    variables = {}
    for name in names:
        meaning = name.replace("_", " ").capitalize()
        variables[name] = ([dimension], np.ascontiguousarray(table[name]), {"long_name": meaning, "units": "1"})
    layout = json.dumps([[name, table.dtype[name].str, []] for name in names])  # each is one number
    dataset: xarray.Dataset = xr.Dataset(variables, attrs={"layout": layout})
    return dataset


def _describe_events(dataset: Any, motion: Motion) -> None:
    """Add CF attributes with which other readers see events in SI units; the stored bits stay in kernel units."""
    for name, unit in EVENT_UNITS.items():
        if name in dataset:
            dataset[name].attrs.update(units=unit, scale_factor=motion.units.of(name.removeprefix("before_")))
    for name, words in (("kind", EVENT_NAMES), ("before_mode", MODE_WORDS), ("after_mode", MODE_WORDS)):
        if name in dataset:
            dataset[name].attrs.update(_flags(words, dataset[name].dtype))


def _write_rows(path: Path, header: list[str], rows: Any) -> None:
    with replacing(path) as temporary, temporary.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(header)
        writer.writerows(rows)
