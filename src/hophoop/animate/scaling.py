"""Scale of the arrows of forces, which follows the forces so that small ones are visible."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from hophoop.animate.frames import Clock
from hophoop.results.poses import Floats
from hophoop.simulation.trajectory import Trajectory

AROUND = 0.6  # time before and after a picture that its scale takes into account [s of film]
LONGEST = 4.0  # maximum length over the full length, for unbounded forces in a jam
LEAST = 0.03  # of the maximum force: smaller ones have the scale of this one, so that they look small


def force_levels(motions: Sequence[Trajectory], clock: Clock, fps: float, most: float) -> Floats:
    """Return the force whose arrow has the full length, for each picture.

    It is the smoothed maximum force within `AROUND`, at least the present force up to `most`.

    motions: motions with one scale; clock: clock of the film; fps: pictures per second [1/s]; most: maximum force of the scale,
    without short peaks [N]; levels: shape (frames,), above 0 [N].
    """
    forces = np.zeros(clock.count)
    for motion, times in zip(motions, clock.times, strict=True):
        sample = motion.at(times)
        for each in (sample.normal_force, sample.friction_force):
            forces = np.maximum(forces, np.minimum(np.nan_to_num(np.abs(each), nan=0.0, posinf=most), most))
    reach = max(1, math.ceil(0.5 * AROUND * fps))
    padded = np.pad(forces, 2 * reach)
    window = np.lib.stride_tricks.sliding_window_view(padded, 2 * reach + 1)
    greatest = window.max(axis=1)  # from `reach` before the film to `reach` after it
    felt = np.flatnonzero(greatest > 0.0)
    if not felt.size:
        return np.full(clock.count, most)
    greatest = np.maximum(greatest, LEAST * most)
    # in long flights without force: interpolate the scale
    level = np.exp(np.interp(np.arange(greatest.size), felt, np.log(greatest[felt])))
    kernel = np.ones(2 * reach + 1) / (2 * reach + 1)
    return np.maximum(np.convolve(level, kernel, mode="valid"), forces)


def arrow(force: Floats, newton: float, full: float) -> Floats:
    """Return a force as an arrow, at most `LONGEST` times the full length.

    force shape (2,) [N]; newton: length of the arrow of 1 N, in any unit of length; full: full length, in the same unit; arrow:
    shape (2,), in the same unit.
    """
    way = force * newton
    return np.asarray(way * min(1.0, LONGEST * full / max(float(np.hypot(*way)), 1e-300)))
