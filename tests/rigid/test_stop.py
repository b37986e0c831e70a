"""A motion that is computed can be stopped from another thread, and its budget is a number in memory."""

from __future__ import annotations

import threading
import time

import pytest

import hophoop as hh
from hophoop.records.scratch import MOST_PANELS, Stop, new_scratch, thread_scratch

LONG = hh.Scenario(duration=3e4)  # some hundred thousand panels


def test_the_budget_stands_in_memory() -> None:
    assert new_scratch().written[3] == MOST_PANELS


def test_a_budget_of_few_panels_gives_the_run_so_far() -> None:
    stop = Stop()
    whole = hh.simulate(hh.Scenario())
    with stop.guards():
        thread_scratch().written[3] = 20
        part = hh.simulate(hh.Scenario())
    assert part.status == "event_limit"
    assert 0.0 < part.duration < whole.duration
    count = len(part.events) - 1  # the last one is the end of what is computed
    assert [event.t for event in part.events[:count]] == [event.t for event in whole.events[:count]]
    assert hh.simulate(hh.Scenario()).events == whole.events  # nothing of it is left in this thread


def test_what_is_stopped_before_it_begins_does_nothing() -> None:
    stop = Stop()
    stop.stop()
    with stop.guards():
        assert hh.simulate(LONG).status == "event_limit"


@pytest.mark.compiled
def test_another_thread_stops_a_motion() -> None:
    hh.simulate(hh.Scenario())
    stop = Stop()
    found: list[hh.Trajectory] = []

    def compute() -> None:
        with stop.guards():
            found.append(hh.simulate(LONG))

    thread = threading.Thread(target=compute)
    thread.start()
    time.sleep(0.05)
    began = time.perf_counter()
    stop.stop()
    thread.join(30.0)
    print(f"stopped after {time.perf_counter() - began:.3f} s")
    assert found[0].status == "event_limit"
    assert found[0].duration < LONG.duration
