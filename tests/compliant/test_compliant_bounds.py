"""A compliant motion never takes more steps than it may, and says so."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import hophoop as hh
from hophoop.compliant.kernel import run
from hophoop.compliant.parameters import to_compliance, to_start
from hophoop.physics.body import Event, Status
from hophoop.records.layout import EVENT, SEGMENT


@pytest.mark.parametrize("steps", [1, 20])
def test_steps_are_used_up(steps):
    scenario = hh.Scenario(contact=hh.Compliant())
    body, comp, t_end, rtol = to_compliance(scenario)
    start, touching = to_start(scenario, body, comp)
    events = np.empty(64, EVENT)
    reached = np.zeros(1)
    status, count, rows, pieces = run(body, comp, start, touching, t_end, rtol, steps, events, np.empty(0, SEGMENT), reached)
    assert reached[0] == events[count - 1]["t"] / t_end  # what somebody who looks on is told
    assert status == Status.EVENT_LIMIT
    assert pieces < steps
    assert events[count - 1]["kind"] == Event.END
    if pieces:
        assert events[count - 1]["t"] == rows[pieces - 1, 1]


@pytest.mark.parametrize("limit", [1, 3, 5])
def test_the_ledger_of_a_motion_that_ends_early(limit):
    """It is that of the last event, and not of a piece beyond it."""
    motion = hh.simulate(hh.Scenario(contact=hh.Compliant(max_events=limit), duration=2.0))
    assert motion.status == "event_limit"
    assert len(motion.events) == limit
    assert abs(motion.ledger.residual) <= 1e-6 * motion.ledger.range


def test_many_turns_cost_no_digits():
    """Beside 10⁵ rad of θ a relative tolerance of 1e-9 would be 1e-4 rad, and the ledger off by as much."""
    start = hh.Start(angle=1e5, vx=1.0, omega=3.0)
    turned = hh.simulate(hh.Scenario(start=start, duration=1.0, contact=hh.Compliant()))
    assert abs(turned.ledger.residual) <= 1e-7 * turned.ledger.range


def test_after_millions_of_turns_a_step_asks_for_the_digits_that_the_angle_has():
    """θ = 10⁸ rad is known to 10⁻⁸: steps that asked for 10⁻⁹ shrank to noise, hundreds of thousands to a landing."""
    path = Path(__file__).parents[1] / "data" / "once_open" / "5406.toml"
    scenario = hh.Scenario.load(path).replace("contact.max_events", 22)
    motion = hh.simulate(scenario)
    assert abs(motion.events[-1].angle) > 1e8
    assert len(motion.tables["segments"]) < 2_000
    assert abs(motion.ledger.residual) <= 1e-7 * motion.ledger.range
