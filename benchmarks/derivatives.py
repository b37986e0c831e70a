"""What derivatives cost beside the motion: `python benchmarks/derivatives.py [--json] [--rolling-resistance F]`.

The article's motion (v0 = 3.1 m/s, 2 s) and its derivatives with respect to 1 and 12 parameters, measured in turn in one
process, so that the ratios hold on a busy machine too: the bare kernels, and the calls from Python.
"""

import argparse
import json
import math
import statistics
import time

import numpy as np

import hophoop as hh
from hophoop.derivatives.events.ending import propagate_motion
from hophoop.derivatives.parameters import directions_of
from hophoop.derivatives.results.propagation import propagate
from hophoop.derivatives.workspace import ROWS, KnownMotion, Workspace, new_solution
from hophoop.kernel.native import compiled
from hophoop.kernel.numerics.collocation import ORDER
from hophoop.kernel.records.cells import start_of
from hophoop.kernel.records.layout import EVENT, SEGMENT
from hophoop.kernel.records.scratch import new_scratch
from hophoop.kernel.rigid.run import run
from hophoop.scenario import cell_of, time_unit
from hophoop.simulation.exact_start import NO_SCRIPT

PATHS = (
    "hoop.load_fraction", "hoop.radius", "hoop.mass", "plane.gravity", "plane.slope", "plane.mu_static",
    "plane.mu_kinetic", "plane.restitution", "start.x", "start.angle", "start.speed", "duration",
)  # fmt: skip
ROUNDS = 400


def plain(scenario):
    """The bare kernel of the motion, as a call without arguments."""
    unit = time_unit(scenario.hoop, scenario.plane)
    start = start_of(np.array([cell_of(scenario)], dtype=object).T, 0, unit)
    body, scratch = scenario.to_body(), new_scratch()
    events, segments = np.empty(64, EVENT), np.empty(256, SEGMENT)
    end = scenario.duration / unit
    arguments = (body, start, end, math.nan, 0, events, segments, scratch, NO_SCRIPT)
    kernel = compiled(run)
    return lambda: kernel(*arguments)


def derived(motion, paths):
    """The bare kernel of the derivatives."""
    scenario, events, segments = motion.scenario, motion.tables["events"], motion.tables["segments"]
    given = directions_of(scenario, paths)
    known = KnownMotion(events, segments, scenario.duration / motion.units.time, motion.kernel_doubt)
    solution, workspace = (
        new_solution(len(events), len(segments), len(paths)),
        Workspace(new_scratch(), np.zeros((ROWS, ORDER))),
    )
    start = given.start.copy()
    arguments = (scenario.to_body(), known, given.parameter_tangents, start, False, solution, workspace)
    kernel = compiled(propagate_motion)

    def call():
        start[:] = given.start
        kernel(*arguments)

    return call


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--json", action="store_true", help="print JSON")
    parser.add_argument("--rolling-resistance", type=float, default=0.0, help="of the plane (default 0)")
    arguments = parser.parse_args()
    as_json = arguments.json
    scenario = hh.Scenario(plane=hh.Plane(rolling_resistance=arguments.rolling_resistance), duration=2.0)
    motion = hh.simulate(scenario)
    calls = {
        "motion, kernel": plain(scenario),
        "1 parameter, kernel": derived(motion, PATHS[:1]),
        "12 parameters, kernel": derived(motion, PATHS),
        "simulate()": lambda: hh.simulate(scenario),
        "12 parameters, propagated": lambda: propagate(motion, PATHS),
        "motion.sensitivity(1 of 12)": lambda: motion.sensitivity("takeoff.angle", PATHS),
        "motion.sensitivity(8 of 12)": lambda: motion.sensitivity(
            ["takeoff.t", "takeoff.angle", "hop.height", "hop.distance", "hop.duration", "impact.slip", "end.x", "energy_lost"],
            PATHS,
        ),
    }
    seconds = {name: [] for name in calls}
    for _ in range(ROUNDS):
        for name, call in calls.items():
            began = time.perf_counter()
            call()
            seconds[name].append(time.perf_counter() - began)
    medians = {name: statistics.median(each) for name, each in seconds.items()}
    if as_json:
        print(json.dumps(medians))
        return
    for name, each in medians.items():
        beside = "motion, kernel" if "kernel" in name else "simulate()"
        print(f"{name:<30} {each * 1e6:8.1f} µs   {each / medians[beside]:6.2f} times {beside}")


if __name__ == "__main__":
    main()
