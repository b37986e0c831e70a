"""Numbers in the text of the report, formatted, all from computed motions."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from hophoop import theory
from hophoop.article.runs import Runs, largest
from hophoop.article.statement import Statement, Texts
from hophoop.scenario import Hoop, Plane, PointMass, Ring, Start
from hophoop.simulation.simulate import simulate

SMALL = {"radius": 0.3, "mass": 2.0}  # another hoop, for a question in the article's comments

# By the names in story.html, from the numbers of the statements by key and of `_motions` and `_bodies`.
TEXTS = {
    "turn_time": "{slow_motion[t_at_360]:.2f} s",
    "slow_peak": "{slow_motion[largest_speed]:.2f} m/s",
    "bottom_force": "{bottom_force:.1f} N",
    "weight": "{weight:.2f} N",
    "friction_used": "{friction_used[utilization]!h:.1f} %",
    "friction_angle": "{friction_used[angle]!d:.0f}°",
    "friction_needed": "{friction_needed[mu]:.4f}",
    "faster_used": "{faster_friction_used[utilization]!h:.1f} %",
    "critical_speed": "{critical_speed[first_slip_speed]:.4f} m/s",
    "skid_angle": "{slips[slip_angle]!d:.1f}°",
    "spin_angle": "{spin.angle!d:.1f}°",
    "largest_slip": "{slips[largest_slip]:.2f} m/s",
    "end_product": "{ends_rolling[excess_times_t_limit]:.1f} J s",
    "skid_angle_hop": "{hop_slips[0].angle!d:.1f}°",
    "spin_angle_hop": "{hop_slips[1].angle!d:.1f}°",
    "takeoff_angle": "{hops[takeoff_angle_deg]:.1f}°",
    "takeoff_time": "{hops[takeoff_t]:.3f} s",
    "rise": "{hops[rise]!h:.0f} cm",
    "flight_time": "{flight_time:.2f} s",
    "flight_turn": "{flight_turn!d:.0f}°",
    "landing_angle": "{hops[landing_angle_deg]:.1f}°",
    "first_hop": "{hops[first_hop_speed]:.4f} m/s",
    "roll_rate": "{roll_rate:.2f} rad/s",
    "hop_rate": "{constant_rotation[omega]:.2f} rad/s",
    "roll_hop_speed": "{roll_hop_speed:.2f} m/s",
    "least_speed": "{centre_in_flight[least]:.2f} m/s",
    "most_speed": "{centre_in_flight[largest]:.2f} m/s",
    "gravity_centre_speed": "{centre_in_flight[gravity_centre]:.2f} m/s",
    "fall_speed": "{fall_speed:.2f} m/s",
    "rate_before": "{down.before.omega:.2f} rad/s",
    "rate_after": "{down.omega:.2f} rad/s",
    "landing_loss": "{impact_loss[lost]:.2f} J",
    "landing_normal": "{impact_loss[normal]:.2f} J",
    "landing_tangential": "{impact_loss[tangential]:.2f} J",
    "slip_before": "{impact_loss[slip_before]:.2f} J",
    "positive_from": "{positive_potential[angles_deg][0]:.1f}°",
    "positive_to": "{positive_potential[angles_deg][1]:.1f}°",
    "rolls_on": "{landing[slips_again_deg]:.1f}°",
    "rolls_for": "{landing[rolls_for]:.2f} s",
    "low_slip_angle": "{low_friction_rocks[first_slip_deg]:.1f}°",
    "low_turn_angle": "{low_friction_rocks[turning_angles_deg][0]:.1f}°",
    "low_slips": "{low_friction_slips[slips]}",
    "low_loss": "{low_friction_slips[friction]:.1f} J",
    "low_duration": "{low_friction_slips[duration]:g} s",
    "parts_eccentricity": "{made.eccentricity:.2f}",
    "parts_inertia": "{made.inertia_ratio:.4f}",
    "scaled_radius": "{small.radius:g} m",
    "scaled_mass": "{small.mass:g} kg",
    "scaled_speed": "{small_speed:.2f} m/s",
    "scaled_takeoff": "{scaled.angle!d:.6f}°",
    "large_takeoff": "{large.angle!d:.6f}°",
    "right_rate": "{with_load:.2f} rad/s",
    "wrong_rate": "{without_load:.2f} rad/s",
}


def facts(statements: Sequence[Statement], runs: Runs) -> dict[str, str]:
    """Return the numbers in the text of the report, by name; the statements are checked ones."""
    values = {one.key: one.numbers for one in statements} | _motions(runs) | _bodies()
    # no line break between number and unit
    return {name: Texts().format(text, **values).replace(" ", "\u00a0") for name, text in TEXTS.items()}


def _motions(runs: Runs) -> dict[str, Any]:
    hoop, plane, hop = runs.hoop, runs.plane, runs.motion("hop")
    off, down = hop.find("takeoff")[0], hop.find("impact")[0]
    return {
        "bottom_force": largest(runs.motion("slow"), runs.sample("slow").t, lambda state: state.normal_force),
        "weight": hoop.mass * plane.gravity,
        "spin": runs.motion("slipping").find("slip_start")[1],
        "hop_slips": hop.find("slip_start"),
        "down": down,
        "flight_time": down.t - off.t,
        "flight_turn": down.angle - off.angle,
        "fall_speed": hoop.eccentricity * down.before.omega * math.sin(down.angle) - down.before.vy,  # of G
        "roll_rate": theory.rolling_speed(off.angle, hoop, 3.1, plane),
        "roll_hop_speed": theory.immediate_hop_speed(hoop, plane),
    }


def _bodies() -> dict[str, Any]:
    """Numbers for the article's comments: a hoop made of parts, and another radius and mass."""
    made = Hoop.from_parts(1.0, [Ring(mass=0.25, inner_radius=1.0, outer_radius=1.0), PointMass(mass=0.75, at=1.0)])
    hoop, small = Hoop.ideal(0.75), Hoop.ideal(0.75, **SMALL)
    speed = 3.1 * math.sqrt(small.radius)
    large, scaled = (
        simulate(one, Plane(), Start.rolling(v), duration=2.5).find("takeoff")[0] for one, v in ((hoop, 3.1), (small, speed))
    )
    wrong = Hoop(eccentricity=0.75, inertia_ratio=0.25)
    found = {"made": made, "small": small, "small_speed": speed, "large": large, "scaled": scaled}
    return found | {"with_load": theory.max_rolling_speed(hoop, 0.1), "without_load": theory.max_rolling_speed(wrong, 0.1)}
