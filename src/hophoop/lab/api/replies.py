"""Answers of the programming interface as pydantic models, for its OpenAPI document; tests compare answers with them.

The answers themselves come from `hophoop.lab.api.calls`.
"""

from __future__ import annotations

from typing import Any, Literal

from pydantic import BaseModel, ConfigDict, Field

from hophoop.vocabulary.events import EventKind
from hophoop.vocabulary.modes import ModeLetter
from hophoop.vocabulary.quantities import QUANTITIES
from hophoop.vocabulary.statuses import MotionStatus


def _number(name: str, **default: Any) -> Any:
    """Return a field that holds a quantity of a motion."""
    quantity = QUANTITIES[name]
    return Field(**default, description=f"{quantity.meaning} [{quantity.unit}]")


class MotionState(BaseModel):
    """State of a motion."""

    model_config = ConfigDict(extra="forbid", populate_by_name=True)

    t: float = _number("t")
    x: float = _number("x")
    height: float = _number("height")
    angle: float = _number("angle")
    vx: float = _number("vx")
    vy: float = _number("vy")
    omega: float = _number("omega")


class Final(MotionState):
    """State at the end."""

    mode: ModeLetter = Field(description="Letter of the mode")


class Velocities(BaseModel):
    """Velocities just before an event."""

    vx: float | None = _number("vx")
    vy: float | None = _number("vy")
    omega: float | None = _number("omega")


class Impulse(BaseModel):
    """Impulse of an impact, else zeros."""

    normal: float | None = _number("impulse_normal")
    tangential: float | None = _number("impulse_tangential")


class Event(MotionState):
    """An event with the state just after it."""

    kind: EventKind = Field(description="Kind of event")
    from_mode: ModeLetter | None = Field(alias="from", description="Letter of the mode before")
    to_mode: ModeLetter = Field(alias="to", description="Letter of the mode after")
    before: Velocities
    impulse: Impulse
    collision: bool = Field(True, description="False for an impact without collision")
    gain: float | None = _number("gain", default=None)
    stable: bool | None = Field(None, description="Of a rest: whether the equilibrium is stable")


class Result(BaseModel):
    """A motion: events with the states just after them, final state, energies; SI units, radians."""

    schema_name: Literal["hophoop/1"] = Field(alias="schema")
    version: str
    scenario: dict[str, Any] = Field(description="As it was asked for")
    status: MotionStatus
    sequence: str = Field(description="One letter per phase: R roll, S spin, K skid, H flight, M skim")
    fingerprint: str = Field(description="First 16 hexadecimal digits of the SHA-256 of the bits of all events")
    events: list[Event]
    final: Final
    energy: dict[str, float | None] = Field(description="Kinetic, potential and lost energies [J]")
    samples: dict[str, Any] | None = Field(None, description="Name → values at equally spaced times")


class Theory(BaseModel):
    """Thresholds and closed forms of theory for a hoop, as from `hophoop theory --json`; SI units, radians."""

    schema_name: Literal["hophoop-theory/1"] = Field(alias="schema")
    version: str
    scenario: dict[str, Any] = Field(description="As it was asked for")
    theory: dict[str, float | Literal["inf", "-inf"] | None] = Field(description="Quantity → value; null without a value")
    notes: dict[str, str] = Field(description="Quantity → remark, such as why it has no value")


class MapClass(BaseModel):
    """One class of motions of a map."""

    name: str
    text: str
    color: str


class AxisReply(BaseModel):
    """One axis of a map, as it was requested."""

    path: str
    low: float = Field(alias="from")
    high: float = Field(alias="to")
    cells: int


class Map(BaseModel):
    """A map: a row of values for each cell of y; for classes, indices into `classes`."""

    x: AxisReply
    y: AxisReply
    what: str
    label: str
    unit: str
    classes: list[MapClass] | None
    values: list[list[float | None]]


class Error(BaseModel):
    """An error."""

    detail: str = Field(description="One sentence: what is wrong and what is allowed")
    extra: str | None = Field(None, description="The extra of hophoop to install, with status 501")


class Health(BaseModel):
    """The server's answer that it is running."""

    status: Literal["ok"]
    version: str


_MEANINGS = {
    404: "There is no such file",
    413: "The request exceeds the lab's limits",
    422: "Bad input",
    415: "The body is not JSON",
    501: "A package for this file is not installed on the server",
    503: "The lab is busy; Retry-After says when to try again",
}


def responses(*codes: int) -> dict[int | str, dict[str, Any]]:
    """Return the error responses, as FastAPI documents them.

    Parameters
    ----------
    codes : int
        HTTP statuses [1].

    Returns
    -------
    responses : dict
    """
    tagged = {"ETag": {"schema": {"type": "string"}, "description": "Equal for equal requests"}}
    found: dict[int | str, dict[str, Any]] = {code: {"model": Error, "description": _MEANINGS[code]} for code in codes}
    return {200: {"headers": tagged}, 304: {"description": "Not modified: the ETag is known"}, **found}
