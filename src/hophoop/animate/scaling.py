"""How long the arrows of forces are: a scale that follows the forces, so that small ones show as well."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from hophoop.animate.frames import Clock
from hophoop.results.poses import Floats
from hophoop.simulation.trajectory import Trajectory

AROUND = 0.6  # how far before and after a picture the scale looks [s of film]
LONGEST = 4.0  # arrows of full length: what grows without bound, as in a jam, leaves the picture and goes no further
LEAST = 0.03  # of the greatest force: smaller ones keep the scale of that, so that none of them looks like a great one


def force_levels(motions: Sequence[Trajectory], clock: Clock, fps: float, most: float) -> Floats:
    """The force whose arrow has the full length, at every picture.

    It is the greatest force within `AROUND`, smoothed, never less than a force that is there and does not exceed `most`.

    Parameters
    ----------
    motions : sequence of Trajectory
        They share one scale.
    clock : Clock
        Of the film.
    fps : float
        Pictures a second [1/s].
    most : float
        Force from which on the scale stays: short peaks are not what it is for [N].

    Returns
    -------
    levels : ndarray, shape (frames,)
        Above 0 [N].
    """
    forces = np.zeros(clock.count)
    for motion, times in zip(motions, clock.times, strict=True):
        sample = motion.at(times)
        for each in (sample.normal_force, sample.friction_force):
            forces = np.maximum(forces, np.minimum(np.nan_to_num(np.abs(each), nan=0.0, posinf=most), most))
    reach = max(1, math.ceil(0.5 * AROUND * fps))
    padded = np.pad(forces, 2 * reach)
    window = np.lib.stride_tricks.sliding_window_view(padded, 2 * reach + 1)
    greatest = window.max(axis=1)  # from `reach` before the film on, to `reach` after it
    felt = np.flatnonzero(greatest > 0.0)
    if not felt.size:
        return np.full(clock.count, most)
    greatest = np.maximum(greatest, LEAST * most)
    # in long flights nothing acts: the scale goes over from what was before to what follows
    level = np.exp(np.interp(np.arange(greatest.size), felt, np.log(greatest[felt])))
    kernel = np.ones(2 * reach + 1) / (2 * reach + 1)
    return np.maximum(np.convolve(level, kernel, mode="valid"), forces)


def arrow(force: Floats, newton: float, full: float) -> Floats:
    """A force as an arrow, at most `LONGEST` times as long as one of full length.

    Parameters
    ----------
    force : ndarray, shape (2,)
        [N].
    newton : float
        Length of a newton's arrow, in any unit of length.
    full : float
        Full length, in the same unit.

    Returns
    -------
    arrow : ndarray, shape (2,)
        From its tail, in the same unit.
    """
    way = force * newton
    return np.asarray(way * min(1.0, LONGEST * full / max(float(np.hypot(*way)), 1e-300)))
