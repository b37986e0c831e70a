"""One-sided limits of parameters at an end of their range, and of friction that was not seen to slip."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hophoop.fitting.guess import SPREADS
from hophoop.fitting.problem import Problem
from hophoop.fitting.solving import (
    CONFIDENT,
    Minimum,
    Solution,
    approach,
    changed,
    cost_of,
    free_of,
    held,
    minimize,
    solve,
    spread_of,
)
from hophoop.simulation.trajectory import Trajectory

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

    side: int  # −1 the lower end, 1 the upper
    found: Minimum
    blind: list[str]  # parameters without effect there


def unobserved(motions: Sequence[Trajectory]) -> set[str]:
    """Return parameters of the contact that motions do not determine: friction without slip, restitution without impact."""
    slips = any({"S", "K"} & set(motion.sequence) for motion in motions)
    # bounces too small to count end at once
    lands = any(motion.find("impact") or motion.find("bounce_limit") for motion in motions)
    return (set() if slips else {"mu_kinetic", "mu_excess"}) | (set() if lands else {"restitution"})


def with_limits(
    problem: Problem, solution: Solution, wanted: Sequence[str], blind: Sequence[str], robust: bool
) -> tuple[Solution, Limits, list[Trajectory]]:
    """Return a solution with the limits of the wanted parameters that it does not determine, and its motions.

    blind: parameters without effect at the minimum.
    """
    gone = unobserved(problem.motions(solution.minimum.values)) & set(blind)
    solution, limits = one_sided_limits(problem, solution, [name for name in wanted if name not in gone], robust)
    limits |= {name: NOT_SEEN for name in wanted if name in gone or name not in (*solution.free, *limits)}
    if any(piece.channel.name == "omega" for piece in problem.pieces):
        solution = covering(problem, solution, robust)
    return solution, limits, problem.motions(solution.minimum.values)


def one_sided_limits(problem: Problem, solution: Solution, names: Sequence[str], robust: bool) -> tuple[Solution, Limits]:
    """Find limits of parameters that may be at an end of their range, and their effect on the others.

    The slopes at the minimum do not suffice: the sum of squares may be steep at the minimum and flat towards the end.

    names: parameters that may have a limit: free ones, and ones without effect at the minimum; result: the minimum with the
    limited parameters at the end of their range. The covariance of the others includes their change up to the limit. Within
    three standard deviations of an end, the standard deviation is at least that of the sum of squares there; limits: the sign
    and the limit at 95 % of each parameter; no sign and nan where the data agree with both ends [its unit].
    """
    limits, changes = {}, []
    for name in names:
        params, cost = changed(solution.minimum.params, {}, solution.free), solution.minimum.cost
        spread = spread_of(problem, cost, len(solution.free))
        near = _ends(problem, params, solution, name, robust)
        agreed = [end for end in near if end.found.cost - cost <= AGREES * spread]
        if len(agreed) == 1:
            ((side, found, blind),) = agreed
            begin = min(solution.minimum, found, key=lambda one: one.cost)
            step, end = 0.01 * min(params[name].max - params[name].min, 1.0), params[name].max if side < 0 else params[name].min
            value, values = _reach(
                problem,
                changed(params, begin.values),
                partial(_alone, name),
                (begin.values[name], end),
                -side * step,
                begin.cost + CONFIDENT * spread,
                robust,
            )
            limits[name] = ("≤" if side < 0 else "≥", value)
            free = [other for other in solution.free if other != name and other not in blind]
            solution = solve(problem, changed(params, found.values, free), robust)
            now, size = solution.minimum.values, np.sqrt(CONFIDENT * spread)
            changes.append({other: (values[other] - now[other]) / size for other in free})
        elif agreed or name not in solution.free:
            limits[name] = NOT_SEEN
            solution = solution.without(name)
        for one in near if not agreed else ():
            size = np.sqrt((one.found.cost - cost) / spread)  # distance to the end in standard deviations
            solution = solution.with_error(name, abs(one.found.values[name] - solution.minimum.values[name]) / size)
    covariance = solution.covariance.copy()
    for change in changes:
        own = np.array([change.get(name, 0.0) for name in solution.free])
        covariance += np.outer(own, own)
    return solution._replace(covariance=covariance), limits


def covering(problem: Problem, solution: Solution, robust: bool) -> Solution:
    """Return a solution with standard deviations of at least those that the sum of squares has further away.

    The sum of squares of an angular velocity is a staircase: an impact that passes a measured value is a step. So its slopes at
    the minimum do not suffice, and each parameter of the contact is held on both sides.
    """
    params, here = changed(solution.minimum.params, {}, solution.free), solution.minimum
    spread, result = spread_of(problem, here.cost, len(solution.free)), solution
    for name in SPREADS:
        if name not in solution.free or not np.isfinite(solution.covariance).all():
            continue
        place = solution.free.index(name)
        for far in ASIDE:
            value = here.values[name] + far * float(np.sqrt(spread * solution.covariance[place, place]))
            value = float(np.clip(value, params[name].min, params[name].max))
            there = held(changed(params, solution.values_at(name, value)), {name: value})
            other, _ = approach(problem, there, robust)
            away = np.sqrt(max((other.cost - here.cost) / spread, 1.0))  # [standard deviations]
            for one in solution.free:
                result = result.with_error(one, abs(other.values[one] - here.values[one]) / away)
    return result


def _ends(problem: Problem, params: Parameters, solution: Solution, name: str, robust: bool) -> list[End]:
    """Return the ends of a parameter's range that are near by the sum of squares."""
    result = []
    cost = solution.minimum.cost
    for side, end in ((-1, params[name].min), (1, params[name].max)):
        if not np.isfinite(end):
            continue
        starts = [held(changed(params, values), {name: end}) for values in ({}, solution.values_at(name, end))]
        costs = [cost_of(problem, one, robust) for one in starts]
        if min(costs) - cost > problem.count:
            continue  # too far: fitting the others does not help
        found, blind = approach(problem, starts[int(np.argmin(costs))], robust)
        if found.cost - cost <= NEAR * spread_of(problem, cost, len(solution.free)):
            result.append(End(side, found, blind))
    return result


def _alone(name: str, value: float) -> dict[str, float]:
    return {name: value}


def _reach(
    problem: Problem,
    params: Parameters,
    hold: Callable[[float], dict[str, float]],
    ends: tuple[float, float],
    step: float,
    allowed: float,
    robust: bool,
) -> tuple[float, dict[str, float]]:
    """Go as far as the allowed sum of squares permits, with the other parameters fitted.

    hold: parameters that a place fixes; ends: the first place and the last possible one.
    """
    near, values, far = ends[0], params.valuesdict(), np.nan
    for _ in range(STEPS):
        place = float(np.clip(near + step, min(ends), max(ends)))
        there = minimize(problem, held(changed(params, values), hold(place)), robust)
        if there.cost > allowed:
            far, step = place, 0.5 * (place - near)
        else:
            near, values, step = place, there.values, 0.5 * (far - place) if np.isfinite(far) else 2.0 * step
        if near == ends[1] or abs(step) < FINE * abs(near - ends[0]):
            break
    return near, values


def least_friction(problem: Problem, params: Parameters, solution: Solution, needed: float, robust: bool) -> float:
    """Return the minimum static friction at 95 % of a hoop that was not seen to slip.

    params: with friction free; solution: a motion that never slips; needed: friction required by this motion [1]; friction: a
    little less than required, since very short slip cannot be detected [1].
    """
    minimum, free = solution.minimum, free_of(params)

    def hold(friction: float) -> dict[str, float]:
        if {"mu_kinetic", "mu_excess"} <= set(free):
            return {"mu_kinetic": friction, "mu_excess": 0.0}
        name, other = ("mu_excess", "mu_kinetic") if "mu_excess" in free else ("mu_kinetic", "mu_excess")
        return {name: max(friction - params[other].value, 0.0)}

    allowed = minimum.cost + CONFIDENT * spread_of(problem, minimum.cost, len(solution.free))
    first = changed(minimum.params, {}, solution.free)
    return _reach(problem, first, hold, (needed, 0.0), -0.02 * needed, allowed, robust)[0]
