"""Ties that double precision cannot tell: a motion says from when, and `digits=` has what the given doubles lead to."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mp, mpf

import hophoop as hh
from hophoop.scenario import Scenario


def scenario(speed, mu=1.0, gamma=0.75, duration=3.0, **plane):
    return Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(mu=mu, **plane), start=hh.Start.rolling(speed), duration=duration)


# Starts within rounding of a border: the speed, the hoop and plane, and the sequence of the given doubles as exact numbers.
TIES = [
    (3.6166282640049716, {}, "RKRSH"),  # just below the immediate hop; it ended undetermined at t = 0
    (math.nextafter(2.0, 0.0), {"gravity": 3.0}, "R"),  # √(gR/γ) with γ v0² = g R exactly: below it it rolls first
    (2.0, {"gravity": 3.0}, "K"),  # at it N = 0 keeps it down by its second derivative
    (math.nextafter(2.0, 9.0), {"gravity": 3.0}, "H"),
    (1.0421218631155353, {"mu": 0.2511102238185704}, "RSRKRSRKR"),  # the border of sticking, for 2e-13 s
    (0.30991464919018996, {"mu": 0.386061279296875}, "R"),  # the required friction is 6.1e-13 below what there is
]


@pytest.mark.parametrize(("speed", "given", "exact"), TIES)
def test_a_tie_is_reported_and_its_digits_are_exact(speed, given, exact):
    """The motion goes on by the written order, and closes its ledger."""
    case = scenario(speed, duration=1.0 if "gravity" in given else 3.0, **given)
    motion, truth = hh.simulate(case), hh.simulate(case, digits=20)
    assert truth.sequence.startswith(exact)
    assert motion.doubt < case.duration
    assert motion.status == "completed"
    assert abs(motion.ledger.residual) <= 1e-12 * motion.ledger.range
    for ours, true in zip(motion.events, truth.events, strict=False):
        if ours.t >= motion.doubt:
            break
        assert ours.kind == true.kind
        assert ours.t == pytest.approx(float(true.t), rel=1e-12, abs=1e-13)


def friction_ratio(th, speed):
    """F/N of the ideal hoop γ = 3/4 that rolls with the speed at the top."""
    g = mpf("0.75")
    u = (g * mpf(9.81) * (1 - mp.cos(th)) + speed**2 * (1 + g)) / (1 + g * mp.cos(th))
    alpha = g * mp.sin(th) * (u + mpf(9.81)) / (2 * (1 + g * mp.cos(th)))
    friction = alpha * (1 + g * mp.cos(th)) - g * mp.sin(th) * u
    return friction / (mpf(9.81) - g * mp.sin(th) * alpha - g * mp.cos(th) * u)


def test_grazing_friction_is_not_sticking():
    """The friction needed is 6.1e-13 below what is there (40 digits): it rolls. A slip of 2e-7 s was given, R K R."""
    mu, speed = 0.386061279296875, 0.30991464919018996
    assert hh.simulate(scenario(speed, mu=mu, duration=6.0), digits=20).sequence == "R"
    with mp.workdps(40):
        worst = mp.findroot(lambda th: mp.diff(lambda one: friction_ratio(one, mpf(speed)), th), mpf("2.19"))
        assert -7e-13 < abs(friction_ratio(worst, mpf(speed))) - mpf(mu) < -6e-13
    # the same amount above it slips, in two minute phases to each side of the turn's bottom
    slips = hh.simulate(scenario(speed, mu=mu - 1.3e-12, duration=6.0), digits=20).sequence
    assert slips[:2] == "RK"


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
        motion = hh.simulate(scenario(below + k * np.spacing(below), mu=mu, duration=2.0), digits=20)
        assert motion.sequence[:2] == ("R" if k <= 0 else "RK")


@pytest.mark.parametrize(("count", "least"), [(4, 20), pytest.param(30, 200, marks=pytest.mark.long)])
def test_estimated_errors_are_those_that_occur(count, least):
    """Against 20 digits: at most ten times the estimate in 98 of 100, and not far below it as a rule."""
    from oracle_program import simulate
    from rigid.test_oracle_random import draw

    shares = []
    for seed in range(1100, 1100 + count):
        motion = simulate(draw(seed))
        truth = hh.simulate(motion.scenario, digits=20)
        errors = motion.errors
        alike = [one.kind == other.kind for one, other in zip(truth.events, motion.events, strict=False)]
        for i in range(1, [*alike, False].index(False) - 1):  # up to the limit of bounces, which digits do not have
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
