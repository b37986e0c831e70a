"""Numbers of docs/gaits.md: special points of branches, gears of a light load, and a hoop that one can build. A minute."""

from __future__ import annotations

import math

from figures.gaits import branches, doubled, on_slope

import hophoop as hh


def special_points() -> None:
    """Where gaits begin, end and double."""
    first, second = branches()
    doubling = next(one for one in second.special if one.kind == "period doubling")
    fourth = doubled(doubling).follow("plane.slope", (math.radians(1.19), math.radians(1.3)))
    steep = next(gait for gait in hh.gaits.find(on_slope(15.2), 2, near=3.14) if gait.stable)
    steep_branch = steep.follow("plane.slope", (math.radians(15.0), math.radians(16.5)))
    for branch in (first, second, fourth, steep_branch):
        print(branch)
        for one in branch.special:
            factors = " → ".join(f"{factor:.6f}" for factor in one.multipliers)
            print(f"| {math.degrees(one.parameter):.9f}° | {one.kind} | {one.event} | {one.omega:.12f} | {factors} |")


def gears() -> None:
    """All gaits of one hop of a light load on 3°."""
    for gait in hh.gaits.find(on_slope(3.0, hh.Hoop.ideal(0.15)), fastest=18.0):
        if gait.hops == 1:
            print(
                f"| {gait.revolutions} | {gait.speed:.6f} | {gait.hop_height:.5f} | {gait.multipliers[0].real:+.6f} "
                f"| {'yes' if gait.stable else 'no'} |"
            )


def real_hoop() -> None:
    """The hoop of 30 cm that hops for ever: its gait, its range of slopes, and how it depends on slope and friction."""
    scenario = hh.Scenario(hoop=hh.Hoop.ideal(0.5, radius=0.3), plane=hh.Plane(slope=math.radians(3)))
    gait = hh.gaits.find(scenario, near=15.8)[0]
    print(gait, f"hop {100 * gait.hop_height:.3f} cm, {gait.time:.4f} s, {gait.distance:.4f} m")
    for path, step in (("plane.slope", math.radians(0.1)), ("plane.mu", 0.01), ("hoop.load_fraction", 0.01)):
        value = 0.5 if path.startswith("hoop") else {"plane.slope": math.radians(3), "plane.mu": 1.0}[path]
        found = []
        for sign in (1, -1):
            changed = scenario.replace(path, value + sign * step)
            found.append(hh.gaits.find(changed, near=gait.state.omega)[0])
        print(path, "hop changes by", 1e3 * (found[0].hop_height - found[1].hop_height) / 2, "mm per", step)
    branch = gait.follow("plane.slope", (math.radians(0.3), math.radians(5)))
    for one in branch.special:
        print(f"{math.degrees(one.parameter):.6f}° {one.kind} {one.event} {one.multipliers}")


if __name__ == "__main__":
    special_points()
    gears()
    real_hoop()
