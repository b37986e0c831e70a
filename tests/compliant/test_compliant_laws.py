"""Damping for extreme restitutions, and the Jacobian of the equations; tests/physics has the laws."""

import math

import numpy as np
import pytest

from hophoop.kernel.compliant.motion import jacobian, rates
from hophoop.kernel.compliant.records import DYNAMIC
from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.compliant import Compliance, damping_ratio, ratio_restitution


@pytest.mark.parametrize("restitution", [1e-6, 0.02, 1.0])
def test_damping_exists_for_every_restitution(restitution):
    assert ratio_restitution(damping_ratio(restitution)) == pytest.approx(restitution, rel=1e-9)


@pytest.mark.parametrize("law", [0, 1])
@pytest.mark.parametrize(("friction", "regime"), [(0, 0), (1, 0), (1, -1), (2, 0), (2, 1)])
def test_jacobian_is_the_derivative(law, friction, regime):
    body = Body(0.6, 0.5, 0.8, 0.5, 0.9, 0.3, 0.0, 2, False, math.atan2(0.3, 0.9), resist=0.05)
    comp = Compliance(law, friction, 40.0, 3.0, 0.7, 0.3, 0.8, 0.5, 0.3, 20.0, 2.0)
    u = np.array([-0.05, 0.9, 0.2 if regime >= 0 else -0.5, -0.1, 1.3, 0.01])
    analytic, plus, minus = np.zeros((DYNAMIC, DYNAMIC)), np.zeros(DYNAMIC), np.zeros(DYNAMIC)
    jacobian(body, comp, regime, u, analytic)
    for j in range(DYNAMIC):
        step = np.zeros(DYNAMIC)
        step[j] = 1e-6
        rates(body, comp, regime, u + step, plus)
        rates(body, comp, regime, u - step, minus)
        np.testing.assert_allclose(analytic[:, j], (plus - minus) / 2e-6, atol=2e-7)
