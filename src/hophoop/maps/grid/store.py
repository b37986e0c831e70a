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
from collections.abc import Iterator, Mapping
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
from hophoop.maps.grid.axes import has_words
from hophoop.maps.grid.evaluate import Plan, Region
from hophoop.maps.grid.kernel import INTEGERS
from hophoop.maps.grid.quantities import QUANTITIES, Quantity, attributes, codes_of, distinct_sequences, encode, sequences_with
from hophoop.scenario import InputError, parameter
from hophoop.vocabulary.names import SEQUENCE

if TYPE_CHECKING:
    import xarray

UNFINISHED, LOCK = "unfinished", "lock"
SCHEMA = "hophoop-map/1"
ALL_CHUNKS = {"write_empty_chunks": True}
DAMAGED = "{} is damaged: its checksum is not that of its content."


# --- a store while it is written


@contextmanager
def begun(path: Path, plan: Plan, resume: bool, threads: int) -> Iterator[tuple[Plan, dict[str, Any], list[Region]]]:
    """Create or resume the store, locked against other processes, and complete it at the end.

    Yields the plan with the chunk shape of the store, the arrays to be written to, and the missing chunks.
    """
    if not path.exists():
        _create(path, plan)
    elif not resume:
        raise InputError(f"{path} exists already: choose another name, remove it, or resume it: --resume, resume=True.")
    _compare(path, plan)
    with contextlib.nullcontext() if is_complete(path) else _locked(path):
        if is_complete(path):
            yield plan, {}, []
        else:
            arrays = _arrays_of(path.resolve(), plan)
            plan = plan._replace(chunk=next(iter(arrays.values())).chunks[: len(plan.shape)])
            written = map(_written, arrays.values())
            yield plan, arrays, [region for region, *there in zip(plan.regions(), *written, strict=True) if not all(there)]
            finish(path, plan, threads)
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
    path = path.resolve()  # a link to a folder that is not there yet stays
    with temporary(path.with_name(f".{os.urandom(6).hex()}.{path.name}")) as fresh:
        zarr = need("zarr", "maps")
        zarr.create_group(str(fresh), attributes=_provenance(plan))
        for name, values in plan.axes.items():
            data, said = coordinate(name, values)
            zarr.create_array(
                str(fresh / name), data=data, chunks=data.shape, dimension_names=[name], attributes=said, config=ALL_CHUNKS
            )
        (fresh / UNFINISHED).mkdir()
        for quantity in plan.quantities:
            _create_array(_folder(fresh, quantity.name), plan, quantity, packed=quantity.name == SEQUENCE)
        try:
            fresh.rename(path)
        except OSError:
            # another process may have just created it
            if not (path / UNFINISHED).exists():
                raise


def _create_array(folder: Path, plan: Plan, quantity: Quantity, packed: bool = False) -> Any:
    """Create the array of a quantity; every chunk gets a file, also where its values are all 0, and a checksum.

    packed: of sequences that are packed into integers, before all are known.
    """
    zarr, more = need("zarr", "maps"), (INTEGERS,) if packed else ()
    return zarr.create_array(
        str(folder),
        shape=plan.shape + more,
        chunks=plan.chunk + more,
        dtype="u8" if packed else quantity.dtype,
        fill_value=0 if packed else quantity.fill,
        compressors=[zarr.codecs.ZstdCodec(), zarr.codecs.Crc32cCodec()],
        dimension_names=None if packed else list(plan.axes),
        attributes=quantity.attributes,
        config=ALL_CHUNKS,
        overwrite=True,
    )


def _arrays_of(path: Path, plan: Plan) -> dict[str, Any]:
    """Return the arrays of an incomplete store to be written to."""
    zarr = need("zarr", "maps")
    with zarr.config.set({f"array.{key}": value for key, value in ALL_CHUNKS.items()}):
        return {q.name: zarr.open_array(str(_folder(path, q.name)), mode="r+") for q in plan.quantities}


def _folder(path: Path, name: str) -> Path:
    return path / UNFINISHED / name if name == SEQUENCE else path / name


def _written(array: Any) -> list[bool]:
    """Return for each chunk of an array whether its file is there."""
    keys = map(array.metadata.encode_chunk_key, np.ndindex(array.cdata_shape))
    return [(array.store.root / key).exists() for key in keys]


def finish(path: Path, plan: Plan, threads: int) -> None:
    """Give the sequences their codes, and the attributes their checksum, which completes the store."""
    if QUANTITIES[SEQUENCE] in plan.quantities:
        _write_sequences(path, plan, threads)
    for left in path.rglob("*.partial"):  # of a process that was killed
        left.unlink(missing_ok=True)
    with opened(path) as dataset:
        need("zarr", "maps").open_group(str(path), mode="r+").attrs[CHECKSUM] = _checksum_of(dataset)
    consolidate(path)


def _write_sequences(path: Path, plan: Plan, threads: int) -> None:
    packed = need("zarr", "maps").open_array(str(_folder(path, SEQUENCE)), mode="r")
    with ThreadPoolExecutor(threads) as pool:
        codes = codes_of(set().union(*pool.map(lambda region: distinct_sequences(packed[region])[0], plan.regions())))
        array = _create_array(path / SEQUENCE, plan, sequences_with(codes))

        def write(region: Region) -> None:
            array[region] = encode(*distinct_sequences(packed[region]), codes)

        for _ in pool.map(write, plan.regions()):
            pass


# --- datasets


def dataset_of(plan: Plan, arrays: Mapping[Quantity, Any]) -> xarray.Dataset:
    """Return arrays in memory with their coordinates and attributes."""
    variables = {quantity.name: (list(plan.axes), array, quantity.attributes) for quantity, array in arrays.items()}
    coordinates = {name: (name, *coordinate(name, values)) for name, values in plan.axes.items()}
    return with_words(need("xarray", "maps").Dataset(variables, coordinates, _provenance(plan)), plan.axes)


def coordinate(name: str, values: NDArray[Any]) -> tuple[NDArray[Any], dict[str, Any]]:
    """Return the values of an axis, of words their codes, and its attributes."""
    about, words = parameter(name), values.tolist() if has_words(values) else []
    return np.arange(len(words), dtype=np.int16) if words else values, attributes(about.description, about.unit, words)


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
    xarray, place = need("xarray", "maps"), Path(path)
    if not place.exists():
        raise InputError(f"{place} is not there.")
    if not is_complete(place):
        raise InputError(f"{place} is not complete: continue it with resume.")
    try:
        if place.suffix == ".nc" and is_broken(place):
            raise InputError(DAMAGED.format(place))
        dataset = opened(place)
        _check_whole(place, dataset)
        plan = json.loads(dataset.attrs["plan"])
        found = xarray.decode_cf(dataset)[[*plan["quantities"], *plan["axes"]]]
        found.attrs.pop(CHECKSUM, None)  # of the file
        return with_words(found, plan["axes"])
    except InputError:
        raise
    except Exception as error:  # libraries raise many kinds of errors on malformed files
        lines = str(error).strip().splitlines() or [type(error).__name__]
        raise InputError(f"{place} cannot be read as a map of hophoop: {lines[0].rstrip('.: ')}.") from None


def opened(place: Path) -> Any:
    """Open a complete map as xarray reads it, without decoding."""
    xarray = need("xarray", "maps")
    if place.suffix == ".nc":
        return xarray.open_dataset(place, engine="netcdf4", decode_cf=False)
    with ignore_foreign_zarr_files():
        return xarray.open_zarr(str(place), chunks=None, consolidated=False, decode_cf=False)


def _checksum_of(dataset: Any) -> str:
    """Return the checksum of a map except for the values of its quantities, whose chunks have their own."""
    return checksum({"/": dataset}, without=list(dataset.data_vars))


def _check_whole(place: Path, dataset: xarray.Dataset) -> None:
    """Refuse a map of another schema, and one that has changed since it was written."""
    said = dataset.attrs
    if "plan" not in said:
        raise InputError(f"{place} is not a map of hophoop.")
    if said.get("schema") != SCHEMA:
        raise InputError(f"{place} has the schema {said.get('schema')!r}, but this version of hophoop reads {SCHEMA!r} only.")
    if CHECKSUM not in said:
        return  # a copy that xarray wrote
    if said[CHECKSUM] != _checksum_of(dataset):
        raise InputError(DAMAGED.format(place))
    if place.suffix != ".nc":
        for name in dataset.data_vars:
            _check_chunks(place, str(name))


def _check_chunks(place: Path, name: str) -> None:
    """Refuse an array with a chunk that is missing, or that is not as it was written."""
    array = need("zarr", "maps").open_array(str(place / name), mode="r")
    if array.nchunks_initialized != array.nchunks:
        raise InputError(f"{place} is damaged: a part of it is missing.")
    for index in np.ndindex(array.cdata_shape):
        try:
            array.blocks[index]
        except Exception as error:  # of its codecs
            raise InputError(f"{place} is damaged: a part of {name} is not as it was written.") from error


def with_words(dataset: xarray.Dataset, axes: Mapping[str, Any]) -> xarray.Dataset:
    """Return the dataset with words instead of codes along axes of words."""
    for name, words in axes.items():
        said = dataset[name].attrs
        if "flag_meanings" in said:
            dataset = dataset.assign_coords({name: (name, words, {"long_name": said["long_name"]})})
    return dataset
