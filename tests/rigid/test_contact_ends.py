"""What follows rolling and slip that end, or turn round."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from contact_tools import body_of, events_of, log_of, phase_at, sliding, state_of
from hophoop.kernel.physics.body import Event, Mode, Status
from hophoop.kernel.records.layout import EVENT, SEGMENT, new_scratch
from hophoop.kernel.rigid import contact_phase
from hophoop.kernel.rigid.phase import STOP_AT_TAKEOFF, STOP_AT_TURN, Ending, limits_of
from hophoop.kernel.rigid.run import BY_RULE, run

pytestmark = pytest.mark.filterwarnings("ignore:.*encountered in:RuntimeWarning")  # where a kernel gives up a panel


ROLL, SPIN, SKID, FLIGHT = (contact_phase.ROLL, contact_phase.SPIN, contact_phase.SKID, contact_phase.FLIGHT)


def test_rolling_that_cannot_be_followed_ends_in_doubt():
    log, scratch = log_of()
    state = state_of(1.0, 0.5)._replace(t=3.0)
    after = contact_phase.after_rolling(body_of(), phase_at(ROLL, state), Ending.SEARCH_LIMIT, state, log)
    assert (after.mode, after.ending, after.status) == (ROLL, Ending.SEARCH_LIMIT, Status.UNDETERMINED)
    assert scratch.doubt.tolist() == [3.0]
    assert events_of(log) == []


@pytest.mark.parametrize(
    ("ending", "om", "mode"),
    [("CONE_FORWARD", 0.5, SPIN), ("CONE_BACKWARD", 0.5, SKID), ("CONE_FORWARD", 2.0, FLIGHT), ("CONE_BACKWARD", 2.0, FLIGHT)],
)
def test_after_rolling_that_needs_all_friction_it_slips_against_it_or_flies(ending, om, mode):
    """It flies where ε θ̇² > g at the top; v_t begins with its second derivative where the friction is the same in slip."""
    ending = Ending[ending]
    state = state_of(0.0, om)._replace(t=3.0)
    for mu_k, vanishing in ((0.5, 2), (0.25, 1)):
        log, _ = log_of()
        body = body_of()._replace(mu_k=mu_k)
        after = contact_phase.after_rolling(body, phase_at(ROLL, state), ending, state, log)
        assert (after.mode, after.ending, after.status, after.begins) == (mode, ending, -1, True)
        assert mode == FLIGHT or contact_phase.vanishing_slip_derivatives(body, after) == vanishing
        assert events_of(log) == [(Event.TAKEOFF if mode == FLIGHT else Event.SLIP_START, ROLL, mode)]


def test_rolling_ends_on_the_cone_where_a_panel_does_not_resolve_the_forces():
    """A light ring that the load lifts on its way up: compared with the motion of 20 digits."""
    start = hh.Start(angle=-0.6, vx=-0.6, omega=0.0)
    scenario = hh.Scenario(hoop=hh.Hoop.ideal(0.9997), plane=hh.Plane(mu=2.0, gravity=1.0), start=start, duration=35.0)
    for one, other in zip(hh.simulate(scenario).events, hh.simulate(scenario, digits=20).events, strict=True):
        assert one.kind == other.kind
        assert one.t == pytest.approx(float(other.t), rel=1e-14)


@pytest.mark.parametrize("mode", [SPIN, SKID])
def test_slip_that_lifts_off_flies(mode):
    log, _ = log_of()
    state = state_of(0.0, 2.0, 1.0 if mode == SKID else -1.0)
    after = contact_phase.after_slip(body_of(), phase_at(mode, state), Ending.LIFT_OFF, state, log)
    assert (after.mode, after.ending, after.status) == (FLIGHT, Ending.LIFT_OFF, -1)
    assert events_of(log) == [(Event.TAKEOFF, mode, FLIGHT)]


@pytest.mark.parametrize("mode", [SPIN, SKID])
def test_slip_that_ends_rolls_where_it_can(mode):
    log, _ = log_of()
    state = state_of(3.0, 0.5)
    after = contact_phase.after_slip(body_of(), phase_at(mode, state), Ending.SLIP_END, state, log)
    assert (after.mode, after.ending, after.status) == (ROLL, Ending.SLIP_END, -1)
    assert events_of(log) == [(Event.STICK, mode, ROLL)]


def turned(mode, th, vt=0.0, stop=0, **plane):
    """What follows a turning point there, and what is written."""
    log, _ = log_of()
    state = state_of(th, 0.0, vt)._replace(t=3.0)
    limits = limits_of(state, 8.0, math.nan, stop, 0)
    phase = phase_at(mode, state)
    after = contact_phase.turning_point_step(body_of(**plane), phase, state, 7, limits, log)
    return after, events_of(log)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_where_rolling_turns_it_rests_rolls_back_or_slips(side):
    """By the torque ε sin θ against f, and by tan of the angle of the force against μ."""
    resist = {"rolling_resistance": 0.125}
    after, events = turned(ROLL, side * 0.1, **resist)
    assert (after.mode, after.status, after.state.t) == (ROLL, Status.AT_REST, 8.0)
    assert events == [(Event.REST, ROLL, ROLL)]
    after, events = turned(ROLL, side * 1.0, **resist)
    assert (after.mode, after.status, after.ending, after.level, after.begins) == (ROLL, -1, Ending.TURNING_POINT, 7, False)
    assert events == [(Event.TURN, ROLL, ROLL)]
    after, events = turned(ROLL, side * 1.0, stop=STOP_AT_TURN, **resist)
    assert (after.mode, after.status, after.ending) == (ROLL, Status.COMPLETED, Ending.TURNING_POINT)
    assert events == [(Event.TURN, ROLL, ROLL)]
    slip = SPIN if side > 0.0 else SKID
    after, events = turned(ROLL, side * 1.0, mu=0.125, **resist)
    assert (after.mode, after.status, after.ending, after.begins) == (slip, -1, Ending.TURNING_POINT, True)
    assert events == [(Event.TURN, ROLL, ROLL), (Event.SLIP_START, ROLL, slip)]
    after, events = turned(ROLL, side * 1.0, mu=0.125, stop=STOP_AT_TURN, **resist)
    assert (after.mode, after.status, after.ending) == (ROLL, Status.COMPLETED, Ending.TURNING_POINT)
    assert events == [(Event.TURN, ROLL, ROLL)]


@pytest.mark.parametrize("sigma", [1, -1])
def test_where_slip_turns_it_goes_on(sigma):
    mode = SKID if sigma > 0 else SPIN
    for stop, status in ((0, -1), (STOP_AT_TURN, Status.COMPLETED)):
        after, events = turned(mode, 2.0, 0.5 * sigma, stop, rolling_resistance=0.125)
        assert (after.mode, after.status, after.ending) == (mode, status, Ending.TURNING_POINT)
        assert events == [(Event.TURN, mode, mode)]


@pytest.mark.parametrize("sigma", [1, -1])
def test_slip_without_rotation_that_stops_on_a_slope_turns_round(sigma):
    """Without friction it slides back."""
    mode, other = (SKID, SPIN) if sigma > 0 else (SPIN, SKID)
    body = body_of(mu=0.0, slope=-0.25 * sigma)
    phase = sliding(sigma)
    limits = limits_of(phase.state, 50.0, math.nan, 0, 0)
    log, _ = log_of()
    after = contact_phase.still_step(body, phase, phase.state, limits, log)
    assert (after.mode, after.ending, after.status) == (other, Ending.SLIP_END, -1)
    assert events_of(log) == [(Event.SLIP_REVERSAL, mode, other)]


def test_the_massless_hoop_skims_where_rolling_has_no_force_left():
    """And one with inertia 1 slips."""
    state = state_of(1.0, 0.5)
    log, _ = log_of()
    after = contact_phase.after_rolling(body_of(1.0), phase_at(ROLL, state), Ending.CONE_FORWARD, state, log)
    assert (after.mode, events_of(log)) == (int(Mode.SKIM), [(Event.SKIM, ROLL, Mode.SKIM)])
    log, _ = log_of()
    heavy = hh.Scenario(hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=1.0), plane=hh.Plane(mu=0.5)).to_body()
    after = contact_phase.after_rolling(heavy, phase_at(ROLL, state), Ending.CONE_FORWARD, state, log)
    assert (after.mode, events_of(log)) == (SPIN, [(Event.SLIP_START, ROLL, SPIN)])


def moved_by_kernel(body, state, t_end, stop=0):
    """(status, kinds of the events, events, number of segments)."""
    events, segments = np.empty(40, EVENT), np.empty(2000, SEGMENT)
    status, count, pieces = run(body, state, BY_RULE, t_end, math.nan, stop, events, segments, new_scratch())
    return status, [Event(kind).name for kind in events["kind"][:count]], events[:count], pieces


def test_a_motion_without_duration_has_a_piece_of_no_length():
    """With its state."""
    status, kinds, _, pieces = moved_by_kernel(body_of(), state_of(2.0, 0.5), 0.0)
    assert (status, kinds, pieces) == (Status.COMPLETED, ["START", "END"], 1)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_ring_that_rolling_resistance_stops_is_at_rest(side):
    """After ω (1 + κ)/f; it does not turn round."""
    body = hh.Scenario(
        hoop=hh.Hoop(eccentricity=0.0, inertia_ratio=1.0), plane=hh.Plane(mu=0.5, rolling_resistance=0.1)
    ).to_body()
    status, kinds, events, _ = moved_by_kernel(body, state_of(1.0, 0.25 * side), 20.0)
    assert (status, kinds) == (Status.AT_REST, ["START", "REST", "END"])
    assert events["t"][1] == pytest.approx(0.25 * 2.0 / 0.1, rel=1e-13)


@pytest.mark.parametrize("resist", [0.0, 0.01])
def test_a_swing_ends_at_its_first_turning_point_only_if_asked(resist):
    body = body_of(rolling_resistance=resist)
    for stop in (0, STOP_AT_TAKEOFF):
        status, kinds, _, _ = moved_by_kernel(body, state_of(2.5), 20.0, stop)
        assert (status, kinds) == (Status.COMPLETED, ["START", *["TURN"] * (len(kinds) - 2), "END"])
        assert len(kinds) > 4
    status, kinds, _, _ = moved_by_kernel(body, state_of(2.5), 20.0, STOP_AT_TURN)
    assert (status, kinds) == (Status.COMPLETED, ["START", "TURN", "END"])


def test_slip_that_ends_goes_on_where_only_a_turning_point_is_asked_for():
    status, kinds, _, _ = moved_by_kernel(body_of(), state_of(2.5, 0.0, 0.5), 5.0, STOP_AT_TURN)
    assert status == Status.COMPLETED
    assert "STICK" in kinds
    assert kinds[-2:] == ["TURN", "END"]


@pytest.mark.parametrize("om", [1e-9, -1e-5])
def test_what_hardly_moves_is_followed_in_panels_of_the_time_that_there_is(om):
    """A ring rolls on as it is; one panel is the whole motion."""
    status, kinds, events, pieces = moved_by_kernel(body_of(0.0), state_of(2.0, om), 0.25)
    assert (status, kinds, pieces) == (Status.COMPLETED, ["START", "END"], 1)
    assert events["after_mode"][1] == ROLL
    assert (events["theta"][1] - 2.0) + events["theta_low"][1] == pytest.approx(0.25 * om, rel=1e-12)
    assert events["x"][1] == pytest.approx(0.25 * om, rel=1e-12)


def test_a_swing_within_the_rounding_of_the_angle_turns_before_it_rests():
    status, kinds, events, _ = moved_by_kernel(body_of(), state_of(math.pi, 1e-17), 20.0)
    assert (status, kinds) == (Status.AT_REST, ["START", "TURN", "REST", "END"])
    assert events["omega"].tolist() == [1e-17, 0.0, 0.0, 0.0]
