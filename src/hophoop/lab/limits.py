"""What one request to the lab may cost, and two answers that are no errors of input: too much, too busy."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from hophoop.scenario import Compliant, InputError, Scenario
from hophoop.scenario.scenario import time_unit
from hophoop.vocabulary.sentences import LAB


class TooMuch(InputError):
    """The request is valid, but asks for more than the lab computes at a time (HTTP 413)."""


class TooBusy(RuntimeError):
    """The lab has as much to do as it takes on (HTTP 503)."""

    seconds = 1

    @classmethod
    def after(cls, seconds: float) -> TooBusy:
        """Say when it is worth while to ask again.

        Parameters
        ----------
        seconds : float
            How long a request that comes now would have to wait [s].

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
        Bytes of a request's body [1].
    duration : float
        Of a motion [s].
    events : int
        Of a motion [1].
    parts : int
        Of a hoop [1].
    samples : int
        Of a motion [1].
    cells : int
        Of a map [1].
    map_seconds : float
        Duration of a motion times the cells of a map [s].
    steps : float
        Estimated steps of the compliant contact's integration [1].
    film : float
        Length of a film [s].
    film_patience : float
        Time after which a request for a film is answered at the latest [s].
    waiting : int
        Requests that wait at the same time [1].
    queue, film_queue : float
        Longest time that a request waits, and one for a film; who would wait longer is told at once [s].
    patience : float
        Longest time that a request is computed [s].
    processes : int
        That compute, besides one for films [1].
    turns : float
        Estimated revolutions of a motion [1].
    map_turns : float
        Estimated revolutions in all cells of a map [1].
    changes : int
        To a scenario, in one request [1].
    reading : float
        Time in which the body of a request must be there [s].
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
    """The scenario with its events bounded; refuse what would take too long.

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
            raise TooMuch(LAB["too_stiff"].format(steps=steps, most=limits.steps))
    if scenario.contact.max_events > limits.events:
        return scenario.replace("contact.max_events", limits.events)
    return scenario


def turns_of(scenario: Scenario, **values: Any) -> Any:
    """About how often the hoop turns, or would turn if all its energy went into rolling: what computing it costs.

    Parameters
    ----------
    scenario : Scenario
    **values : array_like
        Other values of its duration, radius, gravity, slope, vx, vy and omega [SI].

    Returns
    -------
    turns : float or ndarray
        An estimate from above, good to a factor of a few [1].
    """
    hoop, plane = scenario.hoop, scenario.plane
    state = scenario.start.state(hoop)
    given = {
        "duration": scenario.duration, "radius": hoop.radius, "gravity": plane.gravity, "slope": plane.slope,
        "vx": state.vx, "vy": state.vy, "omega": state.omega,
    }  # fmt: skip
    duration, radius, gravity, slope, vx, vy, omega = (np.asarray(values.get(name, value)) for name, value in given.items())
    # twice what the start has and the fall of the load gives, and what the slope adds on the way: its sine is at most that
    start = np.abs(vx) + np.abs(vy) + radius * np.abs(omega) + 2.0 * np.sqrt(gravity * (radius + state.height))
    speed = 2.0 * start + 0.5 * gravity * np.minimum(np.abs(slope), 1.0) * duration
    return speed * duration / (2.0 * math.pi * radius)


def _steps(scenario: Scenario, contact: Compliant) -> float:
    """Rough count of steps: a few for each oscillation of the contact; a small slip speed costs an implicit method none."""
    mass = scenario.hoop.mass
    rate = 10.0 / time_unit(scenario.hoop, scenario.plane)
    if contact.stiffness is not None:
        rate += math.sqrt(contact.stiffness / mass)
    return 10.0 * scenario.duration * rate + 40.0 * float(turns_of(scenario))


def whole_number(value: Any, name: str, least: int, most: int, but_not: int | None = None) -> int:
    """A whole number from `least` on; more than `most` is too much.

    Raises
    ------
    ValueError
        If it is not a whole number in the range.
    TooMuch
        If it is larger.
    """
    if isinstance(value, bool) or not isinstance(value, int) or value < least or value == but_not:
        other = f" and not {but_not}" if but_not is not None else ""
        raise InputError(
            f"{name} = {json.dumps(value)[:60]} must be a whole number from {least}{other}.",
            field=name,
            value=value,
        )
    if value > most:
        raise TooMuch.of_field(name, value, f"at most {most} in the lab")
    return value
