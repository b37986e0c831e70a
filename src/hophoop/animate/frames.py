"""What each frame of a film shows: which instant of the motion, and the way so far. Draws nothing."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from hophoop.kernel.physics.body import EVENT_NAMES
from hophoop.results.poses import Floats, event_times, poses_of, rim_speeds, times_at_turn, turned_at
from hophoop.scenario import InputError
from hophoop.scenario.scenario import time_unit
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary.statuses import STATUSES

STEPS = ("time", "angle")
USUAL_RATE = 60.0
HOLD = 1.2  # how long a film stays on the last state of a motion that cannot go on [s of film]
# Points of a trace a unit of time √(R/g); at the reference hoop some 310 a second.
TRACE_DENSITY = 100
MAX_TRACE_POINTS = 200_000


@dataclass(frozen=True)
class Timing:
    """How film time and the motion's time belong together.

    Attributes
    ----------
    fps : float or None
        Frames a second of film; None is what the format usually has [1/s].
    speed : float
        Seconds of motion a second of film, away from slow motion [1].
    slow_at : str, float or sequence of them
        Kinds of events, or times [s], around which the film is slow.
    slow_factor : float
        How many times slower there [1].
    slow_width : float or None
        How long before and after the film is slow, in the motion's time; None takes √(R/g)/2 [s].
    start, end : float or None
        Part of the motion that is shown [s].
    step : {'time', 'angle'}
        What several motions have in common at each frame.
    """

    fps: float | None = None
    speed: float = 1.0
    slow_at: Sequence[str | float] | str | float = ()
    slow_factor: float = 8.0
    slow_width: float | None = None
    start: float = 0.0
    end: float | None = None
    step: str = "time"

    def __post_init__(self) -> None:
        object.__setattr__(self, "slow_at", self.marks)
        for name, most in (("fps", 1000.0), ("speed", math.inf), ("slow_factor", math.inf)):
            value = getattr(self, name)
            if value is None:
                continue
            if not (0.0 < value <= most and math.isfinite(value)):
                limit = f" and at most {most:g}" if math.isfinite(most) else ""
                raise InputError.of_field(name, value, f"a positive number{limit}")
        if self.slow_width is not None and not (0.0 < self.slow_width < math.inf):
            raise InputError.of_field("slow_width", self.slow_width, "positive (s)")
        if self.step not in STEPS:
            raise InputError.of_field("step", self.step, f"one of {', '.join(STEPS)}")
        for mark in self.marks:
            if isinstance(mark, str) and mark not in EVENT_NAMES:
                raise InputError(
                    f"slow_at = {mark!r} is not a time or one of {', '.join(EVENT_NAMES)}.", field="slow_at", value=mark
                )

    @property
    def marks(self) -> tuple[str | float, ...]:
        """Where the film is slow, as a tuple: kinds of events, or times [s]."""
        marks = self.slow_at
        return (marks,) if isinstance(marks, str | float | int) else tuple(marks)

    @property
    def frame_rate(self) -> float:
        """Frames a second of film, 60 where none is given [1/s]."""
        return USUAL_RATE if self.fps is None else self.fps


@dataclass(frozen=True)
class Clock:
    """The instant that each frame shows.

    Attributes
    ----------
    times : tuple of ndarray, shape (frames,)
        For each motion, its time at each frame [s].
    rate : ndarray, shape (frames,)
        Seconds of motion a second of film [1].
    still : ndarray, shape (frames,)
        How long the film has stayed on the end of a motion that cannot go on [s of film].
    """

    times: tuple[Floats, ...]
    rate: Floats
    still: Floats

    @property
    def count(self) -> int:
        """Number of frames."""
        return len(self.rate)


def clock(motions: Sequence[Trajectory], timing: Timing) -> Clock:
    """The instant of each motion that each frame shows.

    A motion that has ended holds its last state; where none goes on, because mechanics says nothing more, the film stays
    there for a while. In step in angle, the first motion runs as in step in
    time, and each other one shows the first instant at which it has turned as far.

    Parameters
    ----------
    motions : sequence of Trajectory
    timing : Timing

    Returns
    -------
    clock : Clock

    Raises
    ------
    ValueError
        If there is no motion, or the part to show is outside of it.
    """
    if not motions:
        raise InputError("motions = () must hold at least one motion.", field="motions", value=())
    leaders = motions if timing.step == "time" else motions[:1]
    longest = max(motion.duration for motion in leaders)
    end = longest if timing.end is None else timing.end
    if not 0.0 <= timing.start <= longest:
        raise InputError.of_field("start", timing.start, f"from 0 to the motion's end at {longest!r} s")
    if not timing.start <= end <= longest * (1 + 1e-12):
        raise InputError.of_field("end", end, f"from the start at {timing.start!r} s to the motion's end at {longest!r} s")
    times, rate = _film_times(leaders, timing, min(end, longest))
    still = np.zeros(len(times))
    if end >= longest and all(STATUSES[motion.status].stopped for motion in leaders if motion.duration == longest):
        held = np.arange(math.ceil(HOLD * timing.frame_rate)) / timing.frame_rate
        times, still = np.append(times, np.full(held.size, longest)), np.append(still, held)
        rate = np.append(rate, np.full(held.size, rate[-1]))
    if timing.step == "time":
        return Clock(tuple(np.minimum(times, motion.duration) for motion in motions), rate, still)
    turned = turned_at(motions[0], times)
    shown = (times, *(times_at_turn(other, turned) for other in motions[1:]))
    return Clock(shown, rate, still)


def ended(motion: Trajectory, t: float, last: bool) -> str:
    """What a film says instead of the mode, once a motion has ended: empty before.

    Parameters
    ----------
    motion : Trajectory
    t : float
        Time that is shown [s].
    last : bool
        Whether it is the first or the last picture, where a motion that could go on has not ended yet.

    Returns
    -------
    word : str
    """
    if t < motion.duration:
        return ""
    return STATUSES[motion.status].stopped or ("" if last else "ended")


def _film_times(motions: Sequence[Trajectory], timing: Timing, end: float) -> tuple[Floats, Floats]:
    first = timing.start
    marks = _slow_marks(motions, timing)
    if not marks.size:
        count = math.floor((end - first) / timing.speed * timing.frame_rate + 1e-9) + 1
        times = np.minimum(first + np.arange(count) * (timing.speed / timing.frame_rate), end)
        return times, np.full(count, timing.speed)
    width = timing.slow_width or 0.5 * _second(motions[0])
    # The film's own time is the integral of 1/rate; a grid far finer than a frame and a bump holds it.
    step = min(0.1 * timing.speed / timing.frame_rate, width / 50.0)
    grid = np.linspace(first, end, max(2, math.ceil((end - first) / step) + 1))
    nearest = _distance(grid, marks) / width
    # 1 within half the width, then a cosine down to 0: the change of pace does not jerk
    bump = 0.5 + 0.5 * np.cos(math.pi * np.clip(2.0 * nearest - 1.0, 0.0, 1.0))
    pace = timing.speed * timing.slow_factor**-bump
    film = np.concatenate([[0.0], np.cumsum(np.diff(grid) * 0.5 * (1.0 / pace[1:] + 1.0 / pace[:-1]))])
    count = math.floor(film[-1] * timing.frame_rate + 1e-9) + 1
    moments = np.arange(count) / timing.frame_rate
    return np.interp(moments, film, grid), np.interp(moments, film, pace)


def _slow_marks(motions: Sequence[Trajectory], timing: Timing) -> Floats:
    marks: list[float] = []
    for mark in timing.marks:
        if isinstance(mark, str):
            marks += [event.t for motion in motions for event in motion.find(mark)]
        else:
            marks.append(float(mark))
    return np.unique(np.asarray(marks, dtype=float))


def _distance(grid: Floats, marks: Floats) -> Floats:
    after = np.clip(np.searchsorted(marks, grid), 0, marks.size - 1)
    before = np.maximum(after - 1, 0)
    return np.minimum(np.abs(grid - marks[after]), np.abs(grid - marks[before]))


def _second(motion: Trajectory) -> float:
    return time_unit(motion.scenario.hoop, motion.scenario.plane)


@dataclass(frozen=True)
class Trace:
    """The paths of the load and of the centre of gravity over a whole motion.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Time [s]; all events are among them.
    load, gravity_center : ndarray, shape (n, 2)
        World coordinates [m].
    runs : list of (int, int, bool)
        Pieces from a first to a last index, airborne or not, in order; each starts where the former ends.
    """

    t: Floats
    load: Floats
    gravity_center: Floats
    runs: list[tuple[int, int, bool]]


def trace(motion: Trajectory, start: float = 0.0, end: float | None = None) -> Trace:
    """The paths of the load and of the centre of gravity.

    Parameters
    ----------
    motion : Trajectory
    start, end : float, optional
        Part of the motion [s].

    Returns
    -------
    trace : Trace
    """
    end = motion.duration if end is None else min(end, motion.duration)
    count = int(min(MAX_TRACE_POINTS, max(32, TRACE_DENSITY * (end - start) / _second(motion))))
    marks = event_times(motion)
    marks = marks[(marks >= start) & (marks <= end)]
    t = np.unique(np.concatenate([np.linspace(start, end, count), marks]))
    poses = poses_of(motion, t)
    # The mode at a time is that which follows it, so the stretch after point i is airborne if i is.
    airborne = poses.mode[:-1] == "H" if len(t) > 1 else np.zeros(0, dtype=bool)
    edges = np.flatnonzero(np.diff(airborne.astype(int))) + 1
    bounds = [0, *edges.tolist(), len(airborne)]
    runs = [(a, b, bool(airborne[a])) for a, b in pairwise(bounds) if b > a]
    return Trace(t, poses.load, poses.gravity_center, runs)


@dataclass(frozen=True)
class Extent:
    """How far a motion reaches, to fit a view and its scales.

    Attributes
    ----------
    along : tuple of float
        Least and greatest place of the centre along the plane [m].
    height : float
        Greatest gap under the rim [m].
    speed : float
        Greatest speed of a point of the rim [m/s].
    force : float
        Greatest contact force but for short peaks [N].
    """

    along: tuple[float, float]
    height: float
    speed: float
    force: float


def extent(motion: Trajectory, start: float = 0.0, end: float | None = None) -> Extent:
    """How far a motion reaches in a part of it.

    Parameters
    ----------
    motion : Trajectory
    start, end : float, optional
        Part of the motion [s].

    Returns
    -------
    extent : Extent
    """
    radius = motion.scenario.hoop.radius
    end = motion.duration if end is None else min(end, motion.duration)
    count = int(min(20_000, max(200, 60 * (end - start) / _second(motion))))
    poses = poses_of(motion, np.linspace(start, end, count))
    around = np.linspace(0.0, 2.0 * math.pi, 24, endpoint=False)
    weight = motion.scenario.hoop.mass * motion.scenario.plane.gravity
    forces = np.hypot(*np.moveaxis(poses.normal_force, -1, 0))
    if motion.status == "jammed":  # in the instant of a jam the force is without bound
        forces = forces[poses.t < motion.duration]
    # A compliant contact answers an impact with a peak of a few samples: it is not what the scale is for.
    usual = float(np.quantile(forces, 0.995)) if motion.scenario.contact.model != "rigid" else float(forces.max())
    return Extent(
        along=(float(np.min(poses.sample.x)), float(np.max(poses.sample.x))),
        height=float(np.max(poses.sample.height)),
        speed=float(rim_speeds(poses, around, radius).max()),
        force=max(usual, weight),
    )


def follow(times: Floats, places: Floats, seconds: float) -> Floats:
    """A camera's smooth way after something that moves by fits and starts.

    Parameters
    ----------
    times : ndarray, shape (n,)
        Equally spaced times of the film [s].
    places : ndarray, shape (n,)
        Where it is [m].
    seconds : float
        Width of the smoothing, a standard deviation [s].

    Returns
    -------
    smooth : ndarray, shape (n,)
        [m].
    """
    if len(times) < 3:
        return places.copy()
    sigma = max(seconds / (times[1] - times[0]), 1e-9)
    reach = math.ceil(3.0 * sigma)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    # Continued beyond both ends by reflection in the end point, so that it neither lags nor runs ahead there.
    padded = np.pad(places, reach, mode="reflect", reflect_type="odd")
    return np.convolve(padded, kernel / kernel.sum(), mode="valid")
