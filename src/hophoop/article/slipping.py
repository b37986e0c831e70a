"""Statements on slipping, hopping, low friction and the massless hoop."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from hophoop import theory
from hophoop.article.runs import LONG, Runs, bisect, largest
from hophoop.article.statement import Result
from hophoop.kernel.model import inertia_at_height
from hophoop.scenario import Hoop, Plane, Scenario, Start, to_body
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory


def slips(runs: Runs) -> Result:
    motion, sample = runs.motion("slipping"), runs.sample("slipping")
    used = sample.utilization(runs.plane)[np.isin(sample.mode, ["S", "K"])]
    apart = largest(motion, sample.t, lambda state: np.abs(state.vx - state.omega))
    begin = motion.find("slip_start")[0]
    holds = "K" in motion.sequence and "S" in motion.sequence and bool(np.all(np.abs(used - 1.0) < 1e-9))
    numbers = {"sequence": motion.sequence, "slip_angle": begin.angle, "slip_t": begin.t, "largest_slip": apart}
    return Result(holds, numbers)


def peaks_of(motion: Trajectory, turns: int) -> list[float]:
    """Return the maximum velocity of the centre in each of the first revolutions [m/s]."""
    times = motion.times(int(min(400_000, 2000 * motion.duration)))
    turn = np.floor(motion.at(times).angle / (2.0 * math.pi)).astype(int)
    whole = [k for k in range(turns) if (turn > k).any()]
    return [largest(motion, times[turn == k], lambda state: state.vx) for k in whole]


def peaks_fall(runs: Runs) -> Result:
    peaks = peaks_of(simulate(runs.motion("slipping").scenario.replace("duration", 9.0)), 6)
    return Result(len(peaks) >= 5 and all(b < a for a, b in pairwise(peaks)), {"peaks": peaks})


def ends_rolling(runs: Runs) -> Result:
    """Slip above the critical speed never ends: the loss per cycle is proportional to the square of the excess."""
    motion, hoop = runs.long_slipping, runs.hoop
    critical = float(theory.first_slip_speed(hoop, runs.plane))
    floor = (1.0 + hoop.eccentricity) * critical**2  # kinetic energy at the top, rolling at that speed
    sticks = motion.find("stick")
    marks = (30, 300, int(LONG / 2.0), int(LONG))
    last = {t: next(event for event in reversed(sticks) if event.t <= t) for t in marks}
    excess = {t: float(motion.at(event.t).total) - floor for t, event in last.items()}
    products = [excess[t] * t for t in marks[2:]]  # the energy is constant until the next slip
    limit = slow_end(hoop, runs.plane)
    # the deviation falls as log(t)/t, so to about half
    missing = [1.0 - product / limit for product in products]
    algebraic = 0.0 < missing[1] < 0.7 * missing[0] and missing[1] < 0.03
    still = motion.sequence[-8:].count("S") + motion.sequence[-8:].count("K") >= 3 and min(excess.values()) > 0.0
    numbers = {
        "critical_speed": critical,
        "excess_energy": excess,
        "excess_times_t": products,
        "excess_times_t_limit": limit,
        "slip_below": {f"{speed:g}": t for speed, t in slip_below(motion, (0.1, 0.01)).items()},
    }
    return Result(algebraic and still, numbers)


def slow_end(hoop: Hoop, plane: Plane) -> float:
    """Return the limit of t times the energy above rolling at the critical speed, on level ground [J s].

    With the excess x of θ̇ at the bottom this energy is I θ̇ x, and a revolution of period T changes x by −rate·x².
    """
    decay = theory.slip_decay(hoop, plane)
    period = theory.rolling_period(hoop, theory.first_slip_speed(hoop, plane), plane)
    inertia = hoop.mass * hoop.radius**2 * inertia_at_height(to_body(hoop, plane), 0.0)
    return float(period * inertia * decay.omega / decay.rate)


def slip_below(motion: Trajectory, limits: tuple[float, ...]) -> dict[float, float]:
    """Return the time after which a motion's slip velocity stays below a limit [s]."""
    starts = np.array([event.t for event in motion.events if event.to_mode in "SK" and event.kind != "end"])
    ends = np.array([event.t for event in motion.find("stick")])
    count = min(len(starts), len(ends))
    share = np.linspace(0.0, 1.0, 41)[1:-1]
    times = starts[:count, None] + (ends[:count] - starts[:count])[:, None] * share
    slip = np.abs(motion.at(times).slip)
    result = dict.fromkeys(limits, 0.0)
    for limit in limits:
        above = np.flatnonzero(np.max(slip, axis=1) >= limit)
        if above.size:  # in the last phase that exceeds it
            k = int(above[-1])
            low = float(times[k, np.flatnonzero(slip[k] >= limit)[-1]])

            def exceeds(t: float, limit: float = limit) -> bool:
                return bool(abs(motion.at(t).slip) >= limit)

            result[limit] = bisect(low, float(ends[k]), exceeds)
    return result


def hops(runs: Runs) -> Result:
    motion = runs.motion("hop")
    off, down = motion.find("takeoff")[0], motion.find("impact")[0]
    angle = math.degrees(off.angle)
    numbers = {
        "takeoff_angle_deg": angle,
        "takeoff_t": off.t,
        "rise": motion.find("apex")[0].height,
        "landing_angle_deg": math.degrees(down.angle),
        "landing_t": down.t,
        "first_hop_speed": float(theory.first_hop_speed(runs.hoop, runs.plane)),
    }
    return Result(270.0 < angle < 360.0, numbers)


def constant_rotation(runs: Runs) -> Result:
    sample = runs.sample("hop")
    rates = sample.omega[sample.mode == "H"]
    spread = float(np.ptp(rates))
    return Result(spread == 0.0, {"omega": float(rates[0]), "spread": spread})


def centre_in_flight(runs: Runs) -> Result:
    motion, sample = runs.motion("hop"), runs.sample("hop")
    air = sample.mode == "H"
    inner = np.flatnonzero(air)[1:-1]
    along = (sample.vx + runs.hoop.eccentricity * sample.omega * np.cos(sample.angle))[inner]
    height = (1.0 + sample.height + runs.hoop.eccentricity * np.cos(sample.angle))[inner]
    t = sample.t[inner]
    parabola = np.polynomial.Polynomial.fit(t, height, 2)
    gravity = -2.0 * float(parabola.convert().coef[2])
    off_line = float(np.max(np.abs(parabola(t) - height)))
    slowest = -largest(motion, sample.t[air], lambda state: -state.vx)
    highest = largest(motion, sample.t[air], lambda state: state.vx)
    level = float(np.ptp(along))
    numbers = {
        "least": slowest,
        "largest": highest,
        "gravity": gravity,
        "gravity_centre": float(along[0]),
        "gravity_centre_spread": level,
        "off_parabola": off_line,
    }
    return Result(highest - slowest > 1.0 and level < 1e-11 and off_line < 1e-11 and abs(gravity - 9.81) < 1e-8, numbers)


def positive_potential(runs: Runs) -> Result:
    motion, sample = runs.motion("hop"), runs.sample("hop")
    times, values = (column[sample.t > 0.5] for column in (sample.t, sample.potential))
    angles = []
    for k in np.flatnonzero(np.sign(values[1:]) * np.sign(values[:-1]) < 0.0)[:2]:

        def is_before(t: float, sign: float = np.sign(values[k])) -> bool:
            return bool(np.sign(motion.at(t).potential) == sign)

        t = bisect(float(times[k]), float(times[k + 1]), is_before)
        angles.append(math.degrees(motion.at(t).angle))
    near = len(angles) == 2 and abs(angles[0] - 350.0) < 2.5 and abs(angles[1] - 395.0) < 2.5
    return Result(near, {"angles_deg": angles, "largest": largest(motion, sample.t, lambda state: state.potential)})


def landing(runs: Runs) -> Result:
    motion = runs.motion("hop")
    down = motion.find("impact")[0]
    slip = next(event for event in motion.find("slip_start") if event.t > down.t)
    numbers = {
        "mode_after": down.to_mode,
        "slips_again_deg": math.degrees(slip.angle),
        "rolls_for": slip.t - down.t,
        "rolls_by_deg": math.degrees(slip.angle - down.angle),
    }
    return Result(down.to_mode == "R", numbers)


def impact_loss(runs: Runs) -> Result:
    down = runs.motion("hop").find("impact")[0]
    total = down.impact_normal + down.impact_tangential
    parts = {"normal": down.impact_normal, "tangential": down.impact_tangential, "slip_before": down.friction}
    return Result(total > 1.5 * down.impact_tangential, {"lost": total, **parts})


def low_friction_rocks(runs: Runs) -> Result:
    motion = runs.motion("low_friction")
    highest = math.degrees(max(event.angle for event in motion.events))
    angles = [math.degrees(event.angle) for event in motion.find("turn")]
    first = math.degrees(motion.find("slip_start")[0].angle)
    holds = len(angles) >= 2 and highest < 360.0 and motion.sequence.startswith("RS")
    return Result(holds, {"first_slip_deg": first, "turning_angles_deg": angles, "sequence": motion.sequence})


def low_friction_slips(runs: Runs) -> Result:
    motion = runs.motion("low_friction")
    count = len(motion.find("slip_start"))
    return Result(count >= 3, {"slips": count, "friction": motion.ledger.friction, "duration": motion.duration})


def littlewood(runs: Runs) -> Result:
    """γ = 1: the contact force vanishes at 90°, but the rim skims the plane instead of hopping."""
    plane = Plane(mu=2.0)
    limit = math.degrees(float(theory.massless_loss(0.0, plane=plane).angle))
    motion = simulate(Scenario(hoop=Hoop.ideal(1.0), plane=plane, start=Start.rolling(1e-6), duration=12.0))
    angle = math.degrees(motion.find("skim")[0].angle)
    rises = any(event.height > 0.0 for event in motion.events) or "H" in motion.sequence
    holds = abs(limit - 90.0) < 1e-9 and abs(angle - 90.0) < 1e-6 and not rises
    return Result(holds, {"angle_deg": limit, "computed_deg": angle, "sequence": motion.sequence})
