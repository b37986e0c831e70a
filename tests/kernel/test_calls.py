"""Arguments are packed into plain memory as the library's functions read it, and results come back from there."""

import ctypes
import struct
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from hophoop.kernel.native.calls import caller

EVENT = np.dtype([("t", "<f8"), ("kind", "<i8")])
REALS, TABLE = {"array": ["<f8", 1]}, {"array": ["<f8", 2]}
EVENTS = {"array": [EVENT.descr, 1]}


def function(action):
    """A function of the library's kind, which Python carries out with the words of eight bytes that it is given."""
    kind = ctypes.CFUNCTYPE(ctypes.c_int32, *[ctypes.c_void_p] * 3)
    return kind(lambda place, *same: action((ctypes.c_uint8 * 4096).from_address(place)) or 0)


def words(memory, codes, begin=0):
    return struct.unpack_from("=" + codes, bytes(memory), 8 * begin)


def test_an_array_is_its_address_and_its_shape():
    seen = []
    kinds = [{"items": [REALS, TABLE]}, EVENTS, REALS]
    call = caller(function(lambda memory: seen.append(words(memory, "qqqqqqqqq"))), kinds, None)
    for size in range(3, 20):  # a pair of arrays may have the place in memory of an earlier one
        pair, events, empty = (np.arange(float(size)), np.zeros((2, 5))), np.zeros(4, EVENT), np.empty(0)
        assert call(pair, events, empty) is call(pair, events, empty) is None
        at = [array.ctypes.data for array in (*pair, events, empty)]
        assert seen[-2:] == [(at[0], size, at[1], 2, 5, at[2], 4, at[3], 0)] * 2


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
