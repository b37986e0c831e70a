"""TypeScript types of what Python sends to the page, from the models and from the dicts of the controls.

``python -m hophoop.lab.tables`` writes them to web/generated.d.ts; a test fails if the file is out of date.
"""

from __future__ import annotations

import typing
from collections.abc import Iterator, Mapping, Sequence
from enum import Enum
from pathlib import Path
from types import NoneType, UnionType
from typing import Annotated, Any, Final, Literal, NotRequired, Union, get_args, get_origin, is_typeddict

from hophoop.lab.api import replies
from hophoop.lab.site import controls, sent, setup
from hophoop.scenario import Compliant, Disk, Hoop, Plane, PointMass, Rigid, Ring, Rod, Start
from hophoop.scenario.base import Frozen
from hophoop.vocabulary.events import EventKind
from hophoop.vocabulary.modes import ModeLetter
from hophoop.vocabulary.statuses import MotionStatus

FILE: Final = Path(__file__).parents[4] / "web" / "generated.d.ts"

# Python's types and their names on the page.
_NAMES: Final[dict[type, str]] = {
    Ring: "RingPart",
    Disk: "DiskPart",
    PointMass: "PointMassPart",
    Rod: "RodPart",
    Hoop: "CheckedHoop",
    Plane: "CheckedPlane",
    Start: "CheckedStart",
    Rigid: "RigidContact",
    Compliant: "CompliantContact",
    controls.AllowedRange: "AllowedRange",
    controls.SliderInfo: "SliderInfo",
    controls.ChoiceInfo: "ChoiceInfo",
    controls.AxisInfo: "AxisInfo",
    controls.ControlsInfo: "ControlsInfo",
    setup.PresetInfo: "Preset",
    setup.Colors: "Colors",
    setup.Setup: "Setup",
    sent.RangeTable: "RangeTable",
    sent.FieldTable: "FieldTable",
    sent.ModelTable: "ModelTable",
    sent.RuleTable: "RuleTable",
    sent.ScenarioTable: "ScenarioTable",
    sent.WordsTable: "WordsTable",
    sent.ClassesTable: "ClassesTable",
    sent.MapQuantityTable: "MapQuantityTable",
    sent.MapTable: "MapTable",
    sent.LimitsTable: "LimitsTable",
    sent.SamplesTable: "SamplesTable",
    sent.Tables: "Tables",
    EventKind: "EventKind",
    ModeLetter: "ModeLetter",
    MotionStatus: "MotionStatus",
    replies.Velocities: "Velocities",
    replies.Impulse: "Impulse",
    replies.Event: "MotionEvent",
    replies.Final: "FinalState",
    sent.SentMotion: "SentMotion",
}
WIDTH: Final = 120  # of a line, as the page's formatter has it
_PLAIN: Final = {str: "string", bool: "boolean", int: "number", float: "number", NoneType: "null", Any: "any"}


def text() -> str:
    """Return the content of the file.

    Returns
    -------
    text : str
        TypeScript.
    """
    parts = [name for model, name in _NAMES.items() if model in (Ring, Disk, PointMass, Rod)]
    blocks = [
        "// Types of what Python sends, written by `python -m hophoop.lab.tables`.",
        f"type WholePart = {' | '.join(parts)};",
        *(_interface(model, name) for model, name in _NAMES.items()),
    ]
    return "\n\n".join(blocks) + "\n"


def _interface(model: Any, name: str) -> str:
    if issubclass(model, Enum):
        words = _options([member.value for member in model])
        line = f"type {name} = {words};"
        return line if len(line) <= WIDTH else line.replace(" = ", " =\n  | ").replace('" | "', '"\n  | "')
    fields = dict(_dict_fields(model) if is_typeddict(model) else _model_fields(model))
    return "\n".join((f"interface {name} {{", *(f"  {key}: {kind};" for key, kind in fields.items()), "}"))


def _dict_fields(model: Any) -> Iterator[tuple[str, str]]:
    for key, kind in typing.get_type_hints(model, include_extras=True).items():
        optional = get_origin(kind) is NotRequired
        yield f"{key}?" if optional else key, _type(get_args(kind)[0] if optional else kind)


def _model_fields(model: Any) -> Iterator[tuple[str, str]]:
    sparse = not issubclass(model, Frozen)  # an answer leaves out what has its default
    for key, field in model.model_fields.items():
        name = field.alias or key
        yield f"{name}?" if sparse and not field.is_required() else name, _type(field.annotation)


def _type(kind: Any) -> str:
    origin, arguments = get_origin(kind), get_args(kind)
    if kind in _PLAIN:
        return _PLAIN[kind]
    if origin is Annotated:
        return _type(arguments[0])
    if origin is Literal:
        return _options(arguments)
    if origin in (Union, UnionType):
        if all(one in _NAMES for one in arguments):
            return "WholePart"
        return " | ".join(_type(one) for one in arguments)
    if origin is tuple and arguments[-1] is not Ellipsis:
        return f"[{', '.join(_type(one) for one in arguments)}]"
    if origin in (tuple, list, Sequence):
        inner = _type(arguments[0])
        return f"({inner})[]" if " | " in inner else f"{inner}[]"
    if origin in (dict, Mapping):
        return f"Record<{_type(arguments[0])}, {_type(arguments[1])}>"
    return _NAMES[kind]


def _options(words: Sequence[Any]) -> str:
    return " | ".join(f'"{word}"' for word in words)
