"""Ties that double precision cannot tell: the side that the given doubles, taken as exact numbers, have.

The truth is a motion in 20 digits (`hophoop.precise`, itself tested against another one).
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp, mpf

import hophoop as hh
from hophoop.maps import points
from hophoop.scenario import Scenario
from hophoop.simulation import exact_start as arbitration


def scenario(speed, mu=1.0, gamma=0.75, duration=3.0, **plane):
    return Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(mu=mu, **plane), start=hh.Start.rolling(speed), duration=duration)


def agree(case):
    """The kernel's motion, once it has the events of the one in 20 digits."""
    motion, truth = hh.simulate(case), hh.simulate(case, digits=20)
    assert motion.status == truth.status
    assert motion.sequence == truth.sequence
    assert [event.kind for event in motion.events] == [event.kind for event in truth.events]
    for ours, true in zip(motion.events, truth.events, strict=True):
        assert ours.t == pytest.approx(float(true.t), rel=1e-12, abs=1e-13)
        assert ours.angle == pytest.approx(float(true.angle), rel=1e-12, abs=1e-11)
    assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range
    return motion


def test_just_below_the_immediate_hop():
    """The article's own hoop; it ended undetermined at t = 0."""
    motion = agree(scenario(3.6166282640049716))
    assert motion.sequence.startswith("RKRSH")
    assert 0.0 < motion.events[1].t < 1e-12


def test_the_doubles_around_the_immediate_hop():
    """√(gR/γ) with γ v0² = g R exactly: below it rolls first, at it N = 0 keeps it down by its second derivative."""
    plane = {"gravity": 3.0}
    for speed, first in ((math.nextafter(2.0, 0.0), "R"), (2.0, "K"), (math.nextafter(2.0, 9.0), "H")):
        motion = agree(scenario(speed, duration=1.0, **plane))
        assert motion.sequence[0] == first, speed


def test_the_border_of_sticking():
    """It ended undetermined at 1.678 s; the truth sticks for 2e-13 s there."""
    motion = agree(scenario(1.0421218631155353, mu=0.2511102238185704))
    assert motion.sequence.startswith("RSRKRSRKR")


def test_the_slope_where_a_nearly_massless_ring_starts_at_the_limit_of_friction():
    """One of the three of a million motions that were undetermined; more digits until the tie is over."""
    hoop = hh.Hoop(radius=0.15208666450676422, eccentricity=0.9999996776578876, inertia_ratio=2.533135274746937e-6)
    plane = hh.Plane(mu=0.25835497867717905, slope=-0.23898338276734932)
    start = hh.Start.rolling(-0.38972433046605987, angle=-0.5056541081270356)
    motion = hh.simulate(hoop, plane, start, duration=0.05)
    truth = hh.simulate(hoop, plane, start, duration=0.05, digits=20)
    assert (motion.status, motion.sequence) == ("completed", truth.sequence)
    assert hh.simulate(hoop, plane, start, duration=3.0).status == "completed"


def test_grazing_friction_is_not_sticking():
    """The friction needed is 6.1e-13 below what is there (40 digits): it rolls. A slip of 2e-7 s was given, R K R."""
    mu, speed = 0.386061279296875, 0.30991464919018996
    assert agree(scenario(speed, mu=mu, duration=6.0)).sequence == "R"
    with mp.workdps(40):
        g, v0 = mpf("0.75"), mpf(speed)

        def needed(th):
            u = (g * mpf(9.81) * (1 - mp.cos(th)) + v0**2 * (1 + g)) / (1 + g * mp.cos(th))
            alpha = g * mp.sin(th) * (u + mpf(9.81)) / (2 * (1 + g * mp.cos(th)))
            friction = alpha * (1 + g * mp.cos(th)) - g * mp.sin(th) * u
            return friction / (mpf(9.81) - g * mp.sin(th) * alpha - g * mp.cos(th) * u)

        worst = mp.findroot(lambda th: mp.diff(needed, th), mpf("2.19"))
        assert -7e-13 < abs(needed(worst)) - mpf(mu) < -6e-13
    # the same amount above it slips, in two minute phases to each side of the turn's bottom
    slips = agree(scenario(speed, mu=mu - 1.3e-12, duration=6.0)).sequence
    assert slips[:2] == "RK"


def friction_ratio(th, speed):
    """F/N of the ideal hoop γ = 3/4 that rolls with the speed at the top."""
    g = mpf("0.75")
    u = (g * mpf(9.81) * (1 - mp.cos(th)) + speed**2 * (1 + g)) / (1 + g * mp.cos(th))
    alpha = g * mp.sin(th) * (u + mpf(9.81)) / (2 * (1 + g * mp.cos(th)))
    friction = alpha * (1 + g * mp.cos(th)) - g * mp.sin(th) * u
    return friction / (mpf(9.81) - g * mp.sin(th) * alpha - g * mp.cos(th) * u)


@pytest.mark.parametrize("mu", [0.4, *(pytest.param(mu, marks=pytest.mark.long) for mu in (0.5, 0.9))])
def test_the_neighbours_of_the_first_slip(mu):
    """The doubles to both sides of the critical speed, known to 40 digits: pure rolling below, a minute slip above.

    `first_slip_speed` itself has some roundings of F/N, times the condition of the speed, d ln v / d ln μ: 8.6 at μ = 0.4, 1.8
    at 0.5, 0.55 at 0.9. So its neighbours say nothing.
    """
    speed = float(hh.theory.first_slip_speed(hh.Hoop.ideal(0.75), hh.Plane(mu=mu)))
    most = max(np.linspace(0.0, 2.0 * math.pi, 629), key=lambda th: abs(friction_ratio(mpf(th), mpf(speed))))
    with mp.workdps(40):
        side = mp.sign(friction_ratio(mpf(most), mpf(speed)))

        def conditions(th, v):
            return side * friction_ratio(th, v) - mpf(mu), mp.diff(lambda one: friction_ratio(one, v), th)

        th, critical = mp.findroot(conditions, (mpf(most), mpf(speed)))
        condition = mpf(mu) / critical / mp.diff(lambda v: side * friction_ratio(th, v), critical)
        assert abs(speed / critical - 1) <= 16 * mpf(2) ** -53 * max(condition, 1)
        below = float(critical) if mpf(float(critical)) < critical else math.nextafter(float(critical), 0.0)
    for k in (-3, 0, 1, 4):
        motion = agree(scenario(below + k * np.spacing(below), mu=mu, duration=2.0))
        assert motion.sequence[:2] == ("R" if k <= 0 else "RK")


def test_a_script_holds_the_same_motion():
    """Repeating the first events, as for a decision, gives the motion that is computed without, and its samples."""
    case = scenario(3.1)
    plain = hh.simulate(case)
    budget = arbitration.Budget(arbitration.steps_allowed(case))
    script = arbitration.script_until(case, 2.0, budget)
    assert 0 < budget.steps < arbitration.ALL_STEPS
    assert len(script) > 3
    truth = hh.simulate(case, digits=20)
    for row, event in zip(script[:-1], truth.events, strict=False):
        assert row["t"] * plain.units.time == pytest.approx(float(event.t), rel=1e-15)


def test_cells_of_a_map_are_decided_too():
    speeds = [3.6166282640049716, 3.1, 2.8]
    assert points(None, {"start.speed": speeds})["sequence"].tolist() == ["RKRSH", "RKRSH", "RKRSR"]
    found = points(None, {"plane.mu": 0.2511102238185704, "start.speed": [1.0421218631155353]}, span="duration")
    assert found["sequence"][0].startswith("RSRKRSRKR")


def test_no_decision_without_need(monkeypatch):
    """Ordinary motions, also frictionless and massless ones, never ask for more digits."""

    def refuse(*_):
        raise AssertionError("asked")

    monkeypatch.setattr("hophoop.simulation.exact_start.script_until", refuse)
    for speed in (0.0, 0.1, 2.0, 2.8, 3.1, 4.0):
        hh.simulate(scenario(speed))
        hh.simulate(scenario(speed, mu=0.3))
        hh.simulate(scenario(speed, mu=0.0))
        hh.simulate(scenario(speed, gamma=1.0))
        hh.simulate(scenario(speed, slope=0.2))
    hh.simulate(hh.Hoop.ideal(0.0), hh.Plane(), hh.Start.rolling(1.0))


@pytest.mark.parametrize(("count", "least"), [(4, 20), pytest.param(30, 200, marks=pytest.mark.long)])
def test_estimated_errors_are_those_that_occur(count, least):
    """Against 20 digits: at most ten times the estimate in 98 of 100, and not far below it as a rule."""
    from oracle_program import simulate
    from rigid.test_oracle_random import draw

    shares = []
    for seed in range(1100, 1100 + count):
        motion = simulate(draw(seed))
        truth = hh.simulate(motion.scenario, digits=20)
        if len(truth.events) != len(motion.events):
            continue
        errors = motion.errors
        for i in range(1, len(motion.events) - 1):
            for name in ("t", "angle", "omega"):
                true = getattr(truth.events[i], name)
                error = abs(float(true - type(true)(getattr(motion.events[i], name))))
                shares.append(error / getattr(errors, name)[i])
    shares = np.array(shares)
    assert len(shares) > least
    assert np.mean(shares <= 10.0) >= 0.98
    assert 0.01 < np.median(shares) < 3.0


def test_errors_of_a_compliant_contact_are_refused():
    motion = hh.simulate(scenario(2.0, duration=0.1).replace("contact", hh.Compliant()))
    with pytest.raises(ValueError, match="rigid contact"):
        _ = motion.errors
