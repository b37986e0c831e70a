"""All statements of the article that can be checked, in its order."""

from __future__ import annotations

from collections.abc import Callable

from hophoop.article import rolling, slipping
from hophoop.article.runs import Runs
from hophoop.article.statement import Check, Statement
from hophoop.article.verdicts import FAILS

SECTIONS = ("A First Attempt", "Increase the Speed", "Let's Hop!", "Revisiting Low Friction")


def statements(runs: Runs | None = None, progress: Callable[[str], None] | None = None) -> tuple[Statement, ...]:
    """Check every statement of the article against computed motions.

    Parameters
    ----------
    runs : Runs, optional
        The motions, if already computed.
    progress : callable, optional
        Called with the key of each checked statement.

    Returns
    -------
    statements : tuple of Statement
        In the order of the article's sections.

    References
    ----------
    :cite:t:`Sonnerlind2023`.
    """
    runs = runs or Runs()
    found = []
    for check in (*rolling.CHECKS, *slipping.CHECKS):
        statement = check_statement(check, runs)
        found.append(statement)
        if progress is not None:
            progress(statement.key)
    return tuple(sorted(found, key=lambda statement: SECTIONS.index(statement.section)))


def check_statement(check: Check, runs: Runs) -> Statement:
    """Check one statement; it fails if the computed motion lacks its subject."""
    try:
        return check(runs)
    except (IndexError, StopIteration, ValueError):
        why = "The computed motion lacks the subject of the statement."
        return Statement(
            key=check.__name__, section=SECTIONS[0], statement=check.__name__, article="–", ours="–", verdict=FAILS, why=why
        )


def count() -> int:
    """Return the number of statements."""
    return len(rolling.CHECKS) + len(slipping.CHECKS)
