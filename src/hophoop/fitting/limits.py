"""One-sided limits of parameters at an end of their range, and of friction that was not seen to slip."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hophoop.fitting.channels import Values
from hophoop.fitting.guess import COST
from hophoop.fitting.parameters import parts_of
from hophoop.fitting.problem import Problem
from hophoop.fitting.solving import CONFIDENT, Minimum, Solution, approach, changed, minimize, solve, unobserved

if TYPE_CHECKING:
    from lmfit import Parameters

AGREES = 4.0  # rise of the sum of squares at an end of a range that the data agree with: two standard deviations
NEAR = 9.0  # rise at an end that is near: three standard deviations
ASIDE = (-3.0, 3.0)  # distances of the sum of squares that errors are compared with [standard deviations]
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
    """Return a solution with the limits of the wanted parameters that it does not determine."""
    problem = solution.problem
    gone = unobserved(problem.motions(solution.minimum.values)) & set(solution.minimum.blind)
    solution, limits = one_sided_limits(solution, [name for name in wanted if name not in gone])
    limits |= {name: NOT_SEEN for name in wanted if name in gone or name not in (*solution.free, *limits)}
    return covering(solution) if any(piece.channel.name == "omega" for piece in problem.pieces) else solution, limits


def one_sided_limits(solution: Solution, names: Sequence[str]) -> tuple[Solution, Limits]:
    """Find limits of parameters that may be at an end of their range, and their effect on the others.

    The slopes at the minimum do not suffice: the sum of squares may be steep at the minimum and flat towards the end.

    names: parameters that may have a limit: free ones, and ones without effect at the minimum; result: the minimum with the
    limited parameters at the end of their range. The covariance of the others includes their change up to the limit. Within
    three standard deviations of an end, the standard deviation is at least that of the sum of squares there; limits: the sign
    and the limit at 95 % of each parameter; no sign and nan where the data agree with both ends [its unit].
    """
    limits: Limits = {}
    changes: list[Values] = []
    for name in names:
        here, spread = solution.minimum, solution.spread
        near = _ends(solution, name)
        agreed = [end for end in near if end.found.cost - here.cost <= AGREES * spread]
        if len(agreed) == 1:
            (end,) = agreed
            value, values = _limit(solution, name, end)
            limits[name] = end.sign, value
            solution = solve(solution.problem, changed(solution.params, end.found.values, [name, *end.found.blind]))
            now, size = solution.minimum.values, np.sqrt(CONFIDENT * spread)
            changes.append({other: (values[other] - now[other]) / size for other in solution.free})
        elif agreed or name not in solution.free:
            limits[name] = NOT_SEEN
            solution = solution.without(name)
        for end in near if not agreed else ():
            size = np.sqrt((end.found.cost - here.cost) / spread)  # distance to the end in standard deviations
            solution = solution.with_error(name, abs(end.value - here.values[name]) / size)
    covariance = solution.covariance.copy()
    for change in changes:
        own = np.array([change.get(name, 0.0) for name in solution.free])
        covariance += np.outer(own, own)
    return solution._replace(covariance=covariance), limits


def covering(solution: Solution) -> Solution:
    """Return a solution with standard deviations of at least those that the sum of squares has further away.

    The sum of squares of an angular velocity is a staircase: an impact that passes a measured value is a step. So its slopes at
    the minimum do not suffice, and each parameter of the contact is held on both sides.
    """
    here, result = solution.minimum, solution
    for name, value, values in solution.beside(ASIDE):
        other = approach(solution.problem, changed(solution.params, values | {name: value}, [name]))
        away = np.sqrt(max((other.cost - here.cost) / solution.spread, 1.0))  # [standard deviations]
        for one in solution.free:
            result = result.with_error(one, abs(other.values[one] - here.values[one]) / away)
    return result


def _ends(solution: Solution, name: str) -> list[End]:
    """Return the ends of a parameter's range that are near by the sum of squares."""
    problem, params, cost = solution.problem, solution.params, solution.minimum.cost
    result = []
    for sign, end in (("≤", params[name].min), ("≥", params[name].max)):
        if not np.isfinite(end):
            continue
        starts = [changed(params, values | {name: end}, [name]) for values in ({}, solution.values_at(name, end))]
        costs = [problem.cost(one.valuesdict()) for one in starts]
        if min(costs) - cost > problem.count:
            continue  # too far: fitting the others does not help
        found = approach(problem, starts[int(np.argmin(costs))])
        if found.cost - cost <= NEAR * solution.spread:
            result.append(End(sign, end, found))
    return result


def _limit(solution: Solution, name: str, end: End) -> tuple[float, Values]:
    """Return the limit of a parameter from an end of its range, and all values there."""
    params, begin = solution.params, min(solution.minimum, end.found, key=COST)
    low, high = params[name].min, params[name].max
    step, last = 0.01 * min(high - low, 1.0), high if end.value == low else low
    return _reach(
        solution.problem,
        changed(params, begin.values),
        lambda value: {name: value},
        (begin.values[name], last),
        step if last == high else -step,
        begin.cost + CONFIDENT * solution.spread,
    )


def _reach(
    problem: Problem,
    params: Parameters,
    hold: Callable[[float], Values],
    ends: tuple[float, float],
    step: float,
    allowed: float,
) -> tuple[float, Values]:
    """Go as far as the allowed sum of squares permits, with the other parameters fitted.

    hold: parameters that a place fixes; ends: the first place and the last possible one.
    """
    near, values, far = ends[0], params.valuesdict(), np.nan
    for _ in range(STEPS):
        place = float(np.clip(near + step, min(ends), max(ends)))
        fixed = hold(place)
        there = minimize(problem, changed(params, values | fixed, fixed))
        if there.cost > allowed:
            far, step = place, 0.5 * (place - near)
        else:
            near, values, step = place, there.values, 0.5 * (far - place) if np.isfinite(far) else 2.0 * step
        if near == ends[1] or abs(step) < FINE * abs(near - ends[0]):
            break
    return near, values


def least_friction(params: Parameters, solution: Solution, needed: float) -> float:
    """Return the minimum static friction at 95 % of a hoop that was not seen to slip.

    params: with friction free; solution: a motion that never slips; needed: friction required by this motion [1]; friction: a
    little less than required, since very short slip cannot be detected [1].
    """
    parts = parts_of("mu_static")
    given = sum(params[name].value for name in parts if not params[name].vary)
    name, *others = (name for name in parts if params[name].vary)

    def hold(friction: float) -> Values:
        return {name: max(friction - given, 0.0)} | dict.fromkeys(others, 0.0)

    allowed = solution.minimum.cost + CONFIDENT * solution.spread
    return _reach(solution.problem, solution.params, hold, (needed, 0.0), -0.02 * needed, allowed)[0]
