"""Rates of the kernel's body, start and units with a parameter of a scenario, given by its path."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from hophoop.derivatives.layout import STATE_ROWS
from hophoop.derivatives.units import DIRECT
from hophoop.kernel.numerics.circular import sine_and_cosine
from hophoop.kernel.records import CELL
from hophoop.scenario import InputError, Scenario, cell_of, time_unit
from hophoop.scenario.paths import parameter
from hophoop.vocabulary.parameters import PARAMETERS, RANGES, TABLE, Range

Floats = NDArray[np.float64]
Change = dict[str, float]  # rates of change with one parameter, by name in CELL; those that are left out are 0


@dataclass(frozen=True)
class Directions:
    """The directions of some parameters, in kernel units.

    Attributes
    ----------
    parameter_tangents : ndarray, shape (PARAMETERS, n)
        Of the body and the duration.
    start : ndarray, shape (STATE_ROWS, n)
        Of the start.
    units : ndarray, shape (3, n)
        Logarithmic rates of the units of length, time and mass.
    """

    parameter_tangents: Floats
    start: Floats
    units: Floats


def _of_part(scenario: Scenario, path: str) -> Change:
    """A number of one part: mass, ε and κ follow by the parallel axis theorem."""
    hoop = scenario.hoop
    _, _, place, name = path.split(".")
    parts = hoop.parts
    if parts is None or int(place) >= len(parts):
        raise InputError(f"{path} is not a number of this hoop: it has {len(parts or ())} parts.")
    part = parts[int(place)]
    value = getattr(part, name)
    # mass, place and inertia are polynomials of degree two at most, of which a central difference is the derivative
    step = 0.5 * abs(value) if value != 0.0 else 1.0
    # not validated, since the steps are large
    numbers = part.to_dict()
    more, less = (type(part).model_construct(**numbers | {name: value + sign * step}) for sign in (1.0, -1.0))
    dmass, dat, dinertia = (
        (getattr(more, each) - getattr(less, each)) / (2.0 * step) if hasattr(part, each) else 0.0
        for each in ("mass", "at", "inertia")
    )
    radius, mass = hoop.radius, hoop.mass
    centre = math.fsum(each.mass * each.at / radius for each in parts) / mass
    away = part.at / radius - centre
    dcentre = (dmass * away + part.mass * dat / radius) / mass
    # the parts' first moment about G is zero, so that a change of G adds nothing
    dmoment = dinertia / (radius * radius) + dmass * (away * away) + 2.0 * part.mass * away * dat / radius
    dinertia_ratio = (dmoment - dmass * hoop.inertia_ratio) / mass
    return {"mass": dmass, "eccentricity": math.copysign(1.0, centre) * dcentre, "inertia_ratio": dinertia_ratio}


def _of_radius(scenario: Scenario) -> Change:
    hoop, start = scenario.hoop, scenario.start
    change = {"radius": 1.0}
    if start.speed is not None:
        change["omega"] = -start.speed / (hoop.radius * hoop.radius)
    else:
        change["slip"] = -(start.omega or 0.0)
    if hoop.parts is not None:
        change["eccentricity"] = -hoop.eccentricity / hoop.radius
        change["inertia_ratio"] = -2.0 * hoop.inertia_ratio / hoop.radius
    return change


def _of_mass(scenario: Scenario) -> Change:
    if scenario.hoop.parts is not None:
        raise InputError("hoop.mass follows from hoop.parts; a derivative is with respect to hoop.parts.0.mass and so on.")
    return {"mass": 1.0}


def _of_load(scenario: Scenario) -> Change:
    gamma = scenario.hoop.load_fraction
    if gamma is None:
        raise InputError("hoop.load_fraction is not what this hoop is given by; take hoop.eccentricity and hoop.inertia_ratio.")
    return {"eccentricity": 1.0, "inertia_ratio": -2.0 * gamma}


def _of_speed(scenario: Scenario) -> Change:
    if scenario.start.speed is None:
        raise InputError("start.speed is not what this start is given by; take start.vx and start.omega.")
    return {"omega": 1.0 / scenario.hoop.radius}


def _of_friction(path: str, scenario: Scenario) -> Change:
    both = path == "plane.mu"
    if both and scenario.plane.mu is None:
        raise InputError("plane.mu is not what this plane is given by; take plane.mu_static and plane.mu_kinetic.")
    name = path.removeprefix("plane.")
    if math.isinf(getattr(scenario.plane, name)):
        raise InputError(f"{path} = inf has no derivative.")
    return {"mu_static": float(both or name == "mu_static"), "mu_kinetic": float(both or name == "mu_kinetic")}


def _of_resistance(scenario: Scenario) -> Change:
    if scenario.hoop.inertia_ratio == 0.0:
        raise InputError("plane.rolling_resistance has no derivatives for the massless hoop, which can have none of it.")
    return {"rolling_resistance": 1.0}


# Where more than the parameter's own column of the cell changes, or something is to be refused first.
_SPECIAL: Mapping[str, Callable[[Scenario], Change]] = {
    "hoop.radius": _of_radius,
    "hoop.mass": _of_mass,
    "hoop.load_fraction": _of_load,
    "plane.mu": partial(_of_friction, "plane.mu"),
    "plane.mu_static": partial(_of_friction, "plane.mu_static"),
    "plane.mu_kinetic": partial(_of_friction, "plane.mu_kinetic"),
    "plane.rolling_resistance": _of_resistance,
    "start.speed": _of_speed,
    "start.vx": lambda _: {"slip": 1.0},
    "start.omega": lambda scenario: {"omega": 1.0, "slip": -scenario.hoop.radius},
}
PATHS = tuple(row.path for row in TABLE if row.derivative)


def change_of(scenario: Scenario, path: str) -> Change:
    """Return the rates of change with one parameter.

    Parameters
    ----------
    scenario : Scenario
    path : str
        Such as ``"plane.mu"`` or ``"hoop.parts.0.mass"``.

    Returns
    -------
    change : dict of float
        Rates in SI units, by name in `CELL`; those that are left out are 0.

    Raises
    ------
    ValueError
        If the path is no number that the motion depends on, or not what the scenario is given by.
    """
    if path in _SPECIAL:
        return _SPECIAL[path](scenario)
    if path in PATHS:
        return {PARAMETERS[path].column: 1.0}
    known = parameter(path)
    if path.startswith("hoop.parts.") and known.unit != "":
        return _of_part(scenario, path)
    raise InputError(
        f"wrt = {path!r} is not a number that the motion depends on; there are {', '.join(PATHS)}.", field="wrt", value=path
    )


def value_of(scenario: Scenario, path: str) -> float:
    """The value of a parameter.

    Parameters
    ----------
    scenario : Scenario
    path : str
        As `change_of` takes it.

    Returns
    -------
    value : float
        In its SI unit [the parameter's].
    """
    if path == "start.omega":
        return scenario.start.state(scenario.hoop).omega
    node: object = scenario
    for step in path.split("."):
        node = node[int(step)] if isinstance(node, tuple) else getattr(node, step)
    return float(node)  # type: ignore[arg-type]


# Of the massless hoop: it has its load at the rim, and rolls on a level plane only.
_FIXED = ("hoop.eccentricity", "plane.slope")
_ANY = Range(-math.inf, math.inf)


def allowed_sides(scenario: Scenario, path: str, value: float) -> tuple[bool, bool]:
    """Return whether a parameter may be smaller, and whether it may be larger, than it is.

    Parameters
    ----------
    scenario : Scenario
    path : str
    value : float
        Of the parameter [its unit].

    Returns
    -------
    smaller, larger : bool
    """
    allowed = RANGES.get(path, _ANY)
    smaller = value > min((allowed.least, *allowed.also))
    larger = value < allowed.most
    hoop, plane = scenario.hoop, scenario.plane
    if hoop.massless and path in _FIXED:
        return False, False
    if plane.mu_static == plane.mu_kinetic:
        smaller = smaller and path != "plane.mu_static"
        larger = larger and path != "plane.mu_kinetic"
    return smaller, larger


def directions_of(scenario: Scenario, paths: Sequence[str]) -> Directions:
    """Return the directions of some parameters, in kernel units.

    Parameters
    ----------
    scenario : Scenario
    paths : sequence of str

    Returns
    -------
    directions : Directions

    Raises
    ------
    ValueError
        As `change_of`.
    """
    given = dict(zip(CELL, cell_of(scenario), strict=True))
    changes = [change_of(scenario, path) for path in paths]
    by = {name: np.array([change.get(name, 0.0) for change in changes]) for name in CELL}
    length, second = scenario.hoop.radius, time_unit(scenario.hoop, scenario.plane)
    sine, cosine = sine_and_cosine(scenario.plane.slope)
    by_length = by["radius"] / length
    by_time = 0.5 * by_length
    if scenario.plane.gravity > 0.0:
        by_time -= 0.5 * by["gravity"] / scenario.plane.gravity
        normal, tangential = -sine * by["slope"], cosine * by["slope"]
    else:
        normal, tangential = cosine * by["gravity"], sine * by["gravity"]
    by_duration = (by["duration"] - given["duration"] * by_time) / second
    parameter_tangents = [
        by["eccentricity"], by["inertia_ratio"], by["mu_static"], by["mu_kinetic"], normal, tangential,
        by["restitution"], by_duration, by["rolling_resistance"],
    ]  # fmt: skip
    start = np.zeros((STATE_ROWS, len(paths)))
    for name in ("x", "height", "angle", "omega", "slip", "vy"):
        _, row, (lengths, times, _) = DIRECT[name]
        by_unit = lengths * by_length + times * by_time
        # their units hold a length once, and are per second once, at most
        start[row] = (by[name] - given[name] * by_unit) * (second if times else 1.0) / (length if lengths else 1.0)
    return Directions(np.array(parameter_tangents), start, np.array([by_length, by_time, by["mass"] / scenario.hoop.mass]))
