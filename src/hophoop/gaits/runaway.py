"""Whether fast motion down a slope grows, and the slope from which the hoop runs away.

Fast motion has no scale of its own. If all velocities are c times as large, a contact lasts 1/c times as long and gravity
changes nothing in it; a flight lasts c times as long and ends many revolutions later, at an angle that is as good as random. So
only the ratios of the velocities matter, and one passage is: a flight, in which the centre of gravity gains 2 ẏ tan β along the
plane and returns with −ẏ; then a contact without gravity, from a random angle. The mean of the logarithm by which the speed
grows decides: where it is negative, fast motion slows down again.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from hophoop.scenario import Hoop, InputError, Plane, Scenario, Start
from hophoop.simulation.simulate import simulate

FIRST = (1.0, 0.3, 1.0)  # any velocities; those of the first flights are not counted
FALL = 3.5  # height of the centre of gravity from which a fall is followed [R]; above 2, where the rim reaches the plane
BATCHES = 50
MOST_WAIT = 1e7  # of a hoop that hardly leaves the plane, in units of R over its speed
SEARCH = 2_000  # flights of each slope of the search
SLOPES, SPREAD = 8, 0.03  # number of slopes around the critical one, and how far they extend, relative to it


class Growth(NamedTuple):
    """Growth of fast motion from flight to flight.

    Attributes
    ----------
    rate : float
        Mean of the logarithm of speed over speed, a flight [1].
    error : float
        Its standard error, from the means of fifty batches [1].
    flights : int
    """

    rate: float
    error: float
    flights: int


class Runaway(NamedTuple):
    """The slope from which fast motion grows.

    Attributes
    ----------
    slope, error : float
        With its standard error [rad].
    steepness : float
        Growth of the rate with the slope [1/rad].
    chi_square : float
        Of a parabola through the rates of eight slopes, with five degrees of freedom; the error is enlarged where it exceeds
        five [1].
    flights : int
        In all.
    """

    slope: float
    error: float
    steepness: float
    chi_square: float
    flights: int


def growth(hoop: Hoop, plane: Plane, flights: int = 20_000, *, seed: int = 1) -> Growth:
    """Growth of fast motion down the slope of a plane.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane
        Gravity does not matter.
    flights : int, default 20000
        From 1000 on.
    seed : int, default 1
        Of the angles at which the hoop lands.

    Returns
    -------
    growth : Growth

    Raises
    ------
    ValueError
        If the hoop has no mass in its rim, there is no friction or no limit to it, a number is out of range, or a contact
        without gravity has no answer.

    Examples
    --------
    >>> import hophoop as hh
    >>> fast = hh.gaits.growth(hh.Hoop.ideal(0.75), hh.Plane(slope=0.9), 2000)
    >>> fast.rate > 10 * fast.error
    True
    """
    _check(hoop, plane, flights, 1000)
    logarithms = _logarithms(hoop, plane, flights, seed)
    means = logarithms[: len(logarithms) // BATCHES * BATCHES].reshape(BATCHES, -1).mean(axis=1)
    return Growth(float(logarithms.mean()), float(means.std(ddof=1) / math.sqrt(BATCHES)), flights)


def runaway(
    hoop: Hoop, plane: Plane, flights: int = 100_000, *, seed: int = 1, progress: Callable[[float], object] | None = None
) -> Runaway:
    """Slope from which fast motion grows; below it, it slows down again.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane
        Its slope and gravity do not matter.
    flights : int, default 100000
        In eight slopes around the critical one, from 8000 on; a ten-thousandth of a second each.
    seed : int, default 1
    progress : callable, optional
        Called with the fraction that is done.

    Returns
    -------
    runaway : Runaway

    Raises
    ------
    ValueError
        As `growth`, and if no slope below 90° separates growth from decay.

    Examples
    --------
    >>> import math
    >>> import hophoop as hh
    >>> found = hh.gaits.runaway(hh.Hoop.ideal(0.25), hh.Plane(), 8000)
    >>> abs(math.degrees(found.slope) - 11.2) < 0.3
    True
    """
    _check(hoop, plane, flights, 1000 * SLOPES)
    middle = _crossing(hoop, plane, seed)
    slopes = middle * (1.0 + SPREAD * np.linspace(-1.0, 1.0, SLOPES))
    found = []
    for k, slope in enumerate(slopes):
        found.append(growth(hoop, _changed(plane, slope=slope), flights // SLOPES, seed=seed + 1 + k))
        if progress is not None:
            progress((k + 1) / SLOPES)
    rates, errors = (np.array([getattr(one, name) for one in found]) for name in ("rate", "error"))
    away = slopes - middle
    parabola, covariance = np.polyfit(away, rates, 2, w=1.0 / errors, cov="unscaled")
    chi_square = float(np.sum(((rates - np.polyval(parabola, away)) / errors) ** 2))
    root = min(np.roots(parabola), key=abs)
    if root.imag != 0.0 or abs(root) > 2.0 * SPREAD * middle:
        raise ValueError(f"The slope is not found with {flights} flights; more may find it.")
    root = float(root.real)
    steepness = float(np.polyval(np.polyder(parabola), root))
    powers = np.array([root * root, root, 1.0])
    error = math.sqrt(powers @ covariance @ powers * max(1.0, chi_square / (SLOPES - 3))) / abs(steepness)
    return Runaway(middle + root, error, steepness, chi_square, sum(one.flights for one in found))


def passage(hoop: Hoop, plane: Plane, velocities: tuple[float, float, float], angle: float) -> tuple[float, float, float]:
    """Velocities with which the hoop leaves the plane next.

    Parameters
    ----------
    hoop : Hoop
        Of radius 1.
    plane : Plane
        Without gravity.
    velocities : tuple of 3 floats
        Of the centre of gravity along the plane and away from it, and angular velocity, at a take-off [1].
    angle : float
        At which the centre of gravity falls past the height of 3.5 radii [rad].

    Returns
    -------
    velocities : tuple of 3 floats

    Raises
    ------
    ValueError
        If the contact has no answer, or the hoop does not leave the plane.
    """
    eps = hoop.eccentricity
    along, away, omega = velocities
    along, away = along + 2.0 * away * math.tan(plane.slope), -away
    height = min(FALL, 1.0 + eps + abs(away))  # the rim reaches the plane below 1 + ε
    if height < FALL:
        angle = math.remainder(angle + omega * (FALL - height) / abs(away), 2.0 * math.pi)
    start = Start(
        height=height - eps * math.cos(angle) - 1.0,
        angle=angle,
        vx=along - eps * omega * math.cos(angle),
        vy=away + eps * omega * math.sin(angle),
        omega=omega,
    )
    duration = 50.0
    while duration < MOST_WAIT:
        motion = simulate(Scenario(hoop=hoop, plane=plane, start=start, duration=duration))
        if motion.status != "completed":
            raise ValueError(f"Fast motion on this plane ends with {motion.status}, so it has no growth.")
        end = motion.events[-1]
        away = end.vy - eps * end.omega * math.sin(end.angle)
        if away > 0.0 and end.height + eps * math.cos(end.angle) > eps:  # nothing brings it back but gravity
            return end.vx + eps * end.omega * math.cos(end.angle), away, end.omega
        duration *= 10.0
    raise ValueError("Fast motion on this plane does not leave it again, so it has no growth.")


def _logarithms(hoop: Hoop, plane: Plane, flights: int, seed: int) -> np.ndarray:
    """Logarithms of speed over speed of all flights but the first ones."""
    hoop = Hoop(radius=1.0, mass=1.0, eccentricity=hoop.eccentricity, inertia_ratio=hoop.inertia_ratio)
    plane = _changed(plane, gravity=0.0)
    velocities, settling = FIRST, flights // 50
    angles = np.random.default_rng(seed).uniform(0.0, 2.0 * math.pi, flights + settling)
    logarithms = np.empty(len(angles))
    for k, angle in enumerate(angles):
        found = passage(hoop, plane, velocities, float(angle))
        ratio = _speed(hoop, found) / _speed(hoop, velocities)
        logarithms[k] = math.log(ratio)
        along, away, omega = (one / _speed(hoop, found) for one in found)
        velocities = along, away, omega
    return logarithms[settling:]


def _speed(hoop: Hoop, velocities: tuple[float, float, float]) -> float:
    """Root of twice the kinetic energy [1]."""
    along, away, omega = velocities
    return math.sqrt(along * along + away * away + hoop.inertia_ratio * omega * omega)


def _changed(plane: Plane, **values: float) -> Plane:
    return Plane.model_validate({**plane.model_dump(exclude={"mu"}), **values})


def _crossing(hoop: Hoop, plane: Plane, seed: int) -> float:
    """A slope near the critical one, by bisection between slopes whose rates differ from 0 by twice their errors."""
    low, high, middle = 0.0, 0.5 * math.pi, 0.25 * math.pi * hoop.eccentricity
    for _ in range(12):
        rate, error, _ = growth(hoop, _changed(plane, slope=middle), SEARCH, seed=seed)
        if abs(rate) < 2.0 * error:
            break
        low, high = (low, middle) if rate > 0.0 else (middle, high)
        middle = 0.5 * (low + high)
    else:
        if low == 0.0 or high == 0.5 * math.pi:
            raise ValueError("No slope below 90° separates growth from decay.")
    return middle


def _check(hoop: Hoop, plane: Plane, flights: int, least: int) -> None:
    if hoop.massless:
        raise InputError.of_field("hoop.inertia_ratio", 0.0, "above 0: a hoop without mass in its rim has no flights")
    if not 0.0 < plane.mu_kinetic <= plane.mu_static < math.inf:
        raise InputError.of_field(
            "plane.mu_kinetic", plane.mu_kinetic, "above 0 and finite: else nothing limits or drives the hoop"
        )
    if not (isinstance(flights, int) and flights >= least):
        raise InputError.of_field("flights", flights, f"an integer from {least} on")
