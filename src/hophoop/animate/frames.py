"""Times and paths of the motion in each frame of a film."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hophoop.animate.look import TAGS, as_tuple, labels_of
from hophoop.kernel.model import EVENT_NAMES
from hophoop.results.poses import Floats, event_times, poses_of, rim_speeds, times_at_turn, to_world, turned_at
from hophoop.scenario import InputError
from hophoop.scenario.scenario import time_unit
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary.names import EVENTS, STATUSES

STEPS = ("time", "angle")
USUAL_RATE, MOST_FPS = 60.0, 1000.0
HOLD = 1.2  # pause on the last state of a motion without continuation [s of film]
# Points of a trace per unit of time √(R/g), about 310 per second for the reference hoop.
TRACE_DENSITY = 100
MAX_TRACE_POINTS = 200_000


@dataclass(frozen=True)
class Timing:
    """Mapping between film time and the motion's time.

    Attributes
    ----------
    fps : float or None
        Pictures per second; by default 60, in 3D 30, in a gif 25 [1].
    speed : float
        Seconds of motion per second of film [1].
    slow_at : str, float or sequence of them
        Kinds of events, or times [s], with slow motion around them.
    slow_factor : float
        Factor of the slow motion [1].
    slow_width : float or None
        Duration of the slow motion before and after, in the motion's time [s]; by default √(R/g)/2.
    start : float
        First time to show [s].
    end : float or None
        Last time to show [s]; by default the motion's end.
    step : {'time', 'angle'}
        Quantity that several motions have in common in each frame.
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
        for name, least, most, allowed in (
            ("fps", 0.0, MOST_FPS, f"a positive number and at most {MOST_FPS:g}"),
            ("speed", 0.0, math.inf, "a positive number"),
            ("slow_factor", 0.0, math.inf, "a positive number"),
            ("slow_width", 0.0, math.inf, "positive (s)"),
            ("start", -math.inf, math.inf, "a finite time (s)"),
            ("end", -math.inf, math.inf, "a finite time (s)"),
        ):
            value = getattr(self, name)
            if value is not None and not (least < value <= most and math.isfinite(value)):
                raise InputError.of_field(name, value, allowed)
        if self.step not in STEPS:
            raise InputError.of_field("step", self.step, f"one of {', '.join(STEPS)}")
        for mark in self.marks:
            if mark not in EVENT_NAMES if isinstance(mark, str) else not math.isfinite(mark):
                raise InputError.of_field("slow_at", mark, f"a finite time (s) or one of {', '.join(EVENT_NAMES)}")

    @property
    def marks(self) -> tuple[str | float, ...]:
        """Kinds of events or times [s] with slow motion, as a tuple."""
        return as_tuple(self.slow_at)

    @property
    def frame_rate(self) -> float:
        """Frames per second of film, 60 by default [1/s]."""
        return USUAL_RATE if self.fps is None else self.fps


@dataclass(frozen=True)
class Clock:
    """Times of the frames.

    Attributes
    ----------
    times : tuple of ndarray, shape (frames,)
        For each motion, its time in each frame [s].
    rate : ndarray, shape (frames,)
        Seconds of motion per second of film [1].
    still : ndarray, shape (frames,)
        Time of the pause at the end of a motion without continuation [s of film].
    """

    times: tuple[Floats, ...]
    rate: Floats
    still: Floats

    @property
    def count(self) -> int:
        """Number of frames."""
        return len(self.rate)


def clock(motions: Sequence[Trajectory], timing: Timing) -> Clock:
    """Return the time of each motion in each frame.

    A motion that has ended keeps its last state. If all have ended without continuation by mechanics, the film pauses there.
    With step "angle" the first motion runs as with "time", and the others show the first time with the same rotation.
    """
    if not motions:
        raise InputError("motions = () must have at least one motion.", field="motions", value=())
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


def end_word(motion: Trajectory, t: float, last: bool) -> str:
    """Return the word in place of the mode after the end of a motion; empty before.

    t: shown time [s]; last: whether it is the first or the last picture, in which a motion with continuation has not ended.
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
    # film time is the integral of 1/rate, on a grid much finer than a frame and a bump of the rate
    step = min(0.1 * timing.speed / timing.frame_rate, width / 50.0)
    grid = np.linspace(first, end, max(2, math.ceil((end - first) / step) + 1))
    nearest = _distance(grid, marks) / width
    # 1 within half of the width, then a cosine down to 0, for a smooth change of speed
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
        Times, including all events [s].
    load, gravity_center : ndarray, shape (n, 2)
        World coordinates [m].
    airborne : ndarray of bool, shape (n,)
        Whether the hoop is airborne after each point.
    """

    t: Floats
    load: Floats
    gravity_center: Floats
    airborne: NDArray[np.bool_]

    def gravity_path(self, airborne: bool) -> Floats:
        """Return the path of the centre of gravity in flight or in contact, nan elsewhere."""
        shown = self.airborne == airborne
        shown[1:] |= shown[:-1].copy()
        return np.where(shown[:, None], self.gravity_center, np.nan)


def trace(motion: Trajectory, start: float = 0.0, end: float | None = None) -> Trace:
    """Return the paths of the load and of the centre of gravity.

    start, end: part of the motion [s].
    """
    end = motion.duration if end is None else min(end, motion.duration)
    count = int(min(MAX_TRACE_POINTS, max(32, TRACE_DENSITY * (end - start) / _second(motion))))
    marks = event_times(motion)
    marks = marks[(marks >= start) & (marks <= end)]
    t = np.unique(np.concatenate([np.linspace(start, end, count), marks]))
    poses = poses_of(motion, t)
    airborne = poses.mode == "H"
    if len(t) > 1:
        airborne[-1] = airborne[-2]  # nothing is after the last point
    return Trace(t, poses.load, poses.gravity_center, airborne)


@dataclass(frozen=True)
class EventMark:
    """A marked event: kind, time [s], and position along the plane and in the world [m]."""

    kind: str
    t: float
    along: float
    place: Floats


def event_marks(motion: Trajectory, times: Floats) -> list[EventMark]:
    """Return the events to mark in a film, in order of time; times: of the pictures [s]."""
    slope = motion.scenario.plane.slope
    return [
        EventMark(event.kind, event.t, event.x, to_world(event.x, 0.0, slope))
        for event in motion.events
        if EVENTS[event.kind].filmed and times[0] <= event.t <= times[-1]
    ]


@dataclass(frozen=True)
class Extent:
    """Range of a motion, for views and scales.

    Attributes
    ----------
    along : tuple of float
        Minimum and maximum position of the centre along the plane [m].
    height : float
        Maximum gap under the rim [m].
    speed : float
        Maximum speed of a point of the rim [m/s].
    force : float
        Maximum contact force without short peaks [N].
    """

    along: tuple[float, float]
    height: float
    speed: float
    force: float


def extent(motion: Trajectory, start: float = 0.0, end: float | None = None) -> Extent:
    """Return the range of a part of a motion.

    start, end: part of the motion [s].
    """
    radius = motion.scenario.hoop.radius
    end = motion.duration if end is None else min(end, motion.duration)
    count = int(min(20_000, max(200, 60 * (end - start) / _second(motion))))
    poses = poses_of(motion, np.linspace(start, end, count))
    around = np.linspace(0.0, 2.0 * math.pi, 24, endpoint=False)
    weight = motion.scenario.hoop.mass * motion.scenario.plane.gravity
    forces = np.hypot(*np.moveaxis(poses.normal_force, -1, 0))
    if motion.status == "jammed":  # in a jam the force is unbounded
        forces = forces[poses.t < motion.duration]
    # ignore the short peaks of impacts on a compliant contact
    usual = float(np.quantile(forces, 0.995)) if motion.scenario.contact.model != "rigid" else float(forces.max())
    return Extent(
        along=(float(np.min(poses.sample.x)), float(np.max(poses.sample.x))),
        height=float(np.max(poses.sample.height)),
        speed=float(rim_speeds(poses, around, radius).max()),
        force=max(usual, weight),
    )


@dataclass(frozen=True)
class Subject:
    """The motions of a film, with what it shows of each: times, label, range, traces and marked events.

    `whole` is the range of all of them, `end` the last time that is shown [s].
    """

    motions: tuple[Trajectory, ...]
    clock: Clock
    labels: tuple[str, ...]
    extents: tuple[Extent, ...]
    whole: Extent
    traces: tuple[Trace, ...]
    marks: tuple[list[EventMark], ...]
    end: float

    def tag(self, row: int) -> str:
        """Return the letter of a motion."""
        return TAGS[row % len(TAGS)]

    def past(self, row: int, k: int) -> list[EventMark]:
        """Return the events of a motion up to the k-th picture."""
        return [one for one in self.marks[row] if one.t <= self.clock.times[row][k]]


def subject_of(motions: Sequence[Trajectory], timing: Timing, labels: Sequence[str] | None) -> Subject:
    """Return what a film shows of some motions; labels: as given by the user."""
    shown = clock(motions, timing)
    pairs = list(zip(motions, shown.times, strict=True))
    ends = [min(float(times[-1]), motion.duration) for motion, times in pairs]
    extents = tuple(extent(motion, timing.start, end) for motion, end in zip(motions, ends, strict=True))
    whole = Extent(
        along=(min(size.along[0] for size in extents), max(size.along[1] for size in extents)),
        height=max(size.height for size in extents),
        speed=max(size.speed for size in extents) or 1.0,
        force=max(size.force for size in extents) or 1.0,
    )
    traces = tuple(trace(motion, timing.start, end) for motion, end in zip(motions, ends, strict=True))
    marks = tuple(event_marks(motion, times) for motion, times in pairs)
    return Subject(tuple(motions), shown, labels_of(motions, labels), extents, whole, traces, marks, max(ends))


def common_slope(motions: Sequence[Trajectory]) -> float:
    """Return the slope of all motions [rad]; refuse different ones."""
    slopes = sorted({motion.scenario.plane.slope for motion in motions})
    if len(slopes) > 1:
        raise InputError.of_field("plane.slope", slopes, "the same in all motions of one scene")
    return slopes[0]


def follow(times: Floats, places: Floats, seconds: float) -> Floats:
    """Return a smooth path of the camera after a jerky one.

    times: shape (n,), equally spaced times of the film [s]; places: shape (n,), positions to follow [m]; seconds: width of the
    smoothing, a standard deviation [s]; smooth shape (n,) [m].
    """
    if len(times) < 3:
        return places.copy()
    sigma = max(seconds / (times[1] - times[0]), 1e-9)
    reach = math.ceil(3.0 * sigma)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    # extended at both ends by reflection in the end point, so that there is no lag
    padded = np.pad(places, reach, mode="reflect", reflect_type="odd")
    return np.convolve(padded, kernel / kernel.sum(), mode="valid")
