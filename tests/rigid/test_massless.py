r"""The massless hoop, γ = 1: rolling, the loss of its contact force, skimming, and what heavy rims do instead.

All of it is the motion of one particle. Rolling, it is at the height R (1 + cos θ) on a cycloid and the force on it
points along the line from the contact, F/N = tan(θ/2). Energy gives (1 + cos θ) R θ̇² = g (1 − cos θ) + 2 v0²/R, so that
N = m (g cos θ − v0²/R); where that is zero, θ̇² = g/R. Then the particle falls freely.
"""

import math

import numpy as np
import pytest

import hophoop as hh

G = 9.81
MASSLESS = hh.Hoop.ideal(1.0)


def roll(speed, mu=2.0, angle=0.0, hoop=MASSLESS, duration=6.0, **plane):
    return hh.simulate(hoop, hh.Plane(mu=mu, **plane), hh.Start.rolling(speed=speed, angle=angle), duration=duration)


@pytest.mark.parametrize("mu", [1.0, 5.0, math.inf])
def test_contact_is_lost_where_the_particle_says(mu):
    """cos θ = v0²/(gR), or where tan(θ/2) = μ if that is sooner; then θ̇ = √(g/R). 90° from rest, as Littlewood has it.

    The margin to the cone is N (1 − tan(θ/2)/μ). Where N comes to zero with a small second factor, 1e-5 at μ = 1 and 0.01 m/s,
    its zero is known to a rounding of the forces over that factor only.
    """
    for speed in (0.01, 1.0, 3.0):
        (skim,) = roll(speed, mu).find("skim")
        by_force, by_friction = math.acos(speed**2 / G), 2 * math.atan(mu)
        known = 1e-12
        if by_force < by_friction:
            known = max(known, 4e-16 / (1.0 - math.tan(0.5 * by_force) / mu))
            assert skim.omega == pytest.approx(math.sqrt(G), rel=known)
        assert skim.angle == pytest.approx(min(by_force, by_friction), rel=known)
        loss = hh.theory.massless_loss(speed, plane=hh.Plane(mu=mu))
        assert (skim.angle, skim.omega) == pytest.approx((loss.angle, loss.omega), rel=max(known, 1e-11))


@pytest.mark.long
def test_heavy_rims_come_to_it():
    """γ = 1 − 10⁻ᵏ down to 10⁻¹²: the first slip goes to the massless loss of contact, but as a skid and not a hop.

    Just before N = 0 the needed friction passes any μ, so that slip begins first; the angle differs by an amount that does
    not vanish with 1 − γ for the mass on the rim that is left must still be turned.
    """
    angles = []
    for k in range(2, 13):
        motion = roll(1.0, hoop=hh.Hoop.ideal(1 - 10.0**-k))
        angles.append(motion.find("slip_start")[0].angle)
        assert motion.sequence.startswith("RKRS")
        # θ itself has so few digits where θ̇ → ∞
        assert abs(motion.ledger.residual) < (1e-12 if k < 5 else 1e-8) * motion.ledger.range
    steps = np.abs(np.diff(angles))
    assert (steps[1:9] < 0.2 * steps[:8]).all()
    assert abs(angles[-1] - math.acos(1.0 / G)) < 1e-9 + abs(angles[0] - math.acos(1.0 / G))
    assert steps[-1] < 1e-10


@pytest.mark.parametrize("angle", [0.0, 5e-324, 1e-9, 2.0 * math.pi - 1e-9])
@pytest.mark.parametrize("way", [1.0, -1.0])
def test_the_load_falls_from_beside_the_top_without_a_turn_more(angle, way):
    """Where cos θ rounds to 1 the load falls on either side; on the other one θ was off by a whole turn."""
    motion, mirrored = (
        hh.simulate(MASSLESS, hh.Plane(mu=5e-324), hh.Start.rolling(sign * way * 3.0, angle=sign * angle), duration=0.05)
        for sign in (1.0, -1.0)
    )
    assert motion.sequence == "M"
    assert motion.events[-1].angle == pytest.approx(angle + way * 0.15676507, abs=2e-9)
    assert [(event.x, event.angle) for event in motion.events] == [(-event.x, -event.angle) for event in mirrored.events]
