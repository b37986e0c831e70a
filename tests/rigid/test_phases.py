"""`hh.phases`: the phases of a motion and why each ends."""

import itertools
import math

import pytest

import hophoop as hh
from hophoop import article
from hophoop.kernel.physics.body import EVENT_NAMES, PASSING
from random_scenarios import draw


def split(motion):
    """Beginnings of the phases of a motion, also from turning points on."""
    inside = {EVENT_NAMES[kind] for kind in PASSING} - {"turn"}
    marks = [event for event in motion.events if event.kind not in inside]
    return [(event.t, event.to_mode) for event, after in itertools.pairwise(marks) if after.t > event.t]


def check(scenario):
    motion = hh.simulate(scenario)
    found = list(hh.phases(scenario))
    lasting = [phase for phase in found if phase.t_end > phase.t_begin]
    assert [(phase.t_begin, phase.mode) for phase in lasting] == split(motion)
    written = [event for phase in found for event in phase.events]
    times = [event.t for event in motion.events if event.kind != "end"]
    assert [event.t for event in written] == times[len(times) - len(written) :]
    return motion, found


@pytest.mark.parametrize("name", sorted(article.scenarios()))
def test_the_articles_motions(name):
    check(article.scenarios()[name])


def check_at_random(count):
    seen = set()
    for index in range(count):
        scenario = hh.Scenario.model_validate({**draw(11, index)[1], "duration": 3.0})
        if scenario.contact.model != "rigid":
            continue
        motion = hh.simulate(scenario)
        if not motion.ok or len(motion.events) > 60:
            continue
        _, found = check(scenario)
        seen |= {phase.ended_by.split(":")[0].split(" F =")[0].split(", with")[0] for phase in found}
    assert len(seen) >= 6, seen


def test_a_paradox_long_after_a_landing_ends_a_phase_of_its_own():
    check(hh.Scenario.model_validate({**draw(11, 139)[1], "duration": 3.0}))


@pytest.mark.parametrize("count", [60, pytest.param(400, marks=pytest.mark.long)])
def test_random_motions(count):
    check_at_random(count)


def test_margins_are_those_of_the_motion():
    """N and F at both ends of each phase, and the reason is the margin that is used up."""
    scenario = hh.Scenario(start=hh.Start.rolling(3.1), duration=2.0)
    motion = hh.simulate(scenario)
    found = list(hh.phases(scenario))
    for phase in found:
        at = motion.at(phase.t_begin)
        assert phase.begin.normal_force == pytest.approx(at.normal_force, rel=1e-12, abs=1e-12)
        assert phase.begin.friction_force == pytest.approx(at.friction_force, rel=1e-12, abs=1e-12)
        assert phase.begin.slip == pytest.approx(at.slip, abs=1e-15)
    rolling, sliding, _, lifting, flying, _ = found
    assert abs(rolling.end.friction_force) == pytest.approx(rolling.end.friction_limit, rel=1e-12)
    assert sliding.end.slip == 0.0
    assert lifting.end.normal_force == pytest.approx(0.0, abs=1e-12)
    assert lifting.end.free_acceleration == pytest.approx(0.0, abs=1e-12)
    assert flying.end.slip == pytest.approx(motion.find("impact")[0].before.slip, rel=1e-14)
    # p_σ = W_nn − σ μk W_tn, with W from the model page
    hoop = scenario.hoop
    s, c = math.sin(sliding.angle_begin), math.cos(sliding.angle_begin)
    eps, kappa = hoop.eccentricity, hoop.inertia_ratio
    expected = 1.0 + eps**2 * s**2 / kappa + eps * s * (1.0 + eps * c) / kappa
    assert sliding.begin.p_sigma == pytest.approx(expected, rel=1e-13)


@pytest.mark.parametrize("speed", [3.6166282640049716, 2.90816022624919, 3.1598361439299016])
def test_phases_after_a_doubt_are_those_of_the_motion(speed):
    scenario = hh.Scenario(start=hh.Start.rolling(speed), duration=4.0)
    motion = hh.simulate(scenario)
    assert motion.doubt < 4.0
    found = [(phase.t_begin, phase.mode) for phase in hh.phases(scenario) if phase.t_end > phase.t_begin]
    assert found == split(motion)


def test_phases_of_a_motion_that_goes_on():
    """They begin in the mode of the state."""
    motion = hh.simulate(hh.Scenario(duration=2.0))
    (begins, *_) = motion.find("slip_start")
    onward = motion.scenario.with_values({"start": hh.Start.of(begins), "duration": 2.0 - begins.t})
    assert [phase.mode for phase in hh.phases(onward)] == list("KRSHR")


def test_a_compliant_contact_is_refused():
    with pytest.raises(ValueError, match=r"contact\.model = 'compliant' must be 'rigid'"):
        hh.phases(hh.Scenario(contact=hh.Compliant()))
