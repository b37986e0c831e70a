"""Search for periodic gaits: fixed points of the return map, and of its iterates."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from itertools import pairwise

import numpy as np

from hophoop._support.errors import check_whole
from hophoop.gaits.computing import check, passages
from hophoop.gaits.differences import last_kept
from hophoop.gaits.gait import Gait
from hophoop.gaits.kernels.layout import COORDINATES, MODE, THETA, T
from hophoop.gaits.maps import FASTEST, SectionMap, place_of, slowest_over_top
from hophoop.gaits.points import Point
from hophoop.gaits.results import Passages
from hophoop.gaits.return_map import Known, known, pieces
from hophoop.kernel.numerics.arithmetic import TWO_PI
from hophoop.results.units import Units
from hophoop.scenario import InputError, Scenario, Start
from hophoop.vocabulary.names import Fate

Progress = Callable[[float], object]

LONGEST = 64  # passages of a period
SLOWEST, MOST_FAST = 1e-3, 100.0  # √(g/R)
GRID, MOST_GRID = 2_000, 10_000  # values of θ̇ per passage of a period, and in all
NEARBY = 0.1  # of `near`, to either side
STARTS, PATIENCE = 96, 3_000  # motions that are left to settle, and their passages
EARLY, RETURNS, NEAR_RETURN = 200, 6, 0.3  # first passages of a motion, those used, and how near it comes [R, √(R/g)]
SHORTEST = 0.1  # √(R/g), of a period: bounces may follow each other faster
EXACT = 1e-9  # largest residual of a gait; those found have 1e-12 and less
SAME = 1e-7  # relative difference of θ̇ within which two gaits are one
DEPTH = 2  # halvings between pieces of the map


def find(
    scenario: Scenario,
    period: int = 1,
    *,
    near: float | None = None,
    fastest: float | None = None,
    section: str = "bottom",
    progress: Progress | None = None,
) -> tuple[Gait, ...]:
    """Find periodic gaits, stable or not.

    Parameters
    ----------
    scenario : Scenario
        Its hoop and plane count; with rigid contact, friction and a slope.
    period : int, default 1
        Passages after which the gait repeats itself, and not earlier, from 1 to 64 [1].
    near : float, optional
        θ̇ at the passage near which to look, to 10 % [rad/s].
    fastest : float, optional
        Without `near`, size of θ̇ up to which to look [rad/s]; by default 10 √(g/R), at landings 20 √(g/R), for heavy loads
        twice what gets over the top. A search takes seconds, but minutes where the map has thousands of pieces: with a
        restitution near 1, or above the critical slope. There `near` helps.
    section : {'bottom', 'landing'}, default 'bottom'
        As in `hophoop.passages`. At the bottom in rolling the map has one dimension, and the search compares 2000 values of θ̇
        and the ends of all pieces of the map that they meet: it finds stable and unstable gaits, except those on pieces
        between two of the values. In slip and at landings it lets 96 motions settle and goes on by Newton's method from the
        nearest returns of each: it finds stable gaits, and unstable ones that they come near.
    progress : callable, optional
        Called with the computed fraction, 0 to 1.

    Returns
    -------
    gaits : tuple of Gait
        The slowest first, or the nearest.

    Raises
    ------
    ValueError
        If the scenario has no gaits, an argument is not allowed, or the search finds none: it says how far it looked and the
        nearest return.

    Examples
    --------
    >>> import math
    >>> import hophoop as hh
    >>> slope = hh.Plane(slope=math.radians(3), gravity=1.0)
    >>> gait = hh.gaits.find(hh.Scenario(hoop=hh.Hoop.ideal(0.5), plane=slope), near=2.8)[0]
    >>> gait
    <Gait: RSHKR, stable, multiplier -0.768024, 1.86137 m/s, 1 hop in 1 revolution>
    """
    _check(scenario, period, near, section)
    base = scenario.replace("start", Start())
    low, high = _range(base, near, fastest, section)
    image_of, known = SectionMap(base, period), []
    if section == "bottom":
        places = GRID if near is not None else min(GRID * period, MOST_GRID)
        grid = math.copysign(1.0, scenario.plane.slope) * np.linspace(low, high, places)
        known = pieces(image_of, sorted(grid.tolist()), DEPTH, progress)
    points = [point for piece in known for point in crossings(image_of, piece)]
    gaits: list[Gait] = []
    for point in [*points, *_settled(base, period, (low, high), section)]:
        if _is_gait(point) and (near is None or abs(point.omega / near - 1.0) <= NEARBY):
            gait = point.gait
            if not any(_same(gait, other) for other in gaits):
                gaits.append(gait)
    if not gaits:
        raise InputError(_nothing(base, period, (low, high), section, known))
    gaits.sort(key=lambda gait: abs(gait.speed if near is None else gait.state.omega - near))
    return tuple(gaits)


def _check(scenario: Scenario, period: int, near: float | None, section: str) -> None:
    check(scenario, section)
    check_whole("period", period, 1, LONGEST)
    if scenario.plane.mu_static == 0.0:
        raise InputError.of_field("plane.mu", 0.0, "above 0: without friction no hoop has a gait")
    if scenario.hoop.eccentricity == 0.0:
        name = "load_fraction" if scenario.hoop.load_fraction is not None else "eccentricity"
        raise InputError.of_field(f"hoop.{name}", 0.0, "above 0: a hoop without load has no gait")
    if scenario.plane.slope == 0.0:
        allowed = "other than 0: on the level nothing makes up for what is lost, and rolling for ever is a fate, not a gait"
        raise InputError.of_field("plane.slope", 0.0, allowed)
    ahead = math.copysign(1.0, scenario.plane.slope)
    if near is not None:
        unit = Units.of_scenario(scenario).of("omega")
        least, most = sorted((ahead * SLOWEST * unit, ahead * MOST_FAST * unit))
        if not least <= near <= most:
            raise InputError.of_field("near", near, f"a θ̇ downhill, from {least:.4g} to {most:.4g} rad/s")


def _range(scenario: Scenario, near: float | None, fastest: float | None, section: str) -> tuple[float, float]:
    """Return the range of the size of θ̇ in which gaits are looked for [√(g/R)]."""
    unit = Units.of_scenario(scenario).of("omega")
    if near is not None:
        return abs(near) / unit * (1.0 - NEARBY), abs(near) / unit * (1.0 + NEARBY)
    low = slowest_over_top(scenario)
    high = max(FASTEST[section], min(2.0 * low, 0.5 * (low + MOST_FAST))) if fastest is None else fastest / unit
    if not low < high < MOST_FAST:
        allowed = f"above {low * unit:.4g}, with which it may get over the top, and below {MOST_FAST * unit:.4g}"
        raise InputError.of_field("fastest", fastest, allowed)
    return low, high


def _is_gait(point: Point) -> bool:
    """Return True if a point repeats itself after the period, downhill, and not earlier."""
    if not (point.comes_back and point.off() <= EXACT and point.apart > SAME):
        return False
    return point.image.turns != 0 and bool(point.image.rows[-1, T] >= SHORTEST)


def _settled(scenario: Scenario, period: int, bounds: tuple[float, float], section: str) -> Iterator[Point]:
    """Yield the fixed points on which motions settle or which they come near, in slip at the bottom or at landings."""
    speed = Units.of_scenario(scenario).of("omega") * scenario.hoop.radius
    ahead = math.copysign(1.0, scenario.plane.slope)
    for omega in np.geomspace(*bounds, STARTS):
        tried = scenario.replace("start", Start.rolling(float(ahead * omega * speed), angle=math.pi))
        found = passages(tried, PATIENCE, section=section, until_decided=True)
        places = _near_returns(found, period)
        if found.decided == Fate.GAIT and found.period == period:
            places.append(len(found) - 1)
        for place in places:
            if section == "landing" or found.mode[place] != "R":
                image_of = SectionMap(scenario, period, section, found.mode[place])
                row = found.numbers[place].copy()
                row[THETA] %= TWO_PI  # a start may count no more than 10⁶ rad
                solution = Point(image_of, place_of(section, row)).solve(patient=True)
                if solution is not None:
                    yield solution


def _near_returns(found: Passages, period: int) -> list[int]:
    """Return a few early passages which the motion comes nearest to again after a period."""
    rows = found.numbers[:EARLY]
    one, other = rows[:-period], rows[period:]
    change = other[:, COORDINATES] - one[:, COORDINATES]
    change[:, 0] -= TWO_PI * np.round(change[:, 0] / TWO_PI)
    off = np.abs(change).max(axis=1)
    off[(other[:, MODE] != one[:, MODE]) | (other[:, T] - one[:, T] < SHORTEST)] = math.inf
    walled = np.pad(off, 1, constant_values=math.inf)
    nearest = np.flatnonzero((off < NEAR_RETURN) & (off <= walled[:-2]) & (off < walled[2:]))
    return [int(k) for k in nearest[np.argsort(off[nearest], kind="stable")][:RETURNS]]


def _same(one: Gait, other: Gait) -> bool:
    """Return True if two gaits are one, whichever of its passages they were found at."""
    passes = np.any(np.abs(other.passages.omega / one.state.omega - 1.0) < SAME)
    return bool(passes) and abs(one.speed / other.speed - 1.0) < SAME


def _nothing(scenario: Scenario, period: int, bounds: tuple[float, float], section: str, known: list[list[Known]]) -> str:
    unit = Units.of_scenario(scenario).of("omega")
    low, high = (bound * unit for bound in bounds)
    looked = f"No gait of period {period} was found with θ̇ from {low:.4g} to {high:.4g} rad/s"
    if section == "landing":
        return f"{looked} at landings: none of {STARTS} motions came near one in {PATIENCE} passages."
    if not known:
        return f"{looked} at the bottom: no motion passes it again in rolling."
    nearest = min(abs(one.excess) for piece in known for one in piece) * unit
    return f"{looked} at the bottom: the nearest return was {nearest:.3g} rad/s off."


# --- fixed points of a piece


def crossings(image_of: SectionMap, piece: list[Known]) -> Iterator[Point]:
    """Yield the points of a piece that the map leads back to, to rounding."""
    for one, other in pairwise(piece):
        if one.excess * other.excess <= 0.0:
            yield Point(image_of, np.array([_crossing(image_of, one, other.omega)]))
    for three in zip(piece, piece[1:], piece[2:], strict=False):
        excess = [one.excess for one in three]
        if (min(excess) > 0.0 or max(excess) < 0.0) and abs(excess[1]) == min(map(abs, excess)):
            for start in (three[0].omega, three[2].omega):  # a pair may be next to the extremum
                found = Point(image_of, np.array([start])).solve()
                if found is not None and three[0].omega <= found.place[0] <= three[2].omega:
                    yield found


def _crossing(image_of: SectionMap, inside: Known, outside: float) -> float:
    """Return the last θ̇ from which the map leads away as it does at the first one, on the way to another."""

    def kept(omega: float) -> Known | None:
        tried = known(image_of, omega)
        return tried if tried.excess * inside.excess > 0.0 else None

    return last_kept(inside, inside.omega, outside, kept).omega
