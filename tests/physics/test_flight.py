"""Flight: against the path of G and the turn of the hoop, written down apart from each other."""

import math

import mpmath as mp
import pytest

from hophoop.kernel.physics.closed_forms import LARGE_ROTATION, flight_displacement, flight_gap, flight_rates
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
    bend, ahead, back = (accelerations(body, end + step, om, "free")[1] for step in (0.0, 1e-4, -1e-4))
    *found, jerk = flight_rates(body, s, c, om, y, vn, f_n, tau)
    assert tuple(found) == pytest.approx((gap, rate, bend), rel=1e-12, abs=1e-13)
    assert jerk == pytest.approx((ahead - back) / 2e-4 * om, rel=1e-7, abs=1e-7)
    way = gx - eps * math.sin(end)
    slip = rates[0] + body.gt * tau - eps * math.cos(end) * om - om
    assert flight_displacement(body, vt, om, s, c, tau) == pytest.approx((way, slip), rel=1e-12, abs=1e-13)


@pytest.mark.parametrize("turned", [LARGE_ROTATION - 0.5, LARGE_ROTATION + 0.5, -LARGE_ROTATION - 0.5, 1e5, -3e7])
@pytest.mark.parametrize("body", BODIES)
def test_flight_of_many_turns(body, turned):
    """Where G is and how the hoop has turned, in 40 digits."""
    th, om, y, vn = 0.4, math.copysign(50.0, turned), 0.3, 0.8
    tau = turned / om
    s, c = math.sin(th), math.cos(th)
    with mp.workdps(40):
        eps, gn, t = mp.mpf(body.eps), mp.mpf(body.gn), mp.mpf(tau)
        rise = vn - eps * om * s
        angle = mp.atan2(s, c) + om * t
        gap = y + eps * c + rise * t - gn * t**2 / 2 - eps * mp.cos(angle)
        rate = rise - gn * t + eps * om * mp.sin(angle)
    f_n = body.eps * om**2 * c - body.gn  # to rounding on every machine: it counts tau**2 / 2 times
    found = flight_gap(body, s, c, om, y, vn, f_n, tau)
    size = abs(rise) * tau + body.gn * tau**2
    lost = 2e-16 * (turned**2 if abs(turned) <= LARGE_ROTATION else abs(turned)) + 1e-14  # as LARGE_ROTATION says
    assert found[0] == pytest.approx(float(gap), abs=4e-15 * float(size) + lost)
    assert found[1] == pytest.approx(float(rate), abs=4e-15 * float(size) / tau + 50.0 * lost)
    bend, jerk = flight_rates(body, s, c, om, y, vn, f_n, tau)[2:]
    assert bend == pytest.approx(float(eps * om**2 * mp.cos(angle) - gn), abs=2500.0 * lost)
    assert jerk == pytest.approx(float(-eps * om**3 * mp.sin(angle)), abs=125000.0 * lost)
