"""Laws of the compliant contact: closed forms against numerical solutions, Jacobians, method constants."""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from hophoop.kernel.compliant.motion import jacobian, rates
from hophoop.kernel.compliant.records import DYNAMIC, STAGES
from hophoop.kernel.numerics.tables import RADAU_A, RADAU_A_INVERSE, RADAU_DEFECT, RADAU_GAMMA, RADAU_LAMBDA, RADAU_NODES
from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.compliant import (
    Compliance,
    damping_ratio,
    friction_force,
    hunt_crossley_number,
    ratio_restitution,
    static_excess,
    traction,
)


def contact(law=0, friction=0, k=40.0, c=3.0, d=0.7, v_s=0.3, mu_s=0.8, mu_k=0.5, k_t=20.0, c_t=2.0):
    excess = static_excess(mu_s, mu_k) if friction == 0 else 0.0
    return Compliance(law, friction, k, c, d, v_s, mu_s, mu_k, excess, k_t, c_t)


def bounce(force, speed):
    """Restitution of a unit mass, integrated until its contact ends."""

    def ends(_, u):
        return force(u) if u[1] > 0.0 else 1.0

    ends.terminal = True
    ends.direction = -1.0
    solution = solve_ivp(lambda _, u: [u[1], force(u)], (0.0, 100.0), [0.0, -speed], rtol=1e-11, atol=1e-13, events=ends)
    return solution.y[1, -1] / speed


@pytest.mark.parametrize("ratio", [0.02, 0.3, 0.9, 0.999999, 1.0, 1.000001, 1.5, 4.0])
def test_restitution_of_a_kelvin_voigt_contact(ratio):
    expected = bounce(lambda u: -u[0] - 2.0 * ratio * u[1], 1.0)
    assert ratio_restitution(ratio) == pytest.approx(expected, rel=1e-5)
    assert damping_ratio(ratio_restitution(ratio)) == pytest.approx(ratio, rel=1e-6)


@pytest.mark.parametrize("restitution", [0.05, 0.3, 0.7, 0.99])
@pytest.mark.parametrize("speed", [0.5, 2.0])
def test_restitution_of_a_hunt_crossley_contact(restitution, speed):
    d = hunt_crossley_number(restitution) / speed

    def force(u):
        return -50.0 * u[0] * (1.0 + d * -u[1])

    assert bounce(force, speed) == pytest.approx(restitution, rel=1e-5)


@pytest.mark.parametrize("restitution", [1e-6, 1e-3, 0.02, 1.0])
def test_damping_exists_for_every_restitution(restitution):
    assert math.isfinite(damping_ratio(restitution))
    assert math.isfinite(hunt_crossley_number(restitution))
    assert ratio_restitution(damping_ratio(restitution)) == pytest.approx(restitution, rel=1e-9)


@pytest.mark.parametrize("friction", [0, 1])
@pytest.mark.parametrize(("mu_s", "mu_k"), [(0.5, 0.5), (0.8, 0.5), (0.6, 0.0)])
def test_friction_has_both_coulomb_limits(friction, mu_s, mu_k):
    comp = contact(friction=friction, mu_s=mu_s, mu_k=mu_k, v_s=1e-3)
    speeds = np.linspace(0.0, 0.1, 20001)
    share = [traction(comp, 0 if friction == 0 or v <= 1e-3 else 1, v)[0] for v in speeds]
    assert max(share) == pytest.approx(mu_s, rel=1e-5)  # of the grid
    assert share[-1] == pytest.approx(mu_k, abs=1e-6)
    assert traction(comp, 0, 0.0)[0] == 0.0
    assert traction(comp, -1, -0.05)[0] == -traction(comp, 1, 0.05)[0]


@pytest.mark.parametrize("law", [0, 1])
@pytest.mark.parametrize(("friction", "regime"), [(0, 0), (1, 0), (1, -1), (2, 0), (2, 1)])
def test_jacobian_is_the_derivative(law, friction, regime):
    body = Body(0.6, 0.5, 0.8, 0.5, 0.9, 0.3, 0.0, 2, False, math.atan2(0.3, 0.9))
    comp = contact(law, friction)
    u = np.array([-0.05, 0.9, 0.2 if regime >= 0 else -0.5, -0.1, 1.3, 0.01])
    analytic, plus, minus = np.zeros((DYNAMIC, DYNAMIC)), np.zeros(DYNAMIC), np.zeros(DYNAMIC)
    jacobian(body, comp, regime, u, analytic)
    for j in range(DYNAMIC):
        step = np.zeros(DYNAMIC)
        step[j] = 1e-6
        rates(body, comp, regime, u + step, plus)
        rates(body, comp, regime, u - step, minus)
        np.testing.assert_allclose(analytic[:, j], (plus - minus) / 2e-6, atol=2e-7)


def test_bristle_opposes_its_stretch():
    comp = contact(friction=2)
    assert friction_force(comp, 0, 1.0, 0.1, 0.0)[0] == -2.0
    assert friction_force(comp, 1, 2.0, 0.1, 0.0)[0] == -1.0


def test_method_is_radau_iia_of_order_nine():
    b = RADAU_A[-1]
    for q in range(2 * STAGES - 1):
        assert b @ RADAU_NODES**q == pytest.approx(1.0 / (q + 1), rel=1e-12)
    for q in range(STAGES):
        np.testing.assert_allclose(RADAU_A @ RADAU_NODES**q, RADAU_NODES ** (q + 1) / (q + 1), rtol=1e-12, atol=1e-14)
        # the embedded rule, with 1/γ at the start, integrates the same powers up to one order less
        assert RADAU_DEFECT @ RADAU_NODES**q + (1.0 / RADAU_GAMMA if q == 0 else 0.0) == pytest.approx(0.0, abs=1e-12)
    values = np.linalg.eigvals(RADAU_A_INVERSE)
    for one in (RADAU_GAMMA, *RADAU_LAMBDA):
        assert np.min(np.abs(values - one)) < 1e-9
