"""Running cells: what a plan is, one chunk of it, and scattered points."""

from __future__ import annotations

import contextlib
import json
import os
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextvars import ContextVar
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._version import __version__
from hophoop.kernel.native import compiled
from hophoop.kernel.panels.panel import RESOLVED
from hophoop.kernel.records.layout import MapRequest, MapResults, unpacked_sequence
from hophoop.maps.grid import kernel
from hophoop.maps.grid.axes import (
    Axis,
    Chunk,
    chunk_at,
    chunk_count,
    chunk_shape,
    chunk_values,
    make_axes,
    ordered,
)
from hophoop.maps.grid.cells import make_cells
from hophoop.maps.grid.quantities import (
    Quantity,
    Span,
    check_span,
    choose_quantities,
    distinct_rows,
    flags_of,
    make_span,
)
from hophoop.maps.grid.settled import SPANS as SETTLED_SPANS
from hophoop.maps.grid.settled import check_settled, evaluate_settled
from hophoop.scenario import InputError, Scenario, parameter

CHUNK_CELLS = 65536


def values_of(results: MapResults, quantity: Quantity) -> NDArray[Any]:
    """Values of one quantity, except the sequence, which stays packed in `results.sequences`."""
    source = results.words if quantity.is_code else results.numbers
    values: NDArray[Any] = source[:, quantity.column].astype(quantity.dtype)
    return values


class Plan(NamedTuple):
    """Specification of a map: everything its content depends on."""

    base: Scenario
    axes: tuple[Axis, ...]
    quantities: tuple[Quantity, ...]
    span: Span
    chunk: tuple[int, ...]

    @property
    def shape(self) -> tuple[int, ...]:
        """Cells along each axis."""
        return tuple(axis.values.size for axis in self.axes)

    @property
    def parts(self) -> int:
        """Number of chunks."""
        return chunk_count(self.shape, self.chunk)

    def part(self, index: int) -> Chunk:
        """Return a chunk by its number."""
        return chunk_at(index, self.shape, self.chunk)

    def to_text(self) -> str:
        """Return the plan as JSON, with the version; equal plans have equal texts."""
        return json.dumps(
            {
                "hophoop": __version__,
                "tolerance": RESOLVED,
                "scenario": self.base.to_dict(),
                "axes": {axis.path: _json(axis.values) for axis in self.axes},
                "quantities": [quantity.name for quantity in self.quantities],
                "span": self.span.name,
                "chunk": list(self.chunk),
            }
        )

    @classmethod
    def from_text(cls, text: str) -> Plan:
        """Read `to_text` back."""
        data = json.loads(text)
        base = Scenario.from_dict(data["scenario"])
        axes = []
        for path, values in data["axes"].items():
            _, description, unit = parameter(path)
            axes.append(Axis(path, np.array(values, str if unit == "" else float), unit, description))
        return cls(
            base,
            tuple(axes),
            choose_quantities(data["quantities"]),
            make_span(data["span"], in_the_end=True),
            tuple(data["chunk"]),
        )


def _json(values: NDArray[Any]) -> list[Any]:
    # JSON has no infinity; NumPy reads the word back as a number
    return ["inf" if value == np.inf else value for value in values.tolist()]


def make_plan(
    base: Scenario | None,
    axes: Mapping[str, ArrayLike],
    quantities: Sequence[str],
    span: str,
    chunk_cells: int = CHUNK_CELLS,
) -> Plan:
    """Check the arguments of a map and return its plan.

    Parameters
    ----------
    base : Scenario or None
        None is the reference hoop.
    axes : mapping of str to array_like
        Values by path [SI].
    quantities : sequence of str
    span : str
    chunk_cells : int, default 65536
        Approximate number of cells computed and written at a time.

    Returns
    -------
    plan : Plan

    Raises
    ------
    ValueError
        If an argument is not allowed.
    """
    base = Scenario() if base is None else base
    if chunk_cells < 1:
        raise InputError.of_field("chunk_cells", chunk_cells, "at least 1")
    made = make_axes(base, axes)
    shape = tuple(axis.values.size for axis in made)
    chunk = chunk_shape(shape, chunk_cells)
    chosen, part = choose_quantities(quantities), make_span(span, in_the_end=True)
    _check_span(base, chosen, part)
    return Plan(base, made, chosen, part, chunk)


def _check_span(base: Scenario, quantities: Sequence[Quantity], span: Span) -> None:
    check_span(quantities, span)
    if span.name in SETTLED_SPANS:
        check_settled(base)


def run_cells(cells: NDArray[np.float64], span: Span, flags: int, *, serial: bool = False) -> MapResults:
    """Run the kernel on all cells.

    Parameters
    ----------
    cells : ndarray, shape (len(CELL), n)
        [SI].
    span : Span
    flags : int
        Flags of the quantities that the kernel computes on request only.
    serial : bool, default False
        Use this thread only, not all cores.

    Returns
    -------
    results : MapResults
    """
    count = cells.shape[1]
    request = _request(span, flags)
    results = _empty_results(count)
    if span.name in SETTLED_SPANS:
        _on_all_cores(count, lambda low, high: evaluate_settled(cells, low, high, span.name, results))
    elif serial:
        compiled(kernel.evaluate_block)(cells, 0, count, request, results)
    else:
        evaluate = compiled(kernel.evaluate_block)
        _on_all_cores(count, lambda low, high: evaluate(cells, low, high, request, results))
    return results


def _request(span: Span, flags: int) -> MapRequest:
    return MapRequest(span.angle, span.stop, span.timed, flags)


def _empty_results(count: int) -> MapResults:
    return MapResults(
        np.empty((count, len(kernel.NUMBERS))),
        np.empty((count, len(kernel.WORDS)), np.int32),
        np.empty((count, kernel.INTEGERS), np.uint64),
    )


def _on_all_cores(count: int, evaluate: Callable[[int, int], None]) -> None:
    """Compute blocks of cells on all threads; results do not depend on the thread."""
    begins = iter(range(0, count, kernel.BLOCK))
    lock = threading.Lock()

    def work() -> None:
        while True:
            with lock:
                low = next(begins, count)
            if low == count:
                return
            high = min(low + kernel.BLOCK, count)
            evaluate(low, high)

    threads = min(_threads.get() or cores(), -(-count // kernel.BLOCK))
    if threads <= 1:
        work()
        return
    with ThreadPoolExecutor(threads) as pool:
        try:
            for done in [pool.submit(work) for _ in range(threads)]:
                done.result()
        except BaseException:  # Ctrl-C included: the other threads end after their block
            with lock:
                begins = iter(())
            raise


def cores() -> int:
    """Number of cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def run_chunk(plan: Plan, index: int, *, serial: bool = False) -> tuple[Chunk, MapResults]:
    """Compute one chunk of a plan."""
    chunk = plan.part(index)
    values = chunk_values(plan.axes, chunk)
    cells = make_cells(plan.base, values, int(np.prod(chunk.shape)))
    flags = flags_of(plan.quantities)
    results = run_cells(cells, plan.span, flags, serial=serial)
    return chunk, results


def points(
    base: Scenario | None,
    values: Mapping[str, ArrayLike],
    quantities: Sequence[str] = ("sequence",),
    span: str = "first_revolution",
) -> dict[str, NDArray[Any]]:
    """Reduced quantities of many motions that form no grid.

    Parameters
    ----------
    base : Scenario or None
        What is varied; None is the reference hoop.
    values : mapping of str to array_like
        Values of the varied parameters by path, arrays that broadcast to one shape [SI].
    quantities : sequence of str
        As in `sweep`.
    span : str
        As in `sweep`.

    Returns
    -------
    results : dict of str to ndarray
        One array a quantity, in its unit of `QUANTITIES` [SI]; sequences and other codes as words, empty
        for a cell whose values do not go together.

    Raises
    ------
    ValueError
        If a parameter, a quantity or the span is unknown.

    Examples
    --------
    >>> points(None, {"start.speed": [0.1, 2.8, 3.1, 5.0]})["sequence"].tolist()
    ['R', 'RKRSR', 'RKRSH', 'H']
    """
    base = Scenario() if base is None else base
    chosen = choose_quantities(quantities)
    arrays = {}
    for path, array in values.items():
        info = parameter(path)
        arrays[path] = np.asarray(array, dtype=str if info.unit == "" else float)
    spread = np.broadcast_arrays(*arrays.values())
    shape = spread[0].shape if spread else (1,)
    flat = {path: array.reshape(-1) for path, array in zip(arrays, spread, strict=True)}
    count = int(np.prod(shape))
    arranged = {path: flat[path] for path in ordered(list(flat))}
    cells = make_cells(base, arranged, count)
    part = make_span(span, in_the_end=True)
    _check_span(base, chosen, part)
    # few points are not worth waking all threads
    raw = run_cells(cells, part, flags_of(chosen), serial=count <= kernel.BLOCK)
    results = {}
    for quantity in chosen:
        if quantity.name == "sequence":
            rows, place = distinct_rows(raw.sequences)
            column = np.array([unpacked_sequence(row) for row in rows], dtype=str)[place]
        else:
            column = values_of(raw, quantity)
            if quantity.words:
                column = np.array([*quantity.words, ""])[column]
        results[quantity.name] = column.reshape(shape)
    return results


_threads: ContextVar[int | None] = ContextVar("threads", default=None)


@contextlib.contextmanager
def thread_limit(threads: int | None) -> Iterator[None]:
    """Use so many threads within; None leaves the number as it is."""
    if threads is None:
        yield
        return
    if not 1 <= threads <= cores():
        raise InputError.of_field("threads", threads, f"from 1 to {cores()}")
    before = _threads.set(threads)
    try:
        yield
    finally:
        _threads.reset(before)
