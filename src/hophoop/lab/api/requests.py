"""Requests to the lab: one pydantic model per call, for the programming interface, its document and the widget."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Iterable, Mapping
from typing import Annotated, Any, TypeVar

from pydantic import AfterValidator, BeforeValidator, Field, ValidationError, WithJsonSchema
from pydantic_core import PydanticCustomError

from hophoop._version import __version__
from hophoop.lab.api import files
from hophoop.lab.api.limits import Limits, TooMuch
from hophoop.lab.api.motion_map import MAP_QUANTITIES, Axis
from hophoop.scenario import InputError, Scenario
from hophoop.scenario.base import Count, Frozen, Number, refuse
from hophoop.scenario.paths import contradiction
from hophoop.scenario.sentences import findings_sentence
from hophoop.vocabulary.sentences import LAB


def _among(names: Iterable[str]) -> Callable[[str], str]:
    known = tuple(names)

    def check(name: str) -> str:
        if name not in known:
            raise PydanticCustomError("value", LAB["one_of"], {"known": ", ".join(known)})
        return name

    return check


def not_one(samples: int) -> int:
    """Refuse a single state: equally spaced states include the start and the end."""
    if samples == 1:
        raise PydanticCustomError("value", "must be a whole number from 0 and not 1")
    return samples


def _pair(change: Any) -> Any:
    if not (isinstance(change, list | tuple) and len(change) == 2 and isinstance(change[0], str)):
        raise refuse(LAB["not_a_pair"].format(change=json.dumps(change)[:60]))
    return change


def _two(numbers: Any) -> Any:
    if not (isinstance(numbers, list | tuple) and len(numbers) == 2):
        raise PydanticCustomError("value", LAB["times"])
    return numbers


def _times(window: tuple[float, float]) -> tuple[float, float]:
    if not 0.0 <= window[0] < window[1]:
        raise PydanticCustomError("value", LAB["times"])
    return window


Quantity = Annotated[
    str,
    AfterValidator(_among(MAP_QUANTITIES)),
    WithJsonSchema({"type": "string", "enum": list(MAP_QUANTITIES)}),
]
FileName = Annotated[
    str,
    AfterValidator(_among(files.KINDS)),
    WithJsonSchema({"type": "string", "enum": list(files.KINDS)}),
]
Samples = Annotated[Count, Field(ge=0), AfterValidator(not_one)]
Change = Annotated[tuple[str, Any], BeforeValidator(_pair)]
Times = Annotated[tuple[Number, Number], BeforeValidator(_two), AfterValidator(_times)]


class ScenarioRequest(Frozen):
    """A scenario: its keys or its link, with other values at some paths."""

    scenario: Scenario = Field(default_factory=Scenario, description="The scenario; unknown keys are errors")
    query: str | None = Field(None, description="A scenario's link, such as plane.mu=0.5, instead of its keys")
    changes: tuple[Change, ...] = Field((), description="Pairs of path and value; the last one for a quantity counts")

    def asked(self) -> Scenario:
        """Return the scenario with its changes; of two changes of the same quantity, the later counts.

        Raises
        ------
        ValueError
            If a path is unknown or a value not allowed.
        """
        scenario = self.scenario if self.query is None else Scenario.from_query(self.query)
        values: dict[str, Any] = {}
        for path, value in self.changes:
            if contradiction([*values, path]):
                scenario, values = scenario.with_values(values), {}
            values[path] = value
        return scenario.with_values(values)

    def options(self) -> dict[str, Any]:
        """Return all options apart from the scenario, ready for JSON."""
        return self.model_dump(mode="json", by_alias=True, exclude={"scenario", "query", "changes"})

    def bounded(self, limits: Limits) -> None:
        """Refuse a request beyond the lab's limits.

        Raises
        ------
        TooMuch
            If it exceeds the limits.
        """
        if len(self.changes) > limits.changes:
            raise TooMuch(LAB["too_many_changes"].format(pairs=len(self.changes), most=limits.changes))


class SimulateRequest(ScenarioRequest):
    """Request for a motion with equally spaced states."""

    samples: Samples = Field(0, description="How many equally spaced states to add; 0 for none")

    def bounded(self, limits: Limits) -> None:
        """Refuse too many samples.

        Raises
        ------
        TooMuch
            If there are too many.
        """
        super().bounded(limits)
        if self.samples > limits.samples:
            raise TooMuch.of_field("samples", self.samples, f"at most {limits.samples} in the lab")


class MotionRequest(ScenarioRequest):
    """Request for a motion as the player shows it, or for a part of it."""

    window: Times | None = Field(None, description="Times from and to [s]; the whole motion by default")


class MapRequest(ScenarioRequest):
    """Request for a map over two parameters."""

    x: Axis = Field(description="The axis across")
    y: Axis = Field(description="The axis upwards")
    what: Quantity = Field("sequence", description="The mapped quantity")

    def bounded(self, limits: Limits) -> None:
        """Refuse equal axes and too many cells.

        Raises
        ------
        ValueError
            If both axes are the same parameter.
        TooMuch
            If there are too many cells.
        """
        super().bounded(limits)
        if self.x.path == self.y.path:
            raise InputError(LAB["equal_axes"].format(path=self.x.path))
        cells = self.x.cells * self.y.cells
        if cells > limits.cells:
            raise TooMuch(LAB["too_many_cells"].format(cells=cells, most=limits.cells))


class FileRequest(ScenarioRequest):
    """Request for a file of a motion."""

    name: FileName = Field(description="Which file")


Model = TypeVar("Model", bound=Frozen)


def validated(model: type[Model], body: Any) -> Model:
    """Return a request made from JSON.

    Parameters
    ----------
    model : type
        A model of this module.
    body : dict

    Returns
    -------
    request : Frozen

    Raises
    ------
    ValueError
        If the body is not valid for the call, in one sentence.
    """
    if not isinstance(body, Mapping):
        raise InputError(f"The body must be a JSON object, not {json.dumps(body)[:60]}.")
    try:
        return model.model_validate(body)
    except ValidationError as error:
        raise InputError(findings_sentence(error.errors(include_url=False))) from None


def tag_of(call: str, scenario: Scenario | None, options: Mapping[str, Any]) -> str:
    """Return a tag that is equal for equal requests to equal versions, however their scenario was written.

    Parameters
    ----------
    call : str
    scenario : Scenario or None
    options : dict

    Returns
    -------
    tag : str
    """
    query = None if scenario is None else scenario.to_query()
    text = json.dumps([__version__, call, query, options], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:32]
