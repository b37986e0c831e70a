"""Rolling, slip, flight and energies in closed form, each from the path, the velocity or the energy of G alone."""

import math

import mpmath as mp
import pytest

from hophoop.kernel.physics.closed_forms import (
    LARGE_ROTATION,
    flight_displacement,
    flight_gap,
    flight_rates,
    kinetic_energy,
    potential_energy,
    rest_curvature,
    rolling_energy_change,
    slip_displacement,
)
from newton_euler import BODIES, STATES, case_of, energy
from oracles import series


def potential(body, turn, th):
    """Of G where the hoop has rolled by an angle."""
    return energy(body, turn, 0.0, th + turn, 0.0, 0.0, 0.0)[1]


@pytest.mark.parametrize("slope", [1.0, -1.0, 0.3])
def test_rolling_gains_what_the_potential_loses(slope):
    """Also where gravity along the slope is one: the way down a slope counts, whatever its number is."""
    body = BODIES[0]._replace(gn=0.4, gt=slope)
    for turn in (0.6, -1.1):
        lost = potential(body, 0.0, 0.5) - potential(body, turn, 0.5)
        gained = rolling_energy_change(body, math.sin(0.5), math.cos(0.5), math.sin(turn), 1.0 - math.cos(turn), turn)
        assert gained == pytest.approx(2.0 * lost, rel=1e-11)


@pytest.mark.parametrize("body", BODIES)
def test_how_the_potential_of_rolling_bends(body):
    """V″ by differences of V: what decides whether rest is stable."""
    step = 1e-4
    for th in (0.0, 0.7, -2.0, 3.0):
        low, mid, high = (potential(body, turn, th) for turn in (-step, 0.0, step))
        found = rest_curvature(body, math.sin(th), math.cos(th))
        assert found == pytest.approx((low - 2.0 * mid + high) / step**2, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize(("th", "om"), STATES)
def test_energies(body, th, om):
    """θ as one number, and as two."""
    x, y, vt, vn = 0.7, 0.3, -0.4, 0.9
    for low in (0.0, 1e-7):
        kinetic, high = energy(body, x, y, th + low, vt + om, vn, om)
        assert kinetic_energy(body, th, om, vt, vn, low) == pytest.approx(kinetic, rel=1e-12)
        assert potential_energy(body, x, y, th + low) == pytest.approx(high - potential(body, 0.0, 0.0), rel=1e-12)


def test_a_load_at_the_plane_keeps_its_digits():
    """At γ = 1 the load beside θ = π hardly moves: ½ (2 sin² ½δ)² of the way along, ½ sin² δ upwards."""
    body = BODIES[0]._replace(eps=1.0, kap=0.0)
    delta = 1e-4
    along, up = 2.0 * math.sin(0.5 * delta) ** 2, math.sin(delta)
    assert kinetic_energy(body, math.pi - delta, 1.0, 0.0, 0.0, 0.0) == pytest.approx(0.5 * (along**2 + up**2), rel=1e-11)


@pytest.mark.parametrize("body", [body._replace(mu_k=0.25) for body in BODIES[:2]])
@pytest.mark.parametrize(("sigma", "mode"), [(1, "K"), (-1, "S")])
def test_how_far_slip_goes(body, sigma, mode):
    """Against the Taylor series of the equations of motion."""
    tau, vt = 0.1, 0.5 * sigma
    for th, om in STATES:
        state = tuple(map(mp.mpf, (0.0, 0.0, th, vt + om, 0.0, om)))
        x, _, end, *_ = map(float, series.expand(series.Parameters(case_of(body)), mode, 0, state, 0, 25).state(tau))
        s, c = math.sin(th), math.cos(th)
        found = slip_displacement(body, sigma, vt, om, s, c, math.sin(end) - s, math.cos(end) - c, tau)
        assert found == pytest.approx(x, rel=1e-11, abs=1e-12)


TURNS = [LARGE_ROTATION - 0.5, LARGE_ROTATION + 0.5, -LARGE_ROTATION - 0.5, 1e5, -3e7]
FLIGHTS = [(th, om, tau) for th, om in STATES for tau in (0.05, 1.7)]
FLIGHTS += [(0.4, math.copysign(50.0, turned), abs(turned) / 50.0) for turned in TURNS]


@pytest.mark.parametrize("body", BODIES)
@pytest.mark.parametrize(("th", "om", "tau"), FLIGHTS)
def test_flight(body, th, om, tau):
    """Where G is and how the hoop has turned, in 40 digits."""
    y, vt, vn = 0.4, -0.6, 0.8
    s, c = math.sin(th), math.cos(th)
    with mp.workdps(40):
        eps, gn, t = mp.mpf(body.eps), mp.mpf(body.gn), mp.mpf(tau)
        along, rise = vt + om + eps * c * om, vn - eps * om * s
        angle = mp.atan2(s, c) + om * t
        sine, cosine = mp.sin(angle), mp.cos(angle)
        gap = y + eps * c + rise * t - gn * t**2 / 2 - eps * cosine
        rate = rise - gn * t + eps * om * sine
        bend, jerk = eps * om**2 * cosine - gn, -eps * om**3 * sine
        way = along * t + body.gt * t**2 / 2 + eps * s - eps * sine
        slip = along + body.gt * t - eps * om * cosine - om
    f_n = body.eps * om**2 * c - body.gn  # to rounding on every machine: it counts tau**2 / 2 times
    turned, size, fast = abs(om * tau), abs(rise) * t + gn * t**2 + abs(along) * t, max(1.0, abs(om))
    lost = 2e-16 * (turned**2 if turned <= LARGE_ROTATION else turned) + 1e-14  # as LARGE_ROTATION says

    def close(value, order):
        return pytest.approx(float(value), abs=4e-15 * float(size / t**order) + fast**order * lost)

    found = flight_rates(body, s, c, om, y, vn, f_n, tau)
    assert found == tuple(close(value, order) for order, value in enumerate((gap, rate, bend, jerk)))
    assert flight_gap(body, s, c, om, y, vn, f_n, tau) == found[:2]
    assert flight_displacement(body, vt, om, s, c, tau) == (close(way, 0), close(slip, 1))
