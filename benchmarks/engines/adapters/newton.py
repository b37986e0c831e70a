"""Newton (Warp) on the CPU: a sphere on a plane, a free body."""

from __future__ import annotations

import math
from typing import Any

import newton
import numpy as np
import warp
from task import States, Task


def run(
    task: Task,
    dt: float,
    solver: str = "XPBD",
    iterations: int = 2,
    stiffness: float = 2500.0,
    damping: float = 100.0,
    friction: float = 1000.0,
    relaxation: float = 0.8,
) -> States:
    """Run a task with a solver of Newton's; stiffness, damping and friction are ke, kd and kf of its shapes."""
    warp.config.quiet = True
    with warp.ScopedDevice("cpu"):
        along, off = task.pull
        builder = newton.ModelBuilder(up_axis=newton.Axis.Y, gravity=(along, off, 0.0))
        surface = newton.ModelBuilder.ShapeConfig(
            density=0.0, ke=stiffness, kd=damping, kf=friction, mu=task.mu, restitution=task.restitution,
            mu_torsional=0.0, mu_rolling=0.0,
        )  # fmt: skip
        start = task.body()
        half = 0.5 * start.turn
        body = builder.add_body(
            xform=warp.transform((start.x, start.y, 0.0), (0.0, 0.0, math.sin(half), math.cos(half))),
            com=(0.0, 0.0, 0.0), mass=task.mass, inertia=warp.mat33(*(np.eye(3) * task.inertia).ravel()), lock_inertia=True,
        )  # fmt: skip
        builder.add_shape_sphere(body, xform=warp.transform((0.0, -task.arm, 0.0)), radius=task.radius, cfg=surface)
        builder.add_ground_plane(cfg=surface)
        model = builder.finalize()
        options: dict[str, Any] = {"angular_damping": 0.0}
        if solver == "XPBD":
            options |= {"iterations": iterations, "enable_restitution": task.restitution > 0.0}
            options |= {"rigid_contact_relaxation": relaxation}
        engine = getattr(newton.solvers, f"Solver{solver}")(model, **options)
        now, following = model.state(), model.state()
        now.joint_qd.assign([start.vx, start.vy, 0.0, 0.0, 0.0, start.spin])
        newton.eval_fk(model, now.joint_q, now.joint_qd, now)
        control = model.control()

        def step() -> None:
            nonlocal now, following
            now.clear_forces()
            engine.step(now, following, control, model.collide(now), dt)
            now, following = following, now

        def read() -> tuple[float, ...]:
            place, rate = now.body_q.numpy()[0], now.body_qd.numpy()[0]
            return place[0], place[1], 2.0 * math.atan2(place[5], place[6]), rate[0], rate[1], rate[5]

        return task.march(dt, step, read, unwrap=True)
