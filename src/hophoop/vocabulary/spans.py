"""Spans of a motion, such as ``revolutions:3``: what ends a map's motions, and `simulate` with ``until``."""

from __future__ import annotations

import math


def number_after(word: str, text: object) -> float:
    """Return the number in a text such as ``revolutions:3``.

    Parameters
    ----------
    word : str
        Before the colon.
    text : str

    Returns
    -------
    number : float
        nan if the text does not start with the word, or no finite number follows.

    Examples
    --------
    >>> number_after("revolutions", "revolutions:3")
    3.0
    """
    found, _, number = str(text).partition(":")
    try:
        value = float(number) if found == word else math.nan
    except ValueError:
        return math.nan
    return value if math.isfinite(value) else math.nan
