"""PyBullet: a sphere on a plane, free in 3D."""

from __future__ import annotations

import math
from typing import Any

import pybullet as bullet
from task import States, Task


def run(
    task: Task, dt: float, iterations: int = 50, cone: bool = False, threshold: float = 0.2, split: bool | None = None
) -> States:
    """Run a task; `threshold` is the speed of approach below which nothing bounces [m/s]."""
    client = bullet.connect(bullet.DIRECT)
    try:
        start = task.body()
        along, off = task.pull
        bullet.setGravity(along, 0.0, off, physicsClientId=client)
        parameters: dict[str, Any] = {"fixedTimeStep": dt, "numSubSteps": 1, "numSolverIterations": iterations}
        parameters |= {"restitutionVelocityThreshold": threshold, "enableConeFriction": int(cone)}
        if iterations > 50:
            parameters["solverResidualThreshold"] = 0.0
        if split is not None:
            parameters["useSplitImpulse"] = int(split)
        bullet.setPhysicsEngineParameter(**parameters, physicsClientId=client)
        plane = bullet.createCollisionShape(bullet.GEOM_PLANE, physicsClientId=client)
        ground = bullet.createMultiBody(0.0, plane, physicsClientId=client)
        ball = bullet.createCollisionShape(
            bullet.GEOM_SPHERE, radius=task.radius, collisionFramePosition=(0.0, 0.0, -task.arm), physicsClientId=client
        )
        # a rotation about −y moves z to −x: counterclockwise in x and z, as in BodyState
        half = 0.5 * start.turn
        body = bullet.createMultiBody(
            task.mass, ball, basePosition=(start.x, 0.0, start.y),
            baseOrientation=(0.0, -math.sin(half), 0.0, math.cos(half)), physicsClientId=client,
        )  # fmt: skip
        free: dict[str, Any] = {"linearDamping": 0.0, "angularDamping": 0.0, "rollingFriction": 0.0, "spinningFriction": 0.0}
        free |= {"localInertiaDiagonal": (task.inertia,) * 3, "activationState": bullet.ACTIVATION_STATE_DISABLE_SLEEPING}
        bullet.changeDynamics(
            body, -1, lateralFriction=task.mu, restitution=task.restitution, physicsClientId=client, **free
        )  # fmt: skip
        bullet.changeDynamics(ground, -1, lateralFriction=1.0, restitution=1.0, physicsClientId=client)
        bullet.resetBaseVelocity(body, (start.vx, 0.0, start.vy), (0.0, -start.spin, 0.0), physicsClientId=client)

        def read() -> tuple[float, ...]:
            place, turn = bullet.getBasePositionAndOrientation(body, physicsClientId=client)
            speed, spin = bullet.getBaseVelocity(body, physicsClientId=client)
            return place[0], place[2], 2.0 * math.atan2(-turn[1], turn[3]), speed[0], speed[2], -spin[1]

        return task.march(dt, lambda: bullet.stepSimulation(physicsClientId=client), read, unwrap=True)
    finally:
        bullet.disconnect(client)
