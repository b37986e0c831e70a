"""All statements of the article that can be checked, in its order."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from importlib.resources import files
from typing import Any

from hophoop.article import rolling, slipping
from hophoop.article.runs import Runs
from hophoop.article.statement import FAILS, Result, Statement, Texts

STATED: dict[str, dict[str, Any]] = tomllib.loads(files("hophoop.article").joinpath("statements.toml").read_text("utf-8"))


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
    for key in STATED:
        found.append(_checked(key, runs))
        if progress is not None:
            progress(key)
    return tuple(found)


def _checked(key: str, runs: Runs) -> Statement:
    """Check one statement; it fails if the computed motion lacks its subject."""
    stated = STATED[key]
    check: Callable[[Runs], Result] = getattr(rolling if hasattr(rolling, key) else slipping, key)
    try:
        holds, numbers = check(runs)
        texts: dict[str, Any] = {name: Texts().format(text, **numbers) for name, text in stated.items()}
    except (IndexError, StopIteration, ValueError):
        lacking = {"article": "–", "ours": "–", "why": "The computed motion lacks the subject of the statement."}
        return Statement(key=key, **stated | lacking | {"verdict": FAILS})
    return Statement(key=key, **texts | ({} if holds else {"verdict": FAILS}), numbers=numbers)
