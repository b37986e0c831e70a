"""What one request to the lab may cost, and two answers that are no errors of input: too much, too busy."""

from __future__ import annotations

import json
import math
from dataclasses import dataclass
from typing import Any

from hophoop.scenario import Compliant, InputError, Scenario
from hophoop.scenario.scenario import time_unit
from hophoop.vocabulary.sentences import LAB


class TooMuch(InputError):
    """The request is valid, but asks for more than the lab computes at a time (HTTP 413)."""


class TooBusy(RuntimeError):
    """The lab has as much to do as it takes on (HTTP 429)."""


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
        Requests that compute or wait at the same time, in one process [1].
    patience : float
        Time after which a request is answered at the latest [s].
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
    patience: float = 20.0


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
    if isinstance(scenario.contact, Compliant):
        steps = _steps(scenario, scenario.contact)
        if steps > limits.steps:
            raise TooMuch(
                f"contact.stiffness, contact.slip_speed and duration need about {steps:.0e} steps of "
                f"integration and must need at most {limits.steps:.0e} in the lab."
            )
    if scenario.contact.max_events > limits.events:
        return scenario.replace("contact.max_events", limits.events)
    return scenario


def _steps(scenario: Scenario, contact: Compliant) -> float:
    """Rough count of steps: a few for each oscillation of the contact; a small slip speed costs an implicit method none."""
    mass = scenario.hoop.mass
    rate = 10.0 / time_unit(scenario.hoop, scenario.plane)
    if contact.stiffness is not None:
        rate += math.sqrt(contact.stiffness / mass)
    return 10.0 * scenario.duration * rate


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
        raise InputError(f"{name} = {json.dumps(value)[:60]} must be a whole number from {least}{other}.")
    if value > most:
        raise TooMuch(f"{name} = {value} must be at most {most} in the lab.")
    return value
