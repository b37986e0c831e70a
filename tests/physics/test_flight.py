"""Flight: against the path of G and the turn of the hoop, written down apart from each other."""

import math

import pytest

from hophoop.physics.flight import flight_displacement, flight_gap
from newton_euler import BODIES, STATES, accelerations

CASES = [(body, *state, tau) for body in BODIES for state in STATES for tau in (0.05, 1.7)]


@pytest.mark.parametrize(("body", "th", "om", "tau"), CASES)
def test_flight(body, th, om, tau):
    x, y, vt, vn = 0.0, 0.4, -0.6, 0.8
    eps, s, c = body.eps, math.sin(th), math.cos(th)
    f_n = accelerations(body, th, om, "free")[1]
    gx, gy = x + eps * s, y + eps * c
    rates = vt + om + eps * c * om, vn - eps * s * om
    end = th + om * tau
    gx += rates[0] * tau + 0.5 * body.gt * tau**2
    gy += rates[1] * tau - 0.5 * body.gn * tau**2
    gap = gy - eps * math.cos(end)
    rate = rates[1] - body.gn * tau + eps * math.sin(end) * om
    assert flight_gap(body, s, c, om, y, vn, f_n, tau) == pytest.approx((gap, rate), rel=1e-12, abs=1e-13)
    way = gx - eps * math.sin(end)
    slip = rates[0] + body.gt * tau - eps * math.cos(end) * om - om
    assert flight_displacement(body, vt, om, s, c, tau) == pytest.approx((way, slip), rel=1e-12, abs=1e-13)
