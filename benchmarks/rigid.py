"""One article motion (v0 = 3.1 m/s, 2 s): hophoop beside SciPy's DOP853 with events, in one run.

    python benchmarks/rigid.py

Prints the median time of each, the ratio to SciPy, and the largest relative error of the event times against
the 25-digit reference in tests/data. The kernel's time is that of a motion in a map. `benchmarks/speed.py` times first runs.
"""

from __future__ import annotations

import argparse
import json
import math
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

import hophoop as hh
from hophoop.kernel.native.library import why_missing
from hophoop.maps.grid.cells import make_cells
from hophoop.maps.grid.evaluate import run_cells
from hophoop.maps.grid.quantities import make_span

SCENARIO = hh.Scenario(duration=2.0)
REFERENCE = Path(__file__).parent.parent / "tests" / "data" / "article_v3.1_mu1.json"
ROUNDS, KERNELS = 9, 100
EPS, KAP, MU, G = 0.75, 0.4375, 1.0, 9.81


def forces(theta: float, rate: float, sigma: int) -> tuple[float, float]:
    """(F, N) in rolling (sigma = 0) or slip, in SI for R = m = 1."""
    s, c = math.sin(theta), math.cos(theta)
    tt, nn, tn = 1 + (1 + EPS * c) ** 2 / KAP, 1 + EPS**2 * s**2 / KAP, -EPS * s * (1 + EPS * c) / KAP
    ft, fn = EPS * s * rate**2, -G + EPS * c * rate**2
    if sigma == 0:
        det = tt * nn - tn * tn
        return (-nn * ft + tn * fn) / det, (tn * ft - tt * fn) / det
    normal = -fn / (nn - sigma * MU * tn)
    return -sigma * MU * normal, normal


def slope(mode: str) -> Callable[[float, np.ndarray], list[float]]:
    """Right-hand side over (x, y, θ, ẋ, ẏ, θ̇)."""
    sigma = {"R": 0, "K": 1, "S": -1, "H": 0}[mode]

    def rates(t: float, z: np.ndarray) -> list[float]:
        theta, rate = z[2], z[5]
        s, c = math.sin(theta), math.cos(theta)
        force, normal = (0.0, 0.0) if mode == "H" else forces(theta, rate, sigma)
        alpha = (EPS * s * normal - (1 + EPS * c) * force) / KAP
        ax = force - EPS * (alpha * c - rate**2 * s)
        ay = normal - G + EPS * (alpha * s + rate**2 * c)
        return [z[3], z[4], rate, ax, ay if mode == "H" else 0.0, alpha]

    return rates


def guard(function: Callable[[np.ndarray], float]) -> Callable[[float, np.ndarray], float]:
    """A terminal event where `function` falls through zero."""

    def event(t: float, z: np.ndarray) -> float:
        return function(z)

    event.terminal = True  # type: ignore[attr-defined]
    event.direction = -1  # type: ignore[attr-defined]
    return event


def cone(side: int) -> Callable[[np.ndarray], float]:
    """Margin to one side of the friction cone in rolling."""

    def margin(z: np.ndarray) -> float:
        force, normal = forces(z[2], z[5], 0)
        return MU * normal - side * force

    return margin


def scipy_motion(duration: float = 2.0) -> list[tuple[str, float]]:
    """The same motion by solve_ivp: DOP853, rtol 1e-10, one call a phase; (mode that begins, time)."""
    t, z, mode = 0.0, np.array([0.0, 0.0, 0.0, 3.1, 0.0, 3.1]), "R"
    found = []
    while t < duration:
        sigma = {"K": 1, "S": -1}.get(mode, 0)
        if mode == "R":
            events = [guard(cone(1)), guard(cone(-1))]
        elif mode == "H":
            events = [guard(lambda z: z[1])]
        else:
            events = [
                guard(lambda z, sigma=sigma: sigma * (z[3] - z[5])),
                guard(lambda z: G - EPS * math.cos(z[2]) * z[5] ** 2),
            ]
        if mode in "KSH":  # leave the event's own surface before watching it
            step = solve_ivp(slope(mode), (t, t + 1e-4), z, method="DOP853", rtol=1e-10, atol=1e-12)
            t, z = step.t[-1], step.y[:, -1]
        result = solve_ivp(slope(mode), (t, duration), z, method="DOP853", rtol=1e-10, atol=1e-12, events=events)
        t, z = result.t[-1], result.y[:, -1].copy()
        if result.status == 0:
            break
        which = next(i for i, times in enumerate(result.t_events) if len(times))
        if mode == "R":
            mode = "S" if which == 0 else "K"
        elif mode == "H":
            s, c = math.sin(z[2]), math.cos(z[2])
            tt, nn, tn = 1 + (1 + EPS * c) ** 2 / KAP, 1 + EPS**2 * s**2 / KAP, -EPS * s * (1 + EPS * c) / KAP
            # this landing sticks: both velocities of the contact vanish
            impulse = np.linalg.solve([[tt, tn], [tn, nn]], [-(z[3] - z[5]), -z[4]])
            z[5] += (EPS * s * impulse[1] - (1 + EPS * c) * impulse[0]) / KAP
            z[1], z[3], z[4], mode = 0.0, z[5], 0.0, "R"
        elif which == 0:
            z[3], mode = z[5], "R"
        else:
            mode = "H"
        found.append((mode, t))
    return found


def median(function: Callable[[], object], runs: int) -> float:
    """Median wall time of a call [s]."""
    function()
    times = []
    for _ in range(runs):
        begin = time.perf_counter()
        function()
        times.append(time.perf_counter() - begin)
    return statistics.median(times)


def errors() -> tuple[float, float]:
    """Largest relative error of the event times of (hophoop, SciPy)."""
    kinds = ("slip_start", "stick", "takeoff", "impact")
    events = json.loads(REFERENCE.read_text())["events"]
    truth = [float(event["t"]) for event in events if event["kind"] in kinds and float(event["t"]) < 2.0]
    ours = [event.t for event in hh.simulate(SCENARIO).events if event.kind in kinds]
    theirs = [t for _, t in scipy_motion()]
    assert len(truth) == len(ours) == len(theirs)

    def worst(times: list[float]) -> float:
        return max(abs(a - b) / a for a, b in zip(truth, times, strict=True))

    return worst(ours), worst(theirs)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.parse_args()
    if why_missing():
        sys.exit(why_missing())
    cells, span = make_cells(SCENARIO, {}, KERNELS), make_span("duration")

    # In turn, so that a machine whose speed changes does not favour one of them.
    times: dict[str, list[float]] = {"scipy": [], "simulate": [], "kernel": []}
    scipy_motion()
    for _ in range(ROUNDS):
        times["scipy"].append(median(scipy_motion, 3))
        times["simulate"].append(median(lambda: hh.simulate(SCENARIO), 50))
        times["kernel"].append(median(lambda: run_cells(cells, span, 0), 20) / KERNELS)
    reference, call, bare = (statistics.median(values) for values in times.values())
    error, scipy_error = errors()
    print(f"SciPy DOP853, rtol 1e-10   {reference * 1e3:9.2f} ms              error {scipy_error:.1e}")
    print(f"simulate()                 {call * 1e6:9.1f} µs  {reference / call:6.0f} ×  error {error:.1e}")
    print(f"kernel                     {bare * 1e6:9.1f} µs  {reference / bare:6.0f} ×")
    print(f"kernel, motions per second and core {1.0 / bare:9.0f}")


if __name__ == "__main__":
    main()
