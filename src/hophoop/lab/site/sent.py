"""Shapes of the tables that the page is built with, and of the results that Python sends it.

`lab.site.typescript` makes the page's types from them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal, NotRequired, TypedDict

from hophoop.lab.api.replies import Event, Final
from hophoop.lab.site.setup import Setup
from hophoop.vocabulary.events import EventKind
from hophoop.vocabulary.statuses import MotionStatus

FieldKind = Literal["number", "friction", "whole", "word", "parts", "section"]


class RangeTable(TypedDict):
    """The values that a number may have."""

    least: float
    most: float
    unit: NotRequired[str]
    also: NotRequired[list[float | Literal["inf"]]]


class FieldTable(TypedDict):
    """A field of a model."""

    kind: FieldKind
    unit: str
    nullable: NotRequired[bool]
    required: NotRequired[bool]
    default: NotRequired[Any]
    limits: NotRequired[list[tuple[str, float]]]
    range: NotRequired[RangeTable]
    options: NotRequired[Sequence[str]]


class ModelTable(TypedDict):
    """A model of a scenario."""

    place: str
    fields: dict[str, FieldTable]


class RuleTable(TypedDict):
    """A rule between fields: its sentence, and what fills it."""

    sentence: str
    values: dict[str, str]
    known: dict[str, Any]
    number: str


class ScenarioTable(TypedDict):
    """The checks of a scenario."""

    sections: dict[str, list[str]]
    models: dict[str, ModelTable]
    parts: dict[str, str]
    ends: Mapping[str, Sequence[str]]
    left_out: Mapping[str, Any]
    rules: list[RuleTable | None]
    touch: float
    default: dict[str, Any]


class WordsTable(TypedDict):
    """What the words of a motion depend on."""

    letters: str
    modes: Sequence[str]
    summed_up: list[EventKind]
    signs: Mapping[str, str]
    least_speed: float


class ClassesTable(TypedDict):
    """The colours of classes of motions."""

    codes: Mapping[str, Mapping[str, str]]
    families: Mapping[str, str]
    massless: Mapping[str, str]
    hops: str
    rolls: str
    other: str


class MapQuantityTable(TypedDict):
    """A quantity that a map shows."""

    span: str
    unit: str
    words: Sequence[str]


class MapTable(TypedDict):
    """What maps and derivatives need of the parameters."""

    events: int
    flight_turns: float
    allowed: dict[str, RangeTable]
    rates: dict[str, str]
    quantities: dict[str, MapQuantityTable]


class LimitsTable(TypedDict):
    """The bounds of one request, as in `lab.api.limits.Limits`."""

    duration: float
    events: int
    parts: int
    samples: int
    cells: int
    turns: float
    map_turns: float
    steps: float
    changes: int
    film: float


class SamplesTable(TypedDict):
    """The table of states."""

    rate: float
    variables: dict[str, str]


class Tables(TypedDict):
    """Everything in tables.json."""

    setup: Setup
    fingerprints: dict[str, str | None]
    schema: str
    scenario: ScenarioTable
    texts: dict[str, str]
    words: WordsTable
    classes: ClassesTable
    map: MapTable
    lab: dict[str, str]
    limits: LimitsTable
    table: SamplesTable
    shown: list[str]


class SentMotion(TypedDict):
    """The header of a motion that Python computes for the page: `lab.api.motion.result`."""

    status: MotionStatus
    sequence: str
    fingerprint: str
    events: list[Event]
    final: Final
    energy: dict[str, float]
    query: str
    duration: float
    turning: dict[str, float]
