"""The five motions, computed once, with quantities for several statements."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache, cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.article.scenarios import scenarios
from hophoop.plots.curves import curve
from hophoop.results.records import ArraySample
from hophoop.scenario import Hoop, Plane, Start
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory

# Long enough for the law of the slow end of slip.
LONG = 3000.0


class Runs:
    """The article's motions and their samples by name, each computed on first use."""

    def __init__(self) -> None:
        self.motion: Callable[[str], Trajectory] = cache(lambda name: simulate(scenarios()[name]))
        # densely sampled, with both sides of each event
        self.sample: Callable[[str], ArraySample] = cache(lambda name: curve(self.motion(name)))

    def extremes(self, name: str, quantity: str) -> tuple[float, float]:
        """Return the least and the largest value of a quantity in a motion."""
        return extremes(self.motion(name), self.sample(name).t, quantity)

    @cached_property
    def long_slipping(self) -> Trajectory:
        """The long motion at 2.8 m/s."""
        scenario = scenarios()["slipping"]
        return simulate(scenario.replace("duration", LONG))

    @property
    def hoop(self) -> Hoop:
        """The reference hoop."""
        return scenarios()["slow"].hoop

    @property
    def plane(self) -> Plane:
        """The article's plane with μ = 1."""
        return scenarios()["slow"].plane


def bisect(low: float, high: float, is_before: Callable[[float], Any]) -> float:
    """Return the time at which a condition ends that holds at `low` and not at `high`, bisected to the last bit [s]."""
    while low < (middle := 0.5 * (low + high)) < high:
        low, high = (middle, high) if is_before(middle) else (low, middle)
    return high


def first_time(motion: Trajectory, angle: float) -> float:
    """Return the first time at which a motion has an angle [s]."""
    grid = motion.times(4001)
    k = int(np.argmax(motion.at(grid).angle >= angle))
    return bisect(float(grid[k - 1]), float(grid[k]), lambda t: motion.at(t).angle < angle)


def extremes(motion: Trajectory, times: NDArray[np.float64], quantity: str) -> tuple[float, float]:
    """Return the least and the largest value between the first and the last time, refined about those of the samples."""
    found = []
    for sign in (-1.0, 1.0):
        near, best = times, -math.inf
        for _ in range(9):  # each round divides the spacing by 10, and the error by 100, at an event by 10
            values = sign * getattr(motion.at(near, side="left"), quantity)
            k = int(np.argmax(values))
            best = max(best, float(values[k]))
            near = np.linspace(near[max(k - 1, 0)], near[min(k + 1, len(near) - 1)], 21)
        found.append(sign * best)
    return found[0], found[1]


def rolling_motion(gamma: float, mu: float, speed: float, duration: float) -> Trajectory:
    """Simulate a hoop of another load fraction from a rolling start at the top."""
    return simulate(Hoop.ideal(gamma), Plane(mu=mu), Start.rolling(speed), duration=duration)
