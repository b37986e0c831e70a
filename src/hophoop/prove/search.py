"""The first root of several functions: every interval before it is shown to have none, and the root to be the only one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from hophoop.prove._flint import Ball, Jet, Undecided, arb, bits, intersection

# (x, terms) → Taylor coefficients of each function in x, valid on the whole ball x.
Evaluate = Callable[[Ball, int], Sequence[Jet]]


@dataclass(frozen=True)
class Root:
    """The first root: which function has it, its enclosure, and the exact bracket in which it is the only one."""

    index: int
    x: Ball
    low: Ball
    high: Ball


def exact(x: Ball) -> Ball:
    """The middle of a ball."""
    return x.mid()


def first_root(
    evaluate: Evaluate, zeros: Sequence[int], begin: Ball, end: Ball, step: Ball | None = None, narrowest: int | None = None
) -> Root | None:
    """The first root in (begin, end] of functions that are positive just after `begin`.

    Parameters
    ----------
    evaluate : callable
    zeros : sequence of int
        Per function, how many derivatives (the value is the zeroth) are known to be zero at the begin; the next one
        is then shown to be positive on the first interval.
    begin, end : Ball
        Exact numbers.
    step : Ball, optional
        First width that is tried.
    narrowest : int, optional
        Binary exponent of the narrowest interval, below which it is given up.

    Raises
    ------
    Undecided
        Where a function touches zero, or nearly so, or two have a root at once.
    """
    width = (end - begin).mid() if step is None else step
    least = arb(2) ** (-bits() // 2 if narrowest is None else narrowest)
    at, known = begin, list(zeros)
    while at < end:
        to = exact(at + width)
        if not to < end:
            to = end
        try:
            verdict = _judge(evaluate, known, at, to)
        except (ValueError, ZeroDivisionError):  # a divisor may vanish on so wide an interval
            verdict = None
        if verdict is None:
            width = exact((to - at) / 2)
            if not width > least:
                raise Undecided("an event comes too close to not happening")
            continue
        if verdict:
            return _earliest(evaluate, [Root(k, refined(evaluate, k, at, to), at, to) for k in verdict])
        at, known = to, [-1] * len(known)
        width = exact((width * 3) / 2)
    return None


def _judge(evaluate: Evaluate, known: Sequence[int], at: Ball, to: Ball) -> list[int] | None:
    """Indices of the functions with a root in (at, to]; None where that cannot be told.

    `known` is −1 where the function is already shown to be positive at `at`.
    """
    whole = at.union(to)
    terms = max(2, max(known, default=0) + 1)
    jets = evaluate(whole, terms)
    middle = exact(whole)
    centre: Sequence[Jet] | None = None
    last: Sequence[Jet] | None = None
    roots = []
    for k, jet in enumerate(jets):
        if known[k] > 0:
            lead = jet[known[k]]
            if lead > 0:
                continue
            if lead < 0:
                raise Undecided("a quantity that starts at zero goes the other way")
            return None
        if jet[0] > 0:
            continue
        if jet[1] > 0:
            if known[k] < 0 or evaluate(at, 1)[k][0] > 0:
                continue
            return None
        if centre is None:
            centre = evaluate(middle, 1)
        if centre[k][0] + jet[1] * (whole - middle) > 0:
            continue
        if not jet[1] < 0:
            return None
        if known[k] == 0 and not evaluate(at, 1)[k][0] > 0:
            return None
        if last is None:
            last = evaluate(to, 1)
        if last[k][0] > 0:
            continue
        if not last[k][0] < 0:
            return None
        roots.append(k)
    return roots


def refined(evaluate: Evaluate, k: int, low: Ball, high: Ball) -> Ball:
    """The root in a bracket on which the function falls, by the interval Newton method."""
    x = low.union(high)
    for _ in range(200):
        middle = exact(x)
        value, slope = evaluate(middle, 1)[k][0], evaluate(x, 2)[k][1]
        following = intersection(x, middle - value / slope)
        if not following.rad() < x.rad() * 3 / 4:
            return following
        x = following
    return x


def _earliest(evaluate: Evaluate, roots: list[Root]) -> Root:
    first = roots[0]
    for other in roots[1:]:
        if other.x < first.x:
            first = other
        elif not first.x < other.x:
            raise Undecided("two events come at the same time, as far as can be told")
    return first
