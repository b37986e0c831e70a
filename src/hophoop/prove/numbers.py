"""Balls of python-flint (Arb) as the kernel's numbers: a comparison is certain, or it raises `Unclear`."""

from __future__ import annotations

import operator
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

from hophoop._support.extras import need

Comparison = Callable[[Any, Any], bool]
Number = Any  # a Ball, or what computes like one

BITS_A_DIGIT = 3.3219280948873626
LOCK = threading.RLock()  # python-flint's settings are those of the whole process


class Library:
    """python-flint, loaded when first used."""

    def __getattr__(self, name: str) -> Any:
        value = getattr(need("flint", "prove"), name)
        setattr(self, name, value)
        return value


flint = Library()


def arb(*values: Any) -> Any:
    """A ball of python-flint: of a number, or of a middle and a radius."""
    return flint.arb(*values)


def arb_poly(values: Any) -> Any:
    """A polynomial."""
    return flint.arb_poly(values)


def arb_series(values: Any) -> Any:
    """A power series, cut off where the present setting says."""
    return flint.arb_series(values)


class Unclear(ArithmeticError):
    """The present precision does not decide something that the motion depends on; the text names it, as a clause."""


class Ball:
    """A number within the radius of its ball; an operation without a bounded result raises `Unclear`.

    Parameters
    ----------
    value : Ball, arb, float or int
        A float that is nan stands for itself: comparisons with it are False.
    """

    __slots__ = ("v",)

    def __init__(self, value: Any) -> None:
        self.v: Any = value.v if isinstance(value, Ball) else bounded(value) if isinstance(value, flint.arb) else arb(value)

    def __abs__(self) -> Ball:
        return Ball(abs(self.v))

    def __neg__(self) -> Ball:
        return Ball(-self.v)

    def __bool__(self) -> bool:
        return not raw(self).is_zero() and ball(self) != 0

    __hash__ = None  # type: ignore[assignment]


def ball(value: Any) -> Number:
    """The number of a ball of python-flint, a float or an integer."""
    return Ball(value)


def raw(value: Any) -> Any:
    """The ball of python-flint in a number."""
    return value.v if isinstance(value, Ball) else value


def bounded(value: Any) -> Any:
    """The same ball, unless it is nan."""
    if value.is_nan():
        raise Unclear("an operation has a bounded result")
    return value


def rational(value: Fraction | int) -> Number:
    """The ball of a rational number."""
    number = Fraction(value)
    return Ball(arb(flint.fmpq(number.numerator, number.denominator)))


def root(value: Number) -> Number:
    """√x."""
    return Ball(raw(value).sqrt())


def _operate(name: str, compute: Callable[[Any, Any], Any]) -> None:
    def wrapped(found: Any) -> Any:
        return Ball(found) if isinstance(found, flint.arb) else found  # or a model or a series

    setattr(Ball, f"__{name}__", lambda self, other: wrapped(compute(self.v, raw(other))))
    setattr(Ball, f"__r{name}__", lambda self, other: wrapped(compute(raw(other), self.v)))


def _compare(name: str, yes: Comparison, no: Comparison, same: bool) -> None:
    def compare(self: Ball, other: Any) -> bool:
        a, b = self.v, arb(raw(other))
        if a.is_nan() or b.is_nan():
            return name == "ne"
        if self is other or yes(a, b) or no(a, b):
            return same if self is other else yes(a, b)
        raise Unclear("a comparison is certain")

    setattr(Ball, f"__{name}__", compare)


for _name in ("add", "sub", "mul", "truediv"):
    _operate(_name, getattr(operator, _name))
for _name, _no, _same in (
    ("lt", "ge", False), ("le", "gt", True), ("gt", "le", False), ("ge", "lt", True), ("eq", "ne", True), ("ne", "eq", False),
):  # fmt: skip
    _compare(_name, getattr(operator, _name), getattr(operator, _no), _same)


def sign(value: Any, rounding: Any = 0) -> int:
    """Sign of a number, 0 where it is exactly zero."""
    return 1 if value > 0 else 0 if value == 0 else -1


@contextmanager
def setting(bits: int | None = None, terms: int | None = None) -> Iterator[None]:
    """Work at so many bits, with series of so many terms; other threads wait, and the settings are as before afterwards."""
    with LOCK:
        ctx = flint.ctx
        before = ctx.prec, ctx.cap
        try:
            ctx.prec, ctx.cap = bits or ctx.prec, terms or ctx.cap
            yield
        finally:
            ctx.prec, ctx.cap = before


def precision() -> int:
    """The present working precision in bits."""
    return int(flint.ctx.prec)
