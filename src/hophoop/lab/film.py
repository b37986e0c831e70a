"""A motion for the player: a header, and states at sufficiently many times, on both sides of every event."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from hophoop.lab import words
from hophoop.lab.packing import PRECISE
from hophoop.scenario import Compliant, Scenario, time_unit
from hophoop.simulation.trajectory import Floats, Trajectory
from hophoop.vocabulary.modes import MODE_WORDS, coming_rotation, mode_words
from hophoop.vocabulary.parameters import TABLE, section_of
from hophoop.vocabulary.statuses import STATUSES

DRAWN = (
    "vx", "vy", "omega", "slip", "friction_force", "normal_force", "kinetic", "potential",
    "friction_loss", "normal_loss", "rolling_resistance", "utilization", "mode",
)  # fmt: skip

SHOWN = tuple(row.path for row in TABLE if row.slider and section_of(row) in ("hoop", "plane", "start"))
"""Paths of the sliders whose values may follow from the scenario instead of being in it."""


def columns(
    motion: Trajectory, rate: float = 150.0, most: int = 6000, window: tuple[float, float] | None = None
) -> dict[str, Floats]:
    """Sample the motion at a steady rate and on both sides of each event, in order of time.

    Parameters
    ----------
    motion : Trajectory
    rate : float, default 150
        Samples per second of motion [1/s].
    most : int, default 6000
        Maximum number of samples between events [1].
    window : (float, float), optional
        Start and end; the whole motion by default [s].

    Returns
    -------
    columns : dict of ndarray
        Arrays of equal lengths; `mode` is the code of the mode's word (see `codes_of`), which also selects the colour.
    """
    duration = motion.duration
    begin, end = (0.0, duration) if window is None else (min(max(t, 0.0), duration) for t in window)
    count = min(max(math.ceil((end - begin) * rate), 240), most)
    steady = np.linspace(begin, end, count + 1) if end > begin else np.array([begin])
    # rounding may put the end of the last segment beyond the duration
    marks = np.unique(np.minimum([event.t for event in motion.events], duration))
    marks = marks[(marks >= begin) & (marks <= end)]
    times = np.union1d(steady, marks)
    after = motion.at(times)
    before = motion.at(marks[marks > 0.0], side="left")
    order = np.argsort(np.concatenate([before.t, times]), kind="stable")
    joined: dict[str, Floats] = {}
    plane = motion.scenario.plane
    for name in (*PRECISE, *DRAWN):
        if name == "mode":
            continue
        if name == "utilization":
            pair = [before.utilization(plane), after.utilization(plane)]
        else:
            pair = [getattr(before, name), getattr(after, name)]
        joined[name] = np.concatenate(pair)[order]
    letters = np.concatenate([before.mode, after.mode])[order]
    joined["mode"] = codes_of(mode_words(letters, coming_rotation(joined["omega"])))
    return joined


def codes_of(words: np.ndarray) -> Floats:
    """Return the code of each mode's word: its index in `vocabulary.modes.MODE_WORDS`, or their number for another word.

    Parameters
    ----------
    words : ndarray of str

    Returns
    -------
    codes : ndarray
        Codes [1].
    """
    codes = np.full(words.shape, float(len(MODE_WORDS)))
    for code, word in enumerate(MODE_WORDS):
        codes[words == word] = code
    return codes


def header(motion: Trajectory, scenario: Scenario | None = None) -> dict[str, Any]:
    """Return what the player needs besides the samples.

    Parameters
    ----------
    motion : Trajectory
    scenario : Scenario, optional
        The scenario shown with the motion; the motion's own by default.

    Returns
    -------
    header : dict
        Result, scenario, link, values of the sliders, and the motion in words.
    """
    scenario = motion.scenario if scenario is None else scenario
    result = motion.to_dict()
    del result["scenario"]
    many = len(result["events"]) > 2000
    if many:
        result["events"] = result["events"][:2000]
    return {
        **result,
        "scenario": scenario.to_dict(),
        "query": scenario.to_query(),
        "duration": motion.duration,
        "values": _values(scenario),
        # values chosen automatically for what the scenario leaves open
        "automatic": _automatic(scenario),
        "massless": scenario.hoop.massless,
        "summary": words.summary(motion),
        "story": words.story(motion),
        "ending": STATUSES[motion.status].sentence,
        "shortened": many,
    }


def _values(scenario: Scenario) -> dict[str, Any]:
    """Return the values of the sliders, however the scenario is written."""
    state = scenario.start.state(scenario.hoop)
    found: dict[str, Any] = {}
    for path in SHOWN:
        section, _, name = path.partition(".")
        holder: Any = state if section == "start" and name != "speed" else getattr(scenario, section)
        found[path] = _finite(getattr(holder, name))
    return found


def _automatic(scenario: Scenario) -> dict[str, float]:
    contact = scenario.contact
    if not isinstance(contact, Compliant):
        return {}
    from hophoop.kernel.compliant.parameters import chosen_in_si
    from hophoop.simulation.compliant import to_compliance

    _, chosen, _, _ = to_compliance(scenario)
    second = time_unit(scenario.hoop, scenario.plane)
    stiffness, slip_speed = chosen_in_si(chosen, scenario.hoop.radius, second, scenario.hoop.mass)
    return {
        "contact.stiffness": stiffness,
        "contact.slip_speed": slip_speed,
        "contact.restitution": scenario.plane.restitution,
    }


def _finite(value: float | None) -> float | str | None:
    return "inf" if value == float("inf") else value
