"""Boundaries between classes, followed point by point to rounding.

From a point on the boundary the classes on a small circle around it are computed. Where they change from one class to the
other ahead, the circle is bisected to adjacent doubles. The radius decreases where the curve bends, and further and further
where it ends in a junction with a third class.
"""

from __future__ import annotations

import itertools
import json
import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hophoop.kernel.numerics.arithmetic import weighted_sum
from hophoop.kernel.numerics.elementwise import arccosine, arctangent2, hypotenuse, sine_and_cosine
from hophoop.maps.boundaries.classes import Classifier, Floats, Window, make_window
from hophoop.scenario import InputError, Scenario

if TYPE_CHECKING:
    import xarray

Curve = Callable[[Floats], tuple[Floats, Floats]]

AHEAD, NARROW = 7, 0.35  # number of first samples, and their half angle [rad]
AROUND, WIDE = 48, 0.75 * math.pi  # the same, if the boundary is not among them
PARTS = 4  # per division of an arc
# Where several events coincide, rounding puts slivers of other classes between two: below this width, relative to the window,
# they are ignored.
SLIVER = 1e-10
SMALLEST = 1e-8  # radius at which a curve that cannot be followed ends, relative to the window
BEND = 0.12  # angle between two steps above which the radius is halved [rad]


class Border(NamedTuple):
    """A curve between two classes.

    Attributes
    ----------
    window : Window
        The plane of the two parameters.
    x, y : ndarray, shape (n,)
        Points of the curve, each on the boundary to rounding, in the parameters' units [SI].
    classes : tuple of str
        The classes to the right and left of the curve, in its direction, with x to the right and y up.
    ends : tuple of str
        Its ends, first and last: ``edge`` of the window, ``junction`` with another class,
        ``closed`` (back at its start) or ``limit`` (maximum number of points).
    """

    window: Window
    x: Floats
    y: Floats
    classes: tuple[str, str]
    ends: tuple[str, str]


def boundary(
    base: Scenario | None,
    ranges: dict[str, tuple[float, float]],
    one: tuple[float, float],
    other: tuple[float, float],
    quantity: str | Sequence[str] = "sequence",
    span: str = "first_revolution",
    logarithmic: Sequence[str] = (),
    step: float = 0.02,
    most: int = 4000,
) -> Border:
    """Follow a boundary between two classes in both directions, to its ends.

    Parameters
    ----------
    base : Scenario or None
        The scenario to vary; None is the reference hoop.
    ranges : dict of str to tuple of float
        The two parameters by path, x first, and the window in which the curve is followed [SI].
    one, other : tuple of float
        Two points (x, y) of different classes: the boundary is the first one on the straight line from `one` to
        `other` [SI].
    quantity : str or sequence of str, default 'sequence'
        Quantities that define the classes.
    span : str, default 'first_revolution'
        As in `sweep`.
    logarithmic : sequence of str
        Parameters with a logarithmic axis.
    step : float, default 0.02
        Maximum distance of two points, relative to the window [1].
    most : int, default 4000
        Maximum number of points in each direction [1].

    Returns
    -------
    border : Border

    Raises
    ------
    ValueError
        If the two points are of one class or not in the window, or an option is not allowed.

    Examples
    --------
    >>> border = boundary(
    ...     None, {"plane.mu": (0.9, 1.1), "start.speed": (2.0, 4.0)}, one=(1.0, 3.1), other=(1.0, 3.8)
    ... )
    >>> border.classes, border.ends
    (('H', 'RKRSH'), ('edge', 'edge'))
    """
    if not 0.0 < step <= 0.5:
        raise InputError.of_field("step", step, "greater than 0 and at most 0.5")
    if most < 1:
        raise InputError.of_field("most", most, "at least 1")
    base = Scenario() if base is None else base
    window = make_window(base, ranges, logarithmic)
    names = [quantity] if isinstance(quantity, str) else list(quantity)
    classify = Classifier(base, window, names, span)
    begin, end = (_place(window, point) for point in (one, other))
    return follow(classify, begin, end, step, most)


def _place(window: Window, point: tuple[float, float]) -> Floats:
    place = np.array(window.places(np.float64(point[0]), np.float64(point[1])))
    if not ((place >= 0.0) & (place <= 1.0)).all():
        raise InputError(f"point {point!r} must lie in the window.")
    return place


def follow(classify: Classifier, one: Floats, other: Floats, step: float, most: int) -> Border:
    """Follow a boundary between two positions of a window."""
    code = classify(one[0], one[1])
    if classify(other[0], other[1]) == code:
        raise InputError(f"the two points are of one class, {classify.names[int(code)]}: a boundary must lie between them.")

    def along(part: Floats) -> tuple[Floats, Floats]:
        place = one[:, None] + (other - one)[:, None] * part
        return place[0], place[1]

    parts, codes = _divide(classify, along, 0.0, 1.0, int(code), hypotenuse(*(other - one)))
    point = np.array(along(np.array([parts]))).reshape(2)
    way = other - one
    # the first class is on the right in the direction of the boundary
    ahead = np.array([-way[1], way[0]]) / hypotenuse(*way)
    first, ends_first = _walk(classify, point, ahead, codes, step, most)
    if ends_first == "closed":
        second: list[Floats] = []
        ends_second = "closed"
    else:
        second, ends_second = _walk(classify, point, -ahead, codes[::-1], step, most)
    points = np.array([*second[::-1], point, *first])
    x, y = classify.window.values(points[:, 0], points[:, 1])
    # `ahead` is the direction turned left, so that `one` is on the left
    names = (classify.names[codes[1]], classify.names[codes[0]])
    return Border(classify.window, x, y, names, (ends_second, ends_first))


def _divide(
    classify: Classifier, curve: Curve, low: float, high: float, code: int, length: float
) -> tuple[float, tuple[int, int]]:
    """Return where on a curve the class first changes from `code`, as far as sampled, and the classes on both sides.

    `length` is that of the curve per unit of its parameter, relative to the window.
    """
    way = 1.0 if high > low else -1.0
    end = high
    while True:
        inner = low + (high - low) * np.arange(1, PARTS) / PARTS
        inner = np.unique(inner[(inner > min(low, high)) & (inner < max(low, high))])[:: int(way)]
        if inner.size == 0:
            break
        changed = np.flatnonzero(classify(*curve(inner)) != code)
        if changed.size:
            k = int(changed[0])
            high = float(inner[k])
            low = float(inner[k - 1]) if k else low
        else:
            low = float(inner[-1])
    beyond = high + way * SLIVER / length
    if way * beyond > way * end:
        beyond = end
    return high, (code, int(classify(*curve(np.array([beyond])))[0]))


def _walk(
    classify: Classifier, start: Floats, ahead: Floats, codes: tuple[int, int], step: float, most: int
) -> tuple[list[Floats], str]:
    """Return the points after `start`, with the class codes[0] on the left, and the kind of end."""
    points: list[Floats] = []
    point = start
    radius = 0.25 * step
    while len(points) < most:
        found = _next(classify, point, ahead, codes, radius)
        if found is None:
            radius *= 0.5
            if radius < SMALLEST:
                return points, "junction"
            continue
        way = (found - point) / radius
        turned = arccosine(max(-1.0, min(1.0, float(weighted_sum(way, ahead)))))
        if turned > BEND and radius > 1e-4 * step and points:
            radius *= 0.5
            continue
        outside = (found < 0.0).any() or (found > 1.0).any()
        if outside:
            part = _leaving(point, found)
            edge = point + part * (found - point)
            settled = _on_edge(classify, edge, codes, radius)
            return [*points, settled], "edge"
        points.append(found)
        point, ahead = found, way
        if len(points) > 3 and hypotenuse(*(point - start)) < 0.6 * radius:
            return [*points, start], "closed"
        if turned < 0.3 * BEND:
            radius = min(1.5 * radius, step)
    return points, "limit"


def _next(classify: Classifier, point: Floats, ahead: Floats, codes: tuple[int, int], radius: float) -> Floats | None:
    """Return the next point of the boundary on a circle; None if there is none."""
    middle = arctangent2(ahead[1], ahead[0])

    def circle(phi: Floats) -> tuple[Floats, Floats]:
        # outside the window the classes are those of its edge
        sines, cosines = sine_and_cosine(phi)
        return np.clip(point[0] + radius * cosines, 0.0, 1.0), np.clip(point[1] + radius * sines, 0.0, 1.0)

    for count, reach in ((AHEAD, NARROW), (AROUND, WIDE)):
        # from the right, through ahead, to the left
        angles = middle + np.linspace(-reach, reach, count)
        seen = classify(*circle(angles))
        changes = np.flatnonzero((seen[:-1] == codes[1]) & (seen[1:] == codes[0]))
        if changes.size == 0:
            continue
        k = int(changes[np.argmin(np.abs(angles[changes] - middle))])
        phi, pair = _divide(classify, circle, float(angles[k]), float(angles[k + 1]), codes[1], radius)
        if pair == (codes[1], codes[0]):
            sine, cosine = sine_and_cosine(phi)
            return np.array([point[0] + radius * cosine, point[1] + radius * sine])
    return None


def _leaving(point: Floats, found: Floats) -> float:
    """Return the fraction of the step to a point outside at which the window ends."""
    part = 1.0
    for i in range(2):
        for edge in (0.0, 1.0):
            if (point[i] - edge) * (found[i] - edge) < 0.0:
                part = min(part, float((edge - point[i]) / (found[i] - point[i])))
    return part


def _on_edge(classify: Classifier, edge: Floats, codes: tuple[int, int], radius: float) -> Floats:
    """Return the boundary's point on the edge of the window, near a guess."""
    across = 1 if min(abs(edge[0]), abs(edge[0] - 1.0)) < min(abs(edge[1]), abs(edge[1] - 1.0)) else 0
    edge = edge.copy()
    edge[1 - across] = round(float(edge[1 - across]))

    def line(shift: Floats) -> tuple[Floats, Floats]:
        place = np.repeat(edge[:, None], np.size(shift), axis=1)
        place[across] = np.clip(place[across] + shift, 0.0, 1.0)
        return place[0], place[1]

    shifts = np.linspace(-radius, radius, AROUND)
    seen = classify(*line(shifts))
    pairs = {codes, codes[::-1]}
    changes = [k for k in range(AROUND - 1) if (int(seen[k]), int(seen[k + 1])) in pairs]
    if not changes:
        return edge
    k = min(changes, key=lambda k: abs(float(shifts[k])))
    shift, _ = _divide(classify, line, float(shifts[k]), float(shifts[k + 1]), int(seen[k]), 1.0)
    return np.array(line(np.array([shift]))).reshape(2)


def borders(dataset: xarray.Dataset, quantity: str = "sequence", step: float = 0.02, most: int = 4000) -> list[Border]:
    """Follow all boundaries between the classes of a map of two axes that its cells show.

    Parameters
    ----------
    dataset : xarray.Dataset
        A map over two parameters.
    quantity : str, default 'sequence'
        Quantities that define the classes.
    step : float, default 0.02
        Maximum distance of two points, relative to the map [1].
    most : int, default 4000
        Maximum number of points of a curve in each direction [1].

    Returns
    -------
    borders : list of Border

    Raises
    ------
    ValueError
        If the map does not have two increasing axes of numbers, or the quantity has no classes.
    """
    if "plan" not in getattr(dataset, "attrs", {}):
        raise InputError("dataset must be a map of hophoop.maps.sweep.", field="dataset", value=dataset)
    plan = json.loads(dataset.attrs["plan"])
    paths = list(plan["axes"])
    if len(paths) != 2:
        raise InputError(f"the map must have two axes, not {len(paths)}.")
    xs, ys = (np.asarray(dataset[path].values) for path in paths)
    if any(v.dtype.kind != "f" or v.size < 2 or not (np.diff(v) > 0).all() for v in (xs, ys)):
        raise InputError("the map's axes must be growing numbers.")
    base = Scenario.from_dict(plan["scenario"])
    window = make_window(base, {paths[0]: (xs[0], xs[-1]), paths[1]: (ys[0], ys[-1])})
    classify = Classifier(base, window, [quantity], plan["span"])
    u, _ = window.places(xs, np.full(xs.size, ys[0]))
    _, v = window.places(np.full(ys.size, xs[0]), ys)
    codes = classify(u[:, None], v[None, :])
    found: list[Border] = []
    left = {(0, i, j) for i, j in np.argwhere(codes[1:] != codes[:-1]).tolist()}
    left |= {(1, i, j) for i, j in np.argwhere(codes[:, 1:] != codes[:, :-1]).tolist()}
    while left:
        side, i, j = min(left)
        left.discard((side, i, j))
        one = np.array([u[i], v[j]])
        other = np.array([u[i + 1], v[j]] if side == 0 else [u[i], v[j + 1]])
        border = follow(classify, one, other, step, most)
        found.append(border)
        left -= _crossed(border, xs, ys)
    return found


def _crossed(border: Border, xs: Floats, ys: Floats) -> set[tuple[int, int, int]]:
    """Return the sides of the map's grid that a boundary crosses."""
    result = set()
    points = np.stack([border.x, border.y], axis=1)
    for a, b in itertools.pairwise(points):
        for side, (p, q, across, rails) in enumerate(
            ((a, b, xs, ys), (a[::-1], b[::-1], ys, xs)),
        ):
            low, high = sorted((p[1], q[1]))
            for k in range(int(np.searchsorted(rails, low)), int(np.searchsorted(rails, high, "right"))):
                part = 0.5 if q[1] == p[1] else (rails[k] - p[1]) / (q[1] - p[1])
                place = p[0] + part * (q[0] - p[0])
                m = int(np.searchsorted(across, place)) - 1
                if 0 <= m < across.size - 1:
                    result.add((side, m, k) if side == 0 else (side, k, m))
    return result
