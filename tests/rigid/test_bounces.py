r"""Bounces that accumulate: their limit in time and state, and the thousands before it.

A disk (ε = 0) bounces as a point does. Dropped from h it lands at t₀ = √(2h/g) with v₀ = g t₀; bounce k leaves with
v₀ eᵏ and lasts 2 v₀ eᵏ/g, so that impact k is at t₀ + 2 (v₀/g)(e + … + eᵏ⁻¹) and all are over at

    t∞ = t₀ (1 + e)/(1 − e).

test_oracle_motion has limits of eccentric hoops, with friction.
"""

import mpmath
import pytest

import hophoop as hh

DISK = hh.Hoop.from_parts(radius=0.5, parts=[hh.Disk(2.0, 0.5)])


@pytest.mark.long
@pytest.mark.compiled
def test_thousands_of_bounces_stay_exact():
    """e = 0.999: some twenty thousand impacts at their times, against 40 digits."""
    e, height = 0.999, 0.05
    motion = hh.simulate(DISK, hh.Plane(mu=0.0, restitution=e), hh.Start(height=height), duration=250.0)
    impacts = motion.find("impact")
    with mpmath.workdps(40):
        ratio, first = mpmath.mpf(e), mpmath.sqrt(2 * mpmath.mpf(height) / mpmath.mpf(9.81))
        for k in (0, 1, 10, 100, 1000, 5000, 15_000):
            true = first * (1 + 2 * ratio * (1 - ratio**k) / (1 - ratio))
            assert impacts[k].t == pytest.approx(float(true), rel=5e-13)
            assert impacts[k].before.vy == pytest.approx(float(-9.81 * first * ratio**k), rel=2e-9)
        end = float(first * (1 + ratio) / (1 - ratio))
    assert motion.find("bounce_limit")[0].t == pytest.approx(end, rel=5e-12)
    assert motion.status == "at_rest"
