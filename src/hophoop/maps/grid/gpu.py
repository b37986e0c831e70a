"""Cells on a CUDA GPU: one thread per cell, with the CPU's kernel functions, compiled by Numba."""

from __future__ import annotations

import sys
import warnings
from importlib.util import find_spec

import numpy as np
from numpy.typing import NDArray

from hophoop.kernel.records.layout import EVENT, MAX_EVENTS, SEGMENT, MapRequest, MapResults
from hophoop.maps.grid.kernel import FIRST_EVENTS, MORE_EVENTS
from hophoop.scenario import InputError

THREADS_PER_BLOCK = 64
# Maximum memory on the device for events, in addition to the cells and their results [bytes].
MEMORY = 2**30
CELLS_PER_BATCH = 2**18


def require_gpu() -> None:
    """Refuse `device='gpu'`, with the reason, where there is no GPU to use.

    Raises
    ------
    ValueError
        If numba-cuda is missing, or there is no CUDA GPU with its driver.
    """
    if find_spec("numba") is not None:
        from numba.core import config

        if config.ENABLE_CUDASIM:  # Numba's simulator, which the tests use
            return
    if find_spec("numba_cuda") is None:
        raise InputError(
            "device = 'gpu' needs a CUDA GPU with its driver, and numba-cuda, which is not installed; it comes with "
            "the extra 'gpu': pip install \"hophoop[gpu]\". Or use 'cpu'.",
            field="device",
            value="gpu",
        )
    from numba import cuda

    if not cuda.is_available():
        raise InputError(
            "device = 'gpu' needs a CUDA GPU with its driver, and there is none: use 'cpu'.", field="device", value="gpu"
        )


def evaluate(cells: NDArray[np.float64], request: MapRequest, results: MapResults) -> None:
    """Compute all cells, in batches that fit into the device's memory; as `kernel.evaluate_block`.

    Parameters
    ----------
    cells : ndarray, shape (len(CELL), n)
        [SI].
    request : MapRequest
    results : MapResults
        With n rows; filled.
    """
    for low in range(0, cells.shape[1], CELLS_PER_BATCH):
        part = slice(low, low + CELLS_PER_BATCH)
        _evaluate_batch(cells[:, part], request, MapResults(*(table[part] for table in results)))


def _evaluate_batch(cells: NDArray[np.float64], request: MapRequest, hosts: MapResults) -> None:
    from numba import cuda

    from hophoop.maps.grid.gpu_kernel import FLIGHT_EVENTS, kernel

    if not getattr(kernel, "overloads", True):  # the simulator compiles nothing
        print("hophoop compiles its kernel for the GPU; this takes minutes, once a process.", file=sys.stderr)
    count = cells.shape[1]
    on_device = cuda.to_device(np.ascontiguousarray(cells))
    results = MapResults(*(cuda.device_array(host.shape, host.dtype) for host in hosts))
    segments = cuda.device_array(1, SEGMENT)
    memory = min(MEMORY, cuda.current_context().get_memory_info().free / 2)
    todo = np.arange(count, dtype=np.int64)
    most = int(cells[MAX_EVENTS].max(initial=1))
    length = min(FIRST_EVENTS, most)
    while todo.size:
        threads = max(1, min(todo.size, int(memory / ((length + FLIGHT_EVENTS) * EVENT.itemsize))))
        events = cuda.device_array((threads, length + FLIGHT_EVENTS), EVENT)
        left = []
        for first in range(0, todo.size, threads):
            these = todo[first : first + threads]
            finished = cuda.device_array(these.size, np.int8)
            with warnings.catch_warnings():
                # ignore Numba's warning about small grids
                warnings.filterwarnings("ignore", "Grid size")
                kernel[-(-these.size // THREADS_PER_BLOCK), THREADS_PER_BLOCK](
                    on_device, cuda.to_device(these), request, events, segments, results, finished
                )
            left.append(these[finished.copy_to_host() == 0])
        todo = np.concatenate(left)
        length = min(MORE_EVENTS * length, most)
    for host, found in zip(hosts, results, strict=True):
        host[:] = found.copy_to_host()
