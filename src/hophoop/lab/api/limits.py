"""Bounds of one request to the lab, and two refusals of valid requests: too much, too busy."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from hophoop.scenario import Compliant, InputError, Scenario
from hophoop.scenario.scenario import time_unit
from hophoop.vocabulary.sentences import LAB


class TooMuch(InputError):
    """The request is valid but exceeds the lab's limits (HTTP 413)."""


class TooBusy(RuntimeError):
    """The lab is fully loaded (HTTP 503)."""

    seconds = 1

    @classmethod
    def after(cls, seconds: float) -> TooBusy:
        """Return an error with the time after which to try again.

        Parameters
        ----------
        seconds : float
            Waiting time of a request that arrives now [s].

        Returns
        -------
        error : TooBusy
        """
        whole = min(max(math.ceil(seconds), 1), 600)
        error = cls(f"The lab is busy; try again in {whole} second{'s' if whole > 1 else ''}.")
        error.seconds = whole
        return error


@dataclass(frozen=True)
class Limits:
    """Bounds of one request.

    Attributes
    ----------
    body : int
        Maximum size of a request's body in bytes [1].
    duration : float
        Maximum duration of a motion [s].
    events : int
        Maximum number of events of a motion [1].
    parts : int
        Maximum number of parts of a hoop [1].
    samples : int
        Maximum number of samples of a motion [1].
    cells : int
        Maximum number of cells of a map [1].
    map_seconds : float
        Maximum of the duration of a motion times the cells of a map [s].
    steps : float
        Maximum of the estimated steps of a compliant contact's integration [1].
    film : float
        Maximum length of a film [s].
    film_patience : float
        Maximum time to compute a film [s].
    waiting : int
        Maximum number of waiting requests [1].
    queue, film_queue : float
        Maximum waiting time of a request, and of one for a film; a request that would wait longer is refused at once [s].
    patience : float
        Maximum time to compute a request [s].
    processes : int
        Processes that compute, besides one for films [1].
    turns : float
        Maximum of the estimated revolutions of a motion [1].
    map_turns : float
        Maximum of the estimated revolutions in all cells of a map [1].
    changes : int
        Maximum number of changes to a scenario in one request [1].
    reading : float
        Maximum time for the body of a request to arrive [s].
    """

    body: int = 65_536
    duration: float = 600.0
    events: int = 20_000
    parts: int = 64
    samples: int = 20_001
    cells: int = 65_536
    map_seconds: float = 400_000.0
    steps: float = 3e6
    film: float = 20.0
    film_patience: float = 180.0
    waiting: int = 64
    queue: float = 10.0
    film_queue: float = 60.0
    patience: float = 20.0
    processes: int = 2
    turns: float = 2e5
    map_turns: float = 4e6
    changes: int = 200
    reading: float = 15.0


USUAL = Limits()


def within(scenario: Scenario, limits: Limits = USUAL) -> Scenario:
    """Return the scenario with its number of events limited; refuse a motion that would take too long.

    Raises
    ------
    TooMuch
        If the motion is longer, stiffer or made of more parts than the limits allow.
    """
    if scenario.duration > limits.duration:
        raise TooMuch(LAB["too_long"].format(duration=scenario.duration, most=limits.duration))
    parts = len(scenario.hoop.parts or ())
    if parts > limits.parts:
        raise TooMuch(LAB["too_many_parts"].format(parts=parts, most=limits.parts))
    turns = float(turns_of(scenario))
    if turns > limits.turns:
        raise TooMuch(LAB["too_many_turns"].format(duration=scenario.duration, turns=turns, most=limits.turns))
    if isinstance(scenario.contact, Compliant):
        steps = _steps(scenario, scenario.contact)
        if steps > limits.steps:
            raise TooMuch(LAB["too_stiff"].format(steps=steps / 1e6, most=limits.steps / 1e6))
    if scenario.contact.max_events > limits.events:
        return scenario.replace("contact.max_events", limits.events)
    return scenario


def turns_of(scenario: Scenario, **values: Any) -> Any:
    """Estimate the revolutions of the hoop if all its energy went into rolling: the cost of a motion.

    Parameters
    ----------
    scenario : Scenario
    **values : array_like
        Other values of duration, radius, gravity, slope, vx, vy and omega of the scenario [SI].

    Returns
    -------
    turns : float or ndarray
        Upper bound, correct to a factor of a few [1].
    """
    hoop, plane = scenario.hoop, scenario.plane
    state = scenario.start.state(hoop)
    given = {
        "duration": scenario.duration, "radius": hoop.radius, "gravity": plane.gravity, "slope": plane.slope,
        "vx": state.vx, "vy": state.vy, "omega": state.omega,
    }  # fmt: skip
    duration, radius, gravity, slope, vx, vy, omega = (np.asarray(values.get(name, value)) for name, value in given.items())
    # twice the energy of the start and of the load's fall, plus that of the slope, whose sine is at most that
    start = np.abs(vx) + np.abs(vy) + radius * np.abs(omega) + 2.0 * np.sqrt(gravity * (radius + state.height))
    speed = 2.0 * start + 0.5 * gravity * np.minimum(np.abs(slope), 1.0) * duration
    return speed * duration / (2.0 * math.pi * radius)


def _steps(scenario: Scenario, contact: Compliant) -> float:
    """Estimate the steps: a few per oscillation of the contact, whatever the slip speed, since the method is implicit."""
    mass = scenario.hoop.mass
    rate = 10.0 / time_unit(scenario.hoop, scenario.plane)
    if contact.stiffness is not None:
        rate += math.sqrt(contact.stiffness / mass)
    return 10.0 * scenario.duration * rate + 40.0 * float(turns_of(scenario))
