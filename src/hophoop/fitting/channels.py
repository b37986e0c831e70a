"""Measured quantities of a track that a fit uses, with their uncertainties."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.scenario import InputError
from hophoop.tracking import Track
from hophoop.tracking.scatter import spread, third_differences

Floats = NDArray[np.float64]

FEWEST = 12  # measured numbers
LONGEST = 0.98  # maximum correlation of errors from one frame to the next
PLACE_ERROR = 0.01  # error that depends on the position in the picture: coding, background, sensor, lens [pixel]
GYROSCOPE = 0.005  # minimum error of an angular velocity whose error is unknown: the usual noise in a phone [rad/s]
PATCH = 40.0  # length over which that error changes [pixel]


class Autocorrelation(NamedTuple):
    """Autocorrelation of errors: share × fade^n between frames n apart."""

    share: float
    fade: float

    @property
    def frames(self) -> float:
        """Number of frames with the information of one frame of independent errors [1]."""
        return 1.0 + 2.0 * self.share * self.fade / (1.0 - self.fade)


NONE = Autocorrelation(0.0, 0.0)


class Sigma(NamedTuple):
    """Given standard deviations; None where the data have their own."""

    places: float | None = None  # of each coordinate [m]
    angles: float | None = None  # [rad]
    omegas: float | None = None  # of angular velocities [rad/s]


class Channel(NamedTuple):
    """One measured quantity."""

    name: str  # x, y, angle, marker_x, marker_y or omega
    rows: NDArray[np.int64]  # of the track
    values: Floats
    errors: Floats
    autocorrelation: Autocorrelation = NONE  # known of its errors in advance


def channels_of(track: Track, sigma: Sigma) -> tuple[Channel, ...]:
    """Centre and angle, the marker if there is no centre, and the angular velocity.

    sigma: standard deviations in place of the track's own.
    """
    centred, marked = (np.isfinite(places[:, 0]).any() for places in (track.centre, track.marker))
    pairs: list[tuple[str, Floats, Floats, float | None]] = []
    if centred:
        pairs += [(name, track.centre[:, k], track.centre_error[:, k], sigma.places) for k, name in enumerate(("x", "y"))]
    elif marked:
        pairs += [(f"marker_{name}", track.marker[:, k], track.marker_error, sigma.places) for k, name in enumerate(("x", "y"))]
    if centred or not marked:
        error = track.angle_error
        if np.isnan(error).all():  # that of the line from the centre to the marker
            ends = track.marker_error, track.centre_error.mean(axis=1)
            reach = np.hypot(*(track.marker - track.centre).T)
            error = np.hypot(*(ends if sigma.places is None else (sigma.places, sigma.places))) / reach
        pairs.append(("angle", track.angle, error, sigma.angles))
    pairs.append(("omega", track.omega, track.omega_error, sigma.omegas))
    result = []
    for name, values, errors, given in pairs:
        rows = np.flatnonzero(np.isfinite(values))
        if not len(rows):
            continue
        own = errors[rows] if given is None else np.full(len(rows), given)
        known = np.isfinite(own) & (own > 0)
        if not known.all():
            own = np.where(known, own, scatter(track.t[rows], values[rows], GYROSCOPE if name == "omega" else 0.0))
        result.append(Channel(name, rows, values[rows], own, _by_place(track, name, float(np.median(own)))))
    if sum(len(channel.rows) for channel in result) < FEWEST:
        raise InputError("The track has the hoop in too few frames to fit anything.")
    return tuple(result)


def _by_place(track: Track, name: str, error: float) -> Autocorrelation:
    """Autocorrelation of the errors that depend on the position in the picture."""
    view = track.view
    steps = np.hypot(*np.diff(track.pixel, axis=0).T)
    if view is None or name == "omega" or not np.isfinite(steps).any():
        return NONE
    size = PLACE_ERROR / view.scale
    if name == "angle":
        size /= track.radius * (view.marker_ratio if np.isfinite(view.marker_ratio) else 1.0)
    return Autocorrelation(min((size / error) ** 2, 1.0), min(float(np.exp(-np.nanmean(steps) / PATCH)), LONGEST))


def scatter(t: Floats, values: Floats, least: float = 0.0) -> float:
    """Standard deviation of one value, from third differences, which are small for a smooth motion.

    It is at least that of rounding to the digits of the data.

    t, values: shape (n,), times [s] and measured values [1]; least: minimum; sigma: in the values' own unit [1].
    """
    if len(t) < 8:
        raise InputError(f"The uncertainty of the data is missing, and {len(t)} frames are too few to estimate it: give sigma.")
    rounding = np.diff(np.unique(np.round(values, 12))).min(initial=np.inf) / np.sqrt(12.0)
    usual = max(spread(third_differences(t, values)), rounding if np.isfinite(rounding) else 0.0, least)
    if not usual > 1e-12 * max(1.0, float(np.abs(values).max())):
        raise InputError("The uncertainty of the data is missing, and they do not scatter: give sigma.")
    return usual
