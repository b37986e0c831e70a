"""How far a gait is from a change of its sequence: which boundary a change of parameters meets first."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from hophoop.results.records import EventRecord
    from hophoop.simulation.trajectory import Trajectory

POINTS = 400  # of each phase


class GaitMargin(NamedTuple):
    """Distance of a gait from a boundary of its sequence.

    Attributes
    ----------
    boundary : str
        What would change: 'slip starts', 'take-off', 'hop vanishes', 'phase vanishes', 'impact: slip just stops' or
        'turns back'.
    t : float
        Where in the period [s].
    value : float
        The share of friction that is left, N over the weight, the hop's height over R, the duration over √(R/g), slip or θ̇ over
        √(gR) or √(g/R), or the share of the impulse's friction that is left: 0 at the boundary [1].
    """

    boundary: str
    t: float
    value: float


def margins_of(motion: Trajectory, section: str) -> tuple[GaitMargin, ...]:
    """Return the margins of one period, the smallest first, to the distance of 400 samples; `Gait.margins` calls this."""
    hoop, plane = motion.scenario.hoop, motion.scenario.plane
    weight = hoop.mass * plane.gravity * math.cos(plane.slope)
    speed = math.sqrt(plane.gravity * hoop.radius)
    found = [_of_turning(motion, speed / hoop.radius)]
    changes = [event for event in motion.events if event.from_mode != event.to_mode or event.kind in ("start", "impact", "end")]
    for one, other in pairwise(changes):
        if other.t <= one.t:
            continue
        if one.to_mode != "H" and other.kind != "end" and (one.kind != "start" or section == "landing"):
            found.append(GaitMargin("phase vanishes", one.t, (other.t - one.t) * speed / hoop.radius))
        sample = motion.at(np.linspace(one.t, other.t, POINTS + 2)[1:-1])
        mode = one.to_mode
        if mode == "H":
            top = int(np.argmax(sample.height))
            found.append(GaitMargin("hop vanishes", float(sample.t[top]), float(sample.height[top]) / hoop.radius))
        elif mode == "R" and other.kind != "slip_start":
            used = np.abs(sample.friction_force) / (plane.mu_static * sample.normal_force)
            worst = int(np.argmax(used))
            found.append(GaitMargin("slip starts", float(sample.t[worst]), 1.0 - float(used[worst])))
        elif mode in "SK" and other.kind != "takeoff":
            least = int(np.argmin(sample.normal_force))
            found.append(GaitMargin("take-off", float(sample.t[least]), float(sample.normal_force[least]) / weight))
    found += [_of_impact(event, plane.mu_kinetic, speed) for event in motion.find("impact") if event.impulse_normal > 0.0]
    return tuple(sorted(found, key=lambda margin: margin.value))


def _of_turning(motion: Trajectory, unit: float) -> GaitMargin:
    sample = motion.at(np.linspace(0.0, motion.duration, POINTS))
    slowest = int(np.argmin(np.abs(sample.omega)))
    return GaitMargin("turns back", float(sample.t[slowest]), abs(float(sample.omega[slowest])) / unit)


def _of_impact(event: EventRecord[float], mu: float, speed: float) -> GaitMargin:
    """Slip that goes on after a landing, or the share of friction that is left where it stops."""
    if event.slip != 0.0:
        return GaitMargin("impact: slip just stops", event.t, abs(event.slip) / speed)
    left = 1.0 - abs(event.impulse_tangential) / (mu * event.impulse_normal)
    return GaitMargin("impact: slip just stops", event.t, left)
