"""The first root of several functions: every interval before it is shown to have none, and the root to be the only one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from hophoop.prove._flint import Ball, Jet, Undecided, arb, bits, intersection

# (x, terms) → Taylor coefficients of each function in x, valid on the whole ball x.
Evaluate = Callable[[Ball, int], Sequence[Jet]]


LEAST_WIDE = 11  # bits: a shorter interval of a box would not decide either
LONGER = 4  # times an interval is doubled
ORDER = 5  # of Taylor's theorem, where the mean value theorem leaves an interval open
SPREAD = [-1]  # a root may lie on both sides of the end of an interval


class Close(Undecided):
    """A root could not be decided; there is none up to `at`.

    Parameters
    ----------
    at : Ball
    """

    def __init__(self, at: Ball) -> None:
        super().__init__("an event comes too close to not happening")
        self.at = at


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
    evaluate: Evaluate,
    zeros: Sequence[int],
    begin: Ball,
    end: Ball,
    step: Ball | None = None,
    wide: bool = False,
    begun: bool = False,
) -> Root | None:
    """The first root in (begin, end] of functions that are positive just after `begin`.

    Parameters
    ----------
    evaluate : callable
    zeros : sequence of int
        Per function, how many derivatives (the value is the zeroth) are known to be zero at the start; the next one
        is then shown to be positive on the first interval.
    begin, end : Ball
        Exact numbers.
    step : Ball, optional
        First width that is tried.
    wide : bool, optional
        True if a box of parameters may spread a root over much of the interval: second derivatives then tell
        the signs of slopes on wider intervals, and what grows from a zero is known to be positive as long as it does so.
    begun : bool, optional
        Whether the zeros were further back.

    Raises
    ------
    Undecided
        Where a function touches zero, or nearly so, or two have a root at once.
    """
    width = (end - begin).mid() if step is None else step
    least = arb(2) ** (-LEAST_WIDE if wide else -bits() // 2)
    at, known, looked = begin, list(zeros), None
    while at < end:
        to = exact(at + width)
        if not to < end:
            to = end
        try:
            verdict = _judge(evaluate, known, at, to, wide, begun)
            if verdict is SPREAD and looked is not at:
                looked = at
                verdict, to = _longer(evaluate, known, at, to, end, begun)
        except (ValueError, ZeroDivisionError):  # a divisor may vanish on so wide an interval
            verdict = None
        if verdict is None or verdict is SPREAD:
            width = exact((to - at) / 2)
            if not width > least:
                raise Close(at)
            continue
        if verdict:
            return _earliest(evaluate, [Root(k, refined(evaluate, k, at, to, wide), at, to) for k in verdict])
        at, begun = to, True
        known = [zeros if wide and zeros > 0 else -1 for zeros in known]
        width = exact((width * 3) / 2)
    return None


def _longer(
    evaluate: Evaluate, known: Sequence[int], at: Ball, to: Ball, end: Ball, begun: bool
) -> tuple[list[int] | None, Ball]:
    """The same on longer intervals, which may hold all of a spread root."""
    further = to
    for _ in range(LONGER):
        further = exact(at + 2 * (further - at))
        if not further < end:
            further = end
        verdict = _judge(evaluate, known, at, further, True, begun)
        if verdict is not SPREAD or not further < end:
            break
    return (verdict, further) if verdict and verdict is not SPREAD else (None, to)


def _expanded(evaluate: Evaluate, k: int, whole: Ball, most: int = ORDER) -> tuple[Ball, Ball]:
    """(value, slope) on an interval by Taylor's theorem about its middle, to the order of the coefficients that there are."""
    middle = exact(whole)
    try:
        last = evaluate(whole, most + 1)[k]
    except Undecided:  # about a turning point there are two coefficients
        last = evaluate(whole, 2)[k]
    way = whole - middle
    value, slope = last[-1], (len(last) - 1) * last[-1]
    for power, one in reversed(list(enumerate(evaluate(middle, len(last) - 1)[k]))):
        value = one + value * way
        slope = power * one + slope * way if power else slope
    return value, slope


def _judge(evaluate: Evaluate, known: Sequence[int], at: Ball, to: Ball, wide: bool, begun: bool) -> list[int] | None:
    """Indices of the functions with a root in (at, to]; None if undecided, SPREAD if it may be decided further on.

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
            if not begun:
                if lead < 0:
                    raise Undecided("a quantity that starts at zero goes the other way")
                return None
        if jet[0] > 0:
            continue
        if jet[1] > 0:
            if known[k] < 0 or begun or evaluate(at, 1)[k][0] > 0:
                continue
            return None
        if centre is None:
            centre = evaluate(middle, 1)
        if centre[k][0] + jet[1] * (whole - middle) > 0:
            continue
        if not jet[1] < 0:
            value, slope = _expanded(evaluate, k, whole, 2 if wide else ORDER)
            if value > 0 or (slope > 0 and known[k] < 0):
                continue
            if not slope < 0:
                return None
        if known[k] == 0 and not begun and not evaluate(at, 1)[k][0] > 0:
            return None
        if last is None:
            last = evaluate(to, 1)
        if last[k][0] > 0:
            continue
        if not last[k][0] < 0:
            return SPREAD if wide else None
        roots.append(k)
    return roots


def refined(evaluate: Evaluate, k: int, low: Ball, high: Ball, bent: bool = False) -> Ball:
    """The root in a bracket on which the function falls, by the interval Newton method."""
    x = low.union(high)
    for _ in range(200):
        middle = exact(x)
        value, slope = evaluate(middle, 1)[k][0], evaluate(x, 2)[k][1]
        if bent or not slope < 0:
            slope = intersection(slope, _expanded(evaluate, k, x, 2 if bent else ORDER)[1])
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
