"""What the article says, next to what we find."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from hophoop.article.verdicts import Judged


@dataclass(frozen=True, kw_only=True)
class Statement(Judged):
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
