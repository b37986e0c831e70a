"""What can be fitted, and what cannot."""

from __future__ import annotations

from typing import NamedTuple


class Kind(NamedTuple):
    """A parameter that can be fitted."""

    unit: str
    meaning: str
    low: float
    high: float
    step: float  # of a numerical derivative


INFINITE = float("inf")
PARAMETERS: dict[str, Kind] = {
    "gamma": Kind("1", "share of the mass in the load", 0.01, 0.99, 1e-5),
    "eccentricity": Kind("1", "distance of the centre of gravity from the centre over the radius", 0.001, 0.999, 1e-5),
    "inertia_ratio": Kind("1", "moment of inertia over m R²", 0.001, 2.0, 1e-5),
    "mu_kinetic": Kind("1", "kinetic friction", 0.0, 3.0, 1e-5),
    "mu_excess": Kind("1", "static less kinetic friction", 0.0, 2.0, 1e-5),
    "restitution": Kind("1", "restitution", 0.0, 0.9, 1e-5),
    "slope": Kind("rad", "slope of the plane", -1.0, 1.0, 1e-6),
    "rolling_resistance": Kind("1", "couple against the rotation over the radius and the normal force", 0.0, 0.5, 1e-6),
    "x0": Kind("m", "place of the centre in the first frame", -INFINITE, INFINITE, 1e-6),
    "angle0": Kind("rad", "angle in the first frame", -INFINITE, INFINITE, 1e-6),
    "speed": Kind("m/s", "speed of the centre in the first frame, rolling", -INFINITE, INFINITE, 1e-6),
    "height0": Kind("m", "height of the rim above the plane in the first frame", 0.0, INFINITE, 1e-6),
    "vx0": Kind("m/s", "velocity of the centre along the plane in the first frame", -INFINITE, INFINITE, 1e-6),
    "vy0": Kind("m/s", "velocity of the centre away from the plane in the first frame", -INFINITE, INFINITE, 1e-6),
    "omega0": Kind("rad/s", "angular velocity in the first frame", -INFINITE, INFINITE, 1e-6),
    "scale": Kind("1", "length in the data over length", 0.5, 2.0, 1e-6),
    "tilt": Kind("rad", "angle by which the plane rises along x of the data", -1.0, 1.0, 1e-6),
    "origin_y": Kind("m", "height of the plane in the data at x = 0", -INFINITE, INFINITE, 1e-6),
    "row_delay": Kind("s", "from the exposure of a row to that of the next", -1e-3, 1e-3, 1e-8),
    "marker_angle": Kind("rad", "angle from the load to the marker", -INFINITE, INFINITE, 1e-6),
    "marker_ratio": Kind("1", "distance of the marker from the centre over the radius", 0.01, 1.5, 1e-6),
}  # fmt: skip
# Numbers of the scenario that change with a parameter, one by one.
PATHS: dict[str, tuple[str, ...]] = {
    "gamma": ("hoop.load_fraction",),
    "eccentricity": ("hoop.eccentricity",),
    "inertia_ratio": ("hoop.inertia_ratio",),
    "mu_kinetic": ("plane.mu_static", "plane.mu_kinetic"),
    "mu_excess": ("plane.mu_static",),
    "restitution": ("plane.restitution",),
    "slope": ("plane.slope",),
    "rolling_resistance": ("plane.rolling_resistance",),
    "x0": ("start.x",),
    "angle0": ("start.angle",),
    "speed": ("start.speed",),
    "height0": ("start.height",),
    "vx0": ("start.vx",),
    "vy0": ("start.vy",),
    "omega0": ("start.omega",),
}
# How the first frame may be: which parameters say it.
STARTS = {
    "rolling": ("x0", "angle0", "speed"),
    "sliding": ("x0", "angle0", "vx0", "omega0"),
    "flying": ("x0", "height0", "angle0", "vx0", "vy0", "omega0"),
}
# Said in place of a parameter that cannot be one.
REFUSED = {
    "t0": "the time of the start says the same as its place, angle and speed together, so the start is the first frame",
    "radius": "the radius gives the scale of the film and is measured; scale can be fitted",
    "mass": "no film can tell the mass: the motion does not depend on it",
    "mu_static": "static friction is mu_kinetic + mu_excess; fix or free those",
    "gravity": "gravity is given, not fitted; scale can be",
}
