"""hophoop's compliant contact: spring, damper and regularised friction, integrated with error control. Ours, too."""

from __future__ import annotations

from typing import Any

from hophoop.engines.adapters.hophoop import sample_motion, scenario_of
from hophoop.engines.task import States, Task
from hophoop.scenario import Compliant

PACKAGE = "hophoop"
STEP = 0.001
TITLE = "hophoop, compliant (ours)"
CONTACT = "Kelvin and Voigt’s or Hunt and Crossley’s force with friction built up over a small slip velocity; error-controlled."
MODEL = "2D; spring and damper with k = m/dt²: dt is the time in which the contact answers, the integrator takes its own steps"
SETTINGS: dict[str, dict[str, Any]] = {
    "default": {},
    "tuned": {"law": "hunt-crossley", "rtol": 1e-8},
}


def run(task: Task, dt: float, law: str = "kelvin-voigt", rtol: float = 1e-9) -> States:
    """Run a task with the stiffness m/dt²."""
    contact = Compliant(stiffness=task.mass / dt**2, law=law, rtol=rtol)
    return sample_motion(scenario_of(task, contact), 0.0)
