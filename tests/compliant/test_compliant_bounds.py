"""A compliant motion never takes more steps than it may, and says so."""

import math
from pathlib import Path

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.compliant import event_loop as kernel
from hophoop.kernel.compliant.event_loop import run
from hophoop.kernel.compliant.records import OM, SIZE, VN, WIDTH, Y, new_work
from hophoop.kernel.physics.body import Event, Status
from hophoop.kernel.records.layout import EVENT
from hophoop.simulation.compliant import to_compliance, to_start
from invariants import check


def followed(steps, room, duration=2.0):
    """(status, number of events, number of pieces), the last event, the rows and what was reached."""
    scenario = hh.Scenario(contact=hh.Compliant(), duration=duration)
    body, comp, t_end, rtol = to_compliance(scenario)
    start, touching = to_start(scenario, body, comp)
    events, rows, reached = np.empty(64, EVENT), np.zeros((room, WIDTH)), np.zeros(1)
    found = run(body, comp, start, touching, t_end, rtol, steps, events, rows, reached)
    return found, events[found[1] - 1], rows, reached[0] * t_end


@pytest.mark.parametrize("steps", [1, 20])
def test_steps_are_used_up(steps):
    (status, _, pieces), last, rows, reached = followed(steps, steps)
    assert reached == pytest.approx(last["t"], rel=1e-15)  # what somebody who looks on is told
    assert status == Status.EVENT_LIMIT
    assert pieces < steps
    assert last["kind"] == Event.END
    assert pieces == 0 or last["t"] == rows[pieces - 1, 1]


def test_steps_beyond_the_table_are_counted():
    """So that it can be made as long as is needed."""
    (short, _, few, _), (long, _, rows, _) = (followed(1000, room, 0.1) for room in (3, 100))
    assert short == long
    assert 3 < short[2] <= 100
    assert (few == rows[:3]).all()


@pytest.mark.parametrize("limit", [1, 5])
def test_the_ledger_of_a_motion_that_ends_early(limit):
    """It is that of the last event, and not of a piece beyond it."""
    motion = hh.simulate(hh.Scenario(contact=hh.Compliant(max_events=limit), duration=2.0))
    assert motion.status == "event_limit"
    assert len(motion.events) == limit
    assert abs(motion.ledger.residual) <= 1e-6 * motion.ledger.range


def test_a_landing_after_millions_of_turns_takes_few_steps():
    """Steps that ask for digits which the angle does not have shrink to noise, hundreds of thousands to a landing."""
    scenario = kept(5406).replace("contact.max_events", 22)
    motion = hh.simulate(scenario)
    assert abs(motion.events[-1].angle) > 1e8
    assert len(motion.tables["segments"]) < 2_000
    assert abs(motion.ledger.residual) <= 1e-7 * motion.ledger.range


def kept(index):
    """A scenario that a night found."""
    return hh.Scenario.load(Path(__file__).parents[1] / "data" / "once_open" / f"{index}.toml")


def test_a_compliant_motion_has_no_doubt():
    """Rigid contact of the same scenario is on the boundary of two classes."""
    scenario = hh.Scenario(start=hh.Start.rolling(float(hh.theory.immediate_hop_speed(hh.Hoop()))), duration=0.1)
    assert hh.simulate(scenario).doubt < 0.1
    assert hh.simulate(scenario.replace("contact", hh.Compliant())).doubt == math.inf


def test_an_angle_keeps_its_digits_through_a_flight_of_many_turns():
    """Next to 5·10¹¹ rad the last digit of one double is 10⁻⁴ rad."""
    plane = hh.Plane(mu=0.3, gravity=1e-4)
    start = hh.Start(height=1e6, angle=0.3, omega=-9e3, vx=0.0)
    motion = hh.simulate(
        hh.Scenario(
            plane=plane, start=start, duration=1e9, contact=hh.Compliant(stiffness=1e8, friction="linear", max_events=60)
        )
    )
    assert len(motion.sequence) > 2
    assert abs(motion.events[-1].angle) > 5e11
    assert abs(motion.ledger.residual) <= 1e-6 * motion.ledger.range


def test_many_steps_within_the_last_digit_of_a_late_time_have_one_ledger():
    """The last event falls between steps that all begin at the same double; its losses were those of another one."""
    motion = hh.simulate(kept(15191).replace("contact.max_events", 200))
    assert motion.duration > 1e5
    assert abs(motion.ledger.residual) <= 1e-9 * motion.ledger.range


def test_steps_of_a_light_ring_keep_the_ledger():
    """With κ = 10⁻⁶ the estimate of a step said too little of its error in rolling: the ledger was off by 10⁻⁶ and more."""
    motion = hh.simulate(kept(22919).replace("contact.rtol", 1e-8))
    assert len(motion.tables["segments"]) < 20_000
    assert abs(motion.ledger.residual) <= 1e-8 * len(motion.tables["segments"]) / 10.0 * motion.ledger.range


def test_the_ledger_of_a_step():
    """It is what its energies and losses say, whatever rounding: a wrong sign of any of them would refuse every step."""
    scenario = hh.Scenario(
        plane=hh.Plane(slope=0.3, rolling_resistance=0.01),
        start=hh.Start(height=0.1, vx=2.0, omega=1.0),
        contact=hh.Compliant(friction="bristle", stiffness=1e4),
        duration=0.5,
    )
    fine = hh.simulate(scenario.replace("contact.rtol", 1e-10))
    assert len(fine.tables["segments"]) < 1_000
    assert abs(fine.ledger.residual) <= 1e-11 * len(fine.tables["segments"]) * fine.ledger.range


def test_a_motion_of_no_time_stays_at_its_start():
    """It was sampled as zeros: a bristle that hardly holds lets go at once, and with it ends a motion of one event."""
    scenario = kept(24580)
    motion = hh.simulate(scenario)
    sample = motion.at(0.0)
    assert motion.duration == 0.0
    assert (sample.x, sample.angle) == (scenario.start.x, scenario.start.angle)
    assert sample.height < 0.0 < sample.normal_force
    assert motion.ledger.residual == 0.0 != motion.ledger.potential


def test_a_bristle_lets_go_before_the_load_vanishes():
    """Both came between the same two samples of a step, and the end of the load was taken for the first."""
    motion = hh.simulate(kept(70961))
    check(motion)
    sample = motion.at(np.array([event.t for event in motion.find("takeoff")]), side="left")
    assert len(sample.t) > 50
    assert (abs(sample.friction_force) <= sample.normal_force + 1e-8).all()


def test_turns_are_counted_on():
    """A hoop that rolls on has turned by x/R, but for the creep of its friction."""
    motion = hh.simulate(
        hh.Scenario.from_query("duration=40&hoop.load_fraction=0.3&start.angle=6&start.speed=3&contact.model=compliant")
    )
    sample = motion.at(motion.times(2000))
    assert sample.angle[-1] - 6.0 > 20.0 * np.pi
    assert sample.angle - 6.0 == pytest.approx(sample.x, abs=0.1)


def test_a_hoop_that_hops_at_once_is_in_flight_from_the_start():
    start, hoop = hh.Start.rolling(5.0), hh.Hoop.ideal(0.75)
    motion = hh.simulate(hh.Scenario(hoop=hoop, start=start, duration=0.1, contact=hh.Compliant()))
    assert [event.kind for event in motion.events] == ["start", "end"]


def test_turns_in_flight_are_counted():
    motion = hh.simulate(hh.Scenario.from_query("duration=0.3&start.height=1&start.omega=60&contact.model=compliant"))
    sample = motion.at(motion.times(50))
    assert sample.angle == pytest.approx(60.0 * sample.t, rel=1e-12)


@pytest.mark.parametrize(("most", "what"), [(50, kernel.GIVEN_UP), (500, kernel.CLEAR)])
def test_turns_below_the_level_of_the_plane_are_used_up(monkeypatch, most, what):
    """A spinning rim on its way up again, faster than the plane follows it: 300 panels of 3 rad."""
    contact = hh.Compliant(law="hunt-crossley", damping=1e4)
    scenario = hh.Scenario(hoop=hh.Hoop(eccentricity=1e-6, inertia_ratio=1.0), plane=hh.Plane(gravity=0.0), contact=contact)
    body, comp, _, _ = to_compliance(scenario)
    begin = np.zeros(SIZE)
    begin[Y], begin[VN], begin[OM] = -0.3, 0.1, 300.0
    monkeypatch.setattr(kernel, "MOST_PANELS", most)
    ended, tau = kernel.fly_below(body, comp, begin, body.eps * 300.0**2, 100.0, new_work())
    assert ended == what
    assert tau == pytest.approx(most * kernel.PHASE / 300.0 if what == kernel.GIVEN_UP else 3.0, rel=1e-4)
