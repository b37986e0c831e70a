"""Which instant each frame shows, what is behind the hoop, and how far all reaches. Nothing is drawn."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import hophoop as hh
from animate_tools import motion, places
from hophoop.animate.frames import Timing, clock, end_word, event_marks, extent, follow, trace
from hophoop.animate.look import bounded, nice
from hophoop.results.poses import poses_of, rim_speeds, times_at_turn, turned_at
from hophoop.scenario import describe


def test_real_time_by_default():
    shown = clock([motion()], Timing(fps=50))
    assert shown.count == 101
    np.testing.assert_allclose(shown.times[0], np.arange(101) / 50, atol=1e-12)
    assert (shown.rate == 1.0).all()


@pytest.mark.parametrize("speed", [0.25, 3.0])
def test_speed_is_motion_over_film(speed):
    shown = clock([motion()], Timing(fps=30, speed=speed))
    assert shown.count == math.floor(2.0 / speed * 30 + 1e-9) + 1
    np.testing.assert_allclose(np.diff(shown.times[0]), speed / 30, rtol=1e-9)


def test_part_of_a_motion():
    shown = clock([motion()], Timing(fps=10, start=0.5, end=1.5))
    np.testing.assert_allclose(shown.times[0], np.linspace(0.5, 1.5, 11))


def test_slow_motion_around_the_takeoff():
    takeoff = motion().find("takeoff")[0].t
    shown = clock([motion()], Timing(fps=200, slow_at=("takeoff",), slow_factor=5, slow_width=0.1))
    times = shown.times[0]
    pace = np.gradient(times, 1 / 200)
    near, far = abs(times - takeoff) < 0.04, abs(times - takeoff) > 0.11
    assert near.sum() > 50
    np.testing.assert_allclose(pace[near], 0.2, rtol=2e-3)
    np.testing.assert_allclose(pace[far][1:-1], 1.0, rtol=2e-3)
    np.testing.assert_allclose(shown.rate, pace, rtol=0.02, atol=0.02)
    assert (np.diff(times) > 0).all()
    # the film's length is the integral of 1/rate: 0.1 s at a fifth, 0.1 s in between
    assert times[-1] == pytest.approx(2.0, abs=1 / 200)


def test_slow_motion_around_a_time_and_without_such_an_event():
    assert clock([motion()], Timing(fps=30, slow_at=(1.0,))).count > 61
    assert clock([motion(2.0)], Timing(fps=30, slow_at=("takeoff",))).count == 61


def test_in_step_in_time_a_motion_that_has_ended_holds():
    short, long = motion(duration=1.0), motion(2.0)
    shown = clock([short, long], Timing(fps=20))
    assert shown.count == 41
    assert (shown.times[0][20:] == 1.0).all()
    np.testing.assert_allclose(shown.times[1], np.arange(41) / 20, atol=1e-12)


def test_in_step_in_angle():
    fast, slow = motion(), motion(2.0, duration=4.0)
    shown = clock([fast, slow], Timing(fps=60, step="angle"))
    np.testing.assert_allclose(slow.at(shown.times[1]).angle, fast.at(shown.times[0]).angle, rtol=1e-9, atol=1e-9)


def test_in_step_in_angle_with_a_leader_that_turns_back():
    rocking, rolling = motion(0.1, 0.3, 8.0), motion(3.1, 1.0, 2.0)
    shown = clock([rocking, rolling], Timing(fps=30, step="angle"))
    assert (np.diff(shown.times[1]) >= 0).all()
    reached = np.maximum.accumulate(rocking.at(shown.times[0]).angle)
    np.testing.assert_allclose(rolling.at(shown.times[1]).angle, reached, rtol=1e-3, atol=2e-3)


def test_first_time_at_a_turn():
    rocking = motion(0.1, 0.3, 8.0)
    wanted = np.array([0.0, 1.0, 3.0, 5.9, 50.0])
    times = times_at_turn(rocking, wanted)
    np.testing.assert_allclose(rocking.at(times[:4]).angle, wanted[:4], atol=1e-9)
    assert times[0] == 0.0
    assert times[4] == 8.0  # never that far
    before = rocking.at(np.linspace(0, times[3], 2000)[:-1]).angle
    assert (before < 5.9).all()
    assert turned_at(rocking, times[:4]) == pytest.approx(wanted[:4], abs=1e-9)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"fps": 0}, "fps = 0"),
        ({"fps": math.nan}, "fps"),
        ({"fps": 2000}, "at most 1000"),
        ({"speed": -1}, "speed = -1"),
        ({"slow_factor": 0}, "slow_factor = 0"),
        ({"slow_width": 0}, "slow_width = 0"),
        ({"slow_at": ("hop",)}, r"slow_at = 'hop' must be a finite time \(s\) or one of"),
        ({"slow_at": math.nan}, "slow_at = nan must be a finite time"),
        ({"slow_at": (1.0, math.inf)}, "slow_at = inf must be a finite time"),
        ({"start": math.nan}, "start = nan must be a finite time"),
        ({"end": math.nan}, "end = nan must be a finite time"),
        ({"step": "phase"}, "step = 'phase' must be one of time, angle"),
        ({"start": 3.0}, "start = 3.0"),
        ({"start": 1.0, "end": 0.5}, "end = 0.5"),
        ({"end": 9.0}, "end = 9.0"),
    ],
)
def test_bad_timing_is_refused(options, words):
    with pytest.raises(ValueError, match=words):
        clock([motion()], Timing(**options))


def test_no_motion_is_refused():
    with pytest.raises(ValueError, match="at least one motion"):
        clock([], Timing())


# Poses


@pytest.mark.parametrize("slope", [0.0, 0.3])
def test_poses_are_where_the_model_says(slope):
    times = np.linspace(0.0, 1.5, 40)
    run = motion(1.0, 1.0, 1.5, slope)
    poses = poses_of(run, times)
    np.testing.assert_allclose(poses.load, places(run, times), atol=1e-12)
    # G lies on the way from the centre to the load, at γ R
    between = poses.center + 0.75 * (poses.load - poses.center)
    np.testing.assert_allclose(poses.gravity_center, between, atol=1e-12)
    # the contact is a radius from the centre, across the plane
    down = poses.contact - poses.center
    np.testing.assert_allclose(np.hypot(*down.T), 1.0 + 0 * times, atol=1e-12)
    np.testing.assert_allclose(down, np.tile([-math.sin(slope), -math.cos(slope)], (40, 1)), atol=1e-12)


def test_forces_are_arrows_across_and_along_the_plane():
    run = motion(1.0, 1.0, 1.5, 0.3)
    poses = poses_of(run, [0.3, 0.8])
    normal = np.array([math.sin(0.3), math.cos(0.3)])
    along = np.array([math.cos(0.3), -math.sin(0.3)])
    for i in range(2):
        np.testing.assert_allclose(poses.normal_force[i], poses.sample.normal_force[i] * normal, atol=1e-12)
        np.testing.assert_allclose(poses.friction_force[i], poses.sample.friction_force[i] * along, atol=1e-12)


def test_rim_speeds_are_those_of_the_moving_points():
    """Against the displacement of material points, in flight too."""
    run, step = motion(), 1e-6
    for t in (0.2, 0.7, 1.3):
        here, there = poses_of(run, [t - step]), poses_of(run, [t + step])
        body = np.linspace(0.0, 6.0, 7)

        def point(poses, body=body):
            turned = body + poses.angle[0]
            return poses.center[0] + np.stack([np.sin(turned), np.cos(turned)], axis=-1)

        measured = np.hypot(*(point(there) - point(here)).T) / (2 * step)
        now = poses_of(run, [t])
        np.testing.assert_allclose(rim_speeds(now, body + now.angle[0], 1.0)[0], measured, rtol=1e-6)


# Traces, extent, camera


def test_the_trace_holds_all_events_and_is_red_only_in_flight():
    track = trace(motion())
    events = {event.t for event in motion().events}
    assert events <= set(track.t)
    takeoff, landing = motion().find("takeoff")[0].t, motion().find("impact")[0].t
    np.testing.assert_array_equal(track.airborne, (takeoff <= track.t) & (track.t < landing))
    for flies, least, most in ((True, takeoff, landing), (False, 0.0, 2.0)):
        shown = track.t[np.isfinite(track.gravity_path(flies)).all(axis=1)]
        assert (shown[0], shown[-1]) == (least, most)
    np.testing.assert_allclose(track.load, places(motion(), track.t), atol=1e-12)


def test_the_trace_is_fine_enough_for_the_eye():
    track = trace(motion(duration=2.0))
    # sagitta of the chords, over the radius
    middle = places(motion(), 0.5 * (track.t[1:] + track.t[:-1]))
    off = np.hypot(*(middle - 0.5 * (track.load[1:] + track.load[:-1])).T)
    assert off.max() < 0.002


def test_extent():
    size = extent(motion())
    sample = motion().at(motion().times(4000))
    assert size.along == pytest.approx((0.0, sample.x.max()), abs=1e-6)
    assert size.height == pytest.approx(sample.height.max(), rel=1e-3)
    # the top of the rim, where it rolls fastest
    assert size.speed == pytest.approx(2 * sample.vx.max(), rel=5e-3)
    assert size.force == pytest.approx(sample.normal_force.max(), rel=2e-2)


@settings(max_examples=30)
@given(st.floats(-5, 5), st.floats(-3, 3), st.integers(3, 200))
def test_the_camera_follows_steady_motion_without_lag(start, speed, n):
    times = np.arange(n) / 30
    np.testing.assert_allclose(follow(times, start + speed * times, 0.4), start + speed * times, atol=1e-9)


def test_the_camera_is_calm():
    times = np.arange(300) / 60
    jerks = 0.2 * np.sin(20 * times)
    left = np.abs(np.diff(follow(times, times + jerks, 0.45) - times)) / np.abs(np.diff(jerks)).max()
    assert left.max() < 0.1
    assert left[90:-90].max() < 0.01


@given(st.floats(1e-6, 1e6))
def test_nice_numbers(value):
    step = nice(value)
    assert step <= value * (1 + 1e-9) < 2.6 * step
    assert float(f"{step:.0e}") == pytest.approx(step)


def test_descriptions():
    assert describe(motion().scenario) == "v₀ = 3.1 m/s, μ = 1, γ = 0.75"
    other = hh.Scenario(
        hoop=hh.Hoop(eccentricity=0.5, inertia_ratio=0.6),
        plane=hh.Plane(mu_static=0.5, mu_kinetic=0.4, slope=0.1, restitution=0.2),
        start=hh.Start(omega=1.0, vx=1.0),
        contact=hh.Compliant(),
    )
    assert describe(other) == (
        "v = (1, 0) m/s, θ̇ = 1 rad/s, μs = 0.5, μk = 0.4, ε = 0.5, κ = 0.6, β = 5.73°, e = 0.2, compliant contact"
    )


@pytest.mark.parametrize("value", [math.inf])
def test_a_plane_without_slip_is_said(value):
    assert "μ = ∞" in describe(hh.Scenario(plane=hh.Plane(mu=value)))


def jam():
    return hh.simulate(hh.Hoop.ideal(0.85), hh.Plane(mu=0.8), hh.Start.rolling(8.9), duration=2.0)


def test_a_film_stays_where_mechanics_says_nothing_more():
    stuck = jam()
    shown = clock([stuck], Timing(fps=20))
    moving = int(np.floor(stuck.duration * 20)) + 1
    assert stuck.status == "jammed"
    assert (shown.times[0][moving:] == stuck.duration).all()
    assert (shown.still[:moving] == 0.0).all()
    np.testing.assert_allclose(shown.still[moving:], np.arange(shown.count - moving) / 20)
    assert shown.still[-1] > 1.0
    assert [one.kind for one in event_marks(stuck, shown.times[0])] == ["impact", "jam"]
    assert end_word(stuck, stuck.duration, last=True) == "jammed"
    assert end_word(stuck, 0.999 * stuck.duration, last=False) == ""


def test_a_film_stops_with_a_motion_that_could_go_on():
    shown = clock([motion()], Timing(fps=20))
    assert (shown.still == 0.0).all()
    assert end_word(motion(), 2.0, last=True) == ""
    assert end_word(motion(), 2.0, last=False) == "ended"


def test_a_film_of_a_part_does_not_stay():
    shown = clock([jam()], Timing(fps=20, end=0.5))
    assert shown.times[0][-1] == 0.5
    assert (shown.still == 0.0).all()
    beside = clock([jam(), motion()], Timing(fps=20))
    assert beside.times[1][-1] == 2.0
    assert (beside.still == 0.0).all()


def test_the_scale_of_arrows_is_not_that_of_a_jam():
    stuck = jam()
    assert stuck.at(stuck.duration).normal_force > 1e5
    size = extent(stuck)
    assert size.force < 300.0


def test_an_arrow_has_a_greatest_length():
    np.testing.assert_allclose(bounded(np.array([30.0, 40.0]), 60.0), [30.0, 40.0])
    np.testing.assert_allclose(bounded(np.array([3e9, 4e9]), 60.0), [36.0, 48.0])
    assert (bounded(np.zeros(2), 60.0) == 0.0).all()
