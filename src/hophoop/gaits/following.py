"""Follow a gait over a parameter: by steps along its branch on a piece of the map, and from piece to piece at the borders."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import product

import numpy as np

from hophoop.gaits.branch import BORDER, DOUBLING, END, FOLD, JOINS, LIMIT, TOP, Branch, Point, Special
from hophoop.gaits.differences import Floats, last_kept
from hophoop.gaits.gait import Gait
from hophoop.gaits.kernels.layout import BRANCHES, MODE
from hophoop.gaits.maps import Image, SectionMap, place_of, value_of
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
    found = image_of.solve(place, np.eye(len(place))[-1])
    first = None if found is None else Point(image_of, *found)
    if first is None or not first.known:
        raise InputError.of_field("path", path, "a parameter whose derivative exists at this gait")
    rising = math.copysign(1.0, first.tangent[-1]) * first.tangent
    back, ahead = (Follower(first, (low / scale, high / scale), turned=turned) for turned in (True, False))
    complete = True
    try:
        for k, half in enumerate((back, ahead)):
            half.run(-rising if half.turned else rising)
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
    if not (math.isfinite(low) and math.isfinite(high) and low <= value <= high and low < high):
        unit = f" {parameter(path).unit}" if parameter(path).unit else ""
        raise InputError(f"low = {low!r} and high = {high!r} must be finite and on both sides of {path} = {value!r}{unit}.")
    if path == "plane.slope" and low < 0.0 < high:
        raise InputError.of_field("bounds", bounds, "slopes of one sign: on the level there is no gait")
    return value, low, high


class Follower:
    """The points of one direction along a branch; `turned` if it is the one that a branch ends with in reverse."""

    def __init__(self, first: Point, bounds: tuple[float, float], *, turned: bool) -> None:
        self.bounds, self.turned = bounds, turned
        self.points = [first]
        self.special: list[Special] = []

    def run(self, way: Floats) -> None:
        """Follow the branch in a direction until it ends or leaves the range."""
        step = LONGEST_STEP
        while len(self.points) < MOST_POINTS:
            here = self.points[-1]
            ahead = here.ahead(way, step)
            if ahead is not None:
                ahead = self.within_range(here, ahead)
            if ahead is not None and (here.distance(ahead) > 2.0 * step or not ahead.known):
                ahead = None
            if ahead is not None and ahead.apart < JOINED < here.apart:
                last = furthest(here, way, step, JOINED)
                self.between(here, last)
                self.add(JOINS, last)
                return
            if ahead is not None and ahead.image.key == here.image.key:
                self.between(here, ahead)
                self.points.append(ahead)
                if self.is_limit(ahead):
                    self.add(LIMIT, ahead)
                    return
                way = math.copysign(1.0, ahead.tangent @ way) * ahead.tangent
                step = min(1.5 * step, LONGEST_STEP)
            elif ahead is None and step > SHORTEST_STEP:
                step *= 0.5
            else:
                last = furthest(here, way, 4.0 * step if ahead is None else step)
                beyond = self.cross(last, way)
                if beyond is not None:
                    way, step = beyond, LONGEST_STEP / 8.0
                elif ahead is not None and step > NEXT:  # a step to another part of the branch, beyond a fold
                    step *= 0.25
                else:
                    self.end(last if last.known else here, way)
                    return

    def cross(self, last: Point, way: Floats) -> Floats | None:
        """Add the border that a piece ends at and a gait beyond it; return the direction there, or None if nothing goes on."""
        for new in gaits_beside(last, way):
            reach = 2.0 * last.distance(new) + NEXT
            for tangent in (new.tangent, -new.tangent):
                beyond = on_piece(new, tangent, reach)
                if beyond is not None and on_piece(new, -tangent, reach) is None:
                    self.between(self.points[-1], last)
                    self.add_border(last, new)
                    self.points.append(beyond)
                    return tangent
        return None

    def between(self, here: Point, ahead: Point) -> None:
        """Add the fold and the period doubling between two points."""
        for kind, critical in ((FOLD, 1.0), (DOUBLING, -1.0)):
            if here.off(critical) * ahead.off(critical) < 0.0:
                found = between(here, ahead, critical)
                if found is not None:
                    self.add(kind, found, factors=(critical,))

    def add_border(self, last: Point, first: Point) -> None:
        """Add the border between the ends of two pieces, unless only the branch of an impact changes, and no multiplier."""
        factors = last.exact_multiplier, first.exact_multiplier
        words = last.image.sequence, first.image.sequence
        event = boundary(last.image, first.image, last.map.section)
        if self.turned:
            words, factors = words[::-1], factors[::-1]
        if words[0] != words[1] or abs(factors[1] - factors[0]) > SAME:
            self.add(BORDER, last, f"{event}: {words[0]} | {words[1]}", factors)

    def is_limit(self, point: Point) -> bool:
        """Return True if a point is at a limit of the range."""
        return min(abs(float(point.place[-1]) - bound) for bound in self.bounds) < AT_LIMIT

    def within_range(self, here: Point, ahead: Point) -> Point | None:
        """Return a point ahead, or instead of one beyond the range the one at its limit."""
        limit = min(max(float(ahead.place[-1]), self.bounds[0]), self.bounds[1])
        if limit == ahead.place[-1]:
            return ahead
        share = (limit - here.place[-1]) / (ahead.place[-1] - here.place[-1])
        return here.near(here.place + share * (ahead.place - here.place), np.eye(len(here.place))[-1])

    def end(self, last: Point, way: Floats) -> None:
        """Add the end of a branch: the limit of the range, the top of the hill, or that of a piece."""
        if self.is_limit(last):
            self.add(LIMIT, last)  # a value beyond may not be allowed at all, such as a restitution below 0
            return
        motion = last.gait.motion()
        slowest = np.abs(motion.at(np.linspace(0.0, motion.duration, SAMPLES)).omega).min() / last.map.unit
        if slowest < NEAR_TOP:
            self.add(TOP, last)
            return
        images = (last.map(place) for place in places_beside(last, way))
        beyond = next((image for image in images if len(image.rows) and image.key != last.image.key), None)
        self.add(END, last, "" if beyond is None else boundary(last.image, beyond, last.map.section))

    def add(self, kind: str, point: Point, event: str = "", factors: tuple[float, ...] = ()) -> None:
        """Add a special point; other than folds and doublings it is a point of the branch, too."""
        if kind not in (FOLD, DOUBLING) and point is not self.points[-1]:
            self.points.append(point)
        factors = factors or (point.multiplier.real,)
        self.special.append(Special(kind, event, point.map.path, point.parameter, point.omega, factors, point.gait))


def furthest(here: Point, way: Floats, step: float, apart: float = 0.0) -> Point:
    """Return the last point along a direction on the piece of one.

    apart: what must remain between the state and that after a part of the period.
    """

    def kept(length: float) -> Point | None:
        tried = on_piece(here, way, length)
        return tried if tried is not None and tried.apart > apart else None

    return last_kept(here, 0.0, step, kept, NEAREST)


def on_piece(here: Point, way: Floats, step: float) -> Point | None:
    """Return the gait a step further along a direction, if it has the phases of the one here."""
    tried = here.ahead(way, step)
    return tried if tried is not None and tried.image.key == here.image.key else None


def between(here: Point, ahead: Point, critical: float) -> Point | None:
    """Return the gait between two at which a multiplier is critical."""
    way = ahead.place - here.place
    length = float(np.linalg.norm(way))
    way /= length
    before, now, at_before, at_now = 0.0, length, here.off(critical), ahead.off(critical)
    for _ in range(STEPS):
        before, now, at_before = now, now - at_now * (now - before) / (at_now - at_before), at_now
        found = on_piece(here, way, now)
        if found is None:
            return None
        at_now = found.off(critical, exact=True)
        if abs(now - before) < KNOWN or at_now == at_before:
            return found
    return None


def places_beside(last: Point, way: Floats) -> Iterator[Floats]:
    """Yield places next to a point, those ahead first."""
    for distance, shift in product(BESIDE, (way, *np.eye(len(way)), *-np.eye(len(way)))):
        yield last.place + distance * shift


def gaits_beside(last: Point, way: Floats) -> Iterator[Point]:
    """Yield the gaits next to one that are on other pieces of the map, or on that of another mode; those ahead first."""
    for place in places_beside(last, way):
        beside = in_its_mode(last.map, place)
        if beside is None or beside.image.key == last.image.key or not beside.known:
            continue
        new = beside.near(beside.place, beside.tangent)
        if new is not None and new.image.key == beside.image.key and new.known and last.distance(new) < NEXT:
            yield new


def in_its_mode(image_of: SectionMap, place: Floats) -> Point | None:
    """Return the point at a place, on the map of the mode in which the hoop comes back; None if it does not."""
    place = image_of.in_mode(place)
    image = image_of(place)
    if len(image.rows) == image_of.period and not image_of.comes_back(image):
        row = image.rows[-1]
        mode = MODE_LETTERS[int(row[MODE])]
        image_of = SectionMap(image_of.scenario, image_of.period, image_of.section, mode, image_of.path, image_of.scale)
        place = np.append(place_of(image_of.section, row), place[-1])
        image = image_of(place)
    return Point(image_of, place, image) if image_of.comes_back(image) else None


def boundary(one: Image, other: Image, section: str) -> str:
    """Return the boundary between two images, by their phases and modes."""
    mode, branches = one.rows[-1, [MODE, BRANCHES]] != other.rows[-1, [MODE, BRANCHES]]
    if mode and section == "bottom":
        return "slip at the section"
    if one.sequence == other.sequence or (mode and branches):
        return "impact: slip just stops"
    return "phase vanishes" if one.sequence.count("H") == other.sequence.count("H") else "hop vanishes"
