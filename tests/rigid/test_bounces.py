r"""Bounces that accumulate: their limit in time and state, and the thousands before it.

A disk (ε = 0) bounces as a point does. Dropped from h it lands at t₀ = √(2h/g) with v₀ = g t₀; bounce k leaves with
v₀ eᵏ and lasts 2 v₀ eᵏ/g, so that impact k is at t₀ + 2 (v₀/g)(e + … + eᵏ⁻¹) and all are over at

    t∞ = t₀ (1 + e)/(1 − e).

Up to then the total normal impulse is m v₀ + m g (t∞ − t₀), which is also what friction had at its disposal. For an eccentric
hoop there is no such sum; there the limit must be the one that the times of the bounces run to.
"""

from __future__ import annotations

import math

import mpmath
import pytest

import hophoop as hh

DISK = hh.Hoop.from_parts(radius=0.5, parts=[hh.Disk(2.0, 0.5)])


def limit_of(motion):
    """The one bounce_limit of a motion."""
    (limit,) = motion.find("bounce_limit")
    return limit


@pytest.mark.parametrize("restitution", [1e-6, 0.1, 0.5, 0.9, 0.99])
@pytest.mark.parametrize("law", ["newton", "poisson", "stronge"])
def test_limit_of_a_disk(restitution, law):
    """Time and place of the limit, to rounding."""
    plane = hh.Plane(mu=0.0, restitution=restitution, impact_law=law)
    first = math.sqrt(2 * 0.3 / 9.81)
    end = first * (1 + restitution) / (1 - restitution)
    motion = hh.simulate(DISK, plane, hh.Start(height=0.3, vx=1.5, omega=2.0), duration=end + 0.25)
    limit = limit_of(motion)
    assert limit.t == pytest.approx(end, rel=2e-12)
    assert limit.x == pytest.approx(1.5 * end, rel=2e-12)
    assert limit.height == limit.vy == 0.0
    assert limit.to_mode == "K"  # ẋ > Rθ̇: it goes on sliding
    assert limit.impact_normal == pytest.approx(2.0 * 9.81 * 0.3, rel=1e-12)
    assert motion.sequence.endswith("HK")
    assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range
    after = motion.at(end + 0.2)
    assert (after.height, after.vx, after.omega) == pytest.approx((0.0, 1.5, 2.0), rel=1e-11)


@pytest.mark.long
@pytest.mark.compiled
def test_thousands_of_bounces_stay_exact():
    """e = 0.999: every one of some twenty thousand impacts at its time, against 40 digits."""
    e, height = 0.999, 0.05
    plane = hh.Plane(mu=0.0, restitution=e)
    motion = hh.simulate(DISK, plane, hh.Start(height=height), duration=250.0)
    impacts = motion.find("impact")
    assert len(impacts) > 15_000
    with mpmath.workdps(40):
        ratio, first = mpmath.mpf(e), mpmath.sqrt(2 * mpmath.mpf(height) / mpmath.mpf(9.81))
        for k in (0, 1, 10, 100, 1000, 5000, 10_000, 15_000):
            true = first * (1 + 2 * ratio * (1 - ratio**k) / (1 - ratio))
            assert impacts[k].t == pytest.approx(float(true), rel=5e-13)
            assert impacts[k].before.vy == pytest.approx(float(-9.81 * first * ratio**k), rel=2e-9)
        end = float(first * (1 + ratio) / (1 - ratio))
    assert limit_of(motion).t == pytest.approx(end, rel=5e-12)
    assert motion.status == "at_rest"
    assert abs(motion.ledger.residual) <= 1e-11 * motion.ledger.range


@pytest.mark.parametrize(("mu", "ends"), [(0.02, "S"), (0.5, "R")])
def test_friction_over_all_bounces(mu, ends):
    r"""A disk with spin: over all bounces friction has the impulse P = m v₀ + m g (t∞ − t₀) to work with.

    ẋ = μ P/m and θ̇ = ω − 2 μ P/(m R) while it slips; if that is more than enough it rolls, ẋ = R ω/3 = R θ̇.
    """
    e, spin = 0.6, 20.0
    first = math.sqrt(2 * 0.3 / 9.81)
    end = first * (1 + e) / (1 - e)
    motion = hh.simulate(DISK, hh.Plane(mu=mu, restitution=e), hh.Start(height=0.3, omega=spin), duration=end + 0.1)
    limit = limit_of(motion)
    assert limit.t == pytest.approx(end, rel=2e-12)
    assert limit.to_mode == ends
    impulse = 9.81 * end  # per mass: v₀ = g t₀
    if ends == "S":
        assert limit.vx == pytest.approx(mu * impulse, rel=1e-11)
        assert limit.omega == pytest.approx(spin - 2 * mu * impulse / 0.5, rel=1e-11)
        assert motion.at(end + 0.1).vx == pytest.approx(mu * (impulse + 9.81 * 0.1), rel=1e-11)
    else:
        assert limit.vx == pytest.approx(0.5 * spin / 3, rel=1e-13)
        assert limit.slip == 0.0


@pytest.mark.parametrize("law", ["newton", "poisson", "stronge"])
@pytest.mark.parametrize("restitution", [0.3, 0.7, 0.95])
@pytest.mark.parametrize(("angle", "omega", "mu", "slope"), [(0.4, 2.0, 0.4, 0.0), (2.5, -1.0, 0.1, 0.3), (3.0, 0.5, 0.0, 0.0)])
def test_limit_of_an_eccentric_hoop(law, restitution, angle, omega, mu, slope):
    """The impacts' times run to the limit: the last gaps are those of a geometric series that ends there.

    With r the ratio of the last two gaps, what is missing after the last impact is gap·r/(1 − r).
    """
    hoop = hh.Hoop(radius=1.0, mass=1.0, eccentricity=0.5, inertia_ratio=0.3)
    plane = hh.Plane(mu=mu, restitution=restitution, impact_law=law, slope=slope)
    motion = hh.simulate(hoop, plane, hh.Start(height=0.02, angle=angle, omega=omega), duration=8.0)
    limits = motion.find("bounce_limit")
    assert limits, motion
    impacts = [event for event in motion.find("impact") if event.t < limits[0].t]
    assert len(impacts) >= 5
    # far enough from the end for the gaps to have digits, near enough for their ratio to be constant
    k = max(i for i, event in enumerate(impacts) if event.t < limits[0].t - 1e-6)
    gaps = [impacts[i + 1].t - impacts[i].t for i in (k - 2, k - 1)]
    ratio = gaps[1] / gaps[0]
    assert 0.0 < ratio < 1.0
    rest = gaps[1] * ratio / (1 - ratio)
    assert limits[0].t == pytest.approx(impacts[k].t + rest, abs=2e-3 * rest + 1e-12)
    assert limits[0].vy == 0.0
    assert limits[0].to_mode in "RSK"
    assert abs(motion.ledger.residual) <= 1e-11 * motion.ledger.range


def test_elastic_bounces_do_not_end():
    """e = 1 has no limit: without a loss there is nothing to close."""
    motion = hh.simulate(DISK, hh.Plane(restitution=1.0), hh.Start(height=0.1), duration=60.0)
    assert not motion.find("bounce_limit")
    assert motion.status == "completed"
    period = 2 * math.sqrt(2 * 0.1 / 9.81)
    impacts = motion.find("impact")
    assert impacts[-1].t == pytest.approx((len(impacts) - 0.5) * period, rel=1e-12)
