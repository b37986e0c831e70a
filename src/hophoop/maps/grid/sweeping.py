"""Sweep a grid of scenarios: in memory or into a file, on threads of this machine or a cluster."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support.checksum import seal
from hophoop._support.extras import need
from hophoop._support.files import netcdf_errors, replacing
from hophoop._support.progress import bar
from hophoop._support.stopping import remove
from hophoop.maps.grid import store
from hophoop.maps.grid.chunks import check_address, compute_on_cluster, compute_on_threads
from hophoop.maps.grid.evaluate import CHUNK_CELLS, Plan, Region, cores, make_plan
from hophoop.maps.grid.memory import check_memory
from hophoop.maps.grid.quantities import Quantity, codes_of, distinct_sequences, encode, sequences_with
from hophoop.scenario import InputError, Scenario
from hophoop.vocabulary.names import SEQUENCE

if TYPE_CHECKING:
    import xarray
    from distributed import Client

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
    scheduler: str | Client | None = None,
    progress: bool | Progress = False,
    chunk_cells: int = CHUNK_CELLS,
) -> xarray.Dataset:
    """Compute a map: reduced quantities of the motion in every cell of a grid of scenarios.

    Parameters
    ----------
    base : Scenario, optional
        The scenario to vary; by default the reference hoop.
    axes : mapping of str to array_like
        Parameters by their path, such as ``{"plane.mu": …, "start.speed": …}``, each with its
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
    scheduler : str or distributed.Client, optional
        A Dask cluster to compute on instead, or the address of its scheduler, such as ``"tcp://10.0.0.1:8786"``. Its workers
        must see `out`.
    progress : bool or callable, default False
        Show progress on standard error; a callable gets the number of cells done and of all cells.
    chunk_cells : int, default 65536
        Maximum number of cells computed and written at a time [1].

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
        If a library of the extra ``maps``, or for a cluster of ``cluster``, is missing.

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
        raise InputError("axes must name at least one parameter.")
    if scheduler is not None and out is None:
        raise InputError("out must name a file for a sweep over a cluster: the workers write into it.")
    if isinstance(scheduler, str):
        check_address(scheduler)
    if resume and out is None:
        raise InputError("out must name the file to resume.")
    if threads is not None and not 1 <= threads <= cores():
        raise InputError.of_field("threads", threads, f"from 1 to {cores()}")
    plan = make_plan(base, axes, quantities, span, chunk_cells)
    kinds = ["int32" if quantity.name == SEQUENCE else quantity.dtype for quantity in plan.quantities]
    if out is None:
        check_memory(plan.shape, kinds, "name a file that ends in .zarr with out, or take fewer values")
        with _reporting(progress, plan) as report:
            return _in_memory(plan, threads, report)
    file = Path(out)
    if file.suffix not in (".zarr", ".nc"):
        raise InputError.of_field("out", str(file), ".zarr or .nc", rule="must end in")
    if file.suffix == ".nc" and file.exists():
        if not resume:
            raise InputError(f"{file} exists already: choose another name or remove it.")
        return store.open_map(file)
    place = place_of(file)
    if place != file:  # netCDF is written at the end, all at once
        check_memory(plan.shape, 2 * kinds, "name a file that ends in .zarr")
    with store.begun(place, plan, resume, threads or cores()) as (plan, arrays, todo), _reporting(progress, plan) as report:
        left = sum(math.prod(part.stop - part.start for part in region) for region in todo)
        report(math.prod(plan.shape) - left)
        if todo and scheduler is None:
            compute_on_threads(plan, arrays, todo, threads, report)
        elif todo:
            compute_on_cluster(plan, arrays, todo, scheduler, report)
    if file.suffix == ".nc":
        _to_netcdf(place, file)
    return store.open_map(file)


def place_of(file: Path) -> Path:
    """Return where the chunks of a map are written: the Zarr store itself, or one next to the netCDF file."""
    return file if file.suffix == ".zarr" else file.with_name(f"{file.name}.part.zarr")


class _Sequences:
    """Sequences in memory: of each chunk its region, its distinct sequences, and of each cell the index among them."""

    def __init__(self) -> None:
        self.chunks: list[Any] = []

    def __setitem__(self, region: Region, keys: NDArray[np.uint64]) -> None:
        self.chunks.append((region, *distinct_sequences(keys)))

    def coded(self, shape: tuple[int, ...]) -> tuple[Quantity, NDArray[Any]]:
        """Return the quantity with all sequences, and the code of each cell."""
        codes = codes_of(text for _, texts, _ in self.chunks for text in texts)
        quantity = sequences_with(codes)
        found = np.empty(shape, quantity.dtype)
        for region, texts, place in self.chunks:
            found[region] = encode(texts, place, codes)
        return quantity, found


def _in_memory(plan: Plan, threads: int | None, report: Callable[[int], None]) -> xarray.Dataset:
    targets: dict[str, Any] = {
        quantity.name: _Sequences() if quantity.name == SEQUENCE else np.empty(plan.shape, quantity.dtype)
        for quantity in plan.quantities
    }
    compute_on_threads(plan, targets, plan.regions(), threads, report)
    pairs = ((quantity, targets[quantity.name]) for quantity in plan.quantities)
    arrays = dict(found.coded(plan.shape) if isinstance(found, _Sequences) else (quantity, found) for quantity, found in pairs)
    return store.dataset_of(plan, arrays)


def _to_netcdf(place: Path, file: Path) -> None:
    need("netCDF4", "maps")
    dataset = store.opened(place)
    with replacing(file) as fresh:
        with netcdf_errors(fresh):
            dataset.to_netcdf(fresh, engine="netcdf4")
        seal(fresh)
    remove(place)


@contextmanager
def _reporting(progress: bool | Progress, plan: Plan) -> Iterator[Callable[[int], None]]:
    """Context that gives one function to call with the number of cells just done, for a bar, a callable or neither."""
    total, done = math.prod(plan.shape), 0
    with bar("cells", quiet=progress is not True, rate=True) as shown:
        report = progress if callable(progress) else shown

        def add(cells: int) -> None:
            nonlocal done
            done += cells
            if report is not None:
                report(done, total)

        yield add
