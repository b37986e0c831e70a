"""Flight and energies in closed form, from the path of G alone; the oracles have rolling and slip."""

import math

import mpmath as mp
import pytest

from hophoop.kernel.physics.closed_forms import (
    LARGE_ROTATION,
    flight_displacement,
    flight_gap,
    flight_rates,
    kinetic_energy,
)
from newton_euler import BODIES, STATES


def test_a_load_at_the_plane_keeps_its_digits():
    """At γ = 1 the load beside θ = π hardly moves: ½ (2 sin² ½δ)² of the way along, ½ sin² δ upwards."""
    body = BODIES[0]._replace(eps=1.0, kap=0.0)
    delta = 1e-4
    along, up = 2.0 * math.sin(0.5 * delta) ** 2, math.sin(delta)
    assert kinetic_energy(body, math.pi - delta, 1.0, 0.0, 0.0, 0.0) == pytest.approx(0.5 * (along**2 + up**2), rel=1e-11)


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
        t, begin = mp.mpf(tau), mp.atan2(s, c)
        along, rise = vt + om + mp.mpf(body.eps) * c * om, vn - mp.mpf(body.eps) * om * s

        def gap(t):
            return y + body.eps * (c - mp.cos(begin + om * t)) + rise * t - body.gn * t**2 / 2

        def way(t):
            return along * t + body.gt * t**2 / 2 + body.eps * (s - mp.sin(begin + om * t))

        rates, moved = [mp.diff(gap, t, order) for order in range(4)], [way(t), mp.diff(way, t) - om]
    f_n = body.eps * om**2 * c - body.gn  # to rounding on every machine: it counts tau**2 / 2 times
    turned, size, fast = abs(om * tau), abs(rise) * t + body.gn * t**2 + abs(along) * t, max(1.0, abs(om))
    lost = 2e-16 * (turned**2 if turned <= LARGE_ROTATION else turned) + 1e-14  # as LARGE_ROTATION says

    def close(value, order):
        return pytest.approx(float(value), abs=4e-15 * float(size / t**order) + fast**order * lost)

    found = flight_rates(body, s, c, om, y, vn, f_n, tau)
    assert found == tuple(close(value, order) for order, value in enumerate(rates))
    assert flight_gap(body, s, c, om, y, vn, f_n, tau) == found[:2]
    assert flight_displacement(body, vt, om, s, c, tau) == tuple(close(value, order) for order, value in enumerate(moved))
