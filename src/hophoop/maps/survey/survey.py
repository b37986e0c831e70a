"""Survey of all classes of the first revolution of one hoop, each with its share, its width and an example."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from hophoop.kernel.numerics.elementwise import logarithm, power
from hophoop.maps.boundaries.classes import Classifier, make_window
from hophoop.maps.grid.axes import LN_10, geometric
from hophoop.maps.grid.evaluate import points
from hophoop.maps.survey.arrangement import Arrangement, Options, Seen, arrange
from hophoop.maps.survey.coincidences import Class
from hophoop.maps.survey.rules import Place, Rules, explain
from hophoop.maps.survey.slices import Floats, Ints
from hophoop.maps.survey.strips import strips_at
from hophoop.scenario import InputError, Scenario

# Both parameters start slightly above 0, where the hoop rests or has no friction. The immediate hop starts at √(g R/γ) for
# every friction; above it H is the only class.
MOST_FRICTION, FASTEST = 2.0, 1.06
# The required friction of rolling is known to rounding only, which matters below this friction.
LEAST_FRICTION = 1e-5
# Whether slower starts pass the top depends on v0², which is lost in the rounding of the work of friction.
LEAST_SPEED = 1e-3
BORDER_PART = 1e-12  # precision of borders in which theory excludes other classes; the others are bisected to rounding
THIN = 1e-11  # intervals of speed that neighbouring lines need not share, relative to the range
NARROWEST = 1e-14  # narrower classes hold only a few adjacent doubles, decided by rounding
TRIES = 12  # intervals of a class at which its width is measured
HALVINGS = 40  # bisections of an extent known to a factor of 4
LISTED = 25  # positions on the border of a skid at which theory computes the width of its strips
NEAR = 1e-6  # relative distance in speed from such a position
REACH = np.concatenate([np.ldexp(1.0, -2 * np.arange(26, 0, -1)), [0.5, 1.0]])  # relative to the range of friction


class Found(NamedTuple):
    """One class of motion over the first revolution.

    Attributes
    ----------
    sequence, ending : str
        As in `Entry`.
    area : float
        Share of the window [1].
    width : float
        Twice the distance from the example to the nearest end of the class, along friction and along speed, relative to the
        window's sides [1].
    mu, speed : float
        The example [1], [m/s].
    """

    sequence: str
    ending: str
    area: float
    width: float
    mu: float
    speed: float


class Narrow(NamedTuple):
    """A class that exists by theory but is too narrow to be found.

    Attributes
    ----------
    sequence, ending : str
        As in `Entry`.
    mu, speed : float
        The sampled position where it is widest [1], [m/s].
    log10_width : float
        Decimal logarithm of its width by theory: the smaller of those along friction and speed, relative to the window's
        side [1].
    """

    sequence: str
    ending: str
    mu: float
    speed: float
    log10_width: float


class Survey(NamedTuple):
    """Result of `survey`.

    Attributes
    ----------
    found : list of Found
        Largest area first; of width 1e-14 or more.
    meetings : list of tuple
        μ and speed where classes meet, and the classes [1], [m/s].
    strips : list of tuple of str
        The strips of skids by theory (`hophoop.maps.survey.strips`), sequences with endings.
    too_narrow : list of Narrow
        The strips that are not in `found`.
    unexplained : list of tuple
        Neighbours that differ by more than one coincidence and between which no class in `found` can lie, with a position.
    arrangement : Arrangement
    classes : list of tuple of str
        Meanings of the arrangement's codes.
    mu_range, speed_range : tuple of float
        The window [1], [m/s].
    motions : int
        Number of motions computed [1].
    complete : bool
        Whether every difference was followed to the requested precision.
    """

    found: list[Found]
    meetings: list[tuple[float, float, tuple[Class, ...]]]
    strips: list[Class]
    too_narrow: list[Narrow]
    unexplained: list[tuple[Class, Class, float, float]]
    arrangement: Arrangement
    classes: list[Class]
    mu_range: tuple[float, float]
    speed_range: tuple[float, float]
    motions: int
    complete: bool


def survey(
    load_fraction: float = 0.75,
    lines: int = 60,
    part: float = 1e-10,
    least_friction: float = LEAST_FRICTION,
    least_speed: float = LEAST_SPEED,
) -> Survey:
    """Follow all borders between classes of the first revolution, for one ideal hoop with R = 1 m.

    Parameters
    ----------
    load_fraction : float, default 0.75
        γ [1].
    lines : int, default 60
        Number of lines of constant friction spaced by ratio, and as many by difference; as many speeds on each [1].
    part : float, default 1e-10
        Meetings of classes are located to this part of μ [1].
    least_friction : float, default 1e-5
        Lower end of the window [1].
    least_speed : float, default 1e-3
        Lower end of the window [m/s].

    Returns
    -------
    survey : Survey

    Raises
    ------
    ValueError
        If an option is not allowed.
    """
    if not 4 <= lines <= 4096:
        raise InputError.of_field("lines", lines, "from 4 to 4096")
    if not 1e-15 <= part < 0.1:
        raise InputError.of_field("part", part, "from 1e-15 to 0.1")
    for name, least in (("least_friction", least_friction), ("least_speed", least_speed)):
        if not 0.0 < least < 0.1:
            raise InputError.of_field(name, least, "greater than 0 and below 0.1")
    base = Scenario().replace("hoop.load_fraction", load_fraction)
    fastest = FASTEST * math.sqrt(base.plane.gravity / load_fraction)
    ranges = {"plane.mu": (least_friction, MOST_FRICTION), "start.speed": (least_speed, fastest)}
    classify = Classifier(base, make_window(base, ranges), ("sequence", "ending"), "first_revolution")
    rules = Rules(classify)
    frictions = np.unique(
        np.concatenate(
            [
                geometric(least_friction, MOST_FRICTION, lines),
                np.linspace(least_friction, 0.25 * MOST_FRICTION, lines),
                np.linspace(least_friction, MOST_FRICTION, max(lines // 2, 2)),
            ]
        )
    )
    speeds = np.unique(np.concatenate([geometric(least_speed, fastest, lines), np.linspace(least_speed, fastest, lines)]))
    arrangement = arrange(
        classify.at, frictions, speeds, Options(part, THIN * fastest, rules.settled, BORDER_PART, rules.remove_spurious)
    )
    sides = MOST_FRICTION - least_friction, fastest - least_speed
    places = _widest(classify, arrangement.seen, ranges["plane.mu"], ranges["start.speed"])
    shares = arrangement.areas[places.code] / (sides[0] * sides[1])
    found = []
    for code, width, mu, speed, share in zip(*places, shares, strict=True):
        sequence, ending = rules.classes[code]
        found.append(Found(sequence, ending, float(share), float(width), float(mu), float(speed)))
    found.sort(key=lambda one: -one.area)
    hidden, unexplained = explain(arrangement, rules.classes)
    found = [one for one in found if one.width >= NARROWEST]
    seen = {(one.sequence, one.ending) for one in found}
    too_narrow = [_by_theory(base, strip, hidden[strip], sides) for strip in sorted(hidden.keys() - seen)]
    meetings = [(one.x, one.y, tuple(rules.classes[code] for code in one.codes)) for one in arrangement.meetings]
    return Survey(
        found, meetings, sorted(hidden), too_narrow, unexplained, arrangement, rules.classes, ranges["plane.mu"],
        ranges["start.speed"], classify.evaluated, arrangement.complete,
    )  # fmt: skip


class _Places(NamedTuple):
    """A position in each class, and the width of the class there."""

    code: Ints
    width: Floats
    x: Floats
    y: Floats


def _widest(classify: Classifier, seen: Seen, x_range: tuple[float, float], y_range: tuple[float, float]) -> _Places:
    """Return, for each class, the sampled point with the largest minimum extent."""
    picked = []
    for code in np.unique(seen.code):
        own = np.flatnonzero(seen.code == code)
        own = own[np.argsort(-seen.length[own], kind="stable")]
        # the longest intervals, and fewer and fewer of the shorter ones
        ranks = np.minimum(power(float(own.size), np.arange(TRIES) / TRIES).astype(int) - 1, own.size - 1)
        picked.append(own[np.unique(np.concatenate([ranks, np.arange(min(TRIES // 2, own.size))]))])
    tries = np.concatenate(picked)
    sides = x_range[1] - x_range[0], y_range[1] - y_range[0]
    low, high = _extents(classify, seen.code[tries], 0, seen.x[tries], seen.y[tries], x_range)
    widths = np.minimum((high - low) / sides[0], seen.length[tries] / sides[1])
    order = np.lexsort((-widths, seen.code[tries]))
    code, first = np.unique(seen.code[tries][order], return_index=True)
    best = order[first]
    width, x, y = widths[best], seen.x[tries][best], seen.y[tries][best]
    # move to the middle of both extents
    for _ in range(2):
        left, right = _extents(classify, code, 0, x, y, x_range)
        mid_x = 0.5 * (left + right)
        below, above = _extents(classify, code, 1, mid_x, y, y_range)
        mid_y = 0.5 * (below + above)
        wide = np.minimum((right - left) / sides[0], (above - below) / sides[1])
        good = (wide >= 0.5 * width) & (classify.at(mid_x, mid_y) == code)
        width, x, y = (np.where(good, new, old) for new, old in ((wide, width), (mid_x, x), (mid_y, y)))
    left, right = _extents(classify, code, 0, x, y, x_range)
    below, above = _extents(classify, code, 1, x, y, y_range)
    nearest = np.minimum(np.minimum(x - left, right - x) / sides[0], np.minimum(y - below, above - y) / sides[1])
    return _Places(code, 2.0 * nearest, x, y)


def _extents(
    classify: Classifier, code: Ints, along: int, x: Floats, y: Floats, ends: tuple[float, float]
) -> tuple[Floats, Floats]:
    """Return how far each class extends from its position in both directions, along x (0) or y (1)."""
    place = np.array([x, y])
    rows = np.arange(code.size)
    result = []
    for way in (-1.0, 1.0):
        tried = np.clip(place[along][:, None] + way * REACH * (ends[1] - ends[0]), *ends)
        flat = np.repeat(place[:, :, None], REACH.size, axis=2)
        flat[along] = tried
        same = classify.at(flat[0].reshape(-1), flat[1].reshape(-1)).reshape(tried.shape) == code[:, None]
        first = np.argmin(same, axis=1)
        outer = tried[rows, first]
        inner = np.where(first > 0, tried[rows, np.maximum(first - 1, 0)], place[along])
        for _ in range(HALVINGS):
            pair = place.copy()
            pair[along] = 0.5 * (inner + outer)
            is_in = classify.at(pair[0], pair[1]) == code
            inner, outer = np.where(is_in, pair[along], inner), np.where(is_in, outer, pair[along])
        result.append(np.where(same.all(axis=1), ends[0] if way < 0.0 else ends[1], inner))
    return result[0], result[1]


def _by_theory(base: Scenario, strip: Class, places: list[Place], sides: Place) -> Narrow:
    """Return a strip at the sampled position where it is widest."""
    places = sorted(places)
    asked = [places[k] for k in np.unique(np.linspace(0, len(places) - 1, LISTED).round().astype(int))]
    # on the border itself rounding decides
    speeds = np.array([[speed * (1.0 - NEAR), speed * (1.0 + NEAR)] for _, speed in asked])
    values = {"plane.mu": np.array([[mu] for mu, _ in asked]), "start.speed": speeds}
    times = points(base, values, ["time"])["time"].max(axis=1)
    best = Narrow(*strip, *places[0], -math.inf)
    for (mu, speed), time in zip(asked, times.tolist(), strict=True):
        at = base.with_values({"plane.mu": mu, "start.speed": speed, "duration": 1.5 * time + 0.5})
        try:
            logs = [getattr(strips_at(at, path), strip[1]) for path in ("plane.mu", "start.speed")]
        except InputError:  # next to the position where the skid starts or ends
            continue
        width = min(log - logarithm(side) / LN_10 for log, side in zip(logs, sides, strict=True))
        best = max(best, Narrow(*strip, mu, speed, width), key=lambda one: one.log10_width)
    return best
