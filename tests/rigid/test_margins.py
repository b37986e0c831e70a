"""The margins of a mode against Newton's and Euler's equations as one linear system."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.rigid.sampling import MARGINS, margins_of
from newton_euler import BODIES, STATES, accelerations, responses


def margins(body, mode, th, om, slip=0.0, height=0.0):
    return dict(zip(MARGINS, margins_of(body, int(mode), th, 0.0, om, slip, height), strict=True))


def free_opening(body, th, om):
    """ÿ of the lowest point of the rim, without contact."""
    return accelerations(body, th, om, "free")[1]


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize(("th", "om"), STATES)
def test_rolling_has_its_forces_and_its_cone(body, th, om):
    found = margins(body, Mode.ROLL, th, om, 0.25, 0.5)
    friction, normal = accelerations(body, th, om, "roll")[3:]
    expected = [normal, friction, body.mu_s * normal, free_opening(body, th, om), 0.25, 0.5, math.nan]
    np.testing.assert_allclose(list(found.values()), expected, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize(("mode", "sigma"), [(Mode.SKID, 1), (Mode.SPIN, -1)])
@pytest.mark.parametrize(("th", "om"), STATES)
def test_slip_has_the_friction_against_it_and_its_stiffness(body, mode, sigma, th, om):
    found = margins(body, mode, th, om, 0.25 * sigma)
    friction, normal = accelerations(body, th, om, sigma)[3:]
    tangential, plain = responses(body, th)
    p_sigma = plain[1] - sigma * body.mu_k * tangential[1]  # ÿ of the rim for a unit of N with its friction
    expected = [normal, friction, body.mu_k * normal, free_opening(body, th, om), 0.25 * sigma, 0.0, p_sigma]
    np.testing.assert_allclose(list(found.values()), expected, rtol=1e-11, atol=1e-12)


@pytest.mark.parametrize("mode", [Mode.FLIGHT, Mode.SKIM])
@pytest.mark.parametrize("mu", [0.5, math.inf])
def test_without_contact_there_are_no_forces(mode, mu):
    body = BODIES[0]._replace(mu_s=mu, mu_k=mu)
    found = margins(body, mode, 0.4, 1.3, 0.25, 0.5)
    expected = [0.0, 0.0, 0.0, free_opening(body, 0.4, 1.3), 0.25, 0.5, math.nan]
    np.testing.assert_allclose(list(found.values()), expected, rtol=1e-14)


@pytest.mark.parametrize("mode", [Mode.SKID, Mode.SPIN])
@pytest.mark.parametrize(("gamma", "mu"), [(1.0, 0.5), (0.75, math.inf)])
def test_slip_without_a_mass_in_the_rim_or_a_limit_of_friction_is_not_described(mode, gamma, mu):
    body = hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(mu=mu)).to_body()
    found = margins(body, mode, 0.4, 0.5)
    assert all(math.isnan(found[name]) for name in ("normal_force", "friction_force", "friction_limit", "p_sigma"))
    assert found["free_acceleration"] == pytest.approx(free_opening(body._replace(kap=1.0), 0.4, 0.5), rel=1e-14)


def test_a_massive_rim_is_described_too():
    """κ above 1, as where the mass is on arms outside of the rim."""
    body = BODIES[0]._replace(kap=1.75)
    found = margins(body, Mode.SKID, 0.4, 1.3)
    assert found["normal_force"] == pytest.approx(accelerations(body, 0.4, 1.3, 1)[4], rel=1e-12)


@pytest.mark.parametrize("mu", [0.5, math.inf])
def test_a_load_of_zero_holds_nothing(mu):
    """Without weight N is zero exactly, and so is μ N, whatever μ."""
    body = hh.Scenario(hoop=hh.Hoop.ideal(0.0), plane=hh.Plane(mu=mu, gravity=0.0)).to_body()
    found = margins(body, Mode.ROLL, 0.4, 1.0)
    assert (found["normal_force"], found["friction_limit"]) == (0.0, 0.0)


def test_a_plane_without_slip_has_no_limit_where_it_presses():
    body = hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=hh.Plane(mu=math.inf)).to_body()
    for omega, pulls, limit in ((0.0, False, math.inf), (1.5, True, -math.inf), (3.0, True, -math.inf)):
        found = margins(body, Mode.ROLL, 0.0, omega)
        assert (found["normal_force"] < 0.0, found["friction_limit"]) == (pulls, limit)
