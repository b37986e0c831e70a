r"""Equations of motion from the Lagrangian, with the contact force as a multiplier (double precision).

With q = (x, y, θ) of the rim's centre the centre of gravity is G = (x + εR sin θ, R + y + εR cos θ), so

    T = m/2 (ẋ² + ẏ² + ε²R²θ̇² + 2εRθ̇ (ẋ cos θ − ẏ sin θ)) + κmR²θ̇²/2
    V = m g (cos β · G_y − sin β · G_x)

which gives the constant-free mass matrix below, the centrifugal terms mεRθ̇² (sin θ, cos θ, 0) and the
gravity terms. The material point at the bottom of the rim has velocity (ẋ − Rθ̇, ẏ); its Jacobian J is
constant. The contact force λ = (F, N) enters as Jᵀλ, the couple M of rolling resistance in the third row. The accelerations,
λ and M solve one augmented 6 × 6 system, closed by three rows that depend on the mode: nothing is eliminated by hand.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from .cases import Case

ROLL, SPIN, SKID, FLIGHT = "R", "S", "K", "H"
DIRECTION = {SPIN: -1.0, SKID: 1.0}  # sign of the slip velocity ẋ − Rθ̇

Vector = NDArray[np.float64]


def mass_matrix(case: Case, angle: float) -> Vector:
    """Mass matrix in (x, y, θ)."""
    m, arm = case.mass, case.eccentricity * case.radius
    s, c = math.sin(angle), math.cos(angle)
    about_centre = arm**2 + case.inertia_ratio * case.radius**2
    return m * np.array([[1.0, 0.0, arm * c], [0.0, 1.0, -arm * s], [arm * c, -arm * s, about_centre]])


def applied_forces(case: Case, angle: float, omega: float) -> Vector:
    """Generalised gravity plus centrifugal terms, the right-hand side without contact."""
    m, arm, g = case.mass, case.eccentricity * case.radius, case.gravity
    s, c = math.sin(angle), math.cos(angle)
    down, along = math.cos(case.slope), math.sin(case.slope)
    return m * np.array(
        [
            g * along + arm * s * omega**2,
            -g * down + arm * c * omega**2,
            g * arm * (down * s + along * c),
        ]
    )


def contact_jacobian(case: Case) -> Vector:
    """Rows: velocity of the contact point along and off the plane per (ẋ, ẏ, θ̇)."""
    return np.array([[1.0, 0.0, -case.radius], [0.0, 1.0, 0.0]])


def solve_mode(case: Case, mode: str, angle: float, omega: float, way: int = 0) -> Vector:
    """Accelerations, contact force and couple (ẍ, ÿ, θ̈, F, N, M) in a mode.

    With rolling resistance f the couple is −f R N way where the hoop turns that `way`, and holds θ̇ where `way` is 0.
    """
    system = np.zeros((6, 6))
    right = np.zeros(6)
    jacobian = contact_jacobian(case)
    system[:3, :3] = mass_matrix(case, angle)
    system[:3, 3:5] = -jacobian.T
    system[2, 5] = -1.0
    right[:3] = applied_forces(case, angle, omega)
    system[5, 5] = 1.0
    if mode == FLIGHT:
        system[3, 3] = system[4, 4] = 1.0
        return np.linalg.solve(system, right)
    system[4, :3] = jacobian[1]
    if mode == ROLL:
        system[3, :3] = jacobian[0]
    else:
        system[3, 3], system[3, 4] = 1.0, DIRECTION[mode] * case.mu_kinetic
    if case.rolling_resistance and way == 0:
        system[5, 2], system[5, 5] = 1.0, 0.0
    else:
        system[5, 4] = case.rolling_resistance * case.radius * way
    return np.linalg.solve(system, right)


def free_normal_acceleration(case: Case, angle: float, omega: float) -> float:
    """Acceleration of the contact point off the plane if there were no contact force."""
    return float(np.linalg.solve(mass_matrix(case, angle), applied_forces(case, angle, omega))[1])


def normal_response(case: Case, angle: float, direction: float, way: int = 0) -> float:
    """Acceleration off the plane per unit normal force when slip in `direction` and a turn that `way` drag along."""
    jacobian = contact_jacobian(case)
    force = jacobian[1] - direction * case.mu_kinetic * jacobian[0]
    force[2] -= case.rolling_resistance * case.radius * way
    return float(np.linalg.solve(mass_matrix(case, angle), force)[1])


def kinetic_energy(case: Case, angle: float, velocity: Vector) -> float:
    """½ q̇ᵀ M q̇ [J]."""
    return 0.5 * float(velocity @ mass_matrix(case, angle) @ velocity)


def potential_energy(case: Case, x: float, height: float, angle: float) -> float:
    """Weight times the true rise of G above its place at x = 0, in contact, load on the normal [J]."""
    arm = case.eccentricity * case.radius
    along = x + arm * math.sin(angle)
    off = height + arm * (math.cos(angle) - 1.0)
    return case.mass * case.gravity * (off * math.cos(case.slope) - along * math.sin(case.slope))
