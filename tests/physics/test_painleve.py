"""κ p_σ beside zero, where doubles have lost its sign: against 40 digits."""

import math

import pytest
from mpmath import mp, mpf

import hophoop as hh
from hophoop.kernel.physics.contact import exact_slip_coefficients, slip_coefficients
from random_scenarios import draw_beside_a_border, scenario_of


def in_forty_digits(body, th, low, sigma):
    """(q, κ p_σ)."""
    with mp.workdps(40):
        angle = mpf(th) + mpf(low)
        inertia = 1 - mpf(body.eps) ** 2 if body.ideal else mpf(body.kap)
        q = body.eps * mp.sin(angle) + sigma * mpf(body.mu_k) * (1 + body.eps * mp.cos(angle))
        return q, inertia + body.eps * mp.sin(angle) * q


@pytest.mark.parametrize("index", [4, 85, 107, 157, 288, 446])
def test_stiffness_at_the_threshold(index):
    border, sections = draw_beside_a_border(2026, index)
    assert border == "Painlevé"
    scenario = scenario_of(sections)
    body, th = scenario.to_body(), scenario.start.angle
    q, stiffness = in_forty_digits(body, th, 0.0, 1)
    assert abs(stiffness) < 1e-15
    for found in (
        exact_slip_coefficients(body, th, 0.0, 1, 0.0),
        slip_coefficients(body, th, 0.0, math.sin(th), math.cos(th), 1, 0.0),
    ):
        assert found == (pytest.approx(float(q), rel=1e-14), pytest.approx(float(stiffness), rel=1e-12, abs=0.0))


def test_a_rounded_inertia_is_not_that_of_the_ideal_hoop():
    hoop = hh.Hoop.ideal(0.7)
    same = hh.Hoop(eccentricity=hoop.eccentricity, inertia_ratio=hoop.inertia_ratio)
    ideal, given = (hh.Scenario(hoop=each).to_body() for each in (hoop, same))
    assert (ideal.ideal, given.ideal) == (True, False)
    assert exact_slip_coefficients(ideal, 0.0, 0.0, 1, 0.0)[1] - exact_slip_coefficients(given, 0.0, 0.0, 1, 0.0)[
        1
    ] == pytest.approx(float(1 - mpf(0.7) ** 2 - mpf(hoop.inertia_ratio)), abs=2e-16)
