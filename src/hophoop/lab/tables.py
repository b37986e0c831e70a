"""Tables of Python's data for the page that computes in the browser, written to a file that its script is built with.

``python -m hophoop.lab.tables`` writes it, and Python's words into the page's English; a test fails if a file is out of date.
TypeScript checks it against the type `Tables` of web/types.d.ts.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final, Literal, get_args, get_origin

from pydantic.fields import FieldInfo

from hophoop._version import __version__
from hophoop.derivatives.results.sensitivity import EDGE, SIDED
from hophoop.kernel.model import EVENT_NAMES, MODE_LETTERS
from hophoop.kernel.records import Refusal
from hophoop.lab import limits
from hophoop.lab.limits import LAB
from hophoop.lab.presets import FIRST, presets
from hophoop.maps import QUANTITIES
from hophoop.plots import curves
from hophoop.results.save import SCHEMA
from hophoop.scenario import Compliant, Disk, Hoop, Plane, PointMass, Rigid, Ring, Rod, Scenario, Start
from hophoop.scenario.checking import RULES, TEXTS, Frozen, Number, Rule
from hophoop.scenario.models import LEFT_OUT
from hophoop.scenario.parts import TOUCH
from hophoop.scenario.paths import ENDS
from hophoop.simulation.simulate import simulate
from hophoop.vocabulary import colors, names
from hophoop.vocabulary.names import EVENTS, FATES, SIGNS, STATUSES, identifier, plain
from hophoop.vocabulary.parameters import RANGES, TABLE, Parameter, Range, section_of
from hophoop.vocabulary.quantities import COLUMNS

FILE: Final = Path(__file__).parent / "static" / "tables.json"
ENGLISH: Final = Path(__file__).parent / "words" / "en.json"

_PARTS = (Ring, Disk, PointMass, Rod)
LEAST_SPEED: Final = 1e-9  # critical speeds below this are not shown as speeds [m/s]
SAMPLES_PER_SECOND: Final = 200  # of the table of states that the page saves [1/s]
GRAVITIES = [
    ("Earth", 9.81),
    ("Moon", 1.62),
    ("Mars", 3.71),
    ("Jupiter", 24.79),
    ("Weightless", 0.0),
]

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

GROUPS = ("hoop", "plane", "start", "contact", "motion")
COLORS = ("GRAVITY_CENTER", "NORMAL_FORCE", "FRICTION_FORCE")
# Diagrams of the page, which has no column of the energy in a contact's spring.
CURVES: dict[str, tuple[curves.Curve, ...]] = {
    "velocities": curves.VELOCITIES,
    "energies": tuple(curve for curve in curves.ENERGIES if curve.field != "spring"),
    "forces": curves.FORCES,
    "utilization": curves.PANELS["utilization"][1],
}
# Sentences about paths that the page does not send; those about other problems are in one key.
UNSEEN: Final = {"two_ways", "no_section_parts", "not_there", "no_parameter", "other_problem", "other_problems"}
# Bounds that the page keeps as well.
LIMITS = ("DURATION", "EVENTS", "PARTS", "SAMPLES", "CELL_EVENTS")


def tables() -> dict[str, Any]:
    """Return everything, ready for JSON.

    Returns
    -------
    tables : dict
        Infinity is the word "inf", as in a scenario file.
    """
    return {
        "setup": _setup(),
        # of each preset, to compare with those of the page
        "fingerprints": {preset.key: simulate(preset.scenario).fingerprint for preset in presets()},
        "schema": SCHEMA,
        "scenario": _scenario(),
        # the sentences are in words/; here is how their values are written
        "texts": {name: _places(said) for name, said in TEXTS.items() if name not in UNSEEN},
        "words": {
            "letters": "".join(MODE_LETTERS),
            "modes": names.MODE_WORDS,
            "summed_up": [kind for kind in EVENT_NAMES if EVENTS[kind].summed_up],
            "signs": SIGNS,
            "least_speed": LEAST_SPEED,
        },
        "classes": {
            "codes": colors.CODES,
            "families": colors.FAMILIES,
            "massless": colors.MASSLESS,
            "hops": colors.HOPS,
            "rolls": colors.ROLLS,
            "other": colors.GRAY,
        },
        "map": {
            # values that a cell and a field may have
            "allowed": {path: _range(allowed) for path, allowed in RANGES.items()},
            "quantities": {
                name: {"span": span, "unit": QUANTITIES[name].unit, "words": QUANTITIES[name].words}
                for name, (_, span) in MAP_QUANTITIES.items()
            },
        },
        "lab": {name: _places(said) for name, said in LAB.items()},
        "limits": {name.lower(): getattr(limits, name) for name in LIMITS},
        "table": {"rate": SAMPLES_PER_SECOND, "variables": {name: quantity.unit for name, quantity in COLUMNS.items()}},
        "curves": {name: [{"field": curve.field, "color": curve.color} for curve in shown] for name, shown in CURVES.items()},
        # sliders whose values may follow from the scenario instead of being in it
        "shown": [row.path for row in TABLE if row.slider and section_of(row) in ("hoop", "plane", "start")],
    }


def english() -> dict[str, str | dict[str, str]]:
    """Return what the page says in words of Python's own, by their keys in words/en.json.

    Returns
    -------
    texts : dict
        A text, or one for each plural; {places} without the format of their values.
    """
    found: dict[str, str] = {
        **{f"mode.{word}": word for word in names.WORDS},
        **{f"verb.{word}": facts.verb for word, facts in names.WORDS.items()},
        **{f"event.{kind}": event.label for kind, event in EVENTS.items()},
        **{f"status.{status}": facts.sentence for status, facts in STATUSES.items() if facts.sentence},
        **{f"class.{word}": plain(word) for what in MAP_QUANTITIES for word in colors.CODES.get(what, ())},
        **{f"fate.{identifier(fate)}": facts.sentence for fate, facts in FATES.items()},
        "reason.edge": EDGE,
        "reason.sided": SIDED,
        **{f"quantity.{name}": label for name, (label, _) in MAP_QUANTITIES.items()},
        **{f"gravity.{name.lower()}": name for name, _ in GRAVITIES},
        **{f"refusal.{name}": text for name, text in TEXTS.items() if name not in UNSEEN},
        **{f"lab.{name}": text for name, text in LAB.items()},
    }
    for row in TABLE:
        if row.slider or row.choices:
            found |= {f"parameter.{row.path}": row.label, f"help.{row.path}": row.meaning}
        found |= {f"choice.{row.path}.{value}": label for value, label in row.choices}
        if row.axis:
            found[f"axis.{row.path}"] = row.axis.label or f"{row.label} {row.symbol}"
    for preset in presets():
        found |= {f"example.{preset.key}": preset.title, f"example.{preset.key}.text": preset.text}
    texts: dict[str, str | dict[str, str]] = {key: re.sub(r"\{(\w+)[^}]*\}", r"{\1}", text) for key, text in found.items()}
    texts["refusal.other_problems"] = {"one": TEXTS["other_problem"], "other": TEXTS["other_problems"]}
    return texts


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
        "rules": [_rule(RULES[code]) if code in RULES else None for code in Refusal],
        "touch": TOUCH,
        "default": _written(Scenario().to_dict()),
    }


def _fields(model: type[Frozen]) -> dict[str, dict[str, Any]]:
    return {name: _field(field) for name, field in model.model_fields.items()}


def _field(field: FieldInfo) -> dict[str, Any]:
    """Return what the page checks of a value: the kind of a number with its range, the words, or parts."""
    made: dict[str, Any] = {"kind": "section", "unit": ""}
    for mark in field.metadata:
        if isinstance(mark, Number):
            kind = "whole" if field.annotation is int else "friction" if mark.endless else "number"
            made = {"kind": kind, "unit": mark.unit} | ({"range": _range(mark.range)} if mark.range else {})
    for kind in (field.annotation, *get_args(field.annotation)):
        if kind is type(None):
            made["nullable"] = True
        elif get_origin(kind) is Literal:
            made |= {"kind": "word", "options": get_args(kind)}
        elif get_origin(kind) is tuple:
            made["kind"] = "parts"
    if field.is_required():
        made["required"] = True
    elif field.default_factory is None:
        made["default"] = _written(field.default)
    return made


def _places(template: str) -> str:
    """Return the places of a template, each with the format of its value."""
    return "".join(re.findall(r"\{[^}]*\}", template))


def _rule(rule: Rule) -> dict[str, Any]:
    """Return a rule; a range in its sentence is given by its ends."""
    known = {
        name: _range(value.range, value.unit) if isinstance(value, Number) and value.range else value
        for name, value in rule.known.items()
    }
    return _written({**rule._asdict(), "known": known})  # type: ignore[no-any-return]


def _range(allowed: Range, unit: str = "") -> dict[str, Any]:
    made: dict[str, Any] = {"least": allowed.least, "most": allowed.most}
    if unit not in ("", "1"):
        made["unit"] = unit
    if allowed.also:
        made["also"] = _written(list(allowed.also))
    return made


def _written(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _written(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_written(item) for item in value]
    return "inf" if value == math.inf else value


# --- controls ---------------------------------------------------------------------------------------


def _setup() -> dict[str, Any]:
    """Return what the page is built from: version, controls, presets, colours."""
    return {
        "version": __version__,
        "controls": _controls(),
        "map_quantities": list(MAP_QUANTITIES),
        "presets": [{"key": p.key, "query": p.scenario.to_query(), "more": k >= FIRST} for k, p in enumerate(presets())],
        "colors": {
            # by the letters of a hoop that rolls forward; each mode is shown with the letter of its word
            "modes": dict(zip(MODE_LETTERS, colors.MODES.values(), strict=True)),
            "mode_names": {letter: f"mode.{word}" for letter, word in zip(MODE_LETTERS, colors.MODES, strict=True)},
            "airborne": colors.GRAVITY_CENTER_AIRBORNE,
            **{name.lower(): getattr(colors, name) for name in COLORS},
        },
    }


def _controls() -> dict[str, Any]:
    """Return sliders with their ranges, choices and axes of maps; their paths are in the keys of `english`."""
    return {
        "groups": {group: [_slider(row) for row in TABLE if section_of(row) == group and row.slider] for group in GROUPS},
        "choices": [{"path": row.path, "options": [value for value, _ in row.choices]} for row in TABLE if row.choices],
        "gravities": [(f"gravity.{name.lower()}", value) for name, value in GRAVITIES],
        "map_axes": [_axis(row) for row in sorted((row for row in TABLE if row.axis), key=_rank)],
    }


def _slider(row: Parameter) -> dict[str, Any]:
    assert row.slider is not None
    low, high, step = row.slider
    return {
        "path": row.path,
        "symbol": row.symbol,
        "unit": _unit(row),
        "least": low,
        "most": high,
        "step": step,
    }


def _rank(row: Parameter) -> tuple[int, int]:
    # a map varies the start most often
    return ("start", "hoop", "plane").index(section_of(row)), row.axis.rank if row.axis else 0


def _axis(row: Parameter) -> dict[str, Any]:
    assert row.axis is not None
    assert row.range is not None
    least = min(row.range.least, 0.0) if 0.0 in row.range.also else row.range.least
    return {
        "path": row.path,
        "unit": _unit(row),
        "range": (row.axis.low, row.axis.high),
        "allowed": (least, row.range.most),
    }


def _unit(row: Parameter) -> str:
    return "°" if row.degrees else "" if row.unit == "1" else row.unit


# --- files ------------------------------------------------------------------------------------------


def text() -> str:
    """Return the content of the file.

    Returns
    -------
    text : str
        JSON.
    """
    return json.dumps(tables(), ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def words() -> str:
    """Return the page's English, with Python's own texts as they are now.

    Returns
    -------
    text : str
        JSON.
    """
    own = english()
    families = {key.partition(".")[0] for key in own}
    page = json.loads(ENGLISH.read_text(encoding="utf-8"))
    kept = {key: said for key, said in page.items() if key.partition(".")[0] not in families}
    return json.dumps(dict(sorted({**kept, **own}.items())), ensure_ascii=False, indent=2) + "\n"


if __name__ == "__main__":
    FILE.write_text(text(), encoding="utf-8")
    ENGLISH.write_text(words(), encoding="utf-8")
