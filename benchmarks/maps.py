"""Speed of maps, beside a loop over simulate(), SciPy and MuJoCo, with the classes that MuJoCo gets wrong.

    python benchmarks/maps.py [--motions 20000] [--json FILE] [--skip scipy mujoco cluster]

Motions are those of γ = 3/4 with μ from 0 to 2 and v0 from 0 to 5 m/s over the first revolution, on a grid or drawn at random.
Times are those of the process (CPU seconds), so that a busy machine does not spoil them; only the scaling
over workers needs wall time. MuJoCo is installed apart (`pip install mujoco`); the SciPy solution is the tests' own oracle.
"""

from __future__ import annotations

import argparse
import json
import math
import platform
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import hophoop as hh
from hophoop import maps
from hophoop.maps.grid.cells import make_cells
from hophoop.maps.grid.evaluate import run_cells
from hophoop.maps.grid.quantities import make_span

STEP = 1e-3  # of MuJoCo [s]
SLIPPING = 0.02  # slip velocity from which on MuJoCo's rim slips [m/s]; its friction always creeps a little
LIFTED = 1e-3  # gap from which on MuJoCo's rim is off the plane; its soft contact trembles [m]
SHORTEST = 4e-3  # phases of MuJoCo that are shorter are noise [s]


def draw(count: int, seed: int = 1) -> dict[str, np.ndarray]:
    """Random cells of the map."""
    rng = np.random.default_rng(seed)
    return {"plane.mu": rng.uniform(0.0, 2.0, count), "start.speed": rng.uniform(0.0, 5.0, count)}


def cpu(work) -> float:
    """CPU seconds of a call."""
    began = time.process_time()
    work()
    return time.process_time() - began


def grid(side: int) -> dict[str, np.ndarray]:
    """The same window in the order of a map, where neighbours take the same branches."""
    mu, speed = np.meshgrid(np.linspace(0.0, 2.0, side), np.linspace(0.0, 5.0, side), indexing="ij")
    return {"plane.mu": mu.reshape(-1), "start.speed": speed.reshape(-1)}


def kernel_rate(values: dict[str, np.ndarray]) -> dict[str, float]:
    """Motions per second and core, best of three."""
    count = values["plane.mu"].size
    span = make_span("first_revolution")
    run_cells(make_cells(hh.Scenario(), draw(128), 128), span, 0)

    def work():
        run_cells(make_cells(hh.Scenario(), values, count), span, 0)

    return {"motions": count, "motions_per_second_and_core": count / min(cpu(work) for _ in range(3))}


def simulate_rate(count: int) -> dict[str, float]:
    """The same motions by a loop over simulate(), each as long as its first revolution."""
    values = draw(count)
    times = maps.points(None, values, ["time"])["time"]
    scenarios = [
        hh.Scenario(duration=max(float(t), 1e-3), start=hh.Start.rolling(v), plane=hh.Plane(mu=mu))
        for t, mu, v in zip(times, values["plane.mu"], values["start.speed"], strict=True)
    ]
    hh.simulate(scenarios[0])

    def work():
        for scenario in scenarios:
            _ = hh.simulate(scenario).sequence

    return {"motions": count, "motions_per_second_and_core": count / cpu(work)}


def scipy_rate(count: int) -> dict[str, float]:
    """The same motions by DOP853 with events (tests/oracles)."""
    sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
    from oracles.cases import rolling
    from oracles.hybrid import solve

    values = draw(count)
    times = maps.points(None, values, ["time"])["time"]

    def work():
        for t, mu, v in zip(times, values["plane.mu"], values["start.speed"], strict=True):
            solve(rolling("map", v, mu, duration=max(float(t), 1e-3)))

    return {"motions": count, "motions_per_second_and_core": count / cpu(work)}


MODEL = """
<mujoco>
  <option timestep="{step}" gravity="0 0 -9.81" cone="elliptic" impratio="100" integrator="implicitfast"/>
  <worldbody>
    <geom name="plane" type="plane" size="100 1 0.1" friction="{mu} 0 0" condim="3" solref="0.002 1"/>
    <body name="hoop" pos="0 0 1">
      <joint name="x" type="slide" axis="1 0 0"/>
      <joint name="z" type="slide" axis="0 0 1"/>
      <joint name="turn" type="hinge" axis="0 1 0"/>
      <inertial pos="0 0 0.75" mass="1" diaginertia="0.4375 0.4375 0.4375"/>
      <geom name="rim" type="cylinder" size="1 0.05" euler="90 0 0" friction="{mu} 0 0" condim="3"
            solref="0.002 1"/>
    </body>
  </worldbody>
</mujoco>
"""


def mujoco_sequence(mu: float, speed: float, most: float) -> str:
    """Phases of MuJoCo's motion over the first revolution, at a time step of 1 ms."""
    import mujoco

    model = mujoco.MjModel.from_xml_string(MODEL.format(step=STEP, mu=max(mu, 1e-6)))
    data = mujoco.MjData(model)
    data.qvel[:] = speed, 0.0, speed
    modes: list[str] = []
    gaps: list[float] = []
    while data.time < most and abs(data.qpos[2]) < 2.0 * math.pi and data.qvel[2] > 0.0:
        mujoco.mj_step(model, data)
        slip = data.qvel[0] - data.qvel[2]
        gaps.append(data.qpos[1])
        if gaps[-1] > LIFTED:
            # it took off where the gap began to grow
            while len(gaps) > 1 and gaps[-2] < gaps[-1]:
                gaps.pop()
            return phases(modes[: len(gaps) - 1]) + "H"
        modes.append("R" if abs(slip) < SLIPPING else ("K" if slip > 0 else "S"))
    return phases(modes)


def phases(modes: list[str]) -> str:
    """Letters of runs that are not noise."""
    text = ""
    run = 0
    for i, mode in enumerate(modes):
        run = run + 1 if i and modes[i - 1] == mode else 1
        if run * STEP >= SHORTEST and not text.endswith(mode):
            text += mode
    return text


def mujoco_rate(count: int) -> dict[str, float]:
    """The same motions by MuJoCo, and how many come out in another class."""
    values = draw(count)
    exact = maps.points(None, values, ["sequence", "time"])
    found = []

    def work():
        for t, mu, v in zip(exact["time"], values["plane.mu"], values["start.speed"], strict=True):
            found.append(mujoco_sequence(mu, v, 2.0 * float(t) + 0.1))

    seconds = cpu(work)
    wrong = [a != b for a, b in zip(exact["sequence"], found, strict=True)]
    hops = [("H" in a) != ("H" in b) for a, b in zip(exact["sequence"], found, strict=True)]
    slipping = [w for w, a in zip(wrong, exact["sequence"], strict=True) if a not in ("R", "H")]
    return {
        "motions": count,
        "motions_per_second_and_core": count / seconds,
        "wrong_classes": int(sum(wrong)),
        "of_those_that_slip": len(slipping),
        "wrong_of_those_that_slip": int(sum(slipping)),
        "wrong_about_hopping": int(sum(hops)),
    }


def scaling(side: int) -> dict[str, float]:
    """Wall time of one map over 1 and 2 worker processes of a Dask cluster, and over none."""
    axes = {"plane.mu": np.linspace(0.01, 2.0, side), "start.speed": np.linspace(0.01, 5.0, side)}
    result: dict[str, float] = {"motions": side * side}
    from distributed import Client, LocalCluster

    for workers in (1, 2):
        with (
            tempfile.TemporaryDirectory() as folder,
            LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster,
            Client(cluster),
        ):
            small = {name: values[:: max(1, side // 16)] for name, values in axes.items()}
            address = cluster.scheduler_address
            # every worker loads its compiled kernel before the clock starts
            maps.sweep(None, small, out=Path(folder) / "warm.zarr", scheduler=address, chunk_cells=16)
            began = time.perf_counter()
            maps.sweep(None, axes, out=Path(folder) / "map.zarr", scheduler=address, chunk_cells=8192)
            result[f"seconds_with_{workers}"] = time.perf_counter() - began
    result["speed_up"] = result["seconds_with_1"] / result["seconds_with_2"]
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--motions", type=int, default=20000)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--skip", nargs="*", default=[])
    options = parser.parse_args()
    work = {
        "map": lambda: kernel_rate(grid(math.isqrt(options.motions))),
        "scattered": lambda: kernel_rate(draw(options.motions)),
        "simulate": lambda: simulate_rate(max(20, options.motions // 50)),
        "scipy": lambda: scipy_rate(max(5, options.motions // 2000)),
        "mujoco": lambda: mujoco_rate(max(20, options.motions // 100)),
        "cluster": lambda: scaling(max(64, math.isqrt(10 * options.motions))),
    }
    results: dict[str, dict[str, float]] = {"machine": {"python": platform.python_version()}}  # type: ignore[dict-item]
    for name, measure in work.items():
        if name in options.skip:
            continue
        results[name] = measure()
        print(name, json.dumps(results[name]), flush=True)
    rate = results.get("map", {}).get("motions_per_second_and_core")
    for name in ("simulate", "scipy", "mujoco"):
        if rate and name in results:
            print(f"{rate / results[name]['motions_per_second_and_core']:,.0f} times as fast as {name}")
    if options.json:
        options.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
