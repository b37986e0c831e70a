"""A map as a Zarr store, written chunk by chunk: a resumed map has the same bytes as one written without a stop.

A chunk is complete when its file of each quantity is there, since Zarr writes a file whole or not at all. An incomplete store
has a folder `unfinished` with a lock and the sequences, packed into integers. After the last chunk the sequences get codes, the
attributes their checksum, which completes the store, and the folder is removed.

Each chunk has its own checksum (CRC-32C), which is compared on reading; the one in the attributes is of everything outside the
chunks. A netCDF file has one of all its bytes.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hophoop._support.checksum import CHECKSUM, checksum, is_broken
from hophoop._support.extras import need
from hophoop._support.files import consolidate, ignore_foreign_zarr_files
from hophoop._support.stopping import temporary
from hophoop.maps.grid.axes import Axis
from hophoop.maps.grid.evaluate import Plan
from hophoop.maps.grid.kernel import INTEGERS
from hophoop.maps.grid.quantities import QUANTITIES, SEQUENCE, Quantity, attributes, distinct_rows, flags_in_file, table_of
from hophoop.scenario import InputError

if TYPE_CHECKING:
    import xarray

UNFINISHED, LOCK = "unfinished", "lock"
SCHEMA = "hophoop-map/1"
MOST_SHORT_CODES = 2**15 - 1
ALL_CHUNKS = {"write_empty_chunks": True}


# --- a store while it is written


@contextmanager
def begun(path: Path, plan: Plan, resume: bool) -> Iterator[tuple[Plan, list[tuple[int, ...]]]]:
    """Create or resume the store, locked against other processes.

    Yields the plan with the chunk shape of the store, and the places of the missing chunks.
    """
    if not path.exists():
        _create(path, plan)
    elif not resume:
        raise InputError(f"{path} exists already: choose another name, remove it, or resume it: --resume, resume=True.")
    _compare(path, plan)
    with contextlib.nullcontext() if is_complete(path) else _locked(path):
        todo: list[tuple[int, ...]] = []
        if not is_complete(path):
            arrays = arrays_of(path, plan)
            plan = plan._replace(chunk=next(iter(arrays.values())).chunks[: len(plan.shape)])
            todo = [index for index in np.ndindex(*plan.chunks) if not _is_written(path, arrays, index)]
        yield plan, todo
    if is_complete(path):
        shutil.rmtree(path / UNFINISHED, ignore_errors=True)


def is_complete(path: Path) -> bool:
    """Return True if a store is one that `finish` completed, or another program's copy of one."""
    return not (path / UNFINISHED).exists() or CHECKSUM in _attributes_of(path)


def _attributes_of(path: Path) -> dict[str, Any]:
    try:
        return dict(need("zarr", "maps").open_group(str(path), mode="r").attrs)
    except (OSError, ValueError, KeyError):
        return {}


def _locked(path: Path) -> Any:
    """Return a context that holds the lock of an incomplete store; the system releases it when a process dies."""
    filelock = need("filelock", "maps")
    try:
        return filelock.FileLock(path / UNFINISHED / LOCK).acquire(blocking=False)
    except filelock.Timeout:
        raise InputError(f"{path} is being written by another process: wait for it or stop it.") from None


def _compare(path: Path, plan: Plan) -> None:
    known = _attributes_of(path).get("plan")
    if known is None:
        raise InputError(f"{path} is not a map of hophoop.")
    new = plan.to_dict()
    try:
        old = dict(json.loads(known))
        version = old["hophoop"]
    except (ValueError, TypeError, KeyError):
        raise InputError(f"{path} holds a damaged plan and cannot be resumed.") from None
    if version != new["hophoop"]:
        raise InputError(f"{path} holds a map of hophoop {version}, which this version {new['hophoop']} cannot resume.")
    for key in sorted({*old, *new}):
        # as text, where the order of the axes counts
        if json.dumps(old.get(key)) != json.dumps(new.get(key)):
            raise InputError(f"{path} holds a map with another {key} and cannot be resumed.")


def _create(path: Path, plan: Plan) -> None:
    if path.is_symlink():  # to a folder that is not there yet; the link stays
        path = Path(os.path.realpath(path))
    with temporary(path.with_name(f".{os.urandom(6).hex()}.{path.name}")) as fresh:
        need("zarr", "maps").create_group(str(fresh), attributes=_provenance(plan))
        for axis in plan.axes:
            _write_axis(fresh, axis)
        (fresh / UNFINISHED).mkdir()
        for quantity in plan.quantities:
            _create_array(fresh, plan, quantity)
        try:
            fresh.rename(path)
        except OSError:
            # another process may have just created it
            if not (path / UNFINISHED).exists():
                raise


def _write_axis(path: Path, axis: Axis) -> None:
    """Write a coordinate; words as codes with their table."""
    values, said = axis.values, attributes_of(axis)
    if not axis.unit:
        said |= flags_in_file(values.tolist())
        values = np.arange(values.size, dtype=np.int16)
    need("zarr", "maps").create_array(
        str(path / axis.path), data=values, chunks=values.shape, dimension_names=[axis.path], attributes=said, config=ALL_CHUNKS
    )


def _create_array(path: Path, plan: Plan, quantity: Quantity, sequences: Sequence[str] | None = None) -> Any:
    """Create the array of a quantity; every chunk gets a file, also where its values are all 0, and a checksum.

    sequences: before they are known, sequences are packed into integers.
    """
    zarr, packed = need("zarr", "maps"), quantity.name == SEQUENCE and sequences is None
    more = (INTEGERS,) if packed else ()
    return zarr.create_array(
        str(_folder(path, quantity.name) if packed else path / quantity.name),
        shape=plan.shape + more,
        chunks=plan.chunk + more,
        dtype="u8" if packed else quantity.dtype if sequences is None else code_type(sequences),
        fill_value=0 if packed else quantity.fill,
        compressors=[zarr.codecs.ZstdCodec(), zarr.codecs.Crc32cCodec()],
        dimension_names=None if packed else [axis.path for axis in plan.axes],
        attributes=attributes(quantity, sequences or ()),
        config=ALL_CHUNKS,
        overwrite=True,
    )


def arrays_of(path: Path, plan: Plan) -> dict[str, Any]:
    """Return the arrays of an incomplete store to be written to."""
    zarr = need("zarr", "maps")
    with zarr.config.set({f"array.{key}": value for key, value in ALL_CHUNKS.items()}):
        return {q.name: zarr.open_array(str(_folder(path, q.name)), mode="r+") for q in plan.quantities}


def _folder(path: Path, name: str) -> Path:
    return path / UNFINISHED / name if name == SEQUENCE else path / name


def _is_written(path: Path, arrays: Mapping[str, Any], index: tuple[int, ...]) -> bool:
    """Return True if a chunk is there of every quantity."""
    keys = {name: (*index, 0)[: array.ndim] for name, array in arrays.items()}
    return all((_folder(path, name) / array.metadata.encode_chunk_key(keys[name])).exists() for name, array in arrays.items())


def finish(path: Path, plan: Plan, threads: int) -> None:
    """Give the sequences their codes, and the attributes their checksum, which completes the store."""
    if any(quantity.name == SEQUENCE for quantity in plan.quantities):
        _write_sequences(path, plan, threads)
    for left in path.rglob("*.partial"):  # of a process that was killed
        left.unlink(missing_ok=True)
    need("zarr", "maps").open_group(str(path), mode="r+").attrs[CHECKSUM] = _checksum_of(path)
    consolidate(path)


def _write_sequences(path: Path, plan: Plan, threads: int) -> None:
    packed = need("zarr", "maps").open_array(str(_folder(path, SEQUENCE)), mode="r")
    regions = [plan.region(index) for index in np.ndindex(*plan.chunks)]
    with ThreadPoolExecutor(threads) as pool:
        names, codes = table_of(set().union(*pool.map(lambda region: distinct_rows(packed[region])[0], regions)))
        array = _create_array(path, plan, QUANTITIES[SEQUENCE], names)

        def write(region: tuple[slice, ...]) -> None:
            array[region] = encode(packed[region], codes)

        for _ in pool.map(write, regions):
            pass


def encode(keys: NDArray[np.uint64], codes: Mapping[tuple[int, ...], int]) -> NDArray[np.int32]:
    """Return the codes of a block of packed sequences."""
    rows, place = distinct_rows(keys)
    return np.array([codes[row] for row in rows], np.int32)[place]


def code_type(names: Sequence[str]) -> str:
    """Return the type of the codes of sequences."""
    return "int16" if len(names) <= MOST_SHORT_CODES else "int32"


# --- datasets


def dataset_of(plan: Plan, arrays: Mapping[str, Any], names: Sequence[str]) -> xarray.Dataset:
    """Return arrays in memory with their coordinates and attributes; `names` are the sequences."""
    paths = [axis.path for axis in plan.axes]
    variables = {q.name: (paths, arrays[q.name], attributes(q, names)) for q in plan.quantities}
    coordinates = {axis.path: (axis.path, axis.values, attributes_of(axis)) for axis in plan.axes}
    made: xarray.Dataset = need("xarray", "maps").Dataset(variables, coordinates, _provenance(plan))
    return made


def attributes_of(axis: Axis) -> dict[str, Any]:
    """Return the attributes of a coordinate."""
    return {"long_name": axis.description} | ({"units": axis.unit} if axis.unit else {})


def _provenance(plan: Plan) -> dict[str, Any]:
    """Return the attributes that describe how a map was made; no date, so that equal maps are equal files."""
    data = plan.to_dict()
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


def open_map(path: str | Path) -> xarray.Dataset:
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
    if not is_complete(place):
        raise InputError(f"{place} is not complete: continue it with resume.")
    try:
        _check_whole(place)
        return with_words(opened(place))
    except InputError:
        raise
    except Exception as error:  # libraries raise many kinds of errors on malformed files
        lines = str(error).strip().splitlines() or [type(error).__name__]
        raise InputError(f"{place} cannot be read as a map of hophoop: {lines[0].rstrip('.: ')}.") from None


def opened(place: Path, **options: Any) -> Any:
    """Open a complete map as xarray reads it."""
    xarray = need("xarray", "maps")
    if place.suffix == ".nc":
        return xarray.open_dataset(place, engine="netcdf4", **options)
    with ignore_foreign_zarr_files():
        return xarray.open_zarr(str(place), chunks=None, consolidated=False, **options)


def _checksum_of(place: Path) -> str:
    """Return the checksum of a map except for the values of its quantities, whose chunks have their own."""
    with opened(place, decode_cf=False) as dataset:
        return checksum({"/": dataset}, without=list(dataset.data_vars))


def _check_whole(place: Path) -> None:
    """Refuse a map of another schema, and one that has changed since it was written."""
    damaged = f"{place} is damaged: its checksum is not that of its content."
    if place.suffix == ".nc" and is_broken(place):
        raise InputError(damaged)
    with opened(place, decode_cf=False) as dataset:
        said, names = dict(dataset.attrs), list(dataset.data_vars)
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
    if place.suffix != ".nc":
        group = need("zarr", "maps").open_group(str(place), mode="r", use_consolidated=False)
        for name in names:
            _check_chunks(place, group[name])


def _check_chunks(place: Path, array: Any) -> None:
    """Refuse an array with a chunk that is missing, or that is not as it was written."""
    if array.nchunks_initialized != array.nchunks:
        raise InputError(f"{place} is damaged: a part of it is missing.")
    for index in np.ndindex(array.cdata_shape):
        try:
            array.blocks[index]
        except Exception as error:  # of its codecs
            raise InputError(f"{place} is damaged: a part of {array.basename} is not as it was written.") from error


def with_words(dataset: xarray.Dataset) -> xarray.Dataset:
    """Return the dataset with words instead of codes along axes of words."""
    plan = json.loads(dataset.attrs["plan"])
    dataset = dataset[plan["quantities"]]
    dataset.attrs.pop(CHECKSUM, None)  # of the file
    for name, words in plan["axes"].items():
        said = dataset[name].attrs
        if "flag_meanings" in said:
            dataset = dataset.assign_coords({name: (name, words, {"long_name": said["long_name"]})})
    return dataset
