"""python-flint, loaded when first used: Arb balls, whose every operation encloses the true result."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from functools import cache
from typing import Any

from hophoop._support.extras import need

Ball = Any  # a flint.arb
Series = Any  # a flint.arb_series
Jet = list[Ball]  # Taylor coefficients: value, slope, half of the second derivative, …


@cache
def library() -> Any:
    """The module, looked up once: every ball is made by it."""
    return need("flint", "prove")


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    value = getattr(library(), name)
    globals()[name] = value
    return value


class Undecided(Exception):
    """A condition of the proof could not be shown; the text names it, as a clause."""


def arb(*values: Any) -> Ball:
    """A ball: of a number, or of a middle and a radius."""
    return library().arb(*values)


def series(coefficients: list[Any]) -> Series:
    """A power series, cut off where the present order is."""
    return library().arb_series(coefficients)


def rational(value: Fraction | int) -> Ball:
    """The ball of a rational number."""
    flint = library()
    number = Fraction(value)
    return flint.arb(flint.fmpq(number.numerator, number.denominator))


@contextmanager
def precision(bits: int) -> Iterator[None]:
    """Work at so many bits, and leave python-flint's global settings as they were."""
    ctx = library().ctx
    before, cap = ctx.prec, ctx.cap
    ctx.prec = bits
    try:
        yield
    finally:
        ctx.prec, ctx.cap = before, cap


@contextmanager
def order(terms: int) -> Iterator[None]:
    """Cut series off after so many terms."""
    ctx = library().ctx
    before = ctx.cap
    ctx.cap = terms
    try:
        yield
    finally:
        ctx.cap = before


def bits() -> int:
    """The present working precision."""
    return int(library().ctx.prec)


def pi() -> Ball:
    """π."""
    return library().arb.pi()


def symmetric(radius: Ball) -> Ball:
    """The interval [−radius, radius]."""
    return arb(0, radius.abs_upper())


def coefficients(value: Series, terms: int) -> Jet:
    """The first coefficients of a series (which drops trailing zeros)."""
    found = list(value.coeffs())[:terms]
    return found + [arb(0)] * (terms - len(found))


def polynomial(values: Jet, x: Ball) -> Ball:
    """Horner's scheme."""
    total = arb(0)
    for value in reversed(values):
        total = total * x + value
    return total
