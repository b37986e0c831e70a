"""Texts of a scenario: TOML, JSON and the query of a link."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import IO, Any

from hophoop._support.errors import InputError, check_type, shortened
from hophoop.scenario.checking import say

MOST_BYTES = 1_000_000
# A key with many parts is slow in tomllib; a scenario's keys have two.
_DEEP_KEY = re.compile(r"""(?<![\w-])([\w-]+|"[^"\n]*"|'[^'\n]*')([ \t]*\.[ \t]*([\w-]+|"[^"\n]*"|'[^'\n]*')){16}""")


def read_file(path: Path) -> str:
    """Return the text of a file."""
    with path.open("rb") as stream:
        return _decoded(stream, str(path), "text file")


def read_standard_input() -> str:
    """Return the text of standard input."""
    stream = getattr(sys.stdin, "buffer", None)
    return sys.stdin.read() if stream is None else _decoded(stream, "standard input", "text")


def _decoded(stream: IO[bytes], name: str, kind: str) -> str:
    content = stream.read(MOST_BYTES + 1)
    if len(content) > MOST_BYTES:
        raise InputError(f"{name} is longer than {MOST_BYTES:,} bytes, which no scenario is.")
    try:
        # universal newlines, as in Python's text files
        return content.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError:
        raise InputError(f"{name} is not a {kind} in UTF-8.") from None


def read_text(text: str, form: str | None, name: str) -> dict[str, Any]:
    """Parse TOML or JSON; without a format, a text that starts with a brace is JSON."""
    check_type("text", text, str)
    if form is None:
        form = "json" if text.lstrip().startswith("{") else "toml"
    if form not in ("toml", "json"):
        raise InputError.of_field("format", form, "'toml' or 'json'")
    import tomllib  # here, as urllib below: most motions read no text

    try:
        if form == "toml" and _DEEP_KEY.search(text):
            raise RecursionError
        data = tomllib.loads(text) if form == "toml" else json.loads(text, object_pairs_hook=_once)
    except InputError:
        raise
    except (ValueError, RecursionError) as error:
        raise InputError(f"{name} is not valid {form.upper()}: {parse_reason(error)}.") from None
    if not isinstance(data, dict):
        shown = json.dumps(data)
        if len(shown) > 40:
            shown = "a list" if isinstance(data, list) else "a text or number"
        raise InputError(f"{name} must hold a table of keys, not {shown}.")
    return data


def parse_reason(error: BaseException) -> str:
    """Why a text is no TOML or JSON.

    error: What the parser raised; reason: The end of a sentence, without its stop.
    """
    if isinstance(error, RecursionError):
        return "nested too deeply"
    text = str(error).rstrip(".")
    # Python reads no whole number of more than 4,300 digits; its words about that are for programmers
    return "a number has too many digits" if text.startswith("Exceeds the limit") else text


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    # JSON would silently keep the last of two equal keys; TOML refuses them.
    table: dict[str, Any] = {}
    for name, value in pairs:
        if name in table:
            raise InputError(f"The key {shortened(repr(name))} is given twice.")
        table[name] = value
    return table


def toml_text(data: Mapping[str, Any], units: Mapping[str, str]) -> str:
    """Return TOML with the unit of each quantity as a comment; `units` maps paths to units."""
    lines: list[str] = []
    for key, value in data.items():  # the duration is before the sections
        if not isinstance(value, Mapping):
            lines.append(_toml_line(key, value, units[key]))
            continue
        lines += ["", f"[{key}]"]
        lines += [_toml_line(name, item, units.get(f"{key}.{name}", "")) for name, item in value.items()]
    return "\n".join(lines) + "\n"


def _toml_line(key: str, value: Any, unit: str) -> str:
    if key == "parts":
        rows = [", ".join(f"{name} = {_toml_value(item)}" for name, item in part.items()) for part in value]
        return "\n".join([f"{key} = [", *(f"  {{ {row} }}," for row in rows), "]"])
    line = f"{key} = {_toml_value(value)}"
    return f"{line:<30} # {unit}" if unit not in ("", "1") else line


def _toml_value(value: Any) -> str:
    # A JSON string without control characters is a TOML string as well.
    return json.dumps(value) if isinstance(value, str) and value != "inf" else str(value)


def query_text(data: Mapping[str, Any]) -> str:
    """Return a query such as `plane.mu=0.5&start.speed=3.1`, in the order of the keys."""
    from urllib.parse import urlencode

    return urlencode([(path, _query_value(value)) for path, value in _leaves(data)])


def _leaves(node: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    if isinstance(node, list):
        node = dict(enumerate(node))
    if not isinstance(node, Mapping):
        yield path, node
        return
    for key, child in node.items():
        yield from _leaves(child, f"{path}.{key}" if path else key)


def _query_value(value: Any) -> str:
    text = value if isinstance(value, str) else repr(value).replace("e+", "e")
    return text.removesuffix(".0")


def read_query(query: str) -> dict[str, Any]:
    """Return the nested keys of a query from `query_text`."""
    from urllib.parse import parse_qsl

    check_type("query", query, str)
    try:
        pairs = parse_qsl(query.removeprefix("?"), keep_blank_values=True, max_num_fields=1000)
    except ValueError as error:
        raise InputError(say("unreadable_query", reason=str(error).rstrip("."))) from None
    data: dict[str, Any] = {}
    for path, text in pairs:
        steps = path.split(".")
        node = data
        for step in steps[:-1]:
            node = node.setdefault(step, {})
            if not isinstance(node, dict):
                raise InputError(say("value_above", path=path, above=path.rpartition(".")[0]))
        if steps[-1] in node:
            raise InputError(say("given_twice", path=path))
        node[steps[-1]] = _query_number(text)
    hoop = data.get("hoop")
    if isinstance(hoop, dict) and isinstance(hoop.get("parts"), dict):
        hoop["parts"] = _numbered(hoop["parts"])
    return data


def _query_number(text: str) -> Any:
    try:
        return float(text)
    except ValueError:
        return text


def _numbered(parts: Mapping[str, Any]) -> list[Any]:
    names = [str(index) for index in range(len(parts))]
    for name in parts:
        if name not in names:
            raise InputError(say("parts_out_of_order", name=name))
    return [parts[name] for name in names]
