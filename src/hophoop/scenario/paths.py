"""Parameters of a scenario by dotted path, such as ``plane.mu``: their meanings, and how to replace one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from hophoop._support.errors import InputError
from hophoop.scenario.checking import Frozen, near_name, say, unit_of
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
    section, _, key = path.rpartition(".")
    for model in _models(section):
        if key in model.model_fields:
            field = model.model_fields[key]
            return ParameterInfo(path, field.description or "", unit_of(field))
    if path == "duration":
        return ParameterInfo(path, PARAMETERS[path].meaning, PARAMETERS[path].unit)
    keys = [name for model in _SECTIONS.get(section, ()) for name in model.model_fields]
    close = near_name(key, keys or ["duration", *_SECTIONS], section) if path.count(".") < 2 else ""
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
    found = ["duration"]
    for section, models in _SECTIONS.items():
        for model in models:
            names = [name for name in model.model_fields if name not in ONWARD]
            found += [path for name in names if (path := f"{section}.{name}") not in found]
    return found


def _models(section: str) -> Sequence[type[Frozen]]:
    """Return the models that may be at a section, or at the place of a part."""
    return _PARTS if re.fullmatch(r"hoop\.parts\.\d+", section) else _SECTIONS.get(section, ())


def contradiction(given: Iterable[str]) -> tuple[str, str] | None:
    """Return two of the paths that contradict each other by giving one quantity in two ways.

    given: Paths of parameters that are given together.

    Examples
    --------
    >>> contradiction(["start.speed", "plane.mu", "start.vx"])
    ('start.speed', 'start.vx')
    """
    known = list(given)
    for path in known:
        section = path.partition(".")[0]
        ended = {f"{section}.{key}" for key in ENDS.get(path, ())}
        for other in known:
            # a section given together with one of its keys
            if any(other == end or other.startswith(f"{end}.") for end in ended):
                return path, other
    return None


def with_replaced(scenario: Scenario, values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keys of the scenario with other values at some paths, in any order, for validation.

    Whole sections come first, then their keys. If a value is given in another way than before, other quantities keep their
    values.
    """
    pair = contradiction(values)
    if pair is not None:
        one, other = pair
        given = {"one_value": values[one], "other_value": values[other]}
        raise InputError(say("two_ways", one=one, other=other, **given))
    data = scenario.to_dict()
    spelt_out: set[str] = set()
    for path in sorted(values, key=_rank):
        value = _keys(values[path])
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
        if section not in spelt_out and any(key in table for key in ENDS.get(path, ())):
            spelt_out.add(section)
            spelt = _spelt_out(_as_given(scenario, values, section), data, path)
            table.update({key: value for key, value in spelt.items() if f"{section}.{key}" not in values})
        for key in ENDS.get(path, ()):
            table.pop(key, None)
        _put(table, rest.split("."), value, path)
    return data


def _rank(path: str) -> tuple[int, int]:
    # an expanded start needs the new hoop; sections come before their keys
    section, _, rest = path.partition(".")
    return (section == "start", 0 if not rest else 1 if path in ("contact.model", "hoop.parts") else 2)


def _keys(value: Any) -> Any:
    """Return a value as a copy of its keys, which may be changed."""
    if isinstance(value, Frozen):
        return value.to_dict()
    if isinstance(value, Mapping):
        return {key: _keys(item) for key, item in value.items()}
    return [_keys(item) for item in value] if isinstance(value, list | tuple) else value


def _as_given(scenario: Scenario, values: Mapping[str, Any], section: str) -> Frozen:
    """Return a section before single values in it are replaced."""
    kept: Frozen = getattr(scenario, section)
    return type(kept).from_dict(values[section]) if section in values else kept


def _spelt_out(given: Frozen, data: Mapping[str, Any], path: str) -> dict[str, Any]:
    """Return the same section given in the other way, to keep the quantities that the path does not name."""
    if isinstance(given, Hoop) and path != "hoop.parts":
        kept = ("mass",) if path == "hoop.load_fraction" else ("mass", "eccentricity", "inertia_ratio")
        return {name: getattr(given, name) for name in kept}
    if isinstance(given, Plane) and path != "plane.mu":
        return {"mu_static": given.mu_static, "mu_kinetic": given.mu_kinetic}
    if isinstance(given, Start) and path != "start.speed":
        # a rolling start as the free start of the new hoop
        state = given.state(Hoop.from_dict(data["hoop"]))
        return {"height": state.height, "vx": state.vx, "vy": state.vy, "omega": state.omega}
    return {}


def _put(table: Any, steps: Sequence[str], value: Any, path: str) -> None:
    """Set a key below a section; all tables above it must exist."""
    *above, last = steps
    for step in above:
        table = table[_key(table, step, path)]
    table[_key(table, last, path, new=True)] = value


def _key(table: Any, step: str, path: str, new: bool = False) -> Any:
    """Return a step of a path as a key of a table, which may be a new one, or as an index of a list."""
    if isinstance(table, dict) and (new or step in table):
        return step
    if isinstance(table, list) and step.isdecimal() and int(step) < len(table):
        return int(step)
    raise InputError(say("not_there", path=path, step=step), field=path)
