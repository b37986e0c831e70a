"""Landing and apex of a flight, against the path of G and the turn of the hoop on a dense grid of times."""

import math
from typing import NamedTuple

import numpy as np
import pytest
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
        turned = np.sin(self.th + self.om * tau) - math.sin(self.th)
        return self.vn - self.gn * tau + self.eps * self.om * turned

    @property
    def opening(self):
        return self.eps * self.om**2 * math.cos(self.th) - self.gn

    def found(self, order, limit=1e9):
        body = Body(self.eps, 0.3, 1.0, 1.0, self.gn, 0.0, 0.0, 0, False, 0.0)
        return landing.first_landing(body, self.th, self.om, self.y, self.vn, self.opening, order, limit)


def first_fall(function, times):
    """The first place on a grid where a function falls through zero, and then to rounding; nan where it does not."""
    values = function(times)
    falls = np.flatnonzero((values[:-1] > 0.0) & (values[1:] <= 0.0))
    return brentq(function, times[falls[0]], times[falls[0] + 1], xtol=1e-14) if falls.size else math.nan


def check(case, order, begin=1e-9):
    times = np.linspace(begin, 40.0, 400_001)
    expected = first_fall(case.gap, times)
    found, apex, _ = case.found(order)
    if math.isnan(expected):
        assert found == -1.0 or found > times[-1]
        return
    # rounding moves a landing beside a touch
    assert found == pytest.approx(expected, rel=1e-12, abs=1e-12 + 1e-14 / abs(case.rate(expected)))
    height = np.max(case.gap(np.linspace(0.0, expected, 20_001)))
    assert case.gap(max(apex, 0.0)) == pytest.approx(height, rel=1e-6)
    assert apex < 0.0 or (apex < found and abs(case.rate(apex)) < 1e-11)
    assert case._replace(th=-case.th, om=-case.om).found(order)[:2] == (found, apex)


@pytest.mark.parametrize("seed", range(40))
def test_random_flights(seed):
    """From above the plane, where the gap bends up and down once, many times or never; and from it, with any speed."""
    random = np.random.default_rng(seed)
    case = Case(*random.uniform([0.0, 0.6, -math.pi, -2.5, 0.01, -3.0], [1.0, 1.0, math.pi, 2.5, 3.0, 3.0]).tolist())
    case = case._replace(om=case.om**3)
    check(case, 0)
    if seed < 15:
        check(case._replace(y=0.0, vn=10.0 ** random.uniform(-4.0, 0.5)), 1, begin=1e-7)


@pytest.mark.parametrize("om", [1.2, 2.0, 5.0, 30.0])
@pytest.mark.parametrize("part", [1.0, 0.999, 0.5, 0.0, -0.7])
def test_lift_off(om, part):
    """From the plane at rest: with f_n = 0 where the load comes to where the gap bends up, and with f_n > 0 within."""
    eps = 0.75
    half = math.acos(1.0 / (eps * om**2))
    check(Case(eps, 1.0, -part * half, om, 0.0, 0.0), 3 if part == 1.0 else 2, begin=1e-3)


def test_without_gravity():
    """G goes on evenly: the rim lands only where G comes down, or where a turn brings it down."""
    for vn, found in ((-0.25, 4.0), (0.25, -1.0), (0.0, -1.0)):
        assert Case(0.5, 0.0, 0.3, 0.0, 1.0, vn).found(0)[0] == pytest.approx(found, rel=1e-15)
    assert Case(0.0, 0.0, 0.3, 2.0, 0.0, 0.0).found(3)[0] == -1.0  # a balanced hoop stays where it is
    check(Case(0.75, 0.0, math.pi, 2.0, 1.4, 0.0), 0)  # the rim comes 1.5 down as the load goes from the bottom to the top


@pytest.mark.parametrize(("above", "low", "high"), [(1e-12, -1.0, -1.0), (0.0, -1.0, -1.0), (-1e-12, 1e-6, 3e-6)])
def test_a_touch_is_no_landing(above, low, high):
    """The rim comes down to the plane and up again, once a turn, without gravity; the gap is (π − τ)²/4 and 10⁻¹² there."""
    found = Case(0.5, 0.0, math.pi, 1.0, 1.0 + above, 0.0).found(0, 20.0)[0]
    assert low <= (math.pi - found if 0.0 < found <= 20.0 else -1.0) <= high  # rounding touches after 2,600 turns


@pytest.mark.parametrize("vn", [1e-3, 1e-8, 1e-90])
def test_tiny_bounces(vn):
    """A parabola over so short a time: 2 v_n over the acceleration."""
    case = Case(0.75, 1.0, 1.0, 1.3, 0.0, vn)
    half = -vn / case.opening
    assert case.found(1)[:2] == pytest.approx((2.0 * half, half), rel=20.0 * vn + 1e-14)


def test_the_apex_of_a_flight_that_is_cut_is_that_of_the_whole_flight():
    """A top before the cut is none if the rim rises higher after it; here are three, the second the highest."""
    case = Case(0.73, 1.0, -1.63, 3.56, 0.91, 0.06)
    landed, apex, _ = case.found(0)
    gaps = [case.gap(tau) for tau in (1.473, 3.061, 4.628)]
    assert apex == pytest.approx(3.061, abs=1e-3)
    assert gaps[2] < gaps[0] < gaps[1]
    for limit in (1.0, 2.0, 3.0):
        assert not 0.0 < case.found(0, limit)[1] < limit
    for limit in (3.1, 4.0, 5.0, landed):
        assert case.found(0, limit)[1] == apex
