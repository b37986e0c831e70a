"""One-sided limits of parameters at an end of their range, and of friction that was not seen to slip."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from hophoop.fitting.problem import Problem
from hophoop.fitting.solving import (
    CONFIDENT,
    Choice,
    Minimum,
    Solution,
    approach,
    complete,
    cost_at,
    minimize,
    solve,
    spread_of,
)
from hophoop.simulation.trajectory import Trajectory

AGREES = 4.0  # rise of the sum of squares at an end of a range that the data agree with: two standard deviations
NEAR = 9.0  # rise at an end that is near: three standard deviations
STEPS = 12  # of a search for a limit
FINE = 0.01  # accuracy of a limit, over its distance from the end
NOT_SEEN = ("", float("nan"))


class End(NamedTuple):
    """The minimum with a parameter at an end of its range."""

    side: int  # −1 the lower end, 1 the upper
    found: Minimum
    blind: list[str]  # parameters without effect there


def unobserved(motion: Trajectory) -> set[str]:
    """Return parameters of the contact that a motion does not determine: friction without slip, restitution without impact."""
    slips = {"S", "K"} & set(motion.sequence)
    lands = motion.find("impact") or motion.find("bounce_limit")  # bounces too small to count end at once
    return (set() if slips else {"mu_kinetic", "mu_excess"}) | (set() if lands else {"restitution"})


def one_sided_limits(
    problem: Problem, choice: Choice, solution: Solution, names: Sequence[str], robust: bool
) -> tuple[Solution, dict[str, tuple[str, float]]]:
    """Find limits of parameters that may be at an end of their range, and their effect on the others.

    The slopes at the minimum do not suffice: the sum of squares may be steep at the minimum and flat towards the end.

    solution: the minimum of `choice`; names: parameters that may have a limit: free ones, and ones without effect at the
    minimum; result: the minimum with the limited parameters at the end of their range. The covariance of the others includes
    their change up to the limit. Within three standard deviations of an end, the standard deviation is at least that of the sum
    of squares there; limits: the sign and the limit at 95 % of each parameter; no sign and nan where the data agree with both
    ends [its unit].
    """
    limits, changes = {}, []
    for name in names:
        spread = spread_of(problem, solution.cost, len(solution.free))
        near = _ends(problem, choice, solution, name, robust)
        agreed = [end for end in near if end.found.cost - solution.cost <= AGREES * spread]
        if len(agreed) == 1:
            ((side, found, blind),) = agreed
            begin = min((solution.values, solution.cost), (found.values, found.cost), key=lambda one: one[1])
            allowed = begin[1] + CONFIDENT * spread
            step = 0.01 * min(np.subtract(*choice.limits(name)[::-1]), 1.0)
            values = _reach(problem, choice.at(begin[0]), name, -side * step, allowed, robust)
            limits[name] = ("≤" if side < 0 else "≥", values[name])
            free = tuple(other for other in solution.free if other != name and other not in blind)
            solution = solve(problem, choice.at(found.values).only(free), robust)
            changes.append({other: (values[other] - solution.values[other]) / np.sqrt(CONFIDENT * spread) for other in free})
        elif agreed or name not in solution.free:
            limits[name] = NOT_SEEN
            solution = solution.without(name)
        for end in near if not agreed else ():
            size = np.sqrt((end.found.cost - solution.cost) / spread)  # distance to the end in standard deviations
            solution = solution.with_error(name, abs(end.found.values[name] - solution.values[name]) / size)
        choice = choice.at(solution.values).only(solution.free)
    covariance = solution.covariance.copy()
    for one in changes:
        own = np.array([one.get(name, 0.0) for name in solution.free])
        covariance += np.outer(own, own)
    return solution._replace(covariance=covariance), limits


def _ends(problem: Problem, choice: Choice, solution: Solution, name: str, robust: bool) -> list[End]:
    """Return the ends of a parameter's range that are near by the sum of squares."""
    result = []
    for side, end in zip((-1, 1), choice.limits(name), strict=True):
        if not np.isfinite(end):
            continue
        held = choice.at(solution.values).without(name, end)
        starts = [held.values, _values_at(choice, solution, name, end)]
        costs = [cost_at(problem, complete(held, values), robust) for values in starts]
        if min(costs) - solution.cost > problem.count:
            continue  # too far: fitting the others does not help
        found, blind = approach(problem, held.at(starts[int(np.argmin(costs))]), robust)
        if found.cost - solution.cost <= NEAR * spread_of(problem, solution.cost, len(solution.free)):
            result.append(End(side, found, blind))
    return result


def _values_at(choice: Choice, solution: Solution, name: str, end: float) -> dict[str, float]:
    """Return values with one at the end of its range and the others by linear regression."""
    values = {**solution.values, name: end}
    if name not in solution.free or not np.isfinite(solution.covariance).all():
        return values
    along = solution.covariance[solution.free.index(name)]
    for other, change in zip(solution.free, along / along[solution.free.index(name)], strict=True):
        if other != name:
            moved = values[other] + change * (end - solution.values[name])
            values[other] = float(np.clip(moved, *choice.limits(other)))
    return values


def _reach(problem: Problem, choice: Choice, name: str, step: float, allowed: float, robust: bool) -> dict[str, float]:
    """Return the values with one as far away as the allowed sum of squares permits, the others fitted."""
    near, far = dict(choice.values), None
    begin = near[name]
    for _ in range(STEPS):
        value = float(np.clip(near[name] + step, *choice.limits(name)))
        there = minimize(problem, choice.at(near).without(name, value), robust)
        if there.cost > allowed:
            far, step = value, 0.5 * (value - near[name])
        else:
            near, step = there.values, (2.0 * step if far is None else 0.5 * (far - value))
        if (far is None and value in choice.limits(name)) or (far is not None and abs(step) < FINE * abs(near[name] - begin)):
            break
    return near


def least_friction(problem: Problem, choice: Choice, solution: Solution, needed: float, robust: bool) -> float:
    """Return the minimum static friction at 95 % of a hoop that was not seen to slip.

    choice: the choice with friction free; solution: a motion that never slips; needed: friction required by this motion [1];
    friction: a little less than required, since very short slip cannot be detected [1].
    """
    scale = spread_of(problem, solution.cost, len(solution.free))
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
        if minimize(problem, fixed, robust).cost - solution.cost > CONFIDENT * scale:
            far = value
        else:
            near, step = value, 2.0 * step
    return near
