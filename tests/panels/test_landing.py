"""Landing and apex of a flight, against the path of G and the turn of the hoop on a dense grid of times."""

import math
from typing import NamedTuple

import numpy as np
import pytest
from mpmath import mp, mpf
from scipy.optimize import brentq

from hophoop.kernel.panels import landing
from hophoop.kernel.physics.body import Body


class Case(NamedTuple):
    """A flight; the gap is y + (v_n − ε θ̇ sin θ) τ − g_n τ²/2 − ε [cos(θ + θ̇ τ) − cos θ]."""

    eps: float
    gn: float
    th: float
    om: float
    y: float
    vn: float

    def gap(self, tau):
        rise = self.vn - self.eps * self.om * math.sin(self.th)
        turned = np.cos(self.th + self.om * tau) - math.cos(self.th)
        return self.y + rise * tau - 0.5 * self.gn * tau**2 - self.eps * turned

    def rate(self, tau):
        rise = self.vn - self.eps * self.om * math.sin(self.th)
        return rise - self.gn * tau + self.eps * self.om * np.sin(self.th + self.om * tau)

    @property
    def opening(self):
        return self.eps * self.om**2 * math.cos(self.th) - self.gn

    def mirrored(self):
        return self._replace(th=-self.th, om=-self.om)

    def found(self, order, limit=1e9):
        gn = self.gn
        body = Body(self.eps, 0.3, 1.0, 1.0, gn, 0.0, 0.0, 0, False, 0.0)
        return landing.first_landing(body, self.th, self.om, self.y, self.vn, self.opening, order, limit)


def first_fall(function, times):
    """The first place on a grid where a function falls through zero, and then to rounding; nan where it does not."""
    values = function(times)
    falls = np.flatnonzero((values[:-1] > 0.0) & (values[1:] <= 0.0))
    return brentq(function, times[falls[0]], times[falls[0] + 1], xtol=1e-14) if falls.size else math.nan


def check(case, order, begin=1e-9):
    times = np.linspace(begin, 40.0, 400_001)
    expected = first_fall(case.gap, times)
    found, apex, seen = case.found(order)
    assert seen == 1e9
    if math.isnan(expected):
        assert found == -1.0 or found > times[-1]
        return
    slowness = 1.0 / abs(case.rate(expected))  # of a landing beside a touch, whose place rounding moves
    assert found == pytest.approx(expected, rel=1e-12, abs=1e-12 + 1e-14 * slowness)
    before = np.linspace(0.0, expected, 20_001)[1:-1]
    height = max(np.max(case.gap(before), initial=0.0), case.y)
    if apex >= 0.0:
        assert 0.0 < apex < found
        assert abs(case.rate(apex)) < 1e-11
        assert case.gap(apex) == pytest.approx(height, rel=1e-6)
    else:
        assert height == pytest.approx(max(case.y, case.gap(before[0])), rel=1e-6)
    assert case.mirrored().found(order) == (found, apex, seen)


@pytest.mark.parametrize("seed", range(60))
def test_random_flights(seed):
    """From above the plane, where the gap bends up and down once, many times or never."""
    random = np.random.default_rng(seed)
    eps = random.uniform(0.0, 1.0)
    om = random.choice([-1.0, 1.0]) * 10.0 ** random.uniform(-2.0, 1.2)
    y, vn = random.uniform(0.01, 3.0), random.uniform(-3.0, 3.0)
    check(Case(eps, float(random.choice([1.0, 0.6])), random.uniform(-math.pi, math.pi), om, y, vn), 0)


@pytest.mark.parametrize("seed", range(20))
def test_bounces(seed):
    """From the plane, with any speed away from it."""
    random = np.random.default_rng(100 + seed)
    om, vn = random.uniform(-4.0, 4.0), 10.0 ** random.uniform(-4.0, 0.5)
    check(Case(random.uniform(0.0, 1.0), 1.0, random.uniform(-math.pi, math.pi), om, 0.0, vn), 1, begin=1e-7)


@pytest.mark.parametrize("om", [1.2, 2.0, 5.0, 30.0])
@pytest.mark.parametrize("part", [1.0, 0.999, 0.5, 0.0, -0.7])
def test_lift_off(om, part):
    """From the plane at rest: with f_n = 0 where the load comes to where the gap bends up, and with f_n > 0 within."""
    eps = 0.75
    half = math.acos(1.0 / (eps * om**2))
    check(Case(eps, 1.0, -part * half, om, 0.0, 0.0), 3 if part == 1.0 else 2, begin=1e-3)


def test_a_lift_off_of_which_rounding_leaves_nothing():
    """g_n = ε θ̇² at the top, where the gap would have to bend up: it is at the plane again at once."""
    assert Case(0.5, 1.0, 0.0, math.nextafter(math.sqrt(2.0), 0.0), 0.0, 0.0).found(3)[0] == 0.0


def test_without_gravity():
    """G goes on evenly: the rim lands only where G comes down, or where a turn brings it down."""
    assert Case(0.5, 0.0, 0.3, 0.0, 1.0, -0.25).found(0)[0] == pytest.approx(4.0, rel=1e-15)
    assert Case(0.5, 0.0, 0.3, 0.0, 1.0, 0.25).found(0)[0] == -1.0
    assert Case(0.5, 0.0, 0.3, 0.0, 1.0, 0.0).found(0)[0] == -1.0
    assert Case(0.0, 0.0, 0.3, 2.0, 0.0, 0.0).found(3)[0] == -1.0  # a balanced hoop stays where it is
    # the rim is lowest with the load on top, 1.5 below where it is with the load at the bottom
    check(Case(0.75, 0.0, math.pi, 2.0, 1.4, 0.0), 0)
    assert Case(0.75, 0.0, math.pi, 2.0, 1.6, 0.0).found(0)[0] == -1.0


@pytest.mark.parametrize(("above", "lands"), [(1e-12, False), (0.0, False), (-1e-12, True)])
def test_a_touch_is_no_landing(above, lands):
    """The rim comes down to the plane and up again, once a turn, without gravity."""
    found = Case(0.5, 0.0, math.pi, 1.0, 1.0 + above, 0.0).found(0, 20.0)[0]
    assert (found > 0.0) is lands
    if lands:
        # The gap is (π − τ)²/4 − 1e-12 there and falls with 1e-6: the time has the condition 1e6, the gap itself is known.
        assert 1e-6 < math.pi - found < 3e-6
        with mp.workdps(30):
            th = mpf(math.pi)
            rise = -mp.mpf("0.5") * mp.sin(th)
            gap = mpf(1.0 + above) + rise * mpf(found) - (mp.cos(th + mpf(found)) - mp.cos(th)) / 2
        assert abs(gap) < 8.0 * np.spacing(1.0)


@pytest.mark.parametrize("vn", [1e-3, 1e-8, 1e-30, 1e-90])
def test_tiny_bounces(vn):
    """A parabola over so short a time: 2 v_n over the acceleration."""
    case = Case(0.75, 1.0, 1.0, 1.3, 0.0, vn)
    found, apex, _ = case.found(1)
    fall = -case.opening
    assert found == pytest.approx(2.0 * vn / fall, rel=20.0 * vn + 1e-14)
    assert apex == pytest.approx(vn / fall, rel=20.0 * vn + 1e-14)


def test_the_limit_of_time_changes_no_bit():
    case = Case(0.75, 1.0, 2.0, 7.0, 0.5, 1.0)
    found = case.found(0)
    assert case.found(0, found[0])[:2] == found[:2]
    assert case.found(0, 100.0)[:2] == found[:2]
