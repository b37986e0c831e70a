"""Slip: how far the hoop goes, against the integrated equations of motion."""

import math

import pytest
from scipy.integrate import solve_ivp

from hophoop.kernel.physics.closed_forms import slip_displacement
from newton_euler import BODIES, accelerations


@pytest.mark.parametrize("body", [body._replace(mu_k=0.25) for body in BODIES[:2]])
@pytest.mark.parametrize("sigma", [1, -1])
@pytest.mark.parametrize("state", [(0.4, 1.3), (2.2, -0.9)])
def test_displacement(body, sigma, state):
    th, om = state
    tau, vt = 0.3, 0.5 * sigma

    def rates(_, now):
        ax, _, alpha, _, _ = accelerations(body, now[1], now[3], sigma)
        return now[2], now[3], ax, alpha

    x, end, _, _ = solve_ivp(rates, (0.0, tau), (0.0, th, vt + om, om), rtol=1e-11, atol=1e-12).y[:, -1]
    s, c = math.sin(th), math.cos(th)
    found = slip_displacement(body, sigma, vt, om, s, c, math.sin(end) - s, math.cos(end) - c, tau)
    assert found == pytest.approx(x, rel=1e-9, abs=1e-10)
