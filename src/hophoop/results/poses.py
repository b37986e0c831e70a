"""Positions of the hoop's points in world coordinates: X level, Y up, slopes drawn as slopes."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop.kernel.numerics.elementwise import hypotenuse, sine_and_cosine
from hophoop.results.records import ArraySample, Motion
from hophoop.scenario import Hoop, PointMass
from hophoop.scenario.scenario import time_unit
from hophoop.vocabulary.names import coming_rotation, mode_words

Floats = NDArray[np.float64]
GRID = 200_000  # maximum number of times at which a motion is sampled for a search


@dataclass(frozen=True)
class Poses:
    """A motion at n times, as points and vectors in world coordinates.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Time [s].
    mode, words : ndarray of str, shape (n,)
        Letter of the mode, and its word [no number].
    angle, omega : ndarray, shape (n,)
        θ [rad] and θ̇ [rad/s].
    center, load, gravity_center, contact : ndarray, shape (n, 2)
        Centre of the rim, load, centre of gravity, and the rim's point nearest to the plane [m].
    velocity : ndarray, shape (n, 2)
        Velocity of the centre, along the plane and away from it [m/s].
    normal_force, friction_force : ndarray, shape (n, 2)
        Forces on the hoop [N].
    sample : Sample
        All other quantities at these times.
    """

    t: Floats
    mode: NDArray[np.str_]
    words: NDArray[np.str_]
    angle: Floats
    omega: Floats
    center: Floats
    load: Floats
    gravity_center: Floats
    contact: Floats
    velocity: Floats
    normal_force: Floats
    friction_force: Floats
    sample: ArraySample


def to_world(along: ArrayLike, above: ArrayLike, slope: float) -> Floats:
    """Convert points or vectors from plane coordinates to world coordinates.

    Parameters
    ----------
    along, above : float or array_like
        Distance along the plane and away from it, in any unit [1].
    slope : float
        β, downhill along +x [rad].

    Returns
    -------
    points : ndarray, shape (..., 2)
        X level and Y up, in the same unit [1].
    """
    a, b = np.asarray(along, dtype=float), np.asarray(above, dtype=float)
    sine, cosine = sine_and_cosine(slope)
    return np.stack(np.broadcast_arrays(a * cosine + b * sine, b * cosine - a * sine), axis=-1)


def load_distance(hoop: Hoop) -> float:
    """Return the distance from the rim's centre to the part that is drawn as the load.

    Parameters
    ----------
    hoop : Hoop

    Returns
    -------
    distance : float
        Distance of the heaviest off-centre part on the side of the centre of gravity; the rim's radius for a hoop without such
        a part [m].
    """
    if hoop.parts is None:
        return hoop.radius
    side = part_side(hoop)
    off = [part for part in hoop.parts if part.mass > 0.0 and part.at * side > 0.0]
    # a point mass first, however light: it is usually called the load
    points = [part for part in off if isinstance(part, PointMass)] or off
    if not points:
        return hoop.radius
    return abs(max(points, key=lambda part: part.mass).at)


def part_side(hoop: Hoop) -> float:
    """Return the sign of a part's signed distance on the line from C to G.

    Parameters
    ----------
    hoop : Hoop

    Returns
    -------
    side : float
        1, or −1 if the centre of gravity is on the negative side of the parts' own line [1].
    """
    moment = math.fsum(part.mass * part.at for part in hoop.parts or ())
    return -1.0 if moment < 0.0 else 1.0


def poses_of(motion: Motion, times: ArrayLike) -> Poses:
    """Return the points of a motion at many times, in world coordinates.

    Parameters
    ----------
    motion : Trajectory
    times : array_like, shape (n,)
        From 0 to the motion's end [s].

    Returns
    -------
    poses : Poses

    Raises
    ------
    ValueError
        If a time is outside the motion.
    """
    sample = motion.at(np.atleast_1d(np.asarray(times, dtype=float)))
    hoop, slope = motion.scenario.hoop, motion.scenario.plane.slope
    radius, arm = hoop.radius, hoop.radius * hoop.eccentricity
    reach = load_distance(hoop)
    sine, cosine = sine_and_cosine(sample.angle)
    level = radius + sample.height
    nothing = np.zeros_like(level)

    def place(along: Any, above: Any) -> Floats:
        return to_world(along, above, slope)

    return Poses(
        t=sample.t,
        mode=sample.mode,
        words=mode_words(sample.mode, coming_rotation(sample.omega)),
        angle=sample.angle,
        omega=sample.omega,
        center=place(sample.x, level),
        load=place(sample.x + reach * sine, level + reach * cosine),
        gravity_center=place(sample.x + arm * sine, level + arm * cosine),
        contact=place(sample.x, sample.height),
        velocity=np.stack([sample.vx, sample.vy], axis=-1),
        normal_force=place(nothing, _finite(sample.normal_force)),
        friction_force=place(_finite(sample.friction_force), nothing),
        sample=sample,
    )


def rim_speeds(poses: Poses, angles: ArrayLike, radius: float) -> Floats:
    """Return the speed of points on the rim.

    Parameters
    ----------
    poses : Poses
    angles : array_like, shape (k,)
        Positions on the rim, from the plane's outward normal, clockwise, fixed in space and not on the hoop [rad].
    radius : float
        Rim radius [m].

    Returns
    -------
    speeds : ndarray, shape (n, k)
        Speed of the hoop's point at that position [m/s].
    """
    phi = np.asarray(angles, dtype=float)[None, :]
    turning = radius * _finite(poses.omega)[:, None]
    sine, cosine = sine_and_cosine(phi)
    along = poses.velocity[:, :1] + turning * cosine
    away = poses.velocity[:, 1:] - turning * sine
    return np.asarray(hypotenuse(along, away))


def event_times(motion: Motion) -> Floats:
    """Return the times of all events of a motion, without repetitions.

    Parameters
    ----------
    motion : Trajectory

    Returns
    -------
    t : ndarray
        In order [s].
    """
    return np.unique(np.clip([event.t for event in motion.events], 0.0, motion.duration))


def turned_at(motion: Motion, times: ArrayLike) -> Floats:
    """Return the maximum rotation of a motion up to each of some times.

    Parameters
    ----------
    motion : Trajectory
    times : array_like, shape (n,)
        [s].

    Returns
    -------
    turned : ndarray, shape (n,)
        Maximum angle from the start's so far [rad].
    """
    wanted = np.asarray(times, dtype=float)
    grid = np.unique(np.concatenate([_grid(motion), wanted]))
    turned = np.maximum.accumulate(np.abs(motion.at(grid).angle - motion.at(0.0).angle))
    return np.asarray(turned[np.searchsorted(grid, wanted)])


def times_at_turn(motion: Motion, turned: ArrayLike) -> Floats:
    """Return the first times at which a motion has rotated by given angles; its end if it never does.

    Parameters
    ----------
    motion : Trajectory
    turned : array_like, shape (n,)
        Angles from the start's, at least 0 [rad].

    Returns
    -------
    t : ndarray, shape (n,)
        [s].
    """
    wanted = np.asarray(turned, dtype=float)
    track = _grid(motion)
    begin = motion.at(0.0).angle
    reached = np.maximum.accumulate(np.abs(motion.at(track).angle - begin))
    after = np.clip(np.searchsorted(reached, wanted), 1, len(track) - 1)
    low, high = track[after - 1].copy(), track[after].copy()
    for _ in range(45):
        middle = 0.5 * (low + high)
        short = np.abs(motion.at(middle).angle - begin) < wanted
        low, high = np.where(short, middle, low), np.where(short, high, middle)
    found = np.where(wanted > reached[-1], motion.duration, high)
    return np.where(wanted <= 0.0, 0.0, found)


def _grid(motion: Motion) -> Floats:
    second = time_unit(motion.scenario.hoop, motion.scenario.plane)
    return motion.times(int(min(GRID, max(64, 60 * motion.duration / second))))


def _finite(values: Any) -> Floats:
    # θ̇ of a massless ring is infinite when its load strikes the plane
    return np.asarray(np.nan_to_num(np.asarray(values, dtype=float), nan=0.0, posinf=0.0, neginf=0.0))
