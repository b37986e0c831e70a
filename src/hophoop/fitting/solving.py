"""Least squares of the exact motion against the data, by lmfit, from several starts."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import product
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hophoop._support.extras import need
from hophoop.fitting.channels import Floats, Values, rotation
from hophoop.fitting.covariance import covariance_of
from hophoop.fitting.guess import COST, SPREADS, Candidate, candidates
from hophoop.fitting.jacobian import exact_slopes
from hophoop.fitting.losses import SOFT, loss
from hophoop.fitting.parameters import spec
from hophoop.fitting.problem import Problem
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from lmfit import Parameters

FIRST_CALLS, MOST_CALLS = 12, 100  # maximum calls of the motion, in a first and in the last minimization
BLIND = 1e-3  # maximum rise of the sum of squares over the range of a parameter without effect
SHORTEST = 100  # numbers of a part of a record that is fitted for a start
ROUNDS = 4  # of other starts, while they help and the data are not explained
WORTH_TRYING = 4.0  # maximum factor of the cost of a start without slip
ASIDE = (-16.0, -8.0, -4.0, -2.0, 2.0, 4.0, 8.0, 16.0)  # distances at which other minima are looked for [standard deviations]
CONFIDENT = 2.71  # rise of the sum of squares at a one-sided limit of 95 %
ENOUGH = 1.0  # friction with which most motions never slip
EXPLAINED = 1.0  # robust cost over the number of data of a motion that explains them; scatter alone has about 0.9
BETTER = 1e-6  # fall of the cost to another minimum


class Minimum(NamedTuple):
    """A minimum without uncertainties."""

    params: Parameters
    cost: float  # sum of the squares, or the robust loss
    residuals: Floats  # [standard deviations]

    @property
    def values(self) -> Values:
        """All parameters [SI units]."""
        return dict(self.params.valuesdict())


class Solution(NamedTuple):
    """A minimum with the covariance of some of its parameters."""

    problem: Problem
    minimum: Minimum
    free: tuple[str, ...]
    covariance: Floats
    aside: tuple[
        Minimum, ...
    ] = ()  # with a parameter of the contact held away from the minimum, if the sum of squares has steps

    @property
    def params(self) -> Parameters:
        """The parameters, free where they have a covariance."""
        return changed(self.minimum.params, {}, set(self.minimum.params) - set(self.free))

    @property
    def spread(self) -> float:
        """Sum of squares over the degrees of freedom, at least 1 [1]."""
        return self.problem.spread(self.minimum.cost, len(self.free))

    def without(self, name: str) -> Solution:
        """Return the solution without the uncertainty of one parameter."""
        kept = [k for k, other in enumerate(self.free) if other != name]
        free = tuple(self.free[k] for k in kept)
        return self._replace(free=free, covariance=self.covariance[np.ix_(kept, kept)])

    def values_at(self, name: str, value: float) -> Values:
        """Return the values of the others by linear regression, with one at a value."""
        if name not in self.free or not np.isfinite(self.covariance).all():
            return {}
        values, place = self.minimum.values, self.free.index(name)
        changes = self.covariance[place] / self.covariance[place, place] * (value - values[name])
        return {other: values[other] + change for other, change in zip(self.free, changes.tolist(), strict=True)}

    def error(self, name: str) -> float:
        """Standard deviation of one parameter, larger where the motion does not explain the data [its unit]."""
        place = self.free.index(name)
        return float(np.sqrt(self.spread * self.covariance[place, place]))

    def with_error(self, name: str, least: float) -> Solution:
        """Return the solution with a minimum standard deviation of one parameter; correlations stay."""
        factors = np.ones(len(self.free))
        factors[self.free.index(name)] = max(1.0, least / self.error(name))
        return self._replace(covariance=self.covariance * np.outer(factors, factors))

    def held(self, params: Parameters, name: str, value: float) -> Parameters:
        """Return parameters with one held at a value, the others as they are or by regression, whichever costs less."""
        starts = [changed(params, self.minimum.values | {name: value}, [name])]
        starts.append(changed(starts[0], self.values_at(name, value) | {name: value}))
        return min(starts, key=lambda one: self.problem.cost(one.valuesdict()))


def parameters(
    values: Values,
    free: Sequence[str],
    bounds: Mapping[str, Sequence[float]] = {},
    tied: Mapping[str, str] = {},
) -> Parameters:
    """Return lmfit's parameters.

    values: start values of free parameters, values of the others; bounds: minimum and maximum; tied: expressions of others.
    """
    lmfit = need("lmfit", "fit")
    result = lmfit.Parameters()
    for name, value in values.items():
        low, high = bounds.get(name, (-np.inf, np.inf))
        low, high = max(low, spec(name).low), min(high, spec(name).high)
        # a value that is given is kept, also outside of the range of a fit
        ends = {"min": low, "max": high} if name in free else {}
        result.add(name, value, vary=name in free, **ends)
    for name, text in tied.items():
        kind = spec(name)
        try:
            result[name].set(expr=text)
            result.update_constraints()
            known = kind.low <= result[name].value <= kind.high and "open" not in text  # no files
        except RecursionError:
            raise InputError(f"tied parameters ({', '.join(tied)}) depend on each other in a circle.") from None
        except Exception:  # whatever an expression can do wrong
            known = False
        if not known:
            allowed = f"with a value from {kind.low:g} to {kind.high:g}"
            raise InputError(f"tied {name} = {text!r} is no expression of the other parameters {allowed}.")
    return result


def changed(params: Parameters, values: Values, fixed: Collection[str] = ()) -> Parameters:
    """Return a copy with other values, and with some of its free parameters fixed."""
    result = params.copy()
    for name, one in result.items():
        if one.expr is None:
            one.value = values.get(name, one.value)
            one.vary = one.vary and name not in fixed
    return result


def free_of(params: Parameters) -> tuple[str, ...]:
    """Return the names of the free parameters."""
    return tuple(name for name, one in params.items() if one.vary)


def minimize(problem: Problem, params: Parameters, most: int = FIRST_CALLS) -> Minimum:
    """Return one minimum.

    most: maximum number of calls of the motion [1].
    """
    tried: list[tuple[float, Values, Floats]] = []

    def residuals(params: Parameters) -> Floats:
        values = params.valuesdict()
        off = problem.residuals(values)
        tried.append((loss(off, problem.robust), values, off))
        return off

    if free_of(params):
        minimizer = need("lmfit", "fit").Minimizer(residuals, params, max_nfev=most)
        how = {"loss": "soft_l1" if problem.robust else "linear", "f_scale": SOFT, "Dfun": partial(slopes, problem)}
        with np.errstate(divide="ignore", invalid="ignore"):  # of its own covariance, which is not used
            minimizer.least_squares(**how)
    else:
        residuals(params)
    # the last call of a minimization that was stopped is not always its best
    cost, values, off = min(tried, key=itemgetter(0))
    return Minimum(changed(params, values), cost, off)


def solve(problem: Problem, params: Parameters) -> Solution:
    """Find one minimum, and the covariance of the parameters that have an effect there."""
    found, names = minimize(problem, params, MOST_CALLS), free_of(params)
    jacobian = slopes(problem, found.params)
    span = [min(params[name].max - params[name].min, 1.0) for name in names]
    seen = (jacobian**2).sum(axis=0) * np.square(span) >= BLIND
    covariance = covariance_of(problem, jacobian[:, seen], found.residuals)
    return Solution(problem, found, tuple(name for name, one in zip(names, seen, strict=True) if one), covariance)


def slopes(problem: Problem, params: Parameters) -> Floats:
    """Derivatives of the residuals by the free parameters, with those tied to them changing as well.

    They are exact where the motion has derivatives. Elsewhere they are differences, both ways if the limits allow.

    jacobian shape (count, number of free ones) [1 over the parameter's unit].
    """
    names = free_of(params)
    tied = tuple(name for name, one in params.items() if one.expr)
    try:
        jacobian = exact_slopes(problem, params.valuesdict(), (*names, *tied))
    except InputError:
        jacobian = np.full((problem.count, len(names) + len(tied)), np.nan)
    result = jacobian[:, : len(names)]
    if tied:
        together = _differences(params, names, lambda values: np.array([values[name] for name in tied]))
        result = result + jacobian[:, len(names) :] @ together
    missing = [k for k in range(len(names)) if not np.isfinite(result[:, k]).all()]
    if missing:
        result[:, missing] = _differences(params, [names[k] for k in missing], problem.residuals)
    return result


def _differences(params: Parameters, names: Sequence[str], of: Callable[[Values], Floats]) -> Floats:
    """Return derivatives by differences within the limits."""
    columns = []
    for name in names:
        one, here = params[name], params[name].value
        step = spec(name).step * max(1.0, abs(here))
        places = min(here + step, one.max), max(here - step, one.min)
        ends = []
        for value in places:
            one.value = value
            ends.append(of(params.valuesdict()))
        one.value = here
        columns.append((ends[0] - ends[1]) / (places[0] - places[1]))
    return np.column_stack(columns)


def of_rotation(problem: Problem) -> bool:
    """Return True if only angular velocities are measured."""
    return all(run.measured == {"omega"} for run in problem.runs)


def beginnings(problem: Problem, params: Parameters, most: int = FIRST_CALLS) -> list[Parameters]:
    """Return a start of a minimization, and of angular velocities alone also one from which the rotation fits.

    An angular velocity jumps at an impact, so the sum of squares has a step wherever an impact passes a measured value.
    """
    if not of_rotation(problem):
        return [params]
    runs = tuple(replace(run, channels=(rotation(run.channels[0], run.t),)) for run in problem.runs)
    there = params.copy()
    for run in runs:  # the rotation counts from the first value
        there[run.named("marker_angle")].set(-there[run.named("angle0")].value, vary=True)
    found = minimize(replace(problem, runs=runs), there, most).values
    return [params, changed(params, found | {name: params[name].value for name in params if name.startswith("marker_angle")})]


def lowest(problem: Problem, params: Parameters, starts: Sequence[Candidate]) -> Minimum:
    """Return the lowest of approximate minima from several starts."""
    found: list[Minimum] = []
    tried: set[str] = set()
    for start in starts:
        # another sequence may explain the data better, also if they are explained to their scatter
        if start.sequence not in tried or not any(_explains(problem, one) for one in found):
            found += [minimize(problem, one) for one in beginnings(problem, changed(params, start.values))]
            tried.add(start.sequence)
    return min(found, key=COST)


def _explains(problem: Problem, found: Minimum) -> bool:
    """Return True if the motion of a minimum explains the data."""
    return found.cost < EXPLAINED * problem.count


def best_of(problem: Problem, params: Parameters, starts: Sequence[Candidate]) -> Solution:
    """Find the lowest minimum from several starts."""
    best = lowest(problem, params, starts)
    for k in range(1, ROUNDS + 1):
        others = [minimize(problem, changed(params, values)) for values in _other_starts(problem, params, best, k)]
        before, best = best, min([best, *others], key=COST)
        if _explains(problem, best) or best.cost > 0.99 * before.cost:
            break
    last = solve(problem, changed(params, _without_slip(problem, params, best).values))
    for _ in range(ROUNDS if problem.jumps else 0):
        last = last._replace(aside=_asides(params, last))
        lower = min(last.aside, key=COST, default=last.minimum)
        if lower.cost > last.minimum.cost - BETTER:
            break
        last = solve(problem, changed(params, lower.values))
    return last


def _other_starts(problem: Problem, params: Parameters, best: Minimum, k: int) -> list[Values]:
    """Return other starts where a minimum does not explain one run, in round k: drawn around it, and that of a first half.

    The first half has fewer landings, which make the sum of squares rough.
    """
    if len(problem.runs) > 1 or _explains(problem, best):
        return []
    (run,) = problem.runs
    free = set(free_of(params))
    drawn = [one.values for one in candidates(run, best.values, free, seed=k)]
    half = run.until(0.5 * float(run.t[-1]))
    starts = candidates(half, best.values, free) if k == 1 and half.count > SHORTEST else []
    if starts:
        found = best_of(replace(problem, runs=(half,)), params, starts).minimum.values
        drawn += [found, found | {"mu_excess": best.values["mu_excess"]}]  # which shows where slip starts, perhaps later
    return drawn


def _asides(params: Parameters, last: Solution) -> tuple[Minimum, ...]:
    """Return minima with one parameter of the contact held at some distances from a minimum.

    An angular velocity jumps at an impact, so the sum of squares has a step wherever an impact passes a measured value, and
    small basins between the steps.
    """
    found = []
    for name, far in product(SPREADS, ASIDE) if np.isfinite(last.covariance).all() else ():
        if name in last.free:
            value = last.minimum.values[name] + far * last.error(name)
            found.append(minimize(last.problem, last.held(params, name, value)))
    return tuple(found)


def _without_slip(problem: Problem, params: Parameters, best: Minimum) -> Minimum:
    """Return a motion that never slips if the data agree with it as well as with the best one, else this."""
    friction, tied = params["mu_kinetic"], any(one.expr for one in params.values())
    if not friction.vary or tied or not slips(problem, best.values):
        return best
    for value in (ENOUGH, friction.max):
        start = changed(params, best.values | {"mu_kinetic": value})
        values = start.valuesdict()
        if problem.cost(values) < WORTH_TRYING * best.cost and not slips(problem, values):
            other = minimize(problem, start)
            alike = other.cost < best.cost + CONFIDENT * problem.spread(best.cost, len(free_of(params)))
            return other if alike and not slips(problem, other.values) else best
    return best


def slips(problem: Problem, values: Values) -> bool:
    """True if any run slips, or there is no motion."""
    try:
        return "mu_kinetic" not in unobserved(problem.motions(values))
    except InputError:
        return True


def unobserved(motions: Sequence[Trajectory]) -> set[str]:
    """Return parameters of the contact that motions do not determine: friction without slip, restitution without impact."""
    slips = any({"S", "K"} & set(motion.sequence) for motion in motions)
    # bounces too small to count end at once
    lands = any(motion.find("impact") or motion.find("bounce_limit") for motion in motions)
    return (set() if slips else {"mu_kinetic", "mu_excess"}) | (set() if lands else {"restitution"})
