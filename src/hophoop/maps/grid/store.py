"""A map as a Zarr store, written chunk by chunk: a resumed map has the same bytes as one written without a stop.

An incomplete store has a folder `unfinished` next to the arrays: the plan, a lock, and for every finished chunk its
sequences (codes of the chunk's own) and a mark that lists them. The mark is written last and completes the chunk. After the
last chunk the sequences get the codes of the whole map, and the folder is removed.

Each chunk has its own checksum (CRC-32C), which is compared on reading; the attributes have one of everything outside
the chunks. A netCDF file has one of all its bytes.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support.checksum import CHECKSUM, checksum, is_broken
from hophoop._support.extras import need
from hophoop._support.files import ignore_foreign_zarr_files, replacing
from hophoop._support.stopping import temporary
from hophoop.kernel.records.layout import MapResults
from hophoop.maps.grid.axes import Axis
from hophoop.maps.grid.evaluate import Plan, run_chunk, values_of
from hophoop.maps.grid.quantities import Quantity, attributes, distinct, encode, table_of
from hophoop.scenario import InputError

UNFINISHED, PLAN, GONE, LOCK = "unfinished", "plan.json", "unfinished.gone", "lock"
SCHEMA = "hophoop-map/1"
CHUNKS = "chunks"  # attribute with the number of chunks of each array; empty chunks are not written
MOST_SHORT_CODES = 2**15 - 1


@contextmanager
def begun(path: Path, plan: Plan, resume: bool) -> Iterator[tuple[Plan, set[int]]]:
    """Create or resume the store, locked against other processes.

    Parameters
    ----------
    path : Path
    plan : Plan
    resume : bool

    Yields
    ------
    plan : Plan
        The same, with the chunk shape of the store.
    todo : set of int
        Missing chunks; empty for a complete map.

    Raises
    ------
    ValueError
        If the store exists (without `resume`), holds another map, or is being written by another process.
    """
    shutil.rmtree(path / GONE, ignore_errors=True)
    if not path.exists():
        _create(path, plan)
    elif not resume:
        raise InputError(f"{path} exists already: choose another name, remove it, or resume it: --resume, resume=True.")
    known = _known_plan(path)
    if known is None:
        raise InputError(f"{path} is not a map of hophoop.")
    _compare(path, known, plan.to_text())
    working = path / UNFINISHED
    with _locked(path, working):
        if not (working / PLAN).exists():
            shutil.rmtree(working, ignore_errors=True)
            yield plan, set()
            return
        plan = read_plan(path)
        # a name with a leading dot is not complete
        done = {int(file.stem) for file in working.glob("*.done") if not file.name.startswith(".")}
        yield plan, set(range(plan.parts)) - done


@contextmanager
def _locked(path: Path, working: Path) -> Iterator[None]:
    """Hold the lock of an incomplete store; the system releases it when a process dies."""
    filelock = need("filelock", "maps")
    lock = filelock.FileLock(working / LOCK)
    if (working / PLAN).exists():
        try:
            lock.acquire(blocking=False)
        except filelock.Timeout:
            raise InputError(f"{path} is being written by another process: wait for it or stop it.") from None
        except FileNotFoundError:
            pass  # the folder was removed meanwhile: the map is complete
    try:
        yield
    finally:
        lock.release()


def read_plan(path: Path) -> Plan:
    """Return the plan of a store."""
    text = _known_plan(path)
    if text is None:
        raise InputError(f"{path} is not a map of hophoop.")
    return Plan.from_text(text)


def _known_plan(path: Path) -> str | None:
    file = path / UNFINISHED / PLAN
    if file.exists():
        return file.read_text(encoding="utf-8", errors="replace")
    try:
        known = need("zarr", "maps").open_group(str(path), mode="r").attrs.get("plan")
    except (OSError, ValueError, KeyError):
        return None
    return None if known is None else str(known)


def _compare(path: Path, known: str, wanted: str) -> None:
    try:
        old, new = json.loads(known), json.loads(wanted)
    except ValueError:
        old = None
    if not isinstance(old, dict):
        raise InputError(f"{path} holds a damaged plan and cannot be resumed.")
    if old.get("hophoop") != new["hophoop"]:
        raise InputError(
            f"{path} holds a map of hophoop {old.get('hophoop')}, which this version {new['hophoop']} cannot resume."
        )
    for key in sorted({*old, *new} - {"chunk"}):  # the store keeps its own
        # as text, where the order of the axes counts
        if json.dumps(old.get(key)) != json.dumps(new.get(key)):
            raise InputError(f"{path} holds a map with another {key} and cannot be resumed.")


def _create(path: Path, plan: Plan) -> None:
    zarr = need("zarr", "maps")
    if path.is_symlink():  # to a folder that is not there yet; the link stays
        path = Path(os.path.realpath(path))
    with temporary(path.with_name(f".{os.urandom(6).hex()}.{path.name}")) as fresh:
        group = zarr.open_group(str(fresh), mode="w", zarr_format=3)
        for axis in plan.axes:
            write_axis(group, axis)
        for quantity in plan.quantities:
            _create_array(group, plan, quantity, quantity.dtype)
        group.attrs.update(provenance(plan))
        (fresh / UNFINISHED).mkdir()
        (fresh / UNFINISHED / PLAN).write_text(plan.to_text(), encoding="utf-8")
        try:
            fresh.rename(path)
        except OSError:
            # another process may have just created it
            if not (path / UNFINISHED).exists():
                raise


def _create_array(group: Any, plan: Plan, quantity: Quantity, dtype: str, overwrite: bool = False) -> Any:
    codecs = need("zarr", "maps").codecs
    return group.create_array(
        quantity.name,
        shape=plan.shape,
        chunks=plan.chunk,
        dtype=dtype,
        fill_value=quantity.fill,
        dimension_names=[axis.path for axis in plan.axes],
        attributes=attributes(quantity),
        overwrite=overwrite,
        compressors=[codecs.ZstdCodec(), codecs.Crc32cCodec()],
    )


def write_axis(group: Any, axis: Axis) -> None:
    """Write a coordinate into the store; words as codes with their table."""
    extra: dict[str, Any] = {"long_name": axis.description}
    values: NDArray[Any] = axis.values
    if axis.unit == "":
        extra |= {
            "units": "1",
            "flag_values": list(range(values.size)),
            "flag_meanings": " ".join(values.tolist()),
        }
        values = np.arange(values.size, dtype=np.int16)
    else:
        extra["units"] = axis.unit
    array = group.create_array(
        axis.path,
        shape=values.shape,
        chunks=values.shape,
        dtype=values.dtype,
        fill_value=0,
        dimension_names=[axis.path],
        attributes=extra,
    )
    array[:] = values


def provenance(plan: Plan) -> dict[str, Any]:
    """Return the attributes that describe how a map was made; no date, so that equal maps are equal files."""
    data = json.loads(plan.to_text())
    del data["chunk"]  # describes the writing, not the content
    return {
        "Conventions": "CF-1.11",
        "schema": SCHEMA,
        "title": "Map of motions of a loaded hoop",
        "source": f"hophoop {data['hophoop']}",
        "scenario": json.dumps(data["scenario"]),
        "span": plan.span.name,
        "tolerance": data["tolerance"],
        "plan": json.dumps(data),
    }


def compute_chunk(path: str, index: int, *, serial: bool = False) -> int:
    """Compute one chunk and write it, and return the number of cells.

    Parameters
    ----------
    path : str
        The store, on a file system shared by all workers.
    index : int
    serial : bool, default False
        Use this thread only, not all cores.

    Returns
    -------
    cells : int
    """
    plan = _plan_of(path)
    chunk, results = run_chunk(plan, index, serial=serial)
    write_chunk(Path(path), plan, index, chunk.region, chunk.shape, results)
    return int(np.prod(chunk.shape))


_plans: dict[str, tuple[int, Plan]] = {}


def _plan_of(path: str) -> Plan:
    # a worker computes many chunks of one map
    stamp = (Path(path) / UNFINISHED / PLAN).stat().st_mtime_ns
    if path not in _plans or _plans[path][0] != stamp:
        _plans[path] = (stamp, read_plan(Path(path)))
    return _plans[path][1]


def write_chunk(
    path: Path, plan: Plan, index: int, region: tuple[slice, ...], shape: tuple[int, ...], results: MapResults
) -> None:
    """Write a chunk of every quantity, and then its mark."""
    zarr = need("zarr", "maps")
    group = zarr.open_group(str(path), mode="r+")
    mark: list[Any] = []
    for quantity in plan.quantities:
        if quantity.name == "sequence":
            keys = sorted(distinct(results.sequences))
            codes = encode(results.sequences, {key: i for i, key in enumerate(keys)})
            with replacing(path / UNFINISHED / f"{index}.npy") as file:
                np.save(file, codes.astype(np.int32).reshape(shape))
            mark = [[str(word) for word in key] for key in keys]
        else:
            group[quantity.name][region] = values_of(results, quantity).reshape(shape)
    with replacing(path / UNFINISHED / f"{index}.done") as file:
        file.write_text(json.dumps(mark), encoding="utf-8")


def finish(path: Path, plan: Plan) -> None:
    """Give the sequences the codes of the whole map, and remove the working files."""
    working = path / UNFINISHED
    if not working.exists():
        return
    if any(quantity.name == "sequence" for quantity in plan.quantities):
        _finish_sequences(path, plan)
    for left in path.rglob("*.partial"):  # of a worker that was killed
        left.unlink(missing_ok=True)
    group = need("zarr", "maps").open_group(str(path), mode="r+")
    group.attrs[CHUNKS] = _chunks_of(path, [quantity.name for quantity in plan.quantities])
    group.attrs[CHECKSUM] = _checksum_of(path)
    gone = path / GONE
    working.rename(gone)
    remove(gone)


def _finish_sequences(path: Path, plan: Plan) -> None:
    group = need("zarr", "maps").open_group(str(path), mode="r+")
    quantity = next(quantity for quantity in plan.quantities if quantity.name == "sequence")
    working = path / UNFINISHED
    tables = {}
    for index in range(plan.parts):
        words = json.loads((working / f"{index}.done").read_text(encoding="utf-8"))
        tables[index] = [tuple(int(word) for word in key) for key in words]
    names, codes = table_of({key for keys in tables.values() for key in keys})
    array = group["sequence"]
    if len(names) > MOST_SHORT_CODES and array.dtype != np.int32:
        array = _create_array(group, plan, quantity, "int32", overwrite=True)
    for index, keys in tables.items():
        table = np.array([codes[key] for key in keys], dtype=array.dtype)
        array[plan.part(index).region] = table[np.load(working / f"{index}.npy")]
    array.attrs.put(attributes(quantity, names))


def remove(path: Path) -> None:
    """Remove a folder if it exists."""
    if path.exists():
        shutil.rmtree(path)


def open_map(path: str | Path) -> Any:
    """Open a map that `sweep` wrote.

    Parameters
    ----------
    path : str or Path
        Ends in .zarr or .nc.

    Returns
    -------
    dataset : xarray.Dataset
        Its arrays are read on access.

    Raises
    ------
    ValueError
        If it does not exist, is incomplete or damaged, or has another schema.
    ImportError
        If xarray is missing.
    """
    need("xarray", "maps")
    place = Path(path)
    if not place.exists():
        raise InputError(f"{place} is not there.")
    if (place / UNFINISHED).exists():
        raise InputError(f"{place} is not complete: continue it with resume.")
    try:
        _check_whole(place)
        dataset = with_words(_opened(place))
    except InputError:
        raise
    except Exception as error:  # libraries raise many kinds of errors on malformed files
        lines = str(error).strip().splitlines() or [type(error).__name__]
        raise InputError(f"{place} cannot be read as a map of hophoop: {lines[0].rstrip('.: ')}.") from None
    return dataset


def _opened(place: Path, **options: Any) -> Any:
    xarray = need("xarray", "maps")
    if place.suffix == ".nc":
        return xarray.open_dataset(place, engine="netcdf4", **options)
    with ignore_foreign_zarr_files():
        return xarray.open_zarr(str(place), chunks=None, consolidated=False, **options)


def _checksum_of(place: Path) -> str:
    """Return the checksum of a map except for the values of its quantities, whose chunks have their own."""
    with _opened(place, decode_cf=False) as dataset:
        return checksum({"/": dataset}, without=[name for name in dataset.variables if name not in dataset.dims])


def _chunks_of(place: Path, names: Sequence[str]) -> str:
    group = need("zarr", "maps").open_group(str(place), mode="r")
    return json.dumps({name: group[name].nchunks_initialized for name in sorted(names)})


def _check_whole(place: Path) -> None:
    """Refuse a map of another schema, and one that has changed since it was written."""
    damaged = f"{place} is damaged: its checksum is not that of its content."
    if place.suffix == ".nc" and is_broken(place):
        raise InputError(damaged)
    with _opened(place, decode_cf=False) as dataset:
        said = dict(dataset.attrs)
        names = [name for name in dataset.variables if name not in dataset.dims]
        if "plan" not in said:
            raise InputError(f"{place} is not a map of hophoop.")
        if said.get("schema") != SCHEMA:
            raise InputError(
                f"{place} has the schema {said.get('schema')!r}, but this version of hophoop reads {SCHEMA!r} only."
            )
        if CHECKSUM not in said:
            return  # a copy that xarray wrote
    if said[CHECKSUM] != _checksum_of(place):
        raise InputError(damaged)
    if place.suffix != ".nc" and said[CHUNKS] != _chunks_of(place, names):
        raise InputError(f"{place} is damaged: a part of it is missing.")


def with_words(dataset: Any) -> Any:
    """Return the dataset with words instead of codes along axes of words."""
    dataset = dataset[json.loads(dataset.attrs["plan"])["quantities"]]
    for name in (CHECKSUM, CHUNKS):  # of the file
        dataset.attrs.pop(name, None)
    for name in dataset.dims:
        coordinate = dataset[name]
        if "flag_meanings" in coordinate.attrs and coordinate.dtype.kind in "iu":
            words = np.array(coordinate.attrs["flag_meanings"].split(" "))[coordinate.values]
            dataset = dataset.assign_coords({name: (name, words, {"long_name": coordinate.attrs["long_name"]})})
    return dataset
