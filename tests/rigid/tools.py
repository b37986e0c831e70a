"""Bodies, states, phases and logs for the tests of motions step by step."""

import math

import numpy as np

import hophoop as hh
from hophoop.kernel.native import compiled
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.records.layout import EVENT, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.records.writing import new_log
from hophoop.kernel.rigid.phase import limits_of
from hophoop.kernel.rigid.run import BY_RULE, run

ROLL, SPIN, SKID, FLIGHT = (int(mode) for mode in (Mode.ROLL, Mode.SPIN, Mode.SKID, Mode.FLIGHT))
NOWHERE = -1  # the mode before a start on the plane


def body_of(gamma=0.75, kap=None, *, mu=0.5, **plane):
    """The kernel's body: of the ideal hoop, or with its eccentricity and κ."""
    hoop = hh.Hoop.ideal(gamma) if kap is None else hh.Hoop(eccentricity=gamma, inertia_ratio=kap)
    return hh.Scenario(hoop=hoop, plane=hh.Plane(mu=mu, **plane)).to_body()


def state_of(angle, om=0.0, vt=0.0, **values):
    """On the plane unless said otherwise; with any other number of a state."""
    return start_state(0.0, 0.0, angle, vt, 0.0, om)._replace(**values)


def limits(state, t_end=9.0, span=math.nan, stop=0):
    return limits_of(state, t_end, span, stop, 0)


def sines_of(state):
    """(sin θ, cos θ)."""
    return sine_cosine(state.th, state.th_low)


def log_of(room=20):
    scratch = new_scratch()
    return new_log(np.zeros(room, EVENT), np.zeros(room, SEGMENT), scratch), scratch


def written(function, *arguments):
    """(what a step returns, the events and segments that it writes, the doubt that it notes)."""
    log, scratch = log_of()
    found = function(*arguments, log)
    events, segments = scratch.counts[:2]
    return found, log.events[:events], log.segments[:segments], scratch.doubt.tolist()


def moves(events):
    """(kind, mode before, mode after) of each event."""
    return [tuple(map(int, row)) for row in events[["kind", "before_mode", "after_mode"]]]


def motion_of(body, state, t_end=1e9, span=math.nan, stop=0, scratch=None, rooms=(400, 20_000)):
    """(status, events, segments) of the kernel, compiled or not."""
    events, segments = np.zeros(rooms[0], EVENT), np.zeros(rooms[1], SEGMENT)
    with np.errstate(all="ignore"):  # where a kernel gives up a panel
        status, count, pieces = compiled(run)(
            body, state, BY_RULE, t_end, span, stop, events, segments, scratch or new_scratch()
        )
    return status, events[:count], segments[:pieces]
