"""Energies, from the place and the velocity of G."""

import math

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


def test_a_load_at_the_plane_keeps_its_digits():
    """At γ = 1 the load beside θ = π hardly moves: ½ (2 sin² ½δ)² of the way along, ½ sin² δ upwards."""
    body = BODIES[0]._replace(eps=1.0, kap=0.0)
    delta = 1e-4
    along, up = 2.0 * math.sin(0.5 * delta) ** 2, math.sin(delta)
    assert kinetic_energy(body, math.pi - delta, 1.0, 0.0, 0.0, 0.0) == pytest.approx(0.5 * (along**2 + up**2), rel=1e-11)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("state", STATES)
def test_an_angle_in_two_parts(body, state):
    """θ as one number and as two, which differ by the square of the second."""
    th, om = state
    part = 1e-7
    whole = kinetic_energy(body, th + part, om, -0.4, 0.9, 0.0)
    assert kinetic_energy(body, th, om, -0.4, 0.9, part) == pytest.approx(whole, rel=1e-12)
    assert abs(whole / kinetic_energy(body, th, om, -0.4, 0.9, 0.0) - 1.0) > 1e-10  # so that another sign would be seen
