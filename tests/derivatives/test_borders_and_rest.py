"""What is written by hand about one event or piece: impacts between two courses, a disturbed equilibrium, rates."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.derivatives.events.impact import CLOSE, JUMP, Blow, distance, impact_change, is_between_courses, tangent_from
from hophoop.derivatives.layout import STATE_ROWS, STILL, Reason
from hophoop.derivatives.pieces.flight_and_rest import accelerations, perturbed_rest, step_along
from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.contact import contact_arms
from hophoop.kernel.physics.impact import impact, slip_rates, stick_rates
from hophoop.kernel.records.state import start_state

STEP = 1e-6
BODY = Body(0.6, 0.5, 0.4, 0.3, 0.9, 0.3, 0.5, 2, False, 0.3)
SINE, COSINE = math.sin(0.7), math.cos(0.7)
STILL_BLOW = Blow(0.0, 0.0, 0.0, 0.0, 0.0)
BY_SLIP = STILL_BLOW._replace(vt=1.0)


def one_sided(body, other, blow, other_blow):
    """The change of an impact from one body and blow to another, by the step."""
    after, before = (np.array(impact(each, *one)) for each, one in ((other, other_blow), (body, blow)))
    return pytest.approx(((after - before) / STEP).tolist(), rel=1e-5, abs=2e-5)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_an_impact_that_stops_a_slip_that_has_just_begun(way):
    """From v_t = 0 either way: the impulse that stops it is there at once, the same to first order."""
    body, blow = BODY._replace(mu_s=1.0, mu_k=1.0, rest=0.0), Blow(0.0, SINE, COSINE, 0.0, -1.1)
    found, reason = impact_change(body, blow, STILL, BY_SLIP._replace(vt=way))
    assert reason == -1  # holds to this side
    assert list(found) == one_sided(body, body, blow, blow._replace(vt=way * STEP))


@pytest.mark.parametrize("vt", [0.4, -0.4])
def test_an_impact_without_friction_changes_by_a_little_friction(vt):
    """The friction that comes acts against the slip."""
    body, blow = BODY._replace(mu_s=0.0, mu_k=0.0), Blow(BODY.rest, SINE, COSINE, vt, -1.1)
    found, _ = impact_change(body, blow, STILL._replace(mu_k=1.0), STILL_BLOW)
    assert list(found) == one_sided(body, body._replace(mu_s=STEP, mu_k=STEP), blow, blow)


def test_what_has_no_derivative_of_an_impact():
    blow = Blow(0.0, SINE, COSINE, 0.4, -1.1)
    by_restitution = STILL._replace(rest=1.0), STILL_BLOW._replace(rest=1.0)
    assert impact_change(BODY._replace(rest=0.0), blow, *by_restitution)[1] == Reason.PLASTIC
    # friction that just holds the stick
    needed = abs(stick_rates(BODY, *contact_arms(BODY, SINE, COSINE))[0])
    for more, between in ((0.0, True), (1e-11, True), (1e-9, False)):
        body = BODY._replace(mu_s=needed + more, mu_k=needed + more)
        assert is_between_courses(body, Blow(0.5, SINE, COSINE, 0.0, -1.1)) == between


def slip_that_just_stops(body, th):
    """The slip with which an impact's slip stops as the compression ends."""
    low, high = 0.0, 2.0
    for _ in range(80):
        vt = 0.5 * (low + high)
        rate = slip_rates(body, *contact_arms(body, math.sin(th), math.cos(th)), -body.mu_k)
        stops = -vt / rate[1]
        low, high = (vt, high) if stops < 1.1 / rate[2] else (low, vt)
    return vt


@pytest.mark.parametrize("th", [0.7, 1e-3, 3e-6, 1e-9])
def test_a_derivative_that_jumps_is_found(th):
    """The slip stops just as the compression ends. Both courses become one as θ → 0, and with it the jump."""
    body = BODY._replace(mu_s=0.9, mu_k=0.3)
    vt = slip_that_just_stops(body, th)
    blow = Blow(body.rest, math.sin(th), math.cos(th), vt, -1.1)
    below, above = (tangent_from(body, blow, vt * (1.0 + side * 1e-12), STILL, BY_SLIP)[1] for side in (-1.0, 1.0))
    assert is_between_courses(body, blow) == (distance(below, above) > JUMP)
    for side in (-1.0, 1.0):
        assert not is_between_courses(body, blow._replace(vt=vt * (1.0 + side * 20.0 * CLOSE)))


@pytest.mark.parametrize("stiffness", [2.0, -2.0, 1e-9, -1e-9])
@pytest.mark.parametrize("tau", [1e-3, 0.5, 3.0])
def test_a_disturbed_equilibrium(stiffness, tau):
    """δθ̈ = k δθ + b by power series."""
    angle, rate, drive = 0.3, -0.7, 0.9
    terms = [angle, rate, 0.5 * (stiffness * angle + drive)]
    for n in range(3, 60):
        terms.append(stiffness * terms[n - 2] / (n * (n - 1)))
    there = sum(term * tau**n for n, term in enumerate(terms))
    speed = sum(n * term * tau ** (n - 1) for n, term in enumerate(terms) if n)
    assert perturbed_rest(stiffness, drive, angle, rate, tau) == pytest.approx((there, speed), rel=1e-13)


@pytest.mark.parametrize("sigma", [0, 1, -1])
def test_rates_of_a_state_are_those_of_its_motion(sigma):
    """A step along the motion: by the changes of a short motion itself."""
    hoop, plane = hh.Hoop(eccentricity=0.6, inertia_ratio=0.5), hh.Plane(gravity=1.0, mu_static=3.0, mu_kinetic=0.3, slope=0.2)
    body = hh.Scenario(hoop=hoop, plane=plane).to_body()
    state = start_state(0.0, 0.0, 1.7, 0.8 * sigma, 0.0, 0.7)
    start = hh.Start(angle=1.7, vx=0.8 * sigma + 0.7, omega=0.7) if sigma else hh.Start.rolling(0.7, angle=1.7)
    after = hh.simulate(hoop, plane, start, duration=1e-4).at(1e-4)
    turning, along, away, lost = accelerations(body, {0: 0, 1: 2, -1: 1}[sigma], state, 0.0)
    assert after.omega - 0.7 == pytest.approx(1e-4 * turning, rel=1e-3)
    assert after.slip - 0.8 * sigma == pytest.approx(1e-4 * along, rel=1e-3, abs=1e-15)
    assert (away, lost) == (0.0, 0.0)
    changes = np.zeros((STATE_ROWS, 1))
    step_along(changes, 0, 0.5, state, (turning, along, 0.25, 0.125))
    expected = [0.5, 0.5 * (state.vt + 0.7), 0.0, 0.35, 0.5 * turning, 0.5 * along, 0.125, 0.0, 0.0, 0.0625]
    assert changes[:, 0].tolist() == pytest.approx(expected)
