"""Impacts: against exact fractions, and against the response of a rigid body to impulses."""

import math
from fractions import Fraction as Q

import pytest
from scipy.optimize import brentq

from hophoop.kernel.physics import impact
from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.contact import exact_slip_coefficients
from newton_euler import BODIES, responses
from oracles import rational

LAWS = {"newton": 0, "poisson": 1, "stronge": 2}
CONTACTS = [
    rational.Contact(Q(1, 2), Q(39, 100), Q(-4, 5), Q(3, 5), Q(1, 4), Q(1, 4)),  # sticks at the limit
    rational.Contact(Q(1, 2), Q(39, 100), Q(-4, 5), Q(3, 5), Q(1, 8), Q(1, 8)),  # slip turns round
    rational.Contact(Q(2, 5), Q(3, 5), Q(3, 5), Q(4, 5), Q(2), Q(1)),
    rational.Contact(Q(2, 3), Q(1, 4), Q(5, 13), Q(-12, 13), Q(1, 3), Q(1, 5)),
    rational.Contact(Q(0), Q(1, 2), Q(0), Q(1), Q(2, 5), Q(2, 5)),  # a disk
    rational.Contact(Q(1, 5), Q(1, 2), Q(-3, 5), Q(4, 5), Q(2, 5), Q(2, 5)),
]
VELOCITIES = [
    (Q(-1), Q(-3), Q(0)),
    (Q(2), Q(-1), Q(1)),
    (Q(1), Q(-2), Q(1)),
    (Q(0), Q(-1), Q(3)),
    (Q(0), Q(-2), Q(3)),
]  # the last stops slipping in restitution


@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("law", LAWS)
def test_against_fractions(contact, law):
    sine, cosine = float(contact.sine), float(contact.cosine)
    for rest in (Q(0), Q(1, 2)):
        body = Body(float(contact.eccentricity), float(contact.inertia_ratio), float(contact.mu_static),
                    float(contact.mu_kinetic), 1.0, 0.0, float(rest), LAWS[law], False, 0.0)  # fmt: skip
        for vx, vy, om in VELOCITIES:
            found = impact.impact(body, float(rest), sine, cosine, float(vx - om), float(vy))
            exact = rational.collide(contact, (vx, vy, om), rest, law)
            after, pushed = exact["velocity"], exact["impulse"]
            expected = (after[0] - after[2], after[1], after[2] - om, pushed["normal"], pushed["tangential"])
            expected = [float(one) for one in (*expected, exact["loss_normal"], exact["loss_tangential"])]
            assert found == pytest.approx(expected, rel=1e-12, abs=1e-12), (rest, vx, vy, om)


@pytest.mark.parametrize("law", [0, 1, 2])
def test_infinite_friction_is_the_limit_of_high_friction(law):
    body = BODIES[1]._replace(mu_s=1e9, mu_k=1e9, law=law)
    s, c = math.sin(2.0), math.cos(2.0)
    for vt in (0.4, -0.7):
        limit = impact.impact(body._replace(mu_s=math.inf, mu_k=math.inf), 0.5, s, c, vt, -1.0)
        assert limit == pytest.approx(impact.impact(body, 0.5, s, c, vt, -1.0), rel=1e-6, abs=1e-7)


# Painlevé's paradox: the angle at which the plane cannot push the hoop off any more


def without_response(body, th, sigma):
    along, up = responses(body, th)
    return up[1] - sigma * body.mu_k * along[1]


STEEP = Body(0.75, 0.1, 1.5, 1.5, 1.0, 0.0, 0.0, 2, False, 0.0)


def singular(sigma, low, high):
    return brentq(lambda th: without_response(STEEP, th, sigma), low, high, xtol=1e-15, rtol=1e-15)


PLACES = [(-1, singular(-1, 0.05, 0.5)), (-1, singular(-1, 0.9, 2.4)), (1, singular(1, -2.4, -0.9))]


@pytest.mark.parametrize(("sigma", "th"), PLACES)
def test_singular_angle(sigma, th):
    def at(distance, u):
        place = th - distance
        s, c = math.sin(place), math.cos(place)
        return impact.singular_angle(STEEP, s, c, u, sigma, *exact_slip_coefficients(STEEP, place, 0.0, sigma, 0.0))

    for distance in (3e-12, -3e-12):
        found, exact, ahead = at(distance, 0.5)
        assert (found, exact) == (True, True)
        assert ahead == pytest.approx(distance, rel=1e-3, abs=0.0)
    assert at(1e-6, 0.5) == (False, False, 0.0)
    pull = STEEP.eps * math.cos(th)
    if pull > 0.0:  # nearly there while the force to press the hoop down vanishes
        assert at(1e-6, STEEP.gn / pull) == (True, False, 0.0)
        assert at(-1e-6, STEEP.gn / pull) == (True, False, 0.0)
        assert at(1e-4, STEEP.gn / pull) == (False, False, 0.0)


def test_a_stick_at_the_edge_of_the_cone_holds():
    body = Body(0.5, 1.0, 0.25, 0.125, 1.0, 0.0, 0.0, 2, False, 0.0)
    # (1, 1/2) about G: the impulse that keeps v_t is 1/4 of the normal one, exactly
    for lever, ratio in ((0.5, 0.25), (-0.5, -0.25)):
        assert impact.impulse_ratio(body, 1.0, lever, 0.0) == (ratio, True)


@pytest.mark.parametrize(("sigma", "th"), PLACES)
@pytest.mark.parametrize("side", [1, -1])
def test_how_near_counts_as_there(sigma, th, side):
    """10⁻¹⁰ rad from p_σ = 0, and for the jam 10⁻⁵ rad and 10⁻⁵ of f_n's parts, whatever the slope of p_σ is."""

    def at(distance, u, body=STEEP):
        place = th - side * distance
        s, c = math.sin(place), math.cos(place)
        return impact.singular_angle(body, s, c, u, sigma, *exact_slip_coefficients(body, place, 0.0, sigma, 0.0))

    assert at(0.9e-10, 0.5)[:2] == (True, True)
    assert at(1.1e-10, 0.5)[:2] == (False, False)
    pull = STEEP.eps * math.cos(th)
    if pull > 0.0:
        u = STEEP.gn / pull  # where f_n = 0
        assert at(0.9e-5, u)[:2] == (True, False)
        assert at(1.1e-5, u)[:2] == (False, False)
        parts = STEEP.gn + STEEP.eps * u
        for off, found in ((0.9e-5, True), (1.1e-5, False)):
            for sign in (1.0, -1.0):
                assert at(1e-9, u + sign * off * parts / pull)[0] == found


def _without_collision(body, th, sigma, law, rest, p_sigma=None, vt=0.7):
    """The impact without collision piece by piece, from the response to impulses: slip until it stops, stick, restitution."""
    along, up = responses(body, th)
    mu = sigma * body.mu_k
    rate_t, rate_n, rate_om = (up[k] - mu * along[k] for k in range(3))
    rate_n = rate_n if p_sigma is None else p_sigma
    hold = -up[0] / along[0]
    stick_n, stick_om = (up[k] + hold * along[k] for k in (1, 2))
    slipping = -sigma * vt / rate_t
    low = rate_n * slipping
    sticking = -low / stick_n
    work_n = 0.5 * low * slipping + 0.5 * low * sticking
    work_t = -mu * 0.5 * sigma * vt * slipping
    if law == LAWS["newton"]:
        back = 0.0
    elif law == LAWS["poisson"]:
        back = rest * (slipping + sticking)
    else:
        back = math.sqrt(-2.0 * rest * rest * work_n / stick_n)
    vn = stick_n * back
    p_n = slipping + sticking + back
    p_t = -mu * slipping + hold * (sticking + back)
    spin = rate_om * slipping + stick_om * (sticking + back)
    return 0.0, vn, spin, p_n, p_t, -(work_n + 0.5 * vn * back), -work_t


@pytest.mark.parametrize("known", [0.0, 1e-12, math.nan])
def test_the_impact_without_collision_where_p_sigma_is_zero_but_for_rounding(known):
    """The slip has to stop; v_n stays 0 meanwhile, also where p_σ is computed a little above 0."""
    body = Body(0.5, 0.25 + 1e-12, 1.0, 1.0, 1.0, 0.0, 0.0, 1, False, 0.0)
    found = impact.impact(body, 0.5, -1.0, 0.0, 0.3, 0.0, known)
    assert found == pytest.approx(_without_collision(body, -0.5 * math.pi, 1, 1, 0.5, 0.0, 0.3), rel=1e-9, abs=1e-12)
    assert found[1] > 0.0  # Poisson bounces


def _pushed(body, th, sigma, rho):
    """(v_t, v_n, θ̇) for a unit of normal impulse, with friction and the couple −ρ, which turns the hoop alone."""
    along, up = responses(body, th)
    turned = -rho / body.kap
    more = (-(1.0 + body.eps * math.cos(th)) * turned, body.eps * math.sin(th) * turned, turned)
    return [u - sigma * body.mu_k * a + m for u, a, m in zip(up, along, more, strict=True)]


@pytest.mark.parametrize("sigma", [-1, 1])
@pytest.mark.parametrize("vt", [0.02, 2.0])
@pytest.mark.parametrize("exact", [True, False])
@pytest.mark.parametrize("f", [0.0, 0.1, 1.0])
def test_singular_slip(sigma, vt, exact, f):
    """An impulse at a fixed angle: by the response to it, to whichever end comes first.

    Without rolling resistance θ̇ turns round to the same speed; where θ̇ = 0 the couple is another, and so is the end.
    """
    body, vt = STEEP._replace(mu_s=2.5, mu_k=2.5), sigma * vt
    grid = [0.01 * k for k in range(-300, 301)]
    for om in (0.3, -0.3, 0.9, -0.9, 0.0123) if f else (0.3, -0.3, 0.9, -0.9, 0.0):
        rho = math.copysign(f, om)
        signs = [_pushed(body, th, sigma, rho)[1] > 0.0 for th in grid]
        places = [k for k in range(len(grid) - 1) if signs[k] != signs[k + 1]]
        assert places
        for k in places:
            th = brentq(lambda at, rho=rho: _pushed(body, at, sigma, rho)[1], grid[k], grid[k + 1], xtol=1e-15, rtol=1e-15)
            ahead = 1e-5 if exact and f == 0.0 else 0.0
            at = th - ahead
            rate, _, turn = _pushed(body, th, sigma, rho)
            ends = {"stops": -vt / rate if vt * rate < 0 else math.inf}
            if turn * om > 0:
                # until θ̇ has grown so far that the centrifugal force lifts the hoop
                pull = body.eps * math.cos(at)
                ends["jams"] = max((math.copysign(math.sqrt(body.gn / pull), om) - om) / turn, 0.0) if pull > 0 else math.inf
            else:
                ends["turns"] = -om / turn * (1.0 if f else 2.0)
            which = min(ends, key=ends.get)
            p = ends[which]
            if math.isinf(p):
                continue
            found = impact.singular_slip(body, math.sin(at), math.cos(at), exact, ahead, vt, om, rho)
            loss = sigma * body.mu_k * (vt * p + 0.5 * rate * p * p)
            assert found == pytest.approx((which == "jams", vt + rate * p, om + turn * p, p, loss), rel=1e-8, abs=1e-10)
            assert which != "stops" or found[1] == 0.0
            assert f == 0.0 or (found[2] == 0.0) == (which == "turns")
