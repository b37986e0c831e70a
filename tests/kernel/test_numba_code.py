"""What Numba compiles of a kernel: the names that it calls, and whether arrays are made."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.native import inline, interpreted_as, noinline
from hophoop.kernel.native.marks import mark_of, source_of
from hophoop.kernel.numerics import circular, collocation
from hophoop.kernel.physics.body import Status
from hophoop.kernel.records.layout import EVENT, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid import run as kernel

pytest.importorskip("numba")
from hophoop.kernel.build import numba_code
from hophoop.kernel.build.numba_code import Namespaces, called, makes_arrays, options_of
from numba_tools import jitted


def by_python(value):
    return ("python", value)


@interpreted_as(by_python)
@inline
def by_loops(value, more=2):
    """Documented."""
    return ("loops", value, more)


@noinline
def long_one(value):
    return by_loops(value)


def empty_row(count):
    return np.empty(count)


def filled(row):
    row[1:3] = 0.0


def stepped(row):
    row[::2] = row[1::2]


def item_set(row, k):
    row[k] = row[k + 1]


def viewed(row):
    return row[1:3].sum()


def caller_of_filled(row):
    filled(row)


@pytest.fixture
def as_kernels(monkeypatch):
    """The functions of this module are kernels."""
    real = numba_code.is_kernel
    monkeypatch.setattr(numba_code, "is_kernel", lambda value: real(value) or getattr(value, "__module__", None) == __name__)
    makes_arrays.cache_clear()
    yield
    makes_arrays.cache_clear()


def test_a_mark_is_that_of_what_is_compiled():
    assert (mark_of(by_loops), mark_of(long_one), mark_of(filled)) == ("inline", "noinline", "")


def test_python_runs_the_other_function_under_the_name_of_the_kernel():
    assert by_loops(1) == ("python", 1)
    assert source_of(by_loops)(1) == ("loops", 1, 2)
    assert source_of(long_one) is long_one
    assert (by_loops.__name__, by_loops.__module__, by_loops.__doc__) == ("by_loops", __name__, "Documented.")
    assert by_python(1) == ("python", 1)
    assert source_of(by_python) is by_python


def test_it_is_compiled_with_what_it_calls(as_kernels):
    assert called(long_one) == [by_loops]
    made = {}

    def make(kernel, function):
        made[kernel] = function
        return lambda *arguments: (kernel.__name__, function(*arguments))

    names = Namespaces(make)
    assert names.of(long_one)(5) == ("long_one", ("by_loops", ("loops", 5, 2)))
    assert names.of(long_one) is names.of(long_one)
    assert set(made) == {long_one, by_loops}
    assert long_one(5) == ("python", 5)  # the module's own names are as before


@pytest.mark.parametrize(
    ("function", "expected"),
    [
        (empty_row, True), (filled, True), (stepped, True), (caller_of_filled, True), (item_set, False), (viewed, False),
        (by_loops, False),
    ],
)  # fmt: skip
def test_whether_references_are_counted(as_kernels, function, expected):
    """To assign to a slice copies: without counted references that ended the process."""
    assert makes_arrays(function) == expected
    assert options_of(function).get("_nrt", True) == expected


def test_options():
    assert options_of(by_loops)["forceinline"]
    assert not options_of(long_one)["forceinline"]
    assert options_of(kernel.step)["error_model"] == "numpy"


def test_a_dispatcher_has_the_bits_of_the_interpreter():
    compiled = jitted(circular.sine_and_cosine)
    assert jitted(circular.sine_and_cosine) is compiled
    for angle in np.random.default_rng(5).uniform(-50.0, 50.0, 200).tolist():
        assert compiled(angle) == circular.sine_and_cosine(angle)


def test_a_dispatcher_is_made_of_the_loops():
    row = np.random.default_rng(6).normal(size=collocation.ORDER)
    found, expected = np.empty((2, collocation.ORDER))
    jitted(collocation.product)(collocation.SERIES_T, row, found)
    source_of(collocation.product)(collocation.SERIES_T, row, expected)
    assert found.tobytes() == expected.tobytes()


@pytest.mark.slow
def test_a_dispatcher_of_motions_has_their_bits():
    scenario = hh.Scenario(duration=2.0)
    motion = hh.simulate(scenario)
    events, segments = np.zeros(64, EVENT), np.zeros(256, SEGMENT)
    start = start_state(0.0, 0.0, 0.0, 0.0, 0.0, 3.1 * motion.units.time)
    end = scenario.duration / motion.units.time
    status, count, pieces = jitted(kernel.run)(
        scenario.to_body(), start, kernel.BY_RULE, end, math.nan, 0, events, segments, new_scratch()
    )
    assert status == Status.COMPLETED
    assert events[:count].tobytes() == motion.tables["events"].tobytes()
    assert segments[:pieces].tobytes() == motion.tables["segments"].tobytes()
