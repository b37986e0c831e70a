"""Arguments are packed into plain memory as the library's functions read it, and results come back from there."""

from __future__ import annotations

import ctypes
import struct
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
import pytest

from hophoop.kernel.native.calls import caller

EVENT = np.dtype([("t", "<f8"), ("kind", "<i8")])
REALS, TABLE = {"array": ["<f8", 1]}, {"array": ["<f8", 2]}
EVENTS = {"array": [EVENT.descr, 1]}


class Pair(NamedTuple):
    first: float
    second: int


def function(action):
    """A function of the library's kind, which Python carries out with the words of eight bytes that it is given."""
    kind = ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.c_void_p] * 3)
    return kind(lambda place, *same: action((ctypes.c_uint8 * 4096).from_address(place)) or 0)


def words(memory, codes, begin=0):
    return struct.unpack_from("=" + codes, bytes(memory), 8 * begin)


def test_numbers_come_in_order_and_results_behind_them():
    seen = []

    def action(memory):
        seen.append(words(memory, "dqqd"))
        memory[32:64] = struct.pack("=ddqq", 2.5, -1.0, 7, 1)

    gives = {"class": None, "items": ["float", {"class": f"{__name__}.Pair", "items": ["float", "int"]}, "bool"]}
    call = caller(function(action), ["float", "int", "bool", {"items": ["float"]}], gives)
    assert call(1.5, -3, np.bool_(True), (0.25,)) == (2.5, Pair(-1.0, 7), True)
    assert call(1.5, 2**62, False, (np.float64(0.25),))[0] == 2.5
    assert seen == [(1.5, -3, 1, 0.25), (1.5, 2**62, 0, 0.25)]


def test_an_array_is_its_address_and_its_shape():
    seen = []
    arrays = (np.arange(3.0), np.zeros((2, 5)), np.zeros(4, EVENT), np.empty(0))
    call = caller(function(lambda memory: seen.append(words(memory, "qqqqqqqqq"))), [REALS, TABLE, EVENTS, REALS], None)
    assert call(*arrays) is None
    at = [array.ctypes.data for array in arrays]
    assert seen == [(at[0], 3, at[1], 2, 5, at[2], 4, at[3], 0)]


def test_what_it_writes_is_in_the_array():
    def action(memory):
        place, count = words(memory, "qq")
        (ctypes.c_double * count).from_address(place)[1] = 9.0

    target = np.zeros(3)
    caller(function(action), [REALS], None)(target)
    assert target.tolist() == [0.0, 9.0, 0.0]


def test_a_named_tuple_of_arrays_may_change():
    seen = []
    call = caller(function(lambda memory: seen.append(words(memory, "qqq"))), [{"items": [REALS, REALS]}], None)  # four words
    for _ in range(30):
        pair = (np.zeros(2), np.zeros(3))
        call(pair)
        call(pair)
        assert seen[-2] == seen[-1] == (pair[0].ctypes.data, 2, pair[1].ctypes.data)


@pytest.mark.parametrize(
    "array",
    [np.zeros(4)[::2], np.zeros((2, 2)), np.zeros(2, np.float32), np.zeros(2, np.int64), np.asfortranarray(np.zeros((3, 2)))],
)
def test_other_arrays_are_refused_and_nothing_is_called(array):
    called = []
    call = caller(function(called.append), [REALS], None)
    with pytest.raises(TypeError, match=f"no such array: {array.dtype} array of shape"):
        call(array)
    assert not called


def test_a_status_is_an_error():
    kind = ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.c_void_p] * 3)
    with pytest.raises(RuntimeError, match="status 3"):
        caller(kind(lambda *_: 3), ["float"], None)(1.0)


def test_threads_share_no_memory():
    ready = threading.Barrier(4)

    def action(memory):
        (given,) = words(memory, "d")
        ready.wait(60.0)
        memory[8:16] = struct.pack("=d", given + 0.5)

    call = caller(function(action), ["float"], "float")
    with ThreadPoolExecutor(4) as pool:
        assert list(pool.map(call, [1.0, 2.0, 3.0, 4.0])) == [1.5, 2.5, 3.5, 4.5]
