"""Exact derivatives of the residuals by the parameters, through all events, where they exist."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from hophoop.derivatives.results.propagation import propagate
from hophoop.fitting.parameters import PATHS
from hophoop.fitting.problem import Problem, Run
from hophoop.simulation.trajectory import Trajectory

Floats = NDArray[np.float64]

SPOTS = ("x", "y", "marker_x", "marker_y")


def exact_slopes(problem: Problem, values: Mapping[str, float], names: Sequence[str]) -> Floats:
    """Return derivatives of the residuals by parameters.

    values: all of the problem's names; jacobian: shape (count, len(names)), a column is nan where there is no derivative: at a
    tangency, a boundary of classes, a limit of a range [1 over the parameter's unit].
    """
    blocks = []
    for run in problem.runs:
        own = {run.named(name): name for name in run.names}
        mine = [k for k, name in enumerate(names) if name in own]
        block = np.zeros((run.count, len(names)))
        block[:, mine] = _of_run(run, run.own(values), [own[names[k]] for k in mine])
        blocks.append(block)
    return np.concatenate(blocks)


def _of_run(run: Run, values: dict[str, float], names: list[str]) -> Floats:
    motion = run.motion(values)
    measured = run.count - len(run.priors)
    result = np.zeros((run.count, len(names)))
    moved = [k for k, name in enumerate(names) if name in PATHS]
    if moved:
        result[:measured, moved] = _of_motion(run, motion, values, [PATHS[names[k]] for k in moved])
    other = [k for k in range(len(names)) if k not in moved]
    if other:
        places = run.places(motion, values)
        for k in other:
            result[:measured, k] = _of_camera(run, motion, values, places, names[k])
    for row, (name, prior) in enumerate(run.priors.items(), measured):
        if name in names:
            result[row, names.index(name)] = -1.0 / prior.error
    return result


def _of_motion(run: Run, motion: Trajectory, values: dict[str, float], groups: list[tuple[str, ...]]) -> Floats:
    """Columns of parameters of the scenario, each a group of its numbers."""
    paths = tuple(dict.fromkeys(path for group in groups for path in group))
    rated = propagate(motion, paths).at_times(run.moments(motion, values), ("x", "height", "angle", "omega"))
    places = [[paths.index(path) for path in group] for group in groups]
    change = {
        field: np.stack([rates[:, of_group].sum(axis=1) for of_group in places], axis=-1) for field, (_, rates) in rated.items()
    }
    return _residual_changes(run, values, rated["angle"][0][:, None], change)


def _residual_changes(run: Run, values: dict[str, float], angle: Floats, change: Mapping[str, Floats]) -> Floats:
    """Derivatives of the residuals from those of position and angle."""
    reach = values["marker_ratio"] * run.radius
    marked = angle + values["marker_angle"]
    along, up = change["x"], change["height"]
    round_x, round_y = reach * np.cos(marked) * change["angle"], -reach * np.sin(marked) * change["angle"]
    cos, sin = values["scale"] * np.cos(values["tilt"]), values["scale"] * np.sin(values["tilt"])
    places = {
        "x": cos * along - sin * up,
        "y": sin * along + cos * up,
        "marker_x": cos * (along + round_x) - sin * (up + round_y),
        "marker_y": sin * (along + round_x) + cos * (up + round_y),
        "angle": change["angle"],
        "omega": change["omega"],
    }
    return _residuals(run, places)


def _of_camera(run: Run, motion: Trajectory, values: dict[str, float], places: dict[str, Floats], name: str) -> Floats:
    """Column of a parameter of camera or marker, from the formulas of `Run.places`; nan for others."""
    none, one = np.zeros(len(run.t)), np.ones(len(run.t))
    ground = values["origin_y"]
    change = dict.fromkeys(places, none)
    if name == "origin_y":
        change |= {"y": one, "marker_y": one}
    elif name == "scale":
        change |= {key: (places[key] - (ground if key.endswith("y") else 0.0)) / values["scale"] for key in SPOTS}
    elif name == "tilt":
        change |= {"x": ground - places["y"], "y": places["x"], "angle": -one}
        change |= {"marker_x": ground - places["marker_y"], "marker_y": places["marker_x"]}
    elif name == "marker_angle":  # the arrow to the marker turned clockwise by a right angle
        change |= {"marker_x": places["marker_y"] - places["y"], "marker_y": places["x"] - places["marker_x"], "angle": one}
    elif name == "marker_ratio":
        for axis in ("x", "y"):
            change[f"marker_{axis}"] = (places[f"marker_{axis}"] - places[axis]) / values["marker_ratio"]
    elif name == "omega_offset":
        change |= {"omega": one}
    elif name == "row_delay" and run.rows is not None:
        state = motion.at(run.moments(motion, values))
        rates = {"x": state.vx * run.rows, "height": state.vy * run.rows, "angle": state.omega * run.rows, "omega": none}
        return _residual_changes(run, values, state.angle, rates)
    else:
        change = dict.fromkeys(places, np.full(len(run.t), np.nan))
    return _residuals(run, change)


def _residuals(run: Run, change: Mapping[str, Floats]) -> Floats:
    """Derivatives of the residuals, which are data minus positions."""
    return np.concatenate([-(change[one.name][one.rows].T / one.errors).T for one in run.channels])
