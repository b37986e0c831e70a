"""pymunk (Chipmunk2D): a circle on a segment."""

from __future__ import annotations

import pymunk
from task import States, Task


def run(task: Task, dt: float, iterations: int = 10, slop: float = 0.1, bias: float | None = None) -> States:
    """Run a task; the settings are those of Chipmunk's space."""
    space = pymunk.Space()
    space.gravity = task.pull
    space.iterations, space.collision_slop = iterations, slop
    if bias is not None:
        space.collision_bias = bias
    ground = pymunk.Segment(space.static_body, (-100.0, 0.0), (100.0, 0.0), 0.0)
    start = task.body()
    body = pymunk.Body(task.mass, task.inertia)
    body.position, body.angle = (start.x, start.y), start.turn
    body.velocity, body.angular_velocity = (start.vx, start.vy), start.spin
    rim = pymunk.Circle(body, task.radius, offset=(0.0, -task.arm))
    rim.friction, ground.friction = task.mu, 1.0
    rim.elasticity, ground.elasticity = task.restitution, 1.0
    space.add(body, rim, ground)
    return task.march(
        dt, lambda: space.step(dt), lambda: (*body.position, body.angle, *body.velocity, body.angular_velocity)
    )  # fmt: skip
