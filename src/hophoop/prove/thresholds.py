"""Critical speeds and thresholds of the rolling start with the load up, proved to as many digits as asked."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass

from hophoop.precise.problem import Problem
from hophoop.prove._flint import Ball, Jet, Undecided, arb, bits, coefficients, order, pi, precision, series
from hophoop.prove.enclosures.maxima import Function, Highest, highest
from hophoop.prove.enclosures.roots import exact
from hophoop.prove.motion import REVOLUTION, Run
from hophoop.prove.physics.equations import Model
from hophoop.prove.proof import BITS_A_DIGIT, Enclosure, check_digits, enclosure
from hophoop.scenario import InputError, Scenario

GUARD_DIGITS = 12
BITS_A_MARGIN = 2.5  # of precision, for each bit that the speed is nearer to the border
START = 1e-9  # relative, on both sides of the double, for the border of the hop
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

    def __init__(self, model: Model) -> None:
        self.model = model

    def forces(self, th: Ball, w: Ball, terms: int) -> tuple[Jet, Jet]:
        """(F, N) as series in θ."""
        model = self.model
        with order(terms):
            z = series([th, 1])
            s, c = z.sin_cos()
            whole = model.inertia(arb(1)) * w / 2 + model.height(arb(0), arb(0), arb(1))
            found = model.rolling(s, c, 2 * (whole - model.height(z, s, c)) / model.inertia(c))
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
        return (1,) if self.model.level else (1, -1)


def over_turn(function: Function) -> Highest:
    """The highest value in the first turn."""
    return highest(function, arb(0), exact((2 * pi()).upper()))


def needed_friction(model: Model, w: Ball) -> Ball:
    """The friction that rolling through the first turn needs."""
    rolling = Rolling(model)
    value = arb(0)
    for side in rolling.sides():
        value = value.max(over_turn(rolling.ratio(w, side)).value)
    return value


def first_slip(model: Model) -> Ball:
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


def immediate_hop(model: Model) -> Ball:
    """Speed at the top from which on the hoop leaves the plane at once, in units of √(gR)."""
    return (model.gn / model.eps).sqrt()


def painleve_friction(model: Model) -> Ball:
    """The least friction with Painlevé's paradox at some angle."""

    def function(th: Ball, terms: int) -> Jet:
        with order(terms):
            s, c = series([th, 1]).sin_cos()
            lever = model.eps * s
            return coefficients(lever * (1 + model.eps * c) / (model.kap + lever * lever), terms)

    return 1 / highest(function, arb(0), exact((pi()).upper())).value


def hop_border(problem: Problem, low: Ball, high: Ball, wanted: Ball) -> Ball:
    """A speed of which both sides are proved: without a hop in the first turn at one end, with one at the other."""

    def hops(speed: Ball) -> bool:
        width = (high - low) / high
        enough = 60 + int(BITS_A_MARGIN * -float(width.log()) / math.log(2))
        for precise in (enough, 2 * enough):
            with precision(precise):
                run = Run(problem, {"start.speed": speed}, until=REVOLUTION, timed=False).run()
            if run.proved:
                return run.ending == "takeoff"
        raise Undecided(run.why)

    if hops(low) or not hops(high):
        raise Undecided("no border of the hop is where it was looked for")
    while not high - low < wanted:
        middle = exact((low + high) / 2)
        try:
            found = hops(middle)
        except Undecided:  # too close to the threshold: a little away from it
            middle = exact(low + (high - low) * 5 / 8)
            found = hops(middle)
        low, high = (low, middle) if found else (middle, high)
    return low.union(high)


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
    if problem.massless or not problem.gravity:
        raise InputError("Thresholds are proved for a hoop with mass in its ring, under gravity.")
    found: dict[str, ProvedNumber] = {}
    reasons = dict.fromkeys(keys, "the start is not a rolling one with the load up")
    if problem.resist:  # the others come out of the energy that rolling keeps without it
        reasons = {key: "it is not proved with rolling resistance" for key in keys if key != "immediate_hop_speed"}
        keys = [key for key in keys if key not in reasons]
        reasons |= dict.fromkeys(keys, "")
    for share in (1, 2):  # of precision: more where it was not enough
        with precision(int(share * (digits + GUARD_DIGITS) * BITS_A_DIGIT)):
            model = Model(problem)
            for key, statement, unit, scale, value in _numbers(scenario, problem, model, digits):
                if key not in keys or key not in reasons:
                    continue
                try:
                    number = value() * scale
                except Undecided as undecided:
                    reasons[key] = str(undecided)
                    continue
                reasons[key] = f"{digits} digits of it could not be shown"
                if number.rad() < abs(number) * arb(10) ** -digits:
                    found[key] = ProvedNumber(key, statement, unit, enclosure(number, arb(1), digits))
                    del reasons[key]
    return list(found.values()), reasons


def _numbers(
    scenario: Scenario, problem: Problem, model: Model, digits: int
) -> Iterator[tuple[str, str, str, Ball, Callable[[], Ball]]]:
    """(key, statement, unit, scale, value) of every threshold."""
    speed = model.speed
    yield (
        "first_slip_speed", "From rest at the top up to this speed the first turn is rolled, above it there is slip.", "m/s",
        speed, lambda: first_slip(model),
    )  # fmt: skip
    yield (
        "first_hop_speed", "Just below this speed there is no hop in the first turn, just above it there is one.", "m/s",
        speed / speed, lambda: _hop_speed(scenario, problem, digits),
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
        w = (model.start().om) ** 2
        yield (
            "needed_friction", f"Rolling through the first turn from {start.speed:g} m/s needs this friction.", "1",
            speed / speed, lambda: needed_friction(model, w),
        )  # fmt: skip


def _hop_speed(scenario: Scenario, problem: Problem, digits: int) -> Ball:
    """The threshold of the hop, searched next to the double that the kernel gives."""
    from hophoop.theory import first_hop_speed

    near = arb(float(first_hop_speed(scenario.hoop, scenario.plane)))
    with precision(max(bits(), int(3 * (digits + GUARD_DIGITS) * BITS_A_DIGIT))):
        low, high = exact(near * (1 - arb(START))), exact(near * (1 + arb(START)))
        return hop_border(problem, low, high, near * arb(10) ** (-digits - 2))
