"""Critical speeds and thresholds of the rolling start with the load up, proved to as many digits as asked."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from hophoop.precise.problem import Problem
from hophoop.prove.models import padded
from hophoop.prove.motion import Body, Run
from hophoop.prove.numbers import BITS_A_DIGIT, Unclear, arb, arb_series, ball, flint, precision, rational, raw, setting
from hophoop.prove.roots import Function
from hophoop.prove.solver import REVOLUTION, Enclosure, check_digits, enclosure, prove_problem
from hophoop.scenario import InputError, Scenario, Start

GUARD_DIGITS = 12
BITS_A_MARGIN = 2.5  # of precision, for each bit that the speed is nearer to the border
AROUND = (Fraction(1, 10**13), Fraction(1, 10**9))  # relative, on both sides of the double, for the border of the hop
FIRST = 200  # events of a first revolution
MOST_PARTS = 1000  # of an interval in which a maximum may be


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


# --- the highest value of an analytic function on an interval, by branch and bound on balls


def highest(function: Function, low: Any, high: Any) -> Any:
    """Return the highest value on [low, high], exact numbers."""
    marks, best = [(low, high)], function(low, 1)[0].max(function(high, 1)[0])
    for _ in range(precision() // 2):
        bounds = [_bound(function, a.union(b)) for a, b in marks]
        middles = [((a + b) / 2).mid() for a, b in marks]
        for middle in middles:
            best = best.max(function(middle, 1)[0])
        kept = [(a, x, b) for (a, b), x, bound in zip(marks, middles, bounds, strict=True) if not bound < best]
        marks = [part for a, x, b in kept for part in ((a, x), (x, b))]
        if len(marks) > MOST_PARTS:
            raise Unclear("a largest value is no flat one")
    for a, b in marks:
        best = best.union(best.max(_bound(function, a.union(b))))
    return best


def _bound(function: Function, whole: Any) -> Any:
    """A ball of all values on a ball."""
    try:
        middle = whole.mid()
        return function(middle, 1)[0] + function(whole, 2)[1] * (whole - middle)
    except (Unclear, ZeroDivisionError):
        return arb(math.inf)


# --- rolling from the top, as functions of θ and of w = v0²/(gR)


def rolling(body: Any, th: Any, w: Any) -> tuple[Any, Any]:
    """(F, N) as series in θ; call it with as many terms."""
    z = arb_series([th, 1])
    u = body.of.rolling_u(body, ball(0), ball(w), z)
    friction, normal = body.of.rolling_forces(body, *z.sin_cos(), u, ball(0))
    return arb_series([0]) + raw(friction), arb_series([0]) + raw(normal)


def ratio(body: Any, w: Any, side: int) -> Function:
    """F/N, counted positive to one side."""

    def function(th: Any, terms: int) -> list[Any]:
        with setting(terms=terms):
            friction, normal = rolling(body, th, w)
            if normal[0] < 0:
                raise InsufficientFriction("no friction is enough, for the hoop would leave the plane")
            return divided(side * friction, normal, terms)

    return function


def slipping(body: Any, side: int) -> Function:
    """−B/A, where the margin to one side of the cone is A + B w: slip from w = A/−B on."""

    def function(th: Any, terms: int) -> list[Any]:
        with setting(terms=terms):
            steady, moving = (raw(body.mu_s) * n - side * f for f, n in (rolling(body, th, w) for w in (0, 1)))
            return divided(steady - moving, steady, terms)

    return function


class InsufficientFriction(Exception):
    """A threshold that does not exist."""


def divided(a: Any, b: Any, terms: int) -> list[Any]:
    """The quotient of two series, the second of which is positive."""
    if not b[0] > 0:
        raise Unclear("a divisor is positive")
    return padded(a / b, terms)


def over_turn(body: Any, function_of: Callable[[int], Function]) -> Any:
    """The highest value in the first turn, at least 0, to both sides of the cone, which on the level are mirror images."""
    value = arb(0)
    for side in (1,) if body.gt == 0 else (1, -1):
        value = value.max(highest(function_of(side), arb(0), (2 * flint.arb.pi()).upper().mid()))
    return value


# --- the thresholds


def first_slip(body: Any) -> Any:
    """Speed at the top from which on there is slip in the first turn, in units of √(gR)."""
    if body.mu_s == math.inf:
        raise InsufficientFriction("friction is infinite")
    if not over_turn(body, lambda side: ratio(body, arb(0), side)) < raw(body.mu_s):
        raise InsufficientFriction("even the smallest push slips, as far as can be told")
    value = over_turn(body, lambda side: slipping(body, side))
    if not value > 0:
        raise InsufficientFriction("no speed leads to slip")
    return value.rsqrt()


def painleve_friction(body: Any) -> Any:
    """The least friction with Painlevé's paradox at some angle."""

    def function(th: Any, terms: int) -> list[Any]:
        with setting(terms=terms):
            arm, lever = body.of.contact_arms(body, *arb_series([th, 1]).sin_cos())
            return divided(arb_series([0]) + lever * arm, arb_series([0]) + body.kap + lever * lever, terms)

    return 1 / highest(function, arb(0), flint.arb.pi().upper().mid())


def start_friction(scenario: Scenario, body: Any) -> Any:
    """The friction that the scenario's own start needs."""
    if scenario.start.speed is None or scenario.start.angle != 0.0:
        raise InsufficientFriction("the start is not a rolling one with the load up")
    w = raw(body.start().om * body.start().om)
    return over_turn(body, lambda side: ratio(body, w, side))


def hop_border(scenario: Scenario, digits: int) -> Any:
    """From a speed without a hop in the first turn to one with a hop [m/s], both proved."""
    from hophoop.theory import first_hop_speed

    near = float(first_hop_speed(scenario.hoop, scenario.plane))
    if not math.isfinite(near):
        raise InsufficientFriction("no speed leads to a hop, as far as doubles can tell")
    started = scenario.replace("start", Start.rolling(near))
    problem = Problem.of(started)

    def hops(speed: Fraction, apart: Fraction) -> bool:
        exact, bits = replace(problem, omega=speed / problem.radius), 60 - BITS_A_MARGIN * math.log2(apart / speed)
        found = prove_problem(started, exact, 1, REVOLUTION, FIRST, lambda: False, int(bits))
        if not found.proved:
            raise InsufficientFriction(found.why)
        return found.ending == "takeoff"

    for around in AROUND:
        apart = around * Fraction(near)
        low, high = Fraction(near) - apart, Fraction(near) + apart
        if hops(high, apart) and not hops(low, apart):
            break
    else:
        raise InsufficientFriction("no border of the hop is where it was looked for")
    while high - low > low / 10 ** (digits + 2):
        middle = (low + high) / 2
        low, high = (low, middle) if hops(middle, high - low) else (middle, high)
    return raw(rational(low)).union(raw(rational(high)))


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
    # the others come out of the energy that rolling keeps without resistance
    asked = [key for key in NUMBERS if key in keys and (not problem.resist or key == "immediate_hop_speed")]
    reasons = {key: "" if key in asked else "it is not proved with rolling resistance" for key in keys}
    found: dict[str, ProvedNumber] = {}
    for share in (1, 2):  # of precision: more where it was not enough
        with setting(int(share * (digits + GUARD_DIGITS) * BITS_A_DIGIT)):
            body = Run(problem, ball(0), True, 0, lambda: None).body
            for key in asked:
                if key in found:
                    continue
                statement, unit, value = NUMBERS[key]
                try:
                    number = value(scenario, body, digits)
                except (Unclear, InsufficientFriction, ZeroDivisionError) as reason:
                    reasons[key] = str(reason)
                    continue
                reasons[key] = f"{digits} digits of it could not be shown"
                if number.rad() < abs(number) * arb(10) ** -digits:
                    found[key] = ProvedNumber(key, statement.format(scenario.start.speed), unit, enclosure(number, digits))
                    del reasons[key]
    return list(found.values()), reasons


# What is proved of each number, with its unit, in SI units.
NUMBERS: dict[str, tuple[str, str, Callable[[Scenario, Body, int], Any]]] = {
    "first_slip_speed": (
        "From rest at the top up to this speed the first turn is rolled, above it there is slip.", "m/s",
        lambda scenario, body, digits: first_slip(body) * raw(body.length / body.time),
    ),
    "first_hop_speed": (
        "Just below this speed there is no hop in the first turn, just above it there is one.", "m/s",
        lambda scenario, body, digits: hop_border(scenario, digits),
    ),
    "immediate_hop_speed": (
        "From this speed on the hoop leaves the plane at the top.", "m/s",
        lambda scenario, body, digits: raw(body.gn / body.eps).sqrt() * raw(body.length / body.time),
    ),
    "painleve_friction": (
        "Painlevé's paradox exists at some angle for more friction than this, for less at none.", "1",
        lambda scenario, body, digits: painleve_friction(body),
    ),
    "needed_friction": (
        "Rolling through the first turn from {:g} m/s needs this friction.", "1",
        lambda scenario, body, digits: start_friction(scenario, body),
    ),
}  # fmt: skip
KEYS = tuple(NUMBERS)
