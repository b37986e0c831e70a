"""Follow the hoop from frame to frame: predict, find, or mark as lost."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from hophoop.tracking.circle import Circle
from hophoop.tracking.detection import Search, acceptable, detect
from hophoop.tracking.marker import Marker, Spot, spots
from hophoop.tracking.rays import Rim, find_disc, find_rim
from hophoop.tracking.video import Picture

Floats = NDArray[np.float64]

FORGET = 0.25  # without the hoop, after which its velocity is unknown [s]
LEAST_REACH = 9.0  # [pixel]
AREAS = (0.55, 1.7)  # area of a visible marker over its usual area
NEAR = 0.09  # tolerance of its distance from the centre, over the radius


@dataclass
class Rows:
    """Positions, one row per frame, in rectified pixels; nan where nothing was found."""

    t: list[float] = field(default_factory=list)  # of the frame's first row, from the file
    circle: list[tuple[float, float, float]] = field(default_factory=list)
    covariance: list[tuple[float, float, float]] = field(default_factory=list)  # xx, xy, yy
    agreement: list[float] = field(default_factory=list)  # share of the whole rim that is seen
    arrow: list[tuple[float, float]] = field(default_factory=list)  # from the centre to the marker, at the exposure of its row
    late: list[float] = field(default_factory=list)  # delay of that after the centre's row
    angle: list[float] = field(default_factory=list)  # of the arrow from up, clockwise, without jumps
    marker_pixel: list[tuple[float, float]] = field(default_factory=list)
    uncertain: list[float] = field(default_factory=list)  # times after which whole revolutions may be missing

    def forget(self, row: int) -> None:
        """Mark the hoop as lost in a frame."""
        for name in ("circle", "covariance"):
            getattr(self, name)[row] = (np.nan,) * 3
        for name in ("arrow", "marker_pixel"):
            getattr(self, name)[row] = (np.nan, np.nan)
        self.angle[row] = self.agreement[row] = np.nan


class Follower:
    """Follows a hoop through the frames of a film.

    Of earlier frames it keeps the last position and velocity, and the rows.
    """

    def __init__(self, search: Search, marker: Marker | None, exposure: float, row_delay: float, seed: int = 0) -> None:
        self.search, self.marker = search, marker
        self.exposure, self.row_delay = exposure, row_delay
        self.rows = Rows()
        self._rng = np.random.default_rng(seed)
        self._last: tuple[float, Floats] | None = None  # time and centre
        self._velocity: Floats | None = None  # [rectified pixels/s]
        self._turned: tuple[float, float] | None = None  # time and angle
        self._omega: float | None = None

    def add(self, picture: Picture) -> None:
        """Look for the hoop in the next frame."""
        rim = self._rim(picture)
        rows = self.rows
        if rim is None:
            rows.t.append(picture.t + 0.5 * self.exposure)
            rows.circle.append((np.nan, np.nan, np.nan))
            rows.covariance.append((np.nan, np.nan, np.nan))
            rows.agreement.append(np.nan)
            self._add_without_marker()
            return
        middle = np.array([rim.circle.x, rim.circle.y])
        t = picture.t + 0.5 * self.exposure + self.row_delay * self._row(middle)
        self._move(t, middle)
        rows.t.append(t)
        rows.circle.append((rim.circle.x, rim.circle.y, rim.circle.radius))
        rows.covariance.append((rim.covariance[0, 0], rim.covariance[0, 1], rim.covariance[1, 1]))
        rows.agreement.append(rim.share * rim.seen)
        spot = self._spot(picture, rim.circle)
        if spot is None:
            self._add_without_marker()
        else:
            self._turn(t, rim.circle, spot)

    def _row(self, point: Floats) -> float:
        return float(self.search.camera.to_picture(point)[1])

    # --- the rim -------------------------------------------------------------------------------

    def _rim(self, picture: Picture) -> Rim | None:
        expected = self.search.expected
        assert expected is not None
        rim = None
        if self._last is not None and picture.t - self._last[0] < FORGET:
            wait = picture.t - self._last[0]
            velocity = np.zeros(2) if self._velocity is None else self._velocity
            guess = self._last[1] + velocity * wait
            way = float(np.hypot(*velocity)) * wait
            # an impact may stop the hoop, and the first velocity is unknown
            reach = LEAST_REACH + 0.6 * way if self._velocity is not None else 0.3 * expected[0]
            circle = Circle(float(guess[0]), float(guess[1]), expected[0])
            lean = velocity * self.row_delay
            reach = min(reach, 0.45 * expected[0])
            rim = find_rim(
                picture.luma, self.search.camera, circle, self.search.sign, reach, expected, self._rng, (lean[0], lean[1])
            )
            if rim is not None and acceptable(rim, expected):
                return rim
        hoop = detect(picture.luma, self.search, self._rng)
        return None if hoop is None else hoop.rim

    def _move(self, t: float, middle: Floats) -> None:
        if self._last is None or t - self._last[0] >= FORGET:
            self._velocity = None
        else:
            self._velocity = (middle - self._last[1]) / (t - self._last[0])
        self._last = (t, middle)

    # --- the marker ----------------------------------------------------------------------------

    def _spot(self, picture: Picture, circle: Circle) -> Spot | None:
        if self.marker is None:
            return None
        good = []
        for spot in spots(picture, self.search.camera, circle, self.marker):
            ratio = np.hypot(spot.x - circle.x, spot.y - circle.y) / circle.radius
            share = spot.area / self.marker.area
            if AREAS[0] < share < AREAS[1] and abs(ratio - self.marker.ratio) < max(NEAR, 3.0 / circle.radius):
                good.append((abs(np.log(share)) + abs(ratio - self.marker.ratio) / NEAR, spot))
        if not good:
            return None
        spot = min(good, key=lambda pair: pair[0])[1]
        disc = find_disc(picture.luma, self.search.camera, Circle(spot.x, spot.y, spot.radius))
        return spot if disc is None else spot._replace(x=disc[0], y=disc[1])

    def _turn(self, t: float, circle: Circle, spot: Spot) -> None:
        rows = self.rows
        late = self.row_delay * (spot.row - self._row(np.array([circle.x, circle.y])))
        arrow = np.array([spot.x - circle.x, spot.y - circle.y])
        angle = float(np.arctan2(arrow[0], arrow[1]))
        if self._turned is not None:
            wait = t - self._turned[0]
            guess = self._turned[1] + (self._omega or 0.0) * wait
            angle += 2 * np.pi * round((guess - angle) / (2 * np.pi))
            if abs(self._omega or 0.0) * wait > 0.5 * np.pi and len(rows.angle) and np.isnan(rows.angle[-1]):
                rows.uncertain.append(t)
            self._omega = (angle - self._turned[1]) / wait
        self._turned = (t, angle)
        rows.arrow.append((float(arrow[0]), float(arrow[1])))
        rows.late.append(late)
        rows.angle.append(angle)
        pixel = self.search.camera.to_picture(np.array([spot.x, spot.y]))
        rows.marker_pixel.append((float(pixel[0]), float(pixel[1])))

    def _add_without_marker(self) -> None:
        self.rows.arrow.append((np.nan, np.nan))
        self.rows.late.append(0.0)
        self.rows.angle.append(np.nan)
        self.rows.marker_pixel.append((np.nan, np.nan))
