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

LAWS = ("newton", "poisson", "stronge")
ANGLE = math.atan2(-0.8, 0.6)
BLOCK = hh.Hoop(radius=1.0, mass=1.0, eccentricity=0.5, inertia_ratio=0.39)
SHARP = hh.Hoop(radius=1.0, mass=1.0, eccentricity=0.5, inertia_ratio=0.04)


def strike(hoop, mu, restitution, law, angle=ANGLE, vx=0.0, vy=0.0, omega=0.0, **plane):
    """The impact at t = 0 and the motion that it begins."""
    where = hh.Plane(mu=mu, restitution=restitution, impact_law=law, **plane)
    start = hh.Start(angle=angle, vx=vx, vy=vy, omega=omega)
    motion = hh.simulate(hoop, where, start, duration=1e-3, contact=hh.Rigid(max_events=12))
    return motion.find("impact")[0], motion


def kinetic(hoop, angle, vx, vy, omega):
    """½ m (ẋ_G² + ẏ_G²) + ½ κ m R² θ̇² [J], from the velocity of the centre."""
    arm = hoop.eccentricity * hoop.radius
    along = vx + arm * omega * math.cos(angle)
    up = vy - arm * omega * math.sin(angle)
    return 0.5 * hoop.mass * (along**2 + up**2) + 0.5 * hoop.inertia * omega**2


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
    after = kinetic(BLOCK, ANGLE, impact.vx, impact.vy, impact.omega)
    before = kinetic(BLOCK, ANGLE, -1.0, -3.0, 0.0)
    assert after - before == pytest.approx(257 / 448, rel=1e-13)
    assert abs(motion.ledger.residual) <= 1e-14 * motion.ledger.range  # reported, and booked
    for law in ("poisson", "stronge"):
        assert not strike(BLOCK, 0.5, 1.0, law, vx=-1.0, vy=-3.0)[1].find("kane_gain")


def test_poissons_law_too_can_give_back_more_than_compression_took():
    r"""`BLOCK`, v = (1, −3), μ = 1/2, e = 1: the normal direction gains 3/32 J, and slip loses twice that.

    Slip: v_t falls at 4/3 − 8/3 = −4/3 and stops at p = 3/4; v_n grows at 55/39 − 2/3 = 29/39 to −127/52. Then it sticks
    and v_n grows faster, at 14/13, zero after another 127/56: p_c = 169/56. Restitution, all of it at 14/13, ends at
    v_n = 13/4. Normal work: −¾·(3 + 127/52)/2 − ½·(127/52)(127/56) + ½·(13/4)(169/56) = (28561 − 28015)/5824 = 3/32.
    Tangential loss: ½·1·½·¾ = 3/16. With e ≤ 0.99 the first is a loss: 28561 e² < 28015.
    """
    impact, motion = strike(BLOCK, 0.5, 1.0, "poisson", vx=1.0, vy=-3.0)
    assert impact.vy == pytest.approx(13 / 4, rel=1e-14)
    assert impact.impact_normal == pytest.approx(-3 / 32, rel=1e-12)
    assert impact.impact_tangential == pytest.approx(3 / 16, rel=1e-13)
    lost = kinetic(BLOCK, ANGLE, 1.0, -3.0, 0.0) - kinetic(BLOCK, ANGLE, impact.vx, impact.vy, impact.omega)
    assert lost == pytest.approx(3 / 32, rel=1e-12)
    assert not motion.find("kane_gain")
    assert motion.ledger.impact_normal == impact.impact_normal
    assert strike(BLOCK, 0.5, 0.99, "poisson", vx=1.0, vy=-3.0)[0].impact_normal > 0.0
    assert strike(BLOCK, 0.5, 1.0, "stronge", vx=1.0, vy=-3.0)[0].impact_normal == pytest.approx(0.0, abs=1e-14)


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


def test_elastic_frictionless_bounces_conserve_energy():
    """e = 1 without friction: hundreds of bounces of an eccentric hoop keep every joule, under each law."""
    hoop = hh.Hoop(radius=0.7, mass=2.0, eccentricity=0.6, inertia_ratio=0.2)
    for law in LAWS:
        plane = hh.Plane(mu=0.0, restitution=1.0, impact_law=law)
        start = hh.Start(height=0.4, angle=0.9, vx=1.0, omega=-3.0)
        motion = hh.simulate(hoop, plane, start, duration=120.0)
        assert len(motion.find("impact")) > 100
        first, last = motion.at(0.0), motion.at(motion.duration)
        assert last.total == pytest.approx(first.total, abs=1e-12 * motion.ledger.range), law
        lost = motion.ledger
        assert lost.friction == 0.0
        assert abs(lost.impact_normal) <= 1e-12 * lost.range
        assert lost.impact_tangential == 0.0
        momentum = motion.at(motion.times(50))
        along = momentum.vx + 0.42 * momentum.omega * np.cos(momentum.angle)
        np.testing.assert_allclose(along, along[0], rtol=1e-12)


@settings(max_examples=120)
@given(
    eccentricity=st.floats(0.0, 0.98),
    share=st.floats(0.02, 1.0),
    angle=st.floats(-math.pi, math.pi),
    mu=st.floats(0.0, 3.0),
    ratio=st.floats(0.0, 1.0),
    restitution=st.floats(0.0, 1.0),
    vx=st.floats(-5.0, 5.0),
    vy=st.floats(-5.0, 0.0),
    omega=st.floats(-5.0, 5.0),
    law=st.sampled_from(LAWS),
)
def test_impacts_are_dissipative(eccentricity, share, angle, mu, ratio, restitution, vx, vy, omega, law):
    """Energy never grows under Poisson's and Stronge's laws; under Newton's it grows by what `kane_gain` says.

    The impulse lies in the friction cone, the rim does not go on into the plane, and the losses are what is missing.
    """
    hoop = hh.Hoop(radius=1.0, mass=1.0, eccentricity=eccentricity, inertia_ratio=share * (1 - eccentricity**2))
    plane = hh.Plane(mu_static=mu, mu_kinetic=mu * ratio, restitution=restitution, impact_law=law, painleve="impact")
    start = hh.Start(angle=angle, vx=vx, vy=vy, omega=omega)
    # a slow elastic approach would bounce thousands of times in any duration
    motion = hh.simulate(hoop, plane, start, duration=1e-6, contact=hh.Rigid(max_events=12))
    scale = kinetic(hoop, angle, vx, vy, omega) + 1e-300
    impacts = [event for event in motion.find("impact") if event.t == 0.0]
    for impact in impacts:
        before = kinetic(hoop, angle, impact.before.vx, impact.before.vy, impact.before.omega)
        after = kinetic(hoop, angle, impact.vx, impact.vy, impact.omega)
        assert impact.vy >= 0.0
        assert impact.impulse_normal >= 0.0
        assert abs(impact.impulse_tangential) <= mu * impact.impulse_normal * (1 + 1e-13) + 1e-300
        if law != "newton":
            assert after <= before + 1e-13 * scale
    if len(impacts) == 1:
        gained = after - before
        assert impact.impact_normal + impact.impact_tangential == pytest.approx(-gained, abs=1e-12 * scale)
        assert impact.impact_tangential >= -1e-15 * scale
        gains = motion.find("kane_gain")
        if gains:
            assert law == "newton"
            assert gains[0].gain == pytest.approx(gained, rel=1e-6, abs=1e-12 * scale)
        else:
            assert gained <= 1e-12 * scale


def test_infinite_friction_stops_slip_at_once():
    r"""μ = ∞: an impulse along the plane alone ends the slip; then `BLOCK` sticks with r* = −1/4.

    v = (−1, −3): the stop takes p_t = 1/W_tt = 3/16 and gives v_n = −3 + (4/3)(3/16) = −11/4, ended by
    p_n = (11/4)(13/14) = 143/56.
    """
    impact, _ = strike(BLOCK, math.inf, 0.0, "stronge", vx=-1.0, vy=-3.0)
    assert impact.slip == 0.0
    assert impact.impulse_normal == pytest.approx(143 / 56, rel=1e-14)
    assert impact.impulse_tangential == pytest.approx(3 / 16 - 143 / 224, rel=1e-14)
    close = strike(BLOCK, 1e6, 0.0, "stronge", vx=-1.0, vy=-3.0)[0]  # and it is the limit of large μ
    assert close.vx == pytest.approx(impact.vx, rel=1e-5)
    assert close.impact_tangential == pytest.approx(impact.impact_tangential, rel=1e-5)


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
    hit, _ = strike(hoop, math.inf, 0.0, law, angle=angle, vx=vx, vy=vy, omega=omega)
    before = kinetic(hoop, angle, hit.before.vx, hit.before.vy, hit.before.omega)
    after = kinetic(hoop, angle, hit.vx, hit.vy, hit.omega)
    assert hit.impact_normal + hit.impact_tangential == pytest.approx(before - after, rel=0, abs=1e-13 * before)
    if hit.vy == 0.0 and hit.slip == 0.0:
        # the momentum of the load along the line that the contact cannot turn: about the contact point
        arm, lever = 1.0 + hoop.eccentricity * math.cos(angle), hoop.eccentricity * math.sin(angle)
        turned = hit.omega - hit.before.omega
        slip = hit.before.vx - hit.before.omega
        want = (arm * slip - lever * hit.before.vy) / (hoop.inertia_ratio + arm**2 + lever**2)
        assert turned == pytest.approx(want, rel=1e-12, abs=1e-12)
