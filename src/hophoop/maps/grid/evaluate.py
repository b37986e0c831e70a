"""Plan of a map, calls of its kernel, and scattered points."""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import nullcontext
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support.errors import check_type
from hophoop._version import __version__
from hophoop.kernel.native import compiled
from hophoop.kernel.records import MapRequest, MapResults
from hophoop.kernel.steps import RESOLVED
from hophoop.maps.grid import kernel
from hophoop.maps.grid.axes import Axes, checked_values, chunk_shape, make_axes
from hophoop.maps.grid.cells import make_cells
from hophoop.maps.grid.quantities import Quantity, Span, choose, distinct_sequences, flags_of
from hophoop.maps.grid.settled import evaluate_settled
from hophoop.scenario import InputError, Scenario
from hophoop.vocabulary.names import SEQUENCE

Region = tuple[slice, ...]

CHUNK_CELLS = 65536
CALL_CELLS = 512  # per call of the kernel: a call takes as long as 2 cells, and a thread stops after one


def values_of(results: MapResults, quantity: Quantity) -> NDArray[Any]:
    """Values of one quantity; sequences are packed, shape (n, INTEGERS)."""
    if quantity.name == SEQUENCE:
        return np.asarray(results.sequences)
    source = results.words if quantity.is_code else results.numbers
    values: NDArray[Any] = source[:, quantity.column].astype(quantity.dtype)
    return values


class Plan(NamedTuple):
    """Specification of a map: everything its content depends on."""

    base: Scenario
    axes: Axes
    quantities: tuple[Quantity, ...]
    span: Span
    chunk: tuple[int, ...]

    @property
    def shape(self) -> tuple[int, ...]:
        """Cells along each axis."""
        return tuple(values.size for values in self.axes.values())

    def regions(self) -> Iterator[Region]:
        """Iterate over the cells of each chunk."""
        sides = zip(self.shape, self.chunk, strict=True)
        return itertools.product(*([slice(i, min(i + step, n)) for i in range(0, n, step)] for n, step in sides))

    def to_dict(self) -> dict[str, Any]:
        """Return the plan for JSON, with the version; equal plans have equal texts."""
        return {
            "hophoop": __version__,
            "tolerance": RESOLVED,
            "scenario": self.base.to_dict(),
            # JSON has no infinity; NumPy reads the word back as a number
            "axes": {
                path: ["inf" if value == np.inf else value for value in values.tolist()] for path, values in self.axes.items()
            },
            "quantities": [quantity.name for quantity in self.quantities],
            "span": self.span.name,
        }


def make_plan(
    base: Scenario | None,
    axes: Mapping[str, ArrayLike],
    quantities: Sequence[str],
    span: str,
    chunk_cells: int = CHUNK_CELLS,
) -> Plan:
    """Check the arguments of a map and return its plan; chunks have at most `chunk_cells` cells."""
    base = Scenario() if base is None else base
    if chunk_cells < 1:
        raise InputError.of_field("chunk_cells", chunk_cells, "at least 1")
    check_type("axes", axes, Mapping)
    made = make_axes(base, axes)
    chunk = chunk_shape([values.size for values in made.values()], chunk_cells)
    return Plan(base, made, *choose(base, quantities, span), chunk)


def run_cells(cells: NDArray[np.float64], span: Span, flags: int, pool: Executor | None = None) -> MapResults:
    """Run the kernel on all cells, shape (len(CELL), n) in SI units, on the threads of `pool` or on this one.

    flags: of the quantities that the kernel computes on request only.
    """
    count = cells.shape[1]
    results = MapResults(
        np.empty((count, len(kernel.NUMBERS))),
        np.empty((count, len(kernel.WORDS)), np.int32),
        np.empty((count, kernel.INTEGERS), np.uint64),
    )
    evaluate: Any = evaluate_settled if span.settled else compiled(kernel.evaluate_block)
    request = span.name if span.settled else MapRequest(span.angle, span.stop, span.timed, flags)
    step = kernel.BLOCK if span.settled else CALL_CELLS

    def run(low: int) -> None:
        evaluate(cells, low, min(low + step, count), request, results)

    for _ in (map if pool is None else pool.map)(run, range(0, count, step)):
        pass
    return results


def cores() -> int:
    """Number of cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


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
        If a parameter, a quantity or the span is unknown, or a value outside the range of its parameter.

    Examples
    --------
    >>> points(None, {"start.speed": [0.1, 2.8, 3.1, 5.0]})["sequence"].tolist()
    ['R', 'RKRSR', 'RKRSH', 'H']
    """
    base = Scenario() if base is None else base
    check_type("values", values, Mapping)
    arrays = checked_values(base, values)
    try:
        spread = np.broadcast_arrays(*arrays.values())
    except ValueError:
        shapes = ", ".join(f"{path} {array.shape}" for path, array in arrays.items())
        raise InputError(f"values have shapes that do not broadcast: {shapes}.") from None
    shape = spread[0].shape if spread else (1,)
    cells = make_cells(base, {path: array.reshape(-1) for path, array in zip(arrays, spread, strict=True)}, math.prod(shape))
    chosen, part = choose(base, quantities, span)
    few = cells.shape[1] <= CALL_CELLS  # not worth the threads
    with nullcontext() if few else ThreadPoolExecutor(cores()) as pool:
        found = run_cells(cells, part, flags_of(chosen), pool)
    results = {}
    for quantity in chosen:
        words: Sequence[str] = quantity.words
        column = values_of(found, quantity)
        if quantity.name == SEQUENCE:
            words, column = distinct_sequences(column)
        results[quantity.name] = (np.array([*words, ""])[column] if quantity.is_code else column).reshape(shape)
    return results
