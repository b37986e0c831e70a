"""Statements on rolling: formulas, forces, required friction. The article's formulas are written independently of ours."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from hophoop import theory
from hophoop.article.runs import Runs, first_time, rolling_motion
from hophoop.article.scenarios import GAMMA, GRAVITY, RUNS
from hophoop.article.statement import Result
from hophoop.scenario import Hoop

ROUNDING = 1e-11
BESIDE = 1e-9  # relative distance of the motions on both sides of a threshold


def potential_energy(runs: Runs) -> Result:
    sample = runs.sample("slow")
    formula = GAMMA * GRAVITY * (np.cos(sample.angle) - 1.0)
    return _compared(sample.potential - formula, 2.0 * GAMMA * GRAVITY)


def kinetic_energy(runs: Runs) -> Result:
    sample = runs.sample("slow")
    formula = (1.0 + GAMMA * np.cos(sample.angle)) * sample.omega**2
    return _compared(sample.kinetic - formula, np.max(sample.kinetic))


def _compared(deviations: Any, size: float) -> Result:
    error = float(np.max(np.abs(deviations)) / size)
    return Result(error < ROUNDING, {"relative_deviation": error})


def rolling_rate(cosine: Any, speed: float) -> Any:
    """Return θ̇ of rolling by the article's formula, at cos θ, from a speed at the top [rad/s]."""
    return np.sqrt((GAMMA * GRAVITY * (1.0 - cosine) + speed**2 * (1.0 + GAMMA)) / (1.0 + GAMMA * cosine))


def angular_velocity(runs: Runs) -> Result:
    errors = {}
    for name in ("slow", "faster"):
        sample = runs.sample(name)
        errors[name] = np.max(np.abs(sample.omega / rolling_rate(np.cos(sample.angle), RUNS[name][0]) - 1.0))
    return Result(max(errors.values()) < ROUNDING, {"relative_deviation": errors})


def largest_angular_velocity(runs: Runs) -> Result:
    motion = runs.motion("slow")
    ours, formula = motion.at(first_time(motion, math.pi)).omega, rolling_rate(-1.0, 0.1)
    holds = abs(ours / formula - 1.0) < ROUNDING and max(runs.sample("slow").omega) <= ours * (1.0 + ROUNDING)
    return Result(holds, {"omega_at_pi": ours, "formula": formula})


def slow_motion(runs: Runs) -> Result:
    motion = runs.motion("slow")
    back = motion.at(first_time(motion, 2.0 * math.pi))
    _, peak = runs.extremes("slow", "vx")
    numbers = {"sequence": motion.sequence, "largest_speed": peak, "speed_at_360": back.vx, "t_at_360": back.t}
    return Result(motion.sequence == "R" and abs(back.vx - 0.1) < 1e-9, numbers)


def friction_used(runs: Runs) -> Result:
    ours = np.nanmax(runs.sample("slow").utilization(runs.plane))
    mu, angle = theory.needed_friction(runs.hoop, 0.1, runs.plane)
    rest = theory.needed_friction(runs.hoop, 0.0, runs.plane).mu
    numbers = {"utilization": mu, "angle": angle, "utilization_from_rest": rest}
    return Result(abs(mu - 0.38) < 0.005 and abs(ours - mu) < 1e-4, numbers)


def friction_needed(runs: Runs) -> Result:
    needed = theory.needed_friction(runs.hoop, 0.1, runs.plane).mu
    below, above = (rolling_motion(GAMMA, needed * (1.0 + off), 0.1, 6.0).sequence for off in (-BESIDE, BESIDE))
    holds = abs(needed - 0.38) < 0.005 and above == "R" and below != "R"
    return Result(holds, {"mu": needed})


def normal_force(runs: Runs) -> Result:
    least = {name: runs.extremes(name, "normal_force")[0] for name in ("slow", "faster")}
    return Result(0.0 < least["faster"] < least["slow"], {"least_normal_force": least})


def faster_rolls(runs: Runs) -> Result:
    slow, faster = (list(runs.extremes(name, "vx")) for name in ("slow", "faster"))
    ratios = [high / low for low, high in (slow, faster)]
    sequence = runs.motion("faster").sequence
    holds = sequence == "R" and faster[1] > slow[1] and ratios[1] < ratios[0]
    return Result(holds, {"sequence": sequence, "ratio_of_speeds": ratios, "speeds": faster})


def faster_friction_used(runs: Runs) -> Result:
    slow, fast = (theory.needed_friction(runs.hoop, speed, runs.plane).mu for speed in (0.1, 2.0))
    return Result(2.0 * slow < fast < 1.0, {"utilization": fast, "utilization_slow": slow})


def critical_speed(runs: Runs) -> Result:
    ours = theory.first_slip_speed(runs.hoop, runs.plane)
    below, above = (rolling_motion(GAMMA, 1.0, ours * (1.0 + off), 2.0).sequence for off in (-BESIDE, BESIDE))
    return Result(2.0 < ours < 2.1 and below == "R" and above != "R", {"first_slip_speed": ours, "excess": ours / 2.0 - 1.0})


def massless_limit(runs: Runs) -> Result:
    loads = [0.9, 0.99, 0.999, 0.9999]
    speeds = [theory.max_rolling_speed(Hoop.ideal(gamma), 0.1) for gamma in loads]
    slope = math.log(speeds[-1] / speeds[-2]) / math.log((1.0 - loads[-1]) / (1.0 - loads[-2]))
    return Result(abs(slope + 0.5) < 0.01, {"gamma": loads, "omega": speeds, "exponent": slope})


def massless_slips(runs: Runs) -> Result:
    cases = []
    for mu in (1.0, 10.0, 100.0):
        loads = (1.0 - 10.0**-k for k in range(1, 12))
        gamma = next(gamma for gamma in loads if theory.needed_friction(Hoop.ideal(gamma), 0.1).mu > mu)
        motion = rolling_motion(gamma, mu, 0.1, 12.0)
        slips = motion.find("slip_start") or motion.find("takeoff")
        cases.append({"mu": mu, "gamma": gamma, "angle_deg": math.degrees(slips[0].angle)})
    return Result(all(0.0 < case["angle_deg"] < 180.0 for case in cases), {"cases": cases})
