"""Circle fitting: algebraic start, geometric and robust refinement, and RANSAC among outliers."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.tracking.scatter import spread

Floats = NDArray[np.float64]

BINS = 72  # of the circumference


class Circle(NamedTuple):
    """A circle in the plane or the picture [pixel]."""

    x: float
    y: float
    radius: float


def fit_circle(points: Floats) -> tuple[float, float, float, Floats]:
    """Fit a circle by algebraic least squares, which are those of the distances where the points are near a circle.

    points: shape (n, 2), at least three [pixel]; x, y, radius: the circle [pixel]; off: shape (n,), distance of each point from
    the circle, positive outside [pixel].
    """
    shift = points.mean(axis=0)
    near = points - shift
    design = np.column_stack([2.0 * near, np.ones(len(near))])
    x, y, square = np.linalg.lstsq(design, (near**2).sum(axis=1), rcond=None)[0].tolist()
    radius = float(np.sqrt(max(square + x * x + y * y, 1e-12)))
    return x + float(shift[0]), y + float(shift[1]), radius, np.hypot(*(near - (x, y)).T) - radius


class CircleFit(NamedTuple):
    """A robust fit of a circle to edges."""

    circle: Circle
    covariance: Floats  # of x, y and radius [pixel²]
    inside: NDArray[np.bool_]  # points on the circle
    spread: float  # of those points about it [pixel]
    oval: tuple[float, float]  # amplitudes of the cosine and sine, twice around, of its radius [pixel]


def robust_circle(
    points: Floats,
    start: Circle,
    reach: float,
    expected: tuple[float, float] | None,
    oval: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> CircleFit | None:
    """Fit a circle geometrically to most of the points, with Tukey's weights.

    points shape (n, 2) [pixel]; reach: points further than this from the start are ignored [pixel]; expected: known radius and
    its error, for a fit to a part of the rim [pixel]; oval: expected amplitudes and their error, for the ellipse that is the
    picture of a tilted circle [pixel]; fit: None if the points are not on a circle.
    """
    radius, error = expected or (0.0, np.inf)
    free = 5 if oval[2] else 3
    found, goal = np.array([*start, *oval[:2]])[:free], np.array([0.0, 0.0, radius, *oval[:2]])[:free]
    hold = np.array([np.inf, np.inf, error, oval[2], oval[2]])[:free] ** -2.0
    width, scatter = reach, reach
    weight, normal = np.zeros(len(points)), np.eye(free)
    for _ in range(10):
        away = points - found[:2]
        distance = np.maximum(np.hypot(*away.T), 1e-9)
        cos, sin = away.T / distance
        jacobian = np.stack([cos, sin, np.ones(len(points)), cos**2 - sin**2, 2.0 * cos * sin], axis=-1)[:, :free]
        off = distance - jacobian[:, 2:] @ found[2:]
        near = np.abs(off) < width
        if near.sum() < 8:
            return None
        # the median of the near points is small although half of the rest are outliers
        scatter = max(spread(off[near]), 0.03)
        scale = max(4.685 * scatter, 0.3)
        weight = np.where(np.abs(off) < scale, (1.0 - (off / scale) ** 2) ** 2, 0.0)
        normal = jacobian.T @ (weight[:, None] * jacobian)
        if np.linalg.det(normal[:3, :3]) <= 1e-4 * float(np.trace(normal[:3, :3])) ** 2:
            return None  # an arc too short to distinguish from a line
        normal += np.diag(scatter**2 * hold)
        step = np.linalg.solve(normal, jacobian.T @ (weight * off) + scatter**2 * hold * (goal - found))
        found += step
        width = max(3.0 * scatter, 1.0)
        if np.abs(step).max() < 1e-3:
            break
    covariance = np.asarray(scatter**2 * np.linalg.inv(normal)[:3, :3], dtype=float)
    x, y, radius, cos2, sin2 = [*found.tolist(), 0.0, 0.0][:5]
    return CircleFit(Circle(x, y, radius), covariance, weight > 0.0, scatter, (cos2, sin2))


def ransac_circles(
    points: Floats, sizes: tuple[float, float], picture: tuple[int, int], rng: np.random.Generator, draws: int = 240
) -> list[tuple[float, Circle]]:
    """Find circles through three random points (RANSAC), those with most points on their circumference first.

    points shape (n, 2) [pixel]; sizes: minimum and maximum radius [pixel]; picture: width and height; only the circumference
    inside counts [pixel]; draws: number of triples [1]; found: covered share of the circumference [1], and the circle; at most
    three separate ones.
    """
    if len(points) < 12:
        return []
    triples = points[rng.integers(0, len(points), (draws, 3))]
    # a point is as far from the first as from the second and from the third
    chords, squares = triples[:, 1:] - triples[:, :1], (triples**2).sum(axis=2)
    centre = (np.linalg.pinv(chords) @ (0.5 * (squares[:, 1:] - squares[:, :1]))[..., None])[..., 0]
    radius = np.hypot(*(centre - triples[:, 0]).T)
    fair = (radius > sizes[0]) & (radius < sizes[1])
    centre, radius = centre[fair], radius[fair]
    away = points - centre[:, None]
    near = np.abs(np.hypot(away[..., 0], away[..., 1]) - radius[:, None]) < np.maximum(1.2, 0.015 * radius)[:, None]
    place = ((np.arctan2(away[..., 1], away[..., 0]) / (2 * np.pi) + 0.5) * BINS).astype(int) % BINS
    covered = np.zeros((len(radius), BINS), dtype=bool)
    rows = np.nonzero(near)
    covered[rows[0], place[rows]] = True
    around = (np.arange(BINS) + 0.5) / BINS * 2 * np.pi - np.pi
    rim = centre[:, None, :] + radius[:, None, None] * np.stack([np.cos(around), np.sin(around)], axis=-1)
    seen = ((rim >= 0) & (rim < np.array(picture))).all(axis=-1)
    share = (covered & seen).sum(axis=1) / np.maximum(seen.sum(axis=1), 0.25 * BINS)
    result: list[tuple[float, Circle]] = []
    for k in np.argsort(-share):
        one = Circle(float(centre[k, 0]), float(centre[k, 1]), float(radius[k]))
        if all(np.hypot(one.x - old.x, one.y - old.y) + abs(one.radius - old.radius) > 0.1 * old.radius for _, old in result):
            result.append((float(share[k]), one))
        if len(result) == 3:
            break
    return result
