"""Derivatives of the residuals by the parameters: exact through all events, where they exist."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import SimpleNamespace

import numpy as np
from numpy.typing import NDArray

from hophoop.derivatives.results.propagation import propagate
from hophoop.fitting.parameters import PATHS, spec
from hophoop.fitting.problem import Problem, Run

Floats = NDArray[np.float64]

FIELDS = ("x", "height", "angle", "omega")
STEP = 1e-6  # along the derivatives of the state; the data are nearly linear in it


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
    """Columns of one run; the motion does not change with the parameters of camera and marker."""
    motion = run.motion(values)
    times = run.moments(motion, values)
    here, paths = motion.at(times), tuple(dict.fromkeys(path for name in names for path in PATHS.get(name, ())))
    rated = propagate(motion, paths).at_times(times, FIELDS) if paths else {}
    result = np.zeros((run.count, len(names)))
    for k, name in enumerate(names):
        change = {
            field: sum(rates[:, paths.index(path)] for path in PATHS.get(name, ())) for field, (_, rates) in rated.items()
        }
        step, ends = STEP if name in PATHS else spec(name).step, []
        for side in (step, -step):
            other = {**values, name: values[name] + side}
            if name in PATHS:
                moved = SimpleNamespace(**{field: getattr(here, field) + side * change[field] for field in FIELDS})
                ends.append(run.distances(run.seen(moved, other), other))
            else:
                ends.append(run.distances(run.places(motion, other), other))
        result[:, k] = (ends[0] - ends[1]) / (2.0 * step)
        if not all(np.isfinite(rates).all() for rates in change.values()):
            result[:, k] = np.nan
    return result
