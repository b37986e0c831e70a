"""Follow the hoop from frame to frame: predict, find, or mark as lost."""

from __future__ import annotations

from typing import Any, NamedTuple

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


NONE = float("nan")


class Frame(NamedTuple):
    """Positions in one frame, in rectified pixels, nan where nothing was found; `rows` has arrays of them."""

    t: Any  # of the exposure, from the file [s]
    circle: Any = (NONE, NONE, NONE)
    covariance: Any = (NONE, NONE, NONE)  # xx, xy, yy
    agreement: Any = NONE  # share of the whole rim that is seen
    arrow: Any = (NONE, NONE)  # from the centre to the marker, at the exposure of its row
    late: Any = 0.0  # delay of that after the centre's row
    angle: Any = NONE  # of the arrow from up, clockwise, without jumps
    marker_pixel: Any = (NONE, NONE)
    uncertain: Any = False  # whether whole revolutions may be missing before


class Follower:
    """Follows a hoop through the frames of a film.

    Of earlier frames it keeps the last position and velocity, and the rows.
    """

    def __init__(self, search: Search, marker: Marker | None, exposure: float, row_delay: float, seed: int = 0) -> None:
        self.search, self.marker = search, marker
        self.exposure, self.row_delay = exposure, row_delay
        self.frames: list[Frame] = []
        self._rng = np.random.default_rng(seed)
        self._last: tuple[float, Floats] | None = None  # time and centre
        self._velocity: Floats | None = None  # [rectified pixels/s]
        self._turned: tuple[float, float] | None = None  # time and angle
        self._omega = 0.0

    @property
    def rows(self) -> Frame:
        """Arrays of all frames; a lost hoop's row is interpolated, so that times increase."""
        rows = Frame(*map(np.array, zip(*self.frames, strict=True)))
        lost = np.isnan(rows.circle[:, 0])
        if self.row_delay and not lost.all():
            delay = self.row_delay * self.search.camera.to_picture(rows.circle[~lost, :2])[:, 1]
            rows.t[lost] += np.interp(rows.t[lost], rows.t[~lost] - delay, delay)
        return rows

    def add(self, picture: Picture) -> None:
        """Look for the hoop in the next frame."""
        rim = self._rim(picture)
        if rim is None:
            self.frames.append(Frame(picture.t + 0.5 * self.exposure))
            return
        circle, own = rim.circle, rim.covariance
        middle = np.array([circle.x, circle.y])
        t = picture.t + 0.5 * self.exposure + self.row_delay * self._row(middle)
        fresh = self._last is None or t - self._last[0] >= FORGET
        self._velocity = None if fresh or self._last is None else (middle - self._last[1]) / (t - self._last[0])
        self._last = (t, middle)
        frame = Frame(t, circle, (own[0, 0], own[0, 1], own[1, 1]), rim.share * rim.seen)
        spot = self._spot(picture, circle)
        self.frames.append(frame if spot is None else self._turn(frame, spot))

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
            rim = find_rim(picture.luma, self.search.camera, circle, self.search.sign, reach, expected, (lean[0], lean[1]))
            if rim is not None and acceptable(rim, expected):
                return rim
        hoop = detect(picture.luma, self.search, self._rng)
        return None if hoop is None else hoop.rim

    # --- the marker ----------------------------------------------------------------------------

    def _spot(self, picture: Picture, circle: Circle) -> Spot | None:
        if self.marker is None:
            return None
        good = []
        for spot in spots(picture, self.search.camera, circle, self.marker):
            share, off = spot.area / self.marker.area, abs(spot.ratio - self.marker.ratio)
            if AREAS[0] < share < AREAS[1] and off < max(NEAR, 3.0 / circle.radius):
                good.append((abs(np.log(share)) + off / NEAR, spot))
        if not good:
            return None
        spot = min(good, key=lambda pair: pair[0])[1]
        disc = find_disc(picture.luma, self.search.camera, Circle(spot.x, spot.y, spot.radius))
        return spot if disc is None else spot._replace(x=disc[0], y=disc[1])

    def _turn(self, frame: Frame, spot: Spot) -> Frame:
        """Add the marker to a frame."""
        t, circle = frame.t, frame.circle
        arrow = np.array([spot.x - circle.x, spot.y - circle.y])
        angle, uncertain = float(np.arctan2(*arrow)), False
        if self._turned is not None:
            wait = t - self._turned[0]
            guess = self._turned[1] + self._omega * wait
            angle += 2 * np.pi * round((guess - angle) / (2 * np.pi))
            uncertain = abs(self._omega) * wait > 0.5 * np.pi and bool(np.isnan(self.frames[-1].angle))
            self._omega = (angle - self._turned[1]) / wait
        self._turned = (t, angle)
        late = self.row_delay * (spot.row - self._row(np.array([circle.x, circle.y])))
        pixel = self.search.camera.to_picture(np.array([spot.x, spot.y]))
        return frame._replace(arrow=arrow, late=late, angle=angle, marker_pixel=pixel, uncertain=uncertain)
