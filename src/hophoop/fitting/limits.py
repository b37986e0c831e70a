"""What is known on one side only: how far a parameter may be from the end of its range, or from what rolling needs."""

from __future__ import annotations

import numpy as np

from hophoop.fitting.problem import Problem
from hophoop.fitting.solving import CONFIDENT, FIRST_CALLS, Choice, Solution, solve

AT_END = 0.02  # so near to an end of its range, in standard deviations or the range, a parameter is at it
STEPS = 12  # of a search for a limit


def at_end(choice: Choice, solution: Solution, name: str) -> int:
    """Whether a free parameter has come to an end of its range: −1 the lower, 1 the upper, 0 neither."""
    low, high = choice.limits(name)
    value = solution.values[name]
    error = float(np.sqrt(max(solution.covariance[solution.free.index(name), solution.free.index(name)], 0.0)))
    if not np.isfinite(error):
        error = 0.0
    near = max(AT_END * error, 1e-4 * (high - low) if np.isfinite(high - low) else 0.0)
    return -1 if value - low < near else 1 if high - value < near else 0


def one_sided(problem: Problem, choice: Choice, solution: Solution, name: str, side: int, soft: bool) -> float:
    """How far a parameter that is at the end of its range may be from it, at 95 %, the others adapting.

    Parameters
    ----------
    problem : Problem
    choice : Choice
    solution : Solution
        With the parameter at the end of its range.
    name : str
    side : {-1, 1}
        At which end it is.
    soft : bool

    Returns
    -------
    limit : float
        In the parameter's own unit [1].
    """
    low, high = choice.limits(name)
    end = low if side < 0 else high
    near, far, step = end, None, 0.01 * min(high - low, 1.0)
    for _ in range(STEPS):
        value = float(np.clip(near - side * step, low, high))
        cost = solve(problem, choice.at(solution.values).without(name, value), soft, FIRST_CALLS).cost
        if cost - solution.cost > CONFIDENT:
            far, step = value, 0.5 * abs(value - near)
        else:
            near, step = value, (2.0 * step if far is None else 0.5 * abs(far - value))
        if value in (low, high) and value != end and far is None:
            break
    return near


def least_friction(problem: Problem, choice: Choice, solution: Solution, needed: float, soft: bool) -> float:
    """The least static friction with which the data agree, of a hoop that was not seen to slip, at 95 %.

    Parameters
    ----------
    problem : Problem
    choice : Choice
        What was free, friction included.
    solution : Solution
        A motion that never slips.
    needed : float
        Friction that this motion needs [1].
    soft : bool

    Returns
    -------
    friction : float
        A little less than needed: slip that is too short is not seen [1].
    """
    scale = max(1.0, solution.cost / max(problem.count - len(solution.free), 1))
    near, far, step = needed, 0.0, 0.02 * needed
    for _ in range(STEPS):
        value = max(near - step, 0.5 * (near + far))
        held = {"mu_kinetic": value, "mu_excess": 0.0}
        if "mu_kinetic" not in choice.free:
            held = {"mu_excess": max(value - choice.values["mu_kinetic"], 0.0)}
        elif "mu_excess" not in choice.free:
            held = {"mu_kinetic": max(value - choice.values["mu_excess"], 0.0)}
        fixed = choice.at(solution.values)
        for name, number in held.items():
            fixed = fixed.without(name, number)
        for name in set(fixed.free) - set(solution.free):
            fixed = fixed.without(name, solution.values[name])
        if solve(problem, fixed, soft, FIRST_CALLS).cost - solution.cost > CONFIDENT * scale:
            far = value
        else:
            near, step = value, 2.0 * step
    return near
