"""One-sided limits of parameters at an end of their range, and of friction that was not seen to slip."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hophoop.fitting.channels import Values
from hophoop.fitting.guess import COST
from hophoop.fitting.parameters import parts_of
from hophoop.fitting.solving import CONFIDENT, Minimum, Solution, changed, minimize, solve, unobserved
from hophoop.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from lmfit import Parameters

AGREES = 4.0  # rise of the sum of squares at an end of a range that the data agree with: two standard deviations
NEAR = 9.0  # rise to what is near: three standard deviations
EQUAL = 2.0  # two minima of equal sums of squares have a variance, about one of them, of half the square of their distance
STEPS = 12  # of a search for a limit
FINE = 0.01  # accuracy of a limit, over its distance from the end
NOT_SEEN = ("", float("nan"))

Limits = dict[str, tuple[str, float]]


class End(NamedTuple):
    """The minimum with a parameter at an end of its range."""

    sign: str  # of a limit: '≤' from the lower end, '≥' from the upper
    value: float
    found: Minimum


def with_limits(solution: Solution, wanted: Sequence[str]) -> tuple[Solution, Limits]:
    """Find limits of the wanted parameters that a solution does not determine, and their effect on the others.

    The slopes at the minimum do not suffice: the sum of squares may be steep at the minimum and flat towards the end.

    result: the minimum with the limited parameters at the end of their range. The covariance of the others includes their
    change up to the limit. Within three standard deviations of an end, the standard deviation is at least that of the sum of
    squares there; limits: the sign and the limit at 95 % of each parameter; no sign and nan where the data agree with both
    ends, or do not show it [its unit].
    """
    gone = unobserved(solution.problem.motions(solution.minimum.values)) - set(solution.free)
    limits: Limits = {}
    aside = solution.aside
    changes: list[Values] = []
    for name in wanted:
        if name in gone:
            continue
        here, spread = solution.minimum, solution.spread
        near = _ends(solution, name)
        agreed = [end for end in near if end.found.cost - here.cost <= AGREES * spread]
        if len(agreed) == 1:
            (end,) = agreed
            value, values = _limit(solution, name, end)
            limits[name] = end.sign, value
            solution = solve(solution.problem, changed(solution.params, end.found.values, [name]))
            now, size = solution.minimum.values, np.sqrt(CONFIDENT * spread)
            changes.append({other: (values[other] - now[other]) / size for other in solution.free})
        elif agreed or name not in solution.free:
            limits[name] = NOT_SEEN
            solution = solution.without(name)
        else:
            for end in near:
                size = np.sqrt((end.found.cost - here.cost) / spread)  # distance to the end in standard deviations
                solution = solution.with_error(name, abs(end.value - here.values[name]) / size)
    limits |= {name: NOT_SEEN for name in wanted if name not in (*solution.free, *limits)}
    for change in changes:
        own = np.array([change.get(name, 0.0) for name in solution.free])
        solution = solution._replace(covariance=solution.covariance + np.outer(own, own))
    return with_least_errors(solution, aside), limits


def with_least_errors(solution: Solution, aside: Sequence[Minimum]) -> Solution:
    """Return a solution with standard deviations of at least those that minima aside from it show.

    The sum of squares of an angular velocity is a staircase: an impact that passes a measured value is a step. So its slopes at
    the minimum do not suffice, and another motion may explain the data nearly as well.
    """
    here = solution.minimum
    for other in aside:
        rise = (other.cost - here.cost) / solution.spread
        for name in solution.free if rise <= NEAR else ():
            away = np.sqrt(max(rise, EQUAL))  # [standard deviations]
            solution = solution.with_error(name, abs(other.values[name] - here.values[name]) / away)
    return solution


def _ends(solution: Solution, name: str) -> list[End]:
    """Return the ends of a parameter's range that are near by the sum of squares."""
    problem, params, cost = solution.problem, solution.params, solution.minimum.cost
    result = []
    for sign, end in (("≤", params[name].min), ("≥", params[name].max)):
        if not np.isfinite(end):
            continue
        start = solution.held(params, name, end)
        if problem.cost(start.valuesdict()) - cost > problem.count:
            continue  # too far: fitting the others does not help
        found = minimize(problem, start)
        if found.cost - cost <= NEAR * solution.spread:
            result.append(End(sign, end, found))
    return result


def _limit(solution: Solution, name: str, end: End) -> tuple[float, Values]:
    """Return the limit of a parameter from an end of its range, and all values there."""
    one, begin = solution.params[name], min(solution.minimum, end.found, key=COST)
    return _reach(solution, begin, name, one.max if end.value == one.min else one.min, 0.01 * min(one.max - one.min, 1.0))


def _reach(solution: Solution, begin: Minimum, name: str, end: float, step: float) -> tuple[float, Values]:
    """Move a parameter from a minimum towards an end as far as the sum of squares permits, with the others fitted.

    step: the first one.
    """
    allowed = begin.cost + CONFIDENT * solution.spread
    values, start, far = begin.values, begin.values[name], np.nan
    near, step = start, float(np.copysign(step, end - start))
    for _ in range(STEPS):
        place = float(np.clip(near + step, min(start, end), max(start, end)))
        there = minimize(solution.problem, changed(solution.params, values | {name: place}, [name]))
        if there.cost > allowed:
            far, step = place, 0.5 * (place - near)
        else:
            near, values, step = place, there.values, 0.5 * (far - place) if np.isfinite(far) else 2.0 * step
        if near == end or abs(step) < FINE * abs(near - start):
            break
    return near, values


def least_friction(params: Parameters, solution: Solution) -> float:
    """Return the minimum static friction at 95 % of a hoop that was not seen to slip.

    params: with friction free; solution: motions that never slip; friction: that required by them, or a little less, since very
    short slip cannot be detected [1].
    """
    needed = max(least_static_friction(motion) for motion in solution.problem.motions(solution.minimum.values))
    if any(one.expr for one in params.values()):
        return needed
    parts = [params[name] for name in parts_of("mu_static")]
    given: float = sum(one.value for one in parts if not one.vary)
    name, *others = (one.name for one in parts if one.vary)
    begin = changed(solution.minimum.params, {name: max(needed - given, 0.0)} | dict.fromkeys(others, 0.0))
    minimum = solution.minimum._replace(params=begin)
    return given + _reach(solution._replace(minimum=minimum), minimum, name, 0.0, 0.02 * needed)[0]


def least_static_friction(motion: Trajectory, points: int = 2000) -> float:
    """Return the maximum of abs(F)/N while the hoop rolls, the friction that it needs at least."""
    state = motion.at(motion.times(points))
    rolling = (state.mode == "R") & (state.normal_force > 0)
    if not rolling.any():
        return 0.0
    return float(np.max(np.abs(state.friction_force[rolling]) / state.normal_force[rolling]))
