"""Motions that go on from a state of another one, or end before it: compared with the one that was not interrupted."""

import math

import numpy as np
import pytest

import hophoop as hh

TURN = 2.0 * math.pi
FREE = ("x", "height", "angle", "vx", "vy", "omega")


def onward(motion, state, left=None):
    """The motion that goes on from a state, to the same end."""
    left = motion.duration - float(state.t) if left is None else left
    return hh.simulate(motion.scenario.with_values({"start": hh.Start.of(state), "duration": left}))


def next_event(motion, since):
    """(kind, mode after, time from `since`, state) of the next event of a motion, an apex left out.

    N grows without bound towards a paradox or a jam, so that the velocities there belong to no exact time.
    """
    for event in motion.events[1:-1]:
        if event.kind != "apex" and event.t > since + 1e-6:
            names = ("x", "height", "angle") if event.kind in ("painleve_inconsistent", "jam") else FREE
            return event.kind, event.to_mode, event.t - since, *(getattr(event, name) for name in names)
    return None


def check_restart(motion, state):
    """Assert that the next event after a state is that of the whole motion; True if there is one that can be compared."""
    wanted = next_event(motion, float(state.t))
    if motion.doubt < math.inf or wanted is None or "M" in motion.sequence:
        return False
    found = next_event(onward(motion, state, motion.duration), 0.0)
    assert found, wanted
    assert found[:2] == wanted[:2], (wanted, found)
    assert found[2:] == pytest.approx(wanted[2:], rel=1e-8, abs=1e-8), (wanted, found)
    return True


def counted(motion, word):
    """Events of a motion that an event-bound `until` counts, by their public fields."""
    if word == "landings":
        return [e for e in motion.events if e.kind == "bounce_limit" or (e.kind == "impact" and e.collision)]
    if word == "reversal":
        return list(motion.find("turn"))
    passing = ("turn", "apex", "kane_gain", "rest", "end")
    opened = [e for e in motion.events if e.kind not in passing and e.to_mode == "H" and e.height == 0.0 and e.vy >= 0.0]
    return [e for e in opened if e.t > 0.0]


def same_events(brief, long):
    """Assert that the events of a motion, except its END, are the first ones of another."""
    mine, others = (motion.tables["events"] for motion in (brief, long))
    count = len(mine) - 1
    assert mine[:count].tobytes() == others[:count].tobytes()


def check_until(long, until):
    """Assert that the motion that ends so is the first part of another, up to the first event or passage; True if it is met."""
    word, _, number = until.partition(":")
    scenario = long.scenario
    brief = hh.simulate(scenario, until=until)
    same_events(brief, long)
    end, met = brief.events[-1], brief.ending == until
    if word in ("revolutions", "angle"):
        ahead = TURN * float(number) if word == "revolutions" else (float(number) - scenario.start.angle) % TURN or TURN
        back = ahead if word == "revolutions" else TURN - ahead or TURN
        turned = long.at(np.linspace(0.0, brief.duration, 200)[:-1]).angle - scenario.start.angle
        assert -back - 1e-12 < turned.min() <= turned.max() < ahead + 1e-12
        if met:
            off = end.angle - scenario.start.angle - (ahead if end.omega > 0.0 else -back)
            assert abs(off) < 1e-12 * (1.0 + abs(end.angle))
    else:
        events = counted(long, word)
        wanted = events[int(number or 1) - 1] if len(events) >= int(number or 1) else None
        assert met == (wanted is not None and wanted.t < scenario.duration)
        if met:
            assert (end.t, end.x, end.angle, end.omega) == (wanted.t, wanted.x, wanted.angle, wanted.omega)
    assert met or brief.status == long.status
    return met
