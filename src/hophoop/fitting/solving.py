"""Least squares of the exact motion against the data, by lmfit, from several starts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import product
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.fitting.channels import rotation
from hophoop.fitting.covariance import covariance_of
from hophoop.fitting.guess import SPREADS, Candidate, candidates
from hophoop.fitting.jacobian import exact_slopes
from hophoop.fitting.losses import SOFT, loss
from hophoop.fitting.parameters import spec
from hophoop.fitting.problem import Problem, problem_of
from hophoop.scenario import InputError

if TYPE_CHECKING:
    from lmfit import Parameters

Floats = NDArray[np.float64]

FIRST_CALLS, MOST_CALLS = 12, 100  # maximum calls of the motion, in a first and in the last minimization
BLIND = 1e-3  # maximum rise of the sum of squares over the range of a parameter without effect
SHORTEST = 100  # numbers of a part of a record that is fitted for a start
ROUNDS = 4  # of other starts, while they help and the data are not explained
WORTH_TRYING = 4.0  # maximum factor of the cost of a start without slip
ASIDE = (-12.0, -4.0, 4.0, 12.0)  # distances of other starts from a minimum [standard deviations]
CONFIDENT = 2.71  # rise of the sum of squares at a one-sided limit of 95 %
ENOUGH = 1.0  # friction with which most motions never slip
EXPLAINED = 1.0  # robust cost over the number of data of a motion that explains them; scatter alone has about 0.9


class Minimum(NamedTuple):
    """A minimum without uncertainties."""

    params: Parameters
    cost: float  # sum of the squares, or the robust loss
    residuals: Floats  # [standard deviations]

    @property
    def values(self) -> dict[str, float]:
        """All parameters [SI units]."""
        return dict(self.params.valuesdict())


class Solution(NamedTuple):
    """A minimum with the covariance of some of its parameters."""

    minimum: Minimum
    free: tuple[str, ...]
    covariance: Floats

    def without(self, name: str) -> Solution:
        """Return the solution without the uncertainty of one parameter."""
        kept = [k for k, other in enumerate(self.free) if other != name]
        free = tuple(self.free[k] for k in kept)
        return self._replace(free=free, covariance=self.covariance[np.ix_(kept, kept)])

    def values_at(self, name: str, value: float) -> dict[str, float]:
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


def parameters(
    values: Mapping[str, float],
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


def changed(params: Parameters, values: Mapping[str, float], vary: Sequence[str] | None = None) -> Parameters:
    """Return a copy with other values, and with only some of its free parameters free."""
    result = params.copy()
    for name, one in result.items():
        if one.expr is None:
            one.value = values.get(name, one.value)
            one.vary = one.vary and (vary is None or name in vary)
    return result


def held(params: Parameters, values: Mapping[str, float]) -> Parameters:
    """Return a copy with some parameters fixed at values."""
    return changed(params, values, [name for name in free_of(params) if name not in values])


def free_of(params: Parameters) -> tuple[str, ...]:
    """Return the names of the free parameters."""
    return tuple(name for name, one in params.items() if one.vary)


def minimize(problem: Problem, params: Parameters, robust: bool, most: int = FIRST_CALLS) -> Minimum:
    """Return one minimum.

    robust: whether outliers count less; most: maximum number of calls of the motion [1].
    """
    tried: list[tuple[float, dict[str, float], Floats]] = []

    def residuals(params: Parameters) -> Floats:
        values = params.valuesdict()
        off = problem.residuals(values)
        tried.append((loss(off, robust), values, off))
        return off

    if free_of(params):
        minimizer = need("lmfit", "fit").Minimizer(residuals, params, max_nfev=most)
        how = {"Dfun": lambda params: slopes(problem, params), "loss": "soft_l1" if robust else "linear", "f_scale": SOFT}
        with np.errstate(divide="ignore", invalid="ignore"):  # of its own covariance, which is not used
            minimizer.least_squares(**how)
    else:
        residuals(params)
    # the last call of a minimization that was stopped is not always its best
    cost, values, off = min(tried, key=lambda one: one[0])
    return Minimum(changed(params, values), cost, off)


def solve(problem: Problem, params: Parameters, robust: bool) -> Solution:
    """Find one minimum and its covariance."""
    found = minimize(problem, params, robust, MOST_CALLS)
    jacobian = slopes(problem, found.params)
    return Solution(found, free_of(params), covariance_of(problem, jacobian, found.residuals, robust))


def cost_of(problem: Problem, params: Parameters, robust: bool) -> float:
    """Return the sum of squares or the robust loss."""
    return loss(problem.residuals(params.valuesdict()), robust)


def spread_of(problem: Problem, cost: float, free: int) -> float:
    """Return the sum of squares over the degrees of freedom, at least 1."""
    return max(1.0, cost / max(problem.count - free, 1))


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


def _differences(params: Parameters, names: Sequence[str], of: Callable[[dict[str, float]], Floats]) -> Floats:
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


def approach(problem: Problem, params: Parameters, robust: bool) -> tuple[Minimum, list[str]]:
    """Return an approximate minimum after few steps, and the parameters without effect at the start."""
    blind = insensitive(problem, params)
    return minimize(problem, held(params, {name: params[name].value for name in blind}), robust), blind


def of_rotation(problem: Problem) -> bool:
    """Return True if only angular velocities are measured."""
    return all(run.measured == {"omega"} for run in problem.runs)


def beginnings(problem: Problem, params: Parameters, robust: bool, most: int = FIRST_CALLS) -> list[Parameters]:
    """Return a start of a minimization, and of angular velocities alone also one from which the rotation fits.

    An angular velocity jumps at an impact, so the sum of squares has a step wherever an impact passes a measured value.
    """
    if not of_rotation(problem):
        return [params]
    runs = [replace(run, channels=(rotation(run.channels[0], run.t),)) for run in problem.runs]
    there = params.copy()
    for run in runs:  # the rotation counts from the first value
        there[run.named("marker_angle")].set(-there[run.named("angle0")].value, vary=True)
    found = minimize(Problem(tuple(runs)), there, robust, most).values
    return [params, changed(params, found | {name: params[name].value for name in params if name.startswith("marker_angle")})]


def lowest(problem: Problem, params: Parameters, starts: Sequence[Candidate], robust: bool) -> tuple[Minimum, list[str]]:
    """Return the lowest of approximate minima from several starts, and the parameters without effect there."""
    found: list[tuple[Minimum, list[str]]] = []
    explained = False
    tried: set[str] = set()
    for start in starts:
        # another sequence may explain the data better, also if they are explained to their scatter
        if explained and start.sequence in tried:
            continue
        begin = changed(params, start.values)
        found += [approach(problem, one, robust) for one in beginnings(problem, begin, robust)]
        tried.add(start.sequence)
        explained = min(one.cost for one, _ in found) < EXPLAINED * problem.count
    return min(found, key=lambda pair: pair[0].cost)


def best_of(problem: Problem, params: Parameters, starts: Sequence[Candidate], robust: bool) -> tuple[Solution, list[str]]:
    """Find the lowest minimum from several starts, and the parameters without effect there."""
    best, blind = lowest(problem, params, starts, robust)
    for k in range(1, ROUNDS + 1):
        cost = best.cost
        for values in _other_starts(problem, params, best, robust, k):
            other = approach(problem, changed(params, values), robust)
            if other[0].cost < best.cost - 1e-6:
                best, blind = other
        if best.cost < EXPLAINED * problem.count or best.cost > 0.99 * cost:
            break
    best, blind = _without_slip(problem, params, best, robust) or (best, blind)
    last, blind = _settled(problem, params, best, blind, robust)
    if any(piece.channel.name == "omega" for piece in problem.pieces):
        for _ in range(ROUNDS):
            aside, seen = min(_asides(problem, params, last, robust), key=lambda pair: pair[0].cost, default=(best, blind))
            if aside.cost > last.minimum.cost - 1e-6:
                break
            last, blind = _settled(problem, params, aside, seen, robust)
    return last, blind


def _other_starts(problem: Problem, params: Parameters, best: Minimum, robust: bool, k: int) -> list[dict[str, float]]:
    """Return other starts where a minimum does not explain one run, in round k: drawn around it, and that of a first half.

    The first half has fewer landings, which make the sum of squares rough. A few angular velocities are explained by more than
    one motion, so they have a first round in any case.
    """
    explained = best.cost < EXPLAINED * problem.count and not (k == 1 and of_rotation(problem))
    if explained or len(problem.runs) > 1:
        return []
    (run,) = problem.runs
    free = set(free_of(params))
    drawn = [one.values for one in candidates(run, best.values, free, seed=k)]
    half = run.until(0.5 * float(run.t[-1]))
    starts = candidates(half, best.values, free) if k == 1 and half.count > SHORTEST else []
    if starts:
        found = best_of(problem_of([half]), params, starts, robust)[0].minimum.values
        drawn += [found, found | {"mu_excess": best.values["mu_excess"]}]  # which shows where slip starts, perhaps later
    return drawn


def _settled(problem: Problem, params: Parameters, best: Minimum, blind: list[str], robust: bool) -> tuple[Solution, list[str]]:
    """Return the minimum near an approximate one, and the parameters without effect there."""
    values = best.values
    for _ in range(3):
        last = solve(problem, held(changed(params, values), {name: values[name] for name in blind}), robust)
        values, before = last.minimum.values, blind
        blind = insensitive(problem, changed(params, values))
        if blind == before:
            break  # else parameters have lost or gained effect on the way
    return last, blind


def _asides(problem: Problem, params: Parameters, last: Solution, robust: bool) -> list[tuple[Minimum, list[str]]]:
    """Return other minima, from starts some standard deviations away along each parameter of the contact.

    An angular velocity jumps at an impact, so the sum of squares has a step wherever an impact passes a measured value, and
    small basins between the steps.
    """
    found: list[tuple[Minimum, list[str]]] = []
    variances = np.diag(last.covariance) * spread_of(problem, last.minimum.cost, len(last.free))
    # also with the middle of the range of a parameter that has no effect here, but may have some elsewhere
    blind = {name: sum(SPREADS[name]) / 2 for name in SPREADS if name in free_of(params) and name not in last.free}
    for name, variance in zip(last.free, variances, strict=True):
        if name in SPREADS and np.isfinite(last.covariance).all():
            for far, others in product(ASIDE, [{}, blind] if blind else [{}]):
                value = last.minimum.values[name] + far * float(np.sqrt(variance))
                value = float(np.clip(value, params[name].min, params[name].max))
                there = {**last.minimum.values, **last.values_at(name, value), **others}
                found.append(approach(problem, changed(params, there), robust))
    return found


def _without_slip(problem: Problem, params: Parameters, best: Minimum, robust: bool) -> tuple[Minimum, list[str]] | None:
    """Return a motion that never slips if the data agree with it as well as with the best one."""
    friction, tied = params.get("mu_kinetic"), any(one.expr for one in params.values())
    if not friction.vary or tied or not slips(problem, best.values):
        return None
    for value in (float(np.clip(ENOUGH, friction.min, friction.max)), friction.max):
        there = changed(params, {**best.values, "mu_kinetic": value})
        if cost_of(problem, there, robust) < WORTH_TRYING * best.cost and not slips(problem, there.valuesdict()):
            other, blind = approach(problem, there, robust)
            alike = other.cost < best.cost + CONFIDENT * spread_of(problem, best.cost, len(free_of(params)))
            return (other, blind) if alike and not slips(problem, other.values) else None
    return None


def slips(problem: Problem, values: Mapping[str, float]) -> bool:
    """True if any run slips, or there is no motion."""
    try:
        return any({"S", "K"} & set(motion.sequence) for motion in problem.motions(values))
    except InputError:
        return True
