"""Why a change of the source cannot be seen: reads mutations_explained.toml."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import NamedTuple

from mutants import Key

FILE = Path(__file__).with_suffix(".toml")


class Entry(NamedTuple):
    """The reason for a change, and how many changes its operator makes in the function."""

    reason: str
    count: int


def explained(text: str) -> dict[Key, Entry]:
    """The explained changes of a table in TOML; one that has two reasons is a mistake."""
    found: dict[Key, Entry] = {}
    for reason, places in tomllib.loads(text).items():
        for place, operators in places.items():
            module, _, function = place.partition(":")
            for operator, numbers in operators.items():
                ordinals, count = numbers.split(" of ")
                for ordinal in ordinals.split():
                    key = Key(module, function, operator, int(ordinal))
                    if key in found:
                        raise ValueError(f"{place} has {operator} {ordinal} twice: {found[key].reason}; {reason}")
                    found[key] = Entry(reason, int(count))
    return found


EXPLAINED = explained(FILE.read_text(encoding="utf-8"))
