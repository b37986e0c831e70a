"""A camera in front of the plane of motion, straight on or tilted.

Points of the plane are in rectified pixels: along the picture's columns and up its rows, with the scale at the point where
the optical axis meets the plane. Without tilt a rectified pixel is a pixel.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from typing import Annotated

import numpy as np
from pydantic import Field

from hophoop._support.extras import need
from hophoop.tracking.circle import fit_circle
from hophoop.tracking.scatter import Complexes, Floats, spread

USUAL_FOCAL = 0.9  # of a phone, over the width of its picture; error 30 %
FOCAL_SPREAD = 0.3
TILT_SPREAD = 0.25  # prior of a tilt [rad]
RADIUS_ERROR = 0.07  # of a picture [pixel]
OVAL_ERROR = 0.1  # of its amplitude twice around: coding, and a rolling shutter whose delay was not given [pixel]
BLURRED = 0.1  # error of both, over the way of the hoop during the exposure
STARTS = (-0.12, -0.04, 0.04, 0.12)  # tilts from which the search starts [rad]
LIMITS = ((-0.5, -0.5, -1.2), (0.5, 0.5, 1.2))  # of tilts [rad] and of the logarithm of the focal length
WORTH = 60.0  # minimum reduction of the sum of squares over the variance by a significant tilt


@dataclass(frozen=True)
class Camera:
    """A pinhole camera in front of the plane of motion.

    Parameters
    ----------
    width, height : int
        Size of the picture [pixel].
    focal : float
        Focal length [pixel].
    tilt_x, tilt_y : float, default 0
        Turn of the plane about the picture's horizontal and vertical axis [rad].
    """

    width: Annotated[int, Field(gt=0)]
    height: Annotated[int, Field(gt=0)]
    focal: Annotated[float, Field(gt=0, allow_inf_nan=False)]
    tilt_x: float = 0.0
    tilt_y: float = 0.0

    def _projection(self) -> Floats:
        """Matrix from points of the plane to pixels, in homogeneous coordinates."""
        (sin_x, sin_y), (cos_x, cos_y) = np.sin([self.tilt_x, self.tilt_y]), np.cos([self.tilt_x, self.tilt_y])
        plane = np.array([[cos_y, 0, 0], [sin_x * sin_y, cos_x, 0], [-cos_x * sin_y, sin_x, self.focal]])
        lens = np.array([[self.focal, 0, 0.5 * (self.width - 1)], [0, -self.focal, 0.5 * (self.height - 1)], [0, 0, 1]])
        return np.asarray(lens @ plane)

    def to_picture(self, points: Floats) -> Floats:
        """Project points of the plane to pixels.

        Parameters
        ----------
        points : ndarray, shape (…, 2)
            In rectified pixels, up is positive [pixel].

        Returns
        -------
        pixels : ndarray, shape (…, 2)
            Column and row [pixel].
        """
        return _through(self._projection(), points)

    def to_plane(self, pixels: Floats) -> Floats:
        """Return the points of the plane at pixels.

        Parameters
        ----------
        pixels : ndarray, shape (…, 2)
            Column and row [pixel].

        Returns
        -------
        points : ndarray, shape (…, 2)
            In rectified pixels, up is positive [pixel].
        """
        return _through(np.asarray(np.linalg.inv(self._projection()), dtype=float), pixels)


def _through(matrix: Floats, points: Floats) -> Floats:
    """Return points through a projection."""
    seen = points @ matrix[:, :2].T + matrix[:, 2]
    return np.asarray(seen[..., :2] / seen[..., 2:])


def pairs(points: Complexes) -> Floats:
    """Return coordinates, shape (n, 2), of points in the complex plane."""
    return np.stack([points.real, points.imag], axis=-1)


def flat(camera: Camera, pixels: Complexes) -> Complexes:
    """Return the points of the plane at pixels, both in the complex plane."""
    return np.asarray(camera.to_plane(pairs(pixels)) @ [1.0, 1.0j])


def fit_camera(camera: Camera, edges: list[Complexes], focal_known: bool, blur: Floats) -> Camera:
    """Find the tilt with which all images of one circle have the same radius.

    camera: the picture's size and an initial focal length; edges: points of the rim in several pictures [pixel];
    focal_known: whether the focal length is known; blur: way of the hoop during the exposure of each picture [pixel]; camera:
    as given if no tilt is significant.
    """
    edges = [points[:: max(1, len(points) // 60)] for points in edges]
    steps = [np.diff(fit_circle(flat(camera, points))[1]) for points in edges]  # a tilt hardly changes them
    scatter = max(spread(np.concatenate(steps)) / np.sqrt(2.0), 0.05)
    # blur and coding add an error of the radius to that of its points, and make an oval of the picture of a rim
    count, wider = np.array([len(points) for points in edges]), BLURRED * blur
    error = np.sqrt(scatter**2 / count + RADIUS_ERROR**2 + wider**2)
    oval_error = np.sqrt(2.0 * scatter**2 / count + OVAL_ERROR**2 + wider**2)

    def of(values: Floats) -> Camera:
        longer = 1.0 if focal_known else np.exp(values[2])
        return replace(camera, tilt_x=values[0], tilt_y=values[1], focal=camera.focal * longer)

    def residuals(values: Floats) -> Floats:
        now = of(values)
        radii, ovals, rests = zip(*(_shape(now, points) for points in edges), strict=True)
        off = (radii - np.average(radii, weights=error**-2)) / error
        oval, prior = np.array(ovals) / oval_error, values / [TILT_SPREAD, TILT_SPREAD, FOCAL_SPREAD]
        result: Floats = np.concatenate([off, oval.real, oval.imag, np.concatenate(rests) / scatter, prior])
        return result

    def cost(values: Floats) -> float:
        return 2.0 * float((np.sqrt(1.0 + residuals(values) ** 2) - 1.0).sum())

    # the shape of a circle does not show which side is nearer; only its size across the picture does
    starts = sorted((np.array([*tilt, 0.0]) for tilt in product(STARTS, STARTS)), key=cost)
    solve = partial(need("scipy.optimize", "track").least_squares, residuals, loss="soft_l1", bounds=LIMITS, max_nfev=12)
    best = min((solve(start, xtol=1e-5, ftol=1e-5) for start in starts[:2]), key=lambda one: one.cost)
    return of(best.x) if cost(np.zeros(3)) - 2.0 * best.cost > WORTH else camera


def _shape(camera: Camera, points: Complexes) -> tuple[float, complex, Floats]:
    """Radius of the circle through points of the picture, amplitude of its oval, and the distances of the points from that."""
    planar = flat(camera, points)
    circle, off = fit_circle(planar)
    twice = np.exp(2j * np.angle(planar - circle.centre))
    oval = 2.0 * (off * twice.conj()).mean()
    return circle.radius, complex(oval), off - (oval * twice).real
