"""Samples between events and at them: slip without rotation and rest by hand, and which side of an event a sample is on."""

import math

import numpy as np
import pytest

import hophoop as hh
from random_scenarios import draw, scenario_of


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_hoop_that_does_not_turn_slides_and_rests(side):
    """The couple holds it on a slope: gravity and friction slow it down evenly, until friction holds it as well."""
    hoop = hh.Hoop(radius=0.5, mass=2.0, eccentricity=0.5, inertia_ratio=0.6)
    plane = hh.Plane(mu=0.2, slope=0.1, rolling_resistance=0.9)
    motion = hh.simulate(hoop, plane, hh.Start(x=3.0, angle=0.3, vx=side * 2.0), duration=9.0)
    assert (motion.sequence[-1], motion.status) == ("R", "at_rest")
    load, pull = 2.0 * 9.81 * math.cos(0.1), 2.0 * 9.81 * math.sin(0.1)
    speed = side * 2.0 + 0.5 * (pull - side * 0.2 * load) * 0.25
    slid = 0.25 * (side * 1.0 + 0.5 * speed)
    fallen = load * (math.cos(0.3) - 1.0) * 0.25 - pull * (3.0 + slid + 0.25 * math.sin(0.3))
    for t, way, forces in ((0.25, slid, (load, -side * 0.2 * load)), (9.0, None, (load, -pull))):
        found = motion.at(t)
        assert (found.angle, found.omega, found.height, found.vy) == (0.3, 0.0, 0.0, 0.0)
        assert (found.normal_force, found.friction_force) == pytest.approx(forces, rel=1e-14)
        if way:
            assert found.vx == found.slip == pytest.approx(speed, rel=1e-14)
            assert (found.x, found.friction) == pytest.approx((3.0 + way, 0.2 * load * abs(way)), rel=1e-14)
            assert (found.kinetic, found.potential) == pytest.approx((speed**2, fallen), rel=1e-13)


@pytest.mark.parametrize("speed", [0.3, -1.7, 3.1])
@pytest.mark.parametrize("radius", [1.0, 0.3])
def test_just_before_the_load_strikes_the_rim_turns_without_bound(radius, speed):
    """The limit, whatever rounding makes of the time: the load is down and has all its energy, the rim has none."""
    motion = hh.simulate(hh.Hoop.ideal(1.0, radius), start=hh.Start.rolling(speed), duration=9.0)
    impact = motion.find("impact")[0]
    before, after = motion.at(impact.t, side="left"), motion.at(impact.t)
    assert before.omega == before.vx == math.copysign(math.inf, speed)
    assert (before.mode, before.x, before.angle, before.slip) == ("M", impact.x, impact.angle, impact.before.slip)
    assert before.kinetic == pytest.approx(0.5 * (impact.before.slip**2 + impact.before.vy**2), rel=1e-14)
    assert (after.omega, after.vx) == (impact.omega, impact.vx)


def test_at_an_event_a_sample_is_the_state_just_after_it():
    """To the last bit, where the event begins a phase; and from the left that just before it."""
    seen = set()
    for index in range(40):
        motion = hh.simulate(scenario_of(draw(31, index), 200))
        begins, rows = set(motion.tables["segments"]["t"].tolist()), motion.tables["events"]
        for event, row, following in zip(motion.events, rows, rows[1:], strict=False):
            if row["t"] < following["t"] and row["t"] in begins:
                sample, before = motion.at(event.t), motion.at(event.t, side="left")
                first = next(one for one in motion.events if one.t == event.t)
                for name in ("x", "height", "vy", "slip", "omega", "friction", "impact_normal"):
                    assert getattr(sample, name) == getattr(event, name), (motion, event.t, name)
                assert sample.mode == event.to_mode
                if event.t > 0.0:
                    assert before.mode == first.from_mode
                    assert before.omega == pytest.approx(first.before.omega, rel=1e-9, abs=1e-9)
                seen.add(event.kind)
    assert seen >= {"start", "takeoff", "impact", "stick", "slip_start"}


def test_the_end_is_the_end_in_seconds_too():
    """Of a motion that ends before its time, there and back between the units."""
    ended = [motion for index in range(60) if not (motion := hh.simulate(scenario_of(draw(31, index), 7))).ok]
    assert len(ended) > 5
    for motion in ended:
        (found,) = motion.units.kernel_times(motion.tables["segments"], np.array([motion.duration]))
        last = motion.tables["events"]["t"][-1]
        assert found == last or (motion.status == "event_limit" and abs(found - last) <= 2.3e-16 * last)
