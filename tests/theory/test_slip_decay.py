"""How slip dies away on the level, against the return map."""

import math

import pytest

import hophoop as hh

HOOP = hh.Hoop.ideal(0.75)
LEVEL = hh.Plane(gravity=1.0)
CASES = [
    (hh.Hoop.ideal(0.75, radius=0.3, mass=2.0), hh.Plane()),
    (hh.Hoop.ideal(0.5), hh.Plane(mu=0.5, gravity=1.0)),
    (hh.Hoop.ideal(0.3), hh.Plane(mu=0.3, gravity=1.0)),
]


def passages(hoop, plane, omega, count):
    return hh.passages(hh.Scenario(hoop=hoop, plane=plane, start=hh.Start.rolling(omega * hoop.radius, angle=math.pi)), count)


@pytest.mark.parametrize(("hoop", "plane"), CASES)
def test_a_revolution_loses_the_square_of_the_excess(hoop, plane):
    """The differences from the law shrink with the excess: they are of the next order."""
    decay = hh.theory.slip_decay(hoop, plane)
    off = []
    for part in (3e-4, 3e-5):
        excess = part / decay.rate
        found = passages(hoop, plane, decay.omega + excess, 1)
        assert found.sequences == ("RSRKR",)
        off.append(abs((excess - (found.omega[0] - decay.omega)) / excess / part - 1.0))
    assert off[0] < 3e-3
    assert off[1] < 0.2 * off[0]


def test_below_the_first_slip_nothing_is_lost():
    decay, speed = hh.theory.slip_decay(HOOP, LEVEL), hh.theory.first_slip_speed(HOOP, LEVEL)
    assert passages(HOOP, LEVEL, decay.omega * (1 - 1e-12), 1).sequences == ("R",)
    assert decay.omega == pytest.approx(math.sqrt(((2 + 2 * 0.75) * speed**2 + 4 * 0.75) / (2 - 2 * 0.75)), rel=1e-13)
    # above it the excess falls as one over the revolutions
    found = passages(HOOP, LEVEL, decay.omega + 0.05, 2000)
    assert found.omega[-1] - decay.omega == pytest.approx(decay.excess(0.05, 2000), rel=1e-2)


@pytest.mark.parametrize(
    ("hoop", "plane", "message"),
    [
        (HOOP, hh.Plane(slope=0.1), "plane.slope must be 0"),
        (HOOP, hh.Plane(gravity=0.0), "plane.gravity above 0"),
        (HOOP, hh.Plane(rolling_resistance=0.01), "plane.rolling_resistance must be 0"),
        (HOOP, hh.Plane(mu_static=0.6, mu_kinetic=0.5), "plane.mu one number"),
        (hh.Hoop.ideal(0.0), hh.Plane(), "hoop.load_fraction above 0 and below 1"),
        (HOOP, hh.Plane(mu=0.0), "finite friction"),
        (HOOP, hh.Plane(mu=0.1), "begins to slip at no speed above 0"),
    ],
)
def test_refusals(hoop, plane, message):
    with pytest.raises(ValueError, match=message):
        hh.theory.slip_decay(hoop, plane)
