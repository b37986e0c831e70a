"""Rolling: θ̇² from the energy of G's motion alone."""

import math

import pytest

from hophoop.physics.roll import rolling_energy_change, rolling_u
from newton_euler import BODIES, STATES, energy


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("state", STATES)
@pytest.mark.parametrize("turn", [0.6, -1.1, 4.0])
def test_energy_of_rolling_is_kept(body, state, turn):
    th, om = state
    kinetic, potential = energy(body, 0.0, 0.0, th, om, 0.0, om)
    end = th + turn
    _, later = energy(body, turn, 0.0, end, 0.0, 0.0, 0.0)  # the centre has gone as far as the rim has turned
    unit, _ = energy(body, turn, 0.0, end, 1.0, 0.0, 1.0)
    assert rolling_u(body, th, om * om, turn) == pytest.approx((kinetic + potential - later) / unit, rel=1e-11, abs=1e-12)
    gained = rolling_energy_change(body, math.sin(th), math.cos(th), math.sin(turn), 1.0 - math.cos(turn), turn)
    assert gained == pytest.approx(2.0 * (potential - later), rel=1e-11, abs=1e-12)
