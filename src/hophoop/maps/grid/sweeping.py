"""Sweep a grid of scenarios: in memory or into a file, on all cores or a cluster."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from hophoop._support.checksum import seal
from hophoop._support.extras import need
from hophoop._support.files import netcdf_errors, replacing
from hophoop._support.progress import bar
from hophoop.maps.grid import store
from hophoop.maps.grid.evaluate import CHUNK_CELLS, Plan, make_plan, run_chunk, thread_limit, values_of
from hophoop.maps.grid.memory import check_memory
from hophoop.maps.grid.quantities import attributes, distinct, encode, table_of
from hophoop.scenario import InputError, Scenario

if TYPE_CHECKING:
    import xarray

Progress = Callable[[int, int], None]


def sweep(
    base: Scenario | None = None,
    axes: Mapping[str, ArrayLike] | None = None,
    quantities: Sequence[str] = ("sequence",),
    span: str = "first_revolution",
    *,
    out: str | Path | None = None,
    resume: bool = False,
    threads: int | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    progress: bool | Progress = False,
    chunk_cells: int = CHUNK_CELLS,
) -> xarray.Dataset:
    """Compute a map: reduced quantities of the motion in every cell of a grid of scenarios.

    Parameters
    ----------
    base : Scenario, optional
        The scenario to vary; by default the reference hoop.
    axes : mapping of str to array_like
        At least two parameters by their path, such as ``{"plane.mu": …, "start.speed": …}``, each with its
        values [SI]. Cells whose values do not go together (such as μk above μs) are marked, not errors.
    quantities : sequence of str, default ('sequence',)
        Names of `QUANTITIES`, or of `SETTLED` with the span ``settled``.
    span : str, default 'first_revolution'
        How much of each motion counts. ``first_revolution`` ends at a full turn, at θ̇ = 0 or at take-off,
        whichever comes first, without a time limit; ``takeoff``, ``reversal`` and ``revolutions:N`` end
        there, at the latest after the scenario's duration; ``duration`` ends after it. The first hop is always
        computed up to its landing. ``settled`` ends when it is decided what becomes of the motion, at the latest after 2000
        passages of the bottom (``settled:landing``: landings); it has quantities of its own, such as fate.
    out : str or Path, optional
        Write to this file, ending in .zarr or .nc, chunk by chunk; else the map stays in memory.
    resume : bool, default False
        Resume the map in `out` where it was stopped.
    threads : int, optional
        How many cores; all by default [1].
    workers : int, optional
        Number of processes of a Dask cluster to start on this machine [1].
    scheduler : str, optional
        Address of a running Dask scheduler, such as ``"tcp://10.0.0.1:8786"``. Its workers must see `out`.
    progress : bool or callable, default False
        Show progress on standard error; a callable gets the number of cells done and of all cells.
    chunk_cells : int, default 65536
        Approximate number of cells computed and written at a time [1].

    Returns
    -------
    dataset : xarray.Dataset
        One array per quantity over the axes' paths, with units and long_name; sequences and other codes are
        small integers with their table in ``flag_values`` and ``flag_meanings`` (see `words_of`). The arrays
        of a file are read on access.

    Raises
    ------
    ValueError
        If an axis, a quantity, the span or an option is not allowed, or the map or its netCDF file does not fit in memory.
    KeyboardInterrupt
        If it is stopped; finished chunks are kept, and `resume` continues.
    ImportError
        If xarray or Zarr, or for a cluster Dask, is missing.

    Examples
    --------
    >>> import hophoop as hh
    >>> dataset = hh.maps.sweep(axes={"plane.mu": [0.3, 1.0], "start.speed": [0.1, 3.1, 5.0]})
    >>> words = hh.maps.words_of(dataset["sequence"])
    >>> [[words[code] for code in row] for row in dataset["sequence"].values]
    [['RSRKRSRKR', 'RKRSH', 'H'], ['R', 'RKRSH', 'H']]
    """
    need("xarray", "maps")
    if axes is None:
        raise InputError("axes must name at least two parameters.")
    if workers is not None and scheduler is not None:
        raise InputError("workers and scheduler cannot be given together.")
    if workers is not None and workers < 1:
        raise InputError.of_field("workers", workers, "at least 1")
    clustered = workers is not None or scheduler is not None
    if clustered and out is None:
        raise InputError("out must name a file for a sweep over a cluster: the workers write into it.")
    if resume and out is None:
        raise InputError("out must name the file to resume.")
    plan = make_plan(base, axes, quantities, span, chunk_cells)
    dataset: xarray.Dataset
    kinds = ["int32" if quantity.name == "sequence" else quantity.dtype for quantity in plan.quantities]
    if out is None:
        check_memory(plan.shape, kinds, "name a file that ends in .zarr with out, or take fewer values")
        with thread_limit(threads), _reporting(progress, plan) as report:
            dataset = _in_memory(plan, report)
            return dataset
    file = Path(out)
    if file.suffix not in (".zarr", ".nc"):
        raise InputError.of_field("out", str(file), ".zarr or .nc", rule="must end in")
    if file.suffix == ".nc" and file.exists():
        if not resume:
            raise InputError(f"{file} exists already: choose another name or remove it.")
        dataset = store.open_map(file)
        return dataset
    place = place_of(file)
    if place != file:  # netCDF is written at the end, all at once
        check_memory(plan.shape, 2 * kinds, "name a file that ends in .zarr")
    with thread_limit(threads), store.begun(place, plan, resume) as (plan, todo):
        with _reporting(progress, plan) as report:
            report(_cells_of(plan, set(range(plan.parts)) - todo))
            if clustered:
                from hophoop.maps.grid.distributed import compute_on_cluster

                compute_on_cluster(place, sorted(todo), scheduler, workers, report)
            else:
                for index in sorted(todo):
                    report(store.compute_chunk(str(place), index))
        store.finish(place, plan)
    if file.suffix == ".nc":
        _to_netcdf(place, file)
    dataset = store.open_map(file)
    return dataset


def place_of(file: Path) -> Path:
    """Return where the chunks of a map are written while it is computed.

    Parameters
    ----------
    file : Path
        The map's file, ending in .zarr or .nc.

    Returns
    -------
    place : Path
        The Zarr store itself, or one next to the netCDF file.
    """
    return file if file.suffix == ".zarr" else file.with_name(f"{file.name}.part.zarr")


def _cells_of(plan: Plan, indices: set[int]) -> int:
    return sum(int(np.prod(plan.part(index).shape)) for index in indices)


def _in_memory(plan: Plan, report: Callable[[int], None]) -> Any:
    arrays = {
        quantity.name: np.empty(plan.shape, np.int32 if quantity.name == "sequence" else quantity.dtype)
        for quantity in plan.quantities
    }
    seen: dict[tuple[int, ...], int] = {}
    for index in range(plan.parts):
        chunk, results = run_chunk(plan, index)
        for quantity in plan.quantities:
            if quantity.name == "sequence":
                for key in distinct(results.sequences):
                    seen.setdefault(key, len(seen))
                values = encode(results.sequences, seen)
            else:
                values = values_of(results, quantity)
            arrays[quantity.name][chunk.region] = values.reshape(chunk.shape)
        report(int(np.prod(chunk.shape)))
    names, codes = table_of(seen)
    if "sequence" in arrays:
        table = np.array([codes[key] for key in seen], np.int16 if len(names) <= store.MOST_SHORT_CODES else np.int32)
        arrays["sequence"] = table[arrays["sequence"]]
    xarray = need("xarray", "maps")
    paths = [axis.path for axis in plan.axes]
    return xarray.Dataset(
        {quantity.name: (paths, arrays[quantity.name], attributes(quantity, names)) for quantity in plan.quantities},
        {
            axis.path: (
                axis.path,
                axis.values,
                {"long_name": axis.description} | ({"units": axis.unit} if axis.unit else {}),
            )
            for axis in plan.axes
        },
        store.provenance(plan),
    )


def _to_netcdf(place: Path, file: Path) -> None:
    need("netCDF4", "maps")
    dataset = need("xarray", "maps").open_zarr(str(place), chunks=None, consolidated=False)
    with replacing(file) as fresh:
        with netcdf_errors(fresh):
            dataset.to_netcdf(fresh, engine="netcdf4")
        seal(fresh)
    store.remove(place)


@contextmanager
def _reporting(progress: bool | Progress, plan: Plan) -> Iterator[Callable[[int], None]]:
    """Context that gives one function to call with the number of cells just done, for a bar, a callable or neither."""
    total, done = int(np.prod(plan.shape)), 0
    with bar("cells", quiet=progress is not True, rate=True) as shown:
        report = progress if callable(progress) else shown

        def add(cells: int) -> None:
            nonlocal done
            done += cells
            if report is not None:
                report(done, total)

        yield add
