"""What is written of every event: its impulses change the velocities, and a number stands only where it means something."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import brentq

import hophoop as hh
from hophoop.kernel.native import forced
from hophoop.kernel.physics.body import Event, Mode
from hophoop.kernel.physics.contact import slip_coefficients
from hophoop.kernel.physics.impact import impact
from hophoop.kernel.physics.modes import UNDECIDED
from hophoop.kernel.records.layout import EVENT, EVENTS, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.records.writing import event_without_jump, new_log
from hophoop.kernel.rigid.transitions import collide, end_bounces, leave_cone, resolve_mode, resolve_painleve_singularity

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
        assert row["stable"] in (0, 1) if kind == Event.REST else row["stable"] == -1
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
    assert "kane_gain" in kinds["gain"]
    assert "bounce_limit" in kinds["no slip"]
    for name in ("inconsistent", "inconsistent, slowly", "run into"):
        assert "painleve_inconsistent" in kinds[name], name
    assert kinds["indeterminate"][1:3] == ["painleve_indeterminate", "impact"]
    assert kinds["indeterminate, free"][1] == "painleve_indeterminate"
    assert "impact" in kinds["hop"]


def body_of(gamma=0.75, **plane):
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(**plane)).to_body()


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_rounding_is_no_gain(size):
    """A push of e = 1 without friction loses nothing, and gains nothing by rounding either."""
    body = body_of(mu=0.0, restitution=1.0)
    random = np.random.default_rng(2)
    for _ in range(100):
        th, vt, vn, om = random.uniform(-3.0, 3.0, 4) * [1.0, size, size, size]
        state = start_state(0.0, 0.0, th, vt, -abs(vn), om)
        assert collide(body, 1.0, state, Event.IMPACT, Mode.FLIGHT, 1)[1].gain == 0.0


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_a_gain_grows_with_the_square_of_the_speed(size):
    """That of Newton's law with friction, Kane's: the work of the impulses, found from the energy before and after."""
    body = body_of(mu=0.8, restitution=0.9, impact_law="newton")
    th, vt, vn, om = 1.25, 1.25 * size, -1.75 * size, 1.375 * size
    state = start_state(0.0, 0.0, th, vt, vn, om)
    after, cause = collide(body, 0.9, state, Event.IMPACT, Mode.FLIGHT, 1)
    arm, lever = 1.0 + body.eps * math.cos(th), body.eps * math.sin(th)

    def energy(one):
        return 0.5 * ((one.vt + arm * one.om) ** 2 + (one.vn - lever * one.om) ** 2 + body.kap * one.om**2)

    assert cause.gain == pytest.approx(energy(after) - energy(state), rel=1e-13)
    assert cause.gain > 0.05 * size**2


@pytest.mark.parametrize("speed", [0.7, 1.0])
@pytest.mark.parametrize("sigma", [1, -1])
def test_an_impact_within_contact_has_p_sigma_with_all_its_digits(sigma, speed):
    """Beside p_σ = 0, where that of sin θ and cos θ has none."""
    body = body_of(0.75, mu=1.0)

    def stiffness(th):
        return slip_coefficients(body, th, 0.0, math.sin(th), math.cos(th), 1, 0.0)[1]

    zero = brentq(stiffness, -1.2, -0.9, xtol=1e-16)
    th = next(one for one in (zero, np.nextafter(zero, -2.0), np.nextafter(zero, 0.0)) if stiffness(one) <= 0.0)
    state = start_state(0.0, 0.0, sigma * th, sigma * speed, 0.0, 0.1)
    s, c = math.sin(sigma * th), math.cos(sigma * th)
    exact = slip_coefficients(body, sigma * th, 0.0, s, c, sigma, 0.0)[1] / body.kap
    assert -1e-14 < exact <= 0.0
    after, cause = collide(body, 0.0, state, Event.IMPACT, Mode.SKID, 0)
    vt, vn, spin, p_n, p_t, _, _ = impact(body, 0.0, s, c, state.vt, 0.0, exact)
    assert (after.vt, after.vn, after.om, cause.p_n, cause.p_t) == (vt, vn, state.om + spin, p_n, p_t)
    assert p_n != impact(body, 0.0, s, c, state.vt, 0.0)[3] or exact == 0.0


@pytest.mark.parametrize("vt", [0.5, -0.5])
def test_the_end_of_bounces_without_slip_rolls(vt):
    """However the stop along the plane throws the rim up: about the contact point the angular momentum stays."""
    body = body_of(0.75, mu=math.inf, restitution=0.5)
    th = math.copysign(1.0, vt)
    state = start_state(0.0, 0.0, th, vt, -1e-3, 0.3)
    arm, lever = 1.0 + body.eps * math.cos(th), body.eps * math.sin(th)

    def momentum_and_energy(one):
        along, up = one.vt + arm * one.om, one.vn - lever * one.om
        return body.kap * one.om + arm * along - lever * up, 0.5 * (along**2 + up**2 + body.kap * one.om**2), along, up

    thrown, _ = collide(body, 0.0, state, Event.IMPACT, Mode.FLIGHT, 1)
    assert thrown.vn > 0.1
    after, cause = end_bounces(body, state)
    before, now = momentum_and_energy(state), momentum_and_energy(after)
    assert (after.vt, after.vn) == (0.0, 0.0)
    assert now[0] == pytest.approx(before[0], rel=1e-14)
    assert before[1] - now[1] == pytest.approx(after.impact_n + after.impact_t, rel=1e-13)
    assert (cause.p_t, cause.p_n) == pytest.approx((now[2] - before[2], now[3] - before[3]), rel=1e-13)
    assert (cause.kind, cause.gain, cause.collision) == (Event.BOUNCE_LIMIT, 0.0, 1)


def test_the_end_of_bounces_that_lift_hardly_at_all():
    """A throw of 0.1 is one, too."""
    body = body_of(0.75, mu=math.inf, restitution=0.5)
    state = start_state(0.0, 0.0, 1.0, 1e-3, -1e-6, 0.3)
    after, _ = end_bounces(body, state)
    assert (after.vt, after.vn) == (0.0, 0.0)


def written(function, *arguments):
    """(what a transition returns, the events that it writes, the doubt that it notes)."""
    scratch = new_scratch()
    log = new_log(np.zeros(20, EVENT), np.zeros(0, SEGMENT), scratch)
    found = function(*arguments, log)
    return found, log.events[: scratch.counts[EVENTS]], scratch.doubt.tolist()


def hoop_of(eps, kap, **plane):
    return hh.Scenario(hoop=hh.Hoop(eccentricity=eps, inertia_ratio=kap), plane=hh.Plane(**plane)).to_body()


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_slip_without_friction_that_has_ended_does_not_go_on(way):
    """The load before the centre and below it drives the rim ahead: after slip ahead rounding has the wrong sign."""
    body = hoop_of(0.5, 0.75, mu=0.0)
    state = start_state(0.0, 0.0, -way * 2.0, 0.0, 0.0, 0.0)
    ahead, back = (Mode.SKID, Mode.SPIN) if way > 0.0 else (Mode.SPIN, Mode.SKID)
    (mode, _), events, _ = written(resolve_mode, body, state, event_without_jump(Event.START, -1, state))
    assert (mode, events["kind"].tolist()) == (ahead, [Event.START])
    for before, after in ((ahead, back), (back, ahead)):
        (mode, _), events, _ = written(resolve_mode, body, state, event_without_jump(Event.STICK, before, state))
        assert (mode, events["kind"].tolist(), events["after_mode"].tolist()) == (after, [Event.SLIP_REVERSAL], [after])


@pytest.mark.parametrize("mu", [0.125, 1.0])
def test_with_friction_the_rule_decides_after_slip(mu):
    """Where the rim is too steep a slope for it: down it goes, from whichever side it came."""
    body = hoop_of(0.0, 1.0, mu=mu, slope=1.5)
    state = start_state(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    for before in (Mode.SKID, Mode.SPIN):
        (mode, _), _, _ = written(resolve_mode, body, state, event_without_jump(Event.STICK, before, state))
        assert mode == Mode.SKID


def test_where_the_model_has_no_answer_the_event_is_of_rolling():
    """μ = ∞ where rolling would have to pull, and free motion would enter the plane."""
    body = hoop_of(0.5, 0.01, mu=math.inf)
    state = start_state(0.0, 0.0, 1.0, 0.0, 0.0, 1.6)
    (mode, after), events, _ = written(resolve_mode, body, state, event_without_jump(Event.START, -1, state))
    assert (mode, after) == (UNDECIDED, state)
    assert (events["kind"].tolist(), events["after_mode"].tolist()) == ([Event.START], [Mode.ROLL])


@pytest.mark.parametrize("sigma", [1, -1])
def test_a_paradox_is_of_the_slip_before_it(sigma):
    """Also at the speed of 1 or below."""
    body = hoop_of(0.75, 0.4375, mu=1.3)
    for speed in (0.5, 1.0):
        state = start_state(0.0, 0.0, -sigma * 0.7, sigma * speed, 0.0, 0.1)
        _, events, _ = written(resolve_mode, body, state, event_without_jump(Event.START, -1, state))
        slip = Mode.SKID if sigma > 0 else Mode.SPIN
        assert events["kind"].tolist()[:2] == [Event.START, Event.PAINLEVE_INCONSISTENT]
        assert events["after_mode"].tolist()[:2] == [slip, slip]
        assert events["before_mode"][1] == slip


def singular(body, near):
    """θ where κ p_σ = 0 for slip ahead, approached with falling θ."""

    def stiffness(th):
        return slip_coefficients(body, th, 0.0, math.sin(th), math.cos(th), 1, 0.0)[1]

    return brentq(stiffness, *near, xtol=1e-16)


@pytest.mark.parametrize("side", [1, -1])
def test_slip_that_runs_into_p_sigma_of_zero_stops_or_turns_round(side):
    """By an impulse at that angle, along which θ̇ and v_t change in a fixed ratio; its work is the loss."""
    body = hoop_of(0.75, 0.4375, mu=1.3)
    th = singular(body, (-0.7, -0.1)) if side > 0 else -singular(body, (-0.7, -0.1))
    arm, lever = 1.0 + 0.75 * math.cos(th), 0.75 * math.sin(th)
    mode = Mode.SKID if side > 0 else Mode.SPIN
    turn, rate = -1.0 / lever, arm / lever - side * 1.3
    assert side * turn > 0.0 > side * rate
    for vt, om in ((0.5, -1.0), (9.0, -0.25)):
        state = start_state(0.0, 0.0, th, side * vt, 0.0, side * om)._replace(impact_t=0.5, t=3.0)
        (jams, after_mode, after), events, _ = written(resolve_painleve_singularity, body, int(mode), state)
        stop, round_trip = -side * vt / rate, -2.0 * side * om / turn
        p_n = min(stop, round_trip)
        assert not jams
        assert after.om == pytest.approx(side * om + turn * p_n, rel=1e-13)
        assert after.vt == (0.0 if stop < round_trip else pytest.approx(side * vt + rate * p_n, rel=1e-13))
        assert after.vn == 0.0
        assert after.impact_t == pytest.approx(0.5 + 1.3 * 0.5 * abs(side * vt + after.vt) * p_n, rel=1e-13)
        assert events["kind"].tolist() == [Event.PAINLEVE_INCONSISTENT, Event.IMPACT]
        assert events["gain"].tolist() == [0.0, 0.0]
        assert events["stable"].tolist() == [-1, -1]
        assert events["impulse_normal"][1] == pytest.approx(p_n, rel=1e-13)
        assert events["impulse_tangential"][1] == pytest.approx(-side * 1.3 * p_n, rel=1e-13)
        assert events["after_mode"][1] == after_mode
        assert (after_mode == mode) == (stop > round_trip)


@pytest.mark.parametrize("side", [1, -1])
def test_slip_without_speed_beside_p_sigma_of_zero_ends(side):
    """No impulse: there is nothing to stop."""
    body = hoop_of(0.75, 0.4375, mu=1.3)
    th = side * singular(body, (-0.7, -0.1))
    mode = Mode.SKID if side > 0 else Mode.SPIN
    for slip in (0.0, -1e-9 * side, -1e-3 * side):
        state = start_state(0.0, 0.0, th, slip, 0.0, side * -1.0)
        (jams, after_mode, after), events, _ = written(resolve_painleve_singularity, body, int(mode), state)
        assert (jams, after.vt, after.vn, after.om) == (False, 0.0, 0.0, state.om)
        assert after_mode != mode
        assert Event.IMPACT not in events["kind"]


def test_slip_that_jams_where_the_load_is_thrown_up():
    """Near p_σ = 0 and f_n = 0 at once, where ε cos θ θ̇² = g: some 10⁻⁶ away the panels are as good as nothing, too."""
    body = hoop_of(0.75, 0.4375, mu=1.3)
    th = singular(body, (-0.7, -0.1)) + 1e-7
    om = math.sqrt((1.0 - 1e-7) / (0.75 * math.cos(th)))
    for speed in (om, -om):
        state = start_state(0.0, 0.0, th, 9.0, 0.0, speed)
        (jams, mode, after), events, _ = written(resolve_painleve_singularity, body, int(Mode.SKID), state)
        if jams:
            assert (mode, events["kind"].tolist()) == (Mode.SKID, [Event.JAM])
            assert 0.75 * math.cos(th) * after.om**2 == pytest.approx(1.0, rel=1e-12)
        assert jams == (speed > 0.0)
        assert mode != UNDECIDED
    # elsewhere such an end of the panels is a failure
    for angle, speed in ((th, 0.5 * om), (th + 1e-4, om)):
        state = start_state(0.0, 0.0, angle, 9.0, 0.0, speed)
        assert written(resolve_painleve_singularity, body, int(Mode.SKID), state)[0] == (False, UNDECIDED, state)


@pytest.mark.parametrize("slip", [True, False])
def test_rolling_that_has_used_up_its_friction(slip):
    """Lifts off where the rim would be free, even by nothing at all; else it slips against the friction that it had."""
    body = hoop_of(0.25, 1.0, mu=0.5)

    def left(body, om, t=2.0):
        state = start_state(0.0, 0.0, 0.0, 0.0, 0.0, om)._replace(t=t)
        mode, events, doubt = written(leave_cone, body, state, slip)
        return mode, events["kind"].tolist(), events["after_mode"].tolist(), doubt == [t]

    after = Mode.SPIN if slip else Mode.SKID
    flight, slips = (Mode.FLIGHT, [Event.TAKEOFF], [Mode.FLIGHT]), (after, [Event.SLIP_START], [after])
    # with the load at the top f_n = θ̇²/4 − g
    for om, found, doubt in (
        (2.0, flight, True),
        (2.5, flight, False),
        (9.0, flight, False),
        (1.5, slips, False),
        (0.0, slips, False),
    ):
        assert left(body, om) == (*found, doubt)
    # a doubt within 10⁻¹¹ of g + θ̇²
    for part, doubt in ((4.9e-11, True), (5.1e-11, False)):
        assert left(body, math.sqrt(4.0 * (1.0 + part))) == (*flight, doubt)
        assert left(body, math.sqrt(4.0 * (1.0 - part))) == (*slips, doubt)
    endless = hoop_of(0.25, 1.0, mu=math.inf)
    assert left(endless, 1.5) == (UNDECIDED, [], [], False)
    assert left(endless, 2.0 * (1.0 - 1e-13)) == (UNDECIDED, [], [], False)
    assert left(endless, 2.0) == (*flight, False)
