"""How many panels a motion may have is a number in memory."""

from __future__ import annotations

import math

import numpy as np

import hophoop as hh
from hophoop.kernel.native import compiled
from hophoop.kernel.physics.body import Status
from hophoop.kernel.records.layout import EVENT, MOST_PANELS, PANEL_LIMIT, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid.run import BY_RULE, run


def test_a_budget_of_few_panels_gives_the_run_so_far() -> None:
    scenario, scratch = hh.Scenario(), new_scratch()
    assert scratch.counts[PANEL_LIMIT] == MOST_PANELS
    scratch.counts[PANEL_LIMIT] = 20
    whole = hh.simulate(scenario)
    unit = whole.units.time
    start = start_state(0.0, 0.0, 0.0, 0.0, 0.0, 3.1 * unit)
    events, segments = np.empty(64, EVENT), np.empty(256, SEGMENT)
    status, count, _ = compiled(run)(
        scenario.to_body(), start, BY_RULE, scenario.duration / unit, math.nan, 0, events, segments, scratch
    )
    assert status == Status.EVENT_LIMIT
    found = events[: count - 1]  # the last one is the end of what is computed
    assert 2 < len(found) < len(whole.events) - 1
    assert found.tobytes() == whole.tables["events"][: count - 1].tobytes()
