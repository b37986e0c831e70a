"""Tables of Python's data for the page that computes in the browser, written to a file that its script is built with.

``python -m hophoop.lab.tables`` writes it, and the page's types of it; a test fails if a file is out of date.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from pathlib import Path
from types import UnionType
from typing import Annotated, Any, Final, Literal, Union, get_args, get_origin

from pydantic import AfterValidator, BeforeValidator
from pydantic.fields import FieldInfo

from hophoop.derivatives.layout import REASONS
from hophoop.derivatives.results.sensitivity import EDGE, SIDED
from hophoop.kernel.records.refusal import Refusal
from hophoop.lab.api.files import SAMPLES_PER_SECOND
from hophoop.lab.api.limits import USUAL
from hophoop.lab.api.motion_map import FLIGHT_TURNS, MAP_EVENTS, MAP_QUANTITIES
from hophoop.lab.site import typescript
from hophoop.lab.site.presets import presets
from hophoop.lab.site.setup import setup
from hophoop.maps import QUANTITIES
from hophoop.results.save import SCHEMA
from hophoop.scenario import Compliant, Disk, Hoop, Plane, PointMass, Rigid, Ring, Rod, Scenario, Start, base
from hophoop.scenario.base import Frozen
from hophoop.scenario.models import LEFT_OUT
from hophoop.scenario.parts import TOUCH
from hophoop.scenario.paths import ENDS
from hophoop.scenario.ranges import RANGES, Inside
from hophoop.scenario.rules import RULES
from hophoop.scenario.texts import TEXTS
from hophoop.simulation.simulate import simulate
from hophoop.vocabulary import classes, colors, modes
from hophoop.vocabulary.events import EVENTS, SIGNS
from hophoop.vocabulary.parameters import TABLE, Range, section_of
from hophoop.vocabulary.quantities import COLUMNS
from hophoop.vocabulary.sentences import LAB, LEAST_SPEED, STORY, SUMMARY, THEORY
from hophoop.vocabulary.statuses import STATUSES

FILE: Final = Path(__file__).parent / "static" / "tables.json"

_KINDS = {base._number: "number", base._friction: "friction", base._whole: "whole"}
# Attributes of an annotation, and pydantic's names of the corresponding errors.
_LIMITS = {"gt": "greater_than", "ge": "greater_than_equal", "lt": "less_than", "le": "less_than_equal"}
_PARTS = (Ring, Disk, PointMass, Rod)
_BOUNDS = ("duration", "events", "parts", "samples", "cells", "turns", "map_turns", "steps", "changes")


def tables() -> dict[str, Any]:
    """Return everything, ready for JSON.

    Returns
    -------
    tables : dict
        Infinity is the word "inf", as in a scenario file.
    """
    found: dict[str, Any] = {
        "setup": setup(),
        # of each preset, to compare with those of the page
        "fingerprints": {preset.key: _fingerprint(preset.scenario) for preset in presets()},
        "schema": SCHEMA,
        "scenario": _scenario(),
        "texts": TEXTS,
        "words": {
            "letters": "".join(modes.MODE_LETTERS),
            "modes": modes.MODE_WORDS,
            "verbs": modes.VERBS,
            "events": {
                kind: {"verb": event.verb, "label": event.label, "summed_up": event.summed_up} for kind, event in EVENTS.items()
            },
            "signs": SIGNS,
            "statuses": {status: facts.sentence for status, facts in STATUSES.items()},
            "sequence": modes.LETTERS,
            "story": STORY,
            "summary": SUMMARY,
            "theory": THEORY,
            "least_speed": LEAST_SPEED,
        },
        "classes": {
            "codes": classes.CODES,
            "families": classes.FAMILIES,
            "massless": classes.MASSLESS,
            "hops": classes.HOPS,
            "rolls": classes.ROLLS,
        }
        | {"other": colors.GRAY},
        "map": {
            "events": MAP_EVENTS,
            "flight_turns": FLIGHT_TURNS,
            # values that a cell may have
            "allowed": {path: _range(allowed) for path, allowed in RANGES.items()},
            # the columns of a cell that change by as much as a parameter of which a motion has derivatives
            "rates": {row.path: row.column for row in TABLE if row.derivative and row.column},
            "quantities": {
                name: {"label": label, "span": span, "unit": QUANTITIES[name].unit, "words": QUANTITIES[name].words}
                for name, (label, span) in MAP_QUANTITIES.items()
            },
        },
        "lab": LAB,
        # reasons for a missing derivative, by the module's names; and the reason for a one-sided one
        "reasons": {reason.name.lower(): text for reason, text in REASONS.items()} | {"edge": EDGE, "sided": SIDED},
        "limits": {name: getattr(USUAL, name) for name in _BOUNDS},
        "table": {"rate": SAMPLES_PER_SECOND, "variables": {name: quantity.unit for name, quantity in COLUMNS.items()}},
        # sliders whose values may follow from the scenario instead of being in it
        "shown": [row.path for row in TABLE if row.slider and section_of(row) in ("hoop", "plane", "start")],
    }
    return found


def _fingerprint(scenario: Scenario) -> str | None:
    """Return the fingerprint of the motion; None if double precision does not decide it, as on the page."""
    motion = simulate(scenario)
    return motion.fingerprint if motion.doubt == math.inf else None


def _scenario() -> dict[str, Any]:
    """Return the checks of a scenario: models with their fields and the constraints between them."""
    sections: dict[str, list[type[Frozen]]] = {
        "hoop": [Hoop],
        "plane": [Plane],
        "start": [Start],
        "contact": [Rigid, Compliant],
    }
    described = (Scenario, Hoop, Plane, Start, Rigid, Compliant, *_PARTS)
    return {
        "sections": {name: [model.__name__ for model in models] for name, models in sections.items()},
        "models": {model.__name__: {"place": model.place, "fields": _fields(model)} for model in described},
        "parts": {_fields(model)["shape"]["default"]: model.__name__ for model in _PARTS},
        "ends": ENDS,
        # keys of the plane that are not written where they have their default
        "left_out": LEFT_OUT,
        # by the codes of the kernel's refusals
        "rules": [_written(RULES[code]._asdict()) if code in RULES else None for code in Refusal],
        "touch": TOUCH,
        "default": _written(Scenario().to_dict()),
    }


def _fields(model: type[Frozen]) -> dict[str, dict[str, Any]]:
    return {field.alias or name: _field(field) for name, field in model.model_fields.items()}


def _field(field: FieldInfo) -> dict[str, Any]:
    kind, metadata, nullable = _taken_apart(field.annotation, list(field.metadata))
    extra = field.json_schema_extra
    made: dict[str, Any] = {"kind": "section", "unit": str(extra.get("unit", "1")) if isinstance(extra, dict) else ""}
    if nullable:
        made["nullable"] = True
    if field.is_required():
        made["required"] = True
    elif field.default_factory is None:
        made["default"] = _written(field.default)
    for item in metadata:
        if isinstance(item, BeforeValidator) and item.func in _KINDS:
            made["kind"] = _KINDS[item.func]
        elif isinstance(item, AfterValidator) and isinstance(inside := getattr(item.func, "__self__", None), Inside):
            made["range"] = _range(inside.allowed, inside.unit)
        else:
            found = [[name, float(getattr(item, key))] for key, name in _LIMITS.items() if hasattr(item, key)]
            if found:
                made.setdefault("limits", []).extend(found)
    if get_origin(kind) is Literal:
        options = get_args(kind)
        quoted = [repr(option) for option in options]
        said = " or ".join(part for part in (", ".join(quoted[:-1]), quoted[-1]) if part)
        made.update(kind="word", options=options, expected=said)
    elif get_origin(kind) is tuple:
        made["kind"] = "parts"
    return made


def _taken_apart(annotation: Any, metadata: list[Any]) -> tuple[Any, list[Any], bool]:
    """Return the plain type, its annotations from the inside out, and whether None is allowed."""
    nullable = False
    while True:
        if get_origin(annotation) is Annotated:
            annotation, *added = get_args(annotation)
            # a field in an annotation means its limits
            inner = [part for item in added for part in (item.metadata if isinstance(item, FieldInfo) else [item])]
            metadata = [*inner, *metadata]
        elif get_origin(annotation) in (Union, UnionType) and type(None) in get_args(annotation):
            nullable = True
            (annotation,) = (one for one in get_args(annotation) if one is not type(None))
        else:
            return annotation, metadata, nullable


def _range(allowed: Range, unit: str = "") -> dict[str, Any]:
    made = {"least": allowed.least, "most": allowed.most, "words": allowed.words(unit)}
    return made | ({"also": _written(list(allowed.also))} if allowed.also else {})


def _written(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _written(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_written(item) for item in value]
    return "inf" if value == math.inf else value


def text() -> str:
    """Return the content of the file.

    Returns
    -------
    text : str
        JSON.
    """
    return json.dumps(tables(), ensure_ascii=False, allow_nan=False, indent=1) + "\n"


if __name__ == "__main__":
    FILE.write_text(text(), encoding="utf-8")
    typescript.FILE.write_text(typescript.text(), encoding="utf-8")
