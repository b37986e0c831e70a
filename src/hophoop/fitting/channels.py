"""Measured quantities of a track that a fit uses, with their uncertainties."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.scenario import InputError
from hophoop.tracking import Track
from hophoop.tracking.scatter import spread, third_differences

Floats = NDArray[np.float64]
Values = dict[str, float]  # by name

FEWEST = 12  # measured numbers
PLACE_ERROR = 0.01  # error that depends on the position in the picture: coding, background, sensor, lens [pixel]
GYROSCOPE = 0.005  # minimum error of an angular velocity whose error is unknown: the usual noise in a phone [rad/s]
LEAST_ROTATION = 1e-3  # error of a rotation from a gyroscope [rad]
ROUNDED = 0.75  # maximum distance of rounded times from an even grid, over their last decimal
PATCH = 40.0  # length over which that error changes [pixel]
GIVE = "give --sigma, --sigma-angle or --sigma-omega (sigma= and the like in fit)"


class Kind(NamedTuple):
    """Channels whose errors are given, or estimated, together."""

    words: str
    unit: str  # of a thousandth
    channels: tuple[str, ...]
    fields: tuple[str, ...]  # of a track


KINDS = {
    "places": Kind("Marks", "mm", ("x", "y", "marker_x", "marker_y"), ("centre_error", "marker_error")),
    "angles": Kind("Angles", "mrad", ("angle",), ("angle_error",)),
    "omegas": Kind("Angular velocities", "mrad/s", ("omega",), ("omega_error",)),
}


class Channel(NamedTuple):
    """One measured quantity."""

    name: str  # x, y, angle, marker_x, marker_y or omega
    rows: NDArray[np.int64]  # of the track
    values: Floats
    errors: Floats
    known: bool = True  # whether the data have errors; otherwise they are estimated from the scatter
    frames: float = 1.0  # with the information of one of independent errors, as far as known in advance


def with_errors(track: Track, given: Mapping[str, float | None], own: bool = False) -> Track:
    """Return the track with standard deviations in place of its own, or, if it keeps its own, where it has none.

    given: by key of KINDS, None for those of the track [m, rad or rad/s].
    """
    errors: dict[str, Any] = {}
    for kind, error in given.items():
        for name in KINDS[kind].fields if error is not None else ():
            now = getattr(track, name)
            errors[name] = np.where((now > 0) & own, now, error)
    return replace(track, **errors)


def channels_of(track: Track) -> tuple[Channel, ...]:
    """Centre and angle, the marker if there is no centre, and the angular velocity."""
    centred, marked = (np.isfinite(places[:, 0]).any() for places in (track.centre, track.marker))
    angle_error = track.angle_error
    if np.isnan(angle_error).all():  # that of the line from the centre to the marker
        ends = np.hypot(track.marker_error, track.centre_error.mean(axis=1))
        angle_error = ends / np.hypot(*(track.marker - track.centre).T)
    measured = {
        "x": (track.centre[:, 0], track.centre_error[:, 0]),
        "y": (track.centre[:, 1], track.centre_error[:, 1]),
        "marker_x": (track.marker[:, 0], track.marker_error),
        "marker_y": (track.marker[:, 1], track.marker_error),
        "angle": (track.angle, angle_error),
        "omega": (track.omega, track.omega_error),
    }
    unused = ("marker_x", "marker_y") if centred else ("angle",) if marked else ()
    result = []
    for name, (values, errors) in measured.items():
        rows = np.flatnonzero(np.isfinite(values))
        if name in unused or not len(rows):
            continue
        own = errors[rows]
        known = np.isfinite(own) & (own > 0)
        if not known.all():
            own = np.where(known, own, scatter([(track.t[rows], values[rows])], name))
        frames = _frames_in_place(track, name, float(np.median(own)))
        result.append(Channel(name, rows, values[rows], own, bool(known.all()), frames))
    if sum(len(channel.rows) for channel in result) < FEWEST:
        raise InputError("The track has the hoop in too few frames to fit anything.")
    return tuple(result)


def _frames_in_place(track: Track, name: str, error: float) -> float:
    """Return the frames with the information of one, by the share of errors that depend on the place in the picture [1]."""
    view = track.view
    steps = np.hypot(*np.diff(track.pixel, axis=0).T)
    if view is None or name == "omega" or not np.isfinite(steps).any():
        return 1.0
    size = PLACE_ERROR / view.scale
    if name == "angle":
        size /= track.radius * (view.marker_ratio if np.isfinite(view.marker_ratio) else 1.0)
    return 1.0 + 2.0 * min((size / error) ** 2, 1.0) * PATCH / max(float(np.nanmean(steps)), 1.0)


def rotation(omega: Channel, t: Floats) -> Channel:
    """Return the rotation since the first value instead of an angular velocity: at an impact it does not jump.

    Between two values its error is up to that of the greatest jump.

    t: of the rows [s].
    """
    times = t[omega.rows]
    jump = float(np.abs(np.diff(omega.values)).max() * np.median(np.diff(times)))
    turned = rotation_of(times, omega.values)
    return Channel("angle", omega.rows, turned, np.full(len(turned), max(0.25 * jump, LEAST_ROTATION)))


def rotation_of(t: Floats, omega: Floats) -> Floats:
    """Return the rotation since the first of angular velocities, shape (n,) [rad]."""
    return np.asarray(need("scipy.integrate", "fit").cumulative_trapezoid(omega, t, initial=0.0))


def evened(track: Track) -> tuple[Track, Values]:
    """Return the track with the times of the even grid that its times round to, and its rate [Hz]; nothing without rounding."""
    frames = np.cumsum(np.round(np.diff(track.t, prepend=track.t[0]) / np.median(np.diff(track.t))))
    step, begin = np.polyfit(frames, track.t, 1)
    even = begin + step * frames
    if not 1e-3 * step < np.abs(track.t - even).max() < ROUNDED * _rounding(track.t):
        return track, {}
    return replace(track, t=even), {"rate": float(1.0 / step)}


def with_scatter(track: Track, off: Mapping[str, Floats]) -> tuple[Track, Values]:
    """Return the track with its scatter as errors where it has none, and the scatter of each kind.

    It is that of the deviations from a motion, also from a wrong one, in which the rest of the motion is smooth. In the data
    third differences take the motion for scatter below about 240 frames per second.

    off: data minus motion, by name of the channel [m, rad or rad/s]; scatter: by key of KINDS [m, rad or rad/s].
    """
    found: Values = {}
    for name, kind in KINDS.items():
        # with the errors of its ends, the line from the centre to the marker has one, too
        group = [one for one in channels_of(track) if one.name in kind.channels and not one.known]
        if group:
            usual = scatter([(track.t[one.rows], one.values) for one in group], group[0].name)
            rest = _roughness([(track.t[one.rows], off[one.name]) for one in group])
            found[name] = float(min(usual, max(rest, *(_least_error(one.values, one.name) for one in group))))
            track = with_errors(track, {name: found[name]}, own=True)
    return track, found


Pieces = Sequence[tuple[Floats, Floats]]


def scatter(pieces: Pieces, name: str) -> float:
    """Standard deviation of one value, from third differences, which are small for a smooth motion.

    It is at least that of rounding to the digits of the data.

    pieces: times [s] and measured values, each of shape (n,); name: of their channel; sigma: in the values' own unit [1].
    """
    count = min(len(t) for t, _ in pieces)
    if count < 8:
        raise InputError(f"The uncertainty of the data is missing, and {count} frames are too few to estimate it: {GIVE}.")
    usual = max(_roughness(pieces), *(_least_error(values, name) for _, values in pieces))
    if not usual > 1e-12 * max(1.0, *(np.abs(values).max() for _, values in pieces)):
        raise InputError(f"The uncertainty of the data is missing, and they do not scatter: {GIVE}.")
    return usual


def _roughness(pieces: Pieces) -> float:
    """Standard deviation of one value, from the third differences of all pieces."""
    return spread(np.concatenate([third_differences(t, values) for t, values in pieces]))


def _least_error(values: Floats, name: str) -> float:
    """Standard deviation of rounding to the digits of the data; for an angular velocity at least the usual noise."""
    return max(float(_rounding(values) / np.sqrt(12.0)), GYROSCOPE if name == "omega" else 0.0)


def _rounding(values: Floats) -> float:
    """Unit of the last decimal of numbers; 0 if they are not rounded, or all the same."""
    rounded = (10.0**-k for k in range(10) if np.allclose(values, np.round(values, k), rtol=0.0, atol=1e-12))
    return next(rounded, 0.0) if np.ptp(values) else 0.0
