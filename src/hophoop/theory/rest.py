"""Equilibria of a hoop on a plane, and how it rocks about them."""

from __future__ import annotations

import math
from dataclasses import dataclass

from hophoop.kernel.model import rolling_inertia
from hophoop.kernel.numerics.elementwise import arcsine, cosine, sine, tangent
from hophoop.kernel.steps import equilibrium_is_stable
from hophoop.scenario import Hoop, InputError, Plane, time_unit, to_body
from hophoop.theory.kernels.arcs import TURN, first_maximum, first_valley


@dataclass(frozen=True)
class Equilibrium:
    """An angle at which a hoop can rest.

    Attributes
    ----------
    angle : float
        θ from 0 to 2π [rad].
    stable : bool
        Whether the potential energy of rolling is smallest there.
    holds : bool
        Whether static friction is enough, abs(tan β) ≤ μs.
    period : float
        Of small rocking about a stable equilibrium; nan for an unstable one [s].
    """

    angle: float
    stable: bool
    holds: bool
    period: float


def equilibria(hoop: Hoop, plane: Plane = Plane()) -> tuple[Equilibrium, ...]:
    r"""The angles at which a hoop can rest on a plane, and whether friction holds it there.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane

    Returns
    -------
    equilibria : tuple of Equilibrium
        The unstable one (load up) and the stable one (load down); empty where the slope is too steep for the
        eccentricity, and for ε = 0 or g = 0, where any angle or none is one.

    Raises
    ------
    ValueError
        If the massless hoop is put on a slope, or the plane has rolling resistance: see `rest_ranges`.

    Notes
    -----
    :math:`\varepsilon \sin(\theta + \beta) = -\sin\beta`: the centre of gravity is above the contact.

    Examples
    --------
    >>> import hophoop as hh
    >>> for rest in hh.theory.equilibria(hh.Hoop.ideal(0.75), hh.Plane(slope=0.3)):
    ...     print(round(rest.angle, 6), rest.stable, rest.holds)
    5.578176 False True
    3.246602 True True
    """
    if plane.rolling_resistance > 0.0:
        given = plane.rolling_resistance
        raise InputError.of_field(
            "plane.rolling_resistance", given, "0 here: with it a hoop rests in the ranges of `rest_ranges`"
        )
    body = to_body(hoop, plane)
    second = time_unit(hoop, plane)
    found = []
    for angle in (float(first_maximum(body)), float(first_valley(body))):
        if math.isnan(angle):
            continue
        stable = bool(equilibrium_is_stable(body, angle))
        period = math.nan
        if stable:
            stiffness = body.eps * (body.gt * sine(angle) - body.gn * cosine(angle))
            period = TURN * math.sqrt(rolling_inertia(body, cosine(angle)) / stiffness) * second
        holds = abs(tangent(plane.slope)) <= plane.mu_static
        found.append(Equilibrium(angle % TURN, stable, holds, period))
    return tuple(found)


@dataclass(frozen=True)
class RestRange:
    """Angles at which rolling resistance holds a hoop.

    Attributes
    ----------
    low, high : float
        θ between which it rests, low from 0 to 2π and high from there to a whole turn on [rad].
    holds : bool
        Whether static friction is enough, abs(tan β) ≤ μs.
    """

    low: float
    high: float
    holds: bool


def rest_ranges(hoop: Hoop, plane: Plane) -> tuple[RestRange, ...]:
    r"""The angles at which a hoop can rest on a plane with rolling resistance.

    Parameters
    ----------
    hoop : Hoop
    plane : Plane

    Returns
    -------
    ranges : tuple of RestRange
        One about each equilibrium, one about both where they meet, and of a whole turn where the hoop rests at any angle;
        empty where it rests at none.

    Raises
    ------
    ValueError
        If gravity is 0, so that nothing presses the hoop on the plane.

    Notes
    -----
    :math:`\lvert\varepsilon\sin(\theta + \beta) + \sin\beta\rvert \le f\cos\beta`: the centre of gravity is above the
    range in which the pressure of the contact can be.

    Examples
    --------
    >>> import hophoop as hh
    >>> for rest in hh.theory.rest_ranges(hh.Hoop.ideal(0.75), hh.Plane(rolling_resistance=0.3)):
    ...     print(round(rest.low, 5), round(rest.high, 5))
    2.73008 3.55311
    5.87167 6.6947
    """
    if plane.gravity == 0.0:
        raise InputError("plane.gravity = 0 must be above 0: nothing presses the hoop on the plane.")
    reach, push = plane.rolling_resistance * cosine(plane.slope), sine(plane.slope)
    holds = abs(tangent(plane.slope)) <= plane.mu_static
    eps = hoop.eccentricity
    least, most = -push - reach, reach - push  # of ε sin(θ + β)
    if least > eps or most < -eps:
        return ()
    low, high = max(least, -eps), min(most, eps)
    if low <= -eps and high >= eps:
        return (RestRange(0.0, TURN, holds),)
    first, last = arcsine(low / eps), arcsine(high / eps)
    if high >= eps:  # the range goes on through the side of the load
        pairs = [(first, math.pi - first)]
    elif low <= -eps:
        pairs = [(math.pi - last, TURN + last)]
    else:
        pairs = [(first, last), (math.pi - last, math.pi - first)]
    found = []
    for begin, end in pairs:
        start = (begin - plane.slope) % TURN
        found.append(RestRange(start, start + (end - begin), holds))
    return tuple(sorted(found, key=lambda rest: rest.low))
