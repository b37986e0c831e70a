"""Beside equilibria: what a phase conserves is carried with all its digits."""

import math

import numpy as np
import pytest
from mpmath import mp, mpf

import hophoop as hh
from hophoop.kernel.numerics import arithmetic


def moved(link, until, events=3):
    """The motion of a link, for 1000 s or so many events."""
    return hh.simulate(hh.Scenario.from_query(f"duration=1000&contact.max_events={events}&{link}"), until=until)


@pytest.mark.parametrize(
    ("link", "until", "t", "angle", "omega"),
    [
        # over the top; once 8e-8 off at 1e-4, 1.5 s at 1e-8, and a reversal that cannot be at 1e-9
        ("start.speed=0.1", "revolutions:2", 11.639595922337611, 4.0 * math.pi, 1e-1),
        ("start.speed=1e-4", "revolutions:2", 30.696941845546221, 4.0 * math.pi, 1e-4),
        ("start.speed=1e-9", "revolutions:2", 62.459434027569543, 4.0 * math.pi, 1e-9),
        ("start.speed=1e-100", "revolutions:2", 640.53679172837818, 4.0 * math.pi, 1e-100),
        # from rest just short of it, to the second turning point; 5e-15 was frozen
        ("start.angle=0.1", None, 10.615336254380260, 1e-1, 0.0),
        ("start.angle=1e-6", None, 42.377083074359027, 1e-6, 0.0),
        ("start.angle=5e-15", None, 95.109363141266243, 5e-15, 0.0),
        ("start.angle=1e-100", None, 639.51193608398517, 1e-100, 0.0),
        # without friction; the first came 1.49 s late, the third 43 % off in θ
        ("plane.mu=0&start.angle=1e-14", "angle:1.5", 8.2501053255668616, 1.5, 3.703066024102005),
        ("plane.mu=0&start.angle=1e-3", "angle:1.5", 2.0737507357992987, 1.5, 3.7030650278643904),
        (
            "hoop.load_fraction=0.1482093344156866&plane.mu=0&start.angle=-1e-12",
            "angle:-1.5", 23.610430931433246, -1.5, -1.6439190344730148,
        ),
        ("hoop.load_fraction=0.5&plane.mu=0&start.angle=1e-80", "angle:1.5", 72.529545720851904, 1.5, 3.021172946059047),
        # pushed uphill from the double nearest to the hilltop of a slope it turns, once round
        (
            "plane.slope=0.3&plane.mu=3&start.angle=-0.7050089020113282&start.speed=-0.01",
            "reversal", 4.8282973683597525, -4.4311338497395564, 0.0,
        ),
        (
            "hoop.load_fraction=0.5&plane.slope=0.1&plane.mu=3&start.angle=-0.3010178957381322&start.speed=-1e-5",
            "reversal", 11.487323140738248, -4.8783577165044825, 0.0,
        ),
        ("plane.slope=-0.2&start.angle=2.5", "reversal", 0.94769234459470939, 3.6172860987408049, 0.0),  # about the valley
        # in slip with friction, 1e-4 rad beside its hilltop
        (
            "plane.mu=0.3&start.angle=0.6845398424750028&start.vx=-9.001&start.omega=-0.001",
            "angle:-0.3153", 2.2267892852048598, -0.3153, -1.8993467827942395,
        ),
    ],
)  # fmt: skip
def test_slow_motions_have_all_their_digits(link, until, t, angle, omega):
    """By quadratures of the closed forms in 50 digits, and by digits=20 on slopes."""
    end = moved(link, until).events[-1]
    assert end.t == pytest.approx(t, rel=2e-15 if end.slip == 0.0 else 1e-13)
    assert (end.angle, end.omega) == pytest.approx((angle, omega), rel=1e-12, abs=0.0)


@pytest.mark.parametrize(
    ("link", "until", "t", "error"),
    [
        # in slip without friction, at the rotation of the start: the rounding of θ̇² at the bottom over that at the top
        ("plane.mu=0&start.vx=1.01&start.omega=0.01", "revolutions:2", 8.6066437672833934, 1e-10),
        ("plane.mu=0&start.vx=0.300000001&start.omega=1e-9", "revolutions:2", 24.328289807052538, math.inf),
        # beside a hilltop that no double is: its rounding over the distance, or over the speed
        ("plane.slope=-0.4&plane.mu=3&start.angle=0.9459432474646534&start.speed=1e-8", "reversal", 13.999903593095212, 1e-10),
        ("plane.mu=0.3&start.angle=-0.6846398414750028&start.vx=90", "angle:0.3153", 5.3145934617802821, 1e-7),
    ],
)
def test_other_slow_motions_lose_digits_or_are_in_doubt(link, until, t, error):
    motion = moved(link, until, events=9)
    assert motion.events[-1].t == pytest.approx(t, abs=error)
    assert bool(motion.doubt < motion.duration) is (error == math.inf)


@pytest.mark.long
def test_the_ledgers_of_long_motions_and_of_slow_slip_on_little_friction():
    """2.8 m/s over 600 s and 1,400 events: it was off by 1.5e-10 J, and by 5.6e-8 J after 6,000 s."""
    motion = hh.simulate(hh.Scenario.from_query("duration=600&start.speed=2.8"))
    assert len(motion.events) > 1400
    assert abs(motion.ledger.residual) < 1e-11
    rng = np.random.default_rng(8)
    for gamma in (0.1, 0.48, 0.75, 0.9) * 10:
        plane = hh.Plane(mu=float(10.0 ** rng.uniform(-6.0, -3.0)))
        start = hh.Start.rolling(float(10.0 ** rng.uniform(-4.0, -1.0)))
        assert abs(hh.simulate(hh.Hoop.ideal(gamma), plane, start, duration=30.0).ledger.residual) < 1e-12, (
            gamma,
            plane,
            start,
        )


def test_two_doubles():
    """The arithmetic of two doubles against 60 digits."""
    random = np.random.default_rng(3)

    def total(high, low):
        return mpf(float(high)) + mpf(float(low))

    with mp.workdps(60):
        for _ in range(120):
            a = (random.uniform(-6, 6), random.uniform(-1e-17, 1e-17))
            b = (random.uniform(0.1, 3), random.uniform(-1e-18, 1e-18))
            one, other = total(*a), total(*b)
            for found, true in (
                (arithmetic.add(a, b), one + other),
                (arithmetic.multiply(a, b), one * other),
                (arithmetic.divide(a, b), one / other),
            ):
                assert abs(total(*found) - true) < 1e-30 * (1 + abs(true))
