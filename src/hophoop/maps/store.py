"""A map as a Zarr store: made chunk by chunk, taken up again after any stop, and the same bytes in the end.

While it grows, the store has a folder `unfinished` beside the arrays: the plan, and for every finished chunk
its sequences (codes of the chunk's own) and a mark that lists them. A chunk counts once its mark is there,
which is written last. When all are there the sequences get the codes of the whole map, and the folder goes.
"""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop._extras import need
from hophoop._files import replacing
from hophoop.maps.axes import Axis
from hophoop.maps.evaluate import Plan, Results, run_chunk
from hophoop.maps.quantities import attributes, distinct, encode, table_of
from hophoop.scenario import InputError

UNFINISHED, PLAN, GONE = "unfinished", "plan.json", "unfinished.gone"
MOST_SHORT_CODES = 2**15 - 1


def begin(path: Path, plan: Plan, resume: bool) -> tuple[Plan, set[int]]:
    """Make the store, or take it up again.

    Parameters
    ----------
    path : Path
    plan : Plan
    resume : bool

    Returns
    -------
    plan : Plan
        The same, with the chunks that the store has.
    todo : set of int
        Chunks that are not there yet; empty for a map that is complete.

    Raises
    ------
    ValueError
        If the store is there already (without `resume`) or holds another map.
    """
    remove(path / GONE)
    if not path.exists():
        _create(path, plan)
    elif not resume:
        raise InputError(f"{path} is there already: take another name, remove it, or take it up with resume.")
    known = _known_plan(path)
    if known is None:
        raise InputError(f"{path} is not a map of hophoop.")
    _compare(path, known, plan.to_text())
    working = path / UNFINISHED
    if not working.exists():
        return plan, set()
    plan = read_plan(path)
    # one with a dot in front is not whole yet
    done = {int(file.stem) for file in working.glob("*.done") if not file.name.startswith(".")}
    return plan, set(range(plan.parts)) - done


def read_plan(path: Path) -> Plan:
    """The plan of a store."""
    text = _known_plan(path)
    if text is None:
        raise InputError(f"{path} is not a map of hophoop.")
    return Plan.from_text(text)


def _known_plan(path: Path) -> str | None:
    file = path / UNFINISHED / PLAN
    if file.exists():
        return file.read_text(encoding="utf-8")
    try:
        known = need("zarr", "maps").open_group(str(path), mode="r").attrs.get("plan")
    except (OSError, ValueError, KeyError):
        return None
    return None if known is None else str(known)


def _compare(path: Path, known: str, wanted: str) -> None:
    old, new = json.loads(known), json.loads(wanted)
    for key in new:
        if key == "chunk":  # the store keeps its own
            continue
        # as text, where the order of the axes counts
        if json.dumps(old.get(key)) != json.dumps(new[key]):
            raise InputError(f"{path} holds a map with another {key}, so that it cannot be taken up.")


def _create(path: Path, plan: Plan) -> None:
    zarr = need("zarr", "maps")
    with replacing(path) as fresh:
        group = zarr.open_group(str(fresh), mode="w", zarr_format=3)
        for axis in plan.axes:
            write_axis(group, axis)
        for quantity in plan.quantities:
            group.create_array(
                quantity.name,
                shape=plan.shape,
                chunks=plan.chunk,
                dtype=quantity.dtype,
                fill_value=quantity.fill,
                dimension_names=[axis.path for axis in plan.axes],
                attributes=attributes(quantity),
            )
        group.attrs.update(provenance(plan))
        (fresh / UNFINISHED).mkdir()
        (fresh / UNFINISHED / PLAN).write_text(plan.to_text(), encoding="utf-8")


def write_axis(group: Any, axis: Axis) -> None:
    """Put a coordinate into the store; words as codes with their table."""
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
    """Attributes that say what made a map; no date, so that equal maps are equal files."""
    data = json.loads(plan.to_text())
    del data["chunk"]  # says how it was written, not what it is
    return {
        "Conventions": "CF-1.11",
        "title": "Map of motions of a loaded hoop",
        "source": f"hophoop {data['hophoop']}",
        "scenario": json.dumps(data["scenario"]),
        "span": plan.span.name,
        "tolerance": data["tolerance"],
        "plan": json.dumps(data),
    }


def compute_chunk(path: str, index: int, device: str = "serial") -> int:
    """Compute one chunk and write it; what a worker does. Returns the number of cells.

    Parameters
    ----------
    path : str
        The store, on a file system that all workers see.
    index : int
    device : {'serial', 'cpu', 'gpu'}

    Returns
    -------
    cells : int
    """
    plan = _plan_of(path)
    chunk, results = run_chunk(plan, index, device)
    write_chunk(Path(path), plan, index, chunk.region, chunk.shape, results)
    return int(np.prod(chunk.shape))


_plans: dict[str, tuple[int, Plan]] = {}


def _plan_of(path: str) -> Plan:
    # A worker takes many chunks of one map.
    stamp = (Path(path) / UNFINISHED / PLAN).stat().st_mtime_ns
    if path not in _plans or _plans[path][0] != stamp:
        _plans[path] = (stamp, read_plan(Path(path)))
    return _plans[path][1]


def write_chunk(
    path: Path, plan: Plan, index: int, region: tuple[slice, ...], shape: tuple[int, ...], results: Results
) -> None:
    """Write a chunk of every quantity, and then its mark."""
    zarr = need("zarr", "maps")
    group = zarr.open_group(str(path), mode="r+")
    mark: list[Any] = []
    for quantity in plan.quantities:
        if quantity.name == "sequence":
            keys = sorted(distinct(results.keys))
            codes = encode(results.keys, {key: i for i, key in enumerate(keys)})
            with replacing(path / UNFINISHED / f"{index}.npy") as file:
                np.save(file, codes.astype(np.int32).reshape(shape))
            mark = [[str(word) for word in key] for key in keys]
        else:
            group[quantity.name][region] = results.of(quantity).reshape(shape)
    with replacing(path / UNFINISHED / f"{index}.done") as file:
        file.write_text(json.dumps(mark), encoding="utf-8")


def finish(path: Path, plan: Plan) -> None:
    """Give the sequences the codes of the whole map, and take away what was needed on the way."""
    working = path / UNFINISHED
    if not working.exists():
        return
    if any(quantity.name == "sequence" for quantity in plan.quantities):
        _finish_sequences(path, plan)
    for left in path.rglob("*.partial"):  # of a worker that was killed
        left.unlink(missing_ok=True)
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
        array = group.create_array(
            "sequence",
            shape=plan.shape,
            chunks=plan.chunk,
            dtype="int32",
            fill_value=quantity.fill,
            dimension_names=[axis.path for axis in plan.axes],
            overwrite=True,
        )
    for index, keys in tables.items():
        table = np.array([codes[key] for key in keys], dtype=array.dtype)
        array[plan.part(index).region] = table[np.load(working / f"{index}.npy")]
    array.attrs.put(attributes(quantity, names))


def remove(path: Path) -> None:
    """Remove a folder that may be there."""
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
        Its arrays are read when they are used.

    Raises
    ------
    ValueError
        If it is not there, or not complete.
    ImportError
        If xarray is missing.
    """
    xarray = need("xarray", "maps")
    place = Path(path)
    if not place.exists():
        raise InputError(f"{place} is not there.")
    if place.suffix == ".nc":
        return with_words(xarray.open_dataset(place, engine="netcdf4"))
    if (place / UNFINISHED).exists():
        raise InputError(f"{place} is not complete: take it up with resume.")
    return with_words(xarray.open_zarr(str(place), chunks=None, consolidated=False))


def with_words(dataset: Any) -> Any:
    """The dataset with words, not codes, along axes of words."""
    dataset = dataset[json.loads(dataset.attrs["plan"])["quantities"]]
    for name in dataset.dims:
        coordinate = dataset[name]
        if "flag_meanings" in coordinate.attrs and coordinate.dtype.kind in "iu":
            words = np.array(coordinate.attrs["flag_meanings"].split(" "))[coordinate.values]
            dataset = dataset.assign_coords({name: (name, words, {"long_name": coordinate.attrs["long_name"]})})
    return dataset
