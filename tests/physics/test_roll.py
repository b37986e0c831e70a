"""Rolling: θ̇² from the energy of G's motion alone."""

import math

import pytest

from hophoop.kernel.physics.closed_forms import rest_curvature, rolling_energy_change
from newton_euler import BODIES, energy


@pytest.mark.parametrize("slope", [1.0, -1.0, 0.3])
def test_what_the_slope_gives_where_gravity_along_it_is_one(slope):
    """The way down a slope counts, whatever its number is: over an angle φ the centre goes down by φ."""
    body = BODIES[0]._replace(gn=0.4, gt=slope)
    for turn in (0.6, -1.1):
        _, before = energy(body, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0)
        _, later = energy(body, turn, 0.0, 0.5 + turn, 0.0, 0.0, 0.0)
        gained = rolling_energy_change(body, math.sin(0.5), math.cos(0.5), math.sin(turn), 1.0 - math.cos(turn), turn)
        assert gained == pytest.approx(2.0 * (before - later), rel=1e-11)


@pytest.mark.parametrize("body", BODIES)
def test_how_the_potential_of_rolling_bends(body):
    """V″ by differences of V: what decides whether rest is stable."""
    step = 1e-4
    for th in (0.0, 0.7, -2.0, 3.0):
        low, mid, high = (energy(body, turn, 0.0, th + turn, 0.0, 0.0, 0.0)[1] for turn in (-step, 0.0, step))
        found = rest_curvature(body, math.sin(th), math.cos(th))
        assert found == pytest.approx((low - 2.0 * mid + high) / step**2, rel=1e-6, abs=1e-6)
