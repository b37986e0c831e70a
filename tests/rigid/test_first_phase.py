"""The first event of a motion, landings, and the last of many bounces: what the kernel writes."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.records.layout import EVENT, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state, with_velocities
from hophoop.kernel.rigid import flight_phase
from hophoop.kernel.rigid.phase import STOP_AT_TAKEOFF, STOP_AT_TURN
from hophoop.kernel.rigid.run import BY_RULE, run

NOWHERE = -1  # the mode before a start on the plane


def body_of(gamma=0.75, **plane):
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(**plane)).to_body()


def motion_of(body, *start, t_end=1.0, span=math.nan, stop=0, scratch=None):
    """(status, events) of the kernel; x, y, θ, v_t, v_n, θ̇ in its units."""
    events = np.empty(100, EVENT)
    state = start_state(*start)
    room = np.empty(0, SEGMENT)
    with np.errstate(all="ignore"):  # as where a kernel gives up a panel
        status, count, _ = run(body, state, BY_RULE, t_end, span, stop, events, room, scratch or new_scratch())
    return status, events[:count]


@pytest.mark.parametrize(
    ("start", "before", "after"),
    [
        ((0.0, 0.0, 0.5, 1.0, 0.0, 0.0), NOWHERE, Mode.SKID),
        ((0.0, 0.0, 0.5, -1.0, 0.0, 0.0), NOWHERE, Mode.SPIN),
        ((0.0, 0.0, 0.5, 0.0, 1.0, 0.0), Mode.FLIGHT, Mode.FLIGHT),
        ((0.0, 0.0, 0.5, 0.0, -1.0, 0.0), Mode.FLIGHT, Mode.FLIGHT),
        ((0.0, 0.5, 0.5, 0.0, 0.0, 0.0), Mode.FLIGHT, Mode.FLIGHT),
    ],
)
def test_the_massless_hoop_only_rolls_and_skims(start, before, after):
    status, events = motion_of(body_of(1.0), *start)
    assert status == Status.UNDETERMINED
    assert [(row["kind"], row["before_mode"], row["after_mode"]) for row in events[:1]] == [(Event.START, before, after)]
    assert events[-1]["kind"] == Event.END
    assert len(events) == 2


@pytest.mark.parametrize(
    ("start", "before", "after"),
    [
        ((0.0, 0.0, 0.5, 0.0, 0.0, 1.0), NOWHERE, Mode.ROLL),
        ((0.0, 0.0, 0.5, 1.0, 0.0, 1.0), NOWHERE, Mode.SKID),
        ((0.0, 0.0, 0.5, -1.0, 0.0, 1.0), NOWHERE, Mode.SPIN),
        ((0.0, 5e-324, 0.5, 0.0, 0.0, 1.0), Mode.FLIGHT, Mode.FLIGHT),
        ((0.0, 1e-240, 0.5, 0.0, 0.0, 1.0), Mode.FLIGHT, Mode.FLIGHT),
        ((0.0, 0.0, 0.5, 0.0, 1.0, 1.0), Mode.FLIGHT, Mode.FLIGHT),
    ],
)
def test_the_mode_before_and_after_the_start(start, before, after):
    _, events = motion_of(body_of(), *start, t_end=0.01)
    assert (events[0]["kind"], events[0]["before_mode"], events[0]["after_mode"]) == (Event.START, before, after)


def test_a_landing_is_a_collision():
    """And an impact within contact, by Painlevé's paradox, is none; what is no impact has no such number."""
    _, events = motion_of(body_of(restitution=0.5), 0.0, 0.5, 0.5, 0.0, 0.0, 0.0, t_end=2.0)
    assert set(events["kind"]) >= {Event.START, Event.IMPACT, Event.APEX}
    for row in events:
        assert row["collision"] == (1 if row["kind"] in (Event.IMPACT, Event.BOUNCE_LIMIT) else -1)


def test_bounces_that_take_no_time_are_closed_at_the_first_one():
    """An impact tells by itself by how much slower the next one is."""
    _, events = motion_of(body_of(0.0, restitution=0.5), 0.0, 0.0, 0.0, 0.0, -1e-13, 0.0)
    kinds = [int(kind) for kind in events["kind"] if kind != Event.APEX]
    assert kinds[:2] == [Event.START, Event.BOUNCE_LIMIT]


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_flight_ends_at_the_angle_of_the_span(way):
    """After rolling some of the way: θ̇ t is what is left of it."""
    body = body_of()
    _, whole = motion_of(body, 0.0, 0.0, 0.0, 0.0, 0.0, way * 3.1 / math.sqrt(9.81), t_end=6.0)
    takeoff = next(row for row in whole if row["after_mode"] == Mode.FLIGHT)
    span = abs(takeoff["angle"]) + 0.1
    _, events = motion_of(body, 0.0, 0.0, 0.0, 0.0, 0.0, way * 3.1 / math.sqrt(9.81), t_end=6.0, span=span)
    assert events[-1]["before_mode"] == Mode.FLIGHT
    assert events[-1]["angle"] == pytest.approx(way * span, rel=1e-15)
    assert events[-1]["t"] == pytest.approx(takeoff["t"] + 0.1 / abs(takeoff["omega"]), rel=1e-14)


def test_a_motion_may_end_at_a_turn_or_a_takeoff():
    """Each by itself or both; the start is neither."""
    body = body_of()
    swing, hop = (0.0, 0.0, 2.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0, 0.0, 3.1 / math.sqrt(9.81))
    thrown = (0.0, 0.5, 0.0, 0.0, 0.0, 1.0)
    both = STOP_AT_TURN + STOP_AT_TAKEOFF
    for start, stop, last in (
        (swing, STOP_AT_TURN, Event.TURN),
        (swing, both, Event.TURN),
        (swing, STOP_AT_TAKEOFF, None),
        (hop, STOP_AT_TAKEOFF, Event.TAKEOFF),
        (hop, both, Event.TAKEOFF),
        (hop, STOP_AT_TURN, None),
        (thrown, STOP_AT_TURN, None),
    ):
        status, events = motion_of(body, *start, t_end=5.0, stop=stop)
        assert status == Status.COMPLETED
        assert (events[-2]["kind"] if events[-1]["t"] < 5.0 else None) == last


def test_a_doubt_of_the_motion_before_is_forgotten():
    scratch = new_scratch()
    scratch.doubt[:] = 0.5
    motion_of(body_of(), 0.0, 0.0, 0.5, 0.0, 0.0, 1.0, scratch=scratch)
    assert np.isnan(scratch.doubt).all()


@pytest.mark.parametrize("ratio", [0.0625, 0.5, 0.99])
@pytest.mark.parametrize("time", [0.5, 20.0])
def test_bounces_are_closed_when_those_to_come_take_no_time(ratio, time):
    """Each takes 2 v/g and is slower by the same ratio: 2 v/(g (1 − ratio)) in all, beside the time so far or its unit."""
    body = body_of(0.0)
    before = start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)._replace(t=time)
    allowed = flight_phase.CLOSING * max(time, 1.0) * (1.0 - ratio) / 2.0
    for v_n, closes in ((0.99 * allowed, True), (1.01 * allowed, False)):
        after = with_velocities(before, 0.0, v_n, 0.0)
        landing = with_velocities(before, 0.0, -v_n / ratio, 0.0)
        assert flight_phase.is_last_bounce(body, landing, after) is closes


def test_bounces_that_grow_no_slower_are_not_closed():
    body = body_of(0.0)
    state = start_state(0.0, 0.0, 0.0, 0.0, 1e-14, 0.0)
    for last in (1e-14, 0.5e-14, 0.0):
        assert not flight_phase.is_last_bounce(body, state._replace(vn=-last), state)
    before = state._replace(vn=-1.0)
    assert not flight_phase.is_last_bounce(body, before, state._replace(vn=0.0))
    assert not flight_phase.is_last_bounce(body_of(0.0, gravity=0.0), before, state)
    assert flight_phase.is_last_bounce(body, before, state._replace(vn=1e-101))


@pytest.mark.parametrize(("speed", "doubtful"), [(3.6166282640049716, True), (3.1, False), (2.8, False)])
def test_a_margin_that_only_touches_zero_is_a_doubt(speed, doubtful):
    """3.6166282640049716 m/s is the double nearest to the speed at which rolling just keeps its grip."""
    scratch = new_scratch()
    motion_of(body_of(), 0.0, 0.0, 0.0, 0.0, 0.0, speed / math.sqrt(9.81), t_end=1.0 * math.sqrt(9.81), scratch=scratch)
    assert math.isnan(scratch.doubt[0]) is not doubtful


def test_tables_that_are_too_short_are_said():
    events, state = np.empty(100, EVENT), start_state(0.0, 0.0, 0.5, 0.0, 0.0, 1.0)
    for room, pieces, expected in ((events, 2, (Status.BUFFER, 2)), (events[:2], 0, (Status.EVENT_LIMIT, 0))):
        table = np.empty(pieces, SEGMENT)
        found = run(body_of(), state, BY_RULE, 9.0, math.nan, 0, room, table, new_scratch())
        assert found[::2] == expected
