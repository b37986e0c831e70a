"""Law of the slow end of slip above the critical speed, from the forces of rolling alone.

Rolling with the energy Δ above that of the critical speed would require h = α Δ − β (θ − θ*)²/2 more friction than
available, near the angle θ* of contact with the cone. Slip starts where h = 0, at θ* − s with s² = 2 α Δ/β. There
v̇_t = K h, and with θ̇ = ω

    v_t = K β/(2 ω) · (s² φ − φ³/3 + 2 s³/3) = K β/(6 ω) · (φ + s)² (2 s − φ),   φ = θ − θ*

Slip ends at φ = 2 s. It dissipates (μ N/ω) ∫ v_t dφ = 9 μ N K β s⁴/(8 ω²). On level ground the cone is touched twice per
revolution, symmetrically about the bottom. So a revolution of period T dissipates c Δ² with c = 9 μ N K α²/(β ω²), and Δ t
tends to T/c.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from hophoop import theory
from hophoop.kernel.physics.contact import inertia_at_height, kappa_p_sigma, load_height
from hophoop.scenario import Hoop, Plane, to_body

HALF_WIDTH, DEGREE = 0.2, 24  # of the polynomial through h about θ*, accurate to rounding


class SlowEnd(NamedTuple):
    """The numbers of the law.

    Attributes
    ----------
    product : float
        Limit of Δ t [J s].
    period : float
        T [s].
    loss : float
        c: the loss per revolution is c Δ² [1/J].
    angle : float
        θ* [rad].
    """

    product: float
    period: float
    loss: float
    angle: float


def slow_end(hoop: Hoop, plane: Plane) -> SlowEnd:
    """Law of the slow end of slip on level ground.

    plane: level, with μs = μk low enough for slip at some speed.
    """
    critical = float(theory.first_slip_speed(hoop, plane))
    mu = plane.mu_kinetic
    guess = float(theory.slip_angle(hoop, critical * (1.0 + 1e-9), plane))
    # a polynomial through N and F at both speeds gives h, its maximum and its curvature there
    nodes = np.polynomial.chebyshev.chebpts1(DEGREE)
    angles = guess + HALF_WIDTH * nodes
    forces = theory.rolling_forces(angles, hoop, critical, plane)
    sigma = -math.copysign(1.0, float(theory.rolling_forces(guess, hoop, critical, plane).friction))
    over = -sigma * forces.friction - mu * forces.normal
    # the forces are linear in the energy, so any difference of energy gives the slope
    faster = theory.rolling_forces(angles, hoop, 2.0 * critical, plane)
    inertia = 1.0 + hoop.inertia_ratio + hoop.eccentricity**2 + 2.0 * hoop.eccentricity
    energy = 0.5 * hoop.mass * inertia * 3.0 * critical**2
    rise = (-sigma * faster.friction - mu * faster.normal - over) / energy
    curve = np.polynomial.Chebyshev.fit(nodes, over, DEGREE - 1, domain=[-1.0, 1.0])
    roots = curve.deriv().roots()
    place = float(min(roots[np.abs(roots.imag) < 1e-9].real, key=abs))
    angle = guess + HALF_WIDTH * place
    bend = -float(curve.deriv(2)(place)) / HALF_WIDTH**2
    slope = float(np.polynomial.Chebyshev.fit(nodes, rise, DEGREE - 1, domain=[-1.0, 1.0])(place))
    normal = float(theory.rolling_forces(angle, hoop, critical, plane).normal)
    omega = float(theory.rolling_speed(angle, hoop, critical, plane))
    sine, cosine = math.sin(angle), math.cos(angle)
    body = to_body(hoop, plane)
    # det W over p_σ: the slip acceleration per newton of missing friction
    gain = inertia_at_height(body, load_height(sine, cosine)) / kappa_p_sigma(body, sine, cosine, sigma, 0.0) / hoop.mass
    loss = 9.0 * mu * normal * gain * slope**2 / (bend * omega**2)
    period = float(theory.rolling_period(hoop, critical, plane))
    return SlowEnd(period / loss, period, loss, angle)
