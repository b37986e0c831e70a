"""Branches of gaits over a parameter, through folds and boundaries of the sequence, with their special points."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.gaits.computing import passages
from hophoop.gaits.gait import Gait
from hophoop.gaits.maps import Floats, Image, SectionMap, eigenvalues, value_of
from hophoop.kernel.physics import MODE_LETTERS
from hophoop.scenario import InputError, Scenario
from hophoop.scenario.paths import parameter

if TYPE_CHECKING:
    import xarray

Progress = Callable[[float], object]

TENTH = 0.1  # of the range: unit of the scaled parameter
LONGEST_STEP, SHORTEST_STEP = 0.02, 1e-9  # along the branch, in (coordinates in units of R and √(R/g), scaled parameter)
MOST_POINTS = 4_000
NEAREST = 1e-15  # along the branch: to rounding
SAME = 1e-5  # of multipliers: where an impact's branch changes, but nothing else, no border is reported
BESIDE = (1e-9, 1e-7, 1e-5)  # distances at which the pieces next to a boundary are looked for
STEPS, KNOWN = 20, 1e-9  # of the secant rule, and the last one: the next would be rounding
UNKNOWN = 1e-5  # along the branch: the largest gap at a boundary
AT_LIMIT = 1e-8  # scaled parameter: within it a branch has reached the limit of its range
SAMPLES, NEAR_TOP = 400, 1e-3  # of a period, and the least θ̇ of one that ends at the top [√(g/R)]
JOINED = 1e-7  # √(g/R): within it θ̇ after a part of the period is the same
PHASE = "phase vanishes"
RADIUS, MASS, GRAVITY = "hoop.radius", "hoop.mass", "plane.gravity"

FOLD, DOUBLING, BORDER, JOINS, TOP, END, LIMIT = (
    "fold", "period doubling", "border collision", "joins a shorter period", "top of the hill", "end", "limit of the range",
)  # fmt: skip


class Special(NamedTuple):
    """A special point of a branch.

    Attributes
    ----------
    kind : str
        'fold', 'period doubling', 'border collision', 'joins a shorter period', 'top of the hill', 'end' or 'limit of
        the range'.
    event : str
        Of a border collision the boundary ('hop vanishes', 'phase vanishes', 'impact: slip just stops' or 'slip at the
        section') and the sequences on both sides; of an end the boundary that is met there, if one is; else empty.
    path : str
        Of the parameter.
    parameter : float
        [SI].
    omega : float
        θ̇ at the section [rad/s].
    multipliers : tuple of float
        Before and after it along the branch; one where they are the same [1].
    gait : Gait
        At or just before it.
    """

    kind: str
    event: str
    path: str
    parameter: float
    omega: float
    multipliers: tuple[float, ...]
    gait: Gait

    def __repr__(self) -> str:
        event = f" ({self.event})" if self.event else ""
        factors = " to ".join(f"{one:.6g}" for one in self.multipliers)
        return f"<{self.kind}{event} at {self.path} = {self.parameter:.12g}, multiplier {factors}>"


@dataclass(frozen=True, eq=False)
class Point:
    """A gait of a branch.

    Attributes
    ----------
    map : SectionMap
    place : ndarray
        Coordinates and scaled parameter.
    image : Image
        Of the place.
    """

    map: SectionMap
    place: Floats
    image: Image

    @cached_property
    def rates(self) -> Floats:
        """Derivative of the map by the place."""
        return self.map.rates(self.image, self.place)

    @property
    def known(self) -> bool:
        """Whether the derivative exists."""
        return bool(np.isfinite(self.rates).all())

    @cached_property
    def multiplier(self) -> complex:
        """The eigenvalue of the largest modulus [1]."""
        return complex(eigenvalues(self.rates[:, :-1])[0])

    @property
    def omega(self) -> float:
        """θ̇ at the section [rad/s]."""
        return self.map.omega(self.place)

    @property
    def parameter(self) -> float:
        """The parameter [SI]."""
        return float(self.place[-1]) * self.map.scale

    @property
    def gait(self) -> Gait:
        """The gait."""
        return Gait(passages(self.map.at(self.place), self.map.period, section=self.map.section))

    @cached_property
    def tangent(self) -> Floats:
        """Unit vector along the branch."""
        found: Floats = np.linalg.svd(self.rates - np.eye(*self.rates.shape))[2][-1]
        return found

    @property
    def apart(self) -> float:
        """Difference of the state from that after a part of the period."""
        return self.map.apart(self.image, self.place)

    def off(self, critical: float, *, exact: bool = False) -> float:
        """Return det(derivative − critical), which is 0 where a multiplier has this value."""
        rates = self.map.rates(self.image, self.place, exact=True) if exact else self.rates
        return float(np.linalg.det(rates[:, :-1] - critical * np.eye(len(rates))))

    def near(self, guess: Floats, normal: Floats) -> Point | None:
        """Return the gait near a guess, on the plane through it with a normal."""
        found = self.map.solve(guess, normal, self.rates)
        return None if found is None else Point(self.map, *found)

    def ahead(self, way: Floats, step: float) -> Point | None:
        """Return the gait a step further along a direction."""
        return self.near(self.place + step * way, way)

    def distance(self, other: Point) -> float:
        """Return the distance of another point, in θ̇ and the parameter where they have different modes."""
        if self.map.names == other.map.names:
            return float(np.linalg.norm(other.place - self.place))
        return float(np.linalg.norm(other.pair(other.place) - self.pair(self.place)))

    def pair(self, place: Floats) -> Floats:
        """Return θ̇ and the parameter of a place, which all modes have."""
        return place[[self.map.names.index("omega"), -1]]


@dataclass(frozen=True)
class Branch:
    """A branch of gaits; made by `Gait.follow`.

    Attributes
    ----------
    points : tuple of Point, length n
        In the order along the branch.
    special : tuple of Special
        In the order along the branch.
    complete : bool
        False if it was stopped.
    """

    points: tuple[Point, ...]
    special: tuple[Special, ...]
    complete: bool = True

    @property
    def path(self) -> str:
        """Path of the parameter."""
        return self.points[0].map.path

    @property
    def period(self) -> int:
        """Passages of a period [1]."""
        return self.points[0].map.period

    @property
    def section(self) -> str:
        """The section, 'bottom' or 'landing'."""
        return self.points[0].map.section

    @cached_property
    def parameter(self) -> NDArray[np.float64]:
        """The parameter, shape (n,) [SI]."""
        return np.array([point.parameter for point in self.points])

    @cached_property
    def omega(self) -> NDArray[np.float64]:
        """θ̇ at the section, shape (n,) [rad/s]."""
        return np.array([point.omega for point in self.points])

    @cached_property
    def multiplier(self) -> NDArray[np.float64]:
        """The multiplier of the largest modulus, of a complex pair its real part, shape (n,) [1]."""
        return np.array([point.multiplier.real for point in self.points])

    @property
    def sequences(self) -> tuple[str, ...]:
        """Phases of a period as in `Gait`, length n."""
        return tuple(point.image.sequence for point in self.points)

    @property
    def stable(self) -> NDArray[np.bool_]:
        """Where the gait is stable, shape (n,)."""
        return np.array([abs(point.multiplier) < 1.0 for point in self.points])

    @property
    def hops(self) -> NDArray[np.int64]:
        """Hops of a period, shape (n,)."""
        return np.array([sum("H" in part for part in sequence.split("·")) for sequence in self.sequences])

    def gait(self, index: int) -> Gait:
        """Return the gait of a point.

        Parameters
        ----------
        index : int

        Returns
        -------
        gait : Gait
        """
        return self.points[index].gait

    def to_dict(self) -> dict[str, Any]:
        """Return all numbers as a dict for JSON, in SI units.

        Returns
        -------
        numbers : dict
        """
        names = ("kind", "event", "parameter", "omega")
        special = [
            {name: getattr(one, name) for name in names} | {"multipliers": list(one.multipliers)} for one in self.special
        ]
        columns = {name: getattr(self, name).tolist() for name in ("parameter", "omega", "multiplier")}
        about = {"path": self.path, "period": self.period}
        return {**about, **columns, "sequence": list(self.sequences), "special": special}

    def to_xarray(self) -> xarray.Dataset:
        """Return the branch as an xarray.Dataset over its points.

        Returns
        -------
        dataset : xarray.Dataset

        Raises
        ------
        ImportError
            If xarray is missing.
        """
        xr = need("xarray", "maps")
        about = parameter(self.path)
        variables: dict[str, Any] = {
            "parameter": ("point", self.parameter, {"units": about.unit or "1", "long_name": about.description}),
            "omega": ("point", self.omega, {"units": "rad/s", "long_name": "Angular velocity at the passage"}),
            "multiplier": ("point", self.multiplier, {"units": "1", "long_name": "Multiplier of the period"}),
            "sequence": ("point", np.array(self.sequences, dtype=str), {"units": "1", "long_name": "Phases of a period"}),
        }
        dataset: xarray.Dataset = xr.Dataset(variables, attrs={"path": self.path, "period": self.period})
        return dataset

    def __repr__(self) -> str:
        kinds = ", ".join(one.kind for one in self.special)
        return (
            f"<Branch: {len(self.parameter)} gaits over {self.path} from {self.parameter.min():.6g} to "
            f"{self.parameter.max():.6g}; {kinds}>"
        )


class Follower:
    """The points of one direction along a branch."""

    def __init__(self, first: Point, bounds: tuple[float, float]) -> None:
        self.bounds = bounds
        self.points = [first]
        self.special: list[Special] = []

    def run(self, way: Floats) -> None:
        """Follow the branch in a direction until it ends or leaves the range."""
        step = LONGEST_STEP
        while len(self.points) < MOST_POINTS:
            here = self.points[-1]
            ahead = here.ahead(way, step)
            if ahead is not None and not self.bounds[0] + AT_LIMIT <= ahead.place[-1] <= self.bounds[1] - AT_LIMIT:
                if self.leaves(here, ahead):
                    return
                ahead = None
            if ahead is None or here.distance(ahead) > 2.0 * step or not ahead.known:
                ahead, step = None, 0.5 * step
                if step > SHORTEST_STEP:
                    continue
            elif ahead.apart < JOINED < here.apart:
                last, _ = furthest(here, way, step, JOINED)
                self.between(here, last)
                self.add(JOINS, last)
                return
            elif ahead.image.key == here.image.key:
                self.between(here, ahead)
                self.points.append(ahead)
                way = ahead.tangent if ahead.tangent @ way > 0.0 else -ahead.tangent
                step = min(1.5 * step, LONGEST_STEP)
                continue
            last, next_one = furthest(here, way, 4.0 * step if ahead is None else step)
            if ahead is not None and step > UNKNOWN and (next_one is None or last.distance(next_one) > UNKNOWN):
                step *= 0.25  # the step met another part of the branch, for instance beyond a fold
                continue
            beyond = self.pass_border(last, way, None if ahead is None else next_one)
            if beyond is None:
                self.end(last if last.known else here, way)
                return
            way, step = beyond, LONGEST_STEP / 8.0

    def pass_border(self, last: Point, way: Floats, beyond: Point | None) -> Floats | None:
        """Add a border collision, and go on on its other side; return the direction, or None if nothing goes on there."""
        new = beyond if beyond is not None else next(self.beside(last, way), None)
        if new is None or not new.known:
            return None
        event = boundary(last.image, new.image, last.map.section)
        if event == PHASE and last.map.mode != new.map.mode:  # the first phase after the landing vanishes: the end of a branch
            return None
        towards = 1.0 if new.pair(new.tangent) @ (new.pair(new.place) - last.pair(last.place)) > 0.0 else -1.0
        if beyond is None:
            new = backed(new, -towards * new.tangent, last.distance(new))
        for sign in (towards, -towards):
            tangent = sign * new.tangent
            if beyond is not None and sign < 0.0 and tangent @ way < 0.0 and goes_on(new, -tangent):
                continue
            if goes_on(new, tangent):
                here = self.points[-1]
                one = last if last.known else short_of(here, last, way)
                self.between(here, one)
                factors = one.multiplier.real, new.multiplier.real
                if last.image.sequence != new.image.sequence or abs(factors[1] - factors[0]) > SAME:
                    self.add(BORDER, last, f"{event}: {last.image.sequence} | {new.image.sequence}", factors)
                self.points.append(new)
                return tangent
        return None

    def beside(self, last: Point, way: Floats) -> Iterator[Point]:
        """Yield gaits next to a point that are on another piece, where no step leads on."""
        shifts = [sign * unit for unit in np.eye(len(last.place)) for sign in (1.0, -1.0)]
        places = [(last.map, last.place + distance * shift) for shift in shifts for distance in BESIDE]
        further = (in_other_mode(last.map, last.place + distance * way) for distance in BESIDE)
        places += [other for other in further if other is not None]
        for image_of, place in places:
            image = image_of(place)
            if not image_of.comes_back(image) or (image_of.mode == last.map.mode and image.key == last.image.key):
                continue
            tried = Point(image_of, place, image)
            new = tried.near(place, tried.tangent) if tried.known else None
            if new is not None and new.image.key == image.key and last.distance(new) < 10.0 * BESIDE[-1]:
                yield new

    def between(self, here: Point, ahead: Point) -> None:
        """Add the fold and the period doubling between two points."""
        for kind, critical in ((FOLD, 1.0), (DOUBLING, -1.0)):
            if here.off(critical) * ahead.off(critical) < 0.0:
                found = between(here, ahead, critical)
                if found is not None:
                    self.add(kind, found, factors=(critical,))

    def leaves(self, here: Point, ahead: Point) -> bool:
        """Add the point at the limit of the range that is between two; return False if its phases are others."""
        limit = self.bounds[0] if ahead.place[-1] < self.bounds[0] + AT_LIMIT else self.bounds[1]
        last = at_value(here, ahead.place, limit)
        if last is None:
            return False
        self.between(here, last)
        self.add(LIMIT, last)
        return True

    def end(self, last: Point, way: Floats) -> None:
        """Add the end of a branch: the limit of the range, the top of the hill, or that of a piece."""
        if min(abs(float(last.place[-1]) - bound) for bound in self.bounds) < AT_LIMIT:
            self.add(LIMIT, last)  # a value beyond may not be allowed at all, such as a restitution below 0
            return
        motion = last.gait.motion()
        slowest = np.abs(motion.at(np.linspace(0.0, motion.duration, SAMPLES)).omega).min() / last.map.unit
        if slowest < NEAR_TOP:
            self.add(TOP, last)
            return
        shifts = [way, *np.eye(len(way)), *-np.eye(len(way))]
        tried = (last.map(last.place + distance * shift) for distance in BESIDE for shift in shifts)
        beyond = next((image for image in tried if image.passages and image.key != last.image.key), None)
        self.add(END, last, "" if beyond is None else boundary(last.image, beyond, last.map.section))

    def add(self, kind: str, point: Point, event: str = "", factors: tuple[float, ...] = ()) -> None:
        """Add a special point; other than folds and doublings it is a point of the branch, too."""
        if kind not in (FOLD, DOUBLING) and point is not self.points[-1]:
            self.points.append(point)
        factors = factors or (point.multiplier.real,)
        self.special.append(Special(kind, event, point.map.path, point.parameter, point.omega, factors, point.gait))


def furthest(here: Point, way: Floats, step: float, apart: float = 0.0) -> tuple[Point, Point | None]:
    """Return the last point along a direction on the piece of one, and the first one beyond it, if one is.

    apart: what must remain between the state and that after a part of the period.
    """
    low, high = 0.0, step
    last, first = here, None
    while low < (middle := 0.5 * (low + high)) < high and high - low > NEAREST:
        tried = here.ahead(way, middle)
        if tried is not None and tried.image.key == here.image.key and tried.apart > apart:
            low, last = middle, tried
        else:
            high, first = middle, first if tried is None else tried
    return last, first


def backed(new: Point, back: Floats, far: float) -> Point:
    """Return the point next to the border that a point is beyond, where its derivative exists on both sides."""
    return short_of(new, furthest(new, back, 2.0 * far)[0], back)


def short_of(here: Point, last: Point, way: Floats) -> Point:
    """Return a point between two on a line, 1e-7 before the last one, or the first one if it is not farther away."""
    distance = here.distance(last) - BESIDE[1]
    near = here.ahead(way, distance) if distance > 0.0 else None
    return near if near is not None and near.known else here


def between(here: Point, ahead: Point, critical: float) -> Point | None:
    """Return the gait between two at which a multiplier is critical."""
    way = ahead.place - here.place
    length = float(np.linalg.norm(way))
    way /= length
    before, now, at_before, at_now = 0.0, length, here.off(critical), ahead.off(critical)
    for _ in range(STEPS):
        before, now, at_before = now, now - at_now * (now - before) / (at_now - at_before), at_now
        found = here.ahead(way, now)
        if found is None or found.image.key != here.image.key:
            return None
        at_now = found.off(critical, exact=True)
        if abs(now - before) < KNOWN or at_now == at_before:
            return found
    return None


def at_value(here: Point, further: Floats, value: float) -> Point | None:
    """Return the gait of the piece at a value of the scaled parameter near the line from a point to a place."""
    share = (value - here.place[-1]) / (further[-1] - here.place[-1])
    guess = here.place + share * (further - here.place)
    found = here.near(guess, np.eye(len(guess))[-1])
    return found if found is not None and found.image.key == here.image.key else None


def goes_on(new: Point, tangent: Floats) -> bool:
    """Return True if the branch goes on with the phases of a point in a direction."""
    tried = new.ahead(tangent, BESIDE[-1])
    return tried is not None and tried.image.key == new.image.key


def in_other_mode(image_of: SectionMap, place: Floats) -> tuple[SectionMap, Floats] | None:
    """Return the map of the mode in which the hoop comes back, and the place there; None if the mode is the same."""
    start = place.copy()
    if "slip" in image_of.names:  # it may be past 0, where the mode ends
        k = image_of.names.index("slip")
        start[k] = min(start[k], 0.0) if image_of.mode == "S" else max(start[k], 0.0)
    image = image_of(start)
    if len(image.passages) < image_of.period or image_of.comes_back(image):
        return None
    last, section = image.passages[-1], image_of.section
    mode = MODE_LETTERS[last.mode]
    other = SectionMap(image_of.scenario, image_of.period, section, mode, image_of.path, image_of.scale)
    return other, np.append(last.place(section), place[-1])


def boundary(one: Image, other: Image, section: str) -> str:
    """Return the boundary between two images, by their phases and modes."""
    moved = one.passages[-1].mode != other.passages[-1].mode
    if moved and section == "bottom":
        return "slip at the section"
    if one.sequence == other.sequence or (moved and one.passages[-1].branches != other.passages[-1].branches):
        return "impact: slip just stops"
    return PHASE if one.sequence.count("H") == other.sequence.count("H") else "hop vanishes"


def follow(gait: Gait, path: str, bounds: tuple[float, float], progress: Progress | None = None) -> Branch:
    """Follow a gait over a parameter, from the branch's end below it to that above; `Gait.follow` calls and describes this."""
    value, low, high = range_of(gait.scenario, path, bounds)
    scale = TENTH * (high - low)
    image_of = SectionMap(gait.scenario, gait.period, gait.section, gait.passages.mode[-1], path, scale)
    place = image_of.point(gait.scenario.start, value)
    found = image_of.solve(place, np.eye(len(place))[-1])
    if found is None:
        raise InputError.of_field("path", path, "a parameter whose derivative exists at this gait")
    first = Point(image_of, *found)
    halves = [Follower(first, (low / scale, high / scale)) for _ in range(2)]
    complete = True
    try:
        for k, half in enumerate(halves):
            sign = 1.0 if (first.tangent[-1] > 0.0) == (k == 1) else -1.0
            half.run(sign * first.tangent)
            if progress is not None:
                progress(0.5 * (k + 1))
    except KeyboardInterrupt:
        complete = False
    back, ahead = halves
    points = [*reversed(back.points), *ahead.points[1:]]
    special = [_turned(one) for one in reversed(back.special)] + ahead.special
    return Branch(tuple(points), tuple(special), complete)


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


def _turned(special: Special) -> Special:
    """Return a special point met in the other direction."""
    event = special.event
    if " | " in event:
        boundary, _, words = event.rpartition(": ")
        one, _, other = words.partition(" | ")
        event = f"{boundary}: {other} | {one}"
    return special._replace(multipliers=special.multipliers[::-1], event=event)
