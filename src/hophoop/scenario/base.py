"""Common parts of a scenario's models: frozen models, kinds of numbers, one-sentence errors."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, model_validator
from pydantic_core import PydanticCustomError

from hophoop._support.errors import InputError, plain, shortened, shown
from hophoop.scenario.sentences import input_error
from hophoop.scenario.texts import TEXTS, say
from hophoop.vocabulary.parameters import PARAMETERS, RANGES, TABLE, Range, section_of


def plain_init(init: Callable[..., None]) -> Callable[..., None]:
    """Mark an ``__init__`` that only passes on to pydantic's.

    Without the mark pydantic would call it for nested models too, whose errors must keep their path in the
    scenario.
    """
    init.__pydantic_base_init__ = True  # type: ignore[attr-defined]
    return init


def near_name(word: str, known: Sequence[str], place: str) -> str:
    """Return the key, or the path in another section, that an unknown key probably means; empty if there is none."""
    import difflib

    word = word.strip().lower().replace(" ", "_").replace("-", "_")
    section = place.removesuffix(".")
    names: dict[str, str] = {}  # every name of a key of this section
    elsewhere: dict[str, str] = {}
    for row in TABLE:
        key = row.path.rpartition(".")[2]
        if section_of(row) == (section or "motion"):
            names |= dict.fromkeys(row.names, key) if key in known else {}
        elif section or section_of(row) in known:
            for name in (key, *row.names):
                elsewhere.setdefault(name, row.path)
    names |= {name: name for name in known}
    if word in names:
        return names[word]
    close = difflib.get_close_matches(word, names, n=1, cutoff=0.75)
    return names[close[0]] if close else elsewhere.get(word, "")


def unknown_key(key: str, known: Sequence[str], place: str) -> str:
    """Return the sentence for a key that a section does not have, with the one that it probably means."""
    close = near_name(key, known, place)
    hint = say("did_you_mean", close=close) if close else say("known_are", known=", ".join(known))
    return say("unknown_key", path=f"{place}{shortened(key)}", hint=hint)


class Frozen(BaseModel):
    """A validated model that never changes; a bad value raises `InputError`."""

    place: ClassVar[str] = ""  # the model's path in a scenario, with a trailing dot

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    @plain_init
    def __init__(self, /, *unnamed: Any, **values: Any) -> None:
        if unnamed:
            name, keys = type(self).__name__, ", ".join(type(self).model_fields)
            raise InputError(f"{name} takes its values by name ({keys}), not as {name}({shortened(shown(unnamed[0]))}).")
        try:
            super().__init__(**values)
        except ValidationError as error:
            raise input_error(error) from None

    @model_validator(mode="before")
    @classmethod
    def _known_keys(cls, data: Any) -> Any:
        # pydantic forbids extra keys too, but does not list the known ones
        known = [field.alias or name for name, field in cls.model_fields.items()]
        for key in data if isinstance(data, Mapping) else ():
            if key not in known:
                raise refuse(unknown_key(str(key), known, cls.place), f"{cls.place}{shortened(str(key))}")
        return data

    def __setattr__(self, name: str, value: Any) -> None:
        path = self._path_of(name)
        raise InputError(
            f"{path} = {shortened(shown(value))} cannot be assigned, since a {type(self).__name__} never changes; "
            f"{self._changing(name, shortened(shown(value)))} returns another one.",
            field=path,
            value=value,
        )

    def __delattr__(self, name: str) -> None:
        path = self._path_of(name)
        raise InputError(f"{path} cannot be deleted, since a {type(self).__name__} never changes.", field=path)

    def _path_of(self, name: str) -> str:
        path, known = f"{self.place}{shortened(name)}", list(type(self).model_fields)
        if name not in known and not hasattr(type(self), name):
            raise InputError(unknown_key(name, known, self.place), field=path)
        return path

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
        return {name: _plain(value) for name in self._written() if (value := getattr(self, name)) is not None}

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


def _plain(value: Any) -> Any:
    if isinstance(value, Frozen):
        return value.to_dict()
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    return "inf" if value == math.inf else value


def refuse(message: str, field: str | None = None) -> PydanticCustomError:
    """Return an error whose message is the whole sentence."""
    return PydanticCustomError("sentence", "{sentence}", {"sentence": plain(message), "field": field and plain(field)})


def _not(kind: Literal["number", "friction", "whole", "finite_number"]) -> PydanticCustomError:
    return PydanticCustomError(kind, TEXTS[kind])


def _number(value: Any) -> float:
    # booleans and text are refused; NumPy's scalars become Python floats
    scalar = getattr(value, "ndim", 0) == 0 and hasattr(value, "__float__")
    if not scalar or isinstance(value, bool | np.bool_):
        raise _not("number")
    try:
        return float(value) + 0.0  # no −0.0, so that equal scenarios have equal links
    except OverflowError:
        raise _not("finite_number") from None
    except (TypeError, ValueError):
        raise _not("number") from None


def _friction(value: Any) -> float:
    # JSON has no infinity, hence the word
    number = float("inf") if value == "inf" else _number(value)
    if not number >= 0.0:
        raise _not("friction")
    return number


def _whole(value: Any) -> int:
    number = _number(value)
    if not number.is_integer():
        raise _not("whole")
    return int(value)


def within(path: str) -> Any:
    """Return the pydantic annotation that keeps a number in the range of a path of `RANGES`."""
    allowed = RANGES[path]
    if not allowed.also:
        return Field(ge=allowed.least, le=allowed.most)

    def kept(value: float) -> float:
        if not allowed.holds(value):
            raise PydanticCustomError("value", TEXTS["range"], {"words": allowed.words(PARAMETERS[path].unit)})
        return value

    return AfterValidator(kept)


NUMBER = BeforeValidator(_number)
Number = Annotated[float, NUMBER]
Friction = Annotated[float, Field(allow_inf_nan=True), BeforeValidator(_friction), within("plane.mu")]
Count = Annotated[int, within("contact.max_events"), BeforeValidator(_whole)]


def quantity(default: Any, meaning: str, unit: str = "1", allowed: Range | None = None) -> Any:
    """Return a pydantic field with its meaning and unit ("1" for a pure number, "" for a word)."""
    extra: dict[str, Any] = {"unit": unit}
    if allowed is not None and 0.0 in allowed.also:
        extra |= {"minimum": 0.0, "maximum": allowed.most}
    return Field(default, description=meaning, json_schema_extra=extra)


def field_of(path: str) -> Any:
    """Return a pydantic field with the default, meaning and unit of a parameter."""
    row = PARAMETERS[path]
    return quantity(row.default, row.meaning, row.unit, row.range)


def alone(section: str, way: str, given: Iterable[str]) -> None:
    """Refuse keys that are given together with the one that says it all."""
    for other in given:
        if other != way:
            raise refuse(say("together", section=section, other=other, way=way))
