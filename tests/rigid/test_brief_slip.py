"""Slip from rest that ends long before the first panel does: in closed form, and against the longer computation."""

import pytest

import hophoop as hh


@pytest.mark.parametrize("speed", [-1e-5, 1e-3, 0.3, 20.0])
@pytest.mark.parametrize(("ratio", "mu"), [(1e6, 1e6), (1e4, 1e4), (0.1, 0.5)])
def test_a_balanced_body_rolls_after_a_brief_slip(ratio, mu, speed):
    """v_t falls by μ g (1 + 1/κ): of a panel as wide as usual its work would be the rounding."""
    body = hh.Hoop(eccentricity=0.0, inertia_ratio=ratio)
    motion = hh.simulate(body, hh.Plane(mu=mu, gravity=5.0), hh.Start(vx=speed, omega=0.0), duration=20.0)
    stick = motion.find("stick")[0]
    found = (stick.t, stick.omega, motion.ledger.friction)
    expected = (abs(speed) / (mu * 5.0 * (1.0 + 1.0 / ratio)), speed / (1.0 + ratio), 0.5 * speed**2 * ratio / (1.0 + ratio))
    assert found == pytest.approx(expected, rel=1e-12)
    assert motion.at(0.5 * stick.t).slip == pytest.approx(0.5 * speed, rel=1e-9)


@pytest.mark.parametrize("speed", [1e-4, -1e-12, 1e-20, -1e-140, 1e-180, -5.6957134631529205e-247])
def test_an_unbalanced_hoop_sticks_after_a_brief_slip(speed):
    """As by 20 digits, which see no rounding; slip that no double can follow, as its square underflows, is over at once."""
    scenario = hh.Scenario(plane=hh.Plane(mu=0.5), start=hh.Start(angle=1.0, vx=speed, omega=0.0), duration=0.1)
    motion = hh.simulate(scenario)
    stick = motion.find("stick")[0]
    if abs(speed) < 1e-150:
        assert (stick.t, stick.slip) == (0.0, 0.0)
        assert motion.sequence == hh.simulate(scenario.replace("start.vx", 0.0)).sequence
        return
    middle = motion.at(0.5 * stick.t)
    assert middle.slip == pytest.approx(0.5 * speed, rel=1e-3)
    assert middle.friction_force * speed < 0.0
    if abs(speed) > 1e-30:
        exact = hh.simulate(scenario, digits=20).find("stick")[0]
        assert (stick.t, stick.omega) == pytest.approx((float(exact.t), float(exact.omega)), rel=1e-9)
