"""A statement of the article with our result."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from hophoop.article.verdicts import Verdict


@dataclass(frozen=True, kw_only=True)
class Statement(Verdict):
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

    section: str
    statement: str
    article: str
    numbers: dict[str, Any] = field(default_factory=dict)

    _json = ("key", "section", "statement", "article", "ours", "verdict", "why", "numbers")


Check = Callable[[Any], Statement]
