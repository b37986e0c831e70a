"""The highest value of an analytic function on an interval, by branch and bound on balls."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from hophoop.prove._flint import Ball, Jet, Undecided, arb, bits
from hophoop.prove.checker.intervals import root

Function = Callable[[Ball, int], Jet]  # (x, terms) → Taylor coefficients, valid on the ball x
PARTS = 64


def highest(function: Function, low: Ball, high: Ball) -> Ball:
    """Return the highest value on [low, high], exact numbers; raise Undecided if a maximum is too flat to be located."""
    width = (high - low) / PARTS
    marks = [low, *((low + width * k).mid() for k in range(1, PARTS)), high]
    best = function(low, 1)[0]
    for mark in marks[1:]:
        best = best.max(function(mark, 1)[0])
    work = list(pairwise(marks))
    while work:
        a, b = work.pop()
        if not b - a > arb(2) ** (-bits() // 2):
            raise Undecided("a largest value is too flat to be told")
        verdict = _top(function, a, b, best)
        if verdict is None:
            middle = ((a + b) / 2).mid()
            work += [(a, middle), (middle, b)]
        else:
            for top in verdict:
                best = best.max(function(top, 1)[0])
    return best


def _top(function: Function, a: Ball, b: Ball, best: Ball) -> list[Ball] | None:
    """Tops inside [a, b] that may be the highest, apart from the ends of the whole interval; None: look closer."""
    whole = a.union(b)
    try:
        jet = function(whole, 3)
    except (ValueError, ZeroDivisionError):
        return None
    middle = whole.mid()
    if jet[0] < best or function(middle, 1)[0] + jet[1] * (whole - middle) < best:
        return []
    if jet[1] > 0 or jet[1] < 0:
        return []
    if not jet[2] < 0:
        return None
    first, last = function(a, 2)[1], function(b, 2)[1]
    if first < 0 or last > 0:
        return []
    if not (first > 0 and last < 0):
        return None

    def slope(x: Ball, terms: int) -> list[Jet]:
        found = function(x, terms + 1)
        return [[(k + 1) * found[k + 1] for k in range(terms)]]

    return [root(slope, 0, a, b, "a top is alone")]
