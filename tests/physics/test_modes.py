"""The next mode: against what Newton's and Euler's equations allow, and just beside ties."""

import math

import numpy as np
import pytest

from hophoop.kernel.physics import modes
from hophoop.kernel.physics.body import Body
from newton_euler import accelerations, responses

ROLL, SPIN, SKID, FLIGHT = modes.ROLL, modes.SPIN, modes.SKID, modes.FLIGHT


def bodies(count, seed):
    random = np.random.default_rng(seed)
    for _ in range(count):
        beta = 0.4 * random.normal()
        mu_k = 1.2 * random.random()
        yield Body(random.random(), 0.03 + random.random(), mu_k * (1.0 + 0.5 * random.random()), mu_k,
                   math.cos(beta), math.sin(beta), 0.0, 2, False, beta), random  # fmt: skip


def allowed_without_slip(body, th, om):
    """Modes from v_t = 0 that the equations allow, none of them a tie."""
    found = set()
    _, _, _, friction, normal = accelerations(body, th, om, "roll")
    if normal > 0.0 and abs(friction) < body.mu_s * normal:
        found.add(ROLL)
    for sigma, mode in ((1, SKID), (-1, SPIN)):
        ax, _, alpha, _, normal = accelerations(body, th, om, sigma)
        along, up = responses(body, th)
        if up[1] - sigma * body.mu_k * along[1] > 0.0 and normal > 0.0 and sigma * (ax - alpha) > 0.0:
            found.add(mode)
    if accelerations(body, th, om, "free")[1] > 0.0:
        found.add(FLIGHT)
    return found


def test_from_a_contact_point_at_rest():
    seen = set()
    for body, random in bodies(600, 1):
        th, om = 6.0 * random.random() - 3.0, 3.0 * random.normal()
        mode = modes.next_mode(body, th, 0.0, om, 0.0)
        allowed = allowed_without_slip(body, th, om)
        assert mode in allowed
        # rule 1: roll before slip before flight
        assert mode == (ROLL if ROLL in allowed else mode)
        assert mode != FLIGHT or not allowed & {SPIN, SKID}
        assert modes.can_roll(body, th, om) == (ROLL in allowed)
        for sigma, slip in ((1, SKID), (-1, SPIN)):
            assert modes.can_start_slip(body, th, om, sigma) == (slip in allowed)
        seen.add(mode)
    assert seen == {ROLL, SPIN, SKID, FLIGHT}


def test_while_it_slips():
    seen = set()
    for body, random in bodies(900, 2):
        body = body._replace(mu_k=3.0 * body.mu_k, mu_s=3.0 * body.mu_s)
        th, om, vt = 6.0 * random.random() - 3.0, 3.0 * random.normal(), random.normal()
        sigma = 1 if vt > 0.0 else -1
        along, up = responses(body, th)
        pushes = up[1] - sigma * body.mu_k * along[1] > 0.0
        presses = accelerations(body, th, om, "free")[1] < 0.0
        expected = {
            (True, True): SKID if sigma > 0 else SPIN,
            (True, False): FLIGHT,
            (False, True): modes.INCONSISTENT,
            (False, False): modes.INDETERMINATE,
        }[pushes, presses]
        assert modes.next_mode(body, th, 0.0, om, vt) == expected
        seen.add(expected)
    assert seen == {SPIN, SKID, FLIGHT, modes.INCONSISTENT, modes.INDETERMINATE}


def test_codes_and_letters_of_slip():
    assert (modes.INCONSISTENT, modes.INDETERMINATE, modes.UNDECIDED) == (10, 11, 12)
    assert [modes.slip_direction(mode) for mode in (ROLL, SPIN, SKID, FLIGHT)] == [0, -1, 1, 0]
    assert [modes.slip_mode(sigma) for sigma in (-1, 1)] == [SPIN, SKID]


TIED = Body(0.8, 0.3, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
PLAIN = Body(0.5, 0.4, 0.0, 0.0, 1.0, 0.0, 0.0, 2, False, 0.0)


def test_lift_off_that_is_a_tie():
    """Where f_n = 0 now, it is what comes next that decides: f_n a little later in free motion, and whether the rim leaves."""
    for gravity in (1.0, 0.2):
        body = TIED._replace(gn=gravity)
        for th in (0.5, -0.5, 1.2):
            for way in (1.0, -1.0):
                om = way * math.sqrt(gravity / (body.eps * math.cos(th)))
                assert abs(accelerations(body, th, om, "free")[1]) < 1e-12
                opening = 1 if accelerations(body, th + 1e-4 * om, om, "free")[1] > 0.0 else -1
                assert modes.opening_sign(body, th, om) == opening
                assert modes.next_mode(body, th, 0.0, om, 0.3) == (FLIGHT if opening > 0 else SKID)
        # at the top the load comes down: the second derivative is −g²/ε there
        assert modes.opening_sign(body, 0.0, math.sqrt(gravity / 0.8)) == -1
    assert [modes.opening_sign(TIED, 0.3, om) for om in (0.0, 3.0)] == [-1, 1]  # f_n itself


def test_without_gravity():
    floating = TIED._replace(gn=0.0)
    assert [modes.opening_sign(floating, th, om) for th, om in ((0.5 * math.pi, 1.0), (-0.5 * math.pi, 1.0), (0.3, 0.0))] == [
        -1, 1, 0,
    ]  # fmt: skip
    # nothing presses and nothing pulls: it leaves
    assert modes.can_roll(floating, 0.3, 0.0) is False
    for mu in (0.5, 0.0, math.inf):
        body = floating._replace(mu_s=mu, mu_k=mu)
        assert modes.next_mode(body, 0.3, 0.0, 0.0, 0.4) == FLIGHT
        assert mu == math.inf or modes.next_mode(body, 0.3, 0.0, 0.0, 0.0) == FLIGHT
    # a wall: it falls along it, and N stays 0
    for sigma in (-1, 1):
        assert modes.can_start_slip(floating._replace(gt=1.0), 0.3, 0.0, sigma) is False


def test_without_friction():
    """The slip that comes is that of the equations; at the top and at the bottom, that of a little later."""
    seen = set()
    for body, random in bodies(300, 3):
        body = body._replace(mu_s=0.0, mu_k=0.0)
        for flat in (False, True):
            if flat:
                body = body._replace(gn=1.0, gt=0.0, slope=0.0)
            for th in (6.0 * random.random() - 3.0, 0.0, math.pi):
                low = 1.2246467991473532e-16 if th == math.pi else 0.0  # π in two doubles
                om = random.normal()
                if accelerations(body, th, om, "free")[1] > -1e-3:
                    continue
                at = th + (1e-7 * om if flat and th in (0.0, math.pi) else 0.0)
                ax, _, alpha, _, _ = accelerations(body, at, om, 1)
                if abs(ax - alpha) < 1e-12:
                    continue
                expected = SKID if ax > alpha else SPIN
                assert modes.frictionless_mode(body, th, low, om) == expected
                assert modes.next_mode(body, th, low, om, 0.0) == expected
                seen.add((flat, th in (0.0, math.pi), expected))
    assert len(seen) == 8
    assert modes.frictionless_mode(PLAIN, 0.0, 0.0, 0.0) == ROLL  # it balances
    for om in (0.0, 0.5, -0.5):
        slips = [modes.next_mode(PLAIN, 0.2, 0.0, om, vt) for vt in (0.0, 0.7, -0.7)]
        assert slips == [modes.frictionless_mode(PLAIN, 0.2, 0.0, om), SKID, SPIN]
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


def a_little_later(body, th, om, motion, dt=1e-5):
    """Angle and rate after a short time of rolling, or of slip."""
    alpha = accelerations(body, th, om, motion)[2]
    return th + om * dt + 0.5 * alpha * dt * dt, om + alpha * dt


@pytest.mark.parametrize(("pace", "seed", "kinds"), [(3.0, 4, 8), (300.0, 8, 8)])
def test_rolling_at_the_edge_of_the_cone(pace, seed, kinds):
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
        against = SPIN if friction > 0.0 else SKID
        sigma = modes.slip_direction(against)
        along, up = responses(body, th)
        if up[1] - sigma * mu * along[1] > 1e-3:  # else Painlevé's paradox
            assert pace > 100.0 or modes.next_mode(body, th, 0.0, om, 0.0) == (ROLL if margin > 0.0 else against)
            ax, _, alpha, _, _ = accelerations(body, *a_little_later(body, th, om, sigma, brief), sigma)
            assert modes.can_start_slip(body, th, om, sigma) == (sigma * (ax - alpha) > 0.0)
            assert not modes.can_start_slip(body, th, om, -sigma)
        seen.add((friction > 0.0, margin > 0.0, body.gt > 0.0))
    assert len(seen) == kinds


def rate_where(force, bound=40.0):
    """θ̇ at which something linear in θ̇² is 0, or None."""
    at_rest, slope = force(0.0), force(1.0) - force(0.0)
    u = -at_rest / slope if slope != 0.0 else -1.0
    return math.sqrt(u) if 1e-2 < u < bound else None


def test_rolling_with_infinite_friction_where_the_plane_no_longer_presses():
    seen = set()
    for body, random in bodies(500, 5):
        body = body._replace(mu_s=math.inf, mu_k=math.inf)
        th = 6.0 * random.random() - 3.0
        om = rate_where(lambda om, body=body, th=th: accelerations(body, th, om, "roll")[4])
        if om is None:
            continue
        om *= random.choice([-1.0, 1.0])
        normal = accelerations(body, *a_little_later(body, th, om, "roll"), "roll")[4]
        if abs(normal) < 1e-7:
            continue
        assert modes.can_roll(body, th, om) == (normal > 0.0)
        seen.add((normal > 0.0, om > 0.0, body.gt > 0.0))
    assert len(seen) == 8


def test_slip_that_begins_where_the_plane_no_longer_presses():
    seen = set()
    for body, random in bodies(900, 6):
        th = 6.0 * random.random() - 3.0
        sigma = int(random.choice([-1, 1]))
        along, up = responses(body, th)
        if up[1] - sigma * body.mu_k * along[1] < 1e-2:
            continue
        om = rate_where(lambda om, body=body, th=th, sigma=sigma: accelerations(body, th, om, sigma)[4])
        if om is None:
            continue
        om *= random.choice([-1.0, 1.0])
        ax, _, alpha, _, _ = accelerations(body, th, om, sigma)
        normal = accelerations(body, *a_little_later(body, th, om, sigma), sigma)[4]
        if abs(normal) < 1e-7 or abs(ax - alpha) < 1e-3:
            continue
        expected = normal > 0.0 and sigma * (ax - alpha) > 0.0
        assert modes.can_start_slip(body, th, om, sigma) == expected
        seen.add((sigma, normal > 0.0, sigma * (ax - alpha) > 0.0))
    assert len(seen) == 8


def test_slip_does_not_begin_against_itself_or_without_push():
    for body, random in bodies(300, 7):
        body = body._replace(mu_k=4.0 * body.mu_k + 1.0, mu_s=6.0 * body.mu_s + 2.0)
        th, om = 6.0 * random.random() - 3.0, 2.0 * random.normal()
        along, up = responses(body, th)
        for sigma in (-1, 1):
            if up[1] - sigma * body.mu_k * along[1] < 0.0:  # the paradox: no slip of this direction
                assert not modes.can_start_slip(body, th, om, sigma)


def test_at_painleves_threshold_the_plane_cannot_tell():
    """Where the plane's answer to friction is 0 within rounding, a slip that presses has no motion."""
    body = Body(0.9, 0.05, 9.0, 9.0, 1.0, 0.0, 0.0, 2, False, 0.0)
    for th in (0.6, -0.6):
        along, up = responses(body, th)
        mu = abs(up[1] / along[1])
        sigma = 1.0 if along[1] > 0.0 else -1.0
        for nudge, expected in (
            (0.0, modes.INCONSISTENT),
            (-1e-12, SKID if sigma > 0.0 else SPIN),
            (1e-12, modes.INCONSISTENT),
        ):
            at = body._replace(mu_s=mu * (1.0 + nudge), mu_k=mu * (1.0 + nudge))
            assert modes.next_mode(at, th, 0.0, 0.1, sigma) == expected
    # p_σ = 0 exactly: no slip can start
    assert modes.can_start_slip(Body(0.5, 0.25, 1.0, 1.0, 1.0, 0.0, 0.0, 2, False, 0.0), -0.5 * math.pi, 0.1, 1) is False


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
    ax, _, alpha, _, _ = accelerations(body, 0.3, 1.0, 1 if slope > 0.0 else -1)
    assert ax == alpha
    assert modes.can_roll(body, 0.3, 1.0) is True
    assert modes.next_mode(body, 0.3, 0.0, 1.0, 0.0) == ROLL
    for sigma in (1, -1):
        assert modes.can_start_slip(body, 0.3, 1.0, sigma) is False


def test_where_rounding_hides_which_of_roll_and_slip_there_is(monkeypatch):
    """What the tests of both refuse is told by the cone alone; without f_n < 0 it flies, and μ = ∞ leaves it open."""
    rule = modes.next_mode
    monkeypatch.setattr(modes, "can_roll", lambda *_: False)
    monkeypatch.setattr(modes, "can_start_slip", lambda *_: False)
    seen = set()
    for body, random in bodies(400, 11):
        th, om = 6.0 * random.random() - 3.0, 1.5 * random.normal()
        _, _, _, friction, normal = accelerations(body, th, om, "roll")
        found = rule(body, th, 0.0, om, 0.0)
        stiff = rule(body._replace(mu_s=math.inf, mu_k=math.inf), th, 0.0, om, 0.0)
        if accelerations(body, th, om, "free")[1] > 0.0:
            assert found == stiff == FLIGHT
        elif body.mu_s * normal >= abs(friction):
            assert (found, stiff) == (ROLL, modes.UNDECIDED)
        else:
            assert (found, stiff) == (SPIN if friction > 0.0 else SKID, modes.UNDECIDED)
        seen.add((found, abs(friction) < 1.0))
    assert len(seen) >= 7


@pytest.mark.parametrize(("way", "expected"), [(1, SKID), (-1, SPIN)])
def test_a_small_force_beyond_its_rounding_is_no_tie_where_there_is_hardly_friction(way, expected):
    """A balanced ring on a slope of 10⁻¹³ rad needs F = 5·10⁻¹⁴ to roll, 25 times the rounding, and has 10⁻²⁰."""
    body = Body(0.0, 1.0, 1e-20, 1e-20, 1.0, way * 1e-13, 0.0, 2, False, way * 1e-13)
    assert modes.can_roll(body, 0.3, 0.0) is False
    assert modes.next_mode(body, 0.3, 0.0, 0.0, 0.0) == expected


@pytest.mark.parametrize("side", [5e-14, -5e-14])
@pytest.mark.parametrize("om", [0.4, -0.4])
def test_so_near_the_edge_of_the_cone_what_comes_decides(side, om):
    """With much friction the rounding of F counts too: 5·10⁻¹⁴ of it inside the cone or outside are a tie."""
    body = Body(0.5, 0.75, 1.0, 1.0, 1.0, 0.0, 0.0, 2, False, 0.0)
    th = 0.6
    _, _, _, friction, normal = accelerations(body, th, om, "roll")
    _, _, _, later, presses = accelerations(body, *a_little_later(body, th, om, "roll"), "roll")
    needed = abs(friction) / normal
    stays_inside = abs(later) / presses < needed
    assert stays_inside == (om < 0.0)
    assert modes.can_roll(body._replace(mu_s=needed * (1.0 + side)), th, om) == stays_inside
