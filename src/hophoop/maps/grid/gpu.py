"""Cells on a CUDA GPU: one thread a cell, by the kernel functions that the CPU runs, compiled by Numba for it."""

from __future__ import annotations

import sys
import warnings
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.kernel.records.layout import EVENT, MAX_EVENTS, SEGMENT
from hophoop.maps.grid.kernel import FIRST_EVENTS, MORE_EVENTS
from hophoop.scenario import InputError

THREADS_A_BLOCK = 64
# Most memory on the device for events, beside what the cells and their results take [bytes].
MEMORY = 2**30
CELLS_A_BATCH = 2**18


def require_gpu() -> None:
    """Refuse `device='gpu'` with the reason where it cannot be had.

    Raises
    ------
    ValueError
        If numba-cuda is missing, or there is no CUDA GPU with its driver.
    """
    from numba.core import config

    if config.ENABLE_CUDASIM:  # Numba's simulator, which the tests use
        return
    if find_spec("numba_cuda") is None:
        raise InputError(
            "device = 'gpu' needs a CUDA GPU with its driver, and numba-cuda, which is not installed; it comes with "
            "the extra 'gpu': pip install 'hophoop[gpu]'. Or use 'cpu'.",
            field="device",
            value="gpu",
        )
    from numba import cuda

    if not cuda.is_available():
        raise InputError(
            "device = 'gpu' needs a CUDA GPU with its driver, and there is none: use 'cpu'.", field="device", value="gpu"
        )


def evaluate(
    cells: NDArray[np.float64],
    angle_span: float,
    stop: int,
    timed: bool,
    wanted: int,
    numbers: NDArray[np.float64],
    words: NDArray[np.int32],
    keys: NDArray[np.uint64],
) -> None:
    """All cells, in batches that fit into the device's memory; as `kernel.evaluate_block`.

    Parameters
    ----------
    cells : ndarray, shape (len(CELL), n)
        [SI].
    angle_span, stop, timed, wanted
        As for `kernel.evaluate_block`.
    numbers, words, keys : ndarray, shape (n, …)
        Filled.
    """
    options = angle_span, stop, timed, wanted
    for low in range(0, cells.shape[1], CELLS_A_BATCH):
        part = slice(low, low + CELLS_A_BATCH)
        _evaluate_batch(cells[:, part], options, [numbers[part], words[part], keys[part]])


def _evaluate_batch(cells: NDArray[np.float64], options: tuple[float, int, bool, int], hosts: list[NDArray[Any]]) -> None:
    from numba import cuda

    from hophoop.maps.grid.gpu_kernel import FLIGHT_EVENTS, kernel

    if not getattr(kernel, "overloads", True):  # the simulator compiles nothing
        print("hophoop compiles its kernel for the GPU; this takes minutes, once a process.", file=sys.stderr)
    count = cells.shape[1]
    on_device = cuda.to_device(np.ascontiguousarray(cells))
    results = [cuda.device_array(host.shape, host.dtype) for host in hosts]
    segments = cuda.device_array(1, SEGMENT)
    memory = min(MEMORY, cuda.current_context().get_memory_info().free / 2)
    todo = np.arange(count, dtype=np.int64)
    most = int(cells[MAX_EVENTS].max(initial=1))
    room = min(FIRST_EVENTS, most)
    while todo.size:
        threads = max(1, min(todo.size, int(memory / ((room + FLIGHT_EVENTS) * EVENT.itemsize))))
        events = cuda.device_array((threads, room + FLIGHT_EVENTS), EVENT)
        left = []
        for first in range(0, todo.size, threads):
            these = todo[first : first + threads]
            finished = cuda.device_array(these.size, np.int8)
            with warnings.catch_warnings():
                # of few cells: that they do not fill the GPU is no news
                warnings.filterwarnings("ignore", "Grid size")
                kernel[-(-these.size // THREADS_A_BLOCK), THREADS_A_BLOCK](
                    on_device, cuda.to_device(these), *options, events, segments, *results, finished
                )
            left.append(these[finished.copy_to_host() == 0])
        todo = np.concatenate(left)
        room = min(MORE_EVENTS * room, most)
    for host, found in zip(hosts, results, strict=True):
        host[:] = found.copy_to_host()
