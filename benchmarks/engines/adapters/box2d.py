"""Box2D 2.3 (pybox2d): a circle on an edge, in single precision."""

from __future__ import annotations

import Box2D as b2
from task import States, Task


def run(task: Task, dt: float, velocity_iterations: int = 8, position_iterations: int = 3) -> States:
    """Run a task; the settings are the iterations per step."""
    world = b2.b2World(gravity=task.pull, doSleep=False)
    ground = world.CreateStaticBody()
    ground.CreateEdgeFixture(vertices=[(-100.0, 0.0), (100.0, 0.0)], friction=task.mu, restitution=0.0)
    start = task.body()
    body = world.CreateDynamicBody(
        position=(start.x, start.y),
        angle=start.turn,
        linearVelocity=(start.vx, start.vy),
        angularVelocity=start.spin,
        allowSleep=False,
    )
    body.CreateCircleFixture(
        radius=task.radius, pos=(0.0, -task.arm), density=1.0, friction=task.mu, restitution=task.restitution
    )  # fmt: skip
    body.massData = b2.b2MassData(mass=task.mass, center=(0.0, 0.0), I=task.inertia)
    body.linearVelocity, body.angularVelocity = (start.vx, start.vy), start.spin
    return task.march(
        dt,
        lambda: world.Step(dt, velocity_iterations, position_iterations),
        lambda: (*body.worldCenter, body.angle, *body.linearVelocity, body.angularVelocity),
    )
