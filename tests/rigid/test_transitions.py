"""What is written of every event: its impulses change the velocities, and a number stands only where it means something."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import hophoop as hh
from hophoop._jit import forced, interpreted
from hophoop.physics.body import Event, Mode
from hophoop.physics.impact import impact
from hophoop.physics.painleve import slip_coefficients
from hophoop.records.state import start_state
from hophoop.rigid.transitions import close_bounces, collide

ALL_MODES = (Mode.ROLL, Mode.SPIN, Mode.SKID)


def scenario(start, gamma=0.75, duration=2.0, **plane):
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(**plane), start=start, duration=duration)


MOTIONS = {
    "hop": scenario(hh.Start.rolling(3.1)),
    "bounces": scenario(hh.Start(height=0.2, angle=0.5, omega=2.0), restitution=0.6, mu=0.4),
    "newton": scenario(hh.Start(height=0.2, angle=1.0, omega=-2.0, vx=3.0), restitution=0.8, mu=0.8, impact_law="newton"),
    "inconsistent": scenario(hh.Start(angle=-0.7, vx=3.0, omega=1.0), mu=1.3),
    "inconsistent, slowly": scenario(hh.Start(angle=-0.7, vx=1.2, omega=1.0), mu=1.3, restitution=0.5),
    "indeterminate": scenario(hh.Start(angle=-0.7, vx=8.0, omega=5.0), mu=1.3, painleve="impact"),
    "indeterminate, free": scenario(hh.Start(angle=-0.7, vx=8.0, omega=5.0), mu=1.3),
    "jam": scenario(hh.Start(angle=-2.312, vx=30.37, omega=5.654), mu=1.219),
    "run into": hh.Scenario(
        hoop=hh.Hoop(eccentricity=0.9128464310036214, inertia_ratio=0.00013391426767761817),
        plane=hh.Plane(mu=0.9864259833341639),
        start=hh.Start(angle=-3.32, vx=10.0, omega=20.0),
        duration=0.2,
    ),
    "no slip": scenario(hh.Start(height=0.3, angle=1.0, omega=2.0, vx=1.0), mu=math.inf, restitution=0.4),
}


def mirrored(case):
    start, plane = case.start, case.plane
    values = {"x": -start.x, "angle": -start.angle}
    if start.speed is not None:
        values["speed"] = -start.speed
    else:
        values |= {"vx": -start.vx, "omega": -start.omega}
    return case.model_copy(update={"start": start.model_copy(update=values), "plane": plane})


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("name", MOTIONS)
def test_events_keep_their_books(name, side):
    case = MOTIONS[name] if side > 0 else mirrored(MOTIONS[name])
    with forced("interpreted"):
        motion = hh.simulate(case)
    body = case.to_body()
    for row in motion._events:
        kind = row["kind"]
        assert (row["stable"] >= 0) == (kind == Event.REST)
        assert row["gain"] > 0.0 if kind == Event.KANE_GAIN else row["gain"] == 0.0
        within = row["before_mode"] in ALL_MODES
        strikes = kind in (Event.IMPACT, Event.BOUNCE_LIMIT)
        assert row["collision"] == (-1 if not strikes else 0 if within else 1)
        if strikes and within:
            assert row["before_mode"] == (Mode.SKID if row["before_slip"] > 0.0 else Mode.SPIN)
        # an impulse at the lowest point of the rim, with the arms of G
        arm, lever = 1.0 + body.eps * math.cos(row["theta"]), body.eps * math.sin(row["theta"])
        turned = row["omega"] - row["before_omega"]
        along = row["slip"] - row["before_slip"] + arm * turned
        up = row["vy"] - row["before_vy"] - lever * turned
        p_n, p_t = row["impulse_normal"], row["impulse_tangential"]
        size = 1e-9 * (1.0 + abs(p_n) + abs(p_t))
        assert (p_n, p_t) == (pytest.approx(up, abs=size), pytest.approx(along, abs=size))
        assert lever * p_n - arm * p_t == pytest.approx(body.kap * turned, abs=size)
        if not strikes and kind != Event.JAM:
            assert (p_n, p_t) == (0.0, 0.0)


def test_the_motions_have_the_events_that_they_are_named_for():
    kinds = {}
    with forced("interpreted"):
        for name, case in MOTIONS.items():
            kinds[name] = [event.kind for event in hh.simulate(case).events]
    assert "jam" in kinds["jam"]
    assert "bounce_limit" in kinds["no slip"]
    for name in ("inconsistent", "inconsistent, slowly", "run into"):
        assert "painleve_inconsistent" in kinds[name], name
    assert kinds["indeterminate"][1:3] == ["painleve_indeterminate", "impact"]
    assert kinds["indeterminate, free"][1] == "painleve_indeterminate"
    assert "impact" in kinds["hop"]


def body_of(gamma=0.75, **plane):
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(**plane)).to_body()


def test_rounding_is_no_gain():
    """A push of e = 1 without friction loses nothing, and gains nothing by rounding either."""
    body = body_of(mu=0.0, restitution=1.0)
    random = np.random.default_rng(2)
    for _ in range(100):
        th, vt, vn, om = random.uniform(-3.0, 3.0, 4)
        state = interpreted(start_state)(0.0, 0.0, th, vt, -abs(vn), om)
        assert interpreted(collide)(body, 1.0, state, Event.IMPACT, Mode.FLIGHT, 1)[1].gain == 0.0


@pytest.mark.parametrize("sigma", [1, -1])
def test_an_impact_within_contact_has_p_sigma_with_all_its_digits(sigma):
    """Beside p_σ = 0, where that of sin θ and cos θ has none."""
    body = body_of(0.75, mu=1.0)

    def stiffness(th):
        return interpreted(slip_coefficients)(body, th, 0.0, math.sin(th), math.cos(th), 1, 0.0)[1]

    zero = brentq(stiffness, -1.2, -0.9, xtol=1e-16)
    th = next(one for one in (zero, np.nextafter(zero, -2.0), np.nextafter(zero, 0.0)) if stiffness(one) <= 0.0)
    state = interpreted(start_state)(0.0, 0.0, sigma * th, sigma * 0.7, 0.0, 0.1)
    s, c = math.sin(sigma * th), math.cos(sigma * th)
    exact = interpreted(slip_coefficients)(body, sigma * th, 0.0, s, c, sigma, 0.0)[1] / body.kap
    assert -1e-14 < exact <= 0.0
    after, cause = interpreted(collide)(body, 0.0, state, Event.IMPACT, Mode.SKID, 0)
    vt, vn, spin, p_n, p_t, _, _ = interpreted(impact)(body, 0.0, s, c, state.vt, 0.0, exact)
    assert (after.vt, after.vn, after.om, cause.p_n, cause.p_t) == (vt, vn, state.om + spin, p_n, p_t)
    assert p_n != interpreted(impact)(body, 0.0, s, c, state.vt, 0.0)[3] or exact == 0.0


@pytest.mark.parametrize("vt", [0.5, -0.5])
def test_the_end_of_bounces_without_slip_rolls(vt):
    """However the stop along the plane throws the rim up: about the contact point the angular momentum stays."""
    body = body_of(0.75, mu=math.inf, restitution=0.5)
    th = math.copysign(1.0, vt)
    state = interpreted(start_state)(0.0, 0.0, th, vt, -1e-3, 0.3)
    arm, lever = 1.0 + body.eps * math.cos(th), body.eps * math.sin(th)

    def momentum_and_energy(one):
        along, up = one.vt + arm * one.om, one.vn - lever * one.om
        return body.kap * one.om + arm * along - lever * up, 0.5 * (along**2 + up**2 + body.kap * one.om**2), along, up

    thrown, _ = interpreted(collide)(body, 0.0, state, Event.IMPACT, Mode.FLIGHT, 1)
    assert thrown.vn > 0.1
    after, cause = interpreted(close_bounces)(body, state)
    before, now = momentum_and_energy(state), momentum_and_energy(after)
    assert (after.vt, after.vn) == (0.0, 0.0)
    assert now[0] == pytest.approx(before[0], rel=1e-14)
    assert before[1] - now[1] == pytest.approx(after.impact_n + after.impact_t, rel=1e-13)
    assert (cause.p_t, cause.p_n) == pytest.approx((now[2] - before[2], now[3] - before[3]), rel=1e-13)
    assert (cause.kind, cause.gain, cause.collision) == (Event.BOUNCE_LIMIT, 0.0, 1)


def test_the_end_of_bounces_that_lift_hardly_at_all():
    """A throw of 0.1 is one, too."""
    body = body_of(0.75, mu=math.inf, restitution=0.5)
    state = interpreted(start_state)(0.0, 0.0, 1.0, 1e-3, -1e-6, 0.3)
    after, _ = interpreted(close_bounces)(body, state)
    assert (after.vt, after.vn) == (0.0, 0.0)
