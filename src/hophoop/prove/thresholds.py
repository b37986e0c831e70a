"""Critical speeds and thresholds of the rolling start with the load up, proved to as many digits as asked."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from hophoop.precise.problem import Problem
from hophoop.prove._flint import Ball, Jet, Series, Undecided, arb, coefficients, order, pi, precision, rational, series
from hophoop.prove.checker.check import check
from hophoop.prove.checker.conventions import Conventions
from hophoop.prove.checker.equations import Equations, Refused
from hophoop.prove.deadline import Deadline
from hophoop.prove.guide import FIRST, REVOLUTION, Mark, by_digits, by_doubles
from hophoop.prove.maxima import Function, highest
from hophoop.prove.proof import (
    BITS_A_DIGIT,
    CHECKER_GUARD,
    Enclosure,
    certificate_of,
    check_digits,
    enclosed,
    enclosure,
    walked,
)
from hophoop.scenario import InputError, Scenario, Start

GUARD_DIGITS = 12
BITS_A_MARGIN = 2.5  # of precision, for each bit that the speed is nearer to the border
AROUND = (Fraction(1, 10**13), Fraction(1, 10**9))  # relative, on both sides of the double, for the border of the hop


@dataclass(frozen=True)
class ProvedNumber:
    """A threshold with its enclosure.

    Attributes
    ----------
    key : str
        As in `hophoop.theory.summary`.
    statement : str
        What is proved of the number.
    unit : str
        Its unit; 1 for a pure number.
    enclosure : Enclosure
    """

    key: str
    statement: str
    unit: str
    enclosure: Enclosure


# --- rolling from the top, as functions of θ and of w = v0²/(gR)


def rolling(model: Equations, th: Ball, w: Any) -> tuple[Series, Series]:
    """(F, N) as series in θ; call it within `order`."""
    z = series([th, 1])
    s, c = z.sin_cos()
    whole = model.inertia(arb(1)) * w / 2 + model.height(arb(0), arb(0), arb(1))
    found = model.contact(s, c, 2 * (whole - model.height(z, s, c)) / model.inertia(c), 0)
    return series([0]) + found.friction, series([0]) + found.normal


def ratio(model: Equations, w: Ball, side: int) -> Function:
    """F/N, counted positive to one side."""

    def function(th: Ball, terms: int) -> Jet:
        with order(terms):
            friction, normal = rolling(model, th, w)
            if normal[0] < 0:
                raise Undecided("no friction is enough, for the hoop would leave the plane")
            if not normal[0] > 0:
                raise ZeroDivisionError
            return coefficients(side * friction / normal, terms)

    return function


def slipping(model: Equations, side: int) -> Function:
    """−B/A, where the margin to one side of the cone is A + B w: slip from w = A/−B on."""

    def function(th: Ball, terms: int) -> Jet:
        with order(terms):
            steady, moving = (
                model.mu_s * normal - side * friction for friction, normal in (rolling(model, th, w) for w in (0, 1))
            )
            if not steady[0] > 0:
                raise ZeroDivisionError
            return coefficients((steady - moving) / steady, terms)

    return function


def over_turn(model: Equations, function_of: Callable[[int], Function]) -> Ball:
    """The highest value in the first turn, at least 0, to both sides of the cone, which on the level are mirror images."""
    value = arb(0)
    for side in (1,) if model.gt.is_zero() else (1, -1):
        value = value.max(highest(function_of(side), arb(0), (2 * pi()).upper().mid()))
    return value


# --- the thresholds


def needed_friction(model: Equations, w: Ball) -> Ball:
    """The friction that rolling through the first turn needs."""
    return over_turn(model, lambda side: ratio(model, w, side))


def first_slip(model: Equations) -> Ball:
    """Speed at the top from which on there is slip in the first turn, in units of √(gR)."""
    if model.mu_s is None:
        raise Undecided("friction is infinite")
    if not needed_friction(model, arb(0)) < model.mu_s:
        raise Undecided("even the smallest push slips, as far as can be told")
    value = over_turn(model, lambda side: slipping(model, side))
    if not value > 0:
        raise Undecided("no speed leads to slip")
    return value.rsqrt()


def painleve_friction(model: Equations) -> Ball:
    """The least friction with Painlevé's paradox at some angle."""

    def function(th: Ball, terms: int) -> Jet:
        with order(terms):
            s, c = series([th, 1]).sin_cos()
            lever = model.eps * s
            return coefficients(lever * (1 + model.eps * c) / (model.kap + lever * lever), terms)

    return 1 / highest(function, arb(0), pi().upper().mid())


def start_friction(scenario: Scenario, model: Equations) -> Ball:
    """The friction that the scenario's own start needs."""
    if scenario.start.speed is None or scenario.start.angle != 0.0:
        raise Undecided("the start is not a rolling one with the load up")
    return needed_friction(model, model.start.om**2)


def hop_border(scenario: Scenario, digits: int) -> Ball:
    """From a speed without a hop in the first turn to one with a hop [m/s]: found in extended precision, both proved."""
    from hophoop.theory import first_hop_speed

    near = float(first_hop_speed(scenario.hoop, scenario.plane))
    if not math.isfinite(near):
        raise Undecided("no speed leads to a hop, as far as doubles can tell")
    started = scenario.replace("start", Start.rolling(near))
    problem, rough = Problem.of(started), by_doubles(started, REVOLUTION, FIRST)

    def motion(speed: Fraction, apart: Fraction) -> list[Mark]:
        """Of a speed that is so far from the border."""
        exact = replace(problem, omega=speed / problem.radius)
        found = by_digits(exact, rough, GUARD_DIGITS + int(-math.log10(apart / near)), REVOLUTION, FIRST, Deadline())
        if found is None:
            raise Undecided("the border of the hop takes too many steps")
        return found

    def hops(speed: Fraction, apart: Fraction) -> bool:
        first = (
            one.after == "H" for one in motion(speed, apart) if one.after == "H" or one.kind == "turn" or one.angle > 2 * pi()
        )
        return next(first, False)

    for around in AROUND:
        apart = around * Fraction(near)
        low, high = Fraction(near) - apart, Fraction(near) + apart
        if hops(high, apart) and not hops(low, apart):
            break
    else:
        raise Undecided("no border of the hop is where it was looked for")
    while high - low > low / 10 ** (digits + 2):
        middle = (low + high) / 2
        low, high = (low, middle) if hops(middle, high - low) else (middle, high)
    bits = 60 + int(BITS_A_MARGIN * (digits + 2) * BITS_A_DIGIT)
    for speed, ends in ((low, False), (high, True)):
        why, ending = first_turn(started, speed, motion(speed, high - low), 10.0 ** -(digits // 2 + 4), bits)
        if why or (ending == "takeoff") != ends:
            raise Undecided(why or "a speed at the border of the hop ends otherwise than it was computed")
    return rational(low).union(rational(high))


def first_turn(scenario: Scenario, speed: Fraction, guide: Sequence[Mark], wide: float, bits: int) -> tuple[str, str]:
    """(why the first revolution of an exact speed is not proved, or '', its ending)."""
    exact = scenario.to_dict()
    exact["start"]["speed"] = speed
    conventions = Conventions(exact, REVOLUTION, 0, FIRST, bits + CHECKER_GUARD)
    walk, why = walked(conventions, guide, wide, bits, Deadline())
    if why:
        return why, ""
    events, _ = enclosed(walk, 1, Deadline())
    verdict = check(certificate_of(walk, exact, events, 0))
    return verdict.why, str(walk.claim["ending"])


def thresholds(scenario: Scenario, digits: int = 30, keys: Collection[str] | None = None) -> list[ProvedNumber]:
    """Critical speeds and thresholds of a hoop on its plane, each proved to its last digit.

    Parameters
    ----------
    scenario : Scenario
        Its hoop and plane count, and the speed of a rolling start with the load up.
    digits : int, default 30
        From 1 to 200 [1].
    keys : collection of str, optional
        Some of KEYS, by default all: first_slip_speed, first_hop_speed, immediate_hop_speed, painleve_friction,
        needed_friction.

    Returns
    -------
    numbers : list of ProvedNumber
        Those that this hoop has and that could be proved.

    Raises
    ------
    ValueError
        If digits is out of its range, the hoop is massless, or there is no gravity.
    """
    return decided(scenario, digits, KEYS if keys is None else keys)[0]


def decided(scenario: Scenario, digits: int, keys: Collection[str]) -> tuple[list[ProvedNumber], dict[str, str]]:
    """`thresholds`, and why each of the others that were asked for is not proved, as a clause."""
    check_digits(digits)
    problem = Problem.of(scenario)
    if problem.kap == 0 or not problem.gravity:
        raise InputError("Thresholds are proved for a hoop with mass in its ring, under gravity.")
    found: dict[str, ProvedNumber] = {}
    reasons = dict.fromkeys(keys, "")
    if problem.resist:  # the others come out of the energy that rolling keeps without it
        reasons |= {key: "it is not proved with rolling resistance" for key in keys if key != "immediate_hop_speed"}
    for share in (1, 2):  # of precision: more where it was not enough
        with precision(int(share * (digits + GUARD_DIGITS) * BITS_A_DIGIT)):
            model = Equations(scenario.to_dict())
            for key, (statement, unit, value) in NUMBERS.items():
                if key not in reasons or (problem.resist and key != "immediate_hop_speed"):
                    continue
                try:
                    number = value(scenario, model, digits)
                except (Undecided, Refused) as undecided:
                    reasons[key] = str(undecided)
                    continue
                reasons[key] = f"{digits} digits of it could not be shown"
                if number.rad() < abs(number) * arb(10) ** -digits:
                    found[key] = ProvedNumber(
                        key, statement.format(scenario.start.speed), unit, enclosure(number, arb(1), digits)
                    )
                    del reasons[key]
    return list(found.values()), reasons


# What is proved of each number, with its unit, in SI units.
NUMBERS: dict[str, tuple[str, str, Callable[[Scenario, Equations, int], Ball]]] = {
    "first_slip_speed": (
        "From rest at the top up to this speed the first turn is rolled, above it there is slip.", "m/s",
        lambda scenario, model, digits: first_slip(model) * model.speed,
    ),
    "first_hop_speed": (
        "Just below this speed there is no hop in the first turn, just above it there is one.", "m/s",
        lambda scenario, model, digits: hop_border(scenario, digits),
    ),
    "immediate_hop_speed": (
        "From this speed on the hoop leaves the plane at the top.", "m/s",
        lambda scenario, model, digits: (model.gn / model.eps).sqrt() * model.speed,
    ),
    "painleve_friction": (
        "Painlevé's paradox exists at some angle for more friction than this, for less at none.", "1",
        lambda scenario, model, digits: painleve_friction(model),
    ),
    "needed_friction": (
        "Rolling through the first turn from {:g} m/s needs this friction.", "1",
        lambda scenario, model, digits: start_friction(scenario, model),
    ),
}  # fmt: skip
KEYS = tuple(NUMBERS)
