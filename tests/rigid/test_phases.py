"""`hh.phases`: the phases of a motion and why each ends."""

import itertools

import pytest

import hophoop as hh
from hophoop.kernel.physics.body import EVENT_NAMES, PASSING
from random_scenarios import draw


def check(scenario):
    """The phases of a motion, which begin at its events, also at turning points, and have them."""
    motion = hh.simulate(scenario)
    found = list(hh.phases(scenario))
    inside = {EVENT_NAMES[kind] for kind in PASSING} - {"turn"}
    marks = [event for event in motion.events if event.kind not in inside]
    begun = [(event.t, event.to_mode) for event, after in itertools.pairwise(marks) if after.t > event.t]
    assert [(phase.t_begin, phase.mode) for phase in found if phase.t_end > phase.t_begin] == begun
    written = [event.t for phase in found for event in phase.events]
    times = [event.t for event in motion.events if event.kind != "end"]
    assert written == times[len(times) - len(written) :]
    return motion, found


def random_scenario(index):
    return hh.Scenario.model_validate({**draw(11, index), "duration": 3.0})


@pytest.mark.parametrize("count", [60, pytest.param(400, marks=pytest.mark.long)])
def test_random_motions(count):
    seen = set()
    for scenario in map(random_scenario, range(count)):
        if scenario.contact.model != "rigid":
            continue
        motion = hh.simulate(scenario)
        if motion.ok and len(motion.events) <= 60:
            seen |= {phase.ended_by.split(":")[0].split(" F =")[0].split(", with")[0] for phase in check(scenario)[1]}
    assert len(seen) >= 6, seen


def test_a_paradox_long_after_a_landing_ends_a_phase_of_its_own():
    check(
        hh.Scenario.from_query(
            "duration=3&hoop.radius=0.6855079852407605&hoop.mass=0.5886285681887637&hoop.load_fraction=0.9999999999926623"
            "&plane.slope=0.771821079891456&plane.mu=0.7585034953774762&plane.impact_law=newton&start.height=0.4447958288114718"
            "&start.angle=1.1643293684434308&start.vx=0.3100195103899729&start.vy=-1.4659865566059846&start.omega=-0.9559680812037399"
        )
    )


@pytest.mark.parametrize("speed", [3.6166282640049716, 2.90816022624919, 3.1598361439299016])
def test_phases_after_a_doubt_are_those_of_the_motion(speed):
    assert check(hh.Scenario(start=hh.Start.rolling(speed), duration=4.0))[0].doubt < 4.0


def test_the_margin_that_is_used_up_ends_a_phase():
    motion, found = check(hh.Scenario(start=hh.Start.rolling(3.1), duration=2.0))
    rolling, sliding, _, lifting, flying, _ = (phase.end for phase in found)
    assert found[0].begin.normal_force == pytest.approx(motion.at(0.0).normal_force, rel=1e-12)
    assert abs(rolling.friction_force) == pytest.approx(rolling.friction_limit, rel=1e-12)
    assert sliding.slip == 0.0
    assert (lifting.normal_force, lifting.free_acceleration) == pytest.approx((0.0, 0.0), abs=1e-12)
    assert flying.slip == pytest.approx(motion.find("impact")[0].before.slip, rel=1e-14)


def test_phases_of_a_motion_that_goes_on():
    """They begin in the mode of the state."""
    motion = hh.simulate(hh.Scenario(duration=2.0))
    (begins, *_) = motion.find("slip_start")
    onward = motion.scenario.with_values({"start": hh.Start.of(begins), "duration": 2.0 - begins.t})
    assert [phase.mode for phase in hh.phases(onward)] == list("KRSHR")


def test_a_compliant_contact_is_refused():
    with pytest.raises(ValueError, match=r"contact\.model = 'compliant' must be 'rigid'"):
        hh.phases(hh.Scenario(contact=hh.Compliant()))
