"""How a motion begins and ends: the first phase that the kernel makes of a start, and what it says of tables that are full."""

import math

import numpy as np
import pytest

from hophoop.kernel.panels.anchor import NONE
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.records.layout import PANEL_LIMIT, new_scratch
from hophoop.kernel.rigid import run as kernel
from hophoop.kernel.rigid.phase import GOING, START_LEVEL, Ending, Phase
from rigid.tools import FLIGHT, NOWHERE, ROLL, SKID, SPIN, body_of, log_of, motion_of, moves, state_of

MASSLESS, SKIM = body_of(1.0), int(Mode.SKIM)
UNDETERMINED = int(Status.UNDETERMINED)


def begin(body, state):
    """(first phase, its events)."""
    log, scratch = log_of()
    phase = kernel.begin(body, state, kernel.BY_RULE, log)
    return phase, moves(log.events[: scratch.counts[0]])


@pytest.mark.parametrize(
    ("body", "state", "before", "mode", "status"),
    [
        # on the plane by the rule of the modes; one that is thrown flies
        (body_of(), state_of(0.0, vt=-0.5), NOWHERE, SPIN, GOING),
        (body_of(), state_of(0.5, 1.0, y=1e-200), FLIGHT, FLIGHT, GOING),
        (body_of(), state_of(0.5, 1.0, y=0.5, vn=-0.5), FLIGHT, FLIGHT, GOING),
        (body_of(), state_of(0.5, 1.0, vn=0.5), FLIGHT, FLIGHT, GOING),
        # of a massless hoop that does not roll nothing is said: without a moment of inertia no force tells how it turns
        (MASSLESS, state_of(0.5, vt=0.5), NOWHERE, SKID, UNDETERMINED),
        (MASSLESS, state_of(0.5, vn=0.5), FLIGHT, FLIGHT, UNDETERMINED),
        (MASSLESS, state_of(0.5, vn=-0.5), FLIGHT, FLIGHT, UNDETERMINED),
        (MASSLESS, state_of(0.5, 0.5, y=0.5), FLIGHT, FLIGHT, UNDETERMINED),
        # it rolls from a slow start where tan(θ/2) ≤ μ, or with its load at rest on the plane
        (MASSLESS, state_of(0.5, 0.25), NOWHERE, ROLL, GOING),
        (MASSLESS, state_of(math.pi), NOWHERE, ROLL, GOING),
        # all turns about the load, which has no weight to be moved
        (MASSLESS, state_of(math.pi, -1.0), NOWHERE, ROLL, UNDETERMINED),
    ],
)
def test_the_first_phase(body, state, before, mode, status):
    phase, events = begin(body, state)
    assert events == [(Event.START, before, mode)]
    assert phase == Phase(mode, state, status == GOING, START_LEVEL, Ending.CONTINUES, status, NONE)


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize(("resistance", "left"), [(0.1, 0.0), (0.0, 1e-150)])
def test_a_rotation_whose_square_underflows_is_none_for_the_couple(resistance, left, sign):
    """Rolling resistance is against it, or holds the hoop that does not turn."""
    body = body_of(rolling_resistance=resistance)
    for om, kept in ((1e-150, left), (1e-100, 1e-100)):
        assert begin(body, state_of(math.pi + 0.05, sign * om))[0].state.om == sign * kept


def test_a_doubt_of_the_motion_before_is_forgotten():
    scratch = new_scratch()
    scratch.doubt[:] = 0.5
    motion_of(body_of(), state_of(0.5, 1.0), 1.0, scratch=scratch)
    assert np.isnan(scratch.doubt).all()


def hopped(*rooms, panels=None):
    """(status, events, segments) of a hoop that rolls, slips, hops and lands."""
    scratch = new_scratch()
    if panels is not None:
        scratch.counts[PANEL_LIMIT] = panels
    return motion_of(body_of(), state_of(0.0, 3.1 / math.sqrt(9.81)), 4.0, scratch=scratch, rooms=rooms or (100, 1000))


def test_what_a_motion_says_of_its_end():
    """Tables of just the length are enough, and one row less is not; what was written stays as it was."""
    status, events, segments = hopped()
    count, pieces = len(events), len(segments)
    assert (status, events["kind"][-1]) == (Status.COMPLETED, Event.END)
    assert (events["t"][-1], segments["t_end"][-1]) == (4.0, 4.0)
    for rooms, ended in (
        ((count, pieces), Status.COMPLETED),
        ((count, 0), Status.COMPLETED),  # no segments are asked for
        *(((length, pieces), Status.EVENT_LIMIT) for length in (count - 1, count - 2, 1)),
        *(((count, length), Status.BUFFER) for length in (pieces - 1, pieces - 2, 1)),
    ):
        found, known, rows = hopped(*rooms)
        assert found == ended
        assert (rows == segments[: len(rows)]).all()
        assert (known == events[: len(known)]).all()
        assert len(known) == rooms[0] or (ended == Status.BUFFER and events["t"][len(known)] >= rows["t_end"][-1])


def test_where_the_panels_are_used_up_the_motion_ends_where_it_has_come_to():
    status, events, segments = hopped(panels=3)
    assert status == Status.EVENT_LIMIT
    assert moves(events[-1:]) == [(Event.END, ROLL, ROLL)]
    assert 0.0 < events["t"][-1] == segments["t_end"][-1] < 4.0
    events = hopped(panels=20)[1]
    assert len(events) > 2
    assert (events[:-1] == hopped()[1][: len(events) - 1]).all()
