"""The oracles' equations for a body of the kernel, in units of R and m, with no formula of `physics/` in them."""

import math

import numpy as np

from hophoop.kernel.physics.body import Body
from oracles import mechanics
from oracles.cases import Case

BODIES = [
    # ε, κ, μs, μk, g_n, g_t, e, law, painleve_impact, β
    Body(0.75, 0.25 * 0.75 + 0.1, 0.9, 0.7, math.cos(0.2), math.sin(0.2), 0.4, 1, False, 0.2),
    Body(0.4, 0.6, 0.35, 0.3, math.cos(-0.35), math.sin(-0.35), 0.7, 2, True, -0.35),
    Body(0.9, 0.05, 1.4, 1.1, 1.0, 0.0, 0.0, 0, False, 0.0),
]
# θ, θ̇: in each quarter, forwards and backwards
STATES = [(0.4, 1.3), (1.9, -0.8), (3.6, 2.1), (5.3, -1.7), (-2.0, 0.6), (3.0, 0.9)]


def case_of(body, rho=0.0):
    """The oracles' case of a body; ρ N is the couple against the rotation."""
    return Case(
        "body", eccentricity=body.eps, inertia_ratio=body.kap, gravity=math.hypot(body.gn, body.gt),
        slope=math.atan2(body.gt, body.gn), mu_static=body.mu_s, mu_kinetic=body.mu_k, rolling_resistance=abs(rho),
    )  # fmt: skip


def accelerations(body, th, om, mode, rho=0.0):
    """(ẍ, ÿ, θ̈, F, N): mode is 'roll', 'free', or the direction of slip ±1; ρ N is the couple against the rotation."""
    letter = {"roll": mechanics.ROLL, "free": mechanics.FLIGHT, 1: mechanics.SKID, -1: mechanics.SPIN}[mode]
    return mechanics.solve_mode(case_of(body, rho), letter, th, om, int(np.sign(rho)))[:5]


def responses(body, th):
    """Changes of (v_t, v_n, θ̇) for a unit impulse along the plane, and for one normal to it."""
    case = case_of(body)
    jacobian = mechanics.contact_jacobian(case)
    changes = np.linalg.solve(mechanics.mass_matrix(case, th), jacobian.T)
    return [(*(jacobian @ change), change[2]) for change in changes.T]


def energy(body, x, y, th, vx, vy, om):
    """(kinetic, potential) energy; the second up to a constant."""
    case = case_of(body)
    return mechanics.kinetic_energy(case, th, np.array([vx, vy, om])), mechanics.potential_energy(case, x, y, th)
