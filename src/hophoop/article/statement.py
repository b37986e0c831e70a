"""What the article says, beside what we find."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

AGREES = "agrees"
WITHIN_READING = "agrees within reading accuracy"
DIFFERS = "differs"
FAILS = "fails"
VERDICTS = (AGREES, WITHIN_READING, DIFFERS, FAILS)


@dataclass(frozen=True)
class Statement:
    """One statement of the article, checked.

    Attributes
    ----------
    key : str
        Short name.
    section : str
        Where in the article.
    statement : str
        What it says, in our words.
    article : str
        Its value.
    ours : str
        What our motion gives.
    verdict : str
        'agrees'; 'agrees within reading accuracy', where the article gives a rounded value or one read off a
        plot; 'differs', where we know why and have checked the reason itself; 'fails', where neither holds.
    why : str
        What stands behind the verdict.
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

    def to_dict(self) -> dict[str, Any]:
        """The statement as it stands in ``statements.json``.

        Returns
        -------
        keys : dict
        """
        return {
            "key": self.key,
            "section": self.section,
            "statement": self.statement,
            "article": self.article,
            "ours": self.ours,
            "verdict": self.verdict,
            "why": self.why,
            "numbers": self.numbers,
        }


def agreement(holds: bool, exact: bool = True) -> str:
    """The verdict on a statement that either holds or fails."""
    return (AGREES if exact else WITHIN_READING) if holds else FAILS


def difference(reason_holds: bool) -> str:
    """The verdict where the article is not confirmed: only a checked reason makes it more than a failure."""
    return DIFFERS if reason_holds else FAILS


Check = Callable[[Any], Statement]
