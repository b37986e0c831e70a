"""A statement of the article with our result."""

from __future__ import annotations

import math
import string
from dataclasses import asdict, dataclass, field
from typing import Any, NamedTuple

AGREES = "agrees"
WITHIN_READING = "agrees within reading accuracy"
DIFFERS = "differs"
FAILS = "fails"


class Result(NamedTuple):
    """Result of a check: whether our reading of the statement holds, and the numbers of its texts."""

    holds: bool
    numbers: dict[str, Any]


class Texts(string.Formatter):
    """Texts with numbers: ``!d`` converts to degrees, ``!h`` to a hundredfold; a list gets a comma between its items."""

    def convert_field(self, value: Any, conversion: str | None) -> Any:
        """Convert a number as its field asks for."""
        if conversion == "d":
            return math.degrees(value)
        return 100.0 * value if conversion == "h" else super().convert_field(value, conversion)

    def format_field(self, value: Any, format_spec: str) -> str:
        """Format a number, or each one of a list."""
        return ", ".join(format(one, format_spec) for one in (value if isinstance(value, list) else [value]))


@dataclass(frozen=True, kw_only=True)
class Statement:
    """One statement of the article, checked.

    Attributes
    ----------
    key : str
        Short name.
    section : str
        Section of the article.
    statement : str
        Its content, in our words.
    article : str
        Its value.
    ours : str
        Our result.
    verdict : str
        'agrees'; 'agrees within reading accuracy' if the article's value is rounded or read off a plot; 'differs' with a
        checked reason; 'fails' otherwise.
    why : str
        The reason for the verdict.
    numbers : dict
        The numbers behind `ours`, in full precision.
    """

    key: str
    section: str
    statement: str
    article: str
    ours: str
    verdict: str = AGREES
    why: str = ""
    numbers: dict[str, Any] = field(default_factory=dict)

    @property
    def holds(self) -> bool:
        """True unless the verdict is 'fails'."""
        return self.verdict != FAILS

    def to_dict(self) -> dict[str, Any]:
        """Convert to a dictionary for JSON.

        Returns
        -------
        fields : dict
        """
        return asdict(self)
