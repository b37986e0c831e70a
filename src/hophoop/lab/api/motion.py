"""A motion for the player: its results, and states at sufficiently many times, on both sides of every event."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np

from hophoop.lab.api.packing import PRECISE
from hophoop.scenario import Scenario
from hophoop.simulation.trajectory import Floats, Trajectory
from hophoop.vocabulary.names import MODE_WORDS, coming_rotation, mode_words

DRAWN = (
    "vx", "vy", "omega", "slip", "friction_force", "normal_force", "kinetic", "potential",
    "friction_loss", "normal_loss", "rolling_resistance", "utilization", "mode",
)  # fmt: skip


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
        Maximum number of steady samples [1]; if it limits them, there is one more where the load passes the top or the bottom.
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
    if count == most:
        times = np.union1d(times, passes(times, motion.at(times).angle))
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


def passes(times: Floats, angle: Floats) -> Floats:
    """Return about when the load passes the top or the bottom, where speeds and forces are extreme.

    Parameters
    ----------
    times : ndarray, shape (n,)
        Increasing times [s].
    angle : ndarray, shape (n,)
        The angle θ of the load at these times [rad].

    Returns
    -------
    passes : ndarray
        At most one time between two of `times` [s].
    """
    half = np.floor(angle / np.pi)
    at = np.flatnonzero(half[1:] != half[:-1])
    low, high = angle[at], angle[at + 1]
    share = (np.maximum(half[at], half[at + 1]) * np.pi - low) / (high - low)
    return np.asarray(times[at] + share * (times[at + 1] - times[at]))


def codes_of(words: np.ndarray) -> Floats:
    """Return the code of each mode's word: its index in `vocabulary.names.MODE_WORDS`, or their number for another word.

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


def result(motion: Trajectory, scenario: Scenario | None = None) -> dict[str, Any]:
    """Return the results of a motion, from which the page makes its words.

    Parameters
    ----------
    motion : Trajectory
    scenario : Scenario, optional
        The scenario shown with the motion; the motion's own by default.

    Returns
    -------
    result : dict
        As in a result file, with the scenario's link under `query`; `turning` holds, for events with θ̇ = 0, the angular
        velocity halfway to the next event [rad/s].
    """
    found = motion.to_dict()
    for key in ("schema", "version", "scenario"):
        del found[key]
    pairs = enumerate(itertools.pairwise(motion.events))
    halfway = {number: 0.5 * (event.t + following.t) for number, (event, following) in pairs if event.omega == 0.0}
    return {
        **found,
        "query": (scenario or motion.scenario).to_query(),
        "duration": motion.duration,
        "turning": {str(number): motion.at(t).omega for number, t in halfway.items()},
    }
