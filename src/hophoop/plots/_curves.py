"""A motion as curves: dense samples with both sides of every event, and its phases."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from hophoop.results import Sample
from hophoop.scenario.scenario import time_unit
from hophoop.trajectory import Trajectory

# Samples a unit of time √(R/g); at the reference hoop some 470 a second.
DENSITY = 150
FEWEST, MOST = 600, 40_000


@dataclass(frozen=True)
class Phase:
    """A stretch of the motion in one mode: times [s] and angles [degrees] at its ends."""

    mode: str
    t: float
    end_t: float
    angle: float
    end_angle: float


def phases(motion: Trajectory) -> list[Phase]:
    """The motion's phases in order; an event that leaves the mode as it is does not part them."""
    found: list[Phase] = []
    events = motion.events
    for event, following in pairwise(events):
        if not following.t > event.t:
            continue
        angle, end_angle = math.degrees(event.angle), math.degrees(following.angle)
        if found and found[-1].mode == event.to_mode and following.kind != "start":
            last = found.pop()
            found.append(Phase(last.mode, last.t, following.t, last.angle, end_angle))
        else:
            found.append(Phase(event.to_mode, event.t, following.t, angle, end_angle))
    return found


def curve(motion: Trajectory, start: float = 0.0, end: float | None = None) -> Sample:
    """The motion sampled densely, each event's instant from the left and from the right."""
    end = motion.duration if end is None else min(end, motion.duration)
    unit = time_unit(motion.scenario.hoop, motion.scenario.plane)
    count = int(min(MOST, max(FEWEST, DENSITY * (end - start) / unit)))
    marks = np.unique([event.t for event in motion.events if start <= event.t <= end])
    grid = np.setdiff1d(np.linspace(start, end, count), marks)
    before = motion.at(marks[marks > start], side="left")
    after = motion.at(np.concatenate([grid, marks]))
    order = np.argsort(np.concatenate([before.t, after.t]), kind="stable")
    columns = {
        field.name: np.concatenate([getattr(before, field.name), getattr(after, field.name)])[order]
        for field in fields(Sample)
    }
    return Sample(**columns)


def turning(motion: Trajectory) -> bool:
    """Whether the hoop turns both ways, so that its angle does not order the motion."""
    turns = [event.omega for event in motion.events] + [event.before.omega for event in motion.events]
    rates = np.concatenate([motion.at(motion.times(200)).omega, turns])
    rates = rates[np.isfinite(rates)]
    size = float(np.max(np.abs(rates), initial=0.0))
    return bool((rates > 1e-9 * size).any() and (rates < -1e-9 * size).any())


def broken(values: NDArray[np.float64], sample: Sample, modes: str) -> NDArray[np.float64]:
    """The values where the mode is one of `modes`, nan elsewhere: a line that breaks.

    A phase's last point is taken from the left of the event that ends it, so that it belongs to the phase.
    """
    inside = np.isin(sample.mode, list(modes))
    return np.where(inside, values, np.nan)
