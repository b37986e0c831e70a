"""Parameters of a scenario by dotted path, such as ``plane.mu``: their meanings, and how to replace one."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from hophoop._support.errors import InputError, shown
from hophoop.scenario.checking import Frozen, keys_of, near_name, say, unit_of
from hophoop.scenario.models import Compliant, Hoop, Plane, Rigid
from hophoop.scenario.parts import Disk, PointMass, Ring, Rod
from hophoop.scenario.start import Start
from hophoop.vocabulary.parameters import PARAMETERS

if TYPE_CHECKING:
    from hophoop.scenario.scenario import Scenario

_SECTIONS: dict[str, tuple[type[Frozen], ...]] = {
    "hoop": (Hoop,),
    "plane": (Plane,),
    "start": (Start,),
    "contact": (Rigid, Compliant),
}
_PARTS = (Ring, Disk, PointMass, Rod)

ONWARD = ("slip", "mode")  # of a start that goes on from another motion

# Keys that a path replaces, where a quantity can be given in several ways.
ENDS: dict[str, Sequence[str]] = {
    "hoop.load_fraction": ("eccentricity", "inertia_ratio", "parts"),
    "hoop.eccentricity": ("load_fraction", "parts"),
    "hoop.inertia_ratio": ("load_fraction", "parts"),
    "hoop.parts": ("load_fraction", "eccentricity", "inertia_ratio", "mass"),
    "plane.mu": ("mu_static", "mu_kinetic"),
    "plane.mu_static": ("mu",),
    "plane.mu_kinetic": ("mu",),
    "start.speed": ("height", "vx", "vy", "omega", *ONWARD),
    "start.height": ("speed", "mode"),
    "start.vx": ("speed", *ONWARD),
    "start.vy": ("speed", "mode"),
    "start.omega": ("speed", *ONWARD),
    "contact.damping": ("restitution",),
    "contact.restitution": ("damping",),
}


class ParameterInfo(NamedTuple):
    """Meaning and unit of a path.

    Attributes
    ----------
    path : str
        Such as ``"plane.mu"``.
    description : str
        Its meaning, in a few words.
    unit : str
        Its unit; "1" for a pure number, "" for a word.
    """

    path: str
    description: str
    unit: str


def parameter(path: str) -> ParameterInfo:
    """Return meaning and unit of a scenario's parameter.

    Parameters
    ----------
    path : str
        Such as ``"plane.mu"``, ``"duration"`` or ``"hoop.parts.0.mass"``.

    Returns
    -------
    parameter : ParameterInfo
        path, description and unit; the unit is "1" for a pure number and "" for a word.

    Raises
    ------
    ValueError
        If a scenario has no such parameter.

    Examples
    --------
    >>> parameter("start.speed").unit
    'm/s'
    """
    if path == "duration":
        return ParameterInfo(path, PARAMETERS[path].meaning, PARAMETERS[path].unit)
    section, _, key = path.rpartition(".")
    models = _PARTS if re.fullmatch(r"hoop\.parts\.\d+", section) else _SECTIONS.get(section, ())
    # of a key that several have, the first one says the meaning
    fields = {name: field for model in reversed(models) for name, field in model.model_fields.items()}
    if key in fields:
        return ParameterInfo(path, fields[key].description or "", unit_of(fields[key]))
    close = near_name(key, list(fields) or ["duration", *_SECTIONS], section and f"{section}.") if path.count(".") < 2 else ""
    if close and close not in _SECTIONS:
        raise InputError(say("unknown_key", path=path, hint=say("did_you_mean", close=close)), field=path)
    raise InputError(say("no_parameter", path=path, known=", ".join(paths())), field=path)


def paths() -> list[str]:
    """Return the paths of all numbers and words in a scenario, without a hoop's parts and a start that goes on.

    Returns
    -------
    paths : list of str
        In the order of a scenario file.
    """
    found = dict.fromkeys(
        f"{section}.{name}"
        for section, models in _SECTIONS.items()
        for model in models
        for name in model.model_fields
        if name not in ONWARD
    )
    return ["duration", *found]


def contradiction(given: Collection[str]) -> tuple[str, str] | None:
    """Return two of the paths that contradict each other by giving one quantity in two ways.

    given: Paths of parameters that are given together.

    Examples
    --------
    >>> contradiction(["start.speed", "plane.mu", "start.vx"])
    ('start.speed', 'start.vx')
    """
    for path in given:
        section = path.partition(".")[0]
        ended = tuple(f"{section}.{key}." for key in ENDS.get(path, ()))
        for other in given:
            if f"{other}.".startswith(ended):  # or something in it
                return path, other
    return None


def with_replaced(scenario: Scenario, values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keys of the scenario with other values at some paths, in any order, for validation.

    Whole sections come first, then their keys. If a value is given in another way than before, other quantities keep their
    values.
    """
    if pair := contradiction(values):
        one, other = pair
        raise InputError(say("two_ways", one=one, one_value=shown(values[one]), other=other, other_value=shown(values[other])))
    data = scenario.to_dict()
    for path in sorted(values, key=_rank):
        value = keys_of(values[path])
        section, _, rest = path.partition(".")
        if not rest:
            data[section] = value
            continue
        if path == "contact.model":
            # the two models have few keys in common
            data["contact"] = {"model": value}
            continue
        table = data.setdefault(section, {})
        if not isinstance(table, dict):
            raise InputError(say("no_section_parts", path=path, section=section), field=path)
        ended = ENDS.get(path, ())
        if any(key in table for key in ended):
            given = getattr(scenario, section)
            if section in values:
                given = type(given).from_dict(values[section])
            table |= {key: kept for key, kept in _spelt_out(given, data, path).items() if f"{section}.{key}" not in values}
        for key in ended:
            table.pop(key, None)
        _put(table, rest.split("."), value, path)
    return data


def _rank(path: str) -> tuple[int, int]:
    # an expanded start needs the new hoop; sections come before their keys
    section, _, rest = path.partition(".")
    return (section == "start", 0 if not rest else 1 if path in ("contact.model", "hoop.parts") else 2)


def _spelt_out(given: Any, data: Mapping[str, Any], path: str) -> dict[str, Any]:
    """Return the same section given in the other way, to keep the quantities that the path does not name."""
    names: Sequence[str] = ()
    if isinstance(given, Hoop) and path != "hoop.parts":
        names = ("mass",) if path == "hoop.load_fraction" else ("mass", "eccentricity", "inertia_ratio")
    elif isinstance(given, Plane) and path != "plane.mu":
        names = ("mu_static", "mu_kinetic")
    elif isinstance(given, Start) and path != "start.speed":
        # a rolling start as the free start of the new hoop
        given = given.state(Hoop.from_dict(data["hoop"]))
        names = ("height", "vx", "vy", "omega")
    return {name: getattr(given, name) for name in names}


def _put(table: Any, steps: Sequence[Any], value: Any, path: str) -> None:
    """Set a key below a section; all tables above it must exist."""
    step, *rest = steps
    if isinstance(table, list) and step.isdecimal() and int(step) < len(table):
        step = int(step)
    elif not isinstance(table, dict) or (rest and step not in table):
        raise InputError(say("not_there", path=path, step=step), field=path)
    if rest:
        _put(table[step], rest, value, path)
    else:
        table[step] = value
