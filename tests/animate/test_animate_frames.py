"""Which instant each frame shows, what is behind the hoop, and how far all reaches. Nothing is drawn."""

import math

import numpy as np
import pytest

import hophoop as hh
from animate_tools import motion
from hophoop.animate.frames import Timing, clock, end_word, event_marks, extent, follow, trace
from hophoop.animate.look import bounded


@pytest.mark.parametrize(
    ("timing", "times"),
    [
        ({"fps": 50}, np.arange(101) / 50),
        ({"fps": 30, "speed": 0.25}, np.arange(241) / 120),
        ({"fps": 30, "speed": 3.0}, np.arange(21) / 10),
        ({"fps": 10, "start": 0.5, "end": 1.5}, np.linspace(0.5, 1.5, 11)),
    ],
)
def test_times_of_the_frames(timing, times):
    shown = clock([motion()], Timing(**timing))
    np.testing.assert_allclose(shown.times[0], times, atol=1e-12)
    assert (shown.rate == timing.get("speed", 1.0)).all()


def test_slow_motion_around_the_takeoff():
    takeoff = motion().find("takeoff")[0].t
    shown = clock([motion()], Timing(fps=200, slow_at=("takeoff",), slow_factor=5, slow_width=0.1))
    times = shown.times[0]
    pace = np.gradient(times, 1 / 200)
    near, far = abs(times - takeoff) < 0.04, abs(times - takeoff) > 0.11
    np.testing.assert_allclose(pace[near], 0.2, rtol=2e-3)
    np.testing.assert_allclose(pace[far][1:-1], 1.0, rtol=2e-3)
    np.testing.assert_allclose(shown.rate, pace, rtol=0.02, atol=0.02)
    assert clock([motion()], Timing(fps=30, slow_at=(1.0,))).count > 61
    assert clock([motion(2.0)], Timing(fps=30, slow_at=("takeoff",))).count == 61


def test_several_motions_in_step():
    """In time a motion that has ended holds; in angle, one that follows waits while the leader turns back."""
    short, rocking, rolling = motion(duration=1.0), motion(0.1, 0.3, 8.0), motion(3.1, 1.0, 1.0)
    np.testing.assert_allclose(clock([short, motion(2.0)], Timing(fps=20)).times[0], np.minimum(np.arange(41) / 20, 1.0))
    shown = clock([rocking, motion(), rolling], Timing(fps=30, step="angle"))
    grid = np.linspace(0.0, 8.0, 20_001)
    reached = np.interp(shown.times[0], grid, np.maximum.accumulate(rocking.at(grid).angle))
    np.testing.assert_allclose(motion().at(shown.times[1]).angle, reached, atol=1e-5)
    assert shown.times[2][-1] == 1.0  # never that far


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"fps": 2000}, "at most 1000"),
        ({"speed": -1}, "speed = -1"),
        ({"slow_factor": 0}, "slow_factor = 0"),
        ({"slow_width": 0}, "slow_width = 0"),
        ({"slow_at": (1.0, math.inf)}, "slow_at = inf must be a finite time"),
        ({"start": math.nan}, "start = nan must be a finite time"),
        ({"end": math.inf}, "end = inf must be a finite time"),
        ({"step": "phase"}, "step = 'phase' must be one of time, angle"),
        ({"start": 3.0}, "start = 3.0"),
        ({"start": 1.0, "end": 0.5}, "end = 0.5"),
    ],
)
def test_bad_timing_is_refused(options, words):
    with pytest.raises(ValueError, match=words):
        clock([motion()], Timing(**options))


def test_no_motion_is_refused():
    with pytest.raises(ValueError, match="at least one motion"):
        clock([], Timing())


# Traces, extent, camera


def test_the_trace_holds_all_events_and_is_red_only_in_flight():
    track = trace(motion())
    assert {event.t for event in motion().events} <= set(track.t)
    takeoff, landing = motion().find("takeoff")[0].t, motion().find("impact")[0].t
    np.testing.assert_array_equal(track.airborne, (takeoff <= track.t) & (track.t < landing))
    for flies, ends in ((True, [takeoff, landing]), (False, [0.0, 2.0])):
        shown = track.t[np.isfinite(track.gravity_path(flies)).all(axis=1)]
        assert list(shown[[0, -1]]) == ends


def test_the_camera_follows_steady_motion_without_lag_and_is_calm():
    times = np.arange(300) / 60
    jerks = 0.2 * np.sin(20 * times)
    for n in (3, 300):
        np.testing.assert_allclose(follow(times[:n], 5 - 3 * times[:n], 0.4), 5 - 3 * times[:n], atol=1e-9)
    left = np.abs(np.diff(follow(times, times + jerks, 0.45) - times)) / np.abs(np.diff(jerks)).max()
    assert left.max() < 0.1
    assert left[90:-90].max() < 0.01


@pytest.fixture(scope="module")
def jam():
    return hh.simulate(hh.Scenario.from_query("duration=2&hoop.load_fraction=0.85&plane.mu=0.8&start.speed=8.9"))


def test_a_film_stays_where_mechanics_says_nothing_more(jam):
    shown = clock([jam], Timing(fps=20))
    moving = int(np.floor(jam.duration * 20)) + 1
    assert (shown.times[0][moving:] == jam.duration).all()
    assert (shown.still[:moving] == 0.0).all()
    np.testing.assert_allclose(shown.still[moving:], np.arange(shown.count - moving) / 20)
    assert shown.still[-1] > 1.0
    assert [one.kind for one in event_marks(jam, shown.times[0])] == ["impact", "jam"]
    assert end_word(jam, jam.duration, last=True) == "jammed"
    assert end_word(jam, 0.999 * jam.duration, last=False) == ""
    # it does not stay with a motion that could go on, nor in the middle of one
    for runs, timing in (([motion()], {}), ([jam], {"end": 0.5}), ([jam, motion()], {})):
        assert (clock(runs, Timing(fps=20, **timing)).still == 0.0).all()
    assert [end_word(motion(), 2.0, last) for last in (True, False)] == ["", "ended"]


def test_the_scale_of_arrows_is_not_that_of_a_jam(jam):
    assert jam.at(jam.duration).normal_force > 1e5
    assert extent(jam).force < 300.0
    np.testing.assert_allclose(bounded(np.array([30.0, 40.0]), 60.0), [30.0, 40.0])
    np.testing.assert_allclose(bounded(np.array([3e9, 4e9]), 60.0), [36.0, 48.0])
    assert (bounded(np.zeros(2), 60.0) == 0.0).all()
