"""The line on which the hoop stands, from the lowest positions of its centre."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from hophoop.tracking.scatter import NORMAL, Floats

LOW = 0.15  # share of the frames below the first line
LEAST_WAY = 0.7  # minimum distance of the centre for a direction, over the radius
LEAST_ERROR = 0.02  # minimum error of a centre, from lens and sensor [pixel]
ALIKE = 10  # frames in a row with the same error [1]
CLICK = 1.0  # error of a given point of the ground [pixel]


class Ground(NamedTuple):
    """The line of the centre while the rim touches the ground [rectified pixels]."""

    x: float
    y: float
    angle: float  # of its rise to the right [rad]
    frames: int  # in contact, used for it; 0 if it was given
    directed: bool  # whether the direction is known
    height_error: float  # of y [rectified pixels]
    angle_error: float  # nan if the direction is unknown [rad]


def ground_line(points: Floats, errors: Floats, radius: float) -> Ground:
    """Fit the line below the path of the centre.

    points: shape (n, 2), centres [rectified pixels]; errors: shape (n,), errors of the heights [rectified pixels]; radius
    [rectified pixels]; ground: level if the hoop stays in one place.
    """
    middle, y = float(points[:, 0].mean()), points[:, 1]
    x = points[:, 0] - middle
    directed = bool(np.ptp(x) > LEAST_WAY * radius)

    def fit(weight: np.ndarray) -> tuple[Floats, Floats]:
        line = np.polyfit(x, y, int(directed), w=np.sqrt(weight))
        return line, y - np.polyval(line, x)

    weight = np.ones(len(x))
    for _ in range(61):  # quantile regression by reweighting
        line, off = fit(weight)
        weight = np.where(off > 0, LOW, 1.0 - LOW) / np.maximum(np.abs(off), 1e-3)
    error = max(np.median(errors), 0.05)
    near = np.abs(off) < 4.0 * error
    for _ in range(20):
        if near.sum() >= (4 if directed else 3):
            line, off = fit(1.0 * near)
            near = np.abs(off) < 3.0 * max(error, NORMAL * np.median(np.abs(off[near])))
    if not near.any():  # the hoop keeps no height, as in a film that lies on its side
        near[:] = True
    used = int(near.sum())
    height_error = float(max(np.sqrt((off[near] ** 2).mean()), LEAST_ERROR) * np.sqrt(ALIKE / used))
    angle, angle_error = 0.0, float("nan")
    if directed:
        angle, angle_error = float(np.arctan(line[0])), height_error / float(np.std(x[near]))
    return Ground(middle, float(line[-1]), angle, used, directed, height_error, angle_error)


def line_through(points: Floats, radius: float) -> Ground:
    """Return the centre's line over two points of the ground.

    points: shape (2, 2) [rectified pixels]; radius [rectified pixels].
    """
    left, right = np.sort(points @ [1.0, 1.0j])
    along = right - left
    centre = complex(left + 1j * radius * along / abs(along))
    error = float(np.sqrt(2.0) * CLICK / abs(along))
    return Ground(centre.real, centre.imag, float(np.angle(along)), 0, True, CLICK, error)
