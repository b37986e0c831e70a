"""Motions that go on from a state of another one, compared with the one that was not interrupted, to the last bit."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.lib.recfunctions import repack_fields

import hophoop as hh
from hophoop.kernel.numerics.double_double import add
from random_scenarios import draw, scenario_of

HOPS = hh.Scenario(hoop=hh.Hoop.ideal(0.5), plane=hh.Plane(slope=math.radians(3.0)), duration=20.0)
STATE = ("x", "height", "angle", "vx", "vy", "omega", "slip")
ACCUMULATED = ("friction", "impact_normal", "impact_tangential", "rolling_resistance")


def onward(motion, state, duration=None):
    """The motion that goes on from a state, to the same end."""
    left = motion.duration - float(state.t) if duration is None else duration
    return hh.simulate(motion.scenario.with_values({"start": hh.Start.of(state), "duration": left}))


def same_onward(motion, again, share=0.5):
    """Assert that the events of `again`, up to a share of its time, are events of `motion`; return how many."""
    begin = again.scenario.start.exact
    old, new = motion.tables["events"], again.tables["events"]
    old = old[old["t"] >= begin[-3]]
    new = new[1:-1][new["t"][1:-1] <= share * new["t"][-1]]  # panels are fitted to the end of time
    if not len(new):
        return 0
    whole, part = _untimed(old), _untimed(new)
    first = [row.tobytes() for row in whole].index(part[0].tobytes())
    old = old[first : first + len(new)]
    assert whole[first : first + len(new)].tobytes() == part.tobytes()
    t, t_low = add((old["t"], old["t_low"]), (-begin[-3], -begin[-2]))
    np.testing.assert_array_equal(new["t"], t)
    np.testing.assert_allclose(new["t_low"], t_low, rtol=0, atol=1e-25)
    for name in ACCUMULATED:
        unit = max(abs(motion.tables["events"][name][-1]), 1e-300)
        lost = old[name] - new[name]
        np.testing.assert_allclose(lost, lost[0], rtol=0, atol=1e-14 * unit)
    return len(new)


def _untimed(table):
    """All columns but those that count from the start, without gaps between them."""
    return repack_fields(table[[name for name in table.dtype.names if name not in ("t", "t_low", *ACCUMULATED)]])


def test_random_motions_go_on_with_the_same_bits():
    """200 random motions, each from a random time and from a random event."""
    compared = phases = 0
    for index in range(200):
        scenario = scenario_of(draw(36, index)[1], 400)
        scenario = scenario.replace("duration", 3.0 * scenario.duration)
        motion = hh.simulate(scenario)
        if motion.status == "event_limit" or not motion.ok or motion.doubt < math.inf or scenario.hoop.massless:
            continue
        random = np.random.default_rng([36, index])
        event = motion.events[int(random.integers(len(motion.events) - 1))]
        for state in (motion.at(float(random.random()) * 0.5 * motion.duration), event):
            if state.t > 0.8 * motion.duration:
                continue
            again = onward(motion, state)
            assert again.status == motion.status
            if getattr(state, "kind", "").startswith("painleve"):  # the paradox is met anew
                continue
            compared += same_onward(motion, again)
            phases += 1
            assert abs(again.ledger.residual) <= 1e-9 * again.ledger.range
            begin, sample = again.events[0], again.at(0.0)
            assert [getattr(begin, name) for name in STATE] == [getattr(state, name) for name in STATE]
            for name in STATE if again.events[1].t > 0.0 else ():
                assert getattr(sample, name) == pytest.approx(getattr(state, name), rel=1e-13, abs=1e-13)
    assert phases > 200
    assert compared > 1000


def test_the_sequence_of_restarts():
    """A motion restarted at each landing, and in the middle of phases, ends as the one that goes on."""
    motion = hh.simulate(HOPS)
    done, state = 0.0, motion.at(0.7)
    for step in (0.9, 0.05, 0.01, 1.3, 1.1, 2.0, 0.3):
        done += state.t
        again = onward(motion, state, motion.duration - done)
        state = again.at(step)
        again.sequence.index("H")
    whole = motion.at(done + step)
    for name in ("x", "angle", "omega", "slip", "height"):
        assert getattr(state, name) == pytest.approx(getattr(whole, name), abs=1e-12)
    last = onward(motion, state, motion.duration - done - step)
    old, new = motion.tables["events"], last.tables["events"]
    for name in ("x", "x_low", "theta", "theta_low", "omega", "slip", "vy", "height"):
        assert new[name][1:-1].tobytes() == old[name][-len(new) + 1 : -1].tobytes()


@pytest.mark.parametrize("restitution", [0.4, 0.8])
def test_bounces_that_end_go_on(restitution):
    """v_n after the last landing decides where bounces are closed."""
    motion = hh.simulate(
        hh.Scenario(start=hh.Start(height=0.3, vx=1.0, angle=0.4), duration=3.0).replace("plane.restitution", restitution)
    )
    (limit, *_) = motion.find("bounce_limit")
    landings = [e for e in motion.find("impact") if e.t < limit.t]
    for state in (landings[-1], landings[-2], motion.at(0.5 * (landings[-1].t + landings[-2].t))):
        again = onward(motion, state)
        assert same_onward(motion, again) > 0
        assert len(again.find("bounce_limit")) == len(motion.find("bounce_limit"))


def test_slip_that_has_just_begun_stays_slip():
    """From the state alone, v_t = 0 would roll on: the mode is part of it."""
    motion = hh.simulate(hh.Scenario(duration=2.0))
    (begins, *_) = motion.find("slip_start")
    assert begins.slip == 0.0
    again = onward(motion, begins)
    assert again.sequence == motion.sequence[1:]
    plain = hh.Start.of(begins).model_copy(update={"exact": None})
    assert plain.mode == "K"
    held = hh.simulate(motion.scenario.with_values({"start": plain, "duration": 2.0 - begins.t}))
    assert held.sequence == again.sequence
    assert held.events[-1].angle == pytest.approx(again.events[-1].angle, abs=1e-12)
    exact = hh.simulate(held.scenario, digits=20)
    assert exact.sequence == held.sequence
    assert float(exact.events[-1].angle) == pytest.approx(held.events[-1].angle, abs=1e-11)


def test_other_parameters_start_from_the_state():
    """On another plane the phase before does not lead to the state, which then counts alone."""
    motion = hh.simulate(HOPS)
    start = hh.Start.of(motion.at(7.3))
    other = HOPS.with_values({"start": start, "plane.mu": 0.5, "duration": 3.0})
    free = {name: getattr(start, name) for name in ("x", "height", "angle", "vx", "vy", "omega")}
    same = hh.simulate(other.with_values({"start": hh.Start(**free)}))
    assert hh.simulate(other).sequence == same.sequence
    assert hh.simulate(other).events[-1].angle == pytest.approx(same.events[-1].angle, abs=1e-10)
    moved = other.replace("start.omega", 3.0).start
    assert (moved.slip, moved.mode, moved.exact) == (None, None, None)


def test_files_and_links():
    """All numbers survive, and a start without them is written as before."""
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


def test_saved_and_loaded(tmp_path):
    motion = onward(hh.simulate(HOPS), hh.simulate(HOPS).at(7.3))
    motion.save(tmp_path / "onward.nc")
    again = hh.load(tmp_path / "onward.nc")
    assert again.fingerprint == motion.fingerprint
    assert again.at(1.0) == motion.at(1.0)


def test_until_and_derivatives_of_a_motion_that_goes_on():
    """`until` counts from the new start; derivatives agree with those from the plain state."""
    motion = hh.simulate(HOPS)
    state = motion.at(7.3)
    scenario = HOPS.replace("start", hh.Start.of(state))
    brief = hh.simulate(scenario, until="revolutions:1")
    assert brief.events[-1].angle == pytest.approx(state.angle + 2 * math.pi, abs=1e-13)
    free = {name: getattr(state, name) for name in ("x", "height", "angle", "vx", "vy", "omega")}
    plain = hh.simulate(HOPS.with_values({"start": hh.Start(**free), "duration": 2.0}))
    exact = hh.simulate(scenario.replace("duration", 2.0))
    for of in ("end.angle", "impact.omega"):
        wanted = plain.sensitivity(of, ["start.omega", "plane.mu"]).derivatives
        np.testing.assert_allclose(exact.sensitivity(of, ["start.omega", "plane.mu"]).derivatives, wanted, rtol=1e-9)


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
    with pytest.raises(ValueError, match=r"^start\.exact needs start\.mode"):
        hh.Start(exact=(0.0,) * len(hh.Start.of(motion.at(1.0)).exact))
    with pytest.raises(ValueError, match="cannot be given together"):
        hh.Start(speed=1.0, slip=0.0)
    with pytest.raises(ValueError, match=r"^start\.slip = 2\.0 must be start\.vx - hoop\.radius start\.omega = 1\.0 within"):
        HOPS.replace("start", hh.Start(vx=1.0, slip=2.0))


def test_compliant_state_is_a_free_start():
    """A compliant motion goes on from positions and velocities."""
    motion = hh.simulate(HOPS.with_values({"contact.model": "compliant", "duration": 0.5}))
    start = hh.Start.of(motion.at(0.3))
    assert (start.mode, start.exact) == (None, None)
