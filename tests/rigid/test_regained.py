"""Slip that comes back to its hilltop regains the digits of θ̇² that rounding has lost, and keeps its momentum."""

from __future__ import annotations

import math

import pytest

import hophoop as hh
from hophoop._jit import interpreted
from hophoop.records.state import start_state
from hophoop.rigid import contact_phase


@pytest.mark.parametrize("om", [0.25, -0.25])
@pytest.mark.parametrize("angle", [0.5, 3.0, -2.0])
def test_the_centre_of_gravity_keeps_its_velocity_along_the_plane(om, angle):
    body = hh.Scenario(hoop=hh.Hoop.ideal(0.75)).to_body()
    state = interpreted(start_state)(0.25, 0.0, angle, -0.5, 0.0, om)._replace(th_low=1e-10, vn=0.125)
    after = interpreted(contact_phase.regained)(body, state, 0.16)
    assert after.om == math.copysign(0.4, om)
    along = [at.vt + at.om * (1.0 + 0.75 * math.cos(angle + 1e-10)) for at in (state, after)]
    assert along[1] == pytest.approx(along[0], abs=1e-14)
    assert after._replace(vt=-0.5, om=om) == state
