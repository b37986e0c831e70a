"""hophoop's compliant contact: spring, damper and regularised friction, integrated with error control. Ours, too."""

from __future__ import annotations

from adapters.hophoop import sample_motion, scenario_of
from task import States, Task

from hophoop.scenario import Compliant


def run(task: Task, dt: float, law: str = "kelvin-voigt", rtol: float = 1e-9) -> States:
    """Run a task with the stiffness m/dt²."""
    contact = Compliant(stiffness=task.mass / dt**2, law=law, rtol=rtol)
    return sample_motion(scenario_of(task, contact))
