"""States, phases and logs for the tests of contact step by step."""

from __future__ import annotations

import math

import numpy as np

import hophoop as hh
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.kernel.records.layout import EVENT, EVENTS, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.records.writing import new_log
from hophoop.kernel.rigid import contact_phase
from hophoop.kernel.rigid.phase import Ending, Phase

STARTED = {"t": 3.0, "t_low": 1e-17, "x": 2.0, "x_low": -1e-17, "revolutions": 2.0, "friction": 0.125, "impact_n": 0.25}
STARTED |= {"impact_t": 0.375, "rolling_loss": 0.5}


def body_of(gamma=0.75, slope=0.0, mu=0.5, **plane):
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(mu=mu, slope=slope, **plane)).to_body()


def state_of(angle, om=0.0, vt=0.0, anchor=None):
    state = start_state(0.0, 0.0, angle, vt, 0.0, om)
    return state if anchor is None else state._replace(anchor=anchor)


def sines_of(state):
    """(sin θ, cos θ)."""
    return sine_cosine(state.th, state.th_low)


def log_of(room=10):
    scratch = new_scratch()
    return new_log(np.zeros(room, EVENT), np.zeros(room, SEGMENT), scratch), scratch


def phase_at(mode, state, level=5):
    return Phase(mode, state, False, level, Ending.CONTINUES, -1)


def events_of(log):
    return [tuple(row) for row in log.events[: log.counts[EVENTS]][["kind", "before_mode", "after_mode"]].tolist()]


def sliding(sigma, th=math.pi):
    """Slip over the load, which does not turn at θ = π without friction on the load's arm."""
    mode = contact_phase.SKID if sigma > 0 else contact_phase.SPIN
    state = state_of(th, 0.0, 1.5 * sigma)._replace(**STARTED)
    return phase_at(mode, state)
