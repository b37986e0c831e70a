"""Statements on slipping, hopping, low friction and the massless hoop."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np

from hophoop import theory
from hophoop.article.runs import LONG, Runs, crossings, largest
from hophoop.article.slow_end import slow_end
from hophoop.article.statement import WITHIN_READING, Result, agreement, difference
from hophoop.scenario import Hoop, Plane, Scenario, Start
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory


def slips(runs: Runs) -> Result:
    motion, sample = runs.motion("slipping"), runs.sample("slipping")
    sliding = np.isin(sample.mode, ["S", "K"])
    used = sample.utilization(runs.plane)[sliding]
    apart = largest(motion, sample.t, lambda state: np.abs(state.vx - state.omega))
    begin = motion.find("slip_start")[0]
    return Result(
        ours=f"phases {motion.sequence[:7]}…; skids from {math.degrees(begin.angle):.2f}° (t = {begin.t:.4f} "
        "s), v and Rθ̇ "
        f"up to {apart:.3f} m/s apart",
        verdict=agreement("K" in motion.sequence and "S" in motion.sequence and bool(np.all(np.abs(used - 1.0) < 1e-9))),
        numbers={"sequence": motion.sequence, "slip_angle": begin.angle, "largest_slip": apart},
    )


def peaks_of(motion: Trajectory, turns: int) -> list[float]:
    """Return the maximum velocity of the centre in each of the first revolutions [m/s]."""
    times = motion.times(int(min(400_000, 2000 * motion.duration)))
    turn = np.floor(motion.at(times).angle / (2.0 * math.pi)).astype(int)
    whole = [k for k in range(turns) if (turn > k).any()]
    return [largest(motion, times[turn == k], lambda state: state.vx) for k in whole]


def peaks_fall(runs: Runs) -> Result:
    motion = simulate(runs.motion("slipping").scenario.replace("duration", 9.0))
    peaks = peaks_of(motion, 6)
    return Result(
        ours=", ".join(f"{peak:.3f}" for peak in peaks) + " m/s",
        verdict=agreement(len(peaks) >= 5 and all(b < a for a, b in pairwise(peaks))),
        numbers={"peaks": peaks},
    )


def ends_rolling(runs: Runs) -> Result:
    """Slip above the critical speed never ends: the loss per cycle is proportional to the square of the excess."""
    motion = runs.long_slipping
    critical = float(theory.first_slip_speed(runs.hoop, runs.plane))
    floor = (1.0 + runs.hoop.eccentricity) * critical**2  # kinetic energy at the top, rolling at that speed
    sticks = motion.find("stick")
    marks = {t: next(event for event in reversed(sticks) if event.t <= t) for t in (30.0, 300.0, LONG / 2.0, LONG)}
    excess = {t: _energy(motion, event) - floor for t, event in marks.items()}
    products = [float(excess[t] * t) for t in (LONG / 2.0, LONG)]  # the energy is constant until the next slip
    limit = slow_end(runs.hoop, runs.plane).product
    times = slip_below(motion, (0.1, 0.01))
    # the deviation falls as log(t)/t, so to about half
    missing = [1.0 - product / limit for product in products]
    algebraic = 0.0 < missing[1] < 0.7 * missing[0] and missing[1] < 0.03
    still = motion.sequence[-8:].count("S") + motion.sequence[-8:].count("K") >= 3 and min(excess.values()) > 0.0
    return Result(
        ours=f"it tends to rolling with {critical:.6f} m/s at the top, but never gets there: what it has above "
        "that energy "
        f"falls in the end as {limit:.3f} J s/t ({excess[30.0]:.3f} J after 30 s, {excess[LONG]:.4f} J after "
        f"{LONG:.0f} s, which is {products[1]:.2f} J s/t); "
        f"slip stays below 0.1 m/s after {times[0.1]:.1f} s, below 1 cm/s after {times[0.01]:.1f} s",
        verdict=difference(algebraic and still),
        numbers={
            "critical_speed": critical,
            "excess_energy": {f"{t:g}": float(value) for t, value in excess.items()},
            "excess_times_t": products,
            "excess_times_t_limit": limit,
            "slip_below": {f"{speed:g}": t for speed, t in times.items()},
        },
    )


def _energy(motion: Trajectory, event: Any) -> float:
    return float(motion.at(event.t).total)


def slip_below(motion: Trajectory, limits: tuple[float, ...]) -> dict[float, float]:
    """Return the time after which a motion's slip velocity stays below a limit [s]."""
    starts = np.array([event.t for event in motion.events if event.to_mode in "SK" and event.kind != "end"])
    ends = np.array([event.t for event in motion.find("stick")])
    count = min(len(starts), len(ends))
    share = np.linspace(0.0, 1.0, 41)[1:-1]
    times = starts[:count, None] + (ends[:count] - starts[:count])[:, None] * share
    slip = np.abs(motion.at(times).slip)
    result = {}
    for limit in limits:
        above = np.flatnonzero(np.max(slip, axis=1) >= limit)
        if not above.size:
            result[limit] = 0.0
            continue
        # the last phase that exceeds it: the time when it falls below
        k = int(above[-1])
        low, high = float(times[k, np.flatnonzero(slip[k] >= limit)[-1]]), float(ends[k])
        for _ in range(50):
            middle = 0.5 * (low + high)
            if abs(motion.at(middle).slip) >= limit:
                low = middle
            else:
                high = middle
        result[limit] = high
    return result


def hops(runs: Runs) -> Result:
    motion = runs.motion("hop")
    off, down = motion.find("takeoff")[0], motion.find("impact")[0]
    top = motion.find("apex")[0].height
    least = float(theory.first_hop_speed(runs.hoop, runs.plane))
    angle = math.degrees(off.angle)
    return Result(
        ours=f"takes off at {angle:.3f}° (t = {off.t:.6f} s), rises {top:.4f} m, lands at "
        f"{math.degrees(down.angle):.3f}° "
        f"(t = {down.t:.6f} s)",
        verdict=agreement(270.0 < angle < 360.0),
        why=f"It hops in its first turn from v₀ = {least:.6f} m/s on; at 2.8 m/s it does not.",
        numbers={
            "takeoff_angle_deg": angle,
            "takeoff_t": off.t,
            "rise": top,
            "landing_angle_deg": math.degrees(down.angle),
            "landing_t": down.t,
            "first_hop_speed": least,
        },
    )


def constant_rotation(runs: Runs) -> Result:
    sample = runs.sample("hop")
    rates = sample.omega[sample.mode == "H"]
    spread = float(np.ptp(rates))
    return Result(
        ours=f"{rates[0]:.6f} rad/s throughout, " + (f"to {spread:.0e}" if spread else "to the last bit"),
        verdict=agreement(spread <= 1e-12 * rates[0]),
        numbers={"omega": float(rates[0]), "spread": spread},
    )


def centre_in_flight(runs: Runs) -> Result:
    motion, sample = runs.motion("hop"), runs.sample("hop")
    air = sample.mode == "H"
    inner = np.flatnonzero(air)[1:-1]
    along = sample.vx + runs.hoop.eccentricity * sample.omega * np.cos(sample.angle)
    height = 1.0 + sample.height + runs.hoop.eccentricity * np.cos(sample.angle)
    t = sample.t[inner]
    parabola = np.polynomial.Polynomial.fit(t, height[inner], 2)
    bend = float(parabola.convert().coef[2])
    off_line = float(np.max(np.abs(parabola(t) - height[inner])))
    slowest = -largest(motion, sample.t[air], lambda state: -state.vx)
    highest = largest(motion, sample.t[air], lambda state: state.vx)
    level = float(np.ptp(along[inner]))
    return Result(
        ours=f"centre from {slowest:.4f} to {highest:.4f} m/s; centre of gravity "
        f"{along[inner][0]:.6f} m/s to "
        f"{level:.0e}, off a parabola with g = {-2.0 * bend:.6f} m/s² by {off_line:.0e} m",
        verdict=agreement(highest - slowest > 1.0 and level < 1e-11 and off_line < 1e-11 and abs(-2.0 * bend - 9.81) < 1e-8),
        numbers={"least": slowest, "largest": highest, "gravity": -2.0 * bend},
    )


def positive_potential(runs: Runs) -> Result:
    motion, sample = runs.motion("hop"), runs.sample("hop")
    late = sample.t > 0.5
    times = crossings(motion, sample.potential[late], sample.t[late], lambda state: state.potential)
    angles = [math.degrees(motion.at(t).angle) for t in times]
    highest = largest(motion, sample.t, lambda state: state.potential)
    near = len(angles) >= 2 and abs(angles[0] - 350.0) < 2.5 and abs(angles[1] - 395.0) < 2.5
    return Result(
        ours=f"between {angles[0]:.3f}° and {angles[1]:.3f}°, up to {highest:.4f} J",
        verdict=WITHIN_READING if near else difference(False),
        numbers={"angles_deg": angles[:2], "largest": highest},
    )


def landing(runs: Runs) -> Result:
    motion = runs.motion("hop")
    down = motion.find("impact")[0]
    slip = next((event for event in motion.find("slip_start") if event.t > down.t), None)
    rolls = down.to_mode == "R"
    again = (
        ""
        if slip is None
        else (
            f" up to {math.degrees(slip.angle):.2f}° ({slip.t - down.t:.3f} s, "
            f"{math.degrees(slip.angle - down.angle):.0f}°), then it spins again"
        )
    )
    return Result(
        ours=f"the landing ends the slip at once, and the hoop rolls{again}",
        verdict=agreement(rolls) if slip is None else difference(rolls),
        numbers={"mode_after": down.to_mode, "slips_again_deg": None if slip is None else math.degrees(slip.angle)},
    )


def impact_loss(runs: Runs) -> Result:
    motion = runs.motion("hop")
    down = motion.find("impact")[0]
    total = down.impact_normal + down.impact_tangential
    before = down.friction
    return Result(
        ours=f"{total:.4f} J lost in the impact, {down.impact_tangential:.4f} J of it to friction and "
        f"{down.impact_normal:.4f} J in the normal direction; all slip before it took {before:.4f} J",
        verdict=agreement(total > 1.5 * down.impact_tangential),
        numbers={
            "lost": total,
            "normal": down.impact_normal,
            "tangential": down.impact_tangential,
            "slip_before": before,
        },
    )


def low_friction_rocks(runs: Runs) -> Result:
    motion = runs.motion("low_friction")
    turns = motion.find("turn")
    highest = math.degrees(max(event.angle for event in motion.events))
    angles = [math.degrees(event.angle) for event in turns]
    rocks = len(angles) >= 2 and highest < 360.0
    return Result(
        ours=f"slips first at {math.degrees(motion.find('slip_start')[0].angle):.2f}°; turns back at "
        + ", ".join(f"{angle:.1f}°" for angle in angles),
        verdict=agreement(rocks and motion.sequence.startswith("RS")),
        numbers={"turning_angles_deg": angles, "sequence": motion.sequence},
    )


def low_friction_slips(runs: Runs) -> Result:
    motion = runs.motion("low_friction")
    slips_ = motion.find("slip_start")
    lost = motion.ledger.friction
    return Result(
        ours=f"{len(slips_)} times in {motion.duration:g} s, with {lost:.3f} J lost",
        verdict=agreement(len(slips_) >= 3),
        numbers={"slips": len(slips_), "friction": lost},
    )


def littlewood(runs: Runs) -> Result:
    """γ = 1: the contact force vanishes at 90°, but the rim skims the plane instead of hopping."""
    loss = theory.massless_loss(0.0, plane=Plane(mu=2.0))
    limit = math.degrees(float(loss.angle))
    start = Start.rolling(1e-6)
    motion = simulate(Scenario(hoop=Hoop.ideal(1.0), plane=Plane(mu=2.0), start=start, duration=12.0))
    skim = motion.find("skim")
    angle = math.degrees(skim[0].angle) if skim else math.nan
    rises = any(event.height > 0.0 for event in motion.events) or "H" in motion.sequence
    return Result(
        ours=f"the contact force vanishes at {limit:.6f}° (computed motion: {angle:.6f}°), but the rim does "
        "not rise: it "
        f"skims the plane, phases {motion.sequence}",
        verdict=difference(abs(limit - 90.0) < 1e-9 and abs(angle - 90.0) < 1e-6 and not rises),
        numbers={"angle_deg": limit, "computed_deg": angle, "sequence": motion.sequence},
    )
