"""All claims by year, and their verdicts."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterable
from functools import cache, partial
from importlib.resources import files

from pydantic import TypeAdapter

from hophoop.article import rolling, slipping
from hophoop.article.runs import Runs
from hophoop.article.statement import Check
from hophoop.article.statements import check_statement
from hophoop.claims.claim import Claim, Finding, check_claim
from hophoop.scenario import InputError

ARTICLE = "Sonnerlind2023"
# Statements of the article with a number and without a long motion; `hophoop reproduce` checks all of them.
FROM_ARTICLE: tuple[Check, ...] = (
    rolling.friction_needed,
    rolling.faster_utilization,
    rolling.critical_speed,
    slipping.littlewood,
    slipping.hops,
    slipping.positive_potential,
    slipping.landing,
    slipping.impact_loss,
    slipping.low_friction,
    slipping.low_friction_slips,
)

Progress = Callable[[int, int], None]


def claims_of(text: str) -> tuple[Claim, ...]:
    """Read claims from TOML.

    Parameters
    ----------
    text : str
        One table per claim, named by its key.

    Returns
    -------
    claims : tuple of Claim
        In the order of the text.

    Raises
    ------
    pydantic.ValidationError
        If a field is missing or unknown, or a claim names a work or a function that does not exist.
    """
    entries = {key: {"key": key, **entry} for key, entry in tomllib.loads(text).items()}
    return tuple(TypeAdapter(dict[str, Claim]).validate_python(entries).values())


@cache
def registry() -> tuple[Claim, ...]:
    """Return all claims with a number, except those of the article.

    Returns
    -------
    claims : tuple of Claim
        By the year of the work.

    Examples
    --------
    >>> registry()[0].work
    'Routh1877'
    """
    text = files("hophoop.claims").joinpath("claims.toml").read_text(encoding="utf-8")
    return tuple(sorted(claims_of(text), key=lambda claim: claim.work[-4:]))


def works() -> tuple[str, ...]:
    """Return the works of the claims.

    Returns
    -------
    keys : tuple of str
        Keys of references.bib, by year.

    Examples
    --------
    >>> "Littlewood1953" in works()
    True
    """
    return tuple(sorted({claim.work for claim in registry()} | {ARTICLE}, key=lambda work: (work[-4:], work)))


def count(chosen: Iterable[str] = ()) -> int:
    """Return the number of claims.

    Parameters
    ----------
    chosen : iterable of str
        Keys of works; empty for all of them.

    Returns
    -------
    number : int
    """
    wanted = _check_works(chosen)
    return sum(claim.work in wanted for claim in registry()) + (len(FROM_ARTICLE) if ARTICLE in wanted else 0)


def findings(chosen: Iterable[str] = (), progress: Progress | None = None) -> tuple[Finding, ...]:
    """Compute our number of each claim and check its verdict.

    Parameters
    ----------
    chosen : iterable of str
        Keys of works; empty for all of them.
    progress : callable, optional
        Called with the number of claims done and of all.

    Returns
    -------
    findings : tuple of Finding
        By the year of the work. A claim whose number has changed has the verdict 'fails'.

    Raises
    ------
    ValueError
        If there is no claim of a chosen work.

    Examples
    --------
    >>> [one.verdict for one in findings(["Kane1984"])]
    ['agrees']
    """
    wanted, total = _check_works(chosen), count(chosen)
    found = []
    for work in sorted(wanted, key=works().index):
        for judge in _judges(work):
            found.append(judge())
            if progress is not None:
                progress(len(found), total)
    return tuple(found)


def _check_works(chosen: Iterable[str]) -> tuple[str, ...]:
    wanted = tuple(dict.fromkeys(chosen))
    for work in wanted:
        if work not in works():
            raise InputError(f"work = {work} must be one of {', '.join(works())}.", field="work", value=work)
    return wanted or works()


def _judges(work: str) -> list[Callable[[], Finding]]:
    if work == ARTICLE:
        runs = Runs()
        return [partial(_of_article, check, runs) for check in FROM_ARTICLE]
    return [partial(check_claim, claim) for claim in registry() if claim.work == work]


def _of_article(check: Check, runs: Runs) -> Finding:
    one = check_statement(check, runs)
    return Finding(
        key=one.key,
        work=ARTICLE,
        claim=one.statement,
        theirs=one.article,
        ours=one.ours,
        verdict=one.verdict,
        why=one.why,
    )
