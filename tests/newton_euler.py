"""Newton's and Euler's equations of the hoop as one linear system, with no formula of `physics/` in it.

It repeats the formulas of the kernel on purpose, derived another way.

C is the centre at (x, 1 + y), G = C + ε (sin θ, cos θ), P the lowest point of the rim; gravity is (g_t, −g_n), and the plane
acts on P with (F, N). Unknowns are ẍ, ÿ, θ̈, F and N.
"""

import math

import numpy as np

from hophoop.kernel.physics.body import Body

BODIES = [
    # ε, κ, μs, μk, g_n, g_t, e, law, painleve_impact, β
    Body(0.75, 0.25 * 0.75 + 0.1, 0.9, 0.7, math.cos(0.2), math.sin(0.2), 0.4, 1, False, 0.2),
    Body(0.4, 0.6, 0.35, 0.3, math.cos(-0.35), math.sin(-0.35), 0.7, 2, True, -0.35),
    Body(0.9, 0.05, 1.4, 1.1, 1.0, 0.0, 0.0, 0, False, 0.0),
]
# θ, θ̇: in each quarter, forwards and backwards
STATES = [(0.4, 1.3), (1.9, -0.8), (3.6, 2.1), (5.3, -1.7), (-2.0, 0.6), (3.0, 0.9)]


def accelerations(body, th, om, mode, rho=0.0):
    """(ẍ, ÿ, θ̈, F, N): mode is 'roll', 'free', or the direction of slip ±1; ρ N is the couple against the rotation."""
    s, c, u = math.sin(th), math.cos(th), om * om
    eps = body.eps
    rows = [
        # ẍ_G = F + g_t with x_G = x + ε sin θ
        ([1, 0, eps * c, -1, 0], body.gt + eps * s * u),
        # ÿ_G = N − g_n with y_G = 1 + y + ε cos θ
        ([0, 1, -eps * s, 0, -1], -body.gn + eps * c * u),
        # κ θ̈ about G, clockwise: P − G = (−ε sin θ, −1 − ε cos θ)
        ([0, 0, body.kap, 1 + eps * c, rho - eps * s], 0.0),
    ]
    if mode == "roll":
        rows += [([1, 0, -1, 0, 0], 0.0), ([0, 1, 0, 0, 0], 0.0)]
    elif mode == "free":
        rows += [([0, 0, 0, 1, 0], 0.0), ([0, 0, 0, 0, 1], 0.0)]
    else:
        rows += [([0, 0, 0, 1, mode * body.mu_k], 0.0), ([0, 1, 0, 0, 0], 0.0)]
    return np.linalg.solve(np.array([row for row, _ in rows], float), np.array([value for _, value in rows]))


def responses(body, th):
    """Changes of (v_t, v_n, θ̇) for a unit impulse along the plane, and for one normal to it."""
    s, c = math.sin(th), math.cos(th)
    found = []
    for force in ((1.0, 0.0), (0.0, 1.0)):
        spin = (force[1] * body.eps * s - force[0] * (1 + body.eps * c)) / body.kap
        # the velocity of G changes by the impulse; that of P by the turn about G as well
        found.append((force[0] - spin * (1 + body.eps * c), force[1] + spin * body.eps * s, spin))
    return found


def energy(body, x, y, th, vx, vy, om):
    """(kinetic, potential) energy from the velocity and the place of G; the second up to a constant."""
    gx = vx + body.eps * math.cos(th) * om
    gy = vy - body.eps * math.sin(th) * om
    kinetic = 0.5 * (gx * gx + gy * gy + body.kap * om * om)
    place = (x + body.eps * math.sin(th), y + body.eps * math.cos(th))
    return kinetic, body.gn * place[1] - body.gt * place[0]
