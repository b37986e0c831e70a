"""What decides whether a mode lasts, in a state: the forces, their limit, and what the rim would do without contact."""

from __future__ import annotations

import math

from hophoop.kernel.numerics.trigonometry import sine_cosine
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.physics.contact import free_acceleration
from hophoop.kernel.physics.modes import slip_direction
from hophoop.kernel.physics.resistance import forces_rolling, motion_slipping, stiffness_slipping

# In the kernel's units; `hophoop.simulation.phases.Margins` says what they are.
MARGINS = ("normal_force", "friction_force", "friction_limit", "free_acceleration", "slip", "height", "p_sigma")


def margins_of(body, mode, theta, theta_low, omega, slip, height):
    """Numbers in the order of `MARGINS`; nan where the mode has none."""
    s, c = sine_cosine(theta, theta_low)
    normal = math.nan
    friction = math.nan
    p_sigma = math.nan
    mu = body.mu_s
    sigma = slip_direction(mode)
    if mode == Mode.ROLL:
        friction, normal = forces_rolling(body, s, c, omega)
    elif sigma != 0 and body.kap > 0.0 and math.isfinite(body.mu_k):
        normal = motion_slipping(body, s, c, omega, sigma)[1]
        friction = -sigma * body.mu_k * normal
        p_sigma = stiffness_slipping(body, s, c, omega, sigma) / body.kap
        mu = body.mu_k
    elif mode in (Mode.FLIGHT, Mode.SKIM):
        friction = 0.0
        normal = 0.0
    limit = 0.0
    if normal != 0.0:
        limit = math.inf if math.isinf(mu) and normal > 0.0 else mu * normal
    return normal, friction, limit, free_acceleration(body, s, c, omega * omega)[1], slip, height, p_sigma
