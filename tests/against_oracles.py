"""Random motions against independent truths: python tests/against_oracles.py --seed N --count M.

The oracles integrate the equations of mechanics in time and import nothing of hophoop; derivatives are compared with
differences of motions. The line of a motion that is off says how to repeat it alone.
"""

import argparse
import math
import sys
from dataclasses import replace

import numpy as np

import hophoop as hh
from differences import compare_derivatives
from hophoop.results.poses import poses_of
from interrupted import check_restart, check_until
from oracle_program import compare, compare_events, draw, scenario_of
from oracles import hybrid, precise

UNTILS = ("takeoff", "reversal", "landings:1", "landings:2", "revolutions:0.5", "angle:2")
EVENTS = 40  # of a motion whose derivatives are compared
DIGITS = 25
POINT = 1e-8  # between a point of the hoop and the oracle's, over R


def case_of(seed):
    """A random case; one in four has a resistance to rolling that the hoop allows, and with which the model has an answer."""
    case, random = draw(seed), np.random.default_rng([seed, 66])
    resistance = float(10.0 ** random.uniform(-3.0, -1.0)) if random.random() < 0.25 else 0.0
    try:
        status = hh.simulate(scenario_of(found := replace(case, rolling_resistance=resistance))).status
    except ValueError:
        return case
    return case if status == "undetermined" else found


def check_motion(case):
    """Events, energies and samples; where SciPy's steps lose digits, events against series in mpmath."""
    try:
        compare(case)
    except AssertionError:
        if case.rolling_resistance:
            raise
        compare_events(hh.simulate(scenario_of(case)), precise.solve(case, DIGITS).events, 9)


def check_points(case):
    """Rim, load and centre of gravity in the world, as plots and films draw them."""
    truth, motion = hybrid.solve(case), hh.simulate(scenario_of(case))
    slope = np.array([[math.cos(case.slope), math.sin(case.slope)], [-math.sin(case.slope), math.cos(case.slope)]])
    for part in (0.1, 0.45, 0.8):
        t = part * truth.end
        state, poses = truth.at(t), poses_of(motion, t)
        center = np.array([state["x"], case.radius + state["height"]])
        arm = case.radius * case.eccentricity * np.array([math.sin(state["angle"]), math.cos(state["angle"])])
        for found, point in ((poses.center[0], center), (poses.gravity_center[0], center + arm)):
            off = np.abs(found - slope @ point).max()
            assert off < POINT * case.radius * (1.0 + abs(state["x"])), (t, off)


def check_digits(case):
    """The first events in many digits, against series in mpmath, or with resistance to rolling against SciPy's steps."""
    brief = replace(case, duration=1.0, max_events=6)
    if case.rolling_resistance:
        true, digits = hybrid.solve(brief).events, 9
    else:
        true, digits = precise.solve(brief, DIGITS + 10).events, DIGITS - 5
    compare_events(hh.simulate(scenario_of(brief), digits=DIGITS), true, digits)


def check_derivatives(case):
    """One-sided where the motion has a kink."""
    wrong, _ = compare_derivatives(scenario_of(case).with_values({"contact.max_events": EVENTS}))
    assert not wrong, wrong[:3]


def check_parts(case):
    """Motions that go on from a state, and those that end before their duration."""
    motion = hh.simulate(scenario_of(case))
    for part in (0.2, 0.6):
        check_restart(motion, motion.at(part * motion.duration))
    check_restart(motion, motion.events[len(motion.events) // 2])
    for until in UNTILS:
        check_until(motion, until)


CHECKS = {
    "motion": check_motion,
    "points": check_points,
    "digits": check_digits,
    "derivatives": check_derivatives,
    "parts": check_parts,
}


def problems(seed):
    """What is off in one motion."""
    case = case_of(seed)
    for name, check in CHECKS.items():
        try:
            check(case)
        except AssertionError as error:
            yield f"{name}: {' '.join(str(error).split())[:300]}"


def main(argv):
    """Compare motions and print what is off; return 1 if something is."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0, help="of the first motion")
    parser.add_argument("--count", type=int, default=60, help="of motions; the seed counts on")
    given = parser.parse_args(argv)
    count = 0
    for seed in range(given.seed, given.seed + given.count):
        for problem in problems(seed):
            count += 1
            print(f"{problem}\n  python tests/against_oracles.py --seed {seed} --count 1", flush=True)
    print(f"{given.count} motions, seeds {given.seed} to {given.seed + given.count - 1}: {count} problems")
    return int(count > 0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
