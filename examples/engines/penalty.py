"""A penalty method as an adapter of `hophoop compare`."""

import math

PACKAGE = "numpy"  # whose version the table shows
STEP = 0.001  # the manual's time step, in seconds
SETTINGS = {"default": {}, "tuned": {"stiffness": 1e6, "slip_speed": 1e-3}}


def run(task, dt, stiffness=1e5, slip_speed=1e-2):
    # what explicit steps of this size can follow
    stiffness = min(stiffness, task.mass / (3 * dt) ** 2)
    slip_speed = max(slip_speed, 10 * dt)
    x, y, turn, vx, vy, spin = task.body()

    def step():
        nonlocal x, y, turn, vx, vy, spin
        sine, cosine, omega = math.sin(-turn), math.cos(turn), -spin
        gap = y - task.radius - task.arm * cosine
        rise = vy + task.arm * omega * sine
        slip = vx - task.arm * omega * cosine - task.radius * omega
        normal = (
            max(0.0, -stiffness * gap - math.sqrt(stiffness) * rise)
            if gap < 0.0
            else 0.0
        )
        friction = -task.mu * normal * max(-1.0, min(1.0, slip / slip_speed))
        vx += dt * (friction / task.mass + task.pull[0])
        vy += dt * (normal / task.mass + task.pull[1])
        spin += (
            dt
            * (
                (task.radius + task.arm * cosine) * friction
                - task.arm * sine * normal
            )
            / task.inertia
        )
        x, y, turn = x + dt * vx, y + dt * vy, turn + dt * spin

    return task.march(dt, step, lambda: (x, y, turn, vx, vy, spin))
