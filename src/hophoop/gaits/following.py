"""Follow a gait over a parameter: by steps along its branch on a piece of the map, and from piece to piece at the borders."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from hophoop.gaits.branch import BORDER, DOUBLING, END, FOLD, JOINS, LIMIT, TOP, Branch, Special
from hophoop.gaits.differences import Floats, last_kept
from hophoop.gaits.gait import Gait
from hophoop.gaits.kernels.layout import BRANCHES, MODE
from hophoop.gaits.maps import SectionMap, place_of, value_of
from hophoop.gaits.points import Point
from hophoop.kernel.model import MODE_LETTERS
from hophoop.scenario import InputError, Scenario
from hophoop.scenario.paths import parameter

Progress = Callable[[float], object]

TENTH = 0.1  # of the range: unit of the scaled parameter
LONGEST_STEP = 0.02  # along the branch, in (coordinates in units of R and √(R/g), scaled parameter)
SHORTEST_STEP = 1e-9  # without a gait within it a piece ends
NEXT = 1e-5  # within it two gaits are on both sides of a border
NEAREST = 1e-15  # along the branch: to rounding
MOST_POINTS = 4_000
BESIDE = (1e-12, 1e-9, 1e-7, 1e-5)  # distances at which the pieces next to a border are looked for
SAME = 1e-5  # of multipliers: where an impact's branch changes, but nothing else, no border is reported
STEPS, KNOWN = 20, 1e-9  # of the secant rule, and the last one: the next would be rounding
AT_LIMIT = 1e-8  # scaled parameter: within it a branch has reached the limit of its range
SAMPLES, NEAR_TOP = 400, 1e-3  # of a period, and the least θ̇ of one that ends at the top [√(g/R)]
JOINED = 2e-8  # relative to 1 + θ̇: within it the state after a part of the period is the same
RADIUS, MASS, GRAVITY = "hoop.radius", "hoop.mass", "plane.gravity"


def follow(gait: Gait, path: str, bounds: tuple[float, float], progress: Progress | None = None) -> Branch:
    """Follow a gait over a parameter, from the branch's end below it to that above; `Gait.follow` calls and describes this."""
    value, low, high = range_of(gait.scenario, path, bounds)
    scale = TENTH * (high - low)
    image_of = SectionMap(gait.scenario, gait.period, gait.section, gait.passages.mode[-1], path, scale)
    place = image_of.point(gait.scenario.start, value)
    first = Point(image_of, place).solve(np.eye(len(place))[-1])
    if first is None or not first.known:
        raise InputError.of_field("path", path, "a parameter whose derivative exists at this gait")
    rising = math.copysign(1.0, first.tangent[-1]) * first.tangent
    back, ahead = (Follower(first, (low / scale, high / scale), sign) for sign in (-1, 1))
    complete = True
    try:
        for k, half in enumerate((back, ahead)):
            half.run(half.sign * rising)
            if progress is not None:
                progress(0.5 * (k + 1))
    except KeyboardInterrupt:
        complete = False
    return Branch((*reversed(back.points), *ahead.points[1:]), (*reversed(back.special), *ahead.special), complete)


def range_of(scenario: Scenario, path: str, bounds: tuple[float, float]) -> tuple[float, float, float]:
    """Return a scenario's value of a parameter, and the bounds between which its gaits are followed; refuse others."""
    value = value_of(scenario, path)
    if path in (RADIUS, MASS, GRAVITY):
        raise InputError.of_field("path", path, f"a parameter other than {RADIUS}, {MASS} and {GRAVITY}")
    try:
        low, high = (float(bound) for bound in bounds)
    except (TypeError, ValueError):
        raise InputError.of_field("bounds", bounds, "two numbers") from None
    if not (-math.inf < low <= value <= high < math.inf and low < high):
        unit = f" {parameter(path).unit}" if parameter(path).unit else ""
        raise InputError(f"low = {low!r} and high = {high!r} must be finite and on both sides of {path} = {value!r}{unit}.")
    if path == "plane.slope" and low < 0.0 < high:
        raise InputError.of_field("bounds", bounds, "slopes of one sign: on the level there is no gait")
    return value, low, high


class Follower:
    """The points of one direction along a branch; with a sign of −1 the one that the branch begins with, in reverse."""

    def __init__(self, first: Point, bounds: tuple[float, float], sign: int) -> None:
        self.bounds, self.sign = bounds, sign
        self.points = [first]
        self.special: list[Special] = []

    def run(self, way: Floats) -> None:
        """Follow the branch in a direction until it ends or leaves the range."""
        step = LONGEST_STEP
        while len(self.points) < MOST_POINTS:
            here = self.points[-1]
            ahead = self.ahead(way, step)
            if ahead is not None and on_one_piece(here, ahead):
                self.append(ahead)
                if self.is_limit(ahead):
                    self.add(LIMIT, ahead)
                    return
                way = math.copysign(1.0, ahead.tangent @ way) * ahead.tangent
                step = min(1.5 * step, LONGEST_STEP)
            elif ahead is None and step > SHORTEST_STEP:
                step *= 0.5
            else:
                last = furthest(here, way, 4.0 * step if ahead is None else step)
                if ahead is not None and ahead.apart < JOINED < here.apart:
                    self.append(last)
                    self.add(JOINS, last)
                    return
                beyond = self.cross(last, way)
                if beyond is not None:
                    way, step = beyond, LONGEST_STEP / 8.0
                elif ahead is not None and step > NEXT:  # a step to another part of the branch, beyond a fold
                    step *= 0.25
                else:
                    self.end(last if last.known else here, way)
                    return

    def ahead(self, way: Floats, step: float) -> Point | None:
        """Return the gait a step further, at most at the limit of the range; None without one as near."""
        here = self.points[-1]
        found = here.ahead(way, step)
        if found is None:
            return None
        limit = np.clip(found.place[-1], *self.bounds)
        if limit != found.place[-1]:
            share = (limit - here.place[-1]) / (found.place[-1] - here.place[-1])
            found = here.near(here.place + share * (found.place - here.place), np.eye(len(here.place))[-1])
        return found if found is not None and found.known and distance(here, found) <= 2.0 * step else None

    def cross(self, last: Point, way: Floats) -> Floats | None:
        """Add the border that a piece ends at and a gait beyond it; return the direction there, or None if nothing goes on."""
        for new in gaits_beside(last, way):
            reach = 2.0 * distance(last, new) + NEXT
            for tangent in (new.tangent, -new.tangent):
                beyond = on_piece(new, tangent, reach)
                if beyond is not None and on_piece(new, -tangent, reach) is None:
                    self.append(last)
                    self.add_border(last, new)
                    self.points.append(beyond)
                    return tangent
        return None

    def append(self, point: Point) -> None:
        """Add a point of the branch, after the fold and the period doubling on the way to it."""
        here = self.points[-1]
        for kind, critical in ((FOLD, 1.0), (DOUBLING, -1.0)):
            if here.determinant(critical) * point.determinant(critical) < 0.0:
                found = between(here, point, critical)
                if found is not None:
                    self.add(kind, found, factors=(critical,))
        if point is not here:
            self.points.append(point)

    def add_border(self, last: Point, first: Point) -> None:
        """Add the border between the ends of two pieces, unless only the branch of an impact changes, and no multiplier."""
        ends = (last, first)[:: self.sign]
        words = [end.image.sequence for end in ends]
        factors = tuple(float(end.multipliers(exact=True)[0].real) for end in ends)
        if words[0] != words[1] or abs(factors[1] - factors[0]) > SAME:
            self.add(BORDER, last, f"{boundary(last, first)}: {words[0]} | {words[1]}", factors)

    def is_limit(self, point: Point) -> bool:
        """Return True if a point is at a limit of the range."""
        return min(abs(float(point.place[-1]) - bound) for bound in self.bounds) < AT_LIMIT

    def end(self, last: Point, way: Floats) -> None:
        """Add the end of a branch: the limit of the range, the top of the hill, or that of a piece."""
        self.append(last)
        motion = last.gait.motion()
        if self.is_limit(last):
            self.add(LIMIT, last)  # a value beyond may not be allowed at all, such as a restitution below 0
        elif np.abs(motion.at(np.linspace(0.0, motion.duration, SAMPLES)).omega).min() < NEAR_TOP * last.map.unit:
            self.add(TOP, last)
        else:
            self.add(END, last, next((boundary(last, other) for gap in BESIDE for other in last.beside(gap, way)), ""))

    def add(self, kind: str, point: Point, event: str = "", factors: tuple[float, ...] = ()) -> None:
        """Add a special point."""
        factors = factors or (point.multiplier.real,)
        self.special.append(Special(kind, event, point.map.path, point.parameter, point.omega, factors, point.gait))


def distance(one: Point, other: Point) -> float:
    """Return the distance of two points in θ̇ and the parameter, which all modes have."""
    return math.hypot((other.omega - one.omega) / one.map.unit, other.place[-1] - one.place[-1])


def on_one_piece(one: Point, other: Point) -> bool:
    """Return True if two gaits are on one piece of the map, and of a period that is shorter either both or none."""
    return one.image.key == other.image.key and (one.apart > JOINED) == (other.apart > JOINED)


def on_piece(here: Point, way: Floats, step: float) -> Point | None:
    """Return the gait a step further along a direction, if it is on the piece of the one here."""
    tried = here.ahead(way, step)
    return tried if tried is not None and on_one_piece(here, tried) else None


def furthest(here: Point, way: Floats, step: float) -> Point:
    """Return the last gait along a direction on the piece of one."""
    return last_kept(here, 0.0, step, partial(on_piece, here, way), NEAREST)


def between(here: Point, ahead: Point, critical: float) -> Point | None:
    """Return the gait between two at which a multiplier is critical."""
    way = ahead.place - here.place
    length = float(np.linalg.norm(way))
    way /= length
    before, now, at_before, at_now = 0.0, length, here.determinant(critical), ahead.determinant(critical)
    for _ in range(STEPS):
        before, now, at_before = now, now - at_now * (now - before) / (at_now - at_before), at_now
        found = on_piece(here, way, now)
        if found is None:
            return None
        at_now = found.determinant(critical, exact=True)
        if abs(now - before) < KNOWN or at_now == at_before:
            return found
    return None


def gaits_beside(last: Point, way: Floats) -> Iterator[Point]:
    """Yield the gaits next to one that are on other pieces of the map, or on that of another mode; those ahead first."""
    for gap in BESIDE:
        for other in last.beside(gap, way):
            beside = in_its_mode(other)
            if not beside.comes_back or not beside.known:
                continue
            new = beside.near(beside.place, beside.tangent)
            if new is not None and on_one_piece(beside, new) and new.known and distance(last, new) < NEXT:
                yield new


def in_its_mode(point: Point) -> Point:
    """Return a point, or its last passage on the map of the mode in which the hoop comes back, if that is another one."""
    image_of, rows = point.map, point.image.rows
    if point.comes_back or len(rows) < image_of.period:
        return point
    place = np.append(place_of(image_of.section, rows[-1]), point.place[-1])
    return Point(replace(image_of, mode=MODE_LETTERS[int(rows[-1, MODE])]), place)


def boundary(one: Point, other: Point) -> str:
    """Return the boundary between two points, by their phases and modes."""
    mode, branches = one.image.rows[-1, [MODE, BRANCHES]] != other.image.rows[-1, [MODE, BRANCHES]]
    if mode and one.map.section == "bottom":
        return "slip at the section"
    words = one.image.sequence, other.image.sequence
    if words[0] == words[1] or (mode and branches):
        return "impact: slip just stops"
    return "phase vanishes" if words[0].count("H") == words[1].count("H") else "hop vanishes"
