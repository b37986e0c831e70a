"""Least squares of the exact motion against the data, by lmfit, from several starts."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
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
ASIDE = (-12.0, -4.0, 4.0, 12.0)  # distances of other starts from a minimum [standard deviations]
CONFIDENT = 2.71  # rise of the sum of squares at a one-sided limit of 95 %
ENOUGH = 1.0  # friction with which most motions never slip
EXPLAINED = 1.0  # robust cost over the number of data of a motion that explains them; scatter alone has about 0.9
BETTER = 1e-6  # fall of the cost to another minimum


class Minimum(NamedTuple):
    """A minimum without uncertainties."""

    params: Parameters
    cost: float  # sum of the squares, or the robust loss
    residuals: Floats  # [standard deviations]
    blind: Sequence[str] = ()  # parameters without effect on the data

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

    def with_error(self, name: str, least: float) -> Solution:
        """Return the solution with a minimum standard deviation of one parameter; correlations stay."""
        place, factors = self.free.index(name), np.ones(len(self.free))
        factors[place] = max(1.0, least / np.sqrt(self.covariance[place, place]))
        return self._replace(covariance=self.covariance * np.outer(factors, factors))

    def beside(self, distances: Sequence[float]) -> Iterator[tuple[str, float, Values]]:
        """Yield each parameter of the contact, its values at distances within its range, and all values by regression.

        distances [standard deviations]; none where the covariance is infinite.
        """
        params, values = self.minimum.params, self.minimum.values
        for name, far in product(SPREADS, distances) if np.isfinite(self.covariance).all() else ():
            if name in self.free:
                place = self.free.index(name)
                value = values[name] + far * float(np.sqrt(self.spread * self.covariance[place, place]))
                value = float(np.clip(value, params[name].min, params[name].max))
                yield name, value, values | self.values_at(name, value)


def parameters(
    values: Values,
    free: Sequence[str],
    bounds: Mapping[str, Sequence[float]] | None = None,
    tied: Mapping[str, str] | None = None,
) -> Parameters:
    """Return lmfit's parameters.

    values: start values of free parameters, values of the others; bounds: minimum and maximum; tied: expressions of others.
    """
    lmfit = need("lmfit", "fit")
    result = lmfit.Parameters()
    for name, value in values.items():
        low, high = (bounds or {}).get(name, (-np.inf, np.inf))
        low, high = max(low, spec(name).low), min(high, spec(name).high)
        # a value that is given is kept, also outside of the range of a fit
        ends = {"min": low, "max": high} if name in free else {}
        result.add(name, value, vary=name in free, **ends)
    for name, text in (tied or {}).items():
        kind = spec(name)
        try:
            result[name].set(expr=text)
            result.update_constraints()
            known = kind.low <= result[name].value <= kind.high and "open" not in text  # no files
        except RecursionError:
            raise InputError(f"tied parameters ({', '.join(tied or ())}) depend on each other in a circle.") from None
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
    """Find one minimum and its covariance."""
    found = minimize(problem, params, MOST_CALLS)
    covariance = covariance_of(problem, slopes(problem, found.params), found.residuals)
    return Solution(problem, found, free_of(params), covariance)


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


def insensitive(problem: Problem, params: Parameters) -> list[str]:
    """Return the free parameters without effect on the data at the present values."""
    names = free_of(params)
    span = [min(params[name].max - params[name].min, 1.0) for name in names]
    rise = (slopes(problem, params) ** 2).sum(axis=0) * np.square(span) if names else []
    return [name for name, one in zip(names, rise, strict=True) if one < BLIND]


def approach(problem: Problem, params: Parameters) -> Minimum:
    """Return an approximate minimum after few steps, without those parameters that have no effect at the start."""
    blind = insensitive(problem, params)
    return minimize(problem, changed(params, {}, blind))._replace(blind=blind)


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
            found += [approach(problem, one) for one in beginnings(problem, changed(params, start.values))]
            tried.add(start.sequence)
    return min(found, key=COST)


def _explains(problem: Problem, found: Minimum) -> bool:
    """Return True if the motion of a minimum explains the data."""
    return found.cost < EXPLAINED * problem.count


def best_of(problem: Problem, params: Parameters, starts: Sequence[Candidate]) -> Solution:
    """Find the lowest minimum from several starts."""
    best = lowest(problem, params, starts)
    for k in range(1, ROUNDS + 1):
        cost = best.cost
        for values in _other_starts(problem, params, best, k):
            other = approach(problem, changed(params, values))
            if other.cost < best.cost - BETTER:
                best = other
        if _explains(problem, best) or best.cost > 0.99 * cost:
            break
    last = _settled(problem, params, _without_slip(problem, params, best))
    if problem.jumps:
        for _ in range(ROUNDS):
            aside = min(_asides(params, last), key=COST, default=last.minimum)
            if aside.cost > last.minimum.cost - BETTER:
                break
            last = _settled(problem, params, aside)
    return last


def _other_starts(problem: Problem, params: Parameters, best: Minimum, k: int) -> list[Values]:
    """Return other starts where a minimum does not explain one run, in round k: drawn around it, and that of a first half.

    The first half has fewer landings, which make the sum of squares rough. A few angular velocities are explained by more than
    one motion, so they have a first round in any case.
    """
    if len(problem.runs) > 1 or (_explains(problem, best) and not (k == 1 and of_rotation(problem))):
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


def _settled(problem: Problem, params: Parameters, best: Minimum) -> Solution:
    """Return the minimum near an approximate one, without the parameters that have no effect there."""
    for _ in range(3):
        last = solve(problem, changed(params, best.values, best.blind))
        before, best = best, last.minimum._replace(blind=insensitive(problem, changed(params, last.minimum.values)))
        if best.blind == before.blind:
            break  # else parameters have lost or gained effect on the way
    return last._replace(minimum=best)


def _asides(params: Parameters, last: Solution) -> list[Minimum]:
    """Return other minima, from starts some standard deviations away along each parameter of the contact.

    An angular velocity jumps at an impact, so the sum of squares has a step wherever an impact passes a measured value, and
    small basins between the steps.
    """
    # also with the middle of the range of a parameter that has no effect here, but may have some elsewhere
    blind = {name: sum(SPREADS[name]) / 2 for name in SPREADS if name in free_of(params) and name not in last.free}
    starts = [values | others for _, _, values in last.beside(ASIDE) for others in ([{}, blind] if blind else [{}])]
    return [approach(last.problem, changed(params, one)) for one in starts]


def _without_slip(problem: Problem, params: Parameters, best: Minimum) -> Minimum:
    """Return a motion that never slips if the data agree with it as well as with the best one, else this."""
    friction, tied = params["mu_kinetic"], any(one.expr for one in params.values())
    if not friction.vary or tied or not slips(problem, best.values):
        return best
    for value in (float(np.clip(ENOUGH, friction.min, friction.max)), friction.max):
        values = changed(params, {**best.values, "mu_kinetic": value}).valuesdict()
        if problem.cost(values) < WORTH_TRYING * best.cost and not slips(problem, values):
            other = approach(problem, changed(params, values))
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
