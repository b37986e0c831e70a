"""SciPy's solve_ivp with events: the rigid equations as a user would write them, mode after mode."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy import integrate
from task import SPACING, Floats, States, Task

ROLL, FLIGHT = "roll", "flight"  # slip is a sign, that of the slip velocity
CLOSED = 1e-7  # m/s, below which bounces end


def run(task: Task, dt: float, method: str = "RK45", rtol: float = 1e-3, atol: float = 1e-6) -> States:
    """Run a task; dt is the longest step that the integrator may take."""
    state = np.array([task.x, task.height, task.angle, task.vx, task.vy, task.omega])
    t, mode = 0.0, _choose(task, state)
    times, rows = [np.zeros(1)], [state[None]]
    while t < task.duration:
        tests = _events(task, mode)
        done = integrate.solve_ivp(
            lambda _, s, mode=mode: _rates(task, s, mode)[0],
            (t, task.duration), state, method, events=tests, max_step=dt, rtol=rtol, atol=atol, dense_output=True,
        )  # fmt: skip
        if not done.success:
            raise RuntimeError(done.message)
        between = np.arange(math.floor(t / SPACING) + 1, math.ceil(done.t[-1] / SPACING)) * SPACING
        if between.size:
            times.append(between)
            rows.append(done.sol(between).T)
        times.append(done.t[-1:])
        rows.append(done.y.T[-1:])
        t, state = float(done.t[-1]), done.y[:, -1].copy()
        if done.status == 1:
            mode = _after(task, state, mode)
    every, columns = np.concatenate(times), np.concatenate(rows)
    fresh = np.concatenate([np.diff(every) > 1e-9, [True]])  # the state after an event
    return States(every[fresh], *columns[fresh].T)


def _rates(task: Task, s: Floats, mode: Any) -> tuple[Floats, float, float]:
    """Rates of the state, friction and normal force."""
    angle, vx, vy, omega = (float(value) for value in s[2:])
    sine, cosine, m, arm, radius = math.sin(angle), math.cos(angle), task.mass, task.arm, task.radius
    along, off = task.pull
    rows = [
        [m, 0.0, m * arm * cosine, -1.0, 0.0],
        [0.0, m, -m * arm * sine, 0.0, -1.0],
        [0.0, 0.0, task.inertia, radius + arm * cosine, -arm * sine],
    ]
    right = [m * (along + arm * omega**2 * sine), m * (off + arm * omega**2 * cosine), 0.0]
    if mode == FLIGHT:
        rows += [[0.0, 0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 0.0, 1.0]]
    elif mode == ROLL:
        rows += [[1.0, 0.0, -radius, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0]]
    else:
        rows += [[0.0, 0.0, 0.0, 1.0, mode * task.mu], [0.0, 1.0, 0.0, 0.0, 0.0]]
    ax, ay, alpha, friction, normal = np.linalg.solve(np.array(rows), np.array([*right, 0.0, 0.0]))
    return np.array([vx, vy, omega, ax, ay, alpha]), float(friction), float(normal)


def _events(task: Task, mode: Any) -> list[Any]:
    def lands(_: float, s: Floats) -> float:
        return float(s[1])

    def lifts(_: float, s: Floats) -> float:
        return _rates(task, s, mode)[2]

    def holds(_: float, s: Floats) -> float:
        friction, normal = _rates(task, s, mode)[1:]
        return task.mu * normal - abs(friction)

    def slides(_: float, s: Floats) -> float:
        return float(mode * (s[3] - task.radius * s[5]))

    tests: list[Any] = [lands] if mode == FLIGHT else [lifts, holds if mode == ROLL else slides]
    for test in tests:
        test.terminal, test.direction = True, -1.0
    return tests


def _choose(task: Task, s: Floats) -> Any:
    slip = s[3] - task.radius * s[5]
    if s[1] > 0.0 or s[4] > 0.0:
        return FLIGHT
    if abs(slip) > 1e-9:
        mode = math.copysign(1.0, slip)
        if _rates(task, s, mode)[2] < 0.0:
            if _rates(task, s, FLIGHT)[0][4] < 0.0:
                raise RuntimeError("no contact force holds the rim up: Painlevé's paradox.")
            return FLIGHT
        return mode
    s[3] = task.radius * s[5]
    _, friction, normal = _rates(task, s, ROLL)
    if normal <= 0.0:
        return FLIGHT
    return ROLL if abs(friction) <= task.mu * normal else -math.copysign(1.0, friction)


def _after(task: Task, s: Floats, mode: Any) -> Any:
    if mode == FLIGHT:
        s[1] = 0.0
        _impact(task, s)
        return _choose(task, s)
    s[1] = s[4] = 0.0
    slip, (_, friction, normal) = s[3] - task.radius * s[5], _rates(task, s, mode)
    if mode == ROLL:
        return FLIGHT if normal <= 0.0 else -math.copysign(1.0, friction)
    if abs(slip) < 1e-6:
        s[3] = task.radius * s[5]
        return _choose(task, s)
    return FLIGHT


def _impact(task: Task, s: Floats) -> None:
    """Apply Newton's law of restitution and Coulomb's law to the impulses."""
    sine, cosine = math.sin(s[2]), math.cos(s[2])
    lever = np.array([-(task.radius + task.arm * cosine), task.arm * sine])  # of F and N about G
    push = np.eye(2) / task.mass + np.outer(lever, lever) / task.inertia  # velocities of the rim's point per unit impulse
    slip = s[3] - task.radius * s[5]
    bounce = 0.0 if -s[4] < CLOSED else task.restitution
    wanted = np.array([-slip, -(1.0 + bounce) * s[4]])
    impulse = np.linalg.solve(push, wanted)
    if abs(impulse[0]) > task.mu * impulse[1]:
        ratio = -math.copysign(task.mu, slip)
        impulse = np.array([ratio, 1.0]) * (wanted[1] / (push[1, 1] + ratio * push[1, 0]))
    spin = float(lever @ impulse) / task.inertia
    s[3] += impulse[0] / task.mass - task.arm * cosine * spin
    s[4] = -bounce * s[4]
    s[5] += spin
