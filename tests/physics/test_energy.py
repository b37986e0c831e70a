"""Energies, from the place and the velocity of G."""

import pytest

from hophoop.kernel.physics.closed_forms import kinetic_energy, potential_energy
from newton_euler import BODIES, STATES, energy


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("state", STATES)
def test_energies(body, state):
    th, om = state
    x, y, vt, vn = 0.7, 0.3, -0.4, 0.9
    kinetic, potential = energy(body, x, y, th, vt + om, vn, om)
    assert kinetic_energy(body, th, om, vt, vn, 0.0) == pytest.approx(kinetic, rel=1e-13)
    _, zero = energy(body, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    assert potential_energy(body, x, y, th) == pytest.approx(potential - zero, rel=1e-12)
