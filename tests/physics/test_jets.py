"""Taylor coefficients along a candidate motion, against the motion itself in 30 digits."""

import math
from functools import lru_cache

import mpmath as mp
import numpy as np
import pytest

from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.modes import TERMS, candidate_series
from newton_euler import BODIES


@lru_cache
def coefficients_of_motion(body, th0, om0, sigma):
    """The same four series by mpmath: from the motion that its solver finds."""
    eps, kap, mu_s, mu_k, gn, gt = (mp.mpf(value) for value in body[:6])

    def forces(th, om):
        s, c, u = mp.sin(th), mp.cos(th), om * om
        if sigma == 0:
            alpha = (eps * s * (u + gn) + gt * (1 + eps * c)) / (1 + kap + eps**2 + 2 * eps * c)
            normal = gn - eps * s * alpha - eps * c * u
            return alpha, normal, alpha * (1 + eps * c) - eps * s * u - gt
        # about G: κ θ̈ = N ε sin θ − F (1 + ε cos θ) with F = −σ μk N; ÿ_G = N − g_n with y fixed
        arm = eps * s + sigma * mu_k * (1 + eps * c)
        normal = kap * (gn - eps * c * u) / (kap + eps * s * arm)
        return normal * arm / kap, normal, -sigma * mu_k * normal

    motion = mp.odefun(lambda t, y: [y[1], forces(*y)[0]], 0, [mp.mpf(th0), mp.mpf(om0)])

    def at(t, what):
        th, om = motion(t)
        alpha, normal, friction = forces(th, om)
        if what == 0:
            return normal
        if what == 3:
            # F = ẍ_G − g_t, and v_t = ẋ_C − θ̇ with ẋ_C = ẋ_G − ε cos θ θ̇
            return friction + gt - eps * (mp.cos(th) * alpha - mp.sin(th) * om * om) - alpha
        norm = mp.sqrt(1 + mu_s**2)
        return (mu_s * normal + (friction if what == 2 else -friction)) / norm

    # the polynomial through 14 places beside the instant
    times = [mp.mpf(k) / 400 for k in range(14)]
    powers = mp.matrix([[t**k for k in range(14)] for t in times])
    return [mp.lu_solve(powers, mp.matrix([at(t, what) for t in times]))[:TERMS] for what in range(4)]


def cases(sigma):
    """Bodies and states with the series that they should have, in doubles."""
    random = np.random.default_rng(5)
    with mp.workdps(30):
        for _ in range(2):
            beta = random.normal() * 0.3
            body = Body(random.random(), 0.3 + random.random(), random.random(), 0.3 * random.random(),
                        math.cos(beta), math.sin(beta), 0.0, 2, False, beta)  # fmt: skip
            th, om = random.normal(), random.normal()
            expected = coefficients_of_motion(body, th, om, sigma)
            yield body, th, om, [np.array([float(value) for value in series]) for series in expected]


@pytest.mark.parametrize("sigma", [0, 1, -1])
def test_coefficients_are_derivatives_of_the_motion(sigma):
    for body, th, om, expected in cases(sigma):
        found = candidate_series(body, th, om, sigma)
        for what in (0, 1, 2) if sigma == 0 else (0, 3):
            series = expected[what]
            np.testing.assert_allclose(found[what], series, rtol=0, atol=1e-12 * np.abs(series).max())


def test_rolling_stays_without_slip():
    body = BODIES[0]
    assert candidate_series(body, 0.4, 1.3, 0)[3] == (0.0,) * TERMS
