"""Motions that go on from a state of another one, compared with the one that was not interrupted."""

import math

import numpy as np
import pytest

import hophoop as hh
from interrupted import FREE, check_restart, onward
from random_scenarios import draw, scenario_of

HOPS = hh.Scenario(hoop=hh.Hoop.ideal(0.5), plane=hh.Plane(slope=math.radians(3.0)), duration=20.0)
HOP = hh.simulate(hh.Scenario(duration=2.0))


@pytest.mark.long
def test_random_cuts():
    """150 cuts, at a random time or event, from the left or the right: the next event is that of the whole motion."""
    compared = 0
    for index in range(150):
        motion = hh.simulate(scenario_of(draw(36, index), 400))
        random = np.random.default_rng([36, index])
        event = motion.events[int(random.integers(len(motion.events)))]
        t, side = (event.t, "left") if index % 2 else (float(random.random()) * motion.duration, "right")
        state = motion.at(t, side) if index % 3 else event
        compared += check_restart(motion, state)
    assert compared > 80


def test_slip_below_the_static_limit_goes_on():
    """With μs > μk both rolling and slip are possible without slip velocity: the mode tells."""
    plane = hh.Plane(mu_static=1.0, mu_kinetic=0.05, slope=0.3)
    for mode in "SR":
        start = hh.Start(angle=2.0, vx=0.0, omega=0.0, slip=0.0, mode=mode)
        assert hh.simulate(hh.Scenario(plane=plane, start=start, duration=0.1)).sequence == mode


def test_a_load_that_slides_on_the_plane_goes_on():
    """The massless hoop after the strike of its load."""
    motion = hh.simulate(hh.Scenario.from_query("duration=3&hoop.load_fraction=1&plane.mu=0.3&start.speed=1"))
    (strike,) = motion.find("impact")
    assert strike.to_mode in "SK"
    again = onward(motion, motion.at(0.5 * (strike.t + motion.duration)))
    assert (again.events[-1].x, again.status) == (pytest.approx(motion.events[-1].x, abs=1e-12), motion.status)


def test_a_start_from_a_state_is_that_of_its_positions_and_velocities():
    """On another plane, and for derivatives; with another velocity it has no mode."""
    start = hh.Start.of(hh.simulate(HOPS).at(7.3))
    free = hh.Start(**{name: getattr(start, name) for name in FREE})
    other = HOPS.with_values({"plane.mu": 0.5, "duration": 2.0})
    one, same = (hh.simulate(other.with_values({"start": each})) for each in (start, free))
    assert one.sequence == same.sequence
    assert one.events[-1].angle == pytest.approx(same.events[-1].angle, abs=1e-10)
    for of in ("end.angle", "impact.omega"):
        wanted, found = (each.sensitivity(of, ["start.omega", "plane.mu"]).derivatives for each in (same, one))
        np.testing.assert_allclose(found, wanted, rtol=1e-9)
    moved = one.scenario.replace("start.omega", 3.0).start
    assert (moved.slip, moved.mode) == (None, None)
    compliant = HOPS.with_values({"contact.model": "compliant", "duration": 0.5})
    assert hh.Start.of(hh.simulate(compliant).at(0.3)).mode is None


def test_turns_without_friction_are_starts():
    """There the slip velocity is 0 by the mode, and vx − R omega is rounding of speeds that are gone."""
    for slope, angle, speed in ((0.0, 2.0, 0.0), (0.0, -1.0, 0.5), (0.1, 3.0, 0.0)):
        scenario = hh.Scenario(plane=hh.Plane(mu=0.0, slope=slope), start=hh.Start.rolling(speed, angle=angle))
        motion = hh.simulate(scenario)
        for event in motion.events[:-1]:
            for state in (event, motion.at(event.t, "left"), motion.at(event.t)):
                assert scenario.replace("start", hh.Start.of(state)).start.angle == state.angle


def test_files_and_links():
    """All numbers survive, and a start without slip and mode is written without them."""
    scenario = HOPS.replace("start", hh.Start.of(hh.simulate(HOPS).at(7.3)))
    fingerprint = hh.simulate(scenario).fingerprint
    for again in (hh.Scenario.loads(scenario.to_toml()), hh.Scenario.from_query(scenario.to_query())):
        assert again == scenario
        assert hh.simulate(again).fingerprint == fingerprint
    assert set(HOPS.to_dict()["start"]) == {"x", "angle", "speed"}
    assert set(hh.Start(vx=1.0).to_dict()) == {*FREE}


def test_several_states_are_no_start():
    with pytest.raises(ValueError, match=r"single t\.$"):
        hh.Start.of(HOP.at([0.1, 0.2]))
