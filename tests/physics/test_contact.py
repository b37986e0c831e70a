"""Formulas of contact space, each against Newton's and Euler's equations solved as they stand."""

import math

import numpy as np
import pytest
from mpmath import mp, mpf

from hophoop.kernel.physics import contact
from hophoop.kernel.physics.contact import utilization, utilizations
from newton_euler import BODIES, STATES, accelerations, responses

CASES = [(body, *state) for body in BODIES for state in STATES]


@pytest.fixture(params=CASES, ids=lambda case: f"ε={case[0].eps:g} θ={case[1]:g}")
def case(request):
    return request.param


def near(value):
    return pytest.approx(value, rel=1e-11, abs=1e-12)


def test_delassus(case):
    body, th, _ = case
    along, normal = responses(body, th)
    assert contact.delassus(body, math.sin(th), math.cos(th)) == near((along[0], normal[1], along[1]))
    assert along[1] == near(normal[0])  # the operator is symmetric


def test_rolling(case):
    body, th, om = case
    _, _, alpha, friction, normal = accelerations(body, th, om, "roll")
    s, c, u = math.sin(th), math.cos(th), om * om
    assert contact.rolling_acceleration(body, s, c, u, 0.0) == near(alpha)
    assert contact.rolling_forces(body, s, c, u, 0.0) == near((friction, normal))


def test_utilization():
    assert utilization(False, -0.3, 2.0, 0.5, 0.4) == near(0.3)
    assert utilization(True, 0.8, 2.0, 0.5, 0.4) == near(1.0)
    assert utilization(True, 0.0, 0.0, 0.5, 0.4) == 1.0
    assert utilization(False, 0.1, 1.0, 0.0, 0.0) == math.inf
    assert utilization(False, 0.0, 1.0, 0.0, 0.0) == 0.0
    assert math.isnan(utilization(True, 0.0, 1.0, 0.5, 0.0))
    assert math.isnan(utilization(False, 0.0, 0.0, 0.5, 0.4))


def test_utilization_of_many():
    slips = np.array([False, True, False])
    friction, normal = np.array([-0.3, 0.8, 0.0]), np.array([2.0, 2.0, 0.0])
    out = np.empty(3)
    utilizations(slips, friction, normal, np.full(3, 0.5), np.full(3, 0.4), out)
    np.testing.assert_allclose(out, [0.3, 1.0, math.nan])


def test_forces_where_the_load_of_a_massless_ring_meets_the_plane():
    """Newton and Euler's equations in 40 digits: 1 + ε cos θ has lost all of its own there."""
    eps, kap, gt, mu, u = 1.0 - 2.0**-40, 4e-12, 0.3, 0.003, 1e11
    body = BODIES[0]._replace(eps=eps, kap=kap, gt=gt, mu_s=mu, mu_k=mu)
    th = math.pi + 1e-6
    with mp.workdps(40):
        s, c = mp.sin(th), mp.cos(th)
        q = eps * s + mu * (1 + eps * c)
        load = (body.gn - eps * c * u) / (kap + eps * s * q)
        rate = gt + eps * s * u - load * (mu * mpf(kap) + (1 + eps * c) * q)
        inertia = 1 + mpf(kap) + mpf(eps) ** 2 + 2 * eps * c
        turning = {speed: (eps * s * (speed + body.gn) + gt * (1 + eps * c)) / inertia for speed in (u, 1e-9)}
    sine, cosine = float(s), float(c)
    assert contact.slip_motion(body, sine, cosine, u, 1.0, 0.0)[2] == pytest.approx(float(rate), rel=1e-12)
    for speed, expected in turning.items():
        assert contact.rolling_acceleration(body, sine, cosine, speed, 0.0) == pytest.approx(float(expected), rel=1e-12)
