r"""Compliant contact by SciPy's Radau, on the equations of :mod:`oracles.mechanics` in SI units.

Coordinates are those of the Lagrangian, (x, y, θ), their velocities, the bristle's stretch z and both losses.
The contact force is written from its laws alone; each phase (flight, or contact in one regime of friction) is
integrated to its own event and the next one starts there.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from .cases import Case
from .mechanics import applied_forces, contact_jacobian, kinetic_energy, mass_matrix, potential_energy

Vector = NDArray[np.float64]


@dataclass(frozen=True)
class Contact:
    """A contact in SI units, every number given."""

    stiffness: float
    damping: float
    slip_speed: float
    law: str = "kelvin-voigt"
    friction: str = "tanh"
    tangential_stiffness: float = 1.0
    tangential_damping: float = 1.0


def normal(contact: Contact, height: float, rise: float) -> float:
    """Normal force without the clip [N]."""
    if contact.law == "kelvin-voigt":
        return -contact.stiffness * height - contact.damping * rise
    return -contact.stiffness * height * (1.0 - contact.damping * rise)


def friction(case: Case, contact: Contact, slides: int, load: float, slip: float, stretch: float) -> float:
    """Friction force along the plane [N]; `slides` is the direction of slip, 0 in stick."""
    if contact.friction == "tanh":
        return -case.mu_kinetic * load * math.tanh(slip / contact.slip_speed)
    if contact.friction == "linear":
        return -case.mu_kinetic * load * (slides if slides else slip / contact.slip_speed)
    if slides:
        return -slides * case.mu_kinetic * load
    return -contact.tangential_stiffness * stretch - contact.tangential_damping * slip


def stretch_rate(case: Case, contact: Contact, slides: int, load: float, slip: float, stretch: float) -> float:
    """ż of the bristle, whose foot slides under the friction that its spring and damper balance [m/s]."""
    if contact.friction != "bristle":
        return 0.0
    if slides == 0:
        return slip
    pull = slides * case.mu_kinetic * load - contact.tangential_stiffness * stretch
    return pull / contact.tangential_damping


def motion(case: Case, contact: Contact, start: Vector, touching: bool, duration: float, times: Vector) -> Vector:
    """Rows (x, y, θ, ẋ, ẏ, θ̇, z, friction loss, damping loss) at the times; μs = μk is assumed."""
    jacobian = contact_jacobian(case)
    state = np.array(start, dtype=float)
    out = np.full((times.size, 9), np.nan)
    t = 0.0
    slides = direction(case, contact, state) if touching else 0
    for _ in range(200):
        rhs = _rates(case, contact, jacobian, touching, slides)
        events = _events(case, contact, touching, slides)
        inside = times[(times >= t) & (times <= duration)]
        # a first step beyond the event that began the phase, so that it is not found again
        solution = solve_ivp(
            rhs,
            (t, duration),
            state,
            method="Radau",
            rtol=1e-10,
            atol=1e-13,
            events=events,
            dense_output=True,
        )
        until = solution.t[-1]
        now = inside[inside <= until]
        mask = (times >= t) & (times <= until)
        if now.size:
            out[mask] = solution.sol(now).T
        if solution.status == 0:
            return out
        state, t = solution.y[:, -1], until
        fired = next(i for i, found in enumerate(solution.t_events) if found.size)
        if not touching:
            touching = True
            slides = direction(case, contact, state)
        elif fired == 0:
            touching = False
        elif slides:
            slides = 0
        else:
            slides = direction(case, contact, state, strictly=True)
    raise RuntimeError("too many phases")


def direction(case: Case, contact: Contact, state: Vector, strictly: bool = False) -> int:
    """Direction of slip in which a contact begins, 0 in stick; `strictly` where stick has just ended."""
    if contact.friction == "tanh":
        return 0
    slip = state[3] - case.radius * state[5]
    sign = 1 if slip > 0.0 else -1
    if contact.friction == "linear":
        return sign if strictly or abs(slip) > contact.slip_speed else 0
    pull = contact.tangential_stiffness * state[6] + contact.tangential_damping * slip
    load = normal(contact, state[1], state[4])
    return (1 if pull > 0.0 else -1) if strictly or abs(pull) > case.mu_kinetic * load else 0


def energy(case: Case, contact: Contact, row: Vector, touching: bool = True) -> float:
    """Kinetic, potential and spring energy and both losses [J]."""
    total = kinetic_energy(case, row[2], row[3:6]) + potential_energy(case, row[0], row[1], row[2])
    total += 0.5 * contact.stiffness * min(row[1], 0.0) ** 2 + row[7] + row[8]
    if contact.friction == "bristle":
        total += 0.5 * contact.tangential_stiffness * row[6] ** 2
    return float(total)


def _rates(case, contact, jacobian, touching, slides):  # type: ignore[no-untyped-def]
    def rates(_: float, u: Vector) -> Vector:
        right = applied_forces(case, u[2], u[5])
        slip = u[3] - case.radius * u[5]
        lost = damped = stretching = 0.0
        if touching:
            load = normal(contact, u[1], u[4])
            force = friction(case, contact, slides, load, slip, u[6])
            right = right + jacobian.T @ np.array([force, load])
            stretching = stretch_rate(case, contact, slides, load, slip, u[6])
            lost = -force * slip
            damped = -(load + contact.stiffness * u[1]) * u[4]
        elif contact.friction == "bristle":
            stretching = -contact.tangential_stiffness / contact.tangential_damping * u[6]
            damped = -contact.stiffness * min(u[1], 0.0) * u[4]
        else:
            damped = -contact.stiffness * min(u[1], 0.0) * u[4]
        if contact.friction == "bristle":
            lost -= contact.tangential_stiffness * u[6] * stretching
        acceleration = np.linalg.solve(mass_matrix(case, u[2]), right)
        return np.concatenate([u[3:6], acceleration, [stretching, lost, damped]])

    return rates


def _events(case, contact, touching, slides):  # type: ignore[no-untyped-def]
    def falling(function):  # type: ignore[no-untyped-def]
        function.terminal = True
        function.direction = -1.0
        return function

    if not touching:
        # the contact acts below the plane's level, where its law pushes
        return [falling(lambda _, u: max(u[1], -normal(contact, u[1], u[4]) / contact.stiffness))]

    def load(u: Vector) -> float:
        return normal(contact, u[1], u[4])

    def slip(u: Vector) -> float:
        return float(u[3] - case.radius * u[5])

    events = [falling(lambda _, u: load(u) if contact.law == "kelvin-voigt" else -u[1])]
    if contact.friction == "linear":
        limit = contact.slip_speed
        events.append(falling(lambda _, u: slides * slip(u) - limit if slides else limit - abs(slip(u))))
    elif contact.friction == "bristle" and slides:
        events.append(falling(lambda _, u: slides * (slip(u) - stretch_rate(case, contact, slides, load(u), slip(u), u[6]))))
    elif contact.friction == "bristle":
        k, c = contact.tangential_stiffness, contact.tangential_damping
        events.append(falling(lambda _, u: case.mu_kinetic * load(u) - abs(k * u[6] + c * slip(u))))
    return events
