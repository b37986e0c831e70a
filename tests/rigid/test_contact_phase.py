"""Rolling and slip step by step: rest, and what follows slow motion and slip without rotation."""

import math

import pytest

from hophoop.kernel.physics.body import Event, Status
from hophoop.kernel.physics.contact import torque_at_rest
from hophoop.kernel.rigid import contact_phase
from hophoop.kernel.rigid.phase import Ending, begin_phase
from rigid.tools import ROLL, SKID, SPIN, body_of, limits, motion_of, moves, sines_of, state_of, written

pytestmark = pytest.mark.filterwarnings("ignore:.*encountered in:RuntimeWarning")  # where a kernel gives up a panel
SIDES = pytest.mark.parametrize("side", [1, -1])


# rest


def doubt_of(body, sigma, state, until=99.0):
    """The time of the doubt that a rest notes."""
    return written(contact_phase.doubt_rest, body, sigma, state, until)[3][0]


@pytest.mark.parametrize(("sigma", "plane"), [(0, {}), (1, {"mu": 0.0}), (-1, {"mu": 0.0, "slope": 0.2})])
def test_at_the_top_only_what_is_there_exactly_stays(sigma, plane):
    """θ in two doubles; 1e-280 rad are 600 √(R/g) away from being seen."""
    for psi, still in ((0.0, True), (0.5e-280, True), (2e-280, False), (-1e-20, False)):
        state = state_of(0.0, th_low=psi)
        assert contact_phase.is_equilibrium(body_of(**plane), sigma, state) is still
        assert math.isnan(doubt_of(body_of(**plane), sigma, state))


def test_a_hilltop_that_no_double_is_holds_with_a_doubt():
    """Once e^λt has made 10⁻¹¹ of 10⁻¹⁶; on a slope or in slip with friction; not where the couple holds, nor in the valley."""
    body = body_of(slope=0.3, mu=3.0)
    hilltop = -0.3 - math.asin(math.sin(0.3) / 0.75)
    assert contact_phase.is_equilibrium(body, 0, state_of(hilltop))
    growth = math.sqrt(0.4375 + 0.25**2 + 1.5 * (1.0 + math.cos(hilltop))) / math.sqrt(0.75 * math.cos(hilltop + 0.3))
    assert doubt_of(body, 0, state_of(hilltop)) == pytest.approx(11.5 * growth, rel=1e-12)
    assert math.isnan(doubt_of(body, 0, state_of(hilltop), 11.0 * growth))
    assert math.isnan(doubt_of(body._replace(resist=0.1), 0, state_of(hilltop)))
    assert math.isnan(doubt_of(body, 0, state_of(math.pi - 0.6 - hilltop)))
    slip = body_of(mu=0.3)
    th = -math.atan(0.3) - math.asin(0.3 / math.hypot(1.0, 0.3) / 0.75)
    assert contact_phase.is_equilibrium(slip, 1, state_of(th))
    assert 5.0 < doubt_of(slip, 1, state_of(th)) < 20.0
    state = state_of(hilltop)
    step = written(contact_phase.still_step, body, begin_phase(ROLL, state, Ending.REST), state, limits(state, 99.0))
    assert (step[1]["kind"].tolist(), step[3]) == ([Event.REST], [pytest.approx(11.5 * growth, rel=1e-12)])


@SIDES
@pytest.mark.parametrize(("om", "doubts"), [(1e-7, True), (1e-4, False)])
def test_a_slow_pass_in_slip_is_in_doubt(om, doubts, side):
    """Where θ̇ and θ̈ are so small together, while θ̇ falls; not at the valley, nor at an ordinary turning point."""
    body = body_of(mu=0.0)

    def doubt(body, sigma, state):
        return contact_phase.passes_in_doubt(body, sigma, state, *sines_of(state))

    assert doubt(body, 1, state_of(-side * om, side * om)) is doubts
    assert not doubt(body, 1, state_of(side * om, side * om))
    assert not doubt(body, 1, state_of(math.pi - side * om, side * om))
    assert not doubt(body, 1, state_of(-side * 0.5, 0.0))
    assert not doubt(body_of(rolling_resistance=0.01), 0, state_of(0.0))


@pytest.mark.parametrize(
    ("body", "sigma", "th", "stays"),
    [
        # in the valley, which no double is, within its rounding; not where the weight turns the hoop
        (body_of(), 0, math.pi, True),
        (body_of(), 0, -math.pi, True),
        (body_of(), 0, math.pi + 1e-14, False),
        (body_of(), 0, 1e-14, False),
        (body_of(), 0, 2.0, False),
        (body_of(), 1, 1.0, False),
        # without gravity, and a ring that the couple holds
        (body_of(gravity=0.0), 0, 1.0, True),
        (body_of(0.0, 0.7, slope=0.4, rolling_resistance=0.5), 0, -4.0, True),
        # the massless hoop that slips or has its load on the plane, to the rounding of cos θ
        (body_of(1.0), 1, 1.0, True),
        (body_of(1.0), -1, 1.0, True),
        (body_of(1.0), 0, math.pi - 1e-9, True),
        (body_of(1.0), 0, 2.0, False),
    ],
)
def test_where_a_hoop_that_does_not_turn_stays(body, sigma, th, stays):
    assert contact_phase.remains_at_rest(body, sigma, state_of(th)) is stays


def test_a_load_close_to_the_plane_rests_in_its_valley_to_the_rounding_of_the_angle():
    """The inertia about the contact point is so small there that the rounding of θ turns the hoop quickly."""
    for k in range(-17, 18):
        body = body_of(0.9999, slope=0.05 * k)
        valley = math.pi - body.slope + math.asin(math.sin(body.slope) / body.eps)
        for th in (valley, valley - 2.0 * math.pi) if abs(valley - math.pi) <= 1.0 else ():
            for near in (math.nextafter(th, -9.0), th, math.nextafter(th, 9.0), th + 1e-12):
                assert contact_phase.is_equilibrium(body, 0, state_of(near)) is (near < th + 5e-13), body.slope


@SIDES
def test_rest_is_stable_in_a_valley_or_where_the_couple_holds_it_with_some_left(side):
    """On a slope where ε sin(θ + β) + sin β = f cos β at most; held by all of the couple, or a ring, it is not."""
    stable = contact_phase.equilibrium_is_stable
    for resist in (0.0, 0.0625):
        level = body_of(rolling_resistance=resist)
        assert stable(level, math.pi * side)
        assert stable(level, 0.0) is (resist > 0.0)
    for slope, resist in ((0.0, 0.0625), (0.8, 0.01)):
        body = body_of(slope=slope * side, rolling_resistance=resist)
        for part in (-1.001, -0.999, 0.999, 1.001):
            th = math.asin((part * resist * math.cos(slope) - math.sin(slope)) / 0.75) - slope
            assert stable(body, side * th) is (abs(part) < 1.0)
    needed = torque_at_rest(level, math.sin(0.05), math.cos(0.05))
    assert not stable(level._replace(resist=needed), 0.05)
    assert not stable(body_of(0.0), 1.0)


def test_a_swing_within_the_rounding_of_the_angle_turns_before_it_rests():
    """Rest lasts to the end of time, in a valley or, not stable, at the top."""
    status, events, segments = motion_of(body_of(), state_of(math.pi, 1e-17), 20.0)
    assert (status, events["kind"].tolist()) == (Status.AT_REST, [Event.START, Event.TURN, Event.REST, Event.END])
    assert events["omega"].tolist() == [1e-17, 0.0, 0.0, 0.0]
    assert (events["stable"][2], segments["t_end"][-1]) == (1, 20.0)
    status, events, segments = motion_of(body_of(), state_of(0.0), 20.0)
    assert (status, events["stable"][1], segments["t_end"].tolist()) == (Status.AT_REST, 0, [20.0])


# motion


def test_what_hardly_moves_is_followed_in_panels_of_the_time_that_there_is():
    """A ring rolls on as it is in one panel; beside the top δ cosh λt, λ² = ε/(κ + (1 + ε)²), needs a narrow one."""
    for om in (1e-9, -1e-5):
        status, events, segments = motion_of(body_of(0.0), state_of(2.0, om), 0.25)
        assert (status, len(segments), moves(events[1:])) == (Status.COMPLETED, 1, [(Event.END, ROLL, ROLL)])
        assert (events["theta"][1] - 2.0) + events["theta_low"][1] == pytest.approx(0.25 * om, rel=1e-12)
    rate = math.sqrt(0.75 / (0.4375 + 1.75**2))
    for offset in (1e-100, -1e-30):
        for t_end in (0.5, 2.0):
            _, events, _ = motion_of(body_of(), state_of(offset), t_end)
            place, speed = offset * math.cosh(rate * t_end), offset * rate * math.sinh(rate * t_end)
            assert (events["angle"][1], events["omega"][1]) == pytest.approx((place, speed), rel=1e-12, abs=0.0)
    _, events, segments = motion_of(body_of(), state_of(2.0, 0.5), 0.0)
    assert (events["kind"].tolist(), len(segments)) == ([Event.START, Event.END], 1)  # no time at all


@SIDES
def test_after_slip_without_rotation_comes_what_the_mode_rule_says(side):
    """Rolling, as there is no torque; without friction it slides back down the slope."""
    mode, other = (SKID, SPIN) if side > 0 else (SPIN, SKID)
    for body, th, after, kind in (
        (body_of(), math.pi, ROLL, Event.STICK),
        (body_of(1.0), 2.5, ROLL, Event.STICK),
        (body_of(mu=0.0, slope=-0.25 * side), math.pi, other, Event.SLIP_REVERSAL),
    ):
        state = state_of(th, 0.0, 1.5 * side)
        phase = begin_phase(mode, state, Ending.CONTINUES)
        found, events, _, _ = written(contact_phase.still_step, body, phase, state, limits(state, 50.0))
        assert (found.mode, moves(events)) == (after, [(kind, mode, after)])
