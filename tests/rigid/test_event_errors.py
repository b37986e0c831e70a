"""Estimated errors of events where calculus gives them: rounding of each event, times what the motion makes of it."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.native import forced
from hophoop.simulation import event_errors as errors

ROUNDING = 4e-16
RING = hh.Hoop(eccentricity=0.0, inertia_ratio=1.0)  # with radius, mass and gravity 1, all units are 1

SINGULAR = hh.Scenario(  # slip up to p_σ = 0
    hoop=hh.Hoop.ideal(0.9743628639734905),
    plane=hh.Plane(mu=0.9048406257906279),
    start=hh.Start(angle=-1.7728528217331099, vx=10.96322093918777, omega=5.406296354291368),
    duration=0.1,
)


def motion_of(start: hh.Start, duration: float, mu: float = 0.5, slope: float = 0.0, restitution: float = 0.0) -> hh.Trajectory:
    plane = hh.Plane(gravity=1.0, mu=mu, slope=slope, restitution=restitution)
    with forced("interpreted"):
        motion = hh.simulate(RING, plane, start, duration=duration)
        assert motion.errors is not None  # computed here
    return motion


def squares(*parts: float) -> float:
    return ROUNDING * math.sqrt(sum(part * part for part in parts))


def test_rolling_on_the_level():
    """x = ω t: of ω its rounding counts; v_t, v_n and the height are zero by what rolling is, friction has no work."""
    motion = motion_of(hh.Start.rolling(2.0), 3.0)
    assert motion.sequence == "R"
    assert motion.errors.x[-1] == pytest.approx(squares(1.0 + 6.0, 2.0 * 3.0), rel=1e-6, abs=0.0)
    assert motion.errors.omega[-1] == pytest.approx(squares(1.0 + 2.0, 2.0), rel=1e-6, abs=0.0)
    assert motion.errors.angle[-1] == pytest.approx(squares(1.0 + 6.0, 2.0 * 3.0, 1.0), rel=1e-6, abs=0.0)
    assert motion.errors.t[-1] == pytest.approx(squares(1.0 + 3.0), rel=1e-6, abs=0.0)
    assert motion.errors.x[0] == squares(1.0)


def test_a_fall():
    """t = √(2 h), changed by (1 + h)/√(2 h) where the height is by 1 + h; the speed of the fall likewise."""
    motion = motion_of(hh.Start(height=2.0), 3.0)
    assert [event.kind for event in motion.events] == ["start", "impact", "rest", "end"]
    assert motion.errors.t[1] == pytest.approx(squares(1.0 + 2.0, 3.0 / 2.0), rel=1e-6, abs=0.0)
    assert motion.errors.height[1:] == pytest.approx(squares(1.0), rel=1e-6, abs=0.0)


def test_a_throw():
    """t = v + √(v² + 2 h): the rounding of v is that of all speeds; at the apex, where v is 0, the height's counts again."""
    motion = motion_of(hh.Start(height=1.5, vx=3.0, vy=1.0, omega=0.5), 3.5)
    assert [event.kind for event in motion.events[:3]] == ["start", "apex", "impact"]
    speeds = 0.5 + 2.5 + 1.0  # θ̇, v_t and v_n
    assert motion.errors.t[1] == pytest.approx(squares(1.0 + 1.0, speeds), rel=1e-6, abs=0.0)
    by_speed, by_height, at_apex = speeds * (1.0 + 1.0 / 2.0), (1.0 + 1.5) / 2.0, (1.0 + 2.0) / 2.0
    assert motion.errors.t[2] == pytest.approx(squares(1.0 + 3.0, by_speed, by_height, at_apex), rel=1e-6, abs=0.0)


def test_slip_to_an_end():
    """v_t ends at t = v_t/(2 μ): v_t and μ count, and θ̇ by the slip that it makes."""
    motion = motion_of(hh.Start(vx=2.0, omega=0.5), 4.0, mu=0.5)
    assert motion.events[1].kind == "stick"
    slip, stop = 1.5, 1.5
    assert motion.events[1].t == pytest.approx(stop, rel=1e-14)
    assert motion.errors.t[1] == pytest.approx(squares(1.0 + stop, (0.5 + slip) / slip * stop, stop), rel=1e-6, abs=0.0)


def test_an_event_just_before_the_end_is_found_with_the_smaller_change():
    """A rounding of the height that is tried at 1e-8 would land after the end, one of 1e-11 does not."""
    near = motion_of(hh.Start(height=2.0), 2.0 + 1e-9)
    assert near.errors.t[1] == pytest.approx(squares(1.0 + 2.0, 3.0 / 2.0), rel=1e-3, abs=0.0)
    assert np.isfinite(near.errors.x).all()
    nearer = motion_of(hh.Start(height=2.0), 2.0 + 1e-13)
    assert np.isinf(nearer.errors.t[1:]).all()
    assert nearer.errors.t[0] == squares(1.0)


def test_an_event_that_cannot_be_computed_again_leaves_the_others(monkeypatch):
    motion = motion_of(hh.Start(vx=2.0, omega=0.5), 4.0)
    body, events = motion.scenario.to_body(), motion._events
    again = errors._recompute

    def none_at_first(body, row, t_end, room):
        assert room > 2 * len(events)
        return None if row["t"] == 0.0 else again(body, row, t_end, room)

    monkeypatch.setattr(errors, "_recompute", none_at_first)
    with forced("interpreted"):
        table = errors.estimated_errors(body, events, 4.0)
    of_x = errors.FIELDS.index("x")
    assert table[1, of_x] == squares(1.0 + events[1]["x"])
    assert table[2, of_x] == pytest.approx(
        squares(1.0 + events[2]["x"], 1.25 * 2.5), rel=1e-6, abs=0.0
    )  # of θ̇ from the stick on


def test_where_a_changed_motion_has_too_many_events_nothing_is_known_after_the_change(monkeypatch):
    motion = motion_of(hh.Start(vx=2.0, omega=0.5), 4.0)
    body, events = motion.scenario.to_body(), motion._events
    again = errors._recompute

    def none_if_changed(body, row, t_end, room):
        return None if row["omega"] != events[0]["omega"] and row["t"] == 0.0 else again(body, row, t_end, room)

    monkeypatch.setattr(errors, "_recompute", none_if_changed)
    with forced("interpreted"):
        table = errors.estimated_errors(body, events, 4.0)
    assert np.isinf(table[1:]).all()
    assert table[0, errors.FIELDS.index("x")] == squares(1.0)


def test_both_coefficients_of_friction_are_rounded_together(monkeypatch):
    motion = motion_of(hh.Start(vx=2.0, omega=0.5), 4.0)
    body, again, parts = motion.scenario.to_body()._replace(mu_s=0.75), errors._recompute, set()

    def noted(rougher, row, t_end, room):
        parts.add((round(rougher.mu_s / 0.75 - 1.0, 15), round(rougher.mu_k / 0.5 - 1.0, 15)))
        return again(rougher, row, t_end, room)

    monkeypatch.setattr(errors, "_recompute", noted)
    with forced("interpreted"):
        errors.estimated_errors(body, motion._events, 4.0)
    assert parts == {(0.0, 0.0), (1e-8, 1e-8)}


def test_a_swing_comes_later_to_all_its_turning_points():
    """θ at the lowest point of a slow swing is rounded to a part of a turn; over θ̇ that is the time that it is late."""
    with forced("interpreted"):
        hoop, speed = hh.Hoop(eccentricity=0.5, inertia_ratio=1.0), 1e-3
        start = hh.Start.rolling(speed, angle=math.pi)
        motion = hh.simulate(hoop, hh.Plane(gravity=1.0), start, duration=12.0)
        assert [event.kind for event in motion.events] == ["start", "turn", "turn", "end"]
        late = motion.errors.t[1:3]
    assert late == pytest.approx(squares(1.0 / speed), rel=1e-3, abs=0.0)


def test_just_before_an_impulse_at_a_fixed_angle_the_speeds_are_those_of_an_instant_that_is_rounded():
    """N grows without bound as p_σ → 0: the true speeds at the time that the event names, in 17 digits."""
    with forced("interpreted"):
        motion = hh.simulate(SINGULAR)
        events, told = motion.events, motion.errors
    place = [event.kind for event in events].index("painleve_inconsistent")
    assert events[place + 1].kind == "impact"
    right = hh.simulate(SINGULAR.with_values({"duration": events[place].t}), digits=17).events[-1]
    for name in ("vx", "omega"):
        real = abs(float(getattr(right, name)) - getattr(events[place], name))
        assert real > 1e-7
        assert real < 10 * getattr(told, name)[place] < 1e4 * real
        assert getattr(told, name)[place + 1] < 1e-11
