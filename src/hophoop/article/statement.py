"""A statement of the article with our result."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, field
from typing import Any, NamedTuple

AGREES = "agrees"
WITHIN_READING = "agrees within reading accuracy"
DIFFERS = "differs"
FAILS = "fails"
VERDICTS = (AGREES, WITHIN_READING, DIFFERS, FAILS)


class Result(NamedTuple):
    """What a check finds; `article` and `why` where they hold computed numbers, otherwise statements.toml has them."""

    ours: str
    verdict: str
    numbers: dict[str, Any]
    article: str = ""
    why: str = ""


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
    verdict: str
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
            Numbers that JSON lacks are words, such as 'inf'.
        """
        return {name: _plain(value) for name, value in asdict(self).items()}


def _plain(value: Any) -> Any:
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


def agreement(holds: bool, exact: bool = True) -> str:
    """Return the verdict on a statement that either holds or fails."""
    return (AGREES if exact else WITHIN_READING) if holds else FAILS


def difference(reason_holds: bool) -> str:
    """Return the verdict if the article is not confirmed: 'differs' with a checked reason, otherwise 'fails'."""
    return DIFFERS if reason_holds else FAILS
