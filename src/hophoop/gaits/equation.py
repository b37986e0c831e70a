"""The equation of a gait in θ̇ and a parameter, and its solution along a line and at given conditions."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.gaits.computing import passages
from hophoop.gaits.gait import Gait
from hophoop.gaits.section import parameter_rates
from hophoop.results.units import Units
from hophoop.scenario import InputError, Scenario, Start
from hophoop.scenario.paths import parameter

Pair = NDArray[np.float64]
SOLVED = 1e-13  # largest residual of a solution, in √(g/R)
STEPS = 12  # of Newton's method
FAR = 1e3  # times the size of the first correction: then it diverges


class Values(NamedTuple):
    """The return map over a period at one point.

    Attributes
    ----------
    excess : float
        θ̇ after the period less θ̇ [√(g/R)].
    multiplier : float
        [1].
    rate : float
        By the scaled parameter [√(g/R)].
    word : tuple of str
    turns : float
        Revolutions of the period, which belong to the word.
    apart : float
        Least difference of θ̇ from that after a part of the period; inf for a prime period of 1 [√(g/R)].
    """

    excess: float
    multiplier: float
    rate: float
    word: tuple[str, ...]
    turns: float
    apart: float

    @property
    def key(self) -> tuple[tuple[str, ...], float]:
        """What is the same on a piece of the map."""
        return self.word, self.turns

    @property
    def tangent(self) -> Pair:
        """Unit vector along the solutions in (θ̇, scaled parameter)."""
        along = np.array([self.rate, 1.0 - self.multiplier])
        found: Pair = along / np.linalg.norm(along)
        return found


class GaitEquation:
    """P(θ̇; parameter) = θ̇ in rolling at the bottom, with θ̇ in √(g/R) and a parameter scaled to its range.

    Parameters
    ----------
    scenario : Scenario
    period : int
    path : str
    scale : float
        SI value of the parameter per unit of the scaled one.

    Raises
    ------
    ValueError
        If the path is no parameter that can be followed.
    """

    def __init__(self, scenario: Scenario, period: int, path: str, scale: float) -> None:
        self.scenario, self.period, self.path, self.scale = scenario, period, path, scale
        self.unit = Units.of_scenario(scenario).of("omega")

    def at(self, point: Pair) -> Scenario:
        """Return the scenario of a point, which starts on the section in rolling."""
        omega = float(point[0]) * self.unit
        start = Start(angle=math.pi, vx=self.scenario.hoop.radius * omega, omega=omega, slip=0.0, mode="R")
        return self.scenario.replace(self.path, float(point[1]) * self.scale).replace("start", start)

    def __call__(self, point: Pair, sign: float = 1.0) -> Values | None:
        """Return the map at a point, or None where the hoop does not come back in rolling, or the value is not allowed."""
        try:
            scenario = self.at(point)
        except InputError:
            return None
        found = passages(scenario, self.period)
        if len(found) < self.period or set(found.mode) != {"R"}:
            return None
        after = float(found.omega[-1]) / self.unit
        multiplier, rate = parameter_rates(found, self.path, sign)
        if not (math.isfinite(multiplier) and math.isfinite(rate)):
            return None
        turns = round((float(found.angle[-1]) - math.pi) / (2.0 * math.pi))
        parts = [part for part in range(1, self.period) if self.period % part == 0]
        apart = min((abs(float(found.omega[part - 1]) / self.unit - float(point[0])) for part in parts), default=math.inf)
        return Values(after - float(point[0]), multiplier, rate * self.scale, found.word, turns, apart)

    def gait(self, point: Pair) -> Gait:
        """Return the gait of a solution."""
        return Gait(self.at(point), "bottom", self.period)

    def solve(self, point: Pair, normal: Pair, offset: float) -> tuple[Pair, Values] | None:
        """Return the solution with normal · point = offset near a point, by Newton's method, or None if it finds none.

        Parameters
        ----------
        point, normal : ndarray, shape (2,)
        offset : float

        Returns
        -------
        solution : (ndarray, Values) or None
        """
        first = math.inf
        for _ in range(STEPS):
            values = self(point)
            if values is None:
                return None
            off = float(normal @ point) - offset
            matrix = np.array([[values.multiplier - 1.0, values.rate], normal])
            try:
                step = np.linalg.solve(matrix, [-values.excess, -off])
            except np.linalg.LinAlgError:
                return None
            size = float(np.abs(step).max())
            if size < SOLVED or (abs(values.excess) < SOLVED and abs(off) < SOLVED):
                return point, values
            first = min(first, size)
            if size > FAR * first or size > 1.0:
                return None
            point = point + step
        values = self(point)
        return None if values is None or abs(values.excess) > 1e-11 else (point, values)

    def solve_with(self, point: Pair, multiplier: float, step: float = 1e-6) -> tuple[Pair, Values] | None:
        """Return the solution with a given multiplier, or None.

        Parameters
        ----------
        point : ndarray, shape (2,)
            Near it.
        multiplier : float
            [1].
        step : float, default 1e-6
            Of the central differences of the multiplier [√(g/R) and scaled parameter].

        Returns
        -------
        solution : (ndarray, Values) or None
        """
        for _ in range(STEPS):
            values = self(point)
            if values is None:
                return None
            slopes = []
            for shift in (np.array([step, 0.0]), np.array([0.0, step])):
                ahead, back = self(point + shift), self(point - shift)
                if ahead is None or back is None or ahead.key != values.key or back.key != values.key:
                    return None
                slopes.append((ahead.multiplier - back.multiplier) / (2.0 * step))
            matrix = np.array([[values.multiplier - 1.0, values.rate], slopes])
            try:
                change = np.linalg.solve(matrix, [-values.excess, multiplier - values.multiplier])
            except np.linalg.LinAlgError:
                return None
            if float(np.abs(change).max()) > 0.5:
                return None
            point = point + change
            if float(np.abs(change).max()) < 1e-12:
                break
        values = self(point)
        solved = values is not None and abs(values.excess) < 1e-11 and abs(values.multiplier - multiplier) < 1e-7
        return (point, values) if solved and values is not None else None


def value_of(gait: Gait, path: str) -> float:
    """Return the gait's value of a parameter of hoop or plane.

    Parameters
    ----------
    gait : Gait
    path : str

    Returns
    -------
    value : float
        [SI].

    Raises
    ------
    ValueError
        If there is none.
    """
    parameter(path)
    section, _, name = path.partition(".")
    if section not in ("hoop", "plane"):
        raise InputError.of_field("path", path, "a parameter of hoop or plane")
    holder = getattr(gait.scenario, section)
    value = getattr(holder, "mu_static" if name == "mu" else name, None)
    if not isinstance(value, float):
        raise InputError.of_field("path", path, "a number of this hoop and plane")
    return value


def bounds_around(path: str, value: float, bounds: tuple[float, float]) -> tuple[float, float]:
    """Return the bounds of a parameter, if they are numbers on both sides of a value.

    Parameters
    ----------
    path : str
        Of the parameter.
    value : float
    bounds : (float, float)

    Returns
    -------
    low, high : float

    Raises
    ------
    ValueError
        If they are not.
    """
    try:
        low, high = (float(bound) for bound in bounds)
    except (TypeError, ValueError):
        raise InputError.of_field("bounds", bounds, "two numbers") from None
    if not (math.isfinite(low) and math.isfinite(high) and low <= value <= high and low < high):
        raise InputError(f"low = {low!r} and high = {high!r} must be finite and on both sides of {path} = {value!r}.")
    return low, high
