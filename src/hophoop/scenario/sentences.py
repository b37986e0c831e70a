"""One clear sentence out of a failed validation: which field, which value, what is allowed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from pydantic import BaseModel, ValidationError

from hophoop._support.errors import InputError, shortened, shown
from hophoop.scenario.texts import TEXTS, say
from hophoop.vocabulary.parameters import PARAMETERS, RANGES

# Where a model's fields stand in a scenario.
_PLACES = {"Scenario": "", "Rigid": "contact", "Compliant": "contact", "PointMass": "point_mass"}

_LIMITS = {"greater_than_equal": "ge", "less_than_equal": "le"}

# Kinds of pydantic's errors, and what is allowed there.
_KINDS = {
    "finite_number": "finite_number",
    **dict.fromkeys(("model_type", "model_attributes_type", "dict_type", "union_tag_not_found"), "table"),
    **dict.fromkeys(("tuple_type", "list_type"), "list"),
    **dict.fromkeys(("int_parsing", "int_type", "int_from_float"), "whole"),
    "string_type": "word",
}

_MODELS = {"hoop": "a Hoop", "plane": "a Plane", "start": "a Start", "contact": "Rigid or Compliant"}

# Kinds of our own validators, whose messages go on from the value.
_OWN = {"number", "friction", "whole", "value"}

_TAGS = {"rigid", "compliant", "ring", "disk", "point_mass", "rod"}


def parse_reason(error: BaseException) -> str:
    """Why a text is no TOML or JSON.

    error: What the parser raised; reason: The end of a sentence, without its stop.
    """
    if isinstance(error, RecursionError):
        return "nested too deeply"
    text = str(error).rstrip(".")
    # Python reads no whole number of more than 4,300 digits; its words about that are for programmers
    return "a number has too many digits" if text.startswith("Exceeds the limit") else text


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
    if isinstance(error, OSError) and error.strerror and error.filename is not None:
        return f"{error.filename}: {error.strerror}."
    if isinstance(error, OSError) and error.strerror:
        return f"{error.strerror}."
    if not isinstance(error, ValidationError):
        # KeyError and the like show their argument only; a name says more than nothing.
        return str(error) or type(error).__name__
    return str(input_error(error))


def input_error(error: ValidationError) -> InputError:
    """The `InputError` for what pydantic found."""
    findings = list(error.errors(include_url=False))
    place = _PLACES.get(error.title, error.title.lower())
    first = _said(place, findings[0])
    message = findings_sentence(findings, place)
    return InputError(message, findings, field=first.field, value=first.value, allowed=first.allowed)


def findings_sentence(findings: Sequence[Mapping[str, Any]], place: str = "") -> str:
    """Put what pydantic found into one sentence.

    findings: As ``ValidationError.errors()`` gives them; the first is said, the others are counted; place: Path under which the
    validated model stands.
    """
    first = _said(place, findings[0]).sentence
    others = len(findings) - 1
    if others == 0:
        return first
    return say("other_problem" if others == 1 else "other_problems", first=first.removesuffix("."), count=others)


class _Said(NamedTuple):
    sentence: str
    field: str | None = None
    value: Any = None
    allowed: str | None = None


def _said(above: str, finding: Mapping[str, Any]) -> _Said:
    place = _path(above, finding["loc"])
    kind, value, context = finding["type"], finding["input"], finding.get("ctx", {})
    if kind == "sentence":
        return _Said(str(context["sentence"]), context.get("field"))
    if kind == "missing":
        return _Said(say("missing", path=place), place)
    if kind == "union_tag_not_found" and isinstance(value, Mapping):
        place = f"{place}.{_tag_key(place)}"
        return _Said(say("missing", path=place), place)
    if kind == "union_tag_invalid":
        place, value = f"{place}.{_tag_key(place)}", context["tag"]
        expected = [word.strip(" '") for word in str(context["expected_tags"]).split(",")]
        allowed = say("literal_error", expected=_either(expected))
    elif kind in _OWN:
        allowed = finding["msg"]
    elif kind in _LIMITS and place in PARAMETERS:
        allowed = say("range", words=RANGES[place].words(PARAMETERS[place].unit))
    elif kind in _LIMITS:
        allowed = say(kind, limit=context[_LIMITS[kind]])
    elif kind == "literal_error":
        allowed = say(kind, expected=context["expected"])
    elif kind in _KINDS:
        allowed = say(_KINDS[kind])
        if isinstance(value, BaseModel) and place in _MODELS:  # arguments in another order
            allowed = f"must be {_MODELS[place]}, not {type(value).__name__}"
    else:
        message = finding["msg"]
        return _Said(f"{place} = {_show(value)}: {message[:1].lower()}{message[1:]}.", place, value)
    sentence = say("finding", path=place, shown=_show(value), allowed=allowed)
    return _Said(sentence, place, value, allowed.removeprefix("must be "))


def _path(above: str, loc: Sequence[str | int]) -> str:
    parts = [above]
    for step in loc:
        # The name of a union's branch is pydantic's, not the user's.
        if step in _TAGS:
            continue
        parts.append(shortened(str(step)))
    return ".".join(part for part in parts if part) or TEXTS["whole_scenario"]


def _tag_key(place: str) -> str:
    """The key that says which of several models a table is."""
    return "model" if place.rpartition(".")[2] == "contact" else "shape"


def _either(words: Sequence[str]) -> str:
    quoted = [f"'{word}'" for word in words]
    return f"{', '.join(quoted[:-1])} or {quoted[-1]}"


def _show(value: Any) -> str:
    try:
        return shortened(shown(value))
    except ValueError:  # nor does it write one
        return "(a number of too many digits)"
