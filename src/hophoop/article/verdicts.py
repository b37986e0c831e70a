"""The verdicts on what a work says, and the record that every checked claim or statement has."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

AGREES = "agrees"
WITHIN_READING = "agrees within reading accuracy"
DIFFERS = "differs"
NOT_READ = "not read"
FAILS = "fails"
VERDICTS = (AGREES, WITHIN_READING, DIFFERS, NOT_READ, FAILS)


@dataclass(frozen=True, kw_only=True)
class Judged:
    """What hophoop finds next to what a work says, with the verdict.

    Attributes
    ----------
    key : str
        Short name.
    ours : str
        What our motion gives.
    verdict : str
        'agrees'; 'agrees within reading accuracy', where the work's value is rounded or read off a plot; 'differs', where
        we know why; 'not read', where we have not had what the work says; 'fails', where none of these holds.
    why : str
        The reason for the verdict.
    """

    key: str
    ours: str
    verdict: str
    why: str = ""

    _json: ClassVar[tuple[str, ...]] = ()  # fields in the order that files and `--json` have

    @property
    def holds(self) -> bool:
        """Whether the verdict is another one than 'fails'."""
        return self.verdict != FAILS

    def to_dict(self) -> dict[str, Any]:
        """Return the fields as JSON has them.

        Returns
        -------
        fields : dict
            A number that JSON does not have is a word, such as 'inf'.
        """
        return {name: _plain(getattr(self, name)) for name in self._json}


def _plain(value: Any) -> Any:
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


def agreement(holds: bool, exact: bool = True) -> str:
    """The verdict on a statement that either holds or fails."""
    return (AGREES if exact else WITHIN_READING) if holds else FAILS


def difference(reason_holds: bool) -> str:
    """The verdict where the article is not confirmed: only a checked reason makes it more than a failure."""
    return DIFFERS if reason_holds else FAILS
