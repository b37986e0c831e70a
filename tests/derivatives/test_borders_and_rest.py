"""What is written by hand about one event or piece: impacts between two courses, an unstable equilibrium."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.derivatives.events.impact import CLOSE, JUMP, Blow, distance, impact_change, is_between_courses, tangent_from
from hophoop.derivatives.layout import STILL, Reason
from hophoop.derivatives.parameters import value_of
from hophoop.kernel.physics.body import Body
from hophoop.kernel.physics.contact import contact_arms
from hophoop.kernel.physics.impacts import impact, slip_rates, stick_rates

STEP = 1e-6
BODY = Body(0.6, 0.5, 0.4, 0.3, 0.9, 0.3, 0.5, 2, False, 0.3)
SINE, COSINE = math.sin(0.7), math.cos(0.7)
STILL_BLOW = Blow(0.0, 0.0, 0.0, 0.0, 0.0)
BY_SLIP = STILL_BLOW._replace(vt=1.0)


@pytest.mark.parametrize("vt", [0.4, -0.4])
def test_an_impact_without_friction_changes_by_a_little_friction(vt):
    """The friction that comes acts against the slip."""
    body, blow = BODY._replace(mu_s=0.0, mu_k=0.0), Blow(BODY.rest, SINE, COSINE, vt, -1.1)
    found, _ = impact_change(body, blow, STILL._replace(mu_k=1.0), STILL_BLOW)
    after, before = (np.array(impact(each, *blow)) for each in (body._replace(mu_s=STEP, mu_k=STEP), body))
    assert list(found) == pytest.approx(((after - before) / STEP).tolist(), rel=1e-5, abs=2e-5)


def test_what_has_no_derivative_of_an_impact():
    blow = Blow(0.0, SINE, COSINE, 0.4, -1.1)
    by_restitution = STILL._replace(rest=1.0), STILL_BLOW._replace(rest=1.0)
    assert impact_change(BODY._replace(rest=0.0), blow, *by_restitution)[1] == Reason.PLASTIC
    # friction that just holds the stick
    needed = abs(stick_rates(BODY, *contact_arms(BODY, SINE, COSINE))[0])
    for more, between in ((0.0, True), (1e-11, True), (1e-9, False)):
        body = BODY._replace(mu_s=needed + more, mu_k=needed + more)
        assert is_between_courses(body, Blow(0.5, SINE, COSINE, 0.0, -1.1)) == between


@pytest.mark.parametrize("th", [0.7, 1e-3, 3e-6, 1e-9])
def test_a_derivative_that_jumps_is_found(th):
    """The slip stops just as the compression ends. Both courses become one as θ → 0, and with it the jump."""
    body = BODY._replace(mu_s=0.9, mu_k=0.3)
    _, slowing, opening = slip_rates(body, *contact_arms(body, math.sin(th), math.cos(th)), -body.mu_k)
    vt = -1.1 * slowing / opening
    blow = Blow(body.rest, math.sin(th), math.cos(th), vt, -1.1)
    below, above = (tangent_from(body, blow, vt * (1.0 + side * 1e-12), STILL, BY_SLIP)[1] for side in (-1.0, 1.0))
    assert is_between_courses(body, blow) == (distance(below, above) > JUMP)
    for side in (-1.0, 1.0):
        assert not is_between_courses(body, blow._replace(vt=vt * (1.0 + side * 20.0 * CLOSE)))


ROLLS_OFF = [(slope, gamma, None, 0.0) for slope, gamma in ((0.2, 0.75), (-0.1, 0.5), (0.3, 0.7))]
SLIPS_OFF = [(0.0, gamma, mu, vx) for gamma, mu, vx in ((0.75, 0.3, 6.0), (0.6, 0.2, -6.0))]


@pytest.mark.parametrize(("slope", "gamma", "mu", "vx"), [*ROLLS_OFF, *SLIPS_OFF])
@pytest.mark.parametrize("duration", [0.3, 1.0])
def test_a_start_at_an_unstable_equilibrium_to_rounding(slope, gamma, mu, vx, duration):
    """There θ̈ is the rounding of θ; differences of motions a little beside it have all digits."""
    if mu is None:
        angle, plane = -math.asin(math.sin(slope) / gamma) - slope, hh.Plane(slope=slope, mu=2.0)
    else:
        angle, plane = -math.copysign(math.atan(mu) + math.asin(mu / math.hypot(1.0, mu) / gamma), vx), hh.Plane(mu=mu)
    scenario = hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=plane, start=hh.Start(angle=angle, vx=vx), duration=duration)
    if mu is None:
        scenario = scenario.replace("start.speed", 0.0)
    motion = hh.simulate(scenario)
    assert abs(motion.events[-1].omega) < 1e-13
    paths = ["start.angle", "start.speed" if mu is None else "start.omega"]
    found = motion.sensitivity(["end.omega", f"at({duration}).angle"], paths).derivatives
    for k, path in enumerate(paths):
        value, step = value_of(scenario, path), 1e-6
        low, high = (hh.simulate(scenario.with_values({path: value + side * step})).events[-1] for side in (-1.0, 1.0))
        true = [(high.omega - low.omega) / (2.0 * step), (high.angle - low.angle) / (2.0 * step)]
        assert found[:, k] == pytest.approx(true, rel=1e-6)
