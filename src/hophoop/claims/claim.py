"""A claim of the literature, our number beside it, and whether that number still holds."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from typing import Any

from hophoop.article.statement import AGREES, DIFFERS, FAILS, WITHIN_READING

NOT_READ = "not read"
VERDICTS = (AGREES, WITHIN_READING, DIFFERS, NOT_READ, FAILS)


@dataclass(frozen=True)
class Claim:
    """What a work says, and the number that we set beside it.

    Attributes
    ----------
    key : str
        Short name.
    work : str
        Key of the work in references.bib.
    claim : str
        What it says, in our words.
    theirs : str
        Its number, or its answer in a word.
    quantity : str
        What our number is.
    ours : str
        Our number, with the digits that must come out again.
    unit : str
        Unit of our number; empty for a pure number.
    verdict : str
        'agrees'; 'agrees within reading accuracy', where theirs is rounded; 'differs', where we know why;
        'not read', where we have not had what it says.
    why : str
        What stands behind the verdict.
    compute : callable
        Computes our number anew [unit].
    theirs_number : float, optional
        Its number, where there is one that ours is to be compared with [unit].
    reading : float
        How far ours may be from it [unit].
    """

    key: str
    work: str
    claim: str
    theirs: str
    quantity: str
    ours: str
    unit: str
    verdict: str
    why: str
    compute: Callable[[], float]
    theirs_number: float | None = None
    reading: float = 0.0


@dataclass(frozen=True)
class Finding:
    """A claim with our number as it comes out now.

    Attributes
    ----------
    key : str
        Short name of the claim.
    work : str
        Key of the work in references.bib.
    claim : str
        What it says, in our words.
    theirs : str
        Its number, or its answer in a word.
    ours : str
        Our number or what our motion gives, computed now, with its unit.
    verdict : str
        As of the claim; 'fails' where our number has not come out again or no longer bears the verdict.
    why : str
        What stands behind the verdict.
    value : float or None
        Our number in full precision, in the unit of `ours`; None where there are several [unit].
    """

    key: str
    work: str
    claim: str
    theirs: str
    ours: str
    verdict: str
    why: str
    value: float | None = None

    @property
    def holds(self) -> bool:
        """Whether the verdict still stands."""
        return self.verdict != FAILS

    def to_dict(self) -> dict[str, Any]:
        """The finding as JSON has it.

        Returns
        -------
        keys : dict
        """
        value = self.value if self.value is None or math.isfinite(self.value) else str(self.value)
        return {
            "key": self.key,
            "work": self.work,
            "claim": self.claim,
            "theirs": self.theirs,
            "ours": self.ours,
            "value": value,
            "verdict": self.verdict,
            "why": self.why,
        }


def with_unit(number: str, unit: str) -> str:
    """A number with its unit, as it is written."""
    return number.replace("-", "−") + ("°" if unit == "°" else f" {unit}" if unit else "")


def decimals(number: str) -> int:
    """Digits after the point of a number as it is written."""
    return max(0, -int(Decimal(number).as_tuple().exponent))


def judged(claim: Claim) -> Finding:
    """Compute our number anew and see whether the verdict stands.

    Parameters
    ----------
    claim : Claim

    Returns
    -------
    finding : Finding
        'fails' where the number does not come out to the digits written down, where the comparison with the work's number
        gives another verdict, or where the motion no longer has what the claim is about.
    """
    try:
        value = float(claim.compute())
    except (IndexError, StopIteration, ValueError):
        why = "The computed motion does not have what the claim is about."
        return Finding(claim.key, claim.work, claim.claim, claim.theirs, "–", FAILS, why)
    places = decimals(claim.ours)
    again = abs(value - float(claim.ours)) <= 0.5000001 * 10.0**-places
    ours = with_unit(f"{value:.{places}f}", claim.unit)
    verdict, why = claim.verdict, claim.why
    if not again:
        verdict, why = FAILS, f"It was {with_unit(claim.ours, claim.unit)}. {why}"
    elif claim.theirs_number is not None:
        near = abs(value - claim.theirs_number) <= claim.reading
        if near != (claim.verdict in (AGREES, WITHIN_READING)):
            verdict = FAILS
    return Finding(claim.key, claim.work, claim.claim, claim.theirs, f"{claim.quantity} {ours}", verdict, why, value)
