"""Least squares of the exact motion against the data, from several starts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.fitting.covariance import covariance_of
from hophoop.fitting.guess import SPREADS, Candidate, merge_bounces
from hophoop.fitting.jacobian import exact_slopes
from hophoop.fitting.losses import SOFT, loss
from hophoop.fitting.parameters import PARAMETERS
from hophoop.fitting.problem import FAR, Problem
from hophoop.scenario import InputError

Floats = NDArray[np.float64]

FIRST_CALLS, MOST_CALLS = 12, 100  # maximum calls of the motion, in a first and in the last minimization
BLIND = 1e-3  # maximum rise of the sum of squares over the range of a parameter without effect
WALK = 15  # steps along a parameter
WORTH_TRYING, MOST_WALKS = 4.0, 4  # maximum factor of the cost of a step, and maximum number of such starts
CONFIDENT = 2.71  # rise of the sum of squares at a one-sided limit of 95 %
ENOUGH = 1.0  # friction with which most motions never slip


@dataclass(frozen=True)
class Choice:
    """Free, bounded and tied parameters.

    Attributes
    ----------
    values : dict
        Start values of free parameters, values of the others.
    free : tuple of str
    bounds : dict
        Minimum and maximum.
    tied : dict
        Expressions of other parameters.
    """

    values: dict[str, float]
    free: tuple[str, ...]
    bounds: dict[str, tuple[float, float]]
    tied: dict[str, str]

    def limits(self, name: str) -> tuple[float, float]:
        """Return minimum and maximum of a parameter."""
        kind = PARAMETERS[name]
        low, high = self.bounds.get(name, (kind.low, kind.high))
        return max(low, kind.low), min(high, kind.high)

    def without(self, name: str, value: float) -> Choice:
        """Return the choice with one parameter fixed."""
        free = tuple(other for other in self.free if other != name)
        return Choice({**self.values, name: value}, free, self.bounds, self.tied)

    def only(self, names: tuple[str, ...]) -> Choice:
        """Return the choice with only these parameters free."""
        return Choice(self.values, names, self.bounds, self.tied)

    def at(self, values: Mapping[str, float]) -> Choice:
        """Return the choice with other values."""
        return Choice({**self.values, **values}, self.free, self.bounds, self.tied)


class Solution(NamedTuple):
    """A minimum."""

    values: dict[str, float]
    free: tuple[str, ...]
    covariance: Floats  # of the free ones
    cost: float  # sum of the squares, or the robust loss
    residuals: Floats  # [standard deviations]

    def without(self, name: str) -> Solution:
        """Return the solution without the uncertainty of one parameter."""
        kept = [k for k, other in enumerate(self.free) if other != name]
        free = tuple(self.free[k] for k in kept)
        return self._replace(free=free, covariance=self.covariance[np.ix_(kept, kept)])

    def with_error(self, name: str, least: float) -> Solution:
        """Return the solution with a minimum standard deviation of one parameter; correlations stay."""
        place, factors = self.free.index(name), np.ones(len(self.free))
        factors[place] = max(1.0, least / np.sqrt(self.covariance[place, place]))
        return self._replace(covariance=self.covariance * np.outer(factors, factors))


class Minimum(NamedTuple):
    """A minimum without uncertainties."""

    values: dict[str, float]
    cost: float  # sum of the squares, or the robust loss
    residuals: Floats  # [standard deviations]


def solve(problem: Problem, choice: Choice, robust: bool) -> Solution:
    """Find one minimum and its covariance.

    robust: whether outliers count less.
    """
    values, cost, off = minimize(problem, choice, robust, MOST_CALLS)
    found = slopes(problem, choice.at(values), choice.free)
    return Solution(values, choice.free, covariance_of(problem, found, off, robust), cost, off)


def minimize(problem: Problem, choice: Choice, robust: bool, most: int = FIRST_CALLS) -> Minimum:
    """Return one minimum, found by SciPy's trust-region least squares.

    robust: whether outliers count less; most: maximum number of calls of the motion [1].
    """
    begin = complete(choice, {})
    if not choice.free:
        off = problem.residuals(begin)
        return Minimum(begin, loss(off, robust), off)

    def at(free: Floats) -> dict[str, float]:
        return complete(choice, dict(zip(choice.free, free.tolist(), strict=True)))

    def residuals(free: Floats) -> Floats:
        try:
            return problem.residuals(at(free))
        except InputError:  # an expression has no value there
            return np.full(problem.count, FAR)

    found = need("scipy.optimize", "fit").least_squares(
        residuals,
        [begin[name] for name in choice.free],
        lambda free: slopes(problem, choice.at(at(free)), choice.free),
        np.transpose([choice.limits(name) for name in choice.free]),
        loss="soft_l1" if robust else "linear",
        f_scale=SOFT,
        max_nfev=most,
    )
    return Minimum(at(found.x), 2.0 * float(found.cost), found.fun)


def cost_at(problem: Problem, values: dict[str, float], robust: bool) -> float:
    """Return the sum of squares or the robust loss at values of all parameters."""
    return loss(problem.residuals(values), robust)


def spread_of(problem: Problem, cost: float, free: int) -> float:
    """Return the sum of squares over the degrees of freedom, at least 1."""
    return max(1.0, cost / max(problem.count - free, 1))


def complete(choice: Choice, free: Mapping[str, float]) -> dict[str, float]:
    """Return all values: the free ones within their limits, the tied ones computed from the others [SI units]."""
    values = {**choice.values, **free}
    for name in choice.free:
        low, high = choice.limits(name)
        values[name] = min(max(values[name], low), high)
    for _ in choice.tied:  # one may depend on another
        values |= _tied_values(choice, values)
    if choice.tied and _tied_values(choice, values).items() - values.items():
        raise InputError(f"tied parameters ({', '.join(choice.tied)}) depend on each other in a circle.")
    return values


def _tied_values(choice: Choice, values: dict[str, float]) -> dict[str, float]:
    """Return the tied values, each computed once from the given ones."""
    evaluator = need("asteval", "fit").Interpreter(user_symbols=values, minimal=True)
    evaluator.symtable.pop("open", None)
    result = {}
    for name, text in choice.tied.items():
        try:
            result[name] = float(evaluator.eval(text, show_errors=False, raise_errors=True))
            if not np.isfinite(result[name]):
                raise ValueError
        except Exception:
            raise InputError(f"tied {name} = {text!r} is no expression of the other parameters.") from None
    return result


def slopes(problem: Problem, choice: Choice, names: tuple[str, ...]) -> Floats:
    """Derivatives of the residuals by parameters, with those tied to them changing as well.

    They are exact where the motion has derivatives. Elsewhere they are differences, both ways if the limits allow.

    choice: its values are the point; jacobian shape (count, len(names)) [1 over the parameter's unit].
    """
    tied = tuple(choice.tied)
    try:
        jacobian = exact_slopes(problem, complete(choice, {}), (*names, *tied))
    except InputError:
        jacobian = np.full((problem.count, len(names) + len(tied)), np.nan)
    result = jacobian[:, : len(names)]
    if tied:
        together = _differences(choice, names, lambda values: [values[name] for name in tied])
        result = result + jacobian[:, len(names) :] @ together
    missing = tuple(name for k, name in enumerate(names) if not np.isfinite(result[:, k]).all())
    if missing:
        places = [names.index(name) for name in missing]
        result[:, places] = _differences(choice, missing, problem.residuals)
    return result


def _differences(choice: Choice, names: tuple[str, ...], of: Callable[[dict[str, float]], Floats | list[float]]) -> Floats:
    """Return derivatives by central differences."""
    columns = []
    for name in names:
        low, high = choice.limits(name)
        here = min(max(choice.values[name], low), high)
        step = PARAMETERS[name].step * max(1.0, abs(here))
        above, below = min(here + step, high), max(here - step, low)
        ends = [np.asarray(of(complete(choice, {name: value})), dtype=float) for value in (above, below)]
        columns.append((ends[0] - ends[1]) / (above - below))
    return np.column_stack(columns)


def insensitive(problem: Problem, choice: Choice) -> list[str]:
    """Return the free parameters without effect on the data at the present values."""
    jacobian = slopes(problem, choice, choice.free)
    result = []
    for k, name in enumerate(choice.free):
        low, high = choice.limits(name)
        span = min(high - low, 1.0) if np.isfinite(high - low) else 1.0
        if float((jacobian[:, k] ** 2).sum()) * span**2 < BLIND:
            result.append(name)
    return result


def best_of(problem: Problem, choice: Choice, starts: list[Candidate], robust: bool) -> tuple[Solution, list[str]]:
    """Find the lowest minimum from several starts, and the parameters without effect there."""
    found: list[tuple[Minimum, list[str]]] = []
    explained = False
    tried: set[str] = set()
    for start in starts:
        sequence = merge_bounces(start.sequence)
        # another sequence may explain the data better, also if they are explained to their scatter
        if explained and sequence in tried:
            continue
        found.append(approach(problem, choice.at(start.values), robust))
        tried.add(sequence)
        explained = explained or found[-1][0].cost < 1.15 * problem.count
    best, blind = min(found, key=lambda pair: pair[0].cost)
    for values in _walks(problem, choice, best, robust):
        other = approach(problem, choice.at(values), robust)
        if other[0].cost < best.cost - 1e-6:
            best, blind = other
    plain = _without_slip(problem, choice, best, robust)
    if plain is not None:
        best, blind = plain
    last = solve(problem, _without_all(choice.at(best.values), blind), robust)
    for _ in range(2):
        now = insensitive(problem, choice.at(last.values))
        if now == blind:
            break
        blind = now  # parameters have lost or gained effect on the way
        last = solve(problem, _without_all(choice.at(last.values), blind), robust)
    return last, blind


def _without_slip(problem: Problem, choice: Choice, best: Minimum, robust: bool) -> tuple[Minimum, list[str]] | None:
    """Return a motion that never slips if the data agree with it as well as with the best one."""
    if "mu_kinetic" not in choice.free or choice.tied or not _slips(problem, best.values):
        return None
    low, high = choice.limits("mu_kinetic")
    for friction in (float(np.clip(ENOUGH, low, high)), high):
        values = {**best.values, "mu_kinetic": friction}
        cost = cost_at(problem, values, robust)
        if cost < WORTH_TRYING * best.cost and not _slips(problem, values):
            other, blind = approach(problem, choice.at(values), robust)
            alike = other.cost < best.cost + CONFIDENT * spread_of(problem, best.cost, len(choice.free))
            return (other, blind) if alike and not _slips(problem, other.values) else None
    return None


def _slips(problem: Problem, values: dict[str, float]) -> bool:
    try:
        return bool({"S", "K"} & set(problem.motion(values).sequence))
    except InputError:
        return True


def _walks(problem: Problem, choice: Choice, best: Minimum, robust: bool) -> list[dict[str, float]]:
    """Other starts: along each parameter of the contact, the two lowest values apart from the minimum.

    Along these the sum of squares has steps and plateaus, such as restitution so small that nothing bounces.
    """
    result = []
    for name, (low, high) in SPREADS.items():
        if name not in choice.free:
            continue
        least, most = choice.limits(name)
        grid = np.linspace(max(low, least), min(high, most), WALK)
        costs = [(cost_at(problem, {**best.values, name: float(value)}, robust), float(value)) for value in grid]
        for cost, value in sorted(costs)[:2]:
            if cost < WORTH_TRYING * best.cost:
                result.append((cost, {**best.values, name: value}))
    return [values for _, values in sorted(result, key=lambda pair: pair[0])[:MOST_WALKS]]


def approach(problem: Problem, choice: Choice, robust: bool) -> tuple[Minimum, list[str]]:
    """Return an approximate minimum after few steps, and the parameters without effect at the start."""
    blind = insensitive(problem, choice)
    return minimize(problem, _without_all(choice, blind), robust), blind


def _without_all(choice: Choice, blind: list[str]) -> Choice:
    for name in blind:
        choice = choice.without(name, choice.values[name])
    return choice
