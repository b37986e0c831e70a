"""Margins of a mode in a state: the forces, their limit, and the acceleration of the rim without contact."""

from __future__ import annotations

import math

from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.physics.contact import free_acceleration, rolling_forces, slip_motion, slip_stiffness
from hophoop.kernel.physics.modes import slip_direction
from hophoop.kernel.physics.resistance import resistance_arm

# In kernel units; documented in `hophoop.simulation.phases.Margins`.
MARGINS = ("normal_force", "friction_force", "friction_limit", "free_acceleration", "slip", "height", "p_sigma")


def margins_of(body, mode, theta, theta_low, omega, slip, height):
    """Return the margins in the order of `MARGINS`; nan if the mode has none."""
    s, c = sine_cosine(theta, theta_low)
    u = omega * omega
    normal = math.nan
    friction = math.nan
    p_sigma = math.nan
    mu = body.mu_s
    sigma = slip_direction(mode)
    if mode == Mode.ROLL:
        friction, normal = rolling_forces(body, s, c, u, resistance_arm(body, s, c, omega, 0))
    elif sigma != 0 and body.kap > 0.0 and math.isfinite(body.mu_k):
        rho = resistance_arm(body, s, c, omega, sigma)
        normal = slip_motion(body, s, c, u, sigma, rho)[1]
        friction = -sigma * body.mu_k * normal
        p_sigma = slip_stiffness(body, s, c, sigma, rho) / body.kap
        mu = body.mu_k
    elif mode in (Mode.FLIGHT, Mode.SKIM):
        friction = 0.0
        normal = 0.0
    limit = 0.0
    if normal != 0.0:
        limit = math.inf if math.isinf(mu) and normal > 0.0 else mu * normal
    return normal, friction, limit, free_acceleration(body, s, c, u)[1], slip, height, p_sigma
