"""Statements on slipping, hopping, low friction and the massless hoop."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from hophoop import theory
from hophoop.article.runs import LONG, Runs, bisect, extremes, rolling_motion
from hophoop.article.statement import Result
from hophoop.kernel.model import inertia_at_height
from hophoop.plots.curves import curve
from hophoop.scenario import Hoop, Plane, to_body
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory


def slips(runs: Runs) -> Result:
    motion, sample = runs.motion("slipping"), runs.sample("slipping")
    used = sample.utilization(runs.plane)[np.isin(sample.mode, ["S", "K"])]
    apart = max(map(abs, runs.extremes("slipping", "slip")))
    begin = motion.find("slip_start")[0]
    holds = "K" in motion.sequence and "S" in motion.sequence and bool(np.all(np.abs(used - 1.0) < 1e-9))
    numbers = {"sequence": motion.sequence, "slip_angle": begin.angle, "slip_t": begin.t, "largest_slip": apart}
    return Result(holds, numbers)


def peaks_fall(runs: Runs) -> Result:
    motion = simulate(runs.motion("slipping").scenario.replace("duration", 9.0))
    sample = curve(motion)
    turn = sample.angle // (2.0 * math.pi)
    peaks = [extremes(motion, sample.t[turn == k], "vx")[1] for k in range(int(turn[-1]))][:6]
    return Result(len(peaks) >= 5 and all(b < a for a, b in pairwise(peaks)), {"peaks": peaks})


def after_each_slip(runs: Runs) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the ends of all slips of the long motion [s], and the energy above rolling at the critical speed [J]."""
    critical = theory.first_slip_speed(runs.hoop, runs.plane)
    t = np.array([event.t for event in runs.long_slipping.find("stick")])
    return t, runs.long_slipping.at(t).total - (1.0 + runs.hoop.eccentricity) * critical**2


def ends_rolling(runs: Runs) -> Result:
    """Slip above the critical speed never ends: the loss per cycle is proportional to the square of the excess."""
    t, energies = after_each_slip(runs)
    marks = (30, int(LONG / 2.0), int(LONG))
    excess = {mark: energies[np.searchsorted(t, mark, side="right") - 1] for mark in marks}
    products = [excess[mark] * mark for mark in marks[1:]]  # the energy is constant until the next slip
    limit = slow_end(runs.hoop, runs.plane)
    # the deviation falls as log(t)/t, so to about half
    missing = [1.0 - product / limit for product in products]
    algebraic = 0.0 < missing[1] < 0.7 * missing[0] and missing[1] < 0.03
    numbers = {
        "critical_speed": theory.first_slip_speed(runs.hoop, runs.plane),
        "excess_energy": excess,
        "excess_times_t": products,
        "excess_times_t_limit": limit,
        "slip_below": {str(speed): slip_below(runs.long_slipping, speed) for speed in (0.1, 0.01)},
    }
    return Result(algebraic and min(excess.values()) > 0.0, numbers)


def slow_end(hoop: Hoop, plane: Plane) -> float:
    """Return the limit of t times the energy above rolling at the critical speed, on level ground [J s].

    With the excess x of θ̇ at the bottom this energy is I θ̇ x, and a revolution of period T changes x by −rate·x².
    """
    decay = theory.slip_decay(hoop, plane)
    period = theory.rolling_period(hoop, theory.first_slip_speed(hoop, plane), plane)
    inertia = hoop.mass * hoop.radius**2 * inertia_at_height(to_body(hoop, plane), 0.0)
    return float(period * inertia * decay.omega / decay.rate)


def slip_below(motion: Trajectory, speed: float) -> float:
    """Return the time after which a motion's slip velocity stays below a speed [s]."""
    slips = list(zip(motion.find("slip_start"), motion.find("stick"), strict=False))
    starts, ends = np.array([[start.t, end.t] for start, end in slips]).T
    times = np.linspace(starts, ends, 41, axis=-1)[:, 1:-1].reshape(-1)
    k = np.flatnonzero(np.abs(motion.at(times).slip) >= speed)[-1]
    return bisect(times[k], times[k + 1], lambda t: abs(motion.at(t).slip) >= speed)


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
        "first_hop_speed": theory.first_hop_speed(runs.hoop, runs.plane),
    }
    return Result(270.0 < angle < 360.0, numbers)


def constant_rotation(runs: Runs) -> Result:
    sample = runs.sample("hop")
    rates = sample.omega[sample.mode == "H"]
    return Result(np.ptp(rates) == 0.0, {"omega": rates[0]})


def centre_in_flight(runs: Runs) -> Result:
    motion, sample = runs.motion("hop"), runs.sample("hop")
    air = sample.mode == "H"
    inner = np.flatnonzero(air)[1:-1]
    along = (sample.vx + runs.hoop.eccentricity * sample.omega * np.cos(sample.angle))[inner]
    height = (1.0 + sample.height + runs.hoop.eccentricity * np.cos(sample.angle))[inner]
    parabola = np.polynomial.Polynomial.fit(sample.t[inner], height, 2)
    least, largest = extremes(motion, sample.t[air], "vx")
    numbers = {
        "least": least,
        "largest": largest,
        "gravity": -parabola.deriv(2)(0.0),
        "gravity_centre": along[0],
        "gravity_centre_spread": np.ptp(along),
        "off_parabola": np.max(np.abs(parabola(sample.t[inner]) - height)),
    }
    straight = max(numbers["gravity_centre_spread"], numbers["off_parabola"]) < 1e-11
    return Result(largest - least > 1.0 and straight and abs(numbers["gravity"] - 9.81) < 1e-8, numbers)


def positive_potential(runs: Runs) -> Result:
    motion, sample = runs.motion("hop"), runs.sample("hop")
    late = sample.t > 0.5  # it starts at zero
    times, above = sample.t[late], sample.potential[late] > 0.0

    def crossing(k: int) -> float:
        """Angle of a change of sign between two samples [°]."""
        change = bisect(times[k], times[k + 1], lambda t: (motion.at(t).potential > 0.0) == above[k])
        return math.degrees(motion.at(change).angle)

    angles = [crossing(k) for k in np.flatnonzero(above[1:] != above[:-1])[:2]]
    near = len(angles) == 2 and abs(angles[0] - 350.0) < 2.5 and abs(angles[1] - 395.0) < 2.5
    return Result(near, {"angles_deg": angles, "largest": runs.extremes("hop", "potential")[1]})


def landing(runs: Runs) -> Result:
    motion = runs.motion("hop")
    down = motion.find("impact")[0]
    slip = next(event for event in motion.find("slip_start") if event.t > down.t)
    numbers = {
        "slips_again_deg": math.degrees(slip.angle),
        "rolls_for": slip.t - down.t,
        "rolls_by_deg": math.degrees(slip.angle - down.angle),
    }
    return Result(down.to_mode == "R", numbers)


def impact_loss(runs: Runs) -> Result:
    down = runs.motion("hop").find("impact")[0]
    normal, tangential = down.impact_normal, down.impact_tangential
    numbers = {"lost": normal + tangential, "normal": normal, "tangential": tangential, "slip_before": down.friction}
    return Result(normal > 0.5 * tangential, numbers)


def low_friction_rocks(runs: Runs) -> Result:
    motion = runs.motion("low_friction")
    highest = max(event.angle for event in motion.events)
    angles = [math.degrees(event.angle) for event in motion.find("turn")]
    first = math.degrees(motion.find("slip_start")[0].angle)
    holds = len(angles) >= 2 and highest < 2.0 * math.pi and motion.sequence.startswith("RS")
    return Result(holds, {"first_slip_deg": first, "turning_angles_deg": angles})


def low_friction_slips(runs: Runs) -> Result:
    motion = runs.motion("low_friction")
    count = len(motion.find("slip_start"))
    return Result(count >= 3, {"slips": count, "friction": motion.ledger.friction, "duration": motion.duration})


def littlewood(runs: Runs) -> Result:
    """γ = 1: the contact force vanishes at 90°, but the rim skims the plane instead of hopping."""
    limit = math.degrees(theory.massless_loss(0.0, plane=Plane(mu=2.0)).angle)
    motion = rolling_motion(1.0, mu=2.0, speed=1e-6, duration=12.0)
    angle = math.degrees(motion.find("skim")[0].angle)
    rises = any(event.height > 0.0 for event in motion.events) or "H" in motion.sequence
    holds = abs(limit - 90.0) < 1e-9 and abs(angle - 90.0) < 1e-6 and not rises
    return Result(holds, {"angle_deg": limit, "computed_deg": angle, "sequence": motion.sequence})
