"""Verdicts on statements."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, ClassVar

AGREES = "agrees"
WITHIN_READING = "agrees within reading accuracy"
DIFFERS = "differs"
FAILS = "fails"
VERDICTS = (AGREES, WITHIN_READING, DIFFERS, FAILS)


@dataclass(frozen=True, kw_only=True)
class Verdict:
    """Our result on a claim or statement, with the verdict.

    Attributes
    ----------
    key : str
        Short name.
    ours : str
        Our result.
    verdict : str
        'agrees'; 'agrees within reading accuracy' if the work's value is rounded or read off a plot; 'differs' with a known
        reason; 'fails' otherwise.
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
        """True unless the verdict is 'fails'."""
        return self.verdict != FAILS

    def to_dict(self) -> dict[str, Any]:
        """Convert to a dictionary for JSON.

        Returns
        -------
        fields : dict
            Numbers that JSON lacks are words, such as 'inf'.
        """
        return {name: _plain(getattr(self, name)) for name in self._json}


def _plain(value: Any) -> Any:
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value


def agreement(holds: bool, exact: bool = True) -> str:
    """Return the verdict on a statement that either holds or fails."""
    return (AGREES if exact else WITHIN_READING) if holds else FAILS


def difference(reason_holds: bool) -> str:
    """Return the verdict if the article is not confirmed: 'differs' with a checked reason, otherwise 'fails'."""
    return DIFFERS if reason_holds else FAILS
