"""The maximum friction utilization of a motion."""

from __future__ import annotations

import math

import numpy as np

from hophoop.derivatives.pieces.required_friction import fill_peaks
from hophoop.kernel.model import ROLL, SKID, SLIP_START, SPIN, TAKEOFF, required_ratio
from hophoop.kernel.native import noinline
from hophoop.kernel.numerics.circular import sine_cosine
from hophoop.kernel.steps import HOLD

PIECES, PEAKS = 32, 128  # pieces of a rolling phase that are searched together, and the most maxima of abs(F)/N on them


@noinline
def need_at(body, row, om, direction):
    """Return abs(F)/N of rolling at the angle of an event or at the start of a segment."""
    s, c = sine_cosine(row["theta"], row["theta_low"])
    return abs(required_ratio(body, s, c, om * om, direction * body.resist))


@noinline
def greatest_need(body, segments, first, last, after, scratch):
    """Return the maximum abs(F)/N of rolling or rest up to the event `after`: segments `first` to before `last`."""
    if segments[first]["kind"] == HOLD:
        return abs(body.gt) / body.gn if body.gn > 0.0 else 0.0
    peaks = np.empty((PEAKS, 2))
    greatest = need_at(body, after, after["before_omega"], segments[last - 1]["direction"])
    for index in range(first, last, PIECES):
        row = segments[index]
        greatest = max(greatest, need_at(body, row, row["omega"], row["direction"]))
        for k in range(fill_peaks(body, segments, index, min(index + PIECES, last), scratch, peaks)):
            greatest = max(greatest, peaks[k, 0])
    return greatest


def greatest_utilization(motion, scratch):
    """Return the maximum friction utilization in contact; nan without contact."""
    body, events, segments = motion.body, motion.events, motion.segments
    bounded = 0.0 < body.mu_s < math.inf
    for i in range(motion.length):
        row = events[i]
        if row["kind"] == SLIP_START or (row["kind"] == TAKEOFF and row["before_mode"] == ROLL):
            return 1.0 if bounded else 0.0  # rolling reaches the friction cone at its end
    used = math.nan
    last = 0
    for i in range(motion.length - 1):
        row, after = events[i], events[i + 1]
        mode = row["after_mode"]
        first = last
        while last < motion.pieces and segments[last]["t"] < after["t"]:
            last += 1
        if not after["t"] > row["t"]:
            continue
        if mode in (SPIN, SKID) and body.mu_k > 0.0:
            return 1.0
        if mode == ROLL:
            used = 0.0 if math.isnan(used) else used
            if bounded:
                used = max(used, greatest_need(body, segments, first, last, after, scratch) / body.mu_s)
    return 1.0 if used > 1.0 else used
