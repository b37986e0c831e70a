"""Parameters of a fit."""

from __future__ import annotations

from typing import NamedTuple


class ParameterSpec(NamedTuple):
    """A parameter that can be fitted."""

    meaning: str
    unit: str
    usual: float = 0.0  # where the data do not tell more
    low: float = float("-inf")
    high: float = float("inf")
    step: float = 1e-6  # of a numerical derivative
    paths: tuple[str, ...] = ()  # numbers of the scenario that change with it by the same amount


PARAMETERS: dict[str, ParameterSpec] = {
    "gamma": ParameterSpec("share of the mass in the load", "1", 0.5, 0.01, 0.99, 1e-5, ("hoop.load_fraction",)),
    "eccentricity": ParameterSpec(
        "distance of the centre of gravity from the centre over the radius",
        "1",
        0.5,
        0.001,
        0.999,
        1e-5,
        ("hoop.eccentricity",),
    ),
    "inertia_ratio": ParameterSpec("moment of inertia over m R²", "1", 0.75, 0.001, 2.0, 1e-5, ("hoop.inertia_ratio",)),
    "mu_kinetic": ParameterSpec("kinetic friction", "1", 0.5, 0.0, 3.0, 1e-5, ("plane.mu_static", "plane.mu_kinetic")),
    "mu_excess": ParameterSpec("static minus kinetic friction", "1", 0.05, 0.0, 2.0, 1e-5, ("plane.mu_static",)),
    "restitution": ParameterSpec("restitution", "1", 0.3, 0.0, 0.9, 1e-5, ("plane.restitution",)),
    "slope": ParameterSpec("slope of the plane", "rad", 0.0, -1.0, 1.0, paths=("plane.slope",)),
    "rolling_resistance": ParameterSpec(
        "couple against rotation over the radius and the normal force", "1", 0.0, 0.0, 0.5, paths=("plane.rolling_resistance",)
    ),
    "x0": ParameterSpec("position of the centre in the first frame", "m", paths=("start.x",)),
    "angle0": ParameterSpec("angle in the first frame", "rad", paths=("start.angle",)),
    "speed": ParameterSpec("speed of the centre in the first frame, rolling", "m/s", 1.0, paths=("start.speed",)),
    "height0": ParameterSpec("height of the rim above the plane in the first frame", "m", low=0.0, paths=("start.height",)),
    "vx0": ParameterSpec("velocity of the centre along the plane in the first frame", "m/s", 1.0, paths=("start.vx",)),
    "vy0": ParameterSpec("velocity of the centre away from the plane in the first frame", "m/s", paths=("start.vy",)),
    "omega0": ParameterSpec("angular velocity in the first frame", "rad/s", paths=("start.omega",)),
    "scale": ParameterSpec("length in the data over length", "1", 1.0, 0.5, 2.0),
    "stretch": ParameterSpec("relative change of the scale along the plane", "1/m", 0.0, -0.1, 0.1),
    "tilt": ParameterSpec("angle by which the plane rises along x of the data", "rad", 0.0, -1.0, 1.0),
    "origin_y": ParameterSpec("height of the plane in the data at x = 0", "m"),
    "row_delay": ParameterSpec("delay of the exposure from row to row, beyond the track's", "s", 0.0, -1e-3, 1e-3, 1e-8),
    "marker_angle": ParameterSpec("angle from the load to the marker", "rad"),
    "marker_ratio": ParameterSpec("distance of the marker from the centre over the radius", "1", 1.0, 0.01, 1.5),
    "omega_offset": ParameterSpec("offset of the measured angular velocity", "rad/s"),
    "times": ParameterSpec("true times over those of the data", "1", 1.0, 0.8, 1.25),
    "radius": ParameterSpec("true radius over the given one", "1", 1.0, 0.8, 1.25),
    "mu_static": ParameterSpec("static friction, the sum of the two", "1", 0.55, 0.0, 5.0, 1e-5),
}
# Parameters that several runs of a hoop have in common; each run has its own of the others.
SHARED = ("gamma", "eccentricity", "inertia_ratio", "mu_kinetic", "mu_excess", "restitution", "rolling_resistance")
FACTORS = ("times", "radius")  # of the data: a trial fits one
TIMED = ("row_delay", *FACTORS)  # parameters that change the times at which the motion is seen
# Kinds of unknown hoops, and of motion in the first frame, with their parameters.
HOOPS = {"ideal": ("gamma",), "general": ("eccentricity", "inertia_ratio")}
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


def split_number(name: str) -> tuple[str, int]:
    """Return the name of a parameter without the number of its run, as in speed_2, and this number; 0 without one."""
    base, _, number = name.rpartition("_")
    return (base, int(number)) if number.isdigit() else (name, 0)


def spec(name: str) -> ParameterSpec:
    """Return the parameter of a name, which may have the number of its run."""
    return PARAMETERS[split_number(name)[0]]


def parts_of(name: str) -> tuple[str, ...]:
    """Return the parameters whose sum a name is: two for mu_static, otherwise itself."""
    return ("mu_kinetic", "mu_excess") if name == "mu_static" else (name,)
