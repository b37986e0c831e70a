"""Critical speeds and thresholds of the rolling start with the load up, proved to as many digits as asked."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from hophoop.precise.problem import Problem
from hophoop.prove._flint import Ball, Jet, Undecided, arb, coefficients, order, pi, precision, rational, series
from hophoop.prove.checker.check import check
from hophoop.prove.checker.conventions import Conventions
from hophoop.prove.checker.equations import Equations, Refused
from hophoop.prove.deadline import Deadline
from hophoop.prove.guide import FIRST, REVOLUTION, Mark, by_digits, by_doubles
from hophoop.prove.maxima import Function, Highest, highest
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
KEYS = ("first_slip_speed", "first_hop_speed", "immediate_hop_speed", "painleve_friction", "needed_friction")


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


class Rolling:
    """Rolling from the top as functions of θ and of w = v0²/(gR)."""

    def __init__(self, model: Equations) -> None:
        self.model = model

    def forces(self, th: Ball, w: Ball, terms: int) -> tuple[Jet, Jet]:
        """(F, N) as series in θ."""
        model = self.model
        with order(terms):
            z = series([th, 1])
            s, c = z.sin_cos()
            whole = model.inertia(arb(1)) * w / 2 + model.height(arb(0), arb(0), arb(1))
            found = model.contact(s, c, 2 * (whole - model.height(z, s, c)) / model.inertia(c), 0)
            return coefficients(series([0]) + found.friction, terms), coefficients(series([0]) + found.normal, terms)

    def ratio(self, w: Ball, side: int) -> Function:
        """F/N, counted positive to one side."""

        def function(th: Ball, terms: int) -> Jet:
            friction, normal = self.forces(th, w, terms)
            if normal[0] < 0:
                raise Undecided("no friction is enough, for the hoop would leave the plane")
            if not normal[0] > 0:
                raise ZeroDivisionError
            with order(terms):
                return coefficients(side * series(friction) / series(normal), terms)

        return function

    def slipping(self, side: int) -> Function:
        """−B/A, where the margin to one side of the cone is A + B w: slip from w = A/−B on."""
        mu = self.model.mu_s

        def function(th: Ball, terms: int) -> Jet:
            friction0, normal0 = self.forces(th, arb(0), terms)
            friction1, normal1 = self.forces(th, arb(1), terms)
            with order(terms):
                steady = mu * series(normal0) - side * series(friction0)
                moving = mu * series(normal1) - side * series(friction1)
                if not coefficients(steady, 1)[0] > 0:
                    raise ZeroDivisionError
                return coefficients((steady - moving) / steady, terms)

        return function

    def sides(self) -> tuple[int, ...]:
        """Which sides of the cone have to be looked at: on the level both are mirror images."""
        return (1,) if self.model.gt.is_zero() else (1, -1)


def over_turn(function: Function) -> Highest:
    """The highest value in the first turn."""
    return highest(function, arb(0), (2 * pi()).upper().mid())


def needed_friction(model: Equations, w: Ball) -> Ball:
    """The friction that rolling through the first turn needs."""
    rolling = Rolling(model)
    value = arb(0)
    for side in rolling.sides():
        value = value.max(over_turn(rolling.ratio(w, side)).value)
    return value


def first_slip(model: Equations) -> Ball:
    """Speed at the top from which on there is slip in the first turn, in units of √(gR)."""
    if model.mu_s is None:
        raise Undecided("friction is infinite")
    rolling = Rolling(model)
    if not needed_friction(model, arb(0)) < model.mu_s:
        raise Undecided("even the smallest push slips, as far as can be told")
    value = arb(0)
    for side in rolling.sides():
        value = value.max(over_turn(rolling.slipping(side)).value)
    if not value > 0:
        raise Undecided("no speed leads to slip")
    return value.rsqrt()


def immediate_hop(model: Equations) -> Ball:
    """Speed at the top from which on the hoop leaves the plane at once, in units of √(gR)."""
    return (model.gn / model.eps).sqrt()


def painleve_friction(model: Equations) -> Ball:
    """The least friction with Painlevé's paradox at some angle."""

    def function(th: Ball, terms: int) -> Jet:
        with order(terms):
            s, c = series([th, 1]).sin_cos()
            lever = model.eps * s
            return coefficients(lever * (1 + model.eps * c) / (model.kap + lever * lever), terms)

    return 1 / highest(function, arb(0), pi().upper().mid()).value


def hop_border(scenario: Scenario, digits: int) -> Ball:
    """From a speed without a hop in the first turn to one with a hop [m/s]: found in extended precision, both proved."""
    from hophoop.theory import first_hop_speed

    near = float(first_hop_speed(scenario.hoop, scenario.plane))
    if not math.isfinite(near):
        raise Undecided("no speed leads to a hop, as far as doubles can tell")
    rolling = scenario.replace("start", Start.rolling(near))
    problem, rough = Problem.of(rolling), by_doubles(rolling, REVOLUTION, FIRST)

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
        why, ending = first_turn(rolling, speed, motion(speed, high - low), 10.0 ** -(digits // 2 + 4), bits)
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
    reasons = dict.fromkeys(keys, "the start is not a rolling one with the load up")
    if problem.resist:  # the others come out of the energy that rolling keeps without it
        reasons = {key: "it is not proved with rolling resistance" for key in keys if key != "immediate_hop_speed"}
        keys = [key for key in keys if key not in reasons]
        reasons |= dict.fromkeys(keys, "")
    for share in (1, 2):  # of precision: more where it was not enough
        with precision(int(share * (digits + GUARD_DIGITS) * BITS_A_DIGIT)):
            model = Equations(scenario.to_dict())
            for key, statement, unit, scale, value in _numbers(scenario, model, digits):
                if key not in keys or key not in reasons:
                    continue
                try:
                    number = value() * scale
                except (Undecided, Refused) as undecided:
                    reasons[key] = str(undecided)
                    continue
                reasons[key] = f"{digits} digits of it could not be shown"
                if number.rad() < abs(number) * arb(10) ** -digits:
                    found[key] = ProvedNumber(key, statement, unit, enclosure(number, arb(1), digits))
                    del reasons[key]
    return list(found.values()), reasons


def _numbers(scenario: Scenario, model: Equations, digits: int) -> Iterator[tuple[str, str, str, Ball, Callable[[], Ball]]]:
    """(key, statement, unit, scale, value) of every threshold."""
    speed = model.speed
    yield (
        "first_slip_speed", "From rest at the top up to this speed the first turn is rolled, above it there is slip.", "m/s",
        speed, lambda: first_slip(model),
    )  # fmt: skip
    yield (
        "first_hop_speed", "Just below this speed there is no hop in the first turn, just above it there is one.", "m/s",
        speed / speed, lambda: hop_border(scenario, digits),
    )  # fmt: skip
    yield (
        "immediate_hop_speed", "From this speed on the hoop leaves the plane at the top.", "m/s",
        speed, lambda: immediate_hop(model),
    )  # fmt: skip
    yield (
        "painleve_friction", "Painlevé's paradox exists at some angle for more friction than this, for less at none.", "1",
        speed / speed, lambda: painleve_friction(model),
    )  # fmt: skip
    start = scenario.start
    if start.speed is not None and start.angle == 0.0:
        w = model.start.om**2
        yield (
            "needed_friction", f"Rolling through the first turn from {start.speed:g} m/s needs this friction.", "1",
            speed / speed, lambda: needed_friction(model, w),
        )  # fmt: skip
