"""hophoop itself: the exact motion, solved from event to event. We are the authors of this row."""

from __future__ import annotations

from typing import Any

import numpy as np
from task import SPACING, States, Task

from hophoop.scenario import Compliant, Hoop, Plane, Rigid, Scenario, Start
from hophoop.simulation.simulate import simulate


def scenario_of(task: Task, contact: Rigid | Compliant = Rigid()) -> Scenario:
    """Return the scenario of a task, with Newton's law of restitution as in other engines."""
    law: dict[str, Any] = {"impact_law": "newton"} if task.restitution and contact.model == "rigid" else {}
    rolling = task.vx == task.radius * task.omega and task.vy == 0.0 and task.height == 0.0
    start = (
        Start.rolling(task.vx, angle=task.angle, x=task.x)
        if rolling
        else Start(x=task.x, height=task.height, angle=task.angle, vx=task.vx, vy=task.vy, omega=task.omega)
    )
    return Scenario(
        hoop=Hoop(
            radius=task.radius,
            mass=task.mass,
            eccentricity=task.eccentricity,
            inertia_ratio=task.inertia / (task.mass * task.radius**2),
        ),
        plane=Plane(gravity=task.gravity, slope=task.slope, mu=task.mu, restitution=task.restitution, **law),
        start=start,
        duration=task.duration,
        contact=contact,
    )


def sample_motion(scenario: Scenario, spacing: float = SPACING) -> States:
    """Simulate a motion and sample it from 0 to its end, with this time between two states [s]."""
    motion = simulate(scenario)
    t = np.minimum(np.arange(0.0, motion.duration + 0.5 * spacing, spacing), motion.duration)
    at = motion.at(t)
    return States(t, at.x, at.height, at.angle, at.vx, at.vy, at.omega)


def run(task: Task, dt: float) -> States:
    """Run a task with rigid contact."""
    return sample_motion(scenario_of(task), max(dt, SPACING))
