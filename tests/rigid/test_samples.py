"""Samples between events: slip without rotation by hand, and where a time falls among segments and on a panel."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.numerics.tables import NODES
from hophoop.kernel.panels.panel import HOLD
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.records.layout import COLUMNS, SEGMENT, new_scratch
from hophoop.kernel.records.writing import find_segment
from hophoop.kernel.rigid.sampling import sample, xi_at_time
from random_scenarios import draw, scenario_of


def test_a_time_at_a_border_is_in_the_segment_before_or_after():
    begins = np.array([0.0, 1.0, 2.0])
    for t, before, after in ((0.0, 0, 0), (0.5, 0, 0), (1.0, 0, 1), (1.5, 1, 1), (2.0, 1, 2), (9.0, 2, 2)):
        assert find_segment(begins, t, True) == before
        assert find_segment(begins, t, False) == after


def test_the_place_of_a_time_on_a_panel():
    """On one that takes 2 and is left at its end or inside; beside the ends the rounding of the series is not asked."""
    for end in (1.0, 0.5):
        segment, scratch = np.zeros(1, SEGMENT)[0], new_scratch()
        segment["xi"] = end
        for tau, place in ((1e-20, -1.0), (-1e-9, -1.0), (0.25, -0.75), (1.25, 0.25), (2.0, end), (2.5, end)):
            assert xi_at_time(1.0 + NODES, segment, tau, scratch) == pytest.approx(place, abs=1e-14)


def body_of(eps, kap, **plane):
    return hh.Scenario(hoop=hh.Hoop(eccentricity=eps, inertia_ratio=kap), plane=hh.Plane(**plane)).to_body()


BEGIN, BEFORE = 2.0**52, 0.25  # a time at which doubles are 1 apart; the segment begins a quarter before it
MOVING = {
    "x": 3.0,
    "revolutions": 2.0,
    "friction": 0.25,
    "impact_normal": 0.5,
    "impact_tangential": 0.75,
    "rolling_resistance": 1.5,
}


def sampled(body, left=False, tau=2.0, **values):
    """A sample of a segment by the names of its columns."""
    segments, out = np.zeros(1, SEGMENT), np.empty((1, len(COLUMNS)))
    segments["t"], segments["t_low"], segments["t_end"] = BEGIN, -BEFORE, BEGIN + tau
    for name, value in values.items():
        segments[name] = value
    sample(body, segments, np.array([BEGIN + tau]), left, out)
    return dict(zip(COLUMNS, out[0].tolist(), strict=True))


@pytest.mark.parametrize(("mode", "sigma", "slip"), [(Mode.SKID, 1, 7.0), (Mode.SPIN, -1, -7.0), (Mode.ROLL, 0, 0.0)])
def test_a_sample_of_a_hoop_that_does_not_turn(mode, sigma, slip):
    """Slip with a constant force, or rest; after some 100 million years and two turns, and some losses."""
    body = body_of(0.5, 0.75, mu=0.5, slope=0.25)
    rate = math.sin(0.25) - sigma * 0.5 * math.cos(0.25) if sigma else 0.0
    found = sampled(body, mode=mode, kind=HOLD, sigma=sigma, slip=slip, theta=0.5, **MOVING)
    tau = 2.0 + BEFORE
    slid = slip * tau + 0.5 * rate * tau**2
    expected = {
        "mode": mode, "x": 3.0 + slid, "height": 0.0, "angle": 4.0 * math.pi + 0.5, "vx": slip + rate * tau, "vy": 0.0,
        "omega": 0.0, "slip": slip + rate * tau, "normal_force": math.cos(0.25),
        "friction_force": -sigma * 0.5 * math.cos(0.25) if sigma else -math.sin(0.25),
        "friction": 0.25 + abs(0.5 * math.cos(0.25) * slid), "impact_normal": 0.5, "impact_tangential": 0.75,
        "theta": 0.5, "theta_low": 0.0, "rolling_resistance": 1.5,
    }  # fmt: skip
    energies = found.pop("kinetic"), found.pop("potential")
    assert found == pytest.approx(expected, rel=1e-15)
    fallen = 0.5 * (math.cos(0.5) - 1.0) * math.cos(0.25) - (3.0 + slid + 0.5 * math.sin(0.5)) * math.sin(0.25)
    assert energies == pytest.approx((0.5 * (slip + rate * tau) ** 2, fallen), rel=1e-13)


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
