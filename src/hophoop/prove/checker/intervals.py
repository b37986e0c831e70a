"""Inequalities on intervals, and a root that a certificate names."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from hophoop.prove._flint import Ball, Jet, polynomial
from hophoop.prove.checker.equations import Refused

Functions = Callable[[Ball, int], Sequence[Jet]]  # (x, terms) → Taylor coefficients of each, valid on the ball x
MOST_PARTS = 4000
ORDER = 5  # of Taylor's theorem, where an interval about its middle leaves open what is claimed


def require(fact: bool, what: str) -> None:
    """Refuse a step whose condition is not certain."""
    if not fact:
        raise Refused(what)


def shown(clear: Callable[[Ball, Ball, bool], bool], low: Ball, high: Ball, what: str, most: int = MOST_PARTS) -> None:
    """Refuse unless `clear` is true on parts that cover an interval; its last argument is whether a part begins it."""
    work = [(low, high, True)]
    for _ in range(most):
        if not work:
            return
        a, b, starts = work.pop()
        try:
            done = clear(a, b, starts)
        except (ValueError, ZeroDivisionError):  # a divisor may vanish on so wide an interval
            done = False
        if not done:
            middle = ((a + b) / 2).mid()
            require(bool(a < middle) and bool(middle < b), what)
            work += [(middle, b, False), (a, middle, starts)]
    require(not work, what)


def positive(functions: Functions, begin: Ball, end: Ball, what: str, zeros: Sequence[int] | None = None) -> None:
    """Refuse unless all functions are positive on (begin, end].

    `zeros` counts, per function, the derivatives that vanish at the start (the value included): the next one is then
    shown to be positive on the part that starts there. Such a `begin` may be a ball.
    """
    low, high = begin.lower(), end.upper()
    first = list(zeros or [])
    terms = max([1, *first]) + 1
    if low < high:
        shown(lambda a, b, starts: _clear(functions, a, b, terms, first if starts else []), low, high, what)


def _clear(functions: Functions, a: Ball, b: Ball, terms: int, zeros: Sequence[int]) -> bool:
    whole = a.union(b)
    middle = whole.mid()
    jets = functions(whole, terms)
    centre: Sequence[Jet] | None = None
    for k, jet in enumerate(jets):
        known = zeros[k] if k < len(zeros) else 0
        if known:
            if not jet[known] > 0:
                return False
        elif not jet[0] > 0:
            centre = functions(middle, 1) if centre is None else centre
            if not centre[k][0] + jet[1] * (whole - middle) > 0 and not expanded(functions, k, whole)[0] > 0:
                return False
    return True


def expanded(functions: Functions, index: int, x: Ball) -> Jet:
    """(value, slope) of one function on an interval by Taylor's theorem about its middle, with all terms that it has."""
    try:
        far = functions(x, ORDER + 1)[index]
    except Refused:  # about a turning point there are no more
        far = functions(x, 2)[index]
    size = len(far) - 1
    terms = [*functions(x.mid(), size)[index], far[size]]
    slopes = [k * terms[k] for k in range(1, size + 1)]
    return [polynomial(terms, x - x.mid()), polynomial(slopes, x - x.mid())]


def root(functions: Functions, index: int, low: Ball, high: Ball, what: str) -> Ball:
    """The only root of one function in [low, high], where it falls from above to below zero; all others are positive there."""

    def others(x: Ball, terms: int) -> list[Jet]:
        return [jet for k, jet in enumerate(functions(x, terms)) if k != index]

    require(bool(functions(low, 1)[index][0] > 0), f"{what}: not before its bracket")
    require(bool(functions(high, 1)[index][0] < 0), f"{what}: not within its bracket")
    positive(others, low, high, f"{what}: something else comes in its bracket")

    def falls(a: Ball, b: Ball, _: bool) -> bool:
        x = a.union(b)
        return bool(functions(x, 2)[index][1] < 0) or bool(expanded(functions, index, x)[1] < 0)

    shown(falls, low.lower(), high.upper(), f"{what}: only one in its bracket")
    x = low.union(high)
    for _ in range(100):
        middle = x.mid()
        try:
            slope = functions(x, 2)[index][1]
            slope = slope if slope < 0 else expanded(functions, index, x)[1]
            step = middle - functions(middle, 1)[index][0] / slope
        except (ValueError, ZeroDivisionError):
            break
        if not step.is_finite():
            break
        require(bool(x.overlaps(step)), f"{what}: it is in its bracket")
        closer = x.intersection(step)
        if not closer.rad() < x.rad() * 3 / 4:
            return closer
        x = closer
    return x
