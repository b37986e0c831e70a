r"""Impacts worked by hand, and what the three laws of restitution promise.

All of the hand-worked cases are of one body, R = m = 1, in exact fractions. With sin θ = −4/5, cos θ = 3/5 and
ε = 1/2 the lever arms are a = 1 + ε cos θ = 13/10 and b = ε sin θ = −2/5, so that a unit impulse changes the
velocity of the contact point by

    W_tt = 1 + a²/κ,    W_nn = 1 + b²/κ,    W_tn = −ab/κ = (13/25)/κ.

`BLOCK` has κ = 39/100: W = (16/3, 55/39, 4/3). `SHARP` has κ = 1/25: W = (173/4, 5, 13). Slip backwards (v_t < 0)
drags friction r = +μ along, so v_t grows at W_tn + μ W_tt and v_n at W_nn + μ W_tn.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import hophoop as hh
from oracle_program import simulate
from oracles import hybrid, mechanics
from oracles.cases import Case

LAWS = ("newton", "poisson", "stronge")
ANGLE = math.atan2(-0.8, 0.6)
BLOCK = hh.Hoop(radius=1.0, mass=1.0, eccentricity=0.5, inertia_ratio=0.39)
SHARP = hh.Hoop(radius=1.0, mass=1.0, eccentricity=0.5, inertia_ratio=0.04)


def strike(hoop, mu, restitution, law, angle=ANGLE, vx=0.0, vy=0.0, omega=0.0):
    """The impact at t = 0 and the motion that it begins."""
    where = hh.Plane(mu=mu, restitution=restitution, impact_law=law)
    start = hh.Start(angle=angle, vx=vx, vy=vy, omega=omega)
    motion = hh.simulate(hoop, where, start, duration=1e-3, contact=hh.Rigid(max_events=12))
    return motion.find("impact")[0], motion


def test_slip_that_stops_in_compression():
    r"""`BLOCK`, v = (−1, −3), μ = 1/2, e = 1: each law by hand.

    Slip: v_t grows at 4/3 + 8/3 = 4 and stops at p = 1/4; v_n grows at 55/39 + 2/3 = 27/13 to −129/52. Then it sticks
    with r* = −(4/3)/(16/3) = −1/4 and v_n grows at 55/39 − 1/3 = 14/13, zero after another 129/56: p_c = 143/56.
    Compression work: ¼·(3 + 129/52)/2 + (129/52)(129/56)/2 = 20631/5824.

    Newton    v_n = 3.
    Poisson   another 143/56 at 14/13: v_n = 11/4.
    Stronge   v_n² = 2 (14/13)(20631/5824) = 20631/2704: v_n = √20631/52.

    All of the tangential loss is in the slip: ½·1·½·¼ = 1/16.
    """
    expected = {"newton": 3.0, "poisson": 11 / 4, "stronge": math.sqrt(20631) / 52}
    for law, separation in expected.items():
        impact, _ = strike(BLOCK, 0.5, 1.0, law, vx=-1.0, vy=-3.0)
        assert impact.vy == pytest.approx(separation, rel=1e-14), law
        assert impact.slip == 0.0
        assert impact.impact_tangential == pytest.approx(1 / 16, rel=1e-14)
        normal = 143 / 56 + separation / (14 / 13)
        assert impact.impulse_normal == pytest.approx(normal, rel=1e-14)
        assert impact.impulse_tangential == pytest.approx(1 / 8 - (normal - 1 / 4) / 4, rel=1e-13)
    # Stronge's e = 1 gives back all that compression took
    assert strike(BLOCK, 0.5, 1.0, "stronge", vx=-1.0, vy=-3.0)[0].impact_normal == pytest.approx(0, abs=1e-15)


def test_kanes_gain_by_hand():
    r"""The same under Newton's law creates 257/448 J, and `kane_gain` says so.

    Normal work: −(3 + 129/52)/2·¼ + (3 − 129/52)/2·(285/56) = −285/416 + 7695/5824 = 285/448.
    Tangential: −1/16. Together 285/448 − 28/448 = 257/448.
    """
    impact, motion = strike(BLOCK, 0.5, 1.0, "newton", vx=-1.0, vy=-3.0)
    (gain,) = motion.find("kane_gain")
    assert gain.gain == pytest.approx(257 / 448, rel=1e-13)
    assert gain.t == impact.t == 0.0
    assert impact.impact_normal == pytest.approx(-285 / 448, rel=1e-13)
    assert abs(motion.ledger.residual) <= 1e-14 * motion.ledger.range  # reported, and booked


def test_impact_without_collision():
    r"""`SHARP`, v_t = 1, v_n = 0, μ = 1: p_σ = 5 − 13 = −8, an impact though nothing collides.

    v_t falls at 13 − 173/4 = −121/4 and stops at p = 4/121, v_n = −32/121. Stick: r* = −52/173, v_n grows at
    5 − 13·52/173 = 189/173 and is zero at p_c = 4/121 + (32/121)(173/189) = 52/189. Compression work
    ½ (32/121)(52/189) = 832/22869.

    Newton    v_n = 0: there was no approach to give back.
    Poisson   e p_c·189/173 = 52 e/173.
    Stronge   v_n = e √(2 (189/173)(832/22869)) = (e/11) √(1664/173).
    """
    expected = {"newton": 0.0, "poisson": 26 / 173, "stronge": math.sqrt(1664 / 173) / 22}
    for law, separation in expected.items():
        impact, motion = strike(SHARP, 1.0, 0.5, law, vx=1.0)
        (paradox,) = motion.find("painleve_inconsistent")
        assert paradox.t == impact.t == 0.0
        assert impact.collision is False
        assert impact.vy == pytest.approx(separation, rel=1e-13, abs=1e-16), law
        assert impact.slip == 0.0
        normal = 52 / 189 + separation * 173 / 189
        assert impact.impulse_normal == pytest.approx(normal, rel=1e-13)
        assert impact.impulse_tangential == pytest.approx(-4 / 121 - 52 / 173 * (normal - 4 / 121), rel=1e-12)
        assert impact.impact_tangential == pytest.approx(0.5 * 1 * 4 / 121, rel=1e-13)


@settings(max_examples=60)
@given(
    power=st.floats(3.0, 12.0),
    angle=st.floats(-3.0, 3.0),
    vx=st.floats(-3.0, 3.0),
    vy=st.floats(-3.0, -0.1),
    omega=st.floats(-5.0, 5.0),
    law=st.sampled_from(LAWS),
)
def test_an_impact_of_a_nearly_massless_hoop_keeps_its_digits(power, angle, vx, vy, omega, law):
    """1/κ makes W as large as 10¹²; the energy lost and the impulses agree all the same where the contact sticks."""
    hoop = hh.Hoop.ideal(load_fraction=1.0 - 10.0**-power)
    hit, motion = strike(hoop, math.inf, 0.0, law, angle=angle, vx=vx, vy=vy, omega=omega)
    assert abs(motion.ledger.residual) <= 1e-13 * motion.ledger.range
    if hit.vy == 0.0 and hit.slip == 0.0:
        # the momentum of the load along the line that the contact cannot turn: about the contact point
        arm, lever = 1.0 + hoop.eccentricity * math.cos(angle), hoop.eccentricity * math.sin(angle)
        want = (arm * (hit.before.vx - hit.before.omega) - lever * hit.before.vy) / (hoop.inertia_ratio + arm**2 + lever**2)
        assert hit.omega - hit.before.omega == pytest.approx(want, rel=1e-12, abs=1e-12)


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
