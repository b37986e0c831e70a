"""Parameters of a fit."""

from __future__ import annotations

from typing import NamedTuple


class ParameterSpec(NamedTuple):
    """A parameter that can be fitted."""

    unit: str
    meaning: str
    low: float
    high: float
    step: float  # of a numerical derivative


INFINITE = float("inf")
PARAMETERS: dict[str, ParameterSpec] = {
    "gamma": ParameterSpec("1", "share of the mass in the load", 0.01, 0.99, 1e-5),
    "eccentricity": ParameterSpec("1", "distance of the centre of gravity from the centre over the radius", 0.001, 0.999, 1e-5),
    "inertia_ratio": ParameterSpec("1", "moment of inertia over m R²", 0.001, 2.0, 1e-5),
    "mu_kinetic": ParameterSpec("1", "kinetic friction", 0.0, 3.0, 1e-5),
    "mu_excess": ParameterSpec("1", "static minus kinetic friction", 0.0, 2.0, 1e-5),
    "restitution": ParameterSpec("1", "restitution", 0.0, 0.9, 1e-5),
    "slope": ParameterSpec("rad", "slope of the plane", -1.0, 1.0, 1e-6),
    "rolling_resistance": ParameterSpec("1", "couple against rotation over the radius and the normal force", 0.0, 0.5, 1e-6),
    "x0": ParameterSpec("m", "position of the centre in the first frame", -INFINITE, INFINITE, 1e-6),
    "angle0": ParameterSpec("rad", "angle in the first frame", -INFINITE, INFINITE, 1e-6),
    "speed": ParameterSpec("m/s", "speed of the centre in the first frame, rolling", -INFINITE, INFINITE, 1e-6),
    "height0": ParameterSpec("m", "height of the rim above the plane in the first frame", 0.0, INFINITE, 1e-6),
    "vx0": ParameterSpec("m/s", "velocity of the centre along the plane in the first frame", -INFINITE, INFINITE, 1e-6),
    "vy0": ParameterSpec("m/s", "velocity of the centre away from the plane in the first frame", -INFINITE, INFINITE, 1e-6),
    "omega0": ParameterSpec("rad/s", "angular velocity in the first frame", -INFINITE, INFINITE, 1e-6),
    "scale": ParameterSpec("1", "length in the data over length", 0.5, 2.0, 1e-6),
    "stretch": ParameterSpec("1/m", "relative change of the scale along the plane", -0.1, 0.1, 1e-6),
    "tilt": ParameterSpec("rad", "angle by which the plane rises along x of the data", -1.0, 1.0, 1e-6),
    "origin_y": ParameterSpec("m", "height of the plane in the data at x = 0", -INFINITE, INFINITE, 1e-6),
    "row_delay": ParameterSpec("s", "delay of the exposure from row to row, beyond the track's", -1e-3, 1e-3, 1e-8),
    "marker_angle": ParameterSpec("rad", "angle from the load to the marker", -INFINITE, INFINITE, 1e-6),
    "marker_ratio": ParameterSpec("1", "distance of the marker from the centre over the radius", 0.01, 1.5, 1e-6),
    "omega_offset": ParameterSpec("rad/s", "offset of the measured angular velocity", -INFINITE, INFINITE, 1e-6),
}  # fmt: skip
# Factors of the data of which a trial fits one: no parameters of a fit.
FACTORS = {
    "times": ParameterSpec("1", "true times over those of the data", 0.8, 1.25, 1e-6),
    "radius": ParameterSpec("1", "true radius over the given one", 0.8, 1.25, 1e-6),
}
# Parameters that several runs of a hoop have in common; each run has its own of the others.
SHARED = ("gamma", "eccentricity", "inertia_ratio", "mu_kinetic", "mu_excess", "restitution", "rolling_resistance")
# Numbers of the scenario that change with a parameter by the same amount.
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
TIMED = ("row_delay", *FACTORS)  # parameters that change the times at which the motion is seen
# Kinds of motion in the first frame, with their parameters.
STARTS = {
    "rolling": ("x0", "angle0", "speed"),
    "sliding": ("x0", "angle0", "vx0", "omega0"),
    "flying": ("x0", "height0", "angle0", "vx0", "vy0", "omega0"),
}
# Reasons why a name is no parameter.
REFUSED = {
    "t0": "the time of the start is redundant with its position, angle and speed, so the start is the first frame",
    "radius": "the radius gives the scale of the film and is measured; scale can be fitted",
    "mass": "a film does not determine the mass: the motion does not depend on it",
    "mu_static": "static friction is mu_kinetic + mu_excess; fix or free those",
    "gravity": "gravity is given, not fitted; scale can be",
}


STATIC = ParameterSpec("1", "static friction, the sum of the two", 0.0, 5.0, 1e-5)


def spec(name: str) -> ParameterSpec:
    """Return the parameter of a name, which may have the number of its run, such as speed_2; or mu_static."""
    base, _, number = name.rpartition("_")
    return STATIC if name == "mu_static" else (PARAMETERS | FACTORS)[base if number.isdigit() else name]


def parts_of(name: str) -> tuple[str, ...]:
    """Return the parameters whose sum a name is: two for mu_static, otherwise itself."""
    return ("mu_kinetic", "mu_excess") if name == "mu_static" else (name,)
