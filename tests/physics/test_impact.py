"""Impacts against the response of a rigid body to impulses; precise/test_impact.py has them in exact fractions."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

from hophoop.kernel.physics import impacts as impact
from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.contact import slip_coefficients
from newton_euler import BODIES, responses


@pytest.mark.parametrize("law", [0, 1, 2])
def test_infinite_friction_is_the_limit_of_high_friction(law):
    body = BODIES[1]._replace(mu_s=1e9, mu_k=1e9, law=law)
    s, c = math.sin(2.0), math.cos(2.0)
    for vt in (0.4, -0.7):
        limit = impact.impact(body._replace(mu_s=math.inf, mu_k=math.inf), 0.5, s, c, vt, -1.0)
        assert limit == pytest.approx(impact.impact(body, 0.5, s, c, vt, -1.0), rel=1e-6, abs=1e-7)


def test_a_stick_at_the_edge_of_the_cone_holds():
    body = Body(0.5, 1.0, 0.25, 0.125, 1.0, 0.0, 0.0, 2, False, 0.0)
    # (1, 1/2) about G: the impulse that keeps v_t is 1/4 of the normal one, exactly
    for lever, ratio in ((0.5, 0.25), (-0.5, -0.25)):
        assert impact.impulse_ratio(body, 1.0, lever, 0.0) == (ratio, True)


def test_the_impact_without_collision_where_p_sigma_is_zero_but_for_rounding():
    """v_n stays 0 while it slips, also where p_σ is computed a little above 0; then Poisson's law bounces.

    By hand: v_t falls at 3 and θ̇ grows at 2 until p = 1/10; sticking with r = −2/5, v_n grows at 6/5 and θ̇ falls at 2/5.
    """
    body = Body(0.5, 0.25 + 1e-12, 1.0, 1.0, 1.0, 0.0, 0.0, 1, False, 0.0)
    found = impact.impact(body, 0.5, -1.0, 0.0, 0.3, 0.0)
    assert found == pytest.approx((0.0, 0.06, 0.18, 0.15, -0.12, -0.0015, 0.015), rel=1e-9, abs=1e-12)


# Painlevé's paradox: the angle at which the plane cannot push the hoop off any more

STEEP = Body(0.75, 0.1, 1.5, 1.5, 1.0, 0.0, 0.0, 2, False, 0.0)


def pushed(body, th, sigma, rho=0.0):
    """(v_t, v_n, θ̇) for a unit of normal impulse, with friction and the couple −ρ, which turns the hoop alone."""
    along, up = responses(body, th)
    turned = -rho / body.kap
    more = (-(1.0 + body.eps * math.cos(th)) * turned, body.eps * math.sin(th) * turned, turned)
    return [u - sigma * body.mu_k * a + m for u, a, m in zip(up, along, more, strict=True)]


def places(body, sigma, rho=0.0):
    """Angles at which p_σ is 0."""

    def p_sigma(th):
        return pushed(body, th, sigma, rho)[1]

    grid = np.linspace(-3.0, 3.0, 601)
    signs = np.sign([p_sigma(th) for th in grid])
    return [brentq(p_sigma, grid[k], grid[k + 1], xtol=1e-15, rtol=1e-15) for k in np.flatnonzero(np.diff(signs))]


@pytest.mark.parametrize(("sigma", "th"), [(sigma, th) for sigma in (-1, 1) for th in places(STEEP, sigma)])
@pytest.mark.parametrize("side", [1, -1])
def test_singular_angle(sigma, th, side):
    """10⁻¹⁰ rad from p_σ = 0, and for the jam 10⁻⁵ rad and 10⁻⁵ of f_n's parts, whatever the slope of p_σ is."""

    def at(distance, u):
        place = th - side * distance
        s, c = math.sin(place), math.cos(place)
        return impact.singular_angle(STEEP, s, c, u, sigma, *slip_coefficients(STEEP, s, c, sigma, 0.0))

    assert at(0.9e-10, 0.5) == (True, True, pytest.approx(side * 0.9e-10, rel=1e-3))
    assert at(1.1e-10, 0.5) == (False, False, 0.0)
    pull = STEEP.eps * math.cos(th)
    if pull > 0.0:
        u = STEEP.gn / pull  # where f_n = 0
        parts = STEEP.gn + STEEP.eps * u
        for distance, off in ((0.9e-5, 0.0), (1.1e-5, 0.0), (1e-9, 0.9e-5), (1e-9, -0.9e-5), (1e-9, 1.1e-5), (1e-9, -1.1e-5)):
            near = max(distance, abs(off)) < 1e-5
            assert at(distance, u + off * parts / pull) == (near, False, 0.0)


@pytest.mark.parametrize("sigma", [-1, 1])
@pytest.mark.parametrize("speed", [0.02, 2.0])
@pytest.mark.parametrize("exact", [True, False])
@pytest.mark.parametrize("f", [0.0, 0.1, 1.0])
def test_singular_slip(sigma, speed, exact, f):
    """An impulse at a fixed angle: by the response to it, to whichever end comes first.

    Without rolling resistance θ̇ turns round to the same speed; where θ̇ = 0 the couple is another, and so is the end.
    """
    body, vt = STEEP._replace(mu_s=2.5, mu_k=2.5), sigma * speed
    for om in (0.3, -0.3, 0.9, -0.9, 0.0123 if f else 0.0):
        rho = math.copysign(f, om)
        for th in places(body, sigma, rho):
            ahead = 1e-5 if exact and f == 0.0 else 0.0
            at = th - ahead
            rate, _, turn = pushed(body, th, sigma, rho)
            ends = [(-vt / rate, "stops")] if vt * rate < 0.0 else []
            pull = body.eps * math.cos(at)
            if turn * om <= 0.0:
                ends.append((-om / turn * (1.0 if f else 2.0), "turns"))
            elif pull > 0.0:  # until θ̇ has grown so far that the centrifugal force lifts the hoop
                ends.append((max((math.copysign(math.sqrt(body.gn / pull), om) - om) / turn, 0.0), "jams"))
            if not ends:
                continue
            p, which = min(ends)
            found = impact.singular_slip(body, math.sin(at), math.cos(at), exact, ahead, vt, om, rho)
            loss = sigma * body.mu_k * (vt * p + 0.5 * rate * p * p)
            assert found == pytest.approx((which == "jams", vt + rate * p, om + turn * p, p, loss), rel=1e-8, abs=1e-10)
            assert which != "stops" or found[1] == 0.0
            assert f == 0.0 or (found[2] == 0.0) == (which == "turns")
