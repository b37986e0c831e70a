"""Formulas of contact space, with rolling resistance, each against Newton's and Euler's equations solved as they stand."""

import math

import numpy as np
import pytest

from hophoop.kernel.physics import contact
from newton_euler import BODIES, STATES, accelerations, responses


def near(value):
    return pytest.approx(value, rel=1e-11, abs=1e-12)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("f", [0.0, 0.03, 0.4, 1.0])
@pytest.mark.parametrize(("th", "om"), STATES)
def test_forces(body, f, th, om):
    body = body._replace(resist=f)
    s, c, u, rho = math.sin(th), math.cos(th), om * om, math.copysign(f, om)
    along, up = responses(body, th)
    assert contact.delassus(body, s, c) == near((along[0], up[1], along[1]))
    ax, opening, alpha, _, _ = accelerations(body, th, om, "free")
    assert contact.free_acceleration(body, s, c, u) == near((ax - alpha, opening))
    _, _, alpha, *forces = accelerations(body, th, om, "roll", rho)
    assert contact.rolling_forces(body, s, c, u, rho) == near(tuple(forces))
    assert contact.acceleration_in_contact(body, s, c, om, 0) == near(alpha)
    for sigma in (-1, 1):
        ax, _, alpha, _, normal = accelerations(body, th, om, sigma, rho)
        assert contact.slip_motion(body, s, c, u, sigma, rho) == near((alpha, normal, ax - alpha))
        assert contact.acceleration_in_contact(body, s, c, om, sigma) == near(alpha)
        # N = −f_n/p_σ
        for stiffness in (contact.kappa_p_sigma(body, s, c, sigma, rho), contact.slip_coefficients(body, s, c, sigma, rho)[1]):
            assert normal * stiffness == near(-opening * body.kap)


@pytest.mark.parametrize(("eps", "kap"), [(0.75, 0.4375), (0.99, 0.0199), (1.0, 1e-4)])
def test_the_most_resistance_is_where_rolling_loses_its_inertia(eps, kap):
    angles = np.linspace(0.0, 2.0 * math.pi, 200_001)
    inertia = 1.0 + kap + eps * eps + 2.0 * eps * np.cos(angles)
    most = contact.most_resistance(eps, kap)
    least = [np.min(inertia - part * most * eps * np.sin(angles)) for part in (0.999, 1.001)]
    assert least[0] > 0.0 > least[1]


def test_utilization():
    """abs(F)/(μ N) with the μ of the phase, 1 in slip also where N vanishes, nan where nothing presses or rubs."""
    rows = [
        (False, -0.3, 2.0, 0.5, 0.4, 0.3),
        (True, 0.8, 2.0, 0.5, 0.4, 1.0),
        (True, 0.0, 0.0, 0.5, 0.4, 1.0),
        (False, 0.1, 1.0, 0.0, 0.0, math.inf),
        (False, 0.0, 1.0, 0.0, 0.0, 0.0),
        (True, 0.0, 1.0, 0.5, 0.0, math.nan),
        (False, 0.0, 0.0, 0.5, 0.4, math.nan),
    ]
    *columns, expected = map(np.array, zip(*rows, strict=True))
    out = np.empty(len(rows))
    contact.utilizations(*columns, out)
    np.testing.assert_allclose(out, expected, rtol=1e-12)
