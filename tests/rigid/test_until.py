"""Ends of a motion before its duration, compared with the motion that goes on."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.physics.body import Event, Mode
from random_scenarios import draw, scenario_of

TURN = 2.0 * math.pi
HOPS = hh.Scenario(hoop=hh.Hoop.ideal(0.5), plane=hh.Plane(slope=math.radians(3.0)), duration=12.0)
UNTILS = ("revolutions:1", "revolutions:0.3", "landings:1", "landings:3", "angle:1.5", "angle:-2", "takeoff", "reversal")


def counted(motion, until):
    """Events of a motion that an event-bound `until` counts, by their public fields."""
    word = until.partition(":")[0]
    if word == "landings":
        return [e for e in motion.events if e.kind == "bounce_limit" or (e.kind == "impact" and e.collision)]
    if word == "reversal":
        return list(motion.find("turn"))
    passing = ("turn", "apex", "kane_gain", "rest", "end")
    opened = [e for e in motion.events if e.kind not in passing and e.to_mode == "H" and e.height == 0.0 and e.vy >= 0.0]
    return [e for e in opened if e.t > 0.0]


def first_passage(motion, until):
    """Time of the first passage of an angle, from samples of the motion that goes on; inf if there is none."""
    word, _, number = until.partition(":")
    start = motion.events[0].angle
    marks = np.unique([e.t for e in motion.events])
    inside = np.concatenate([np.linspace(a, b, 7)[1:-1] for a, b in pairwise(marks)] or [[]])
    times = np.unique(np.concatenate((marks, inside)))
    turned = motion.at(times).angle - start
    if word == "revolutions":
        ahead = back = TURN * float(number)
    else:
        ahead = (float(number) - start) % TURN or TURN
        back = TURN - ahead or TURN
    beyond = np.flatnonzero((turned >= ahead) | (turned <= -back))
    if not beyond.size:
        return math.inf, math.inf
    return times[max(beyond[0] - 1, 0)], times[beyond[0]]


def same_events(brief, long):
    """Assert that the events of a motion, except its END, are the first ones of another.

    The apex of a flight that is not over is the highest point so far, as in a motion that ends by its duration.
    """
    mine, others = (motion.tables["events"] for motion in (brief, long))
    count = len(mine) - 1
    if mine[count]["after_mode"] == Mode.FLIGHT and mine[count - 1]["kind"] == Event.APEX:
        count -= 1
    assert mine[:count].tobytes() == others[:count].tobytes()


@pytest.mark.parametrize("until", UNTILS)
def test_first_part_of_random_motions(until):
    """The motion is the first part of the one that goes on, up to the first event or passage and no further."""
    ended = 0
    for index in range(60):
        scenario = scenario_of(draw(35, index)[1], 300)
        long, brief = hh.simulate(scenario), hh.simulate(scenario, until=until)
        same_events(brief, long)
        end = brief.events[-1]
        if until.partition(":")[0] in ("revolutions", "angle"):
            low, high = first_passage(long, until)
            met = brief.ending == until
            assert met == (high < long.duration) or high == long.duration
            if met:
                assert low - 1e-12 <= end.t <= high + 1e-12
        else:
            events = counted(long, until)
            number = int(until.partition(":")[2] or 1)
            met = len(events) >= number
            assert brief.ending == until if met and events[number - 1].t < scenario.duration else brief.ending != until
            if met:
                wanted = events[number - 1]
                assert (end.t, end.x, end.angle, end.omega) == (wanted.t, wanted.x, wanted.angle, wanted.omega)
        ended += met
        assert brief.status == long.status or brief.ending == until
        assert abs(brief.ledger.residual) <= 1e-9 * brief.ledger.range or scenario.plane.impact_law == "newton"
    assert 5 < ended < 60


@pytest.mark.parametrize("turns", [0.25, 1.0, 3.0])
def test_revolutions_in_either_direction(turns):
    """θ has changed by exactly so many revolutions, forward or backward."""
    for speed in (3.1, -3.1):
        motion = hh.simulate(HOPS.with_values({"start.speed": speed, "plane.slope": 0.0}), until=f"revolutions:{turns}")
        assert motion.ending == f"revolutions:{turns}"
        assert motion.events[-1].angle == pytest.approx(math.copysign(TURN * turns, speed), abs=2e-15 * turns * TURN)


def test_next_passage_of_an_angle():
    """The nearest passage ahead, and for a start at the angle itself the next one."""
    motion = hh.simulate(HOPS, until="angle:1")
    assert motion.events[-1].angle == pytest.approx(1.0, abs=1e-15)
    assert hh.simulate(HOPS, until=f"angle:{1.0 - 5 * TURN}").events[-1].t == pytest.approx(motion.duration, rel=1e-13)
    assert hh.simulate(HOPS, until="angle:0").events[-1].angle == pytest.approx(TURN, abs=1e-14)
    rocking = HOPS.with_values({"plane.slope": 0.0, "start.speed": 0.5, "start.angle": 1.5})
    behind = hh.simulate(rocking.replace("start.speed", -0.1), until=f"angle:{math.pi}")
    assert behind.events[-1].angle == pytest.approx(math.pi, abs=1e-14)
    assert len(behind.find("turn")) == 1


@pytest.mark.parametrize("way", [1.0, -1.0])
@pytest.mark.parametrize(("turned", "mode"), [(0.5, "R"), (1.2, "M"), (3.0, "M"), (math.pi, "R")])
def test_an_angle_that_the_massless_hoop_passes_as_its_load_falls(way, turned, mode):
    """It rolls up to 1 rad, skims, and slides on with its load at the bottom, at π."""
    massless = hh.Hoop(eccentricity=1.0, inertia_ratio=0.0)
    plane = hh.Plane(mu=0.5)
    for until in (f"angle:{way * turned}", f"revolutions:{turned / TURN}"):
        motion = hh.simulate(massless, plane, hh.Start.rolling(way * 0.5), 12.0, until=until)
        end = motion.events[-1]
        assert (motion.ending, end.to_mode) == (until, mode)
        assert end.angle == pytest.approx(way * turned, rel=3e-16)
        whole = hh.simulate(massless, plane, hh.Start.rolling(way * 0.5), 12.0)
        same_events(motion, whole)
        assert whole.at(end.t).angle == pytest.approx(end.angle, abs=1e-13)
        assert whole.at(end.t).x == pytest.approx(end.x, abs=1e-13)


def test_a_start_that_leaves_the_plane_is_no_takeoff():
    """The first one after it ends the motion."""
    thrown = hh.simulate(HOPS.with_values({"start": hh.Start(vy=1.0, vx=3.0, omega=3.0)}), until="takeoff")
    assert thrown.ending == "takeoff"
    assert thrown.duration > 0.0
    assert thrown.events[-1].to_mode == "H"


def test_the_last_landing_has_its_gain():
    """Kane's energy gain belongs to it, and the ledger closes."""
    gaining = hh.Scenario(
        hoop=hh.Hoop(eccentricity=0.0, inertia_ratio=0.4),
        plane=hh.Plane(restitution=1.0, impact_law="newton", mu_static=0.5, mu_kinetic=0.3),
        start=hh.Start(height=1.0, vx=0.2, omega=3.0),
    )
    motion = hh.simulate(gaining, until="landings:2")
    same_events(motion, hh.simulate(gaining))
    assert motion.events[-1].kind == "end"


def test_duration_stays_the_limit():
    """What comes later than the duration does not end the motion."""
    motion = hh.simulate(HOPS.replace("duration", 1.0), until="revolutions:3")
    assert (motion.ending, motion.duration) == ("duration", 1.0)
    assert motion.fingerprint == hh.simulate(HOPS.replace("duration", 1.0)).fingerprint
    assert hh.simulate(HOPS.replace("plane.mu", 0.0), until="landings:500").ending == "duration"
    limited = hh.simulate(HOPS.replace("contact.max_events", 4), until="landings:1")
    assert limited.ending == limited.status == "event_limit"


@pytest.mark.parametrize("until", ["landings:1", "angle:2.5"])
def test_digits(until):
    """Extended precision ends at the same instant, with all its digits."""
    rough, exact = hh.simulate(HOPS, until=until), hh.simulate(HOPS, until=until, digits=30)
    assert exact.ending == rough.ending == until
    assert exact.sequence == rough.sequence
    end, wanted = rough.events[-1], exact.events[-1]
    for name in ("t", "x", "height", "angle", "omega", "slip"):
        assert getattr(end, name) == pytest.approx(float(getattr(wanted, name)), rel=1e-12, abs=1e-13)
    if until == "angle:2.5":
        assert str(wanted.angle).startswith("2.50000000000000000000000000")


def test_reversal_with_digits():
    """A rocking hoop ends at its first turning point."""
    rocking = hh.Scenario(start=hh.Start.rolling(0.3, angle=2.0))
    rough, exact = hh.simulate(rocking, until="reversal"), hh.simulate(rocking, until="reversal", digits=20)
    assert rough.events[-1].omega == 0.0
    assert rough.duration == pytest.approx(float(exact.duration), rel=1e-13)


def test_saved_and_loaded(tmp_path):
    """A file keeps what ended the motion, and its doubt."""
    motion = hh.simulate(HOPS, until="landings:2")
    motion.save(tmp_path / "brief.nc")
    again = hh.load(tmp_path / "brief.nc")
    assert (again.ending, again.fingerprint, again.doubt) == (motion.ending, motion.fingerprint, motion.doubt)
    assert motion.to_dict()["ending"] == "landings:2"
    assert "ending" not in hh.simulate(HOPS).to_dict()


@pytest.mark.parametrize("bad", ["x", "landings:1.5", "landings:0", "revolutions:-1", "revolutions:", "angle:nan", "angle:1e9"])
def test_unknown_ends(bad):
    """One sentence with the field, the value and what is allowed."""
    for more in ({}, {"digits": 20}):
        with pytest.raises(ValueError, match=r"^until = '.*' must be one of revolutions:N, .*\.$"):
            hh.simulate(HOPS, until=bad, **more)


def test_compliant_contact():
    with pytest.raises(ValueError, match=r"^until = 'takeoff' needs rigid contact"):
        hh.simulate(HOPS.replace("contact.model", "compliant"), until="takeoff")


@pytest.mark.parametrize("until", UNTILS)
def test_the_sample_at_the_end_is_the_state_after_its_event(until):
    """Mode, state and forces; from the left those before. A motion goes on from either as it was."""
    goes_on = HOPS if until != "reversal" else HOPS.with_values({"plane.slope": 0.0, "start.angle": 2.0, "start.speed": 0.3})
    motion, whole = hh.simulate(goes_on, until=until), hh.simulate(goes_on)
    end, after, before = motion.events[-1], motion.at(motion.duration), motion.at(motion.duration, "left")
    assert motion.ending == until
    assert (after.mode, after.t) == (end.to_mode, motion.duration)
    for name in ("x", "height", "angle", "vx", "vy", "omega", "slip"):
        assert getattr(after, name) == getattr(end, name)
    same = whole.at(motion.duration)
    assert after.mode == same.mode
    for name in ("normal_force", "friction_force", "kinetic", "potential", "friction", "vy", "slip"):
        assert getattr(after, name) == pytest.approx(getattr(same, name), abs=1e-9)
    if until.partition(":")[0] in ("landings", "takeoff"):
        assert before.mode != after.mode
    left = min(1.0, whole.duration - motion.duration)
    for state in (after, before, end):
        onward = hh.simulate(goes_on.with_values({"start": hh.Start.of(state), "duration": left}))
        assert onward.at(left).angle == pytest.approx(whole.at(motion.duration + left).angle, abs=1e-10)
        assert (onward.at(np.linspace(0.0, left, 200)).normal_force >= 0.0).all()
