"""What is written of every event: its impulses change the velocities, and a number stands only where it means something."""

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import hophoop as hh
from hophoop.kernel.native import forced
from hophoop.kernel.physics.body import Event
from hophoop.kernel.physics.contact import slip_coefficients
from hophoop.kernel.physics.modes import UNDECIDED
from hophoop.kernel.records.writing import event_without_jump
from hophoop.kernel.rigid.transitions import collide, end_bounces, leave_cone, resolve_mode, resolve_painleve_singularity
from newton_euler import energy
from rigid.tools import FLIGHT, ROLL, SKID, SPIN, body_of, moves, state_of, written
from symmetries import mirrored

SIDES = pytest.mark.parametrize("side", [1, -1])


# links of motions by an event that each is for
MOTIONS = {
    "takeoff": "duration=2",
    "apex": "duration=2&plane.mu=0.4&plane.restitution=0.6&start.height=0.2&start.angle=0.5&start.omega=2",
    "bounce_limit": "duration=2&plane.mu=inf&plane.restitution=0.4&start.height=0.3&start.angle=1&start.vx=1&start.omega=2",
    "kane_gain": "duration=1&plane.mu=0.8&plane.restitution=0.9&plane.impact_law=newton&start.height=0.25&start.angle=1.2"
    "&start.vx=3&start.omega=1.5",
    "painleve_inconsistent": "plane.mu=1.3&plane.restitution=0.5&start.angle=-0.7&start.vx=1.2&start.omega=1&duration=2",
    "painleve_indeterminate": "plane.mu=1.3&plane.painleve=impact&start.angle=-0.7&start.vx=8&start.omega=5&duration=2",
    "jam": "duration=2&plane.mu=1.219&start.angle=-2.312&start.vx=30.37&start.omega=5.654",
    # slip that runs into the paradox
    "impact": "duration=0.2&hoop.eccentricity=0.9128464310036214&hoop.inertia_ratio=0.00013391426767761817"
    "&plane.mu=0.9864259833341639&start.angle=-3.32&start.vx=10&start.omega=20",
    "rest": "duration=9&plane.rolling_resistance=0.05&start.angle=3",
}


@SIDES
@pytest.mark.parametrize("name", MOTIONS)
def test_events_keep_their_books(name, side):
    """Their impulses, at the lowest point of the rim, change the velocities by the arms of G."""
    given = hh.Scenario.from_query(MOTIONS[name])
    case = given if side > 0 else mirrored(given)
    with forced("interpreted"):
        motion = hh.simulate(case)
    assert motion.find(name)
    body = case.to_body()
    for row in motion._events:
        kind = row["kind"]
        within = row["before_mode"] in (ROLL, SPIN, SKID)
        strikes = kind in (Event.IMPACT, Event.BOUNCE_LIMIT)
        # a number stands only where it means something
        assert row["stable"] in (0, 1) if kind == Event.REST else row["stable"] == -1
        assert row["gain"] > 0.0 if kind == Event.KANE_GAIN else row["gain"] == 0.0
        assert row["collision"] == (-1 if not strikes else 0 if within else 1)
        if strikes and within:
            assert row["before_mode"] == (SKID if row["before_slip"] > 0.0 else SPIN)
        arm, lever = 1.0 + body.eps * math.cos(row["theta"]), body.eps * math.sin(row["theta"])
        turned = row["omega"] - row["before_omega"]
        along = row["slip"] - row["before_slip"] + arm * turned
        up = row["vy"] - row["before_vy"] - lever * turned
        p_n, p_t = row["impulse_normal"], row["impulse_tangential"]
        size = 1e-9 * (1.0 + abs(p_n) + abs(p_t))
        assert (p_n, p_t, lever * p_n - arm * p_t) == pytest.approx((up, along, body.kap * turned), abs=size)
        assert strikes or kind == Event.JAM or (p_n, p_t) == (0.0, 0.0)


def kinetic(body, state):
    return energy(body, 0.0, 0.0, state.th, state.vt + state.om, state.vn, state.om)[0]


def test_a_gain_is_energy_and_rounding_is_none():
    """A push of e = 1 without friction gains nothing by rounding; that of Newton's law with friction, Kane's, does."""
    smooth, gaining = body_of(mu=0.0, restitution=1.0), body_of(mu=0.8, restitution=0.9, impact_law="newton")
    random = np.random.default_rng(2)
    for size in (1e-6, 1.0, 1e6):
        for _ in range(100):
            th, vt, vn, om = random.uniform(-3.0, 3.0, 4) * [1.0, size, size, size]
            assert collide(smooth, 1.0, state_of(th, om, vt, vn=-abs(vn)), Event.IMPACT, FLIGHT, 1)[1].gain == 0.0
        state = state_of(1.25, 1.375 * size, 1.25 * size, vn=-1.75 * size)
        after, cause = collide(gaining, 0.9, state, Event.IMPACT, FLIGHT, 1)
        assert cause.gain == pytest.approx(kinetic(gaining, after) - kinetic(gaining, state), rel=1e-13)
        assert cause.gain > 0.05 * size**2


@SIDES
def test_the_end_of_bounces_without_slip_rolls(side):
    """However the stop along the plane throws the rim up: the impulses, at the contact point, turn the hoop."""
    body = body_of(mu=math.inf, restitution=0.5)
    state = state_of(side * 1.0, 0.3, side * 0.5, vn=-1e-3)
    assert collide(body, 0.0, state, Event.IMPACT, FLIGHT, 1)[0].vn > 0.1  # thrown up
    after, cause = end_bounces(body, state)
    arm, lever = 1.0 + body.eps * math.cos(state.th), body.eps * math.sin(state.th)
    turned = after.om - state.om
    along, up = arm * turned - state.vt, -lever * turned - state.vn  # changes of the velocity of G
    assert (after.vt, after.vn, cause.p_t, cause.p_n) == pytest.approx((0.0, 0.0, along, up), rel=1e-13)
    lost = kinetic(body, state) - kinetic(body, after)
    assert (body.kap * turned, after.impact_n + after.impact_t) == pytest.approx((lever * up - arm * along, lost), rel=1e-13)
    assert (cause.kind, cause.gain, cause.collision) == (Event.BOUNCE_LIMIT, 0.0, 1)


def resolved(body, state, kind, before):
    """(mode, events, doubt) by the rule of the modes."""
    (mode, after), events, _, doubt = written(resolve_mode, body, state, event_without_jump(kind, before, state))
    assert mode != UNDECIDED or after == state
    return mode, moves(events), doubt


@SIDES
def test_slip_without_friction_that_has_ended_does_not_go_on(side):
    """The load before the centre and below it drives the rim ahead: after slip ahead rounding has the wrong sign."""
    body, state = body_of(0.5, 0.75, mu=0.0), state_of(-side * 2.0)
    ahead, back = (SKID, SPIN) if side > 0 else (SPIN, SKID)
    assert resolved(body, state, Event.START, -1)[:2] == (ahead, [(Event.START, -1, ahead)])
    for before, after in ((ahead, back), (back, ahead)):
        assert resolved(body, state, Event.STICK, before)[:2] == (after, [(Event.SLIP_REVERSAL, before, after)])


def test_where_the_model_has_no_answer_the_event_is_of_rolling():
    """μ = ∞ where rolling would have to pull, and free motion would enter the plane: more digits tell nothing."""
    mode, events, doubt = resolved(body_of(0.5, 0.01, mu=math.inf), state_of(1.0, 1.6), Event.START, -1)
    assert (mode, events) == (UNDECIDED, [(Event.START, -1, ROLL)])
    assert np.isnan(doubt).all()


# beside p_σ = 0

STEEP = body_of(mu=1.3)


def singular(body, near=(-0.7, -0.1)):
    """θ where κ p_σ = 0 for slip ahead, approached with falling θ."""
    return brentq(lambda th: slip_coefficients(body, math.sin(th), math.cos(th), 1, 0.0)[1], *near, xtol=1e-16)


@SIDES
def test_a_paradox_is_of_the_slip_before_it(side):
    """Also at the speed of 1 or below."""
    slip = SKID if side > 0 else SPIN
    for speed in (0.5, 1.0):
        _, events, _ = resolved(STEEP, state_of(-side * 0.7, 0.1, side * speed), Event.START, -1)
        assert events[:2] == [(Event.START, -1, slip), (Event.PAINLEVE_INCONSISTENT, slip, slip)]


def at_singularity(state, mode=SKID):
    """(whether it jams, mode, state, moves)."""
    (jams, mode, after), events, _, _ = written(resolve_painleve_singularity, STEEP, mode, state)
    return jams, mode, after, moves(events)


@SIDES
def test_slip_that_runs_into_p_sigma_of_zero_stops_or_turns_round(side):
    """By an impulse, which physics/test_impact.py knows; its work is the loss. Without speed there is nothing to stop."""
    th, mode = side * singular(STEEP), SKID if side > 0 else SPIN
    for vt, om, stops in ((0.5, -1.0, True), (9.0, -0.25, False)):
        before = state_of(th, side * om, side * vt, impact_t=0.5)
        jams, then, after, found = at_singularity(before, mode)
        assert (jams, then == mode, after.vt == 0.0, after.vn) == (False, not stops, stops, 0.0)
        assert after.impact_t == pytest.approx(0.5 + kinetic(STEEP, before) - kinetic(STEEP, after), rel=1e-13)
        assert found == [(Event.PAINLEVE_INCONSISTENT, mode, mode), (Event.IMPACT, mode, then)]
    for slip in (0.0, -1e-3 * side):
        jams, then, after, found = at_singularity(state_of(th, -side * 1.0, slip), mode)
        assert (jams, then != mode, after.vt, after.vn, after.om) == (False, True, 0.0, 0.0, -side)
        assert Event.IMPACT not in {kind for kind, _, _ in found}


def test_slip_that_jams_where_the_load_is_thrown_up():
    """Near p_σ = 0 and f_n = 0 at once, where ε cos θ θ̇² = g: some 10⁻⁶ away the panels are as good as nothing, too."""
    th = singular(STEEP) + 1e-7
    om = math.sqrt((1.0 - 1e-7) / (0.75 * math.cos(th)))
    jams, mode, after, found = at_singularity(state_of(th, om, 9.0))
    assert (jams, mode, found) == (True, SKID, [(Event.JAM, SKID, SKID)])
    assert 0.75 * math.cos(th) * after.om**2 == pytest.approx(1.0, rel=1e-12)
    jams, mode, _, _ = at_singularity(state_of(th, -om, 9.0))
    assert not jams
    assert mode != UNDECIDED
    for state in (state_of(th, 0.5 * om, 9.0), state_of(th + 1e-4, om, 9.0)):  # elsewhere such an end is a failure
        assert at_singularity(state) == (False, UNDECIDED, state, [])


@pytest.mark.parametrize(("forward", "slip"), [(True, SPIN), (False, SKID)])
def test_rolling_that_has_used_up_its_friction(forward, slip):
    """Lifts off where the rim would be free, even by nothing at all; else it slips against the friction that it had."""
    body = body_of(0.25, 1.0)
    flight, slips = (FLIGHT, [(Event.TAKEOFF, ROLL, FLIGHT)]), (slip, [(Event.SLIP_START, ROLL, slip)])
    # with the load at the top f_n = θ̇²/4 − g; a doubt within 10⁻¹¹ of g + θ̇²
    for u, mu, expected, doubtful in (
        (4.0, 0.5, flight, True),
        (4.0 + 1.96e-10, 0.5, flight, True),
        (4.0 + 2.04e-10, 0.5, flight, False),
        (4.0 - 1.96e-10, 0.5, slips, True),
        (4.0 - 2.04e-10, 0.5, slips, False),
        (0.0, 0.5, slips, False),
        (4.0 * (1.0 - 2e-13), math.inf, (UNDECIDED, []), False),
        (4.0, math.inf, flight, False),
    ):
        state = state_of(0.0, math.sqrt(u), t=2.0)
        mode, events, _, doubt = written(leave_cone, body._replace(mu_s=mu), state, forward)
        assert (mode, moves(events), doubt == [2.0]) == (*expected, doubtful)
