"""How many panels a motion may have is a number in memory."""

from __future__ import annotations

import hophoop as hh
from hophoop.records.scratch import MOST_PANELS, new_scratch, thread_scratch


def test_the_budget_stands_in_memory() -> None:
    assert new_scratch().written[3] == MOST_PANELS


def test_a_budget_of_few_panels_gives_the_run_so_far() -> None:
    whole = hh.simulate(hh.Scenario())
    thread_scratch().written[3] = 20
    try:
        part = hh.simulate(hh.Scenario())
    finally:
        thread_scratch().written[3] = MOST_PANELS
    assert part.status == "event_limit"
    assert 0.0 < part.duration < whole.duration
    count = len(part.events) - 1  # the last one is the end of what is computed
    assert [event.t for event in part.events[:count]] == [event.t for event in whole.events[:count]]
    assert hh.simulate(hh.Scenario()).events == whole.events
