"""MuJoCo: a sphere on a plane, held in one plane by two slides and a hinge."""

from __future__ import annotations

import mujoco
from task import States, Task


def run(
    task: Task,
    dt: float,
    cone: str = "pyramidal",
    integrator: str = "Euler",
    solref: str = "0.02 1",
    impratio: float = 1.0,
    solimp: str = "0.9 0.95 0.001",
) -> States:
    """Run a task; the settings are MuJoCo's options and those of both geoms."""
    along, off = task.pull
    moment = repr(task.inertia)
    model = mujoco.MjModel.from_xml_string(f"""
    <mujoco>
      <option timestep="{dt!r}" gravity="{along!r} 0 {off!r}" cone="{cone}" integrator="{integrator}" impratio="{impratio!r}"
       tolerance="0" iterations="100"/>
      <worldbody>
        <geom type="plane" size="0 0 1" friction="{task.mu!r} 0 0" solref="{solref}" solimp="{solimp}" condim="3"/>
        <body pos="0 0 {task.radius!r}">
          <joint type="slide" axis="1 0 0"/> <joint type="slide" axis="0 0 1"/> <joint type="hinge" axis="0 1 0"/>
          <inertial pos="0 0 {task.arm!r}" mass="{task.mass!r}" diaginertia="{moment} {moment} {moment}"/>
          <geom type="sphere" size="{task.radius!r}" friction="{task.mu!r} 0 0" solref="{solref}" solimp="{solimp}" condim="3"/>
        </body>
      </worldbody>
    </mujoco>""")
    data = mujoco.MjData(model)
    data.qpos[:] = task.x, task.height, task.angle
    data.qvel[:] = task.vx, task.vy, task.omega
    rows = task.march_rim(dt, lambda: mujoco.mj_step(model, data), lambda: (*data.qpos, *data.qvel))
    return rows
