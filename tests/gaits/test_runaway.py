"""Fast motion without its flights, in examples/in_the_end.py, against motions with gravity, and where it begins to grow."""

import math
import runpy
from pathlib import Path

import numpy as np
import pytest

import hophoop as hh

pytest.importorskip("matplotlib", reason="the extra 'plots' is not installed")
EXAMPLE = runpy.run_path(str(Path(__file__).parents[2] / "examples" / "in_the_end.py"))
FALL = EXAMPLE["FALL"]
HOOP = hh.Hoop.ideal(0.75, radius=1.0, mass=1.0)
PLANES = {
    "plastic": hh.Plane(gravity=1.0, slope=0.5),
    "bouncing": hh.Plane(gravity=1.0, slope=0.3, restitution=0.5, impact_law="newton"),
    "resisted": hh.Plane(gravity=1.0, slope=0.4, mu_static=0.7, mu_kinetic=0.5, rolling_resistance=0.05),
    "uphill": hh.Plane(gravity=1.0, slope=-0.4),
}


def without_gravity(plane):
    return hh.Plane.model_validate({**plane.model_dump(exclude={"mu"}), "gravity": 0.0})


def of_gravity_centre(state):
    eps = HOOP.eccentricity
    return (
        float(state.vx + eps * state.omega * math.cos(state.angle)),
        float(state.vy - eps * state.omega * math.sin(state.angle)),
        float(state.omega),
    )


@pytest.mark.parametrize("name", PLANES)
@pytest.mark.parametrize("seed", range(3))
def test_one_passage_is_that_of_fast_motion_with_gravity(name, seed):
    """From the height of the fall on the way up to the take-off after the next contact, at 10⁴ √(g R)."""
    rng = np.random.default_rng(seed)
    plane, fast = PLANES[name], 1e4
    along, away, omega = fast * np.array([rng.uniform(-1, 1), rng.uniform(0.2, 1), rng.uniform(-1, 1)])
    eps, angle = HOOP.eccentricity, rng.uniform(0, 2 * math.pi)
    start = hh.Start(
        height=FALL - eps * math.cos(angle) - 1.0,
        angle=angle,
        vx=along - eps * omega * math.cos(angle),
        vy=away + eps * omega * math.sin(angle),
        omega=omega,
    )
    flight = 2.0 * away / (plane.gravity * math.cos(plane.slope))
    motion = hh.simulate(hh.Scenario(hoop=HOOP, plane=plane, start=start, duration=flight + 2e3 / fast))
    landing = next(event for event in motion.events if event.kind == "impact")
    last = [event for event in motion.events if event.kind in ("takeoff", "impact")][-1]
    assert last.to_mode == "H"
    # when the fall begins, and where the load is then
    early = motion.at(np.linspace(landing.t - 20 / fast, landing.t, 40001))
    height = 1.0 + early.height + eps * np.cos(early.angle)
    at = float(np.interp(-FALL, -height, early.angle)) % (2.0 * math.pi)
    found = EXAMPLE["passage"](HOOP, plane.slope, without_gravity(plane), (along, away, omega), at)
    assert np.array(found) / fast == pytest.approx(np.array(of_gravity_centre(last)) / fast, abs=1e-6)


def test_the_critical_slope_is_that_of_motions_with_their_flights():
    """34.31° ± 0.08° is from 9,000 landings a slope, computed with gravity and long flights."""
    slope, error = EXAMPLE["critical_slope"](hh.Hoop.ideal(0.75), hh.Plane(), 4_000, 7)
    assert abs(math.degrees(slope) - 34.31) < 3 * math.hypot(0.08, math.degrees(error))
