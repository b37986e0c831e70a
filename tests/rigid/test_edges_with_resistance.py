"""Beside the edges of where a hoop with rolling resistance can rest, against Taylor series in 34 digits.

Beside an edge the torque is a small difference of ε sin(θ + β) + sin β and f cos β. A time is as exact as the start
is: it is that of a start which is off by no more than twice the last digit of the angle.
"""

from __future__ import annotations

import math

import pytest
from mpmath import mp, mpf

import hophoop as hh
from oracles.resisted_rolling import Rolling, time_to, time_to_stop

pytestmark = pytest.mark.compiled

# γ, f, slope
HOOPS = [(0.75, 0.02, 0.0), (0.5, 0.2, 0.0), (0.6, 0.05, 0.1), (0.75, 1e-6, 0.0)]
OFFSETS = [1e-1, 1e-3, 1e-6, 1e-9, 1e-12]
LONG = 300.0
FAST = [(0.75, 0.02, 0.0, 1e-6), (0.6, 0.05, 0.1, 1e-9)]
GRID = [
    case if (case := (*hoop, offset)) in FAST else pytest.param(*case, marks=pytest.mark.slow)
    for hoop in HOOPS
    for offset in OFFSETS
]
in_all = pytest.mark.parametrize(("gamma", "resistance", "slope", "offset"), GRID)


@pytest.fixture(autouse=True)
def digits():
    with mp.workdps(34):
        yield


def hoop_of(gamma, resistance, slope):
    return Rolling(mpf(gamma), 1 - mpf(gamma) ** 2, mpf(resistance), mpf(slope))


def edge(gamma, resistance, slope, valley=False):
    """Where rolling forwards has no torque: the centre of gravity stands f R before the contact."""
    rise = mp.asin((mpf(resistance) * mp.cos(slope) - mp.sin(slope)) / mpf(gamma))
    return (mp.pi - rise if valley else rise) - mpf(slope)


def program(gamma, resistance, slope, angle, omega):
    plane = hh.Plane(mu=20.0, rolling_resistance=resistance, gravity=1.0, slope=slope)
    start = hh.Start.rolling(omega, angle=angle) if omega else hh.Start(angle=angle)
    return hh.simulate(hh.Hoop.ideal(gamma), plane, start, duration=LONG)


def when(motion, angle):
    """The first time at which it has turned to an angle, by halving."""
    low, high = 0.0, next(event.t for event in motion.events if event.angle >= angle)
    while high - low > 2e-16 * high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if float(motion.at(middle).angle) < angle else (low, middle)
        if middle in (low, high) and high - low <= 4e-16 * high:
            break
    return high


def close(found, truth, of_start, angle):
    """As near to the truth as a start that is off by its last two digits would be."""
    last = 2 * math.ulp(angle)
    moved = []
    for sign in (-1, 1):
        try:
            moved.append(abs(of_start(mpf(angle) + sign * last) - truth))
        except ValueError:  # a start before the hilltop does not get there
            moved.append(mpf(0))
    return abs(mpf(found) - truth) <= max(moved) + mpf("6e-15") * truth


@in_all
def test_passing_the_hilltop_slowly(gamma, resistance, slope, offset):
    hoop, angle = hoop_of(gamma, resistance, slope), float(edge(gamma, resistance, slope))
    end = angle + 1.5
    truth, speed = time_to(hoop, mpf(angle), mpf(offset), mpf(end))
    motion = program(gamma, resistance, slope, angle, offset)
    found = when(motion, end)
    assert close(found, truth, lambda start: time_to(hoop, start, mpf(offset), mpf(end))[0], angle)
    assert float(motion.at(found).omega) == pytest.approx(float(speed), rel=1e-12)


@in_all
def test_let_go_beyond_the_hilltop(gamma, resistance, slope, offset):
    hoop, angle = hoop_of(gamma, resistance, slope), float(edge(gamma, resistance, slope) + offset)
    end = float(edge(gamma, resistance, slope)) + 1.5
    truth, _ = time_to(hoop, mpf(angle), mpf(0), mpf(end))
    found = when(program(gamma, resistance, slope, angle, 0.0), end)
    assert close(found, truth, lambda start: time_to(hoop, start, mpf(0), mpf(end))[0], angle)


@in_all
def test_a_small_swing_to_where_it_rests(gamma, resistance, slope, offset):
    """About the edge, from below it to above, where the couple holds it."""
    hoop, angle = hoop_of(gamma, resistance, slope), float(edge(gamma, resistance, slope, valley=True) - offset)
    truth, stop = time_to_stop(hoop, mpf(angle), mpf(0))
    event = program(gamma, resistance, slope, angle, 0.0).events[1]
    held = abs(hoop.eps * mp.sin(stop + hoop.slope) + mp.sin(hoop.slope)) <= hoop.resistance * mp.cos(hoop.slope)
    assert event.kind == ("rest" if held else "turn")
    # half a swing, whose time hardly depends on how wide it is: what rounds the angle rounds the width
    assert abs(mpf(event.t) - truth) <= truth * (mpf("6e-15") + 2 * math.ulp(angle) / offset)
    assert abs(mpf(float(event.angle)) - stop) < 8 * math.ulp(angle)


def test_the_series_are_right_where_there_is_a_formula():
    """A balanced hoop slows down evenly; without the couple the energy stays."""
    balanced = Rolling(mpf(0), mpf("0.6"), mpf("0.05"), mpf("0.02"))
    slowing = (mp.cos(balanced.slope) * balanced.resistance - mp.sin(balanced.slope)) / (1 + balanced.kap)
    t, angle = time_to_stop(balanced, mpf(1), mpf("1.5"))
    assert abs(t - mpf("1.5") / slowing) < mpf(10) ** -30
    assert abs(angle - 1 - mpf("1.5") ** 2 / (2 * slowing)) < mpf(10) ** -30
    free = Rolling(mpf("0.75"), 1 - mpf("0.75") ** 2, mpf(0))
    _, omega = time_to(free, mpf(0), mpf(2), mpf(3))
    energy = [(1 + free.eps * mp.cos(th)) * w**2 + free.eps * mp.cos(th) for th, w in ((mpf(0), mpf(2)), (mpf(3), omega))]
    assert abs(energy[0] - energy[1]) < mpf(10) ** -29
