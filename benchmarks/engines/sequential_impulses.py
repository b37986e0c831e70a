"""Why engines with sequential impulses take off too early: their iteration alone, without any engine around it.

    python benchmarks/engines/sequential_impulses.py

Each step applies gravity and then so many sweeps over one contact with warm start: a correction of the normal impulse and one
of the friction, bounded by μ times the normal impulse. In slip whose friction lifts the rim, a sweep maps N to a − r N with
r = μ abs(W_tn)/W_nn. It settles for r < 1. For r > 1 it ends in a cycle of two: N = 0 and N = a. An even number
of sweeps then leaves N as it was the step before, for good; an odd number turns it over every step, which on average is right.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from measures import measure
from task import States, Task
from truth import truths

Sweep = Callable[[list[float], tuple[float, float, float], float], None]


def _apply(contact: list[float], push: tuple[float, float, float], friction: float, normal: float) -> None:
    """Change both impulses, and the velocities along and off the plane with them."""
    along, off, both = push
    contact[0] += friction
    contact[1] += normal
    contact[2] += along * friction + both * normal
    contact[3] += both * friction + off * normal


def _bounded(value: float, most: float) -> float:
    return min(max(value, -most), most)


def together(contact: list[float], push: tuple[float, float, float], mu: float) -> None:
    """As Chipmunk: both corrections from the velocities before either, friction bounded by the new normal impulse."""
    friction, normal, vt, vn = contact
    new = max(0.0, normal - vn / push[1])
    _apply(contact, push, _bounded(friction - vt / push[0], mu * new) - friction, new - normal)


def friction_first(contact: list[float], push: tuple[float, float, float], mu: float) -> None:
    """As Box2D: friction bounded by the normal impulse so far, then the normal impulse."""
    friction, normal, vt, _ = contact
    _apply(contact, push, _bounded(friction - vt / push[0], mu * normal) - friction, 0.0)
    new = max(0.0, normal - contact[3] / push[1])
    _apply(contact, push, 0.0, new - normal)


def run(task: Task, dt: float, sweeps: int, sweep: Sweep) -> States:
    """The motion with steps of dt [s] and so many sweeps a step."""
    m, inertia, arm, radius = task.mass, task.inertia, task.arm, task.radius
    x, y, turn, vx, vy, spin = task.body()
    contact = [0.0, 0.0, 0.0, 0.0]
    touching = False

    def step() -> None:
        nonlocal x, y, turn, vx, vy, spin, touching
        vx, vy = vx + task.pull[0] * dt, vy + task.pull[1] * dt
        sine, cosine, omega = math.sin(-turn), math.cos(turn), -spin
        if y - radius - arm * cosine <= 0.0:
            levers = -(radius + arm * cosine), arm * sine
            push = (
                1.0 / m + levers[0] ** 2 / inertia,
                1.0 / m + levers[1] ** 2 / inertia,
                levers[0] * levers[1] / inertia,
            )
            old = contact[:2] if touching else [0.0, 0.0]
            contact[:] = [0.0, 0.0, vx - arm * omega * cosine - radius * omega, vy + arm * omega * sine]
            _apply(contact, push, *old)
            for _ in range(sweeps):
                sweep(contact, push, task.mu)
            vx, vy = vx + contact[0] / m, vy + contact[1] / m
            spin -= (levers[0] * contact[0] + levers[1] * contact[1]) / inertia
            touching = True
        else:
            touching = False
        x, y, turn = x + vx * dt, y + vy * dt, turn + spin * dt

    return task.march(dt, step, lambda: (x, y, turn, vx, vy, spin))


def settles(task: Task, angle: float) -> float:
    """r = μ abs(W_tn)/W_nn at an angle [rad]: the sweeps settle where it is below 1."""
    eps, kap = task.eccentricity, task.inertia / (task.mass * task.radius**2)
    sine, cosine = math.sin(angle), math.cos(angle)
    return task.mu * eps * abs(sine) * (1.0 + eps * cosine) / (kap + eps**2 * sine**2)


def main() -> None:
    """Print what each number of sweeps makes of the hop."""
    task, right = truths()["hop"].task, truths()["hop"].measures
    turn = math.degrees(right.takeoff_angle or 0.0)
    edge = next(d for d in range(2700, 3600) if settles(task, math.radians(d / 10.0)) > 1.0) / 10.0
    print(f"the sweeps do not settle from θ = {edge:.1f}° on; the hoop takes off at {turn:.1f}°")
    for sweep in (together, friction_first):
        for sweeps in (10, 11, 100, 101):
            for dt in (1e-3, 1e-4):
                found = measure(task, run(task, dt, sweeps, sweep))
                height = (
                    "no hop" if found.hop_height is None else f"{1e3 * (found.hop_height - (right.hop_height or 0.0)):+8.1f} mm"
                )
                angle = "" if found.takeoff_angle is None else f"{math.degrees(found.takeoff_angle) - turn:+8.2f}°"
                print(f"{sweep.__name__:15} {sweeps:4d} sweeps {1e3 * dt:5g} ms  {height} {angle}  {found.sequence}")


if __name__ == "__main__":
    main()
