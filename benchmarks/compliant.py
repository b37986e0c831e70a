"""Cost of a compliant motion against stiffness beside the rigid solver, and its distance from it.

Usage: python benchmarks/compliant.py

The article's hop at 3.1 m/s, 2 s, warm and in process; the least CPU time of 15 calls.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

from hophoop.article.compliant_figures import landing_scenario, with_contact
from hophoop.scenario import Scenario
from hophoop.simulation.simulate import simulate


def least_time(call: Callable[[], object], repeats: int = 15) -> float:
    """Least CPU time of a call [s], after one that compiles."""
    call()
    times = []
    for _ in range(repeats):
        begin = time.process_time()
        call()
        times.append(time.process_time() - begin)
    return min(times)


def timed(scenario: Scenario) -> float:
    """Time of `simulate` [s]."""
    return least_time(lambda: simulate(scenario))


def angle_error(rigid: Scenario, soft: Scenario) -> float:
    """Maximum difference of θ between both motions [rad]."""
    one, other = simulate(rigid), simulate(soft)
    t = np.linspace(0.0, min(one.duration, other.duration), 400)
    return float(np.max(np.abs(other.at(t).angle - one.at(t).angle)))


def main() -> None:
    """Print the table."""
    rigid = landing_scenario()
    base = timed(rigid)
    print(f"rigid: {base * 1e3:.3f} ms")
    print("friction  stiffness  rtol     ms   × rigid  steps  error of θ / rad")
    for friction in ("tanh", "bristle"):
        for stiffness in (1e2, 1e4, 1e6, 1e8, 1e10, 1e12):
            for rtol in (1e-6, 1e-9):
                soft = with_contact(rigid, stiffness, friction=friction, rtol=rtol)
                cost = timed(soft)
                steps = len(simulate(soft).tables["segments"])
                print(
                    f"{friction:8s}  {stiffness:.0e}      {rtol:.0e} {cost * 1e3:7.2f} {cost / base:8.0f} "
                    f"{steps:6d}  {angle_error(rigid, soft):.1e}"
                )


if __name__ == "__main__":
    main()
