"""Estimated errors of events where calculus gives them: rounding of each event, times what the motion makes of it."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.native import forced

ROUNDING = 4e-16
RING = hh.Hoop(eccentricity=0.0, inertia_ratio=1.0)  # with radius, mass and gravity 1, all units are 1


def motion_of(start, duration, hoop=RING, **plane):
    with forced("interpreted"):
        motion = hh.simulate(hoop, hh.Plane(gravity=1.0, restitution=0.0, **plane or {"mu": 0.5}), start, duration=duration)
        assert motion.errors is not None  # computed here
    return motion


ROLLING, SLIPPING, THROWN = hh.Start.rolling(2.0), hh.Start(vx=2.0, omega=0.5), hh.Start(height=1.5, vx=3.0, vy=1.0, omega=0.5)
SPEEDS = 0.5 + 2.5 + 1.0  # of the throw: θ̇, v_t and v_n


@pytest.mark.parametrize(
    ("start", "duration", "index", "name", "parts"),
    [
        # x = ω t: of ω its rounding counts; v_t, v_n and the height are zero by what rolling is, friction has no work
        (ROLLING, 3.0, 0, "x", [1.0]),
        (ROLLING, 3.0, -1, "t", [1.0 + 3.0]),
        (ROLLING, 3.0, -1, "x", [1.0 + 6.0, 2.0 * 3.0]),
        (ROLLING, 3.0, -1, "omega", [1.0 + 2.0, 2.0]),
        (ROLLING, 3.0, -1, "vx", [1.0 + 2.0, 2.0]),
        (ROLLING, 3.0, -1, "angle", [1.0 + 6.0, 2.0 * 3.0, 1.0]),
        # t = √(2 h), changed by h/√(2 h) where the height is by h; the hoop stays there
        (hh.Start(height=2.0), 3.0, 1, "t", [1.0 + 2.0, 2.0 / 2.0]),
        (hh.Start(height=2.0), 3.0, 3, "height", [1.0]),
        # t = v + √(v² + 2 h): the rounding of v is that of all speeds
        (THROWN, 3.5, 1, "t", [1.0 + 1.0, SPEEDS]),
        (THROWN, 3.5, 1, "height", [1.0 + 2.0, SPEEDS, 1.5]),
        (THROWN, 3.5, 2, "t", [1.0 + 3.0, SPEEDS * (1.0 + 1.0 / 2.0), 1.5 / 2.0]),
        # v_t ends at t = v_t/(2 μ): v_t and μ count, and θ̇ by the slip that it makes
        (SLIPPING, 4.0, 1, "t", [1.0 + 1.5, (0.5 + 1.5) / 1.5 * 1.5, 1.5]),
        (SLIPPING, 4.0, 1, "slip", [1.0]),
        # from there on it rolls at θ̇ = 1.25, of which the half of θ̇ and v_t before remain, and rounding once more
        (SLIPPING, 4.0, 2, "omega", [1.0 + 1.25, 0.5, 0.5 * (0.5 + 1.5), 1.25]),
    ],
)
def test_by_calculus(start, duration, index, name, parts):
    errors = motion_of(start, duration).errors
    expected = ROUNDING * math.sqrt(sum(part * part for part in parts))
    assert getattr(errors, name)[index] == pytest.approx(expected, rel=1e-9, abs=0.0)


def test_static_friction_is_rounded_where_slip_starts():
    wheel, start = hh.Hoop(eccentricity=0.5, inertia_ratio=0.5), hh.Start.rolling(1.4)
    motion = motion_of(start, 1.0, wheel, mu_static=0.4, mu_kinetic=0.1)
    assert motion.events[1].kind == "slip_start"
    paths = ["start.angle", "start.speed", "plane.mu_static", "plane.mu_kinetic"]
    slopes = motion.sensitivity("slip_start.angle", paths).derivatives
    expected = ROUNDING * np.linalg.norm([1.0 + motion.events[1].angle, *(slopes[0] * [1.0, 1.4, 0.4, 0.1])])
    assert motion.errors.angle[1] == pytest.approx(expected, rel=1e-9, abs=0.0)


def test_a_swing_comes_later_to_all_its_turning_points():
    """θ at the lowest point of a slow swing is rounded to a part of a turn; over θ̇ that is the time that it is late."""
    speed = 1e-3
    hoop = hh.Hoop(eccentricity=0.5, inertia_ratio=1.0)
    motion = motion_of(hh.Start.rolling(speed, angle=math.pi), 12.0, hoop)
    assert [event.kind for event in motion.events] == ["start", "turn", "turn", "end"]
    assert motion.errors.t[1:3] == pytest.approx(ROUNDING / speed, rel=1e-3, abs=0.0)


def test_there_are_none_from_a_slip_into_an_unbounded_force_on():
    scenario = hh.Scenario(
        hoop=hh.Hoop.ideal(0.9743628639734905),
        plane=hh.Plane(mu=0.9048406257906279),
        start=hh.Start(angle=-1.7728528217331099, vx=10.96322093918777, omega=5.406296354291368),
        duration=0.1,
    )
    motion = hh.simulate(scenario)
    assert motion.events[1].kind == "painleve_inconsistent"
    assert np.isfinite(motion.errors.t[0])
    assert np.isinf(motion.errors.t[1:]).all()


def test_those_of_a_compliant_contact_are_refused():
    with pytest.raises(ValueError, match="rigid contact"):
        _ = hh.simulate(hh.Scenario(contact=hh.Compliant(), duration=0.1)).errors
