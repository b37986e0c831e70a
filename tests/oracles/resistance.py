r"""The hoop with rolling resistance, integrated in time by SciPy (double precision, SI units).

The equations are those of :mod:`oracles.mechanics` with one more force: the couple M on the rotation, so that
M(q) q̈ = applied + Jᵀ (F, N) + (0, 0, M). A mode is a pair: what the rim does (R, S, K, H) and which way the hoop turns (+1,
−1, or 0 where the couple holds it). The six equations for (ẍ, ÿ, θ̈, F, N, M) are solved as they are; M = −f R N · way, or
θ̈ = 0 where it is held. After an event every pair that the velocities allow is tried, and the one whose signs come out right
is taken. An impact is without the couple.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from . import hybrid
from .cases import Case
from .mechanics import (
    DIRECTION,
    FLIGHT,
    ROLL,
    Vector,
    applied_forces,
    contact_jacobian,
    free_normal_acceleration,
    kinetic_energy,
    mass_matrix,
    potential_energy,
)

Mode = tuple[str, int]


@dataclass
class Motion:
    """Events, losses and end of a motion; the state is (x, y, θ, ẋ, ẏ, θ̇, friction work, rolling work)."""

    events: list[dict[str, Any]] = field(default_factory=list)
    pieces: list[tuple[float, Any, Mode]] = field(default_factory=list)
    sequence: str = ""
    status: str = "completed"
    residual: float = 0.0
    end: Vector = field(default_factory=lambda: np.zeros(8))

    def at(self, t: float) -> Vector:
        """The state at a time, from the dense output."""
        begin, dense, _ = next(piece for piece in reversed(self.pieces) if piece[0] <= t)
        return np.asarray(dense(t - begin))


def solve_mode(case: Case, f: float, mode: Mode, angle: float, omega: float) -> Vector:
    """(ẍ, ÿ, θ̈, F, N, M) in a mode."""
    contact, way = mode
    jacobian = contact_jacobian(case)
    system, right = np.zeros((6, 6)), np.zeros(6)
    system[:3, :3] = mass_matrix(case, angle)
    system[:3, 3:5] = -jacobian.T
    system[2, 5] = -1.0
    right[:3] = applied_forces(case, angle, omega)
    if contact == FLIGHT:
        system[3, 3] = system[4, 4] = system[5, 5] = 1.0
        return np.linalg.solve(system, right)
    system[4, :3] = jacobian[1]
    if contact == ROLL:
        system[3, :3] = jacobian[0]
    else:
        system[3, 3], system[3, 4] = 1.0, DIRECTION[contact] * case.mu_kinetic
    if way == 0:
        system[5, 2] = 1.0
    else:
        system[5, 5], system[5, 4] = 1.0, f * case.radius * way
    return np.linalg.solve(system, right)


def choose(case: Case, f: float, state: Vector) -> Mode:
    """The mode whose signs come out right."""
    vt = hybrid.slip_velocity(case, state)
    contacts = [ROLL, "S", "K"] if vt == 0.0 else ["K" if vt > 0.0 else "S"]
    ways = [0, 1, -1] if state[5] == 0.0 else [1 if state[5] > 0.0 else -1]
    for contact in contacts:
        for way in ways:
            found = solve_mode(case, f, (contact, way), state[2], state[5])
            fits = found[4] > 0.0
            if contact == ROLL:
                fits &= abs(found[3]) <= case.mu_static * found[4]
            elif vt == 0.0:
                fits &= DIRECTION[contact] * (found[0] - case.radius * found[2]) > 0.0
            if way == 0:
                fits &= abs(found[5]) <= f * case.radius * found[4]
            elif state[5] == 0.0:
                fits &= way * found[2] > 0.0
            if fits:
                return contact, way
    return FLIGHT, 0


def guards(case: Case, f: float, mode: Mode) -> dict[str, Callable[[float, Vector], float]]:
    """What is positive while a mode lasts."""
    contact, way = mode
    found: dict[str, Callable[[float, Vector], float]] = {}
    if contact == FLIGHT:
        found["impact"] = lambda _, s: s[1]
    elif way != 0:
        found["turn"] = lambda _, s: way * s[5]
    if contact == ROLL:
        for sign, name in ((1.0, "S"), (-1.0, "K")):

            def margin(_: float, s: Vector, sign: float = sign) -> float:
                forces = solve_mode(case, f, mode, s[2], s[5])
                return float(case.mu_static * forces[4] - sign * forces[3])

            found[name] = margin
    elif contact in DIRECTION:
        found["stick"] = lambda _, s: DIRECTION[contact] * hybrid.slip_velocity(case, s)
        found["takeoff"] = lambda _, s: solve_mode(case, f, mode, s[2], s[5])[4]
    for guard in found.values():
        guard.terminal, guard.direction = True, -1.0  # type: ignore[attr-defined]
    return found


def solve(case: Case, f: float) -> Motion:
    """Solve a case with the rolling resistance f."""
    motion = Motion()
    omega = case.vx / case.radius if case.rolling else case.omega
    state = np.array([case.x, case.height, case.angle, case.vx, case.vy, omega, 0.0, 0.0])
    if case.rolling:
        state[3] = case.radius * omega
    origin = state.copy()
    lost = 0.0
    t = 0.0
    mode = (FLIGHT, 0) if case.height > 0.0 else choose(case, f, state)
    motion.sequence = mode[0]

    def right(_: float, s: Vector) -> Vector:
        found = solve_mode(case, f, mode, s[2], s[5])
        slip = -found[3] * hybrid.slip_velocity(case, s) if mode[0] in DIRECTION else 0.0
        return np.array([*s[3:6], *found[:3], slip, -found[5] * s[5]])

    step = 0.03 * hybrid.time_scale(case)
    while t < case.duration and len(motion.events) < case.max_events:
        if mode == (ROLL, 0):
            motion.status = "at_rest"
            break
        tests = guards(case, f, mode)
        span = (0.0, case.duration - t)
        run = solve_ivp(
            right, span, state, "DOP853", events=list(tests.values()), dense_output=True, max_step=step, rtol=1e-13, atol=1e-15
        )
        motion.pieces.append((t, run.sol, mode))
        t += float(run.t[-1])
        state = run.y[:, -1].copy()
        if run.status != 1:
            break
        name = next(name for name, times in zip(tests, run.t_events, strict=True) if len(times))
        before = mode
        if name == "impact":
            state[1] = 0.0
            after, more = hybrid.impact(case, state)
            lost += more["loss_normal"] + more["loss_tangential"]
            state = np.array([*after[:6], *state[6:]])
            state[4] = 0.0
            mode = choose(case, f, state)
        else:
            state[1] = state[4] = 0.0
            if name == "turn":
                state[5] = 0.0
            if name == "stick" or before[0] == ROLL:
                state[3] = case.radius * state[5]
            if name in DIRECTION:
                opens = free_normal_acceleration(case, state[2], state[5]) >= 0.0
                mode = (FLIGHT, 0) if opens else (name, before[1])
            else:
                mode = (FLIGHT, 0) if name == "takeoff" else choose(case, f, state)
        if mode[0] != before[0]:
            motion.sequence += mode[0]
        motion.events.append({"t": t, "what": name, "to": mode[0], **hybrid.named(state), "rolling": float(state[7])})
    motion.end = state
    energies = [kinetic_energy(case, s[2], s[3:6]) + potential_energy(case, s[0], s[1], s[2]) for s in (origin, state)]
    motion.residual = energies[1] + float(state[6] + state[7]) + lost - energies[0]
    return motion
