"""The next mode: against what Newton's and Euler's equations allow, and just beside ties."""

import math

import numpy as np
import pytest
from mpmath import mp, mpf

from hophoop.kernel.physics import modes
from hophoop.kernel.physics.body import Body, Mode
from newton_euler import BODIES, STATES, accelerations, case_of, responses
from oracles import series

ROLL, SPIN, SKID, FLIGHT = modes.ROLL, modes.SPIN, modes.SKID, modes.FLIGHT


def bodies(count, seed):
    random = np.random.default_rng(seed)
    for _ in range(count):
        beta = 0.4 * random.normal()
        mu_k = 1.2 * random.random()
        yield Body(random.random(), 0.03 + random.random(), mu_k * (1.0 + 0.5 * random.random()), mu_k,
                   math.cos(beta), math.sin(beta), 0.0, 2, False, beta), random  # fmt: skip


def p_sigma(body, th, sigma):
    along, up = responses(body, th)
    return up[1] - sigma * body.mu_k * along[1]


def test_from_a_contact_point_at_rest():
    """One of the modes that the equations allow: roll before slip before flight."""
    seen = set()
    for body, random in bodies(600, 1):
        th, om = 6.0 * random.random() - 3.0, 3.0 * random.normal()
        _, _, _, friction, normal = accelerations(body, th, om, "roll")
        rolls = normal > 0.0 and abs(friction) < body.mu_s * normal
        assert modes.can_roll(body, th, om) == rolls
        allowed = {ROLL} if rolls else set()
        for sigma, mode in ((1, SKID), (-1, SPIN)):
            ax, _, alpha, _, normal = accelerations(body, th, om, sigma)
            slips = p_sigma(body, th, sigma) > 0.0 and normal > 0.0 and sigma * (ax - alpha) > 0.0
            assert modes.can_start_slip(body, th, om, sigma) == slips
            allowed |= {mode} if slips and not rolls else set()
        if not allowed:
            assert accelerations(body, th, om, "free")[1] > 0.0
        found = modes.next_mode(body, th, 0.0, om, 0.0)
        assert found in (allowed or {FLIGHT})
        seen.add(found)
    assert seen == {ROLL, SPIN, SKID, FLIGHT}


def test_from_slip():
    """By the signs of p_σ and f_n; where the couple alone makes p_σ negative an impact, which has none, changes nothing."""
    seen = set()
    for body, random in bodies(1500, 12):
        mu = 0.5 + 2.0 * random.random()
        body = body._replace(
            mu_s=mu,
            mu_k=mu,
            kap=0.4 * body.kap,
            resist=random.choice([0.0, 0.4, 1.0]),
            painleve_impact=bool(random.integers(2)),
        )
        th, om, sigma = 6.0 * random.random() - 3.0, 1.5 * random.normal(), random.choice([-1, 1])
        opening = accelerations(body, th, om, "free")[1]
        stiffness = -opening / accelerations(body, th, om, sigma, math.copysign(body.resist, om))[4]
        if min(abs(p_sigma(body, th, sigma)), abs(stiffness), abs(opening)) < 1e-6:
            continue
        if stiffness > 0.0:
            expected = modes.slip_mode(sigma) if opening < 0.0 else FLIGHT
        elif p_sigma(body, th, sigma) > 0.0 and (opening < 0.0 or body.painleve_impact):
            expected = modes.UNDECIDED
        else:
            expected = modes.INCONSISTENT if opening < 0.0 else modes.INDETERMINATE
        assert modes.next_mode(body, th, 0.0, om, float(sigma)) == expected
        seen.add((body.resist, expected))
    assert len(seen) == 5 + 6 + 6


def test_directions_of_slip():
    assert [modes.slip_direction(mode) for mode in Mode] == [0, -1, 1, 0, 0]
    assert [modes.slip_mode(sigma) for sigma in (-1, 1)] == [SPIN, SKID]


TIED = Body(0.8, 0.3, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
PLAIN = Body(0.5, 0.4, 0.0, 0.0, 1.0, 0.0, 0.0, 2, False, 0.0)


@pytest.mark.parametrize("gravity", [1.0, 0.2])
def test_lift_off_that_is_a_tie(gravity):
    """Where f_n = 0 now, f_n a little later in free motion decides; at the top the load comes down."""
    body = TIED._replace(gn=gravity)
    for th in (0.5, -0.5, 1.2, 0.0):
        for way in (1.0, -1.0):
            om = way * math.sqrt(gravity / (body.eps * math.cos(th)))
            opening = np.sign(accelerations(body, th + 1e-4 * om, om, "free")[1])
            assert modes.opening_sign(body, th, om) == opening
            assert modes.next_mode(body, th, 0.0, om, 0.3) == (FLIGHT if opening > 0 else SKID)


def test_without_gravity():
    floating = TIED._replace(gn=0.0)
    signs = [modes.opening_sign(floating, th, om) for th, om in ((0.5 * math.pi, 1.0), (-0.5 * math.pi, 1.0), (0.3, 0.0))]
    assert signs == [-1, 1, 0]
    # nothing presses and nothing pulls: it leaves
    assert modes.can_roll(floating, 0.3, 0.0) is False
    for mu in (0.5, 0.0, math.inf):
        body = floating._replace(mu_s=mu, mu_k=mu)
        assert modes.next_mode(body, 0.3, 0.0, 0.0, 0.4) == FLIGHT
        assert mu == math.inf or modes.next_mode(body, 0.3, 0.0, 0.0, 0.0) == FLIGHT
    assert modes.next_mode(floating._replace(mu_k=3.0), -1.0, 0.0, 0.0, 1.0) == modes.INDETERMINATE  # p_σ < 0
    # a wall: it falls along it, and N stays 0
    for sigma in (-1, 1):
        assert modes.can_start_slip(floating._replace(gt=1.0), 0.3, 0.0, sigma) is False


def test_without_friction():
    """The slip that comes is that of the equations; on the level at the top and at the bottom, that of a little later."""
    seen = set()
    for body, random in bodies(300, 3):
        body = body._replace(mu_s=0.0, mu_k=0.0)
        level = body._replace(gn=1.0, gt=0.0, slope=0.0)
        th, om = 6.0 * random.random() - 3.0, random.normal()
        for one, at, low in ((body, th, 0.0), (level, th, 0.0), (level, 0.0, 0.0), (level, math.pi, 1.2246467991473532e-16)):
            ax, _, alpha, _, normal = accelerations(one, at if at == th else at + 1e-7 * om, om, 1)
            if normal < 1e-3 or abs(ax - alpha) < 1e-12:
                continue
            expected = SKID if ax > alpha else SPIN
            assert modes.next_mode(one, at, low, om, 0.0) == expected
            seen.add((at == th, low, expected))
    assert len(seen) == 6
    assert modes.next_mode(PLAIN, 0.0, 0.0, 0.0, 0.0) == ROLL  # it balances
    for om in (0.0, 0.5, -0.5):
        assert [modes.next_mode(PLAIN, 0.2, 0.0, om, vt) for vt in (0.7, -0.7)] == [SKID, SPIN]
    assert modes.next_mode(PLAIN, 0.2, 0.0, 3.0, 0.0) == FLIGHT  # f_n > 0: the load pulls the rim up
    # θ = 10⁻²⁰: the coming slip is beyond what forces tell, but its sign is not: it leaves a hilltop to its own side
    for th in (1e-20, -1e-20):
        ax, _, alpha, _, _ = accelerations(PLAIN, math.copysign(1e-3, th), 0.0, 1)
        assert modes.next_mode(PLAIN, th, 0.0, 0.0, 0.0) == (SKID if ax > alpha else SPIN)


def test_infinite_friction():
    body = Body(0.6, 0.4, math.inf, math.inf, 1.0, 0.0, 0.0, 2, False, 0.0)
    assert modes.next_mode(body, 1.0, 0.0, 0.1, 0.0) == ROLL
    assert modes.next_mode(body, 1.0, 0.0, 0.1, 0.4) == modes.INCONSISTENT
    assert modes.next_mode(body, 0.0, 0.0, 9.0, 0.4) == FLIGHT


# --- ties: what decides is the motion a little later -----------------------------------------------


def a_little_later(body, th, om, motion, dt=1e-5, rho=0.0):
    """Angle and rate after a short time of rolling, or of slip."""
    alpha = accelerations(body, th, om, motion, rho)[2]
    return th + om * dt + 0.5 * alpha * dt * dt, om + alpha * dt


@pytest.mark.parametrize("sigma", [0, 1, -1])
def test_series_of_a_candidate_motion(sigma):
    """Against the series of the equations in 30 digits, solved order by order."""
    for body, random in bodies(3, 5):
        th, om = random.normal(), random.normal()
        with mp.workdps(30):
            state = tuple(map(mpf, (0.0, 0.0, th, om, 0.0, om)))
            piece = series.expand(series.Parameters(case_of(body)), "RKS"[sigma], 0, state, 0, 5)
            slip = series.derivative([vx - rate for vx, rate in zip(piece.vx, piece.omega, strict=True)])
            normal, friction, slip = (np.array(one[: modes.TERMS], float) for one in (piece.normal, piece.friction, slip))
        norm = math.hypot(1.0, body.mu_s)
        found = modes.candidate_series(body, th, om, sigma)
        expected = [normal, (body.mu_s * normal - friction) / norm, (body.mu_s * normal + friction) / norm, slip]
        for what in (0, 1, 2, 3) if sigma == 0 else (0, 3):
            np.testing.assert_allclose(found[what], expected[what], rtol=0, atol=1e-12 * np.abs(expected[what]).max() + 1e-25)
        assert sigma != 0 or found[3] == (0.0,) * modes.TERMS


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize("sigma", [0, 1, -1])
def test_series_with_rolling_resistance(body, sigma):
    """First derivatives of N and of v̇_t along the motion, from differences."""
    body, motion, step = body._replace(resist=0.2), sigma or "roll", 1e-5
    for th, om in STATES:
        rho = math.copysign(0.2, om)
        ahead, behind = (
            accelerations(body, *a_little_later(body, th, om, motion, dt, rho), motion, rho) for dt in (step, -step)
        )
        ax, _, alpha, _, normal = (ahead - behind) / (2.0 * step)
        found = modes.candidate_series(body, th, om, sigma)
        assert (found[0][1], found[3][1]) == pytest.approx((normal, ax - alpha), rel=1e-6, abs=1e-6)


@pytest.mark.parametrize(("pace", "seed"), [(3.0, 4), (300.0, 8)])
def test_rolling_at_the_edge_of_the_cone(pace, seed):
    """At θ̇² = 10⁵ g/R the rounding of forces is 10⁻¹¹ of gravity, and a tie is still one."""
    seen = set()
    for body, random in bodies(400, seed):
        th, om = 6.0 * random.random() - 3.0, pace * random.normal()
        _, _, _, friction, normal = accelerations(body, th, om, "roll")
        size, brief = (om * om, 1e-5 / abs(om)) if pace > 100.0 else (1.0, 1e-5)
        if normal < 0.05 * size or abs(friction) < 0.02 * size:
            continue
        mu = abs(friction) / normal
        body = body._replace(mu_s=mu, mu_k=mu)
        _, _, _, later, presses = accelerations(body, *a_little_later(body, th, om, "roll", brief), "roll")
        margin = (mu * presses - abs(later)) / size
        if abs(margin) < 1e-7:
            continue
        assert modes.can_roll(body, th, om) == (margin > 0.0)
        sigma = -1 if friction > 0.0 else 1
        if p_sigma(body, th, sigma) > 1e-3:  # else Painlevé's paradox
            expected = ROLL if margin > 0.0 else modes.slip_mode(sigma)
            assert pace > 100.0 or modes.next_mode(body, th, 0.0, om, 0.0) == expected
            ax, _, alpha, _, _ = accelerations(body, *a_little_later(body, th, om, sigma, brief), sigma)
            assert modes.can_start_slip(body, th, om, sigma) == (sigma * (ax - alpha) > 0.0)
            assert not modes.can_start_slip(body, th, om, -sigma)
        seen.add((sigma, margin > 0.0, body.gt > 0.0))
    assert len(seen) == 8


def test_contact_that_begins_where_the_plane_no_longer_presses():
    """Rolling with infinite friction and slip, N = 0 now: N a little later decides."""
    seen = set()
    for body, random in bodies(1000, 6):
        th, sigma = 6.0 * random.random() - 3.0, int(random.choice([-1, 0, 1]))
        motion = sigma or "roll"
        at_rest, turning = (accelerations(body, th, om, motion)[4] for om in (0.0, 1.0))  # linear in θ̇²
        u = at_rest / (at_rest - turning)
        if p_sigma(body, th, sigma) < 1e-2 or not 1e-4 < u < 1600.0:
            continue
        om = random.choice([-1.0, 1.0]) * math.sqrt(u)
        ax, _, alpha, _, _ = accelerations(body, th, om, motion)
        normal = accelerations(body, *a_little_later(body, th, om, motion), motion)[4]
        if abs(normal) < 1e-7 or (sigma and abs(ax - alpha) < 1e-3):
            continue
        if sigma == 0:
            assert modes.can_roll(body._replace(mu_s=math.inf, mu_k=math.inf), th, om) == (normal > 0.0)
        else:
            assert modes.can_start_slip(body, th, om, sigma) == (normal > 0.0 and sigma * (ax - alpha) > 0.0)
        seen.add((sigma, normal > 0.0, sigma * (ax - alpha) > 0.0 if sigma else om > 0.0))
    assert len(seen) == 12


@pytest.mark.parametrize("sigma", [1, -1])
def test_at_painleves_threshold_the_plane_cannot_tell(sigma):
    """Where the plane's answer to friction is 0 within rounding, a slip that presses has no motion and none can start."""
    th = -0.5 * math.pi * sigma
    for mu, expected in ((1.0, modes.INCONSISTENT), (1.0 - 1e-12, modes.slip_mode(sigma)), (1.0 + 1e-12, modes.INCONSISTENT)):
        body = Body(0.5, 0.25, mu, mu, 1.0, 0.0, 0.0, 2, False, 0.0)
        assert modes.next_mode(body, th, 0.0, 0.1, float(sigma)) == expected
        assert modes.can_start_slip(body, th, 0.1, sigma) is False


def test_where_a_push_has_no_answer_at_all():
    """A ring without mass and its load above it: p_σ = 0 exactly. Rule 4: pressed it is inconsistent, lifted it flies."""
    body = Body(1.0, 0.0, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
    for vt in (0.3, -0.3):
        assert modes.next_mode(body, 0.0, 0.0, 0.5, vt) == modes.INCONSISTENT
        assert modes.next_mode(body, 0.0, 0.0, 2.0, vt) == FLIGHT


@pytest.mark.parametrize("slope", [0.5, -0.5])
def test_a_disk_on_a_slope_whose_slip_neither_grows_nor_ends(slope):
    """μ = tan β κ/(1 + κ): friction along the slope is just what rolling needs, for ever; one margin is zero in every order."""
    body = Body(0.0, 1.0, 0.25, 0.25, 1.0, slope, 0.0, 2, False, 0.0)
    assert modes.can_roll(body, 0.3, 1.0) is True
    for sigma in (1, -1):
        assert modes.can_start_slip(body, 0.3, 1.0, sigma) is False


def test_where_rounding_hides_which_of_roll_and_slip_there_is(monkeypatch):
    """What the tests of both refuse is told by the cone alone; without f_n < 0 it flies, and μ = ∞ leaves it open."""
    monkeypatch.setattr(modes, "can_roll", lambda *_: False)
    monkeypatch.setattr(modes, "can_start_slip", lambda *_: False)
    seen = set()
    for body, random in bodies(300, 11):
        th, om = 6.0 * random.random() - 3.0, 1.5 * random.normal()
        _, _, _, friction, normal = accelerations(body, th, om, "roll")
        stiff = body._replace(mu_s=math.inf, mu_k=math.inf)
        found = tuple(modes.next_mode(each, th, 0.0, om, 0.0) for each in (body, stiff))
        if accelerations(body, th, om, "free")[1] > 0.0:
            assert found == (FLIGHT, FLIGHT)
        else:
            slips = SPIN if friction > 0.0 else SKID
            assert found == (ROLL if body.mu_s * normal >= abs(friction) else slips, modes.UNDECIDED)
        seen.add(found)
    assert len(seen) == 4


@pytest.mark.parametrize(("way", "expected"), [(1, SKID), (-1, SPIN)])
def test_a_small_force_beyond_its_rounding_is_no_tie_where_there_is_hardly_friction(way, expected):
    """A balanced ring on a slope of 10⁻¹³ rad needs F = 5·10⁻¹⁴ to roll, 25 times the rounding, and has 10⁻²⁰."""
    body = Body(0.0, 1.0, 1e-20, 1e-20, 1.0, way * 1e-13, 0.0, 2, False, way * 1e-13)
    assert modes.can_roll(body, 0.3, 0.0) is False
    assert modes.next_mode(body, 0.3, 0.0, 0.0, 0.0) == expected


@pytest.mark.parametrize("side", [5e-14, -5e-14])
def test_so_near_the_edge_of_the_cone_what_comes_decides(side):
    """With much friction the rounding of F counts too: 5·10⁻¹⁴ of it inside the cone or outside are a tie."""
    body = Body(0.5, 0.75, 1.0, 1.0, 1.0, 0.0, 0.0, 2, False, 0.0)
    for om in (0.4, -0.4):  # it rolls into the cone backwards only
        _, _, _, friction, normal = accelerations(body, 0.6, om, "roll")
        assert modes.can_roll(body._replace(mu_s=abs(friction) / normal * (1.0 + side)), 0.6, om) == (om < 0.0)
