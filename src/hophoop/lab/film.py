"""A motion as the player takes it: what it is told with, and states at enough times, both sides of every event."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from hophoop.lab import words
from hophoop.lab.packing import PRECISE
from hophoop.physics.body import MODE_LETTERS
from hophoop.scenario import Compliant, Scenario, time_unit
from hophoop.trajectory import Floats, Trajectory

DRAWN = (
    "vx", "vy", "omega", "slip", "friction_force", "normal_force", "kinetic", "potential",
    "friction", "impact_normal", "impact_tangential", "spring", "damping", "utilization", "mode",
)  # fmt: skip


def columns(motion: Trajectory, rate: float = 150.0, most: int = 6000) -> dict[str, Floats]:
    """The motion at a steady rate and at both sides of each event, in order of time.

    Parameters
    ----------
    motion : Trajectory
    rate : float, default 150
        Samples a second of motion [1/s].
    most : int, default 6000
        Most samples between events [1].

    Returns
    -------
    columns : dict of ndarray
        Equal lengths; `mode` is the index of the mode's letter in 'RSKHM'.
    """
    duration = motion.duration
    count = min(max(math.ceil(duration * rate), 240), most)
    steady = np.linspace(0.0, duration, count + 1) if duration > 0.0 else np.zeros(1)
    # the end of the last piece can lie a rounding beyond the duration
    marks = np.unique(np.minimum([event.t for event in motion.events], duration))
    times = np.union1d(steady, marks)
    after = motion.at(times)
    before = motion.at(marks[marks > 0.0], side="left")
    order = np.argsort(np.concatenate([before.t, times]), kind="stable")
    joined: dict[str, Floats] = {}
    plane = motion.scenario.plane
    for name in (*PRECISE, *DRAWN):
        if name == "utilization":
            continue
        pair = [getattr(before, name), getattr(after, name)]
        if name == "mode":
            pair = [_codes(letters) for letters in pair]
        joined[name] = np.concatenate(pair)[order]
    slip = np.isin(joined["mode"], (1, 2))
    limit = np.where(slip, plane.mu_kinetic, plane.mu_static) * joined["normal_force"]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.abs(joined["friction_force"]) / limit
    joined["utilization"] = np.where(limit > 0.0, share, np.nan)
    if plane.mu_kinetic > 0.0:
        # also at the instant of lift-off, where both forces are zero
        joined["utilization"][slip] = 1.0
    return joined


def _codes(letters: np.ndarray) -> np.ndarray:
    codes = np.zeros(letters.shape)
    for code, letter in enumerate(MODE_LETTERS):
        codes[letters == letter] = code
    return codes


def header(motion: Trajectory, scenario: Scenario | None = None) -> dict[str, Any]:
    """What the player knows of a motion besides its frames.

    Parameters
    ----------
    motion : Trajectory
    scenario : Scenario, optional
        What it is shown as; the motion's own by default.

    Returns
    -------
    header : dict
        Its result, scenario, link, the values of the sliders, and the motion in words.
    """
    scenario = motion.scenario if scenario is None else scenario
    hoop, plane = scenario.hoop, scenario.plane
    result = motion.to_dict()
    del result["scenario"]
    many = len(result["events"]) > 2000
    if many:
        result["events"] = result["events"][:2000]
    state = scenario.start.state(hoop)
    return {
        **result,
        "scenario": scenario.to_dict(),
        "query": scenario.to_query(),
        "duration": motion.duration,
        # as the sliders show them, whichever way the scenario is given
        "values": {
            "hoop.radius": hoop.radius,
            "hoop.mass": hoop.mass,
            "hoop.load_fraction": hoop.load_fraction,
            "hoop.eccentricity": hoop.eccentricity,
            "hoop.inertia_ratio": hoop.inertia_ratio,
            "plane.mu": _finite(plane.mu),
            "plane.mu_static": _finite(plane.mu_static),
            "plane.mu_kinetic": _finite(plane.mu_kinetic),
            "start.speed": scenario.start.speed,
            "start.height": state.height,
            "start.vx": state.vx,
            "start.vy": state.vy,
            "start.omega": state.omega,
        },
        # what is chosen by itself where the scenario leaves it open
        "automatic": _automatic(scenario),
        "massless": hoop.massless,
        "summary": words.summary(motion),
        "story": words.story(motion),
        "ending": words.ENDINGS[motion.status],
        "shortened": many,
    }


def _automatic(scenario: Scenario) -> dict[str, float]:
    contact = scenario.contact
    if not isinstance(contact, Compliant):
        return {}
    from hophoop.compliant.parameters import to_compliance

    _, chosen, _, _ = to_compliance(scenario)
    second = time_unit(scenario.hoop, scenario.plane)
    return {
        "contact.stiffness": chosen.k * scenario.hoop.mass / second**2,
        "contact.slip_speed": chosen.v_s * scenario.hoop.radius / second,
        "contact.restitution": scenario.plane.restitution,
    }


def _finite(value: float | None) -> float | str | None:
    return "inf" if value == float("inf") else value
