"""The program's impacts against exact fractions and against integration over the impulse."""

from __future__ import annotations

import math
from fractions import Fraction as Q
from typing import Any

import numpy as np
import pytest

import hophoop as hh
from hophoop.vocabulary.names import LAW_CODES
from oracle_program import simulate
from oracles import hybrid, mechanics, rational
from oracles.cases import Case

LAWS = tuple(sorted(LAW_CODES))


def impact_at_start(contact: rational.Contact, velocity: tuple[Q, Q, Q], restitution: Q, law: str) -> hh.Trajectory:
    """The program's motion that starts with this impact, R = m = 1."""
    vx, vy, omega = (float(each) for each in velocity)
    case = Case(
        "exact", eccentricity=float(contact.eccentricity), inertia_ratio=float(contact.inertia_ratio),
        mu_static=float(contact.mu_static), mu_kinetic=float(contact.mu_kinetic), restitution=float(restitution),
        impact_law=law, angle=math.atan2(float(contact.sine), float(contact.cosine)), vx=vx, vy=vy, omega=omega,
    )  # fmt: skip
    return simulate(case, duration=1e-3)


def check(motion: hh.Trajectory, exact: dict[str, Any], tolerance: float = 2e-13) -> None:
    """Velocities, impulse and losses of the impact at t = 0."""
    (impact,) = [event for event in motion.find("impact") if event.t == 0.0]
    true = [float(v) for v in exact["velocity"]]
    assert (impact.vx, impact.vy, impact.omega) == pytest.approx(true, rel=0.0, abs=tolerance * max(1.0, *map(abs, true)))
    assert impact.impulse_normal == pytest.approx(float(exact["impulse"]["normal"]), rel=tolerance)
    expected = [float(each) for each in (exact["impulse"]["tangential"], exact["loss_normal"], exact["loss_tangential"])]
    found = (impact.impulse_tangential, impact.impact_normal, impact.impact_tangential)
    assert found == pytest.approx(expected, rel=10 * tolerance, abs=tolerance)
    assert impact.collision is True


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("restitution", [Q(1, 10), Q(1, 2), Q(3, 4), Q(1)])
def test_slip_that_stops_in_either_phase(law: str, restitution: Q) -> None:
    """Exact fractions for slip that ends early, late or never, in either direction, μs above μk too."""
    met = set()
    for sine, cosine in (
        (Q(-4, 5), Q(3, 5)),
        (Q(5, 13), Q(12, 13)),
        (Q(24, 25), Q(-7, 25)),
        (Q(-3, 5), Q(-4, 5)),
    ):
        for mu_kinetic, mu_static in ((Q(1, 8), Q(1, 6)), (Q(1, 3), Q(1, 3)), (Q(4, 5), Q(1))):
            contact = rational.Contact(Q(3, 5), Q(1, 4), sine, cosine, mu_static=mu_static, mu_kinetic=mu_kinetic)
            for vx, omega in ((Q(1, 5), Q(0)), (Q(2), Q(1)), (Q(-1), Q(1)), (Q(-6), Q(3)), (Q(1), Q(1))):
                velocity = (vx, Q(-1), omega)
                exact = rational.collide(contact, velocity, restitution, law)
                before, after = vx - omega, exact["velocity"][0] - exact["velocity"][2]
                met.add((before > 0) - (before < 0) if after == 0 else 2 if after * before < 0 else 3)
                check(impact_at_start(contact, velocity, restitution, law), exact)
    assert met == {-1, 0, 1, 2, 3}  # stuck from either side and from rest, reversed, still slipping


@pytest.mark.parametrize("law", LAWS)
def test_random_impacts_against_integration(law: str) -> None:
    """Any body, size and slip against SciPy's integration over the normal impulse."""
    random = np.random.default_rng(20240)
    gains = 0
    for _ in range(60):
        eccentricity = float(random.uniform(0.0, 0.95))
        mu = float(random.uniform(0.0, 2.0))
        case = Case(
            "impact",
            radius=float(random.uniform(0.2, 2.0)),
            mass=float(random.uniform(0.2, 5.0)),
            eccentricity=eccentricity,
            inertia_ratio=float((1.0 - eccentricity**2) * random.uniform(0.1, 1.0)),
            mu_static=mu * float(random.uniform(1.0, 1.3)),
            mu_kinetic=mu,
            restitution=float(random.choice([0.0, random.uniform(0.0, 1.0)])),
            impact_law=law,
            angle=float(random.uniform(-math.pi, math.pi)),
            vx=float(random.normal() * 3),
            vy=float(-random.uniform(0.1, 5.0)),
            omega=float(random.normal() * 5),
        )
        state = np.array([0.0, 0.0, case.angle, case.vx, case.vy, case.omega, 0.0, 0.0])
        after, more = hybrid.impact(case, state)
        motion = simulate(case, duration=1e-4)
        impact = motion.find("impact")[0]
        size = abs(case.vx) + abs(case.vy) + case.radius * abs(case.omega)
        assert impact.t == 0.0
        speeds = (impact.vx, impact.vy, case.radius * impact.omega)
        assert speeds == pytest.approx((after[3], after[4], case.radius * after[5]), rel=0.0, abs=3e-12 * size), case
        impulse = more["impulse"]
        assert impact.impulse_normal == pytest.approx(impulse["normal"], rel=1e-11)
        assert impact.impulse_tangential == pytest.approx(impulse["tangential"], abs=1e-11 * impulse["normal"] * 3)
        energy = mechanics.kinetic_energy(case, case.angle, state[3:6])
        losses = (impact.impact_normal, impact.impact_tangential)
        assert losses == pytest.approx((more["loss_normal"], more["loss_tangential"]), rel=0.0, abs=1e-11 * energy)
        # the two parts are all that is missing
        left = mechanics.kinetic_energy(case, case.angle, np.array([impact.vx, impact.vy, impact.omega]))
        assert left + impact.impact_normal + impact.impact_tangential == pytest.approx(energy, rel=1e-13)
        gained = left - energy
        if law != "newton":
            assert gained <= 1e-13 * energy
        else:
            kane = motion.find("kane_gain")
            assert bool(kane) == (gained > 1e-13 * energy)
            gains += len(kane)
            if kane:
                assert kane[0].gain == pytest.approx(gained, rel=1e-8, abs=1e-12 * energy)
    assert (gains > 0) == (law == "newton")  # the sample holds a case of what is tested
