"""Numbers in the text of the report, formatted, all from computed motions."""

from __future__ import annotations

import math
from collections.abc import Sequence

from hophoop import theory
from hophoop.article.runs import Runs, largest
from hophoop.article.statement import Statement
from hophoop.scenario import Hoop, Plane, PointMass, Ring, Start
from hophoop.simulation.simulate import simulate

SMALL = {"radius": 0.3, "mass": 2.0}  # another hoop, for a question in the article's comments


def facts(statements: Sequence[Statement], runs: Runs) -> dict[str, str]:
    """Return the numbers in the text of the report, by name.

    statements: checked.
    """
    found = {one.key: one.numbers for one in statements}
    told = {**_rolling(found, runs), **_slipping(found, runs), **_hop(found, runs), **_low(runs), **_bodies()}
    # no line break between number and unit
    return {name: value.replace(" ", "\u00a0") for name, value in told.items()}


def _rolling(found: dict[str, dict[str, object]], runs: Runs) -> dict[str, str]:
    bottom = largest(runs.motion("slow"), runs.sample("slow").t, lambda state: state.normal_force)
    return {
        "turn_time": f"{_number(found, 'slow_motion', 't_at_360'):.2f} s",
        "slow_peak": f"{_number(found, 'slow_motion', 'largest_speed'):.2f} m/s",
        "bottom_force": f"{bottom:.1f} N",
        "weight": f"{runs.hoop.mass * runs.plane.gravity:.2f} N",
        "friction_used": f"{100.0 * _number(found, 'friction_used', 'utilization'):.1f} %",
        "friction_angle": f"{math.degrees(_number(found, 'friction_used', 'angle')):.0f}°",
        "friction_needed": f"{_number(found, 'friction_needed', 'mu'):.4f}",
        "faster_used": f"{100.0 * _number(found, 'faster_friction_used', 'utilization'):.1f} %",
        "critical_speed": f"{_number(found, 'critical_speed', 'first_slip_speed'):.4f} m/s",
    }


def _slipping(found: dict[str, dict[str, object]], runs: Runs) -> dict[str, str]:
    motion = runs.motion("slipping")
    starts = motion.find("slip_start")
    return {
        "skid_angle": _degrees(starts[0].angle),
        "spin_angle": _degrees(starts[1].angle),
        "largest_slip": f"{_number(found, 'slips', 'largest_slip'):.2f} m/s",
        "end_product": f"{_number(found, 'ends_rolling', 'excess_times_t_limit'):.1f} J s",
    }


def _hop(found: dict[str, dict[str, object]], runs: Runs) -> dict[str, str]:
    motion = runs.motion("hop")
    hoop, plane = runs.hoop, runs.plane
    off, down, apex = motion.find("takeoff")[0], motion.find("impact")[0], motion.find("apex")[0]
    slips = motion.find("slip_start")
    total = down.impact_normal + down.impact_tangential
    sine, cosine = math.sin(down.angle), math.cos(down.angle)
    before = down.before
    # the velocity of the centre of gravity
    along = before.vx + hoop.eccentricity * before.omega * cosine
    up = before.vy - hoop.eccentricity * before.omega * sine
    return {
        "skid_angle_hop": _degrees(slips[0].angle),
        "spin_angle_hop": _degrees(slips[1].angle),
        "takeoff_angle": _degrees(off.angle),
        "takeoff_time": f"{off.t:.3f} s",
        "rise": f"{100.0 * apex.height:.0f} cm",
        "flight_time": f"{down.t - off.t:.2f} s",
        "flight_turn": f"{math.degrees(down.angle - off.angle):.0f}°",
        "landing_angle": _degrees(down.angle),
        "first_hop": f"{float(theory.first_hop_speed(hoop, plane)):.4f} m/s",
        "roll_rate": f"{float(theory.rolling_speed(off.angle, hoop, 3.1, plane)):.2f} rad/s",
        "hop_rate": f"{off.omega:.2f} rad/s",
        "roll_hop_speed": f"{math.sqrt(plane.gravity * hoop.radius / hoop.eccentricity):.2f} m/s",
        "least_speed": f"{_number(found, 'centre_in_flight', 'least'):.2f} m/s",
        "most_speed": f"{_number(found, 'centre_in_flight', 'largest'):.2f} m/s",
        "gravity_centre_speed": f"{along:.2f} m/s",
        "fall_speed": f"{-up:.2f} m/s",
        "rate_before": f"{before.omega:.2f} rad/s",
        "rate_after": f"{down.omega:.2f} rad/s",
        "landing_loss": f"{total:.2f} J",
        "landing_normal": f"{down.impact_normal:.2f} J",
        "landing_tangential": f"{down.impact_tangential:.2f} J",
        "slip_before": f"{down.friction:.2f} J",
        "positive_from": f"{_angles(found)[0]:.1f}°",
        "positive_to": f"{_angles(found)[1]:.1f}°",
        "rolls_on": _degrees(slips[2].angle),
        "rolls_for": f"{slips[2].t - down.t:.2f} s",
    }


def _low(runs: Runs) -> dict[str, str]:
    motion = runs.motion("low_friction")
    slips, turns = motion.find("slip_start"), motion.find("turn")
    return {
        "low_slip_angle": _degrees(slips[0].angle),
        "low_turn_angle": _degrees(turns[0].angle),
        "low_slips": str(len(slips)),
        "low_loss": f"{motion.ledger.friction:.1f} J",
        "low_duration": f"{motion.duration:g} s",
    }


def _bodies() -> dict[str, str]:
    """Numbers for the article's comments: a hoop made of parts, and another radius and mass."""
    made = Hoop.from_parts(1.0, [Ring(mass=0.25, inner_radius=1.0, outer_radius=1.0), PointMass(mass=0.75, at=1.0)])
    small = Hoop.ideal(0.75, **SMALL)
    speed = 3.1 * math.sqrt(SMALL["radius"])
    large, scaled = (
        simulate(hoop, Plane(), Start.rolling(v), duration=2.5).find("takeoff")[0]
        for hoop, v in ((Hoop.ideal(0.75), 3.1), (small, speed))
    )
    with_load, without = (
        float(theory.max_rolling_speed(Hoop(eccentricity=0.75, inertia_ratio=ratio), 0.1))
        for ratio in (made.inertia_ratio, 0.25)
    )
    return {
        "parts_eccentricity": f"{made.eccentricity:.2f}",
        "parts_inertia": f"{made.inertia_ratio:.4f}",
        "scaled_radius": f"{SMALL['radius']:g} m",
        "scaled_mass": f"{SMALL['mass']:g} kg",
        "scaled_speed": f"{speed:.2f} m/s",
        "scaled_takeoff": f"{math.degrees(scaled.angle):.6f}°",
        "large_takeoff": f"{math.degrees(large.angle):.6f}°",
        "right_rate": f"{with_load:.2f} rad/s",
        "wrong_rate": f"{without:.2f} rad/s",
    }


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.1f}°"


def _number(found: dict[str, dict[str, object]], key: str, name: str) -> float:
    value = found.get(key, {}).get(name, math.nan)
    return float(value) if isinstance(value, int | float) else math.nan


def _angles(found: dict[str, dict[str, object]]) -> list[float]:
    angles = found.get("positive_potential", {}).get("angles_deg", [math.nan, math.nan])
    return list(angles) if isinstance(angles, list) else [math.nan, math.nan]
