"""Derivatives of the residuals by the parameters: exact through all events, where they exist."""

from __future__ import annotations

from collections.abc import Sequence
from types import SimpleNamespace

import numpy as np

from hophoop.derivatives.results.propagation import propagate
from hophoop.fitting.channels import Floats, Values
from hophoop.fitting.parameters import PARAMETERS, TIMED, ParameterSpec
from hophoop.fitting.problem import Problem, Run

FIELDS = ("x", "height", "angle", "omega")
NONE = ParameterSpec("", "")
STEP = 1e-6  # along the derivatives of the state; the data are nearly linear in it


def exact_slopes(problem: Problem, values: Values, names: Sequence[str]) -> Floats:
    """Return derivatives of the residuals by parameters.

    values: all of the problem's names; jacobian: shape (count, len(names)), a column is nan where there is no derivative: at a
    tangency, a boundary of classes, a limit of a range, of moments [1 over the parameter's unit].
    """
    blocks = []
    for run in problem.runs:
        own = {run.named(name): name for name in run.names}
        blocks.append(_of_run(run, run.own(values), [own.get(name, "") for name in names]))
    return np.concatenate(blocks)


def _of_run(run: Run, values: Values, names: list[str]) -> Floats:
    """Columns of one run: the data follow the changes of the state and of the camera, shape (count, len(names)).

    names: '' for parameters of other runs.
    """
    motion, specs = run.motion(values), [PARAMETERS.get(name, NONE) for name in names]
    times = run.moments(motion, values)
    here, changes = motion.at(times), {field: np.zeros((len(names), len(times))) for field in FIELDS}
    paths = tuple(dict.fromkeys(path for one in specs for path in one.paths))
    rated = propagate(motion, paths).at_times(times, FIELDS) if paths else {}
    for k, one in enumerate(specs):
        for path in one.paths:
            for field, change in changes.items():
                change[k] += rated[field][1][:, paths.index(path)]
    steps = np.array([[STEP if one.paths else one.step] for one in specs])

    def residuals(side: int) -> Floats:
        moved = {field: getattr(here, field) + side * steps * change for field, change in changes.items()}
        others = {name: values[name] + side * steps * (np.array(names)[:, None] == name) for name in values}
        return run.distances(run.seen(SimpleNamespace(**moved), others), others)

    result = (residuals(1) - residuals(-1)) / (2.0 * steps)
    known = np.all([np.isfinite(change).all(axis=1) for change in changes.values()], axis=0)
    return np.where(known & ~np.isin(names, TIMED), result.T, np.nan)
