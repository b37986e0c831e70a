"""All statements of the article that can be checked, in its order."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from importlib.resources import files
from typing import Any

from hophoop.article import rolling, slipping
from hophoop.article.runs import Runs
from hophoop.article.statement import FAILS, Result, Statement

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
    for key, stated in STATED.items():
        result = _check(key, runs)._asdict()
        own = {name: value for name, value in result.items() if value or name not in stated}
        found.append(Statement(key=key, **stated | own))
        if progress is not None:
            progress(key)
    return tuple(found)


def _check(key: str, runs: Runs) -> Result:
    """Check one statement; it fails if the computed motion lacks its subject."""
    check: Callable[[Runs], Result] = getattr(rolling if hasattr(rolling, key) else slipping, key)
    try:
        return check(runs)
    except (IndexError, StopIteration, ValueError):
        return Result("–", FAILS, {}, why="The computed motion lacks the subject of the statement.")
