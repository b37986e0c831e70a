"""How a motion begins and ends: the first phase that the kernel makes of a start, and what it says of tables that are full."""

from __future__ import annotations

import math
from itertools import groupby, pairwise

import numpy as np
import pytest

import hophoop as hh
from contact_tools import body_of
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.records.layout import EVENT, EVENTS, PANEL_LIMIT, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.records.writing import new_log
from hophoop.kernel.rigid import run as kernel
from hophoop.kernel.rigid.phase import GOING, START_LEVEL, Ending, Phase

NOWHERE = -1  # the mode before a start on the plane


def state_of(angle, *, y=0.0, vt=0.0, vn=0.0, om=0.0):
    return start_state(0.5, y, angle, vt, vn, om)


def begin(body, state):
    """(first phase, events as (kind, mode before, mode after))."""
    events, scratch = np.zeros(20, EVENT), new_scratch()
    phase = kernel.begin(body, state, kernel.BY_RULE, new_log(events, np.empty(0, SEGMENT), scratch), scratch)
    return phase, [tuple(map(int, row)) for row in events[["kind", "before_mode", "after_mode"]][: scratch.counts[EVENTS]]]


@pytest.mark.parametrize(
    ("given", "before", "mode"),
    [
        ({"vt": 0.5}, NOWHERE, Mode.SKID),
        ({"vt": -0.5}, NOWHERE, Mode.SPIN),
        ({"vn": 0.5}, Mode.FLIGHT, Mode.FLIGHT),
        ({"vn": -0.5}, Mode.FLIGHT, Mode.FLIGHT),
        ({"y": 0.5}, Mode.FLIGHT, Mode.FLIGHT),
        ({"y": 0.5, "vt": 0.5, "vn": -0.5}, Mode.FLIGHT, Mode.FLIGHT),
    ],
)
@pytest.mark.parametrize("om", [0.0, 0.5])
def test_of_a_massless_hoop_that_does_not_roll_nothing_is_said(given, before, mode, om):
    """Without a moment of inertia no force tells how it turns."""
    state = state_of(0.5, om=om, **given)
    phase, events = begin(body_of(1.0), state)
    assert events == [(Event.START, before, mode)]
    assert (phase.mode, phase.state, phase.begins) == (mode, state, False)
    assert (phase.ending, phase.status) == (Ending.CONTINUES, Status.UNDETERMINED)


@pytest.mark.parametrize(
    ("angle", "om", "mode", "status"),
    [
        (0.5, 0.25, Mode.ROLL, GOING),
        (1.5, 0.25, Mode.SKIM, GOING),  # it would need more than μ N
        (math.pi, 0.0, Mode.ROLL, GOING),
        (math.pi, 0.5, Mode.ROLL, Status.UNDETERMINED),  # all turns about the load, which has no weight to be moved
        (math.pi, 1.0, Mode.ROLL, Status.UNDETERMINED),
        (math.pi, -1.0, Mode.ROLL, Status.UNDETERMINED),
        (3.0, 0.0, Mode.SKIM, GOING),
        (3.0, 1.0, Mode.SKIM, GOING),
    ],
)
def test_a_massless_hoop_rolls_or_skims_from_the_start(angle, om, mode, status):
    """tan(θ/2) ≤ μ is what it needs to roll from a slow start."""
    state = state_of(angle, om=om)
    phase, events = begin(body_of(1.0), state)
    skim = [(Event.SKIM, Mode.ROLL, Mode.SKIM)] if mode == Mode.SKIM else []
    assert events == [(Event.START, NOWHERE, Mode.ROLL), *skim]
    assert phase == Phase(mode, state, status == GOING, START_LEVEL, Ending.CONTINUES, status)


@pytest.mark.parametrize(
    "given", [{"y": 1e-200}, {"y": 0.5, "vn": -0.5}, {"y": 1.0, "vn": -0.5}, {"vn": 0.5}, {"y": 0.5, "vt": 0.5}]
)
def test_a_thrown_hoop_flies_at_first(given):
    state = state_of(0.5, om=1.0, **given)
    phase, events = begin(body_of(), state)
    assert events == [(Event.START, Mode.FLIGHT, Mode.FLIGHT)]
    assert (phase.mode, phase.state, phase.ending, phase.status) == (
        Mode.FLIGHT,
        state,
        Ending.CONTINUES,
        GOING,
    )


@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_a_hoop_thrown_at_the_plane_strikes_it_at_once(restitution):
    """As a start at the moment of an impact."""
    phase, events = begin(body_of(restitution=restitution), state_of(0.5, vn=-0.5))
    assert [kind for kind, _, _ in events] == [Event.START, Event.IMPACT]
    assert phase.state.impact_n > 0.0
    assert phase.state.vn == pytest.approx(restitution * 0.5)
    assert phase.ending == Ending.LANDING


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize(("resistance", "left"), [(0.1, 0.0), (0.0, 1e-150)])
def test_a_rotation_whose_square_underflows_is_none_for_the_couple(resistance, left, sign):
    """Rolling resistance is against it, or holds the hoop that does not turn."""
    phase, _ = begin(body_of(rolling_resistance=resistance), state_of(math.pi + 0.05, om=sign * 1e-150))
    assert phase.state.om == sign * left
    fast, _ = begin(body_of(rolling_resistance=resistance), state_of(math.pi + 0.05, om=sign * 1e-100))
    assert fast.state.om == sign * 1e-100


@pytest.mark.parametrize(
    ("given", "mode"), [({}, Mode.ROLL), ({"vt": 0.5}, Mode.SKID), ({"vt": -0.5}, Mode.SPIN), ({"om": 3.0}, Mode.FLIGHT)]
)
def test_a_hoop_on_the_plane_begins_in_the_mode_that_the_rule_gives(given, mode):
    """At the top θ̇² ε > g throws the rim up: 9 · 0.75 of g."""
    phase, events = begin(body_of(), state_of(0.0, **given))
    assert events == [(Event.START, NOWHERE, mode)]
    assert (phase.mode, phase.begins, phase.ending, phase.status) == (mode, True, Ending.CONTINUES, GOING)


def run(events=100, segments=1000, t_end=4.0, panels=None):
    """(status, events, segments) of a hoop that rolls, slips, hops and lands."""
    tables, scratch = (np.zeros(events, EVENT), np.zeros(segments, SEGMENT)), new_scratch()
    if panels is not None:
        scratch.counts[PANEL_LIMIT] = panels
    found = kernel.run(body_of(), state_of(0.0, om=3.1 / math.sqrt(9.81)), kernel.BY_RULE, t_end, math.nan, 0, *tables, scratch)
    return found, tables[0], tables[1]


def test_what_a_motion_says_of_its_end():
    """Tables of just the length are enough, and one row less is not; what was written stays as it was."""
    (status, count, pieces), events, segments = run()
    assert (status, events["kind"][count - 1]) == (Status.COMPLETED, Event.END)
    assert (events["t"][count - 1], segments["t_end"][pieces - 1]) == (4.0, 4.0)
    exact = run(count, pieces)
    assert exact[0] == (Status.COMPLETED, count, pieces)
    assert (exact[1] == events[:count]).all()
    assert run(count, 0)[0] == (Status.COMPLETED, count, 0)
    for length in (count - 1, count - 2, 1):
        found, rows, _ = run(length, pieces)
        assert found[:2] == (Status.EVENT_LIMIT, length)
        assert (rows == events[:length]).all()
    for length in (pieces - 1, pieces - 2, 1):
        found, known, rows = run(count, length)
        assert (found[0], found[2]) == (Status.BUFFER, length)
        assert (rows == segments[:length]).all()
        assert (known[: found[1]] == events[: found[1]]).all()
        assert events["t"][found[1]] >= rows["t_end"][-1]  # those of the pieces that are there, and no end


def test_where_the_panels_are_used_up_the_motion_ends_where_it_has_come_to():
    (status, count, pieces), events, segments = run(panels=3)
    assert status == Status.EVENT_LIMIT
    assert events["kind"][count - 1] == Event.END
    assert 0.0 < events["t"][count - 1] == segments["t_end"][pieces - 1] < 4.0
    assert events["after_mode"][count - 1] == events["before_mode"][count - 1] == Mode.ROLL


def bouncing(events, segments):
    """(status, number of events, number of segments) of a ball that bounces for ever."""
    tables = np.zeros(events, EVENT), np.zeros(segments, SEGMENT)
    return kernel.run(
        body_of(0.0, restitution=1.0), state_of(0.0, y=0.5), kernel.BY_RULE, 1e6, math.nan, 0, *tables, new_scratch()
    )


def test_where_the_events_are_used_up_the_pieces_so_far_are_counted():
    """START, IMPACT, and from the second flight on APEX and IMPACT."""
    assert bouncing(7, 100) == (Status.EVENT_LIMIT, 7, 4)  # no room for the fourth impact
    assert bouncing(9, 100) == (Status.EVENT_LIMIT, 9, 5)
    assert bouncing(100, 4) == (Status.BUFFER, 10, 4)  # up to the fifth impact


def test_where_events_and_pieces_are_used_up_in_one_step_pieces_are_counted_too():
    for events in range(2, 12):
        for pieces in range(1, 6):
            assert bouncing(events, pieces)[2] >= 0


def hopping_without_loss(most):
    return hh.simulate(
        hh.Hoop.ideal(0.0), hh.Plane(restitution=1.0), hh.Start(height=0.5), duration=1000.0, contact=hh.Rigid(max_events=most)
    )


@pytest.mark.parametrize("most", [511, 512, 513, 514])
def test_a_motion_ends_at_the_last_event_for_which_there_is_room(most):
    """With 512, events and segments are used up in one step; the last segment was left out then."""
    motion = hopping_without_loss(most)
    longer = hopping_without_loss(520)
    assert motion.status == "event_limit"
    assert motion.events == longer.events[:most]
    assert motion.duration == motion.events[-1].t
    inside = 0.5 * (motion.events[-2].t + motion.duration)
    assert motion.at(inside).height == longer.at(inside).height
    assert set(motion.sequence) == {"H"}


@pytest.mark.parametrize("contact", [hh.Rigid, hh.Compliant])
def test_the_sequence_of_a_motion_that_is_cut_is_that_of_its_samples(contact):
    """The phase in which it is cut was left out, and its samples went on to the end of that phase."""
    for most in range(2, 30):
        motion = hh.simulate(
            hh.Hoop.ideal(0.75),
            hh.Plane(mu=0.1),
            hh.Start(angle=2.0, height=0.1),
            duration=30.0,
            contact=contact(max_events=most),
        )
        if motion.status != "event_limit":
            break
        assert len(motion.events) == most
        assert motion.duration == motion.events[-1].t
        times = [event.t for event in motion.events]
        between = [0.5 * (a + b) for a, b in pairwise(times) if b > a]
        assert squeezed(motion.at(between).mode) == squeezed(motion.sequence)
    assert most > 10


def squeezed(letters):
    """The letters without repetition."""
    return "".join(letter for letter, _ in groupby(letters))
