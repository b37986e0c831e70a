"""Roots and signs of functions whose Taylor coefficients on a ball are known."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from hophoop.prove.numbers import Unclear, arb, precision

Function = Callable[[Any, int], list[Any]]  # (x, terms) → Taylor coefficients, valid on the ball x
BRACKETS = 8  # attempts to bracket a root, each 8 times as wide as the one before


def positive_until(f: Function, zeros: int, end: Any) -> Any:
    """Up to where a function is positive whose first derivatives vanish at 0: the next one is positive there."""
    for _ in range(precision()):
        if f(arb(0).union(end), zeros + 1)[zeros] > 0:
            return end
        end = (end / 16).mid()
    raise Unclear("a function that is zero at the start of a phase rises")


def first_root(f: Function, begin: Any, end: Any) -> tuple[Any, Any] | None:
    """A bracket of the first root of a function that is positive at the beginning; None if there is none up to the end."""
    part = arb(1) / 2 - arb(1) / precision()
    work, least = [(begin, end)], (begin if begin > 0 else end) * arb(2) ** (-precision() // 2)
    while work:
        a, b = work.pop()
        # a root may be close to 0; another precision divides elsewhere, as no root may be where an interval is divided
        whole, middle = a.union(b), ((a * b).sqrt() if b > 4 * a > 0 else a + part * (b - a)).mid()
        slope = f(whole, 2)[1]
        if f(middle, 1)[0] + slope * (whole - middle) > 0 or (slope > 0 and f(a, 1)[0] > 0) or (slope < 0 and f(b, 1)[0] > 0):
            continue
        if slope < 0 and f(b, 1)[0] < 0:
            return bracket(f, a, b)
        if not b - a > least:
            raise Unclear("a function that comes close to zero has a sign there")
        work += [(middle, b), (a, middle)]
    return None


def bracket(f: Function, a: Any, b: Any) -> tuple[Any, Any]:
    """A narrow bracket of the root of a function that falls from a to b, both exact."""
    low, high, x = a, b, ((a + b) / 2).mid()
    for _ in range(precision()):
        value, slope = f(x, 2)[:2]
        if not (value > 0 or value < 0):
            break
        low, high = (low, x) if value < 0 else (x, high)
        near = (x - value / slope).mid()
        x = near if low < near and near < high else ((low + high) / 2).mid()
    value, slope = f(x, 2)[:2]
    wide = (2 * value.rad() / abs(slope) + abs(x) * arb(2) ** (8 - precision())).upper()
    for _ in range(BRACKETS):
        low, high = (x - wide).mid().max(a), (x + wide).mid().min(b)
        if f(low, 1)[0] > 0 and f(high, 1)[0] < 0:
            return low, high
        wide *= 8
    raise Unclear("a root is bracketed")
