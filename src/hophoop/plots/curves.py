"""The table of curves, and a motion as curves: dense samples with both sides of every event, and its phases."""

from __future__ import annotations

import math
from dataclasses import fields
from itertools import pairwise
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.results.records import ArraySample, Sample
from hophoop.scenario.scenario import Scenario, time_unit
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors, quantities
from hophoop.vocabulary.names import coming_rotation, mode_word, mode_words

# Samples per unit of time √(R/g); about 470 per second for the reference hoop.
DENSITY = 150
FEWEST, MOST = 600, 40_000


LINE, THIN, BROKEN = 1.8, 1.0, (0, (4, 1.6))


class Curve(NamedTuple):
    """A curve of figures and of panels of films: its quantity, see `values_of`, what it shows, and how."""

    field: str
    label: str
    color: str
    dashes: Any = "-"  # in figures
    short: str = ""  # label in a panel, which shows only curves that have one
    width: float = LINE
    always: bool = True  # in figures also where it is zero throughout


VELOCITIES = (
    Curve("vx", "centre, $v$", colors.CENTER_SPEED, short="v"),
    Curve("rotation", r"rotation, $R\dot\theta$", colors.ROTATION_SPEED, BROKEN, "Rθ̇"),
)
ENERGIES = (
    Curve("kinetic", "kinetic", colors.KINETIC, short="kinetic"),
    Curve("potential", "potential", colors.POTENTIAL, BROKEN, "potential"),
    Curve("total", "kinetic + potential", colors.TOTAL, (0, (7, 1.5, 1.2, 1.5)), "sum"),
    Curve("friction_loss", "lost to friction", colors.FRICTION_LOSS, (0, (1.2, 1.2)), "friction", always=False),
    # its label depends on the contact
    Curve("normal_loss", "", colors.IMPACT_LOSS, (0, (3, 1.2, 1, 1.2, 1, 1.2)), "impacts", always=False),
    Curve("rolling_resistance", "lost to rolling resistance", colors.GRAY, (0, (2, 1, 1, 1)), always=False),
    Curve("spring", "in the contact's spring", colors.GRAY, width=THIN, always=False),
)
FORCES = (
    Curve("normal_force", "normal force", colors.NORMAL_FORCE, short="normal"),
    Curve("friction_force", "friction", colors.FRICTION_FORCE, short="friction"),
)
UTILIZATION = (Curve("signed_utilization", "", colors.FRICTION_FORCE),)
GAP = (Curve("height", "", colors.BLACK),)
# of films: title and curves of each panel
PANELS: Final[dict[str, tuple[str, tuple[Curve, ...]]]] = {
    "velocity": (quantities.VELOCITY, VELOCITIES),
    "energy": (quantities.ENERGY, ENERGIES),
    "forces": (quantities.FORCE, FORCES),
    "utilization": (quantities.UTILIZATION, (Curve("utilization", "", colors.FRICTION_FORCE, short="|F| / μN"),)),
    "phase": ("θ̇ (rad/s)", (Curve("omega", "", colors.BLACK, short="θ̇"),)),
}


class Phase(NamedTuple):
    """A part of the motion in one mode, by letter and word: times [s] and angles [degrees] at its ends."""

    mode: str
    word: str
    t: float
    end_t: float
    angle: float
    end_angle: float


def phases(motion: Trajectory) -> list[Phase]:
    """Return the motion's phases in order; events that keep mode and word do not separate them.

    A slip in which the hoop turns back is two phases, since a spin becomes a skid, or the reverse.
    """
    found: list[Phase] = []
    for event, following in pairwise(motion.events):
        if not following.t > event.t:
            continue
        # θ̇ may be zero at either end, but not halfway
        word = mode_word(event.to_mode, motion.at(0.5 * (event.t + following.t)).omega)
        angle, end_angle = math.degrees(event.angle), math.degrees(following.angle)
        if found and (found[-1].mode, found[-1].word) == (event.to_mode, word):
            found[-1] = found[-1]._replace(end_t=following.t, end_angle=end_angle)
        else:
            found.append(Phase(event.to_mode, word, event.t, following.t, angle, end_angle))
    return found


def shown_words(sample: ArraySample) -> NDArray[np.str_]:
    """Return the words for the modes of a sample in order of time."""
    return mode_words(sample.mode, coming_rotation(sample.omega))


def curve(motion: Trajectory, start: float = 0.0, end: float | None = None) -> ArraySample:
    """Sample the motion densely, with both sides of each event.

    At a jam, where the force is unbounded, it is nan.
    """
    end = motion.duration if end is None else min(end, motion.duration)
    unit = time_unit(motion.scenario.hoop, motion.scenario.plane)
    count = int(min(MOST, max(FEWEST, DENSITY * (end - start) / unit)))
    marks = np.unique([event.t for event in motion.events if start <= event.t <= end])
    grid = np.setdiff1d(np.linspace(start, end, count), marks)
    before = motion.at(marks[marks > start], side="left")
    after = motion.at(np.concatenate([grid, marks]))
    order = np.argsort(np.concatenate([before.t, after.t]), kind="stable")
    columns = {
        field.name: np.concatenate([getattr(before, field.name), getattr(after, field.name)])[order] for field in fields(Sample)
    }
    if motion.status == "jammed":
        for name in ("normal_force", "friction_force"):
            columns[name] = np.where(columns["t"] < motion.duration, columns[name], np.nan)
    return Sample(**columns)


def values_of(name: str, sample: ArraySample, scenario: Scenario) -> Any:
    """Return a quantity of a sample: a field, the rim's speed of rotation, or the friction utilization, signed or not."""
    if name == "rotation":
        return scenario.hoop.radius * sample.omega
    if name.endswith("utilization"):
        return sample.utilization(scenario.plane, signed=name.startswith("signed"))
    return getattr(sample, name)


def turning(motion: Trajectory) -> bool:
    """Return True if the hoop rotates in both directions, so that its angle does not order the motion."""
    rates = curve(motion).omega
    rates = rates[np.isfinite(rates)]
    limit = 1e-9 * np.abs(rates).max(initial=0.0)
    return bool((rates > limit).any() and (rates < -limit).any())
