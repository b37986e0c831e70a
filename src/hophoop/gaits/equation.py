"""The equation of a gait on its section and in a parameter, and its solution along a line and at given conditions."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.gaits.computing import passages
from hophoop.gaits.gait import Gait
from hophoop.gaits.results import Passages
from hophoop.gaits.section import change_of, coordinates, parameter_rates
from hophoop.kernel.physics.body import MODE_LETTERS
from hophoop.results.units import Units
from hophoop.scenario import InputError, Scenario, Start
from hophoop.scenario.paths import parameter
from hophoop.scenario.start import StartState

Pair = NDArray[np.float64]
STEPS = 12  # of Newton's method
DIFFERENCE = 1e-6  # to either side, in each coordinate and the scaled parameter
FAR = 1e3  # times the size of the first correction: then it diverges


class Values(NamedTuple):
    """The return map over a period at one point, in units of R and √(R/g).

    Attributes
    ----------
    excess : ndarray, shape (n,)
        Coordinates of the section after the period less those before.
    matrix : ndarray, shape (n, n)
        Derivative of the map.
    rate : ndarray, shape (n,)
        Its derivative by the scaled parameter.
    sequence : str
    turns : float
        Revolutions of the period, which belong to the sequence.
    apart : float
        Largest difference of the coordinates from those after a part of the period, the least of all parts; inf for period 1.
    """

    excess: Pair
    matrix: Pair
    rate: Pair
    sequence: str
    turns: float
    apart: float

    @property
    def key(self) -> tuple[str, float]:
        """What is the same on a piece of the map."""
        return self.sequence, self.turns

    @property
    def multiplier(self) -> float:
        """The eigenvalue of the largest modulus; of a complex pair its real part, which tells nothing of stability [1]."""
        return float(leading(self.matrix).real)

    @property
    def radius(self) -> float:
        """The largest modulus of an eigenvalue: below 1 the gait is stable [1]."""
        return abs(leading(self.matrix))

    @property
    def trace(self) -> float:
        """Sum of the multipliers [1]."""
        return float(np.trace(self.matrix))

    def off(self, critical: float) -> float:
        """Return det(matrix − critical), which is 0 where a multiplier has this value."""
        return float(np.linalg.det(self.matrix - critical * np.eye(len(self.matrix))))

    @property
    def tangent(self) -> Pair:
        """Unit vector along the solutions in the coordinates and the scaled parameter."""
        found: Pair = np.linalg.svd(self.by_point)[2][-1]
        return found

    @property
    def by_point(self) -> Pair:
        """Derivative of the excess by the point, shape (n, n + 1)."""
        found: Pair = np.column_stack([self.matrix - np.eye(len(self.matrix)), self.rate])
        return found


def leading(matrix: Pair) -> complex:
    """Return the eigenvalue of the largest modulus."""
    found = np.linalg.eigvals(matrix)
    return complex(found[np.argmax(np.abs(found))])


Condition = Callable[[Values, Pair], "tuple[Pair, float] | None"]  # at a point: the row of its derivatives, and what is left


class GaitEquation:
    """P(coordinates; parameter) = coordinates on a section, in units of R and √(R/g), with a parameter scaled to its range.

    A point holds the coordinates, θ̇ alone in rolling at the bottom, and then the scaled parameter.

    Parameters
    ----------
    scenario : Scenario
    period : int
    path : str
    scale : float
        SI value of the parameter per unit of the scaled one.
    section : {'bottom', 'landing'}, default 'bottom'
    mode : str, default 'R'
        Letter of the mode at the start.

    Raises
    ------
    ValueError
        If the path is no parameter that can be followed.
    """

    def __init__(
        self, scenario: Scenario, period: int, path: str, scale: float, section: str = "bottom", mode: str = "R"
    ) -> None:
        self.scenario, self.period, self.path, self.scale = scenario, period, path, scale
        self.section, self.mode = section, mode
        self.names = coordinates(section, MODE_LETTERS.index(mode))
        units = Units.of_scenario(scenario)
        self.units = np.array([units.of(name) for name in self.names])

    def other(self, point: Pair) -> tuple[GaitEquation, Pair] | None:
        """Return the equation of the mode in which the hoop comes back, and the point there; None if the mode is the same."""
        start = point.copy()
        if "slip" in self.names:  # it may be past 0, where the mode ends
            k = self.names.index("slip")
            start[k] = min(start[k], 0.0) if self.mode == "S" else max(start[k], 0.0)
        try:
            found = passages(self.at(start), self.period, section=self.section)
        except InputError:
            return None
        if len(found) < self.period or found.mode[-1] == self.mode:
            return None
        mode = found.mode[-1]
        other = GaitEquation(self.scenario, self.period, self.path, self.scale, self.section, mode)
        row = np.array([float(getattr(found, name)[-1]) for name in other.names]) / other.units
        if other.names[0] == "angle":
            row[0] = math.remainder(row[0], 2.0 * math.pi)
        return other, np.append(row, point[-1])

    def place(self, state: StartState, value: float) -> Pair:
        """Return the point of a state on the section at a value of the parameter."""
        coordinates = state._replace(angle=state.angle % (2.0 * math.pi))
        return np.append([float(getattr(coordinates, name)) for name in self.names] / self.units, value / self.scale)

    def omega(self, point: Pair) -> float:
        """Return θ̇ at a point [rad/s]."""
        k = self.names.index("omega")
        return float(point[k]) * float(self.units[k])

    def parameter(self, point: Pair) -> float:
        """Return the parameter at a point [SI]."""
        return float(point[-1]) * self.scale

    def at(self, point: Pair) -> Scenario:
        """Return the scenario of a point, which starts on the section."""
        value = {"angle": math.pi, "slip": 0.0} | dict(zip(self.names, (point[:-1] * self.units).tolist(), strict=True))
        start = Start(height=0.0, vx=self.scenario.hoop.radius * value["omega"] + value["slip"], mode=self.mode, **value)
        return self.scenario.replace(self.path, self.parameter(point)).replace("start", start)

    def __call__(self, point: Pair) -> Values | None:
        """Return the map at a point, or None where the hoop does not come back in the mode, or the value is not allowed."""
        try:
            scenario = self.at(point)
        except InputError:
            return None
        found = passages(scenario, self.period, section=self.section)
        if len(found) < self.period or found.mode[-1] != self.mode:
            return None
        matrix, rate = parameter_rates(found, self.path)
        if not (np.isfinite(matrix).all() and np.isfinite(rate).all()):
            return None
        first = scenario.start.state(scenario.hoop).angle
        turns = round((float(found.angle[-1]) - first) / (2.0 * math.pi))
        parts = [part for part in range(1, self.period) if self.period % part == 0 and found.mode[part - 1] == self.mode]
        apart = min((float(np.abs(self.excess(found, part - 1, point)).max()) for part in parts), default=math.inf)
        return Values(self.excess(found, -1, point), matrix, rate * self.scale, "·".join(found.sequences), turns, apart)

    def excess(self, found: Passages, index: int, point: Pair) -> Pair:
        """Return the coordinates of a passage less those of a point."""
        return change_of(found, index, self.names, point[:-1])

    def gait(self, point: Pair) -> Gait:
        """Return the gait of a solution."""
        return Gait(passages(self.at(point), self.period, section=self.section))

    def solve(self, point: Pair, normal: Pair, offset: float) -> tuple[Pair, Values] | None:
        """Return the solution with normal · point = offset near a point, by Newton's method, or None if it finds none."""
        return self._newton(point, lambda values, point: (normal, float(normal @ point) - offset), 1e-13)

    def solve_with(self, point: Pair, multiplier: float) -> tuple[Pair, Values] | None:
        """Return the solution near a point with a given multiplier, or None."""

        def condition(values: Values, point: Pair) -> tuple[Pair, float] | None:
            slopes = []
            for shift in DIFFERENCE * np.eye(len(point)):
                ahead, back = self(point + shift), self(point - shift)
                if ahead is None or back is None or ahead.key != values.key or back.key != values.key:
                    return None
                slopes.append((ahead.off(multiplier) - back.off(multiplier)) / (2.0 * DIFFERENCE))
            return np.array(slopes), values.off(multiplier)

        found = self._newton(point, condition, 1e-12)
        return found if found is not None and abs(found[1].off(multiplier)) < 1e-7 else None

    def _newton(self, point: Pair, condition: Condition, solved: float) -> tuple[Pair, Values] | None:
        """Return the solution with one more condition; `solved` is the largest residual, in units of R and √(R/g)."""
        first = math.inf
        for _ in range(STEPS):
            values = self(point)
            known = None if values is None else condition(values, point)
            if values is None or known is None:
                return None
            normal, off = known
            try:
                step = np.linalg.solve(np.vstack([values.by_point, normal]), np.append(-values.excess, -off))
            except np.linalg.LinAlgError:
                return None
            size = float(np.abs(step).max())
            if size < solved or (np.abs(values.excess).max() < solved and abs(off) < solved):
                return point, values
            first = min(first, size)
            if size > FAR * first or size > 1.0:
                return None
            point = point + step
        values = self(point)
        return None if values is None or np.abs(values.excess).max() > 1e-11 else (point, values)


def value_of(scenario: Scenario, path: str) -> float:
    """Return a scenario's value of a parameter of hoop or plane [SI]; refuse other paths."""
    parameter(path)
    section, _, name = path.partition(".")
    if section not in ("hoop", "plane"):
        raise InputError.of_field("path", path, "a parameter of hoop or plane")
    holder = getattr(scenario, section)
    value = getattr(holder, "mu_static" if name == "mu" else name, None)
    if not isinstance(value, float):
        raise InputError.of_field("path", path, "a number of this hoop and plane")
    return value


def bounds_around(path: str, value: float, bounds: tuple[float, float]) -> tuple[float, float]:
    """Return the bounds of a parameter, if they are numbers on both sides of a value; refuse others."""
    try:
        low, high = (float(bound) for bound in bounds)
    except (TypeError, ValueError):
        raise InputError.of_field("bounds", bounds, "two numbers") from None
    if not (math.isfinite(low) and math.isfinite(high) and low <= value <= high and low < high):
        unit = f" {parameter(path).unit}" if parameter(path).unit else ""
        raise InputError(f"low = {low!r} and high = {high!r} must be finite and on both sides of {path} = {value!r}{unit}.")
    return low, high
