"""Slip that comes back to its hilltop regains the digits of θ̇² that rounding has lost, and keeps its momentum."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.panels.anchor import SLIPPING, Anchor, frictionless_value
from hophoop.kernel.records.layout import EVENT, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.records.writing import new_log
from hophoop.kernel.rigid import contact_phase
from hophoop.kernel.rigid.phase import Ending, Phase, limits_of


@pytest.mark.parametrize("om", [0.25, -0.25])
@pytest.mark.parametrize("angle", [0.5, 3.0, -2.0])
def test_the_centre_of_gravity_keeps_its_velocity_along_the_plane(om, angle):
    body = hh.Scenario(hoop=hh.Hoop.ideal(0.75)).to_body()
    state = start_state(0.25, 0.0, angle, -0.5, 0.0, om)._replace(th_low=1e-10, vn=0.125)
    after = contact_phase.recover_slip_velocity(body, state, 0.16)
    assert after.om == math.copysign(0.4, om)
    along = [at.vt + at.om * (1.0 + 0.75 * math.cos(angle + 1e-10)) for at in (state, after)]
    assert along[1] == pytest.approx(along[0], abs=1e-14)
    assert after._replace(vt=-0.5, om=om) == state


@pytest.mark.parametrize("sigma", [1, -1])
@pytest.mark.parametrize(("off", "regains"), [(1e-8, True), (1e-3, True), (1e-10, False), (-1e-8, True)])
def test_what_is_conserved_sets_a_lost_rate_of_turning_right(off, regains, sigma):
    """Slip without friction beside the hilltop, with a rate that is not that of its anchor by some part of it."""
    body = hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=hh.Plane(mu=0.0)).to_body()
    right = math.sqrt(1e-3 + frictionless_value(body, 0.05, 0.0))
    lost = right * (1.0 + off)
    state = start_state(0.25, 0.0, 0.05, 3.0 * sigma, 0.0, lost)._replace(anchor=Anchor(SLIPPING, 1e-3, 0.0, 0.0, 0.75))
    log = new_log(np.zeros(9, EVENT), np.zeros(9, SEGMENT), new_scratch())
    phase = Phase(contact_phase.SKID if sigma > 0 else contact_phase.SPIN, state, False, 5, Ending.CONTINUES, -1)
    limits = limits_of(state, 0.125, math.nan, 0, 0)
    what, after, _ = contact_phase.advance_contact(body, phase, limits, log, new_scratch())
    first = log.segments[0]
    assert (what, after.t, first["t"]) == (Ending.TIME_LIMIT, 0.125, 0.0)
    assert first["omega"] == (pytest.approx(right, rel=1e-15) if regains else lost)
    assert first["u"] == pytest.approx(right**2, rel=1e-14)
    along = [at.vt + at.om * (1.0 + 0.75 * math.cos(at.th)) for at in (state, after)]
    assert along[1] == pytest.approx(along[0], abs=1e-14 if regains else 1e-10)
