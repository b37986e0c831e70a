"""Continuation of a gait along its branch, from step to step, with what is met on the way."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from hophoop.gaits.equation import GaitEquation, Pair, Values
from hophoop.gaits.margins import GaitMargin, margins_of
from hophoop.gaits.special import BORDER, DOUBLING, END, FOLD, JOINS, LIMIT, TOP, Special

LONGEST_STEP, SHORTEST_STEP = 0.02, 1e-9  # along the branch, in (θ̇ in √(g/R), parameter over a tenth of its range)
MOST_POINTS = 4_000
ROUNDS = 60  # of bisection
NEAREST = 1e-15  # along the branch: to rounding
BESIDE = 1e-9  # distance at which the pieces next to a boundary of the word are looked for
CORNER, UNUSUAL = 0.05, 3.0  # change of the multiplier in a step, and relative to the step before, that may be a corner's
UNKNOWN, BASELINE = 1e-5, 1e-4  # along the branch: around a corner, and of the line that is extended to it
AT_LIMIT = 1e-8  # scaled parameter: within it a branch has reached the limit of its range
NEAR_TOP = 1e-3  # √(g/R): least θ̇ of a period that ends at the top
MET = 1e-4  # the largest margin of a boundary that ends a branch
JOINED = 1e-7  # √(g/R): within it θ̇ after a part of the period is the same


class Point(NamedTuple):
    place: Pair
    values: Values
    equation: GaitEquation

    @property
    def margins(self) -> tuple[GaitMargin, ...]:
        """Distances of the gait from the boundaries of its sequence, the smallest first."""
        gait = self.equation.gait(self.place)
        return margins_of(gait.motion(), gait.section)


def apart(one: Point, other: Point) -> float:
    """Return the distance of two points, in θ̇ and the parameter where they have different modes."""
    if one.equation.names == other.equation.names:
        return float(np.linalg.norm(other.place - one.place))
    omegas = [point.place[point.equation.names.index("omega")] for point in (one, other)]
    return float(np.hypot(omegas[1] - omegas[0], other.place[-1] - one.place[-1]))


def is_same_piece(one: Values, other: Values) -> bool:
    """Return True if two near points have the same word, and no corner of the map between them."""
    return one.key == other.key and abs(one.trace - other.trace) < CORNER


def advance(here: Point, way: Pair, step: float) -> Point | None:
    """Return the solution a step further along a direction."""
    guess = here.place + step * way
    found = here.equation.solve(guess, way, float(way @ guess))
    return None if found is None else Point(*found, here.equation)


def furthest(here: Point, way: Pair, step: float, keeps: Callable[[Point], bool]) -> tuple[Point, Point | None, float]:
    """Return the last point along a direction that keeps a property, the first one without it, if one is, and its distance."""
    low, high = 0.0, step
    last, first = here, None
    while low < (middle := 0.5 * (low + high)) < high and high - low > NEAREST:
        tried = advance(here, way, middle)
        if tried is not None and keeps(tried):
            low, last = middle, tried
        else:
            high, first = middle, first if tried is None else tried
    return last, first, low


class Follower:
    """The points of one direction along a branch."""

    def __init__(self, first: Point, bounds: tuple[float, float]) -> None:
        self.bounds = bounds
        self.points = [first]
        self.special: list[Special] = []

    def run(self, direction: Pair) -> None:
        """Follow the branch until it ends or leaves the range."""
        way, step = direction, LONGEST_STEP
        while len(self.points) < MOST_POINTS:
            here = self.points[-1]
            ahead = advance(here, way, step)
            if ahead is None or float(np.linalg.norm(ahead.place - here.place)) > 2.0 * step:
                step *= 0.5
                if step > SHORTEST_STEP:
                    continue
                beyond = self.pass_border(here, way, None)
                if beyond is None:
                    self.end(here)
                    return
                way, step = beyond, LONGEST_STEP / 8.0
                continue
            if not self.bounds[0] + AT_LIMIT <= ahead.place[-1] <= self.bounds[1] - AT_LIMIT:
                self.leave(here, ahead)
                return
            if ahead.values.apart < JOINED < here.values.apart:
                self.join(here, way, step)
                return
            if ahead.values.key != here.values.key:
                last, next_one = self.border(here, way, step)
                if step > UNKNOWN and (next_one is None or apart(last, next_one) > UNKNOWN):
                    step *= 0.25  # the step met another part of the branch, for instance beyond a fold
                    continue
                beyond = self.pass_border(last, way, next_one)
                if beyond is None:
                    self.end(last)
                    return
                way, step = beyond, min(2.0 * step, LONGEST_STEP)
                continue
            self.interval(here, ahead, way, step)
            self.points.append(ahead)
            turned = ahead.values.tangent
            way = turned if turned @ way > 0.0 else -turned
            step = min(1.5 * step, LONGEST_STEP)

    def border(self, here: Point, way: Pair, step: float) -> tuple[Point, Point | None]:
        """Return the last point with the word of `here`, and the first one with another, to rounding."""
        last, first, _ = furthest(here, way, step, lambda point: point.values.key == here.values.key)
        return last, first

    def pass_border(self, last: Point, way: Pair, beyond: Point | None) -> Pair | None:
        """Add a border collision, and go on on its other side; return the direction, or None if nothing goes on there."""
        new = beyond if beyond is not None else self.beside(last, way)
        if new is None or is_same_piece(new.values, last.values):
            return None
        for sign in (1.0, -1.0):
            tangent = sign * new.values.tangent
            if beyond is not None and sign < 0.0 and tangent @ way < 0.0 and self.goes_on(new, -tangent):
                continue
            if self.goes_on(new, tangent):
                if last is not self.points[-1]:
                    self.points.append(last)
                factors = (last.values.multiplier, new.values.multiplier)
                self.add(BORDER, last, factors, self.named(last, new))
                self.points.append(new)
                return tangent
        return None

    def named(self, one: Point, other: Point) -> str:
        """Return the boundary between two points, the smallest margin of both, and their words."""
        margins = [margin for point in (one, other) for margin in point.margins[:1]]
        sequences = f"{one.values.sequence} | {other.values.sequence}"
        least = min(margins, key=lambda margin: margin.value)
        moved = one.equation.mode != other.equation.mode and least.value > MET
        return f"{'slip at the section' if moved else least.boundary}: {sequences}"

    def goes_on(self, new: Point, tangent: Pair) -> bool:
        """Return True if the branch goes on with the word of a point in a direction."""
        tried = advance(new, tangent, 1e-5)
        return tried is not None and is_same_piece(tried.values, new.values)

    def beside(self, last: Point, way: Pair) -> Point | None:
        """Return a solution next to a point that has another word, where no step leads on."""
        shifts = [sign * unit for unit in np.eye(len(last.place)) for sign in (1.0, -1.0)]
        places = [
            (last.equation, last.place + distance * shift)
            for shift in shifts
            for distance in (BESIDE, 1e2 * BESIDE, 1e4 * BESIDE)
        ]
        further = (last.equation.other(last.place + distance * way) for distance in (BESIDE, 1e2 * BESIDE, 1e4 * BESIDE))
        places += [other for other in further if other is not None]
        for equation, place in places:
            values = equation(place)
            if values is None or is_same_piece(values, last.values):
                continue
            found = equation.solve(place, values.tangent, float(values.tangent @ place))
            if found is None or not is_same_piece(found[1], values):
                continue
            new = Point(*found, equation)
            if apart(last, new) < BASELINE:
                return new
        return None

    def join(self, here: Point, way: Pair, step: float) -> None:
        """Add the point at which a gait becomes one of a part of its period."""
        last, _, low = furthest(here, way, step, lambda point: point.values.apart > JOINED)
        if last is not self.points[-1]:
            self.interval(here, last, way, low)
            self.points.append(last)
        self.add(JOINS, last, (last.values.multiplier,), "")

    def interval(self, here: Point, ahead: Point, way: Pair, step: float) -> None:
        """Add what is between two points of one word: a corner of the map, a fold or a period doubling."""
        change = abs(ahead.values.trace - here.values.trace)
        before = self.points[-2].values if len(self.points) > 1 else here.values
        usual = abs(here.values.trace - before.trace) if before.key == here.values.key else 0.0
        corner = self.corner(here, ahead, way, step) if change > max(CORNER, UNUSUAL * usual) else None
        if corner is None:
            self.between(here, ahead)
            return
        one, other = corner
        self.between(here, one)
        self.add(BORDER, one, (one.values.multiplier, other.values.multiplier), self.named(one, other))
        self.points += [one, other]
        self.between(other, ahead)

    def corner(self, here: Point, ahead: Point, way: Pair, step: float) -> tuple[Point, Point] | None:
        """Return the points on both sides of a corner of the map: there the multiplier jumps, but no word changes."""
        middle = 0.5 * (here.values.trace + ahead.values.trace)
        low, high, one, other = 0.0, step, here, ahead
        for _ in range(ROUNDS):
            half = 0.5 * (low + high)
            tried = advance(one, way, half - low) or advance(other, way, half - high)
            if tried is None or half in (low, high):
                break
            if (tried.values.trace - middle) * (here.values.trace - middle) > 0.0:
                low, one = half, tried
            else:
                high, other = half, tried
        left = abs(other.values.trace - one.values.trace)
        jumps = left > 0.5 * abs(ahead.values.trace - here.values.trace) and high - low < UNKNOWN
        return (self.towards(here, one, way, low), other) if jumps else None

    def towards(self, here: Point, one: Point, way: Pair, step: float) -> Point:
        """Return the point at which the smallest margin is 0, by a line through two points before it.

        Within about 1e-7 of such a corner doubles do not decide the derivative.
        """
        before = advance(here, way, step - BASELINE)
        if before is None:
            return one
        values = [point.margins[0].value for point in (before, one)]
        if not 0.0 <= values[1] < values[0]:
            return one
        share = values[1] / (values[0] - values[1])
        return one._replace(place=one.place + share * (one.place - before.place))

    def between(self, here: Point, ahead: Point) -> None:
        """Add a fold or period doubling between two points."""
        for kind, critical in ((FOLD, 1.0), (DOUBLING, -1.0)):
            one, other = here.values.off(critical), ahead.values.off(critical)
            if one * other < 0.0:
                share = one / (one - other)
                guess = here.place + share * (ahead.place - here.place)
                found = here.equation.solve_with(guess, critical)
                if found is not None:
                    self.add(kind, Point(*found, here.equation), (critical,), "")

    def leave(self, here: Point, ahead: Point) -> None:
        """Add the point at the limit of the range, or an end before it if there is no gait."""
        limit = self.bounds[0] if ahead.place[-1] < self.bounds[0] + AT_LIMIT else self.bounds[1]
        last = self.at_value(here, ahead.place, limit)
        reached = last is not None
        if last is None:
            last, beyond = here, limit
            for _ in range(ROUNDS):
                middle = 0.5 * (last.place[-1] + beyond)
                found = self.at_value(last, last.place + last.values.tangent, middle)
                if found is None:
                    beyond = middle
                else:
                    last = found
                if abs(beyond - last.place[-1]) < AT_LIMIT:
                    break
        self.between(here, last)
        if reached:
            self.points.append(last)
            self.add(LIMIT, last, (last.values.multiplier,), "")
        else:
            self.end(last)

    def at_value(self, here: Point, further: Pair, value: float) -> Point | None:
        """Return the solution of the word at a value of the scaled parameter near the line from a point to a place."""
        share = (value - here.place[-1]) / (further[-1] - here.place[-1])
        guess = here.place + share * (further - here.place)
        found = here.equation.solve(guess, np.eye(len(guess))[-1], value)
        return Point(*found, here.equation) if found is not None and found[1].key == here.values.key else None

    def end(self, last: Point) -> None:
        """Add the end of a branch."""
        if last is not self.points[-1]:
            self.points.append(last)
        outside = min(abs(float(last.place[-1]) - bound) for bound in self.bounds) < AT_LIMIT
        if outside:  # a value beyond may not be allowed at all, such as a restitution below 0
            self.add(LIMIT, last, (last.values.multiplier,), "")
            return
        margins = last.margins
        slowest = next(margin.value for margin in margins if margin.boundary == "turns back")
        met = margins[0].boundary if margins[0].value < MET else ""
        top = slowest < NEAR_TOP
        self.add(TOP if top else END, last, (last.values.multiplier,), "" if top else met)

    def add(self, kind: str, point: Point, factors: tuple[float, ...], event: str) -> None:
        one, place = point.equation, point.place
        special = Special(kind, event, one.parameter(place), one.omega(place), factors, one.gait(place), one, place)
        self.special.append(special)
