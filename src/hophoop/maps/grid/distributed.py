"""Sweep on a Dask cluster: workers compute chunks and write them into the store themselves."""

from __future__ import annotations

import contextlib
import logging
import multiprocessing
import platform
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError
from multiprocessing import util
from pathlib import Path
from typing import Any

from hophoop._support.extras import need
from hophoop._support.stopping import ignored_by_children, temporary_folder
from hophoop.kernel.native.sources import stamp
from hophoop.maps.grid.store import compute_chunk
from hophoop.scenario import InputError

# Chunks queued at the scheduler per thread of the cluster, so that its memory does not grow with the map.
WAITING = 4
# Retries of a chunk after an error of its own; Dask handles the death of a worker.
RETRIES = 2
# Timeout of an answer [s].
PATIENCE = 10


def compute_on_cluster(
    path: Path,
    indices: Sequence[int],
    scheduler: str | None,
    workers: int | None,
    report: Callable[[int], None],
) -> None:
    """Compute chunks on the workers of a cluster; the marks in the store list the finished ones.

    Parameters
    ----------
    path : Path
        The store, which the workers see under the same name.
    indices : sequence of int
        Chunks to compute.
    scheduler : str or None
        Address of a running scheduler; None starts a cluster on this machine.
    workers : int or None
        How many processes the cluster on this machine has.
    report : callable
        Called with the cells of every chunk that is done.

    Raises
    ------
    InputError
        If it is not an address.
    OSError
        If no scheduler answers at that address, or it disappears before the end.
    """
    need("distributed", "cluster")
    place = str(path.resolve())
    with _client(scheduler, workers) as client:
        as_completed = need("distributed", "cluster").as_completed
        queue = iter(indices)
        running = as_completed(raise_errors=True)

        # one thread per worker: the cluster runs in parallel
        def submit() -> None:
            index = next(queue, None)
            if index is not None:
                running.add(client.submit(_compute, place, index, stamp(), pure=False, retries=RETRIES))

        try:
            for _ in range(WAITING * max(1, sum(client.nthreads().values()))):
                submit()
            for future in running:
                report(future.result())
                future.release()
                submit()
        except (OSError, CancelledError) as error:
            # it may be an error of a worker, such as a full disk
            if _answers(client):
                raise
            raise OSError(
                f"The scheduler at {client.scheduler.address} is gone; finished chunks are kept, and resume continues."
            ) from error


def _compute(place: str, index: int, sources: str) -> int:
    """Compute a chunk on a worker, which must have the same kernels as this process."""
    own = stamp()
    if own != sources:
        raise OSError(
            f"A worker on {platform.node()} has kernels of other sources ({own[:8]}, here {sources[:8]}): "
            "install the same version of hophoop there."
        )
    return compute_chunk(place, index, serial=True)


def _answers(client: Any) -> bool:
    try:
        client.sync(client.scheduler.identity, callback_timeout=PATIENCE)
    except (OSError, CancelledError, AttributeError):
        return False
    return True


@contextlib.contextmanager
def _client(scheduler: str | None, workers: int | None) -> Iterator[Any]:
    distributed = need("distributed", "cluster")
    if scheduler is not None:
        try:
            connected = distributed.Client(scheduler, timeout=PATIENCE)
        except ValueError as error:  # Dask's error for an invalid address
            raise InputError.of_field("scheduler", scheduler, f"an address such as tcp://host:8786: {error}") from None
        with connected as client:
            client.wait_for_workers(1, timeout=6 * PATIENCE)
            yield client
        return
    others, cluster = set(multiprocessing.active_children()), None
    with temporary_folder() as scratch, contextlib.ExitStack() as stack:
        stack.enter_context(need("dask.config", "cluster").set({"temporary-directory": str(scratch)}))
        # any free port, also next to another cluster
        options = {"threads_per_worker": 1, "dashboard_address": None, "scheduler_kwargs": {"dashboard_address": ":0"}}
        try:
            with ignored_by_children():
                cluster = stack.enter_context(distributed.LocalCluster(n_workers=0, processes=True, **options))
            cluster.scale(workers)
            client = stack.enter_context(distributed.Client(cluster))
            client.wait_for_workers(workers)
            yield client
        except KeyboardInterrupt:
            stack.pop_all()  # closing a busy cluster takes seconds and prints many lines
            if cluster is not None:
                _kill(cluster, others)
            raise


def _kill(cluster: Any, others: set[Any]) -> None:
    """End the workers of a cluster at once and silently."""
    logging.disable()
    frozen = threading.Event()

    def freeze() -> None:
        frozen.set()
        time.sleep(60.0)

    cluster.loop.add_callback(freeze)  # or it starts replacements
    frozen.wait(1.0)
    for process in set(multiprocessing.active_children()) - others:
        process.kill()
        process.join()
    # or a process of multiprocessing reports them as leaked
    util._run_finalizers(0)  # type: ignore[attr-defined]
