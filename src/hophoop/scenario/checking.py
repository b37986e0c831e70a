"""What a scenario may be: the check of every number, the rules between fields, and the sentences that refuse.

A number is checked by the `Number` of its field, a rule between fields by `kernel.records.refusals`. Python and the page fill
the sentences.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from operator import attrgetter
from typing import Any, ClassVar, Final, NamedTuple, Self, get_args

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator
from pydantic.fields import FieldInfo
from pydantic_core import PydanticCustomError, core_schema

from hophoop._support.errors import InputError, plain, shortened, shown
from hophoop.kernel.model import MOST_DEPTH, MOST_HEIGHT, MOST_SPEED
from hophoop.kernel.records import Refusal
from hophoop.vocabulary.parameters import PARAMETERS, RANGES, RELATIVE_SLIP_SPEED, RELATIVE_STIFFNESS, TABLE, Range, section_of

TEXTS: Final[dict[str, str]] = {
    # keys
    "unknown_key": "{path} is not a known key; {hint}",
    "did_you_mean": "did you mean {close}?",
    "known_are": "known are {known}.",
    "missing": "{path} is missing.",
    "together": "{section}.{other} cannot be given together with {section}.{way}.",
    # one value: the field, how it was given, what is allowed
    "finding": "{path} = {shown} {allowed}.",
    "number": "must be a number",
    "whole": "must be a whole number",
    "finite_number": "must be a finite number",
    "range": "must be {words}",
    "literal_error": "must be {expected}",
    "table": "must be a table of keys",
    "list": "must be a list",
    "word": "must be a word",
    "other_problem": "{first} (and {count} more problem).",
    "other_problems": "{first} (and {count} more problems).",
    "whole_scenario": "the scenario",
    # the hoop
    "no_parts": "hoop.parts must not be empty.",
    "half_a_hoop": "hoop.{missing} is missing: hoop.{given} does not define a hoop without it.",
    "massless_eccentricity": (
        "hoop.inertia_ratio = 0 needs hoop.eccentricity = 1 (all mass in a point on the rim), not {eccentricity!r}."
    ),
    "hoop_mass": "hoop.parts give hoop.mass = {mass!r}, which must be {words}.",
    "parts_center": "hoop.parts give hoop.eccentricity = {eccentricity!r}, which must be at most 1.",
    "parts_inertia": "hoop.parts give hoop.inertia_ratio = {inertia_ratio!r}, which must be {words}.",
    "load_inertia": (
        "hoop.load_fraction = {load_fraction!r} gives hoop.inertia_ratio = {inertia_ratio!r}, which must be {words}."
    ),
    "ring_radii": "ring.inner_radius = {inner!r} must not exceed ring.outer_radius = {outer!r}.",
    "beyond_the_rim": (
        "hoop.parts.{index} ({shape}) reaches {reach!r} m from the centre, beyond the rim: hoop.radius = {radius!r}."
    ),
    # plane and start
    "kinetic_above_static": "plane.mu_kinetic = {mu_kinetic!r} must not exceed plane.mu_static = {mu_static!r}.",
    "vertical": "plane.slope = {slope!r} must lie between -pi/2 and pi/2 (radians).",
    "slope": "plane.slope = {slope!r} must be {words}.",
    "no_omega": "start.omega = None must be a number.",
    # what must go together
    "massless_slope": "plane.slope = {slope!r} must be 0 for the massless hoop (hoop.inertia_ratio = 0).",
    "massless_resistance": ("plane.rolling_resistance = {given!r} must be 0 for the massless hoop (hoop.inertia_ratio = 0)."),
    "resistance": (
        "plane.rolling_resistance = {given!r} must be below {most:.6g} for this hoop, whose inertia about the contact "
        "it would cancel at some angle."
    ),
    "massless_compliant": ("contact.model = 'compliant' must be 'rigid' for the massless hoop (hoop.inertia_ratio = 0)."),
    "compliant_friction": "plane.mu_static = inf must be finite with contact.model = 'compliant'.",
    "relative_contact": "contact.{name} = {value!r} is {relative:.3g} {unit} of this hoop and must be {words} of it.",
    "too_soft": (
        "contact.stiffness = {stiffness!r} lets the rim sink some {depth:.0e} radii into the plane, at the speed "
        "of the start, and must be high enough for at most {most:g}."
    ),
    "too_fast": "start has a speed of {speed:.3g} √(g R), with R of the hoop, and must have at most {most:g} √(g R).",
    "too_high": "start.height = {height!r} is {relative:.3g} radii of this hoop and must be at most {most:g} radii.",
    # paths
    "no_parameter": "{path} is not a parameter of a scenario; known are {known}.",
    "no_section_parts": "{path} is not a parameter of a scenario: {section} has no parts.",
    "two_ways": "{one} = {one_value} and {other} = {other_value} cannot be given together.",
    "not_there": "{path} is not there to be replaced: the scenario has no {step!r}.",
    # links
    "unreadable_query": "The query cannot be read: {reason}.",
    "value_above": "{path} cannot be given together with a value for {above}.",
    "given_twice": "{path} is given twice.",
    "parts_out_of_order": "hoop.parts.{name} is out of order: parts are numbered from 0 without a gap.",
}
"""By a stable name."""


def say(name: str, /, **values: Any) -> str:
    """Return a sentence with its values.

    name: A key of `TEXTS`; **values: Values of its braces.

    Examples
    --------
    >>> say("given_twice", path="plane.mu")
    'plane.mu is given twice.'
    """
    return TEXTS[name].format(**values)


# --- numbers ----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Number:
    """What a number of a scenario may be; the mark of its field, which checks it.

    Attributes
    ----------
    range : Range or None
        None for any finite number.
    unit : str
        "1" for a pure number.
    """

    range: Range | None
    unit: str

    @property
    def words(self) -> str:
        """The range in words."""
        return self.range.words(self.unit) if self.range else ""

    @property
    def endless(self) -> bool:
        """Whether it may be infinite."""
        return self.range is not None and math.inf in self.range.also

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        checked = self.whole if int in (source, *get_args(source)) else self.checked
        return core_schema.no_info_before_validator_function(checked, handler(source))

    def checked(self, value: Any) -> Any:
        """Return a value as a number in the range, None for one that is not given.

        value: a number of Python or NumPy, or the word "inf" where it may be infinite; number: never −0.
        """
        if value is None:
            return None  # pydantic refuses it where the field's type does
        number = math.inf if self.endless and isinstance(value, str) and value == "inf" else _number(value)
        if not (math.isfinite(number) or self.endless):
            raise _wrong("finite_number")
        if self.range is not None and not self.range.holds(number):
            raise _wrong("range", words=self.words)
        return number

    def whole(self, value: Any) -> int | None:
        """Return a value as an integer in the range."""
        if value is None:
            return None
        if not _number(value).is_integer():
            raise _wrong("whole")
        return int(self.checked(value))


def _number(value: Any) -> float:
    """Return a scalar of Python or NumPy as a float; booleans and texts are refused."""
    if getattr(value, "ndim", 0) or not hasattr(value, "__float__") or isinstance(value, bool | np.bool_):
        raise _wrong("number")
    try:
        return float(value) + 0.0  # no −0.0, so that equal scenarios have equal links
    except OverflowError:
        raise _wrong("finite_number") from None
    except (TypeError, ValueError):
        raise _wrong("number") from None


def _wrong(name: str, **values: Any) -> PydanticCustomError:
    """Return the error of one value: the end of its sentence, such as 'must be a number'."""
    return PydanticCustomError("value", "{allowed}", {"allowed": say(name, **values)})


def quantity(default: Any, meaning: str, unit: str = "1", allowed: Range | None = None) -> Any:
    """Return a pydantic field with its meaning and unit ("1" for a pure number, "" for a word), and the check of a number."""
    extra: dict[str, Any] = {"unit": unit}
    if allowed is not None:
        extra["minimum"] = min([allowed.least, *allowed.also])
        if math.inf not in allowed.also:
            extra["maximum"] = allowed.most
    field: Any = Field(default, description=meaning, json_schema_extra=extra)
    if unit:
        field.metadata.append(Number(allowed, unit))
    return field


def unit_of(field: FieldInfo) -> str:
    """Return the unit of a field; "" for a word and a section."""
    return next((mark.unit for mark in field.metadata if isinstance(mark, Number)), "")


def field_of(path: str) -> Any:
    """Return a pydantic field with the default, meaning, unit and range of a parameter."""
    row = PARAMETERS[path]
    return quantity(row.default, row.meaning, row.unit, row.range)


# --- models -----------------------------------------------------------------------------------------


class Frozen(BaseModel):
    """A validated model that never changes; a bad value raises `InputError`."""

    place: ClassVar[str] = ""  # the model's path in a scenario, with a trailing dot
    in_order: ClassVar[bool] = False  # whether values may be given without their names

    model_config = ConfigDict(frozen=True, extra="forbid")

    def __init__(self, /, *unnamed: Any, **values: Any) -> None:
        if unnamed and not self.in_order:
            name, keys = type(self).__name__, ", ".join(type(self).model_fields)
            raise InputError(f"{name} takes its values by name ({keys}), not as {name}({shortened(shown(unnamed[0]))}).")
        named = dict(zip(type(self).model_fields, unnamed, strict=False)) if unnamed else {}
        try:
            super().__init__(**named, **values)
        except ValidationError as error:
            raise input_error(error) from None

    # As pydantic's own: it would call another one for nested models too, whose errors must keep their path in the scenario.
    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]

    @model_validator(mode="before")
    @classmethod
    def _known_keys(cls, data: Any) -> Any:
        # pydantic forbids extra keys too, but does not list the known ones
        known = cls.model_fields
        for key in data if isinstance(data, Mapping) else ():
            if key not in known:
                raise refuse(unknown_key(str(key), list(known), cls.place), f"{cls.place}{shortened(str(key))}")
        return data

    def __setattr__(self, name: str, value: Any) -> None:
        path = f"{self.place}{shortened(name)}"
        known = list(type(self).model_fields)
        if name not in known and not hasattr(type(self), name):
            raise InputError(unknown_key(name, known, self.place), field=path)
        raise InputError(
            f"{path} = {shortened(shown(value))} cannot be assigned, since a {type(self).__name__} never changes; "
            f"{self._changing(name, shortened(shown(value)))} returns another one.",
            field=path,
            value=value,
        )

    def _changing(self, name: str, value: str) -> str:
        """Return the expression that makes another model."""
        return f"model_copy(update={{{name!r}: {value}}})"

    def to_dict(self) -> dict[str, Any]:
        """Return its keys as in a scenario file, in the way it was given.

        Returns
        -------
        keys : dict
            Numbers in SI units and words only; an infinite friction is the word "inf", since JSON has no
            infinity.
        """
        return {name: "inf" if value == math.inf else keys_of(value) for name, value in self.__repr_args__()}

    @classmethod
    def from_dict(cls, keys: dict[str, Any]) -> Self:
        """Build it from its keys in a scenario file.

        Parameters
        ----------
        keys : dict
            As `to_dict` gives them; missing keys have their defaults.

        Returns
        -------
        model : Frozen

        Raises
        ------
        ValueError
            If a key is unknown or a value not allowed.
        """
        try:
            return cls.model_validate(keys)
        except ValidationError as error:
            raise input_error(error) from None

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """Return the same model with other values, which are validated (unlike in pydantic).

        Parameters
        ----------
        update : dict, optional
            Keys and their new values, in SI units.
        deep : bool, default False
            Ignored, since a frozen model never changes.

        Returns
        -------
        model : Frozen

        Raises
        ------
        ValueError
            If a key is unknown or a value not allowed.
        """
        return type(self)(**{**self.to_dict(), **update}) if update else self

    def _written(self) -> Iterable[str]:
        """Return the names of the fields that define it; the others follow from them."""
        return type(self).model_fields

    def __repr_args__(self) -> Iterable[tuple[str, Any]]:
        return [(name, value) for name in self._written() if (value := getattr(self, name)) is not None]

    def _settle(self, **values: Any) -> None:
        """Set derived fields; only for validators, before the model is visible."""
        self.__dict__.update(values)


def keys_of(value: Any) -> Any:
    """Return a value as a copy of its keys, which may be changed; numbers and words of NumPy as Python's."""
    if type(value) in (float, str):  # most values, at once
        return value
    if isinstance(value, Frozen):
        return value.to_dict()
    if isinstance(value, Mapping):
        return {key: keys_of(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [keys_of(item) for item in value]
    return value.item() if getattr(value, "ndim", None) == 0 else value


def refuse(message: str, field: str | None = None) -> PydanticCustomError:
    """Return an error whose message is the whole sentence."""
    return PydanticCustomError("sentence", "{sentence}", {"sentence": plain(message), "field": field and plain(field)})


def near_name(word: str, known: Sequence[str], place: str) -> str:
    """Return the path of the key that an unknown key probably means, here or in another section; empty if there is none."""
    import difflib  # here, since a known key needs none

    word = word.strip().lower().replace(" ", "_").replace("-", "_")
    own = place.removesuffix(".") or "motion"
    here = {name: name for name in known}
    elsewhere = ""
    for row in TABLE:
        key = row.path.rpartition(".")[2]
        if section_of(row) == own and key in known:
            here = dict.fromkeys(row.names, key) | here
        elif section_of(row) != own and word in (key, *row.names):
            elsewhere = elsewhere or row.path
    close = difflib.get_close_matches(word, here, n=1, cutoff=0.75)
    return f"{place}{here[close[0]]}" if close else elsewhere


def unknown_key(key: str, known: Sequence[str], place: str) -> str:
    """Return the sentence for a key that a section does not have, with the one that it probably means."""
    close = near_name(key, known, place)
    hint = say("did_you_mean", close=close) if close else say("known_are", known=", ".join(known))
    return say("unknown_key", path=f"{place}{shortened(key)}", hint=hint)


def alone(section: str, way: str, given: Iterable[str]) -> None:
    """Refuse keys that are given together with the one that says it all."""
    for other in given:
        if other != way:
            raise refuse(say("together", section=section, other=other, way=way))


# --- rules between fields ---------------------------------------------------------------------------


class Rule(NamedTuple):
    """A sentence and what fills it.

    Attributes
    ----------
    sentence : str
        A key of `TEXTS`.
    values : dict of str to str
        Paths of a scenario, by the names in the sentence.
    known : dict
        What is the same for all scenarios, likewise; a `Number` gives the words of its range.
    number : str, default ''
        The name in the sentence of the number that `refusal` returns.
    """

    sentence: str
    values: Mapping[str, str]
    known: Mapping[str, Any] = {}
    number: str = ""


_INERTIA = {"words": Number(RANGES["hoop.inertia_ratio"], "1")}
_STIFFNESS = {"unit": "m g/R", "words": Number(RELATIVE_STIFFNESS, "1")}
_SLIP_SPEED = {"unit": "√(g R)", "words": Number(RELATIVE_SLIP_SPEED, "1")}

RULES: Final[dict[Refusal, Rule]] = {
    Refusal.HOOP_MASS: Rule("hoop_mass", {"mass": "hoop.mass"}, {"words": Number(RANGES["hoop.mass"], "kg")}),
    Refusal.PARTS_CENTER: Rule("parts_center", {"eccentricity": "hoop.eccentricity"}),
    Refusal.LOAD_INERTIA: Rule(
        "load_inertia", {"load_fraction": "hoop.load_fraction", "inertia_ratio": "hoop.inertia_ratio"}, _INERTIA
    ),
    Refusal.PARTS_INERTIA: Rule("parts_inertia", {"inertia_ratio": "hoop.inertia_ratio"}, _INERTIA),
    Refusal.MASSLESS_ECCENTRICITY: Rule("massless_eccentricity", {"eccentricity": "hoop.eccentricity"}),
    Refusal.KINETIC_ABOVE_STATIC: Rule(
        "kinetic_above_static", {"mu_kinetic": "plane.mu_kinetic", "mu_static": "plane.mu_static"}
    ),
    Refusal.VERTICAL: Rule("vertical", {"slope": "plane.slope"}),
    Refusal.SLOPE: Rule("slope", {"slope": "plane.slope"}, {"words": Number(RANGES["plane.slope"], "rad")}),
    Refusal.MASSLESS_SLOPE: Rule("massless_slope", {"slope": "plane.slope"}),
    Refusal.MASSLESS_RESISTANCE: Rule("massless_resistance", {"given": "plane.rolling_resistance"}),
    Refusal.RESISTANCE: Rule("resistance", {"given": "plane.rolling_resistance"}, number="most"),
    Refusal.MASSLESS_COMPLIANT: Rule("massless_compliant", {}),
    Refusal.COMPLIANT_FRICTION: Rule("compliant_friction", {}),
    Refusal.STIFFNESS: Rule(
        "relative_contact", {"value": "contact.stiffness"}, {"name": "stiffness", **_STIFFNESS}, "relative"
    ),
    Refusal.TANGENTIAL_STIFFNESS: Rule(
        "relative_contact", {"value": "contact.tangential_stiffness"}, {"name": "tangential_stiffness", **_STIFFNESS},
        "relative",
    ),
    Refusal.SLIP_SPEED: Rule(
        "relative_contact", {"value": "contact.slip_speed"}, {"name": "slip_speed", **_SLIP_SPEED}, "relative"
    ),
    Refusal.TOO_SOFT: Rule("too_soft", {"stiffness": "contact.stiffness"}, {"most": MOST_DEPTH}, "depth"),
    Refusal.TOO_FAST: Rule("too_fast", {}, {"most": MOST_SPEED}, "speed"),
    Refusal.TOO_HIGH: Rule("too_high", {"height": "start.height"}, {"most": MOST_HEIGHT}, "relative"),
}  # fmt: skip


def refused(code: int, scenario: Any, number: float = 0.0) -> PydanticCustomError:
    """Return the error for a broken rule.

    code: A `Refusal` other than NONE; number: What `refusal` returns in addition.
    """
    rule = RULES[Refusal(code)]
    values = {name: attrgetter(path)(scenario) for name, path in rule.values.items()}
    if rule.number:
        values[rule.number] = number
    known = {name: value.words if isinstance(value, Number) else value for name, value in rule.known.items()}
    return refuse(say(rule.sentence, **values, **known))


# --- from what pydantic found to a sentence ---------------------------------------------------------

# Where a model's fields stand in a scenario.
_PLACES = {"Scenario": "", "Rigid": "contact", "Compliant": "contact", "PointMass": "point_mass"}

# Kinds of pydantic's errors, and what is allowed there.
_KINDS = {
    "model_type": "table",
    "model_attributes_type": "table",
    "dict_type": "table",
    "union_tag_not_found": "table",
    "tuple_type": "list",
    "list_type": "list",
    "float_type": "number",
    "int_type": "number",
    "string_type": "word",
}

_MODELS = {"hoop": "a Hoop", "plane": "a Plane", "start": "a Start", "contact": "Rigid or Compliant"}

_TAGS = {"rigid", "compliant", "ring", "disk", "point_mass", "rod"}


def sentence(error: BaseException) -> str:
    """Say in one sentence what is wrong with the input.

    Parameters
    ----------
    error : Exception
        What was raised: pydantic's ``ValidationError``, or any other, whose own message is then used.

    Returns
    -------
    sentence : str
        Names the field by its path in a scenario, its value and what is allowed.

    Examples
    --------
    >>> import hophoop as hh
    >>> from hophoop.scenario import sentence
    >>> try:
    ...     hh.Plane(mu_kinetic=1.2)
    ... except ValueError as error:
    ...     print(sentence(error))
    plane.mu_kinetic = 1.2 must not exceed plane.mu_static = 1.0.
    """
    if isinstance(error, OSError) and error.strerror:
        file = "" if error.filename is None else f"{error.filename}: "
        return f"{file}{error.strerror}."
    if not isinstance(error, ValidationError):
        # KeyError and the like show their argument only; a name says more than nothing.
        return str(error) or type(error).__name__
    return str(input_error(error))


def input_error(error: ValidationError) -> InputError:
    """The `InputError` for what pydantic found: the first finding is said, the others are counted."""
    findings = error.errors(include_url=False)
    first = _problem(_PLACES.get(error.title, error.title.lower()), findings[0])
    others = len(findings) - 1
    message = str(first)
    if others:
        message = say("other_problem" if others == 1 else "other_problems", first=message.removesuffix("."), count=others)
    return InputError(message, findings, field=first.field, value=first.value, allowed=first.allowed)


def _problem(above: str, finding: Mapping[str, Any]) -> InputError:
    """Return one finding of pydantic as an error, for a model at a path."""
    place = _path(above, finding["loc"])
    kind, value, context = finding["type"], finding["input"], finding.get("ctx", {})
    if kind == "sentence":
        return InputError(str(context["sentence"]), field=context.get("field"))
    if kind == "union_tag_not_found" and isinstance(value, Mapping):
        kind = "missing"
        place += _tag(place)
    if kind == "missing":
        return InputError(say("missing", path=place), field=place)
    if kind == "union_tag_invalid":
        value = context["tag"]
        place += _tag(place)
        allowed = say("literal_error", expected=" or ".join(context["expected_tags"].rsplit(", ", 1)))
    elif kind == "value":  # of a number
        allowed = finding["msg"]
    elif kind == "literal_error":
        allowed = say(kind, expected=context["expected"])
    elif isinstance(value, BaseModel) and place in _MODELS:  # arguments in another order
        allowed = f"must be {_MODELS[place]}, not {type(value).__name__}"
    elif kind in _KINDS:
        allowed = say(_KINDS[kind])
    else:
        message = finding["msg"]
        return InputError(f"{place} = {_show(value)}: {message[:1].lower()}{message[1:]}.", field=place, value=value)
    sentence = say("finding", path=place, shown=_show(value), allowed=allowed)
    return InputError(sentence, field=place, value=value, allowed=allowed.removeprefix("must be "))


def _tag(place: str) -> str:
    """Return the step of a path to the key that says which of several models a table is."""
    return ".model" if place.endswith("contact") else ".shape"


def _path(above: str, loc: Sequence[str | int]) -> str:
    # The name of a union's branch is pydantic's, not the user's.
    parts = [above, *(shortened(str(step)) for step in loc if step not in _TAGS)]
    return ".".join(filter(None, parts)) or TEXTS["whole_scenario"]


def _show(value: Any) -> str:
    try:
        return shortened(shown(value))
    except ValueError:  # Python does not write a number of more than 4,300 digits
        return "(a number of too many digits)"
