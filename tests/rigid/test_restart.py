"""Motions that go on from a state of another one, compared with the one that was not interrupted."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from random_scenarios import draw, scenario_of

HOPS = hh.Scenario(hoop=hh.Hoop.ideal(0.5), plane=hh.Plane(slope=math.radians(3.0)), duration=20.0)
CUTS = 150
AT_ONCE = 1e-7  # √(R/g): events so soon after a cut may come before or after it
ACCUMULATED = 1e-5  # √(R/g): before a bounce limit; how many bounces there are depends on the time since the start
ROUNDED, CHANGE = 1e-11, 1e-10
SPREAD = 0.1  # of the effect of a change of CHANGE: that of the rounding of a state and its time
FAR = 1e-5  # larger effects are not proportional to the change
STATE = ("x", "height", "angle", "omega", "slip", "vy")


def time_left(motion, state):
    """The time to the end of a motion, and some more where it did not end by time [s]."""
    return motion.duration - float(state.t) + (0.0 if motion.status == "completed" else motion.units.time)


def onward(motion, state, duration=None):
    """The motion that goes on from a state, to the same end."""
    left = time_left(motion, state) if duration is None else duration
    return hh.simulate(motion.scenario.with_values({"start": hh.Start.of(state), "duration": left}))


def beside(motion, state):
    """The motion that goes on from a state with a small change of all that is free in its mode."""
    start, unit, radius = hh.Start.of(state), motion.units, motion.scenario.hoop.radius
    turning, along = CHANGE * unit.of("omega"), {"R": 0.0, "S": -CHANGE}.get(start.mode, CHANGE) * unit.of("slip")
    changed = {
        "angle": start.angle + CHANGE,
        "omega": start.omega + turning,
        "slip": start.slip + along,
        "vx": start.vx + radius * turning + along,
        "vy": start.vy + (CHANGE * unit.of("vy") if start.mode == "H" else 0.0),
    }
    scenario = motion.scenario.with_values({"start": start, "duration": time_left(motion, state)})
    return hh.simulate(scenario.model_copy(update={"start": start.model_copy(update=changed)}))


def later_events(motion, since):
    """(kind, mode, time, state) after a time, in kernel units, without apices and the bounces just before a bounce limit."""
    events = motion.tables["events"]
    names = [record.kind for record in motion.events]
    limits = [float(t) for t, name in zip(events["t"], names, strict=True) if name == "bounce_limit"]
    found = []
    for row, name in zip(events, names, strict=True):
        t = float(row["t"])
        # the apex is the highest one of a flight since its start
        left_out = name == "apex" or (name == "impact" and any(0.0 <= limit - t < ACCUMULATED for limit in limits))
        if t > since + AT_ONCE and not left_out:
            # N grows without bound towards a paradox or a jam, so that the velocities there belong to no exact time
            state = STATE if name not in ("painleve_inconsistent", "jam") else STATE[:3]
            found.append((name, int(row["after_mode"]), [t - since, *(float(row[each]) for each in state)]))
    return found


def compare(motion, state):
    """Assert that a motion goes on from a state as it was; return the one that goes on and how many events were compared.

    Rounding of the state grows like a small change of it. Bounces are closed within a time relative to the time so far; what is
    left of their impulses turns a light ring.
    """
    unit = motion.units.time
    again = onward(motion, state)
    wanted, found = later_events(motion, float(state.t) / unit), later_events(again, 0.0)
    near = later_events(beside(motion, state), 0.0)
    compared = 0
    closed = False
    for one, other, changed in zip(wanted, found, near, strict=False):
        spread = max(abs(b - c) for b, c in zip(other[2], changed[2], strict=False))
        if one[:2] != changed[:2] or spread > FAR:
            break  # the smallest change leads elsewhere
        closed |= one[0] == "bounce_limit"
        assert one[:2] == other[:2]
        for a, b, c in zip(one[2], other[2], changed[2], strict=True):
            late = (1.0 + motion.duration / unit) / motion.scenario.hoop.inertia_ratio if closed else 1.0
            assert abs(a - b) <= ROUNDED * late * (1.0 + abs(a)) + SPREAD * abs(c - b), (one, other)
        compared += 1
    return again, compared


@pytest.mark.compiled
def test_random_cuts_and_their_second_generation():
    """150 cuts, at a random time or event, from the left or the right; half of them are cut again."""
    compared = cuts = 0
    index = 0
    while cuts < CUTS:
        scenario = scenario_of(draw(36, index)[1], 400)
        motion = hh.simulate(scenario.replace("duration", 3.0 * scenario.duration))
        random = np.random.default_rng([36, index])
        index += 1
        if motion.status == "event_limit" or motion.doubt < math.inf or motion.duration == 0.0:
            continue
        for generation in range(2):
            state = random_state(motion, random)
            if state.mode_letter == "M" or state.record.t > 0.9 * motion.duration:
                break
            again, events = compare(motion, state.record)
            compared += events
            cuts += generation == 0
            if again.status == "event_limit" or again.duration == 0.0:
                break
            motion = again
    assert compared > 3 * CUTS


class random_state:
    """A state of a motion: an event, or a sample at a random time or at an event, from either side."""

    def __init__(self, motion, random):
        event = motion.events[int(random.integers(len(motion.events)))]
        which = int(random.integers(4))
        if which == 0:
            self.record, self.mode_letter = event, event.to_mode
        else:
            t = event.t if which < 3 else float(random.random()) * motion.duration
            self.record = motion.at(t, "left" if which == 1 else "right")
            self.mode_letter = self.record.mode


@pytest.mark.parametrize("speed", [1.0, 3.1])
@pytest.mark.parametrize("cut", [0.2, 0.3, 1.1])
def test_motions_that_have_ended_go_on(speed, cut):
    """From its last event, and from a sample at its end."""
    whole = hh.simulate(hh.Scenario(start=hh.Start.rolling(speed), duration=3.0))
    first = hh.simulate(whole.scenario.replace("duration", cut))
    for state in (first.events[-1], first.at(cut), first.at(cut, "left")):
        again = onward(first, state, 3.0 - cut)
        assert again.duration == 3.0 - cut
        assert again.events[-1].angle == pytest.approx(whole.events[-1].angle, abs=1e-11)
        late = [event.kind for event in whole.events if event.t > cut]
        assert [event.kind for event in again.events][1:] == late


@pytest.mark.parametrize("restitution", [0.4, 0.8])
def test_bounces_that_end_go_on(restitution):
    """Time and state of the limit agree; the number of bounces before it may not."""
    motion = hh.simulate(
        hh.Scenario(start=hh.Start(height=0.3, vx=1.0, angle=0.4), duration=3.0).replace("plane.restitution", restitution)
    )
    (limit, *_) = motion.find("bounce_limit")
    landings = [e for e in motion.find("impact") if e.t < limit.t]
    for state in (landings[-1], landings[-2], motion.at(0.5 * (landings[-1].t + landings[-2].t)), landings[0]):
        again = onward(motion, state)
        found = again.find("bounce_limit")[0]
        assert found.t + state.t == pytest.approx(limit.t, rel=1e-11)
        for name in ("x", "angle", "omega", "slip"):
            assert getattr(found, name) == pytest.approx(getattr(limit, name), rel=1e-11)


def test_slip_that_has_just_begun_stays_slip():
    """From the state alone, v_t = 0 would roll on: the mode is part of it."""
    motion = hh.simulate(hh.Scenario(duration=2.0))
    (begins, *_) = motion.find("slip_start")
    assert begins.slip == 0.0
    again = onward(motion, begins)
    assert again.sequence == motion.sequence[1:]
    assert again.events[-1].angle == pytest.approx(motion.events[-1].angle, abs=1e-12)
    exact = hh.simulate(again.scenario, digits=20)
    assert exact.sequence == again.sequence
    assert float(exact.events[-1].angle) == pytest.approx(again.events[-1].angle, abs=1e-11)


def test_the_left_side_of_a_take_off_is_no_doubt():
    """N is zero there within rounding, and the mode says that slip ends."""
    motion = hh.simulate(hh.Scenario(duration=2.0))
    (takeoff,) = motion.find("takeoff")
    again = onward(motion, motion.at(takeoff.t, "left"))
    assert again.doubt == math.inf
    assert again.sequence == "HR"
    assert again.events[-1].angle == pytest.approx(motion.events[-1].angle, abs=1e-12)


def test_slip_below_the_static_limit_goes_on():
    """With μs > μk both rolling and slip are possible without slip velocity: the mode tells."""
    plane = hh.Plane(mu_static=1.0, mu_kinetic=0.05, slope=0.3)
    state = {"x": 0.0, "height": 0.0, "angle": 2.0, "vx": 0.0, "vy": 0.0, "omega": 0.0, "slip": 0.0}
    slips = hh.simulate(hh.Scenario(plane=plane, start=hh.Start(**state, mode="S"), duration=0.1))
    rolls = hh.simulate(hh.Scenario(plane=plane, start=hh.Start(**state, mode="R"), duration=0.1))
    assert (slips.sequence, rolls.sequence) == ("S", "R")
    assert rolls.events[-1].angle == hh.simulate(rolls.scenario.replace("start.vx", 0.0)).events[-1].angle


def test_a_load_that_slides_on_the_plane_goes_on():
    """The massless hoop after the strike of its load."""
    motion = hh.simulate(hh.Hoop.ideal(1.0), hh.Plane(mu=0.3), hh.Start.rolling(1.0), duration=3.0)
    (strike,) = motion.find("impact")
    assert strike.to_mode in "SK"
    again = onward(motion, motion.at(0.5 * (strike.t + motion.duration)))
    assert again.events[-1].x == pytest.approx(motion.events[-1].x, abs=1e-12)
    assert again.status == motion.status


def test_other_parameters_start_from_the_state():
    """On another plane the motion goes on from the state, and a start with another velocity has no mode."""
    motion = hh.simulate(HOPS)
    start = hh.Start.of(motion.at(7.3))
    other = HOPS.with_values({"start": start, "plane.mu": 0.5, "duration": 3.0})
    free = {name: getattr(start, name) for name in ("x", "height", "angle", "vx", "vy", "omega")}
    same = hh.simulate(other.with_values({"start": hh.Start(**free)}))
    assert hh.simulate(other).sequence == same.sequence
    assert hh.simulate(other).events[-1].angle == pytest.approx(same.events[-1].angle, abs=1e-10)
    moved = other.replace("start.omega", 3.0).start
    assert (moved.slip, moved.mode) == (None, None)


def test_files_and_links():
    """All numbers survive, and a start without slip and mode is written without them."""
    scenario = HOPS.replace("start", hh.Start.of(hh.simulate(HOPS).at(7.3)))
    fingerprint = hh.simulate(scenario).fingerprint
    for again in (
        hh.Scenario.loads(scenario.to_toml()),
        hh.Scenario.from_dict(scenario.to_dict()),
        hh.Scenario.from_query(scenario.to_query()),
    ):
        assert again == scenario
        assert hh.simulate(again).fingerprint == fingerprint
    assert set(HOPS.to_dict()["start"]) == {"x", "angle", "speed"}
    assert set(hh.Start(vx=1.0).to_dict()) == {"x", "height", "angle", "vx", "vy", "omega"}


def test_derivatives_of_a_motion_that_goes_on():
    """They agree with those from the plain state."""
    state = hh.simulate(HOPS).at(7.3)
    exact = hh.simulate(HOPS.with_values({"start": hh.Start.of(state), "duration": 2.0}))
    free = {name: getattr(state, name) for name in ("x", "height", "angle", "vx", "vy", "omega")}
    plain = hh.simulate(exact.scenario.replace("start", hh.Start(**free)))
    for of in ("end.angle", "impact.omega"):
        wanted, found = (each.sensitivity(of, ["start.omega", "plane.mu"]).derivatives for each in (plain, exact))
        np.testing.assert_allclose(found, wanted, rtol=1e-9)


def test_bad_starts():
    """One sentence each."""
    motion = hh.simulate(HOPS)
    with pytest.raises(ValueError, match=r"single t\.$"):
        hh.Start.of(motion.at([0.1, 0.2]))
    with pytest.raises(ValueError, match=r"^start\.mode = 'S' needs start\.slip"):
        hh.Start(mode="S")
    with pytest.raises(ValueError, match=r"^start\.slip = 1\.0 must be at most 0 with start\.mode = 'S'\.$"):
        hh.Start(mode="S", slip=1.0)
    with pytest.raises(ValueError, match=r"needs start\.height = 0"):
        hh.Start(mode="R", slip=0.0, height=0.1)
    with pytest.raises(ValueError, match="cannot be given together"):
        hh.Start(speed=1.0, slip=0.0)
    with pytest.raises(ValueError, match=r"^start\.slip = 2\.0 must be start\.vx - hoop\.radius start\.omega = 1\.0 within"):
        HOPS.replace("start", hh.Start(vx=1.0, slip=2.0))


@pytest.mark.parametrize(
    ("mode", "omega", "slip", "why"),
    [
        ("H", 1.0, 0.0, "without contact the rim would enter the plane"),
        ("S", 9.0, -1.0, "the plane would have to pull"),
        ("R", 9.0, 0.0, "the plane would have to pull"),
        ("R", 1.0, 0.0, "rolling needs more friction than there is"),
    ],
)
def test_a_mode_that_cannot_hold_is_refused(mode, omega, slip, why):
    """N, F and f_n are against it, by more than rounding."""
    start = hh.Start(angle=0.3, omega=omega, vx=omega + slip, slip=slip, mode=mode)
    with pytest.raises(ValueError, match=rf"^start\.mode = '{mode}' cannot hold: {why}\.$"):
        hh.Scenario(plane=hh.Plane(mu=0.1), start=start)
    assert hh.simulate(hh.Scenario(plane=hh.Plane(mu=0.1), start=start.model_copy(update={"mode": None})))


def test_compliant_state_is_a_free_start():
    """A compliant motion goes on from positions and velocities."""
    motion = hh.simulate(HOPS.with_values({"contact.model": "compliant", "duration": 0.5}))
    assert hh.Start.of(motion.at(0.3)).mode is None
