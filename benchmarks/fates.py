"""Fates of random scenarios over γ, slope, μ, e and f, and a check of some by following them much longer.

    python benchmarks/fates.py [--count 5000] [--seed 35] [--passages 2000] [--check-every 10]

Each is computed by itself, so that the slowest is known; one that takes longer than --hangs ends the program with its place.
"""

from __future__ import annotations

import argparse
import collections
import faulthandler
import math
import time

import numpy as np

import hophoop as hh

LATE = 2000.0  # √(R/g), for which a motion is followed on from its last passage
AGES = 1e6  # √(R/g), within which a hoop must rest
PERIODS = 20  # more of a gait that must repeat itself
REPEATS = 1e-7  # relative difference of θ̇ that is a repetition


def scenario_of(seed: int, index: int) -> hh.Scenario:
    """The scenario for which (seed, index) tells everything, in units of R and g."""
    random = np.random.default_rng([seed, index])
    plane = hh.Plane(
        gravity=1.0,
        slope=float(random.choice([0.0, random.uniform(0.0, 0.1), random.uniform(0.0, 0.6)])),
        mu=float(random.uniform(0.02, 2.0)),
        restitution=float(random.choice([0.0, random.uniform(0.0, 0.9)])),
        rolling_resistance=float(random.choice([0.0, random.uniform(0.0, 0.1)])),
    )
    hoop = hh.Hoop.ideal(float(random.uniform(0.05, 0.95)))
    angle = float(random.uniform(-math.pi, math.pi))
    return hh.Scenario(hoop=hoop, plane=plane, start=hh.Start.rolling(float(random.uniform(-4.0, 4.0)), angle=angle))


def problem_of(given: hh.Scenario, fate: str, period: int, decided_at: int) -> str | None:
    """What a much longer motion does that its fate does not allow, or None."""
    if fate == "rests":
        motion = hh.simulate(given.replace("duration", AGES))
        return None if motion.status == "at_rest" else f"rests, but is {motion.status} after {AGES:g}"
    more = PERIODS * max(period, 1)
    found = hh.passages(given, decided_at + more)
    if fate == "gait":
        if len(found) < decided_at + more:
            return f"a gait that ends after {len(found)} passages: {found.status}"
        apart = np.abs(found.omega[-period:] - found.omega[-2 * period : -period]) / (1.0 + np.abs(found.omega[-period:]))
        return None if apart.max() <= REPEATS else f"a gait that differs by {apart.max():.1e} a period later"
    last = given.replace("start", found.start(-1)) if len(found) else given
    motion = hh.simulate(last.replace("duration", LATE))
    late = motion.at(np.linspace(0.5 * motion.duration, motion.duration, 400))
    if fate == "rocks" and np.ptp(late.angle) >= 2.0 * math.pi:
        return f"rocks, but turns by {np.ptp(late.angle):.2f} rad late"
    if fate in ("rolls ahead", "rolls back") and (late.omega * (1.0 if fate == "rolls ahead" else -1.0)).min() <= 0.0:
        return f"{fate}, but does not"
    return None


def main() -> int:
    """Print how many have each fate, the slowest ones, and what a longer motion contradicts."""
    options = argparse.ArgumentParser()
    options.add_argument("--count", type=int, default=5_000)
    options.add_argument("--seed", type=int, default=35)
    options.add_argument("--passages", type=int, default=2_000)
    options.add_argument("--check-every", type=int, default=10)
    options.add_argument("--hangs", type=float, default=300.0, help="s")
    given = options.parse_args()
    counts: collections.Counter[str] = collections.Counter()
    checked: collections.Counter[str] = collections.Counter()
    spent, problems = [], []
    for index in range(given.count):
        faulthandler.dump_traceback_later(given.hangs, exit=True)
        scenario = scenario_of(given.seed, index)
        began = time.process_time()
        judged = hh.gaits.fates([scenario], given.passages)
        spent.append((time.process_time() - began, index))
        fate = str(judged.fates[0])
        counts[fate] += 1
        if index % given.check_every == 0 and fate in ("rocks", "rests", "gait", "rolls ahead", "rolls back"):
            checked[fate] += 1
            found = problem_of(scenario, fate, int(judged.periods[0]), int(judged.passages[0]))
            if found:
                problems.append(f"scenario {index}: {found}")
        faulthandler.cancel_dump_traceback_later()
    for fate, number in counts.most_common():
        print(f"{fate}: {number} ({100.0 * number / given.count:.1f} %), {checked[fate]} checked")
    print("slowest: " + ", ".join(f"{index} in {seconds:.2f} s" for seconds, index in sorted(spent)[:-6:-1]))
    print("\n".join(problems) or "no contradiction")
    return 1 if problems else 0


if __name__ == "__main__":
    raise SystemExit(main())
