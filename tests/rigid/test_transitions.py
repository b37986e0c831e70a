"""What is written of every event: its impulses change the velocities, and a number stands only where it means something."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import hophoop as hh
from hophoop.kernel.native import forced
from hophoop.kernel.physics.body import Event
from hophoop.kernel.physics.contact import slip_coefficients
from hophoop.kernel.physics.impact import impact
from hophoop.kernel.physics.modes import UNDECIDED
from hophoop.kernel.records.writing import event_without_jump
from hophoop.kernel.rigid.transitions import collide, end_bounces, leave_cone, resolve_mode, resolve_painleve_singularity
from rigid.tools import FLIGHT, ROLL, SKID, SPIN, body_of, moves, state_of, written

SIDES = pytest.mark.parametrize("side", [1, -1])


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
    "gain": scenario(
        hh.Start(height=0.25, angle=1.2, omega=1.5, vx=3.0), mu=0.8, restitution=0.9, impact_law="newton", duration=1.0
    ),
    "jam": scenario(hh.Start(angle=-2.312, vx=30.37, omega=5.654), mu=1.219),
    "run into": hh.Scenario(
        hoop=hh.Hoop(eccentricity=0.9128464310036214, inertia_ratio=0.00013391426767761817),
        plane=hh.Plane(mu=0.9864259833341639),
        start=hh.Start(angle=-3.32, vx=10.0, omega=20.0),
        duration=0.2,
    ),
    "no slip": scenario(hh.Start(height=0.3, angle=1.0, omega=2.0, vx=1.0), mu=math.inf, restitution=0.4),
}


# what a motion is named for: its first events
BEGINS = {
    "inconsistent": "start painleve_inconsistent impact",
    "inconsistent, slowly": "start painleve_inconsistent impact",
    "indeterminate": "start painleve_indeterminate impact",
    "indeterminate, free": "start painleve_indeterminate",
}
AMONG = {"hop": "impact", "gain": "kane_gain", "jam": "jam", "run into": "painleve_inconsistent", "no slip": "bounce_limit"}


def mirrored(case):
    names = ("x", "angle", "speed") if case.start.speed is not None else ("x", "angle", "vx", "omega")
    return case.with_values({f"start.{name}": -getattr(case.start, name) for name in names})


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("name", MOTIONS)
def test_events_keep_their_books(name, side):
    """Their impulses, at the lowest point of the rim, change the velocities by the arms of G."""
    case = MOTIONS[name] if side > 0 else mirrored(MOTIONS[name])
    with forced("interpreted"):
        motion = hh.simulate(case)
    kinds = [event.kind for event in motion.events]
    begins = BEGINS.get(name, "start").split()
    assert kinds[: len(begins)] == begins
    assert AMONG.get(name, "start") in kinds
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


def velocities(body, state):
    """(velocity of G along the plane, up, kinetic energy)."""
    along = state.vt + (1.0 + body.eps * math.cos(state.th)) * state.om
    up = state.vn - body.eps * math.sin(state.th) * state.om
    return along, up, 0.5 * (along**2 + up**2 + body.kap * state.om**2)


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_a_gain_is_energy_and_rounding_is_none(size):
    """A push of e = 1 without friction gains nothing by rounding; that of Newton's law with friction, Kane's, does."""
    body = body_of(mu=0.0, restitution=1.0)
    random = np.random.default_rng(2)
    for _ in range(100):
        th, vt, vn, om = random.uniform(-3.0, 3.0, 4) * [1.0, size, size, size]
        assert collide(body, 1.0, state_of(th, om, vt, vn=-abs(vn)), Event.IMPACT, FLIGHT, 1)[1].gain == 0.0
    body = body_of(mu=0.8, restitution=0.9, impact_law="newton")
    state = state_of(1.25, 1.375 * size, 1.25 * size, vn=-1.75 * size)
    after, cause = collide(body, 0.9, state, Event.IMPACT, FLIGHT, 1)
    assert cause.gain == pytest.approx(velocities(body, after)[2] - velocities(body, state)[2], rel=1e-13)
    assert cause.gain > 0.05 * size**2


@SIDES
def test_the_end_of_bounces_without_slip_rolls(side):
    """However the stop along the plane throws the rim up: about the contact point the angular momentum stays."""
    body = body_of(mu=math.inf, restitution=0.5)
    state = state_of(side * 1.0, 0.3, side * 0.5, vn=-1e-3)
    assert collide(body, 0.0, state, Event.IMPACT, FLIGHT, 1)[0].vn > 0.1  # thrown up
    after, cause = end_bounces(body, state)
    before, now = velocities(body, state), velocities(body, after)
    arm, lever = 1.0 + body.eps * math.cos(state.th), body.eps * math.sin(state.th)
    momenta = [body.kap * one.om + arm * along - lever * up for one, (along, up, _) in ((state, before), (after, now))]
    assert (after.vt, after.vn, momenta[1]) == (0.0, 0.0, pytest.approx(momenta[0], rel=1e-14))
    assert before[2] - now[2] == pytest.approx(after.impact_n + after.impact_t, rel=1e-13)
    assert (cause.p_t, cause.p_n) == pytest.approx((now[0] - before[0], now[1] - before[1]), rel=1e-13)
    assert (cause.kind, cause.gain, cause.collision) == (Event.BOUNCE_LIMIT, 0.0, 1)


def resolved(body, state, kind, before):
    """(mode, events) by the rule of the modes."""
    (mode, after), events, _, _ = written(resolve_mode, body, state, event_without_jump(kind, before, state))
    assert mode != UNDECIDED or after == state
    return mode, moves(events)


@SIDES
def test_slip_without_friction_that_has_ended_does_not_go_on(side):
    """The load before the centre and below it drives the rim ahead: after slip ahead rounding has the wrong sign."""
    body, state = body_of(0.5, 0.75, mu=0.0), state_of(-side * 2.0)
    ahead, back = (SKID, SPIN) if side > 0 else (SPIN, SKID)
    assert resolved(body, state, Event.START, -1) == (ahead, [(Event.START, -1, ahead)])
    for before, after in ((ahead, back), (back, ahead)):
        assert resolved(body, state, Event.STICK, before) == (after, [(Event.SLIP_REVERSAL, before, after)])


def test_where_the_model_has_no_answer_the_event_is_of_rolling():
    """μ = ∞ where rolling would have to pull, and free motion would enter the plane."""
    found = resolved(body_of(0.5, 0.01, mu=math.inf), state_of(1.0, 1.6), Event.START, -1)
    assert found == (UNDECIDED, [(Event.START, -1, ROLL)])


# beside p_σ = 0

STEEP = body_of(mu=1.3)


def singular(body, near=(-0.7, -0.1)):
    """θ where κ p_σ = 0 for slip ahead, approached with falling θ."""
    return brentq(lambda th: slip_coefficients(body, th, 0.0, math.sin(th), math.cos(th), 1, 0.0)[1], *near, xtol=1e-16)


@SIDES
def test_a_paradox_is_of_the_slip_before_it(side):
    """Also at the speed of 1 or below."""
    slip = SKID if side > 0 else SPIN
    for speed in (0.5, 1.0):
        _, events = resolved(STEEP, state_of(-side * 0.7, 0.1, side * speed), Event.START, -1)
        assert events[:2] == [(Event.START, -1, slip), (Event.PAINLEVE_INCONSISTENT, slip, slip)]


@SIDES
def test_an_impact_within_contact_has_p_sigma_with_all_its_digits(side):
    """Where that of sin θ and cos θ has none."""
    body = body_of(mu=1.0)

    def stiffness(th):
        return slip_coefficients(body, th, 0.0, math.sin(th), math.cos(th), side, 0.0)[1]

    zero = singular(body, (-1.2, -0.9))
    th = side * next(one for one in (zero, np.nextafter(zero, -2.0), np.nextafter(zero, 0.0)) if stiffness(side * one) <= 0.0)
    exact = stiffness(th) / body.kap
    assert -1e-14 < exact <= 0.0
    for speed in (0.7, 1.0):
        after, cause = collide(body, 0.0, state_of(th, 0.1, side * speed), Event.IMPACT, SKID, 0)
        found = impact(body, 0.0, math.sin(th), math.cos(th), side * speed, 0.0, exact)
        assert (after.vt, after.vn, after.om - 0.1, cause.p_n, cause.p_t) == pytest.approx(found[:5], rel=1e-15)
        assert cause.p_n != impact(body, 0.0, math.sin(th), math.cos(th), side * speed, 0.0)[3] or exact == 0.0


@SIDES
def test_slip_that_runs_into_p_sigma_of_zero_stops_or_turns_round(side):
    """By an impulse at that angle, along which θ̇ and v_t change in a fixed ratio; its work is the loss."""
    th = side * singular(STEEP)
    arm, lever = 1.0 + 0.75 * math.cos(th), 0.75 * math.sin(th)
    mode = SKID if side > 0 else SPIN
    turn, rate = -1.0 / lever, arm / lever - side * 1.3
    for vt, om, stops in ((0.5, -1.0, True), (9.0, -0.25, False)):
        state = state_of(th, side * om, side * vt, impact_t=0.5, t=3.0)
        (jams, after_mode, after), events, _, _ = written(resolve_painleve_singularity, STEEP, mode, state)
        p_n = -side * vt / rate if stops else -2.0 * side * om / turn
        slip = 0.0 if stops else side * vt + rate * p_n
        assert (jams, after_mode == mode) == (False, not stops)
        loss = 0.5 + 1.3 * 0.5 * abs(side * vt + slip) * p_n
        assert (after.om, after.vt, after.vn, after.impact_t) == pytest.approx(
            (side * om + turn * p_n, slip, 0.0, loss), rel=1e-13
        )
        assert moves(events) == [(Event.PAINLEVE_INCONSISTENT, mode, mode), (Event.IMPACT, mode, after_mode)]
        assert events[["gain", "stable"]].tolist() == [(0.0, -1), (0.0, -1)]
        assert (events["impulse_normal"][1], events["impulse_tangential"][1]) == pytest.approx(
            (p_n, -side * 1.3 * p_n), rel=1e-13
        )
    for slip in (0.0, -1e-9 * side, -1e-3 * side):  # without speed it ends: there is nothing to stop
        state = state_of(th, -side * 1.0, slip)
        (jams, after_mode, after), events, _, _ = written(resolve_painleve_singularity, STEEP, mode, state)
        assert (jams, after.vt, after.vn, after.om) == (False, 0.0, 0.0, state.om)
        assert after_mode != mode
        assert Event.IMPACT not in events["kind"]


def test_slip_that_jams_where_the_load_is_thrown_up():
    """Near p_σ = 0 and f_n = 0 at once, where ε cos θ θ̇² = g: some 10⁻⁶ away the panels are as good as nothing, too."""
    th = singular(STEEP) + 1e-7
    om = math.sqrt((1.0 - 1e-7) / (0.75 * math.cos(th)))
    (jams, mode, after), events, _, _ = written(resolve_painleve_singularity, STEEP, SKID, state_of(th, om, 9.0))
    assert (jams, mode, moves(events)) == (True, SKID, [(Event.JAM, SKID, SKID)])
    assert 0.75 * math.cos(th) * after.om**2 == pytest.approx(1.0, rel=1e-12)
    (jams, mode, _), _, _, _ = written(resolve_painleve_singularity, STEEP, SKID, state_of(th, -om, 9.0))
    assert not jams
    assert mode != UNDECIDED
    # elsewhere such an end of the panels is a failure
    for state in (state_of(th, 0.5 * om, 9.0), state_of(th + 1e-4, om, 9.0)):
        assert written(resolve_painleve_singularity, STEEP, SKID, state)[0] == (False, UNDECIDED, state)


@pytest.mark.parametrize(("forward", "slip"), [(True, SPIN), (False, SKID)])
def test_rolling_that_has_used_up_its_friction(forward, slip):
    """Lifts off where the rim would be free, even by nothing at all; else it slips against the friction that it had."""
    body = body_of(0.25, 1.0)

    def left(om, t=2.0, body=body):
        mode, events, _, doubt = written(leave_cone, body, state_of(0.0, om, t=t), forward)
        return mode, moves(events), doubt == [t]

    flight, slips = (FLIGHT, [(Event.TAKEOFF, ROLL, FLIGHT)]), (slip, [(Event.SLIP_START, ROLL, slip)])
    # with the load at the top f_n = θ̇²/4 − g; a doubt within 10⁻¹¹ of g + θ̇²
    for om, found, doubt in (
        (2.0, flight, True),
        (2.5, flight, False),
        (1.5, slips, False),
        (0.0, slips, False),
        *((math.sqrt(4.0 * (1.0 + sign * part)), found, near)
          for sign, found in ((1.0, flight), (-1.0, slips)) for part, near in ((4.9e-11, True), (5.1e-11, False))),
    ):  # fmt: skip
        assert left(om) == (*found, doubt)
    endless = body_of(0.25, 1.0, mu=math.inf)
    for om in (1.5, 2.0 * (1.0 - 1e-13)):
        assert left(om, body=endless) == (UNDECIDED, [], False)
    assert left(2.0, body=endless) == (*flight, False)
