"""Forces and accelerations with rolling resistance against Newton's and Euler's equations with the couple in them."""

import math

import numpy as np
import pytest

from hophoop.kernel.physics import contact, modes
from newton_euler import BODIES, STATES, accelerations, responses

FS = (0.03, 0.4, 1.0)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("f", FS)
@pytest.mark.parametrize(("th", "om"), STATES)
def test_rolling_and_slip(body, f, th, om):
    body = body._replace(resist=f)
    s, c, u = math.sin(th), math.cos(th), om * om
    rho = math.copysign(f, om)
    assert contact.resistance_arm(body, s, c, om, 0) == rho
    _, _, alpha, friction, normal = accelerations(body, th, om, "roll", rho)
    assert contact.rolling_forces(body, s, c, u, rho) == pytest.approx((friction, normal), rel=1e-12, abs=1e-12)
    assert contact.acceleration_in_contact(body, s, c, om, 0) == pytest.approx(alpha, rel=1e-12, abs=1e-12)
    for sigma in (-1, 1):
        along, _, alpha, _, normal = accelerations(body, th, om, sigma, rho)
        found = contact.slip_motion(body, s, c, u, sigma, rho)
        assert found == pytest.approx((alpha, normal, along - alpha), rel=1e-11, abs=1e-11)
        # N = −f_n/p_σ
        p_sigma = contact.kappa_p_sigma(body, s, c, sigma, rho) / body.kap
        assert normal * p_sigma == pytest.approx(-contact.free_acceleration(body, s, c, u)[1], rel=1e-11)
        exact = contact.exact_slip_coefficients(body, th, 0.0, sigma, rho)[1]
        assert exact / body.kap == pytest.approx(p_sigma, rel=1e-12)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize(("th", "om"), STATES)
def test_without_resistance_there_is_no_couple(body, th, om):
    s, c = math.sin(th), math.cos(th)
    for sigma, mode in ((0, "roll"), (1, 1), (-1, -1)):
        assert contact.resistance_arm(body, s, c, om, sigma) == 0.0
        alpha = accelerations(body, th, om, mode, 0.0)[2]
        assert contact.acceleration_in_contact(body, s, c, om, sigma) == pytest.approx(alpha, rel=1e-11, abs=1e-11)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("f", FS)
def test_at_rest_the_couple_holds_what_it_can(body, f):
    body = body._replace(resist=f)
    held = 0
    for th in np.linspace(-3.0, 3.0, 61):
        s, c = math.sin(th), math.cos(th)
        for sigma, torque in ((0, contact.torque_at_rest(body, s, c) / body.gn), (1, None), (-1, None)):
            need = contact.slip_torque_arm(body, s, c, sigma) if torque is None else torque
            rho = contact.resistance_arm(body, s, c, 0.0, sigma)
            assert abs(rho) <= f
            alpha = contact.acceleration_in_contact(body, s, c, 0.0, sigma)
            if sigma == 0:
                forces = tuple(accelerations(body, th, 0.0, "roll", rho)[3:])
                assert contact.rolling_forces(body, s, c, 0.0, rho) == pytest.approx(forces, rel=1e-11, abs=1e-12)
            if abs(need) <= f:
                held += 1
                assert rho == pytest.approx(need)
                assert alpha == pytest.approx(0.0, abs=1e-15)
            elif contact.kappa_p_sigma(body, s, c, sigma, rho) > 0.0 and contact.rolling_forces(body, s, c, 0.0, 0.0)[1] > 0.0:
                assert rho == math.copysign(f, need)
                assert alpha * need > 0.0
    assert held > 0


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("sigma", [0, 1, -1])
@pytest.mark.parametrize(("th", "om"), STATES)
def test_series_of_the_candidate_motion(body, sigma, th, om):
    """First derivatives of N and of v̇_t along the motion, from differences of the closed forms."""
    body = body._replace(resist=0.2)
    s, c = math.sin(th), math.cos(th)
    if contact.kappa_p_sigma(body, s, c, sigma, contact.resistance_arm(body, s, c, om, sigma)) <= 0.0:
        return
    normal, _, _, slip = modes.candidate_series(body, th, om, sigma)
    step = 1e-5

    def values(tau):
        # by Taylor's series of the motion to the second order
        alpha = contact.acceleration_in_contact(body, math.sin(th), math.cos(th), om, sigma)
        later = th + om * tau + 0.5 * alpha * tau * tau
        rate = om + alpha * tau
        s, c = math.sin(later), math.cos(later)
        if sigma == 0:
            return contact.rolling_forces(body, s, c, rate * rate, contact.resistance_arm(body, s, c, rate, 0))[1], 0.0
        return contact.slip_motion(body, s, c, rate * rate, sigma, contact.resistance_arm(body, s, c, rate, sigma))[1:]

    ahead, behind = values(step), values(-step)
    assert normal[1] == pytest.approx((ahead[0] - behind[0]) / (2.0 * step), rel=1e-6, abs=1e-6)
    assert slip[1] == pytest.approx((ahead[1] - behind[1]) / (2.0 * step), rel=1e-6, abs=1e-6)


@pytest.mark.parametrize(("eps", "kap"), [(0.75, 0.4375), (0.99, 0.0199), (0.3, 0.9), (1.0, 1e-4)])
def test_the_most_resistance_is_where_rolling_loses_its_inertia(eps, kap):
    most = contact.most_resistance(eps, kap)
    angles = np.linspace(0.0, 2.0 * math.pi, 200_001)
    inertia = 1.0 + kap + eps * eps + 2.0 * eps * np.cos(angles)
    for f, sign in ((0.999 * most, 1.0), (1.001 * most, -1.0)):
        assert sign * np.min(inertia - f * eps * np.sin(angles)) > 0.0


def test_what_follows_slip_at_painleves_paradox():
    """Where the couple alone makes p_σ negative an impact, which is without it, would change nothing: that is left open."""
    random = np.random.default_rng(12)
    seen = set()
    for _ in range(3000):
        mu = 0.5 + 2.0 * random.random()
        base = BODIES[2]._replace(
            eps=0.5 + 0.45 * random.random(), kap=0.05 + 0.2 * random.random(), mu_s=mu, mu_k=mu,
            resist=random.choice([0.0, 0.4 * random.random(), 1.0]), painleve_impact=bool(random.integers(2)),
        )  # fmt: skip
        th, om, vt = 6.0 * random.random() - 3.0, 1.5 * random.normal(), random.choice([-1.0, 1.0])
        sigma = int(vt)
        rho = math.copysign(base.resist, om)
        opening = contact.free_acceleration(base, math.sin(th), math.cos(th), om * om)[1]
        along, up = responses(base, th)
        without = up[1] - sigma * mu * along[1]
        normal = accelerations(base, th, om, sigma, rho)[4]
        stiffness = -opening / normal
        if min(abs(without), abs(stiffness), abs(opening)) < 1e-6:
            continue
        if stiffness > 0.0:
            expected = modes.slip_mode(sigma) if opening < 0.0 else modes.FLIGHT
        elif without > 0.0 and (opening < 0.0 or base.painleve_impact):
            expected = modes.UNDECIDED
        else:
            expected = modes.INCONSISTENT if opening < 0.0 else modes.INDETERMINATE
        assert modes.next_mode(base, th, 0.0, om, vt) == expected
        seen.add((expected, base.resist == 0.0, base.resist == 1.0, base.painleve_impact, without > 0.0))
    # (what follows, whether p_σ without the couple is positive): each pair that there can be, with and without the couple
    pairs = {(one[0], bool(one[4])) for one in seen if not one[1]}
    slips = {(modes.SPIN, True), (modes.SKID, True), (modes.FLIGHT, True)}
    paradoxes = {(modes.INCONSISTENT, False), (modes.INDETERMINATE, False)}
    assert pairs >= slips | paradoxes | {(modes.UNDECIDED, True), (modes.INDETERMINATE, True)}
    assert {(one[0], bool(one[4])) for one in seen if one[1]} == slips | paradoxes


def test_a_paradox_that_nothing_presses_is_indeterminate():
    body = BODIES[2]._replace(gn=0.0, mu_s=3.0, mu_k=3.0)
    angles = [
        th for th in np.linspace(-3.0, 3.0, 61) if contact.kappa_p_sigma(body, math.sin(th), math.cos(th), 1, 0.0) < -0.01
    ]
    assert angles
    for th in angles:
        assert modes.next_mode(body, th, 0.0, 0.0, 1.0) == modes.INDETERMINATE
