"""Chunks of a map, each computed and written by one task: on threads of this machine, or on a Dask cluster."""

from __future__ import annotations

import platform
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import CancelledError, Executor, ThreadPoolExecutor
from contextlib import contextmanager
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING, Any

import numpy as np

from hophoop._support.extras import need
from hophoop.kernel.native.sources import stamp
from hophoop.maps.grid.cells import make_cells
from hophoop.maps.grid.evaluate import Plan, Region, cores, run_cells, values_of
from hophoop.maps.grid.quantities import flags_of
from hophoop.scenario import InputError

if TYPE_CHECKING:
    from distributed import Client

Report = Callable[[int], None]

WAVE = 1024  # chunks that a cluster knows at a time, so that its memory does not grow with the map
AT_ONCE = 2  # chunks in memory of this machine: threads compute cells of one while others are prepared and written
RETRIES = 2  # of a chunk after an error of its own; Dask handles the death of a worker
PATIENCE = 10  # timeout of an answer [s]


def compute_chunk(
    plan: Plan, targets: Mapping[str, Any], region: Region, pool: Executor | None = None, sources: str = ""
) -> int:
    """Compute a chunk and write it; return its number of cells.

    targets: of each quantity, an array; sequences are written packed into integers; region: the cells of the chunk;
    sources: stamp of the kernels to be used.
    """
    if sources and stamp() != sources:
        raise OSError(
            f"A worker on {platform.node()} has kernels of other sources ({stamp()[:8]}, here {sources[:8]}): "
            "install the same version of hophoop there."
        )
    sides = [values[part] for values, part in zip(plan.axes.values(), region, strict=True)]
    grid = np.meshgrid(*sides, indexing="ij")
    values = dict(zip(plan.axes, map(np.ravel, grid), strict=True))
    results = run_cells(make_cells(plan.base, values, grid[0].size), plan.span, flags_of(plan.quantities), pool)
    for quantity in plan.quantities:
        found = values_of(results, quantity)
        targets[quantity.name][region] = found.reshape(*grid[0].shape, *found.shape[1:])
    return grid[0].size


def compute_on_threads(
    plan: Plan, targets: Mapping[str, Any], todo: Iterable[Region], threads: int | None, report: Report
) -> None:
    """Compute chunks on threads of this process; `report` is called with the number of cells of each one."""
    with ThreadPoolExecutor(AT_ONCE) as chunks, ThreadPoolExecutor(threads or cores()) as pool:
        try:
            for cells in chunks.map(lambda region: compute_chunk(plan, targets, region, pool), todo):
                report(cells)
        except BaseException:  # Ctrl-C included: only the cells that are being computed end
            for executor in (chunks, pool):
                executor.shutdown(wait=False, cancel_futures=True)
            raise


def compute_on_cluster(
    plan: Plan, targets: Mapping[str, Any], todo: Iterable[Region], scheduler: str | Client, report: Report
) -> None:
    """Compute chunks on the workers of a cluster, which must see the store of the targets under the same name."""
    as_completed = need("distributed", "cluster").as_completed
    compute, left = partial(compute_chunk, plan, targets, sources=stamp()), iter(todo)
    with _client(scheduler) as client:
        try:
            while wave := list(islice(left, WAVE)):
                for future in as_completed(client.map(compute, wave, pure=False, retries=RETRIES)):
                    report(future.result())
        except (OSError, CancelledError) as error:
            # it may be an error of a worker, such as a full disk
            if _answers(client):
                raise
            raise OSError(
                f"The scheduler at {client.scheduler.address} is gone; finished chunks are kept, and resume continues."
            ) from error


def check_address(scheduler: str) -> None:
    """Refuse what is no address, before a client exists, which would stay Dask's default scheduler."""
    try:
        need("distributed.comm", "cluster").get_address_host_port(scheduler)
    except ValueError as error:
        raise InputError.of_field("scheduler", scheduler, f"an address such as tcp://host:8786: {error}") from None


@contextmanager
def _client(scheduler: str | Client) -> Iterator[Client]:
    client = need("distributed", "cluster").Client
    if isinstance(scheduler, client):
        with scheduler.as_current():
            yield scheduler
        return
    with client(scheduler, timeout=PATIENCE) as connected:
        connected.wait_for_workers(1, timeout=6 * PATIENCE)
        yield connected


def _answers(client: Client) -> bool:
    try:
        client.sync(client.scheduler.identity, callback_timeout=PATIENCE)
    except (OSError, CancelledError, AttributeError):
        return False
    return True
