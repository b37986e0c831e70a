"""Maps of motions over two parameters for the page."""

from __future__ import annotations

import math
import threading
from typing import Annotated, Any

import numpy as np
from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from hophoop import maps
from hophoop.lab.api.limits import Limits, TooMuch, turns_of, within
from hophoop.maps.grid.evaluate import CHUNK_CELLS
from hophoop.scenario import Compliant, InputError, Rigid, Scenario, parameter
from hophoop.scenario.base import Count, Frozen, Number, refuse
from hophoop.scenario.paths import contradiction
from hophoop.scenario.ranges import RANGES
from hophoop.vocabulary.classes import class_color, class_text
from hophoop.vocabulary.sentences import LAB

# name, words, span of the quantities that a map in the lab can show
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

# A map uses all cores: two at a time would only delay both.
_one_at_a_time = threading.Lock()

MAP_EVENTS = 2000
COSTLY = ("duration", "radius", "gravity", "slope", "vx", "vy", "omega")  # parameters of which `turns_of` takes other values
FLIGHT_TURNS = 2000.0  # a longer flight costs no more: it is only searched near the plane


def number_path(path: str) -> str:
    """Refuse a path that does not name a number."""
    try:
        known = parameter(path)
    except InputError as error:
        raise refuse(str(error)) from None
    if known.unit == "":
        raise PydanticCustomError("value", LAB["number_path"])
    return path


class Axis(Frozen):
    """One axis of a map."""

    path: Annotated[str, AfterValidator(number_path)] = Field(description="A parameter, such as plane.mu")
    low: Number = Field(alias="from", description="Where it starts, in SI units")
    high: Number = Field(alias="to", description="Where it ends, in SI units")
    cells: Annotated[Count, Field(ge=1, le=4096)] = Field(48, description="How many cells")

    def middles(self) -> np.ndarray:
        """Return the middle of each cell."""
        middles: np.ndarray = self.low + (np.arange(self.cells) + 0.5) * ((self.high - self.low) / self.cells)
        return middles

    def to_dict(self) -> dict[str, Any]:
        """Return the axis as it was requested."""
        return self.model_dump(by_alias=True)


def motion_map(scenario: Scenario, x: Axis, y: Axis, what: str, limits: Limits) -> tuple[dict[str, Any], np.ndarray]:
    """Return a map over two parameters; each value belongs to the middle of a cell.

    Raises
    ------
    ValueError
        If the axes contradict the scenario.
    TooMuch
        If it would take too long.

    Notes
    -----
    A cell with a value that no scenario allows is nan.
    """
    words, span = MAP_QUANTITIES[what]
    base, inside, values = bounded(scenario, x, y, what, limits)
    numbers = np.full((y.cells, x.cells), math.nan)
    names: list[str] = []
    quantity = maps.QUANTITIES[what]
    if all(column.size for column in values.values()):
        with _one_at_a_time:
            dataset = maps.sweep(base, values, (what,), span, chunk_cells=CHUNK_CELLS)
        array = dataset[what].transpose(y.path, x.path)
        found = array.values.astype(float)
        if quantity.is_code:
            names = maps.words_of(array)
            found[found < 0] = math.nan
        numbers[np.ix_(inside[y.path], inside[x.path])] = found
    header: dict[str, Any] = {
        "x": x.to_dict(),
        "y": y.to_dict(),
        "what": what,
        "label": words,
        "unit": quantity.unit,
        "classes": None,
    }
    if quantity.is_code:
        header["classes"] = [{"name": name, "text": class_text(name, what), "color": class_color(name, what)} for name in names]
    return header, numbers


def bounded(
    scenario: Scenario, x: Axis, y: Axis, what: str, limits: Limits
) -> tuple[Scenario, dict[str, np.ndarray], dict[str, np.ndarray]]:
    """Return the inputs of a map; refuse one that would take too long before anything is computed.

    Parameters
    ----------
    scenario : Scenario
    x, y : Axis
    what : str
    limits : Limits

    Returns
    -------
    base : Scenario
        With its number of events limited.
    inside, values : dict of str to ndarray
        By path: a mask of the cells with an allowed value, and these values.

    Raises
    ------
    ValueError
        If its contact is compliant, or both axes set the same quantity.
    TooMuch
        If it would take too long.
    """
    if isinstance(scenario.contact, Compliant):
        raise InputError(LAB["rigid_maps"])
    _, span = MAP_QUANTITIES[what]
    inside = {axis.path: _allowed(axis) for axis in (y, x)}
    base = within(scenario, limits)
    if isinstance(base.contact, Rigid) and base.contact.max_events > MAP_EVENTS:
        base = base.replace("contact.max_events", MAP_EVENTS)
    values = {axis.path: axis.middles()[inside[axis.path]] for axis in (y, x)}
    _bounded(base, x, y, values, span, limits)
    if pair := contradiction([y.path, x.path]):
        raise InputError(LAB["two_axes"].format(one=pair[0], other=pair[1]))
    return base, inside, values


def _allowed(axis: Axis) -> np.ndarray:
    """Return a mask of the cells of an axis with an allowed value."""
    try:
        allowed = RANGES[axis.path]
    except KeyError:
        return np.ones(axis.cells, bool)
    middles = axis.middles()
    return (middles >= allowed.least) & (middles <= allowed.most) | np.isin(middles, allowed.also)


def _bounded(base: Scenario, x: Axis, y: Axis, values: dict[str, np.ndarray], span: str, limits: Limits) -> None:
    """Refuse a map that would take too long, by its revolutions.

    Raises
    ------
    TooMuch
        If it would take too long.
    """
    down, across = np.meshgrid(values[y.path], values[x.path], indexing="ij")
    given: dict[str, Any] = {}
    for path, cells in ((y.path, down), (x.path, across)):
        if path == "start.speed":
            given.update(vx=cells, vy=0.0, omega=0.0)  # the rim's own speed is part of the estimate
        else:
            given[path.rpartition(".")[2]] = cells
    if span == "first_revolution":  # one revolution, and the flight after it
        speed = np.abs(given.get("vx", base.start.state(base.hoop).vx))
        with np.errstate(over="ignore"):  # a flight without gravity never ends
            flight = speed**2 / (10.0 * base.plane.gravity * base.hoop.radius + 1e-300)
        turns = 1.0 + np.minimum(flight, FLIGHT_TURNS)
        total = float(np.sum(np.broadcast_to(turns, down.shape)))
    else:
        known = {key: cells for key, cells in given.items() if key in COSTLY}
        each = turns_of(base, **known)
        if np.any(each > limits.turns):
            worst = float(np.max(each))
            raise TooMuch(LAB["cell_turns"].format(turns=worst, most=limits.turns))
        total = float(np.sum(np.broadcast_to(each, down.shape)))
    if total > limits.map_turns:
        raise TooMuch(LAB["map_turns"].format(cells=down.size, turns=total, most=limits.map_turns))
