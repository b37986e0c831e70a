"""Scores: differences between the measures of a record and those of the truth."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from hophoop.engines.conventions import check_start
from hophoop.engines.measures import Measures, energy, interpolate, measure
from hophoop.engines.phases import thin
from hophoop.engines.recording import Recording
from hophoop.engines.truth import Truth
from hophoop.scenario import InputError


@dataclass(frozen=True)
class Scores:
    """Errors of a record. None if the truth has no such quantity; nan if the record lacks it.

    Attributes
    ----------
    sequence_right : bool
        Whether the phases of at least 20 ms are those of the truth, in order.
    takeoff_angle, takeoff_time : float or None
        Error at the take-off [deg], [s].
    hop_height : float or None
        Error of the height of the hop [m].
    landing_angle, landing_time : float or None
        Error at the first landing [deg], [s].
    energy_drift : float
        Maximum change of the energy while that of the truth is conserved [J].
    slip_loss, impact_loss : float or None
        Error of the energy lost in slip up to the first take-off or landing, and in the first landing [J].
    total_loss : float
        Error of the energy lost from the start to the end [J].
    penetration : float
        Maximum depth of the rim in the plane [m].
    chatter : int
        Phases below 20 ms, minus those of the truth.
    angle_error, place_error : float
        Maximum error of θ [deg] and of the centre's position [m] over the motion.
    steps : int or None
        Number of steps.
    wall_seconds : float or None
        Wall time [s].
    """

    sequence_right: bool
    takeoff_angle: float | None
    takeoff_time: float | None
    hop_height: float | None
    landing_angle: float | None
    landing_time: float | None
    energy_drift: float
    slip_loss: float | None
    impact_loss: float | None
    total_loss: float
    penetration: float
    chatter: int
    angle_error: float
    place_error: float
    steps: int | None
    wall_seconds: float | None

    def to_dict(self) -> dict[str, Any]:
        """Convert to a dictionary for JSON, nan as 'missing'.

        Returns
        -------
        scores : dict
        """
        return {name: "missing" if _is_nan(value) else value for name, value in asdict(self).items()}


COLUMNS = tuple(Scores.__dataclass_fields__)


def _is_nan(value: Any) -> bool:
    return isinstance(value, float) and math.isnan(value)


def score(recording: Recording, truth: Truth) -> tuple[Scores, Measures]:
    """Score a record against the truth of its scenario.

    Parameters
    ----------
    recording : Recording
    truth : Truth

    Returns
    -------
    scores : Scores
    measures : Measures
        Of the record itself.

    Raises
    ------
    ValueError
        If the record is invalid or too short, or starts in another state than the motion.
    """
    task, right = truth.task, truth.measures
    states = thin(recording.states)
    t = states.t
    check_start(task, truth.states, states)
    step = float(np.median(np.diff(t)))
    if t[-1] < task.duration - 2.0 * step - 1e-9:
        raise InputError(f"the record ends at {t[-1]:.6g} s; the motion {task.name!r} lasts {task.duration:.6g} s.")
    found = measure(task, states)
    grid = truth.states
    angles = np.array([interpolate(t, states.angle, states.omega, when) for when in grid.t])
    places = np.array([interpolate(t, states.x, states.vx, when) for when in grid.t])
    heights = np.array([interpolate(t, states.y, states.vy, when) for when in grid.t])
    total = energy(task, states)
    early = t <= max(truth.lossless_until - step, step)
    return (
        Scores(
            sequence_right=found.sequence == right.sequence,
            takeoff_angle=_degrees(_off(found.takeoff_angle, right.takeoff_angle)),
            takeoff_time=_off(found.takeoff_time, right.takeoff_time),
            hop_height=_off(found.hop_height, right.hop_height),
            landing_angle=_degrees(_off(found.landing_angle, right.landing_angle)),
            landing_time=_off(found.landing_time, right.landing_time),
            energy_drift=float(np.abs(total[early] - total[0]).max()),
            slip_loss=_off(found.slip_loss, right.slip_loss),
            impact_loss=_off(found.impact_loss, right.impact_loss),
            total_loss=found.total_loss - right.total_loss,
            penetration=found.penetration,
            chatter=max(0, found.chatter - right.chatter),
            angle_error=math.degrees(float(np.abs(angles - grid.angle).max())),
            place_error=float(np.hypot(places - grid.x, heights - grid.y).max()),
            steps=recording.steps,
            wall_seconds=recording.wall_seconds,
        ),
        found,
    )


def _off(found: float | None, right: float | None) -> float | None:
    if right is None:
        return None
    return math.nan if found is None else found - right


def _degrees(value: float | None) -> float | None:
    return None if value is None else math.degrees(value)
