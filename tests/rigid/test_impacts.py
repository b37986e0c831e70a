"""Impacts: random ones against the oracle, under three laws; precise/test_impact.py has exact fractions."""

import math

import numpy as np
import pytest

from oracle_program import simulate
from oracles import hybrid, mechanics
from oracles.cases import Case

LAWS = ("newton", "poisson", "stronge")


@pytest.mark.parametrize("law", LAWS)
def test_random_impacts(law):
    """Any body, size and slip, in SI units, against the oracle; the energy that is missing or too much."""
    random = np.random.default_rng(20240)
    gains = 0
    for _ in range(60):
        eccentricity, mu = random.uniform(0.0, 0.95), random.uniform(0.0, 2.0)
        case = Case(
            "impact",
            radius=random.uniform(0.2, 2.0),
            mass=random.uniform(0.2, 5.0),
            eccentricity=eccentricity,
            inertia_ratio=(1.0 - eccentricity**2) * random.uniform(0.1, 1.0),
            mu_static=mu * random.uniform(1.0, 1.3),
            mu_kinetic=mu,
            restitution=float(random.choice([0.0, 1.0, random.uniform(0.0, 1.0)])),
            impact_law=law,
            angle=random.uniform(-math.pi, math.pi),
            vx=random.normal() * 3,
            vy=-random.uniform(0.1, 5.0),
            omega=random.normal() * 5,
        )
        velocity = np.array([case.vx, case.vy, case.omega])
        after, right = hybrid.impact(case, np.array([0.0, 0.0, case.angle, *velocity]))
        motion = simulate(case, duration=1e-4)
        impact = motion.find("impact")[0]
        found = np.array([impact.vx, impact.vy, impact.omega])
        before, left = (mechanics.kinetic_energy(case, case.angle, each) for each in (velocity, found))
        assert found == pytest.approx(after[3:6], rel=0.0, abs=1e-12 * math.sqrt(before / case.mass) / min(case.radius, 1.0))
        impulse = right["impulse"]
        assert impact.impulse_normal == pytest.approx(impulse["normal"], rel=1e-12)
        assert impact.impulse_tangential == pytest.approx(impulse["tangential"], abs=1e-12 * impulse["normal"] * 3)
        losses = (impact.impact_normal, impact.impact_tangential)
        assert losses == pytest.approx((right["loss_normal"], right["loss_tangential"]), rel=0.0, abs=1e-12 * before)
        assert left + sum(losses) == pytest.approx(before, rel=1e-13)
        kane = motion.find("kane_gain")
        assert bool(kane) == (left - before > 1e-13 * before)
        gains += len(kane)
        assert not kane or kane[0].gain == pytest.approx(left - before, rel=1e-8, abs=1e-12 * before)
    assert (gains > 0) == (law == "newton")  # the sample holds a case of what is tested
