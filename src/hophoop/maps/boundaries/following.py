"""One boundary between two classes, followed point by point to rounding.

Around a point of the boundary the classes on a small circle are computed. Where they change from one class to the other ahead,
the chord is divided to adjacent doubles. The radius decreases where the curve bends, and further and further where it ends in
a junction with a third class.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from hophoop.kernel.numerics.arithmetic import weighted_sum
from hophoop.kernel.numerics.elementwise import arctangent2, hypotenuse, sine_and_cosine
from hophoop.maps.boundaries.classes import SLIVER, Border, Classifier, Floats, first_changes, make_window
from hophoop.scenario import InputError, Scenario

# First samples on a circle, by their angle to the last step [rad]: closest ahead, where a class may be narrow.
EVENLY = np.linspace(-1.0, 1.0, 48)
ANGLES = math.pi * EVENLY * EVENLY * EVENLY
PARTS = 16  # per division of a line: one call for 16 points takes about as long as one for 2
SMALLEST = 1e-8  # radius at which a curve that cannot be followed ends, relative to the window
# Cosines of angles between steps: the radius grows below 2.3°, and shrinks above 6.9°.
STRAIGHT, BENT = 0.9992, 0.9928


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
    classify = Classifier(base, window, [quantity] if isinstance(quantity, str) else list(quantity), span)
    begin, end = window.places(np.array([one, other], float))
    for point, place in ((one, begin), (other, end)):
        if not ((place >= 0.0) & (place <= 1.0)).all():
            raise InputError(f"point {point!r} must lie in the window.")
    return follow(classify, begin, end, step, most)


def follow(classify: Classifier, one: Floats, other: Floats, step: float, most: int) -> Border:
    """Follow a boundary between two positions of a window."""
    code, last = classify(np.array([one, other])).tolist()
    if code == last:
        raise InputError(f"the two points are of one class, {classify.names[code]}: a boundary must lie between them.")
    (start,), (beyond,) = first_changes(classify, one[None], other[None], code, SLIVER, _between)
    # `one` is on the left ahead
    ahead = np.array([one[1] - other[1], other[0] - one[0]])
    points, last_end = _walk(classify, start, ahead, (beyond, code), step, most)
    first_end = last_end
    if last_end != "closed":
        back, first_end = _walk(classify, start, -ahead, (code, beyond), step, most)
        points = [*back[::-1], *points[1:]]
    x, y = classify.window.values(np.array(points)).T
    return Border(classify.window, x, y, (classify.names[beyond], classify.names[code]), (first_end, last_end))


def _between(near: Floats, far: Floats) -> Floats:
    """Return the points that divide a line into equal parts."""
    return np.linspace(near, far, PARTS + 1)[1:-1]


def _walk(
    classify: Classifier, start: Floats, ahead: Floats, codes: tuple[int, int], step: float, most: int
) -> tuple[list[Floats], str]:
    """Return the points from `start` on, with the class codes[0] on the right, and the kind of end.

    ahead: the last step, or the direction of the first one.
    """
    points = [start]
    radius = 0.25 * step
    while len(points) <= most:
        found = _next(classify, points[-1], ahead, codes, radius)
        if found is None:
            radius *= 0.5
            if radius < SMALLEST:
                return points, "junction"
            continue
        way = found - points[-1]
        cosine = weighted_sum(way, ahead) / max(hypotenuse(*way) * hypotenuse(*ahead), SMALLEST * SMALLEST)
        if cosine < BENT and radius > 1e-4 * step and len(points) > 1:
            radius *= 0.5
            continue
        if len(points) > 3 and hypotenuse(*(found - start)) < 0.6 * radius:
            return [*points, start], "closed"
        if way.any():
            points.append(found)
        if ((found == 0.0) | (found == 1.0)).any():
            return points, "edge"
        ahead = way
        if cosine > STRAIGHT:
            radius = min(1.5 * radius, step)
    return points, "limit"


def _next(classify: Classifier, point: Floats, ahead: Floats, codes: tuple[int, int], radius: float) -> Floats | None:
    """Return the next point of the boundary on a circle; None if there is none."""
    sines, cosines = sine_and_cosine(arctangent2(ahead[1], ahead[0]) + ANGLES)
    # outside the window the classes are those of its edge
    circle = np.clip(point + radius * np.stack([cosines, sines], axis=-1), 0.0, 1.0)
    seen = classify(circle)
    changes = np.flatnonzero((seen[:-1] == codes[0]) & (seen[1:] == codes[1]))
    if changes.size == 0:
        return None
    k = changes[np.argmin(np.abs(ANGLES[changes]))]
    (found,), beyond = first_changes(classify, circle[[k]], circle[[k + 1]], codes[0], SLIVER, _between)
    return found if beyond == codes[1] else None
