"""The next mode: against what Newton's and Euler's equations allow, and just beside ties."""

import math

import numpy as np
import pytest

from hophoop.physics import modes
from hophoop.physics.body import Body
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
