"""From a scenario to the numbers of the kernel: units, defaults, a start with the spring loaded."""

from __future__ import annotations

import math

import numpy as np

from hophoop.compliant.records import OM, SIZE, TH, VN, VT, X, Y, Z
from hophoop.physics.body import Body
from hophoop.physics.compliant import (
    Compliance,
    FrictionLaw,
    NormalLaw,
    damping_ratio,
    hunt_crossley_number,
    static_excess,
)
from hophoop.physics.contact import free_acceleration
from hophoop.physics.resistance import forces_rolling, motion_slipping, stiffness_slipping
from hophoop.scenario import Compliant, Scenario
from hophoop.scenario.scenario import time_unit, to_body

STIFFNESS = 1e6  # m g / R
SLIP_SPEED, LEAST_SLIP_SPEED = 1e-3, 1e-9  # √(g R)
RTOL = 1e-9
ROUNDING = 1e-13  # of f_n, beside gravity and θ̇²


def to_compliance(scenario: Scenario) -> tuple[Body, Compliance, float, float]:
    """The numbers that the kernel takes.

    Parameters
    ----------
    scenario : Scenario
        Its contact is Compliant.

    Returns
    -------
    body : Body
    compliance : Compliance
        With every default filled in.
    duration : float
    rtol : float
        All in units of R, m and √(R/g).
    """
    contact, hoop, plane = scenario.contact, scenario.hoop, scenario.plane
    assert isinstance(contact, Compliant)
    second = time_unit(hoop, plane)
    body = to_body(hoop, plane)
    k = STIFFNESS if contact.stiffness is None else contact.stiffness * second**2 / hoop.mass
    law = NormalLaw[contact.law.upper().replace("-", "_")]
    friction = FrictionLaw[contact.friction.upper()]
    c = d = 0.0
    if contact.damping is not None:
        if law == NormalLaw.KELVIN_VOIGT:
            c = contact.damping * second / hoop.mass
        else:
            d = contact.damping * hoop.radius / second
    else:
        restitution = plane.restitution if contact.restitution is None else contact.restitution
        restitution = max(restitution, least_restitution(k))
        if law == NormalLaw.KELVIN_VOIGT:
            c = 2.0 * damping_ratio(restitution) * math.sqrt(k)
        else:
            d = hunt_crossley_number(restitution)
    usual = min(max(1.0 / k, LEAST_SLIP_SPEED), SLIP_SPEED)
    if contact.slip_speed is not None:
        v_s = contact.slip_speed * second / hoop.radius
    else:
        v_s = usual
        if friction == FrictionLaw.BRISTLE:  # it may relax as slowly as the hoop moves: c_t = μ k_t
            v_s = min(1.0 / k, 1.0)
    if body.mu_s == 0.0:  # nothing for a bristle to hold
        friction = FrictionLaw.LINEAR
    k_t = k if contact.tangential_stiffness is None else contact.tangential_stiffness * second**2 / hoop.mass
    compliance = Compliance(
        law=int(law),
        friction=int(friction),
        k=k,
        c=c,
        d=d,
        v_s=v_s,
        mu_s=body.mu_s,
        mu_k=body.mu_k,
        excess=static_excess(body.mu_s, body.mu_k) if friction == FrictionLaw.TANH else 0.0,
        k_t=k_t,
        c_t=body.mu_s / v_s,
        om_s=usual if friction == FrictionLaw.BRISTLE else v_s,
    )
    rtol = RTOL if contact.rtol is None else contact.rtol
    return body, compliance, scenario.duration / second, rtol


def least_restitution(k: float) -> float:
    """The restitution that stands for all smaller ones, which no finite damping gives.

    Parameters
    ----------
    k : float
        Stiffness over m g / R [1].

    Returns
    -------
    restitution : float
        1/√k, at most 0.1: it vanishes with the other errors of a compliant contact [1].
    """
    return min(0.1, 1.0 / math.sqrt(k))


def to_start(scenario: Scenario, body: Body, comp: Compliance) -> tuple[np.ndarray, bool]:
    """The start of the kernel, and whether the contact acts there.

    A start at rest on the plane (height 0, vy 0) has its spring compressed by the normal force that rigid
    contact would have, and its bristle stretched: otherwise every motion would begin with a drop.

    Parameters
    ----------
    scenario : Scenario
    body : Body
    comp : Compliance

    Returns
    -------
    start : ndarray, shape (SIZE,)
    touching : bool
    """
    hoop = scenario.hoop
    second = time_unit(hoop, scenario.plane)
    speed = hoop.radius / second
    given = scenario.start.state(hoop)
    start = np.zeros(SIZE)
    start[X] = given.x / hoop.radius
    start[Y] = given.height / hoop.radius
    start[TH] = given.angle
    start[VT] = given.slip / speed
    start[VN] = given.vy / speed
    start[OM] = given.omega * second
    if start[Y] > 0.0 or start[VN] != 0.0:
        return start, False
    friction, normal = _rigid_force(body, start)
    opening = free_acceleration(body, math.sin(start[TH]), math.cos(start[TH]), start[OM] * start[OM])[1]
    if not normal > 0.0:
        u = start[OM] * start[OM]
        if abs(opening) <= ROUNDING * (body.gn + u):  # zero: its rate decides
            opening = -body.eps * start[OM] * u * math.sin(start[TH])
        return start, opening < 0.0
    start[Y] = -normal / comp.k
    if start[VT] == 0.0:
        _load_friction(comp, start, friction)
    return start, True


def _rigid_force(body: Body, start: np.ndarray) -> tuple[float, float]:
    s, c, u = math.sin(start[TH]), math.cos(start[TH]), start[OM] ** 2
    sigma = int(np.sign(start[VT]))
    if sigma == 0:
        friction, normal = forces_rolling(body, s, c, start[OM])
        if normal > 0.0 and abs(friction) <= body.mu_s * normal:
            return friction, normal
        sigma = -int(np.sign(friction))
    opening = free_acceleration(body, s, c, u)[1]
    stiffness = stiffness_slipping(body, s, c, start[OM], sigma)
    if opening < 0.0 < stiffness:
        normal = motion_slipping(body, s, c, start[OM], sigma)[1]
        return -sigma * body.mu_k * normal, normal
    if opening > 0.0 > stiffness and body.strike:
        # Painlevé's indeterminate contact: beyond twice the unstable equilibrium the spring strikes
        return 0.0, 2.0 * motion_slipping(body, s, c, start[OM], sigma)[1]
    return 0.0, 0.0


def _load_friction(comp: Compliance, start: np.ndarray, friction: float) -> None:
    if comp.friction == FrictionLaw.BRISTLE:
        start[Z] = -friction / comp.k_t
