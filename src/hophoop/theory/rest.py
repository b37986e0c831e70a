"""Equilibria of a hoop on a plane, and how it rocks about them."""

from __future__ import annotations

import math
from dataclasses import dataclass

from hophoop.physics.contact import rolling_inertia
from hophoop.rigid.contact_phase import equilibrium_is_stable
from hophoop.scenario import Hoop, Plane, time_unit, to_body
from hophoop.theory.kernels.arcs import TURN, first_hilltop, first_valley


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
        If the massless hoop is put on a slope.

    Notes
    -----
    :math:`\varepsilon \sin(\theta + \beta) = -\sin\beta`: the centre of gravity stands above the contact.

    Examples
    --------
    >>> import hophoop as hh
    >>> for rest in hh.theory.equilibria(hh.Hoop.ideal(0.75), hh.Plane(slope=0.3)):
    ...     print(round(rest.angle, 6), rest.stable, rest.holds)
    5.578176 False True
    3.246602 True True
    """
    body = to_body(hoop, plane)
    second = time_unit(hoop, plane)
    found = []
    for angle in (float(first_hilltop(body)), float(first_valley(body))):
        if math.isnan(angle):
            continue
        stable = bool(equilibrium_is_stable(body, angle))
        period = math.nan
        if stable:
            stiffness = body.eps * (body.gt * math.sin(angle) - body.gn * math.cos(angle))
            period = TURN * math.sqrt(rolling_inertia(body, math.cos(angle)) / stiffness) * second
        holds = abs(math.tan(plane.slope)) <= plane.mu_static
        found.append(Equilibrium(angle % TURN, stable, holds, period))
    return tuple(found)
