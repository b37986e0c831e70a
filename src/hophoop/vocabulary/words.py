"""Words of the file format, and how they are shown."""

from __future__ import annotations

from enum import StrEnum
from typing import Any


class Word(StrEnum):
    """A string of the file format that type checkers and editors know; it is printed as a plain string."""

    def __repr__(self) -> str:
        return repr(self.value)


def identifier(word: Any) -> str:
    """Return words as an identifier of the file format, such as slips_ever_less for 'slips ever less'."""
    return str(word).replace(" ", "_")


def plain(word: Any) -> str:
    """Return an identifier of the file format as words, such as 'slip start' for slip_start."""
    return str(word).replace("_", " ")
