"""A claim of the literature, our number, and whether that number still holds."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from functools import partial
from typing import Annotated, Any

import pydantic.dataclasses
from pydantic import AfterValidator, BeforeValidator, ConfigDict, Field, StrictFloat

from hophoop.article.verdicts import AGREES, FAILS, VERDICTS, WITHIN_READING, Verdict
from hophoop.cite import references
from hophoop.claims import numbers


def _known_work(key: str) -> str:
    if key not in references():
        raise ValueError(f"{key} is no key of references.bib")
    return key


def _known_verdict(verdict: str) -> str:
    if verdict not in VERDICTS:
        raise ValueError(f"{verdict} must be one of {', '.join(VERDICTS)}")
    return verdict


def _function(name: Any) -> Any:
    """Return the function of `numbers` with this name; other values stay."""
    if not isinstance(name, str):
        return name
    found = getattr(numbers, name, None)
    if name.startswith("_") or getattr(found, "__module__", "") != numbers.__name__:
        raise ValueError(f"{name} is no function of {numbers.__name__}")
    return found


@pydantic.dataclasses.dataclass(frozen=True, kw_only=True, config=ConfigDict(extra="forbid"))
class Claim:
    """A claim of a work, and our number to compare with it: an entry of ``claims.toml``.

    Attributes
    ----------
    key : str
        Short name.
    work : str
        Key of the work in references.bib.
    claim : str
        Its content, in our words.
    theirs : str
        Its number, or its answer as a word.
    quantity : str
        Meaning of our number.
    ours : str
        Our number, with the digits that must be reproduced.
    unit : str
        Unit of our number; empty for a pure number.
    verdict : str
        'agrees'; 'agrees within reading accuracy' if theirs is rounded; 'differs' with a known reason; 'not read' if the
        source was not available.
    why : str
        The reason for the verdict.
    compute : callable
        Computes our number [unit]; in the file the name of a function of ``hophoop.claims.numbers``.
    theirs_number : float, optional
        Its number, if ours is compared with it [unit].
    reading : float
        Maximum difference from it [unit].
    """

    key: str
    work: Annotated[str, AfterValidator(_known_work)]
    claim: str
    theirs: str
    quantity: str
    ours: Annotated[str, Field(pattern=r"^-?\d+(\.\d+)?$")]
    unit: str = ""
    verdict: Annotated[str, AfterValidator(_known_verdict)]
    why: str
    compute: Annotated[Callable[[], float], BeforeValidator(_function)]
    theirs_number: StrictFloat | None = None
    reading: StrictFloat = 0.0


@dataclass(frozen=True, kw_only=True)
class Finding(Verdict):
    """A claim with our number, computed now.

    Attributes
    ----------
    key : str
        Short name of the claim.
    work : str
        Key of the work in references.bib.
    claim : str
        Its content, in our words.
    theirs : str
        Its number, or its answer as a word.
    ours : str
        Our number or result, computed now, with its unit.
    verdict : str
        That of the claim; 'fails' if our number has changed or contradicts the verdict.
    why : str
        The reason for the verdict.
    value : float or None
        Our number in full precision, in the unit of `ours`; None if there are several [unit].
    """

    work: str
    claim: str
    theirs: str
    value: float | None = None

    _json = ("key", "work", "claim", "theirs", "ours", "value", "verdict", "why")


def with_unit(number: str, unit: str) -> str:
    """Return a number with its unit."""
    return number.replace("-", "−") + ("°" if unit == "°" else f" {unit}" if unit else "")


def decimals(number: str) -> int:
    """Return the number of digits after the decimal point."""
    return max(0, -int(Decimal(number).as_tuple().exponent))


def check_claim(claim: Claim) -> Finding:
    """Compute our number and check the verdict.

    Parameters
    ----------
    claim : Claim

    Returns
    -------
    finding : Finding
        'fails' if the number has other digits than the claim, the comparison with the work's number gives another verdict, or
        the motion lacks the subject of the claim.
    """
    finding = partial(Finding, key=claim.key, work=claim.work, claim=claim.claim, theirs=claim.theirs)
    try:
        value = float(claim.compute())
    except (IndexError, StopIteration, ValueError):
        why = "The computed motion lacks the subject of the claim."
        return finding(ours="–", verdict=FAILS, why=why)
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
    return finding(ours=f"{claim.quantity} {ours}", verdict=verdict, why=why, value=value)
