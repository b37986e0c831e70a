"""Maps of motions over two parameters, as the page shows them."""

from __future__ import annotations

import math
import threading
from typing import Annotated, Any

import numpy as np
from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from hophoop import maps
from hophoop.lab.limits import Limits, TooMuch, within
from hophoop.maps.evaluate import CHUNK_CELLS
from hophoop.scenario import Compliant, InputError, Rigid, Scenario, parameter
from hophoop.scenario.base import Count, Frozen, Number, refuse
from hophoop.vocabulary.classes import class_color, class_text
from hophoop.vocabulary.sentences import LAB

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


def _number_path(path: str) -> str:
    try:
        known = parameter(path)
    except InputError as error:
        raise refuse(str(error)) from None
    if known.unit == "":
        raise PydanticCustomError("value", "must be a number's path, not that of a word")
    return path


class Axis(Frozen):
    """One axis of a map."""

    path: Annotated[str, AfterValidator(_number_path)] = Field(description="A parameter, such as plane.mu")
    low: Number = Field(alias="from", description="Where it starts, in SI units")
    high: Number = Field(alias="to", description="Where it ends, in SI units")
    cells: Annotated[Count, Field(ge=1, le=4096)] = Field(48, description="How many cells")

    def middles(self) -> np.ndarray:
        """The middle of each cell."""
        middles: np.ndarray = self.low + (np.arange(self.cells) + 0.5) * ((self.high - self.low) / self.cells)
        return middles

    def to_dict(self) -> dict[str, Any]:
        """As it was asked for."""
        return self.model_dump(by_alias=True)


def motion_map(scenario: Scenario, x: Axis, y: Axis, what: str, limits: Limits) -> tuple[dict[str, Any], np.ndarray]:
    """A map over two parameters; each value is that of a cell's middle.

    Raises
    ------
    ValueError
        If the axes do not go with the scenario.
    TooMuch
        If it would take too long.
    """
    if isinstance(scenario.contact, Compliant):
        raise InputError(LAB["rigid_maps"])
    words, span = MAP_QUANTITIES[what]
    cells = x.cells * y.cells
    if cells * scenario.duration > limits.map_seconds and span != "first_revolution":
        raise TooMuch(
            f"{cells} cells times duration = {scenario.duration:g} s is {cells * scenario.duration:.3g} s of "
            f"motion and must be at most {limits.map_seconds:.3g} s in the lab."
        )
    base = within(scenario, limits)
    if isinstance(base.contact, Rigid) and base.contact.max_events > MAP_EVENTS:
        base = base.replace("contact.max_events", MAP_EVENTS)
    values = {axis.path: axis.middles() for axis in (y, x)}
    with _one_at_a_time:
        dataset = maps.sweep(base, values, (what,), span, chunk_cells=CHUNK_CELLS)
    array = dataset[what].transpose(y.path, x.path)
    quantity = maps.QUANTITIES[what]
    header: dict[str, Any] = {
        "x": x.to_dict(),
        "y": y.to_dict(),
        "what": what,
        "label": words,
        "unit": quantity.unit,
        "classes": None,
    }
    numbers = array.values.astype(float)
    if quantity.is_code:
        names = maps.words_of(array)
        header["classes"] = [{"name": name, "text": class_text(name, what), "color": class_color(name, what)} for name in names]
        numbers[numbers < 0] = math.nan
    return header, numbers
