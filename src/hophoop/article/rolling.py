"""Statements on rolling: formulas, forces, required friction. The article's formulas are written independently of ours."""

from __future__ import annotations

import math

import numpy as np

from hophoop import theory
from hophoop.article.runs import Runs, first_time, largest, rolling_motion
from hophoop.article.scenarios import GAMMA, GRAVITY, RUNS
from hophoop.article.statement import Result, agreement
from hophoop.scenario import Hoop

ROUNDING = 1e-11


def potential_energy(runs: Runs) -> Result:
    sample = runs.sample("slow")
    formula = GAMMA * GRAVITY * (np.cos(sample.angle) - 1.0)
    error = float(np.max(np.abs(sample.potential - formula)) / (2.0 * GAMMA * GRAVITY))
    return Result(
        ours=f"largest deviation along the motion {error:.1e} of the range",
        verdict=agreement(error < ROUNDING),
        numbers={"relative_deviation": error},
    )


def kinetic_energy(runs: Runs) -> Result:
    sample = runs.sample("slow")
    formula = (1.0 + GAMMA * np.cos(sample.angle)) * sample.omega**2
    error = float(np.max(np.abs(sample.kinetic - formula)) / np.max(sample.kinetic))
    return Result(
        ours=f"largest deviation {error:.1e} of the range",
        verdict=agreement(error < ROUNDING),
        numbers={"relative_deviation": error},
    )


def angular_velocity(runs: Runs) -> Result:
    errors = {}
    for name in ("slow", "faster"):
        sample, speed = runs.sample(name), RUNS[name][0]
        cosine = np.cos(sample.angle)
        formula = np.sqrt((GAMMA * GRAVITY * (1.0 - cosine) + speed**2 * (1.0 + GAMMA)) / (1.0 + GAMMA * cosine))
        errors[name] = float(np.max(np.abs(sample.omega / formula - 1.0)))
    return Result(
        ours=f"largest relative deviation {errors['slow']:.1e} at 0.1 m/s, {errors['faster']:.1e} at 2 m/s",
        verdict=agreement(max(errors.values()) < ROUNDING),
        numbers={"relative_deviation": errors},
    )


def largest_angular_velocity(runs: Runs) -> Result:
    motion = runs.motion("slow")
    ours = motion.at(first_time(motion, math.pi)).omega
    formula = math.sqrt((2.0 * GAMMA * GRAVITY + 0.01 * (1.0 + GAMMA)) / (1.0 - GAMMA))
    highest = float(np.max(runs.sample("slow").omega))
    return Result(
        ours=f"{ours:.6f} rad/s at θ = 180°; never more than that",
        verdict=agreement(abs(ours / formula - 1.0) < ROUNDING and highest <= ours * (1.0 + ROUNDING)),
        article=f"θ̇max = (1/R) √{{[2γgR + v₀²(1 + γ)]/(1 − γ)}} = {formula:.6f} rad/s",
        numbers={"omega_at_pi": ours, "formula": formula, "largest_sampled": highest},
    )


def slow_motion(runs: Runs) -> Result:
    motion = runs.motion("slow")
    back = motion.at(first_time(motion, 2.0 * math.pi))
    peak = largest(motion, runs.sample("slow").t, lambda state: state.vx)
    return Result(
        ours=f"phases {motion.sequence}; up to {peak:.3f} m/s, and {back.vx:.6f} m/s again at 360° (t = {back.t:.3f} s)",
        verdict=agreement(motion.sequence == "R" and abs(back.vx - 0.1) < 1e-9),
        numbers={
            "sequence": motion.sequence,
            "largest_speed": peak,
            "speed_at_360": back.vx,
            "t_at_360": back.t,
        },
    )


def friction_used(runs: Runs) -> Result:
    sample = runs.sample("slow")
    ours = float(np.nanmax(sample.utilization(runs.plane)))
    needed = theory.needed_friction(runs.hoop, 0.1, runs.plane)
    rest = theory.needed_friction(runs.hoop, 0.0, runs.plane)
    return Result(
        ours=f"{100.0 * needed.mu:.4f} %, at θ = {math.degrees(needed.angle):.2f}° and its mirror image",
        verdict=agreement(abs(needed.mu - 0.38) < 0.005 and abs(ours - needed.mu) < 1e-4),
        why=f"To the digits given. From the smallest push it would be {100.0 * rest.mu:.4f} %.",
        numbers={"utilization": needed.mu, "angle": needed.angle, "largest_sampled": ours},
    )


def friction_needed(runs: Runs) -> Result:
    needed = float(theory.needed_friction(runs.hoop, 0.1, runs.plane).mu)
    above = rolling_motion(GAMMA, needed * (1.0 + 1e-9), 0.1, 6.0).sequence
    below = rolling_motion(GAMMA, needed * (1.0 - 1e-9), 0.1, 6.0).sequence
    return Result(
        ours=f"μ ≥ {needed:.9f}",
        verdict=agreement(abs(needed - 0.38) < 0.005 and above == "R" and below != "R"),
        numbers={"mu": needed, "sequence_above": above, "sequence_below": below},
    )


def normal_force(runs: Runs) -> Result:
    least = {
        name: -largest(runs.motion(name), runs.sample(name).t, lambda state: -state.normal_force) for name in ("slow", "faster")
    }
    return Result(
        ours=f"least N: {least['slow']:.4f} N at 0.1 m/s, {least['faster']:.4f} N at 2 m/s",
        verdict=agreement(0.0 < least["faster"] < least["slow"]),
        numbers={"least_normal_force": least},
    )


def faster_rolls(runs: Runs) -> Result:
    speeds = {}
    for name in ("slow", "faster"):
        motion, times = runs.motion(name), runs.sample(name).t
        speeds[name] = -largest(motion, times, lambda state: -state.vx), largest(motion, times, lambda state: state.vx)
    slow, fast = speeds["slow"], speeds["faster"]
    ratios = [high / low for low, high in (slow, fast)]
    rolls = runs.motion("faster").sequence == "R"
    return Result(
        ours=f"phases {runs.motion('faster').sequence}; from {fast[0]:.3f} to {fast[1]:.3f} "
        "m/s, a ratio "
        f"of {ratios[1]:.2f} against {ratios[0]:.1f} at 0.1 m/s",
        verdict=agreement(rolls and fast[1] > slow[1] and ratios[1] < ratios[0]),
        numbers={"sequence": runs.motion("faster").sequence, "ratio_of_speeds": ratios},
    )


def faster_friction_used(runs: Runs) -> Result:
    slow, fast = (float(theory.needed_friction(runs.hoop, speed, runs.plane).mu) for speed in (0.1, 2.0))
    return Result(
        ours=f"{100.0 * fast:.3f} % against {100.0 * slow:.3f} %",
        verdict=agreement(2.0 * slow < fast < 1.0),
        numbers={"utilization": fast, "utilization_slow": slow},
    )


def critical_speed(runs: Runs) -> Result:
    ours = float(theory.first_slip_speed(runs.hoop, runs.plane))
    above = rolling_motion(GAMMA, 1.0, ours * (1.0 + 1e-9), 2.0).sequence
    below = rolling_motion(GAMMA, 1.0, ours * (1.0 - 1e-9), 2.0).sequence
    return Result(
        ours=f"from v₀ = {ours:.9f} m/s on, {100.0 * (ours / 2.0 - 1.0):.1f} % more",
        verdict=agreement(2.0 < ours < 2.1 and below == "R" and above != "R", exact=True),
        numbers={"first_slip_speed": ours, "sequence_above": above, "sequence_below": below},
    )


def massless_limit(runs: Runs) -> Result:
    loads = [0.9, 0.99, 0.999, 0.9999]
    speeds = [float(theory.max_rolling_speed(Hoop.ideal(gamma), 0.1)) for gamma in loads]
    slope = math.log(speeds[-1] / speeds[-2]) / math.log((1.0 - loads[-1]) / (1.0 - loads[-2]))
    return Result(
        ours=f"{', '.join(f'{speed:.1f}' for speed in speeds)} rad/s at γ = {', '.join(map(str, loads))}: "
        f"as (1 − γ)^{slope:.3f}",
        verdict=agreement(abs(slope + 0.5) < 0.01),
        numbers={"gamma": loads, "omega": speeds, "exponent": slope},
    )


def massless_slips(runs: Runs) -> Result:
    cases = {}
    for mu in (1.0, 10.0, 100.0):
        gamma = next(
            gamma
            for gamma in (1.0 - 10.0**-k for k in range(1, 12))
            if float(theory.needed_friction(Hoop.ideal(gamma), 0.1).mu) > mu
        )
        motion = rolling_motion(gamma, mu, 0.1, 12.0)
        slips = motion.find("slip_start") or motion.find("takeoff")
        cases[mu] = (gamma, math.degrees(slips[0].angle) if slips else math.nan)
    said = "; ".join(f"μ = {mu:g}: γ = {gamma:.11g} slips at {angle:.1f}°" for mu, (gamma, angle) in cases.items())
    return Result(
        ours=said,
        verdict=agreement(all(0.0 < angle < 180.0 for _, angle in cases.values())),
        numbers={"cases": [{"mu": mu, "gamma": gamma, "angle_deg": angle} for mu, (gamma, angle) in cases.items()]},
    )
