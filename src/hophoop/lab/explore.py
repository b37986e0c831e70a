"""What surrounds a motion: theory's thresholds, the regions of the (θ, θ̇) plane, maps of motions."""

from __future__ import annotations

import json
import math
import threading
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from hophoop import maps, theory
from hophoop.lab.frames import codes_of
from hophoop.lab.limits import Limits, TooMuch, whole_number, within
from hophoop.lab.words import degrees
from hophoop.maps.evaluate import CHUNK_CELLS
from hophoop.scenario import Compliant, InputError, Plane, Rigid, Scenario, parameter
from hophoop.vocabulary.classes import class_color, class_text
from hophoop.vocabulary.words import mode_words

# --- theory ----------------------------------------------------------------------------------------


def thresholds(scenario: Scenario) -> list[dict[str, Any]]:
    """What theory says about the hoop of a scenario.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    thresholds : list of dict
        `key`, `label`, `value` (None where there is none), `unit` and `text`.
    """
    hoop, plane = scenario.hoop, scenario.plane
    known = {quantity.key: quantity for quantity in theory.summary(scenario)}
    found: list[dict[str, Any]] = []

    def add(key: str, label: str, quantity: str, say: Callable[[float], str]) -> None:
        there = known.get(quantity)
        if there is None or there.value is None:
            return
        value = there.value if math.isfinite(there.value) else None
        found.append({"key": key, "label": label, "value": value, "unit": there.unit, "text": say(there.value)})

    if plane.gravity <= 0.0:
        add("painleve", PARADOX_LABEL, "painleve_friction", lambda mu: _painleve(mu, known, plane))
        return found
    if hoop.massless:
        loss = theory.massless_loss(scenario.start.speed or 0.0, hoop.radius, plane)
        why = "friction is used up" if loss.by_friction else "the contact force is gone"
        add("loss", "End of rolling", "massless_loss_angle", lambda angle: f"at {degrees(angle)} {why}")
        return found
    if plane.slope >= 0.0:
        push = "any push is enough"
        add("first_slip", "Slips", "first_slip_speed", lambda speed: _above(speed, "would slip", push))
        add("first_hop", "Hops", "first_hop_speed", lambda speed: _above(speed, "would hop in its first turn", push))
        at_once = "would hop at once"
        add("immediate_hop", "Hops at once", "immediate_hop_speed", lambda speed: _above(speed, at_once, "at any speed"))
    add("needed_friction", "Friction for pure rolling", "needed_friction", lambda mu: _needed(mu, plane))
    add("painleve", PARADOX_LABEL, "painleve_friction", lambda mu: _painleve(mu, known, plane))
    jams = [quantity for key, quantity in known.items() if key.startswith("jam_angle")]
    places = ", ".join(degrees(jam.value) for jam in jams if jam.value is not None)
    add("jam", "Dynamic jam", "jam_angle", lambda angle: f"can end a slip at {places}")
    if hoop.eccentricity > 0.0:
        add("rest", "Rests stably", "stable_angle", lambda angle: f"with the load at {degrees(angle)}")
    return found


PARADOX_LABEL = "Painlevé’s paradox"


def _above(speed: float, would: str, always: str) -> str:
    if speed == 0.0:
        return f"{would}: {always}"
    if not math.isfinite(speed):
        return "never, at any speed"
    return f"{would} above {speed:.4g} m/s"


def _needed(mu: float, plane: Plane) -> str:
    if not math.isfinite(mu):
        return "no friction keeps it rolling"
    return f"μ = {mu:.3g} would keep it rolling ({'enough here' if mu <= plane.mu_static else 'more than there is'})"


def _painleve(mu: float, known: Mapping[str, theory.Quantity], plane: Plane) -> str:
    angle = known["painleve_angle"].value
    whether = "possible here" if mu <= plane.mu_kinetic else "not here"
    return "never" if angle is None else f"from μ = {mu:.3g} on, at {degrees(angle)}: {whether}"


# --- the (θ, θ̇) plane --------------------------------------------------------------------------------

PARADOX = 6  # one more than the codes of modes and of 'no answer'


def regions(
    scenario: Scenario, window: tuple[float, float, float, float], columns: int = 360, rows: int = 240
) -> dict[str, Any]:
    """The mode that follows contact without slip over the (θ, θ̇) plane.

    Parameters
    ----------
    scenario : Scenario
        Its hoop and plane count.
    window : tuple of float
        θ from and to [rad], θ̇ from and to [rad/s].
    columns, rows : int
        Cells over θ, and over θ̇ [1].

    Returns
    -------
    regions : dict of ndarray
        `modes` (rows upwards): code of the mode's word, 5 where the model has no answer; `paradox`: for
        each column −1 (spin), 1 (skid) or 0, the slip that meets Painlevé's paradox there.
    """
    left, right, bottom, top = window
    angles = left + (np.arange(columns) + 0.5) * ((right - left) / columns)
    rates = bottom + (np.arange(rows) + 0.5) * ((top - bottom) / rows)
    letters = theory.mode_of(angles[None, :], rates[:, None], scenario.hoop, scenario.plane)
    codes = codes_of(mode_words(letters, rates[:, None])).astype(np.uint8)
    paradox = np.zeros(columns)
    if not scenario.hoop.massless and math.isfinite(scenario.plane.mu_kinetic):
        paradox = np.asarray(theory.painleve_region(angles, scenario.plane.mu_kinetic, scenario.hoop), float)
    return {"modes": codes, "paradox": paradox}


# --- maps --------------------------------------------------------------------------------------------

# name, words, span; what a map in the lab can show
MAP_QUANTITIES: dict[str, tuple[str, str]] = {
    "sequence": ("what happens in the first turn", "first_revolution"),
    "hop_height": ("height of the first hop", "takeoff"),
    "takeoff_angle": ("angle of take-off", "takeoff"),
    "flight_time": ("duration of the first hop", "takeoff"),
    "greatest_utilization": ("greatest friction utilization", "first_revolution"),
    "energy_lost": ("energy lost", "duration"),
    "end_angle": ("angle at the end", "duration"),
    "painleve": ("Painlevé’s paradox or jam met", "duration"),
    "ending": ("how it ends", "duration"),
}

# A map has all cores: two at a time would only make both late.
_one_at_a_time = threading.Lock()

MAP_EVENTS = 2000
_AXIS_KEYS = {"path", "from", "to", "cells"}


def axis_options(body: Mapping[str, Any], name: str) -> dict[str, Any]:
    """One axis of a map: path, from, to (SI) and cells.

    Raises
    ------
    ValueError
        If one is missing, unknown or not allowed.
    """
    axis = body.get(name)
    if not isinstance(axis, dict):
        raise InputError(f"{name} must be an object with path, from, to and cells.")
    for key in axis:
        if key not in _AXIS_KEYS:
            raise InputError(f"{name}.{key} is not a known key; known are path, from, to, cells.")
    path = axis.get("path")
    if not isinstance(path, str):
        raise InputError(
            f"{name}.path = {json.dumps(path)[:60]} must be the path of a parameter, such as 'plane.mu'."
        )
    if parameter(path).unit == "":
        raise InputError(f"{name}.path = {path!r} must be a number's path, not that of a word.")
    ends = {}
    for key in ("from", "to"):
        value = axis.get(key)
        if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
            raise InputError(f"{name}.{key} = {json.dumps(value)[:60]} must be a finite number.")
        ends[key] = float(value)
    cells = whole_number(axis.get("cells", 48), f"{name}.cells", 1, 4096)
    return {"path": path, **ends, "cells": cells}


def map_options(body: Mapping[str, Any], limits: Limits) -> dict[str, Any]:
    """The options of a map: x, y and what.

    Raises
    ------
    ValueError
        If one is missing or not allowed.
    TooMuch
        If it has too many cells.
    """
    for key in body:
        if key not in ("scenario", "query", "changes", "x", "y", "what"):
            raise InputError(f"{key} is not a known key; known are scenario, x, y, what.")
    x, y = axis_options(body, "x"), axis_options(body, "y")
    if x["path"] == y["path"]:
        raise InputError(f"x.path and y.path are both {x['path']!r} and must differ.")
    what = body.get("what", "sequence")
    if what not in MAP_QUANTITIES:
        raise InputError(f"what = {json.dumps(what)[:60]} must be one of {', '.join(MAP_QUANTITIES)}.")
    cells = x["cells"] * y["cells"]
    if cells > limits.cells:
        raise TooMuch(f"x.cells times y.cells = {cells} must be at most {limits.cells} in the lab.")
    return {"x": x, "y": y, "what": what}


def motion_map(
    scenario: Scenario, options: Mapping[str, Any], limits: Limits
) -> tuple[dict[str, Any], np.ndarray]:
    """A map over two parameters; each value is that of a cell's middle.

    Raises
    ------
    ValueError
        If the axes do not go with the scenario.
    TooMuch
        If it would take too long.
    """
    if isinstance(scenario.contact, Compliant):
        raise InputError("contact.model = 'compliant' must be 'rigid' for a map.")
    x, y, what = options["x"], options["y"], options["what"]
    words, span = MAP_QUANTITIES[what]
    cells = x["cells"] * y["cells"]
    if cells * scenario.duration > limits.map_seconds and span != "first_revolution":
        raise TooMuch(
            f"{cells} cells times duration = {scenario.duration:g} s is {cells * scenario.duration:.3g} s of "
            f"motion and must be at most {limits.map_seconds:.3g} s in the lab."
        )
    base = within(scenario, limits)
    if isinstance(base.contact, Rigid) and base.contact.max_events > MAP_EVENTS:
        base = base.replace("contact.max_events", MAP_EVENTS)
    values = {axis["path"]: _middles(axis) for axis in (y, x)}
    with _one_at_a_time:
        dataset = maps.sweep(base, values, (what,), span, chunk_cells=CHUNK_CELLS)
    array = dataset[what].transpose(y["path"], x["path"])
    quantity = maps.QUANTITIES[what]
    header = {
        "x": x,
        "y": y,
        "what": what,
        "label": words,
        "unit": quantity.unit,
        "classes": None,
    }
    numbers = array.values.astype(float)
    if quantity.is_code:
        names = maps.words_of(array)
        header["classes"] = [
            {"name": name, "text": class_text(name, what), "color": class_color(name, what)}
            for name in names
        ]
        numbers[numbers < 0] = math.nan
    return header, numbers


def _middles(axis: Mapping[str, Any]) -> np.ndarray:
    low, high, cells = float(axis["from"]), float(axis["to"]), int(axis["cells"])
    middles: np.ndarray = low + (np.arange(cells) + 0.5) * ((high - low) / cells)
    return middles
