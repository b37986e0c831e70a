"""Scores: differences between the measures of a record and those of the truth."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from measures import Measures, energy, interpolate, measure
from record import Record, check_start, thin
from truth import Truth


@dataclass(frozen=True)
class Scores:
    """Errors of a record, record minus truth. None if the truth has no such quantity; nan if the record lacks it."""

    sequence_right: bool  # the phases of at least 20 ms are those of the truth, in order
    takeoff_angle: float | None  # degrees
    takeoff_time: float | None  # s
    hop_height: float | None  # m
    landing_angle: float | None  # degrees
    landing_time: float | None  # s
    energy_drift: float  # J: maximum change of the energy while that of the truth is conserved
    slip_loss: float | None  # J, up to the first take-off or landing
    impact_loss: float | None  # J, in the first landing
    total_loss: float  # J, from the start to the end
    penetration: float  # m: maximum depth of the rim in the plane
    chatter: int  # phases below 20 ms, minus those of the truth
    angle_error: float  # degrees: maximum error of θ over the motion
    place_error: float  # m: maximum error of the centre's position
    steps: int | None
    wall_seconds: float | None

    def to_dict(self) -> dict[str, Any]:
        """Return the scores for JSON, nan as 'missing'."""
        return {
            name: "missing" if isinstance(value, float) and math.isnan(value) else value for name, value in asdict(self).items()
        }


def score(record: Record, truth: Truth) -> tuple[Scores, Measures]:
    """Score a record against the truth of its motion; return its own measures, too.

    A record that is invalid, too short, or starts in another state than the motion is a ValueError.
    """
    task, right, grid = truth.task, truth.measures, truth.states
    states = thin(record.states)
    t = states.t
    check_start(task, grid, states)
    step = float(np.median(np.diff(t)))
    if t[-1] < task.duration - 2.0 * step - 1e-9:
        raise ValueError(f"the record ends at {t[-1]:.6g} s; the motion {task.name!r} lasts {task.duration:.6g} s.")
    found = measure(task, states)
    angles, xs, ys = (
        np.array([interpolate(t, value, rate, when) for when in grid.t])
        for value, rate in ((states.angle, states.omega), (states.x, states.vx), (states.y, states.vy))
    )
    total = energy(task, states)
    early = t <= max(truth.lossless_until - step, step)

    def error(name: str, scale: float = 1.0) -> float | None:
        mine, exact = getattr(found, name), getattr(right, name)
        return None if exact is None else math.nan if mine is None else scale * (mine - exact)

    scores = Scores(
        sequence_right=found.sequence == right.sequence,
        takeoff_angle=error("takeoff_angle", math.degrees(1.0)),
        takeoff_time=error("takeoff_time"),
        hop_height=error("hop_height"),
        landing_angle=error("landing_angle", math.degrees(1.0)),
        landing_time=error("landing_time"),
        energy_drift=float(np.abs(total[early] - total[0]).max()),
        slip_loss=error("slip_loss"),
        impact_loss=error("impact_loss"),
        total_loss=found.total_loss - right.total_loss,
        penetration=found.penetration,
        chatter=max(0, found.chatter - right.chatter),
        angle_error=math.degrees(float(np.abs(angles - grid.angle).max())),
        place_error=float(np.hypot(xs - grid.x, ys - grid.y).max()),
        steps=record.steps,
        wall_seconds=record.wall_seconds,
    )
    return scores, found
