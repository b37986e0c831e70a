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


def test_letters_of_slip():
    assert [modes.slip_direction(mode) for mode in (ROLL, SPIN, SKID, FLIGHT)] == [0, -1, 1, 0]
    assert [modes.slip_mode(sigma) for sigma in (-1, 1)] == [SPIN, SKID]


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize("th", [0.5, -0.5, 1.2])
def test_lift_off_that_is_a_tie(th, way):
    """Where f_n = 0 now, it is what comes next that decides: f_n a little later in free motion."""
    body = Body(0.8, 0.3, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
    om = way * math.sqrt(body.gn / (body.eps * math.cos(th)))
    later = accelerations(body, th + 1e-4 * om, om, "free")[1]
    assert abs(accelerations(body, th, om, "free")[1]) < 1e-12
    assert modes.opening_sign(body, th, om) == (1 if later > 0.0 else -1)


def test_lift_off_that_is_a_tie_twice():
    body = Body(0.8, 0.3, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
    assert modes.opening_sign(body, 0.0, 1.0 / math.sqrt(0.8)) == -1  # the load at the top comes down
    floating = body._replace(gn=0.0)
    assert modes.opening_sign(floating, 0.5 * math.pi, 1.0) == -1
    assert modes.opening_sign(floating, -0.5 * math.pi, 1.0) == 1
    assert modes.opening_sign(floating, 0.3, 0.0) == 0


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
    still = Body(0.5, 0.4, 0.0, 0.0, 1.0, 0.0, 0.0, 2, False, 0.0)
    assert modes.frictionless_mode(still, 0.0, 0.0, 0.0) == ROLL  # it balances


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


def test_codes_of_what_is_no_mode():
    assert (modes.INCONSISTENT, modes.INDETERMINATE, modes.UNDECIDED) == (10, 11, 12)


def test_rolling_at_the_edge_of_the_cone():
    seen = set()
    for body, random in bodies(400, 4):
        th, om = 6.0 * random.random() - 3.0, 3.0 * random.normal()
        _, _, _, friction, normal = accelerations(body, th, om, "roll")
        if normal < 0.05 or abs(friction) < 0.02:
            continue
        mu = abs(friction) / normal
        body = body._replace(mu_s=mu, mu_k=mu)
        _, _, _, later, presses = accelerations(body, *a_little_later(body, th, om, "roll"), "roll")
        margin = mu * presses - abs(later)
        if abs(margin) < 1e-7:
            continue
        assert modes.can_roll(body, th, om) == (margin > 0.0)
        against = SPIN if friction > 0.0 else SKID
        expected = ROLL if margin > 0.0 else against
        along, up = responses(body, th)
        sigma = modes.slip_direction(against)
        if up[1] - sigma * mu * along[1] > 1e-3:  # else Painlevé's paradox
            assert modes.next_mode(body, th, 0.0, om, 0.0) == expected
            ax, _, alpha, _, _ = accelerations(body, *a_little_later(body, th, om, sigma), sigma)
            assert modes.can_start_slip(body, th, om, sigma) == (sigma * (ax - alpha) > 0.0)
            assert not modes.can_start_slip(body, th, om, -sigma)
        seen.add((friction > 0.0, margin > 0.0, body.gt > 0.0))
    assert len(seen) == 8


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


@pytest.mark.parametrize("om", [0.0, 0.5, -0.5])
def test_without_friction_in_flight_and_at_rest(om):
    body = Body(0.5, 0.4, 0.0, 0.0, 1.0, 0.0, 0.0, 2, False, 0.0)
    fast = 3.0
    assert modes.next_mode(body, 0.2, 0.0, fast, 0.0) == FLIGHT  # f_n > 0: the load pulls the rim up
    assert modes.next_mode(body, 0.2, 0.0, om, 0.0) == modes.frictionless_mode(body, 0.2, 0.0, om)
    slipping = modes.next_mode(body, 0.2, 0.0, om, 0.7)
    assert slipping == SKID
    assert modes.next_mode(body, 0.2, 0.0, om, -0.7) == SPIN


def test_a_lift_off_that_is_a_tie_while_it_slips():
    """f_n = 0 now and f_n < 0 a little later: the rim stays; f_n > 0: it leaves."""
    body = Body(0.8, 0.3, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
    for th, way in ((0.5, 1.0), (0.5, -1.0)):
        om = way * math.sqrt(1.0 / (0.8 * math.cos(th)))
        opening = modes.opening_sign(body, th, om)
        assert opening == -way
        expected = SKID if opening < 0 else FLIGHT
        assert modes.next_mode(body, th, 0.0, om, 0.3) == expected
    floating = body._replace(gn=0.0)
    # nothing presses and nothing pulls: it leaves
    assert modes.next_mode(floating, 0.3, 0.0, 0.0, 0.4) == FLIGHT
    assert modes.next_mode(floating._replace(mu_s=math.inf, mu_k=math.inf), 0.3, 0.0, 0.0, 0.4) == FLIGHT


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


def test_at_the_threshold_itself_no_slip_can_start():
    body = Body(0.5, 0.25, 1.0, 1.0, 1.0, 0.0, 0.0, 2, False, 0.0)
    assert modes.can_start_slip(body, -0.5 * math.pi, 0.1, 1) is False


def test_where_a_push_has_no_answer_at_all():
    """A ring without mass and its load above it: p_σ = 0 exactly. Rule 4: pressed it is inconsistent, lifted it flies."""
    body = Body(1.0, 0.0, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
    for vt in (0.3, -0.3):
        assert modes.next_mode(body, 0.0, 0.0, 0.5, vt) == modes.INCONSISTENT
        assert modes.next_mode(body, 0.0, 0.0, 2.0, vt) == FLIGHT


def test_a_disk_on_a_slope_whose_slip_neither_grows_nor_ends():
    """μ = tan β κ/(1 + κ): friction along the slope is just what rolling needs."""
    body = Body(0.0, 1.0, 0.25, 0.25, 1.0, 0.5, 0.0, 2, False, 0.0)
    ax, _, alpha, _, _ = accelerations(body, 0.3, 1.0, 1)
    assert ax == alpha
    assert modes.can_start_slip(body, 0.3, 1.0, 1) is False
    assert modes.can_start_slip(body, 0.3, 1.0, -1) is False
    assert modes.next_mode(body, 0.3, 0.0, 1.0, 0.0) == ROLL


def test_the_edge_of_the_cone_at_many_turns_a_second():
    """At θ̇² = 10⁵ g/R the rounding of forces is 10⁻¹¹ of gravity, and a tie is still one."""
    seen = set()
    for body, random in bodies(400, 8):
        th, om = 6.0 * random.random() - 3.0, 300.0 * random.normal()
        _, _, _, friction, normal = accelerations(body, th, om, "roll")
        size = om * om
        if normal < 0.05 * size or abs(friction) < 0.02 * size:
            continue
        mu = abs(friction) / normal
        body = body._replace(mu_s=mu, mu_k=mu)
        _, _, _, later, presses = accelerations(body, *a_little_later(body, th, om, "roll", 1e-5 / abs(om)), "roll")
        margin = (mu * presses - abs(later)) / size
        if abs(margin) < 1e-7:
            continue
        assert modes.can_roll(body, th, om) == (margin > 0.0)
        along, up = responses(body, th)
        sigma = -1 if friction > 0.0 else 1
        if up[1] - sigma * mu * along[1] > 1e-3:
            ax, _, alpha, _, _ = accelerations(body, *a_little_later(body, th, om, sigma, 1e-5 / abs(om)), sigma)
            assert modes.can_start_slip(body, th, om, sigma) == (sigma * (ax - alpha) > 0.0)
        seen.add((friction > 0.0, margin > 0.0))
    assert len(seen) == 4


def test_the_sign_of_what_opens_is_one():
    """By f_n, by its first derivative, and at the top by its second, which is −g²/ε there."""
    body = Body(0.8, 0.3, 0.5, 0.5, 1.0, 0.0, 0.0, 2, False, 0.0)
    assert modes.opening_sign(body, 0.3, 0.0) == -1
    assert modes.opening_sign(body, 0.3, 3.0) == 1
    for gravity in (1.0, 0.2):
        at = body._replace(gn=gravity)
        for th, way, expected in ((0.5, 1.0, -1), (0.5, -1.0, 1), (0.0, 1.0, -1)):
            assert modes.opening_sign(at, th, way * math.sqrt(gravity / (0.8 * math.cos(th)))) == expected


def test_nothing_presses_where_there_is_no_gravity_and_no_rotation():
    floating = Body(0.8, 0.3, 0.5, 0.4, 0.0, 0.0, 0.0, 2, False, 0.0)
    assert modes.can_roll(floating, 0.3, 0.0) is False
    assert modes.opening_sign(floating, 0.3, 0.0) == 0
    for mu in (0.5, 0.0):
        assert modes.next_mode(floating._replace(mu_s=mu, mu_k=mu), 0.3, 0.0, 0.0, 0.0) == FLIGHT
    # a wall: it falls along it, and N stays 0
    wall = floating._replace(gt=1.0)
    for sigma in (-1, 1):
        assert modes.can_start_slip(wall, 0.3, 0.0, sigma) is False


@pytest.mark.parametrize("slope", [0.5, -0.5])
def test_a_disk_rolls_at_the_edge_of_the_cone_for_ever(slope):
    """One of the two margins is zero in every order, which is no reason to slip."""
    body = Body(0.0, 1.0, 0.25, 0.25, 1.0, slope, 0.0, 2, False, 0.0)
    assert modes.can_roll(body, 0.3, 1.0) is True


def test_without_friction_a_hilltop_is_left_to_the_side_where_it_stands():
    """θ = 10⁻²⁰: the coming slip is beyond what forces tell, but its sign is not."""
    body = Body(0.5, 0.4, 0.0, 0.0, 1.0, 0.0, 0.0, 2, False, 0.0)
    found = [modes.next_mode(body, th, 0.0, 0.0, 0.0) for th in (1e-20, -1e-20)]
    alphas = [accelerations(body, math.copysign(1e-3, th), 0.0, 1) for th in (1e-20, -1e-20)]
    assert found == [SKID if ax - alpha > 0.0 else SPIN for ax, _, alpha, _, _ in alphas]


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
