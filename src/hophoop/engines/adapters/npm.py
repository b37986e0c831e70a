"""Engines of the npm registry: commands for Node, which read the task as JSON and write the record as CSV."""

from __future__ import annotations

import os
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any

FOLDER = "HOPHOOP_NPM"  # environment variable with the folder of node_modules


@dataclass(frozen=True)
class NodeEngine:
    """An engine that runs in Node.

    Attributes
    ----------
    package : str
        Name in the npm registry.
    script : str
        The adapter's file.
    title, model, contact : str
        As in `Engine`.
    step : float
        The manual's time step [s].
    settings : dict
        Sets of settings by name.
    """

    package: str
    script: str
    title: str
    step: float
    model: str
    contact: str
    settings: dict[str, dict[str, Any]]

    def command(self) -> list[str]:
        """The command that runs it."""
        return ["node", str(files("hophoop.engines.adapters").joinpath(self.script))]


def npm_folder() -> Path:
    """Return the folder whose node_modules has the engines: that of the environment variable, or the present one."""
    return Path(os.environ.get(FOLDER, "."))


NODE_ENGINES = {
    "rapier": NodeEngine(
        "@dimforge/rapier2d-compat",
        "rapier.mjs",
        "Rapier 2D",
        1.0 / 60.0,
        "2D, single precision; ball of radius R whose centre lies off the body's centre of gravity, on a half space",
        "Velocities by small steps with soft contacts (“TGS soft”): each step is cut into as many as there are solver "
        "iterations, and a contact is a damped spring of a given frequency.",
        {"default": {}, "tuned": {"frequency": 1000, "allowed": 1e-5, "prediction": 1e-4}},
    ),
    "planck": NodeEngine(
        "planck",
        "planck.mjs",
        "Planck",
        1.0 / 60.0,
        "2D; circle of radius R whose centre lies off the body's centre of gravity, on an edge",
        "Box2D's sequential impulses with warm start, friction before the normal impulse; overlap is moved away.",
        {"default": {}, "tuned": {"velocityIterations": 11, "linearSlop": 1e-4, "velocityThreshold": 0.0}},
    ),
    "matter": NodeEngine(
        "matter-js",
        "matter.mjs",
        "Matter",
        1.0 / 60.0,
        "2D; regular polygon in place of the circle, which the engine does not have: 26 sides (default) or 200 (tuned)",
        "Impulses one after another with friction bounded by a multiple of the overlap or of the last normal impulse, "
        "and a separate correction of positions.",
        {"default": {}, "tuned": {"sides": 200, "slop": 0.0005}},
    ),
    "jolt": NodeEngine(
        "jolt-physics",
        "jolt.mjs",
        "Jolt",
        1.0 / 60.0,
        "3D, single precision, kept to a plane by its degrees of freedom; sphere of radius R on a box",
        "Sequential impulses with warm start, friction before the normal impulse; overlap beyond the slop is moved away.",
        {"default": {}, "tuned": {"velocitySteps": 11, "positionSteps": 10, "slop": 1e-4, "minVelocity": 0.0}},
    ),
}
