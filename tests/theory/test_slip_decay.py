"""How slip dies away on the level, against the return map, and the first gait on a gentle slope, which follows from it."""

import math

import pytest

import hophoop as hh

CASES = [(0.75, 1.0), (0.5, 0.5), (0.3, 0.3), (0.6, 0.8)]


def passages(hoop, plane, omega, count):
    return hh.passages(hh.Scenario(hoop=hoop, plane=plane, start=hh.Start.rolling(omega, angle=math.pi)), count)


@pytest.mark.parametrize(("gamma", "mu"), CASES)
def test_a_revolution_loses_the_square_of_the_excess(gamma, mu):
    """The differences from the law shrink with the excess: they are of the next order."""
    hoop, plane = hh.Hoop.ideal(gamma), hh.Plane(mu=mu, gravity=1.0)
    decay = hh.theory.slip_decay(hoop, plane)
    off = []
    for excess in (1e-3, 1e-4):
        found = passages(hoop, plane, decay.omega + excess, 1)
        assert found.sequences == ("RSRKR",)
        off.append(abs((excess - (found.omega[0] - decay.omega)) / excess**2 / decay.rate - 1.0))
    assert off[0] < 3e-3
    assert off[1] < 0.2 * off[0]


def test_below_the_first_slip_nothing_is_lost():
    hoop, plane = hh.Hoop.ideal(0.75), hh.Plane(gravity=1.0)
    decay = hh.theory.slip_decay(hoop, plane)
    assert passages(hoop, plane, decay.omega * (1 - 1e-12), 1).sequences == ("R",)
    speed = hh.theory.first_slip_speed(hoop, plane)
    top = math.sqrt(((2 + 2 * 0.75) * speed**2 + 4 * 0.75) / (2 - 2 * 0.75))
    assert decay.omega == pytest.approx(top, rel=1e-13)


def test_the_excess_falls_as_one_over_the_revolutions():
    hoop, plane = hh.Hoop.ideal(0.75), hh.Plane(gravity=1.0)
    decay = hh.theory.slip_decay(hoop, plane)
    count = 20_000
    found = passages(hoop, plane, decay.omega + 0.05, count)
    left = found.omega[-1] - decay.omega
    assert left == pytest.approx(decay.excess(0.05, count), rel=2e-3)
    assert left * decay.rate * count == pytest.approx(1.0, rel=5e-3)


@pytest.mark.parametrize("degrees", [0.004, 0.001])
def test_on_a_gentle_slope_the_excess_makes_up_for_what_the_slope_gives(degrees):
    """The gait's loss of a revolution, D ω·rate·excess² of energy at the bottom, is 2π sin β."""
    hoop, plane = hh.Hoop.ideal(0.75), hh.Plane(gravity=1.0)
    decay, slope = hh.theory.slip_decay(hoop, plane), math.radians(degrees)
    inertia = 2 - 2 * 0.75  # about the contact with the load at the bottom, in units of m R²
    expected = math.sqrt(2 * math.pi * math.sin(slope) / (inertia * decay.omega * decay.rate))
    found = passages(hoop, hh.Plane(gravity=1.0, slope=slope), decay.omega + expected, 4000)
    assert found.omega[-1] - decay.omega == pytest.approx(expected, rel=0.02)


def test_units_of_length_and_mass():
    small = hh.theory.slip_decay(hh.Hoop.ideal(0.75, radius=0.3, mass=2.0))
    unit = hh.theory.slip_decay(hh.Hoop.ideal(0.75), hh.Plane(gravity=1.0))
    per_second = math.sqrt(hh.Plane().gravity / 0.3)
    assert small.omega == pytest.approx(unit.omega * per_second, rel=1e-14)
    assert small.rate == pytest.approx(unit.rate / per_second, rel=1e-14)


@pytest.mark.parametrize(
    ("hoop", "plane", "message"),
    [
        (hh.Hoop.ideal(0.75), hh.Plane(slope=0.1), "plane.slope must be 0"),
        (hh.Hoop.ideal(0.75), hh.Plane(gravity=0.0), "plane.gravity above 0"),
        (hh.Hoop.ideal(0.75), hh.Plane(rolling_resistance=0.01), "plane.rolling_resistance must be 0"),
        (hh.Hoop.ideal(0.75), hh.Plane(mu_static=0.6, mu_kinetic=0.5), "plane.mu one number"),
        (hh.Hoop.ideal(0.0), hh.Plane(), "hoop.load_fraction above 0 and below 1"),
        (hh.Hoop.ideal(0.75), hh.Plane(mu=0.0), "finite friction"),
        (hh.Hoop.ideal(0.75), hh.Plane(mu=0.1), "begins to slip at no speed above 0"),
    ],
)
def test_refusals(hoop, plane, message):
    with pytest.raises(ValueError, match=message):
        hh.theory.slip_decay(hoop, plane)
