"""Statements on rolling: formulas, forces, required friction. The article's formulas are written independently of ours."""

from __future__ import annotations

import math

import numpy as np

from hophoop import theory
from hophoop.article.runs import Runs, first_time, largest, rolling_motion
from hophoop.article.scenarios import GAMMA, GRAVITY, RUNS
from hophoop.article.statement import Check, Statement
from hophoop.article.verdicts import agreement
from hophoop.scenario import Hoop

ROUNDING = 1e-11


def potential_energy(runs: Runs) -> Statement:
    sample = runs.sample("slow")
    formula = GAMMA * GRAVITY * (np.cos(sample.angle) - 1.0)
    error = float(np.max(np.abs(sample.potential - formula)) / (2.0 * GAMMA * GRAVITY))
    return Statement(
        key="potential_energy",
        section="A First Attempt",
        statement="In rolling the potential energy is a pure harmonic function of the angle.",
        article="W_p = γmgR(cos θ − 1)",
        ours=f"largest deviation along the motion {error:.1e} of the range",
        verdict=agreement(error < ROUNDING),
        why="Taken from the height of the centre of gravity in the computed motion, not from the formula.",
        numbers={"relative_deviation": error},
    )


def kinetic_energy(runs: Runs) -> Statement:
    sample = runs.sample("slow")
    formula = (1.0 + GAMMA * np.cos(sample.angle)) * sample.omega**2
    error = float(np.max(np.abs(sample.kinetic - formula)) / np.max(sample.kinetic))
    return Statement(
        key="kinetic_energy",
        section="A First Attempt",
        statement="The kinetic energy in rolling.",
        article="W_k = mR²(1 + γ cos θ) θ̇²",
        ours=f"largest deviation {error:.1e} of the range",
        verdict=agreement(error < ROUNDING),
        why="Translation of the centre of gravity plus rotation about it, from the computed motion.",
        numbers={"relative_deviation": error},
    )


def angular_velocity(runs: Runs) -> Statement:
    errors = {}
    for name in ("slow", "faster"):
        sample, speed = runs.sample(name), RUNS[name][0]
        cosine = np.cos(sample.angle)
        formula = np.sqrt((GAMMA * GRAVITY * (1.0 - cosine) + speed**2 * (1.0 + GAMMA)) / (1.0 + GAMMA * cosine))
        errors[name] = float(np.max(np.abs(sample.omega / formula - 1.0)))
    return Statement(
        key="angular_velocity",
        section="A First Attempt",
        statement="The angular velocity in rolling, from conservation of energy.",
        article="θ̇ = (1/R) √{[γgR(1 − cos θ) + v₀²(1 + γ)]/(1 + γ cos θ)}",
        ours=f"largest relative deviation {errors['slow']:.1e} at 0.1 m/s, {errors['faster']:.1e} at 2 m/s",
        verdict=agreement(max(errors.values()) < ROUNDING),
        numbers={"relative_deviation": errors},
    )


def fastest(runs: Runs) -> Statement:
    motion = runs.motion("slow")
    ours = motion.at(first_time(motion, math.pi)).omega
    formula = math.sqrt((2.0 * GAMMA * GRAVITY + 0.01 * (1.0 + GAMMA)) / (1.0 - GAMMA))
    highest = float(np.max(runs.sample("slow").omega))
    return Statement(
        key="largest_angular_velocity",
        section="A First Attempt",
        statement="The angular velocity is largest with the load down, θ = π.",
        article=f"θ̇max = (1/R) √{{[2γgR + v₀²(1 + γ)]/(1 − γ)}} = {formula:.6f} rad/s",
        ours=f"{ours:.6f} rad/s at θ = 180°; never more than that",
        verdict=agreement(abs(ours / formula - 1.0) < ROUNDING and highest <= ours * (1.0 + ROUNDING)),
        numbers={"omega_at_pi": ours, "formula": formula, "largest_sampled": highest},
    )


def slow_rolls(runs: Runs) -> Statement:
    motion = runs.motion("slow")
    back = motion.at(first_time(motion, 2.0 * math.pi))
    peak = largest(motion, runs.sample("slow").t, lambda state: state.vx)
    return Statement(
        key="slow_motion",
        section="A First Attempt",
        statement="At 0.1 m/s the hoop rolls through the whole turn; back at the top it has almost stopped.",
        article="pure rolling",
        ours=f"phases {motion.sequence}; up to {peak:.3f} m/s, and {back.vx:.6f} m/s again at 360° (t = {back.t:.3f} s)",
        verdict=agreement(motion.sequence == "R" and abs(back.vx - 0.1) < 1e-9),
        numbers={
            "sequence": motion.sequence,
            "largest_speed": peak,
            "speed_at_360": back.vx,
            "t_at_360": back.t,
        },
    )


def utilization(runs: Runs) -> Statement:
    sample = runs.sample("slow")
    ours = float(np.nanmax(sample.utilization(runs.plane)))
    needed = theory.needed_friction(runs.hoop, 0.1, runs.plane)
    rest = theory.needed_friction(runs.hoop, 0.0, runs.plane)
    return Statement(
        key="friction_used",
        section="A First Attempt",
        statement="At 0.1 m/s only about 38 % of the available friction is used.",
        article="38 %",
        ours=f"{100.0 * needed.mu:.4f} %, at θ = {math.degrees(needed.angle):.2f}° and its mirror image",
        verdict=agreement(abs(needed.mu - 0.38) < 0.005 and abs(ours - needed.mu) < 1e-4),
        why=f"To the digits given. From the smallest push it would be {100.0 * rest.mu:.4f} %.",
        numbers={"utilization": needed.mu, "angle": needed.angle, "largest_sampled": ours},
    )


def friction_needed(runs: Runs) -> Statement:
    needed = float(theory.needed_friction(runs.hoop, 0.1, runs.plane).mu)
    above = rolling_motion(GAMMA, needed * (1.0 + 1e-9), 0.1, 6.0).sequence
    below = rolling_motion(GAMMA, needed * (1.0 - 1e-9), 0.1, 6.0).sequence
    return Statement(
        key="friction_needed",
        section="A First Attempt",
        statement="Rolling through the turn at 0.1 m/s needs a friction of at least 0.38.",
        article="μ ≥ 0.38 (later: 'approximately 0.4')",
        ours=f"μ ≥ {needed:.9f}",
        verdict=agreement(abs(needed - 0.38) < 0.005 and above == "R" and below != "R"),
        why="The motion rolls throughout with a friction greater by 10⁻⁹ of it, and slips with one smaller by as much.",
        numbers={"mu": needed, "sequence_above": above, "sequence_below": below},
    )


def contact_kept(runs: Runs) -> Statement:
    least = {
        name: -largest(runs.motion(name), runs.sample(name).t, lambda state: -state.normal_force) for name in ("slow", "faster")
    }
    return Statement(
        key="normal_force",
        section="Increase the Speed",
        statement="Rolling needs N > 0; at 2 m/s the smallest contact force is smaller than at 0.1 m/s.",
        article="N > 0, minimum decreased",
        ours=f"least N: {least['slow']:.4f} N at 0.1 m/s, {least['faster']:.4f} N at 2 m/s",
        verdict=agreement(0.0 < least["faster"] < least["slow"]),
        numbers={"least_normal_force": least},
    )


def faster_rolls(runs: Runs) -> Statement:
    speeds = {}
    for name in ("slow", "faster"):
        motion, times = runs.motion(name), runs.sample(name).t
        speeds[name] = -largest(motion, times, lambda state: -state.vx), largest(motion, times, lambda state: state.vx)
    slow, fast = speeds["slow"], speeds["faster"]
    ratios = [high / low for low, high in (slow, fast)]
    rolls = runs.motion("faster").sequence == "R"
    return Statement(
        key="faster_rolls",
        section="Increase the Speed",
        statement="At 2 m/s the motion is still pure rolling; the velocity is higher, but more uniform.",
        article="pure rolling",
        ours=f"phases {runs.motion('faster').sequence}; from {fast[0]:.3f} to {fast[1]:.3f} "
        "m/s, a ratio "
        f"of {ratios[1]:.2f} against {ratios[0]:.1f} at 0.1 m/s",
        verdict=agreement(rolls and fast[1] > slow[1] and ratios[1] < ratios[0]),
        numbers={"sequence": runs.motion("faster").sequence, "ratio_of_speeds": ratios},
    )


def faster_utilization(runs: Runs) -> Statement:
    slow, fast = (float(theory.needed_friction(runs.hoop, speed, runs.plane).mu) for speed in (0.1, 2.0))
    return Statement(
        key="faster_friction_used",
        section="Increase the Speed",
        statement="At 2 m/s a much larger fraction of the available friction is used.",
        article="close to 1 (from the plot)",
        ours=f"{100.0 * fast:.3f} % against {100.0 * slow:.3f} %",
        verdict=agreement(2.0 * slow < fast < 1.0),
        numbers={"utilization": fast, "utilization_slow": slow},
    )


def critical_speed(runs: Runs) -> Statement:
    ours = float(theory.first_slip_speed(runs.hoop, runs.plane))
    above = rolling_motion(GAMMA, 1.0, ours * (1.0 + 1e-9), 2.0).sequence
    below = rolling_motion(GAMMA, 1.0, ours * (1.0 - 1e-9), 2.0).sequence
    return Statement(
        key="critical_speed",
        section="Increase the Speed",
        statement="At a marginally higher speed than 2 m/s the hoop slips.",
        article="a little above 2 m/s",
        ours=f"from v₀ = {ours:.9f} m/s on, {100.0 * (ours / 2.0 - 1.0):.1f} % more",
        verdict=agreement(2.0 < ours < 2.1 and below == "R" and above != "R", exact=True),
        why="Solved to rounding; the motion rolls at a speed smaller by 10⁻⁹ of it and slips at one greater by as much.",
        numbers={"first_slip_speed": ours, "sequence_above": above, "sequence_below": below},
    )


def massless_speed(runs: Runs) -> Statement:
    loads = [0.9, 0.99, 0.999, 0.9999]
    speeds = [float(theory.max_rolling_speed(Hoop.ideal(gamma), 0.1)) for gamma in loads]
    slope = math.log(speeds[-1] / speeds[-2]) / math.log((1.0 - loads[-1]) / (1.0 - loads[-2]))
    return Statement(
        key="massless_limit",
        section="A First Attempt",
        statement="As γ approaches 1 the largest angular velocity of rolling approaches infinity.",
        article="θ̇max → ∞",
        ours=f"{', '.join(f'{speed:.1f}' for speed in speeds)} rad/s at γ = {', '.join(map(str, loads))}: "
        f"as (1 − γ)^{slope:.3f}",
        verdict=agreement(abs(slope + 0.5) < 0.01),
        why="As the formula has it, (1 − γ)^(−1/2).",
        numbers={"gamma": loads, "omega": speeds, "exponent": slope},
    )


def massless_slips(runs: Runs) -> Statement:
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
    return Statement(
        key="massless_slips",
        section="A First Attempt",
        statement="That speed is never reached: with any finite friction there is sliding sooner or later.",
        article="sliding for any finite μ",
        ours=said,
        verdict=agreement(all(0.0 < angle < 180.0 for _, angle in cases.values())),
        why="Always before the load is down, where the speed would be largest.",
        numbers={"cases": [{"mu": mu, "gamma": gamma, "angle_deg": angle} for mu, (gamma, angle) in cases.items()]},
    )


CHECKS: tuple[Check, ...] = (
    slow_rolls,
    potential_energy,
    kinetic_energy,
    angular_velocity,
    fastest,
    massless_speed,
    massless_slips,
    utilization,
    friction_needed,
    faster_rolls,
    contact_kept,
    faster_utilization,
    critical_speed,
)
