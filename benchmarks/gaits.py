"""Speed of the return map and of fates on the level, next to SciPy's integrator in the same run.

    python benchmarks/gaits.py [--revolutions 20000] [--motions 20000]

Times are those of the process (CPU seconds). SciPy integrates rolling alone, with an event at the bottom.
"""

from __future__ import annotations

import argparse
import math
import time

import numpy as np

import hophoop as hh
from hophoop.gaits.computing import judged
from hophoop.gaits.kernels.layout import Request
from hophoop.maps.grid.cells import make_cells

CASES = ((1.0, 0.75, 3.4), (3.0, 0.5, 2.7), (4.0, 0.75, 3.4), (3.0, 0.15, 8.0))  # slope in degrees, γ, θ̇


def cpu(work) -> float:
    """CPU seconds of a call, the best of three."""
    best = math.inf
    for _ in range(3):
        began = time.process_time()
        work()
        best = min(best, time.process_time() - began)
    return best


def on_slope(degrees: float, gamma: float, omega: float) -> hh.Scenario:
    """A hoop that rolls through the bottom, in units of R and g."""
    plane = hh.Plane(slope=math.radians(degrees), gravity=1.0)
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=plane, start=hh.Start.rolling(omega, angle=math.pi))


def scipy_revolutions(gamma: float, slope: float, omega: float, count: int) -> None:
    """Roll through the bottom so many times by DOP853 with rtol = 1e-10."""
    from scipy.integrate import solve_ivp

    def rates(_, state):
        th, om = state
        inertia = 1.0 + (1.0 - gamma * gamma) + gamma * gamma + 2.0 * gamma * math.cos(th)
        pull = gamma * math.sin(th + slope) + math.sin(slope) + gamma * math.sin(th) * om * om
        return om, pull / inertia

    def bottom(_, state):
        return math.sin(0.5 * (state[0] - math.pi))

    end = 3.0 * count
    solve_ivp(rates, (0.0, end), (math.pi, omega), "DOP853", events=bottom, rtol=1e-10, atol=1e-12)


def main() -> None:
    """Print revolutions and motions per second and core."""
    options = argparse.ArgumentParser()
    options.add_argument("--revolutions", type=int, default=20_000)
    options.add_argument("--motions", type=int, default=20_000)
    given = options.parse_args()
    for degrees, gamma, omega in CASES:
        scenario = on_slope(degrees, gamma, omega)
        rate = given.revolutions / cpu(lambda scenario=scenario: hh.passages(scenario, given.revolutions))
        print(f"slope {degrees:g}°, γ = {gamma:g}: {rate:,.0f} revolutions per second and core")
    slow = 100 / cpu(lambda: scipy_revolutions(0.75, 0.0, 3.4, 100))
    print(f"SciPy's DOP853, rolling alone: {slow:,.0f} revolutions per second and core")
    random = np.random.default_rng(1)
    values = {"plane.mu": random.uniform(0.005, 2.0, given.motions), "start.speed": random.uniform(0.005, 4.0, given.motions)}
    for restitution in (0.0, 0.5):
        base = hh.Scenario(plane=hh.Plane(gravity=1.0, restitution=restitution))
        cells = make_cells(base, values, given.motions)
        rate = given.motions / cpu(lambda cells=cells: judged(cells, Request(0, 2000, 1e9, 20_000, True)))
        print(f"fates on the level, e = {restitution:g}: {rate:,.0f} motions per second and core")


if __name__ == "__main__":
    main()
