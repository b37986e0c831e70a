"""What must go together: a spring and its hoop in any units, a couple and an inertia, a hoop and the kernels' numbers."""

import math

import pytest

import hophoop as hh
from hophoop.kernel.physics.contact import most_resistance
from strategies import said

SOFT = 0.04  # m g/R: at the speed v, in √(g R), the rim sinks some 5 v + 25 radii, of which the start may have 100


def thrown(radius, mass, gravity, start, weight=1.0):
    """A scenario of the same motion in other units; the start in R and √(g R)."""
    second = math.sqrt(radius / gravity)
    units = {"height": radius, "vx": radius / second, "vy": radius / second, "omega": 1.0 / second}
    return hh.Scenario(
        hoop=hh.Hoop(radius=radius, mass=mass),
        plane=hh.Plane(gravity=weight * gravity),
        start=hh.Start(**{name: value * units[name] for name, value in start.items()}),
        contact=hh.Compliant(stiffness=SOFT * mass * gravity / radius),
    )


@pytest.mark.parametrize("units", [(1.0, 1.0, 9.81), (0.01, 200.0, 9.81), (30.0, 0.004, 0.5)])
@pytest.mark.parametrize(
    "start", [{"vx": 15.0}, {"vy": -15.0}, {"vx": 4.0, "vy": 5.0, "omega": -6.0}, {"omega": 15.0}, {"height": 112.5}]
)
def test_how_deep_a_start_sinks_is_the_same_in_any_units(units, start):
    """√(2 g h) is 15 √(g R) at the height of 112.5 R."""
    thrown(*units, {name: 0.99 * value for name, value in start.items()})
    deeper = {name: 1.01 * value for name, value in start.items()}
    assert "lets the rim sink some 1e+02 radii" in said(lambda: thrown(*units, deeper))


def test_without_gravity_no_height_is_fallen_from():
    thrown(4.0, 2.0, 1.0, {"height": 1e5, "vy": 14.9}, weight=0.0)
    assert "lets the rim sink" in said(lambda: thrown(4.0, 2.0, 1.0, {"vy": 15.1}, weight=0.0))


def test_rolling_resistance_is_below_what_the_inertia_allows():
    hoop = hh.Hoop(eccentricity=0.9, inertia_ratio=0.01)
    most = most_resistance(0.9, 0.01)
    assert 0.0 < most < 1.0
    below = hh.Scenario(hoop=hoop, plane=hh.Plane(rolling_resistance=math.nextafter(most, 0.0)))
    assert hh.Scenario.from_dict(below.to_dict()) == below
    expected = f"plane.rolling_resistance = {most!r} must be below {most:.6g} for this hoop"
    assert expected in said(lambda: hh.Scenario(hoop=hoop, plane=hh.Plane(rolling_resistance=most)))


def test_only_a_resistance_that_is_there_is_written():
    assert "rolling_resistance" not in hh.Plane().to_dict()
    assert hh.Plane(rolling_resistance=0.01).to_dict()["rolling_resistance"] == 0.01


def test_a_part_may_reach_beyond_the_rim_by_what_rounding_does():
    reach, ring = 1.0 + 1e-12, hh.Ring(1.0, 0.9, 1.0)
    hh.Hoop.from_parts(1.0, [ring, hh.PointMass(1.0, reach)])
    beyond = [ring, hh.PointMass(1.0, math.nextafter(reach, 2.0))]
    assert "beyond the rim" in said(lambda: hh.Hoop.from_parts(1.0, beyond))


HOLDS = ""
ENTERS, PULLS = "without contact the rim would enter the plane", "the plane would have to pull"
SLIPS = "rolling needs more friction than there is"


@pytest.mark.parametrize(
    ("mode", "start", "plane", "why"),
    [
        ("H", {}, {}, ENTERS),
        ("H", {"vx": 1.0, "omega": 1.0}, {"rolling_resistance": 0.01}, ENTERS),
        ("H", {}, {"rolling_resistance": 0.01}, HOLDS),  # the couple jumps where the hoop turns back
        ("H", {"vx": 9.0, "omega": 9.0}, {}, HOLDS),
        ("H", {"height": 0.1}, {}, HOLDS),
        ("H", {"vy": 0.1}, {}, HOLDS),
        ("R", {"vx": 2.0, "omega": 2.0}, {}, HOLDS),
        ("R", {"vx": 9.0, "omega": 9.0}, {}, PULLS),
        ("R", {"angle": 1.0}, {"mu": 0.01}, SLIPS),
        ("S", {"vx": 1.0, "omega": 2.0}, {}, HOLDS),
        ("S", {"vx": 8.0, "omega": 9.0}, {}, PULLS),
        ("K", {"vx": 2.0, "omega": 1.0}, {}, HOLDS),
        ("K", {"vx": 10.0, "omega": 9.0}, {}, PULLS),
    ],
)
def test_the_mode_of_a_start_can_hold(mode, start, plane, why):
    begin = hh.Start(mode=mode, slip=start.get("vx", 0.0) - start.get("omega", 0.0), **start)
    if why == HOLDS:
        assert hh.Scenario(start=begin, plane=hh.Plane(**plane)).start == begin
    else:
        assert said(lambda: hh.Scenario(start=begin, plane=hh.Plane(**plane))) == f"start.mode = {mode!r} cannot hold: {why}."


@pytest.mark.parametrize(
    ("start", "expected"),
    [
        ({"mode": "R"}, "start.mode = 'R' needs start.slip, the slip velocity."),
        ({"mode": "R", "slip": 0.0, "height": 1.0}, "start.mode = 'R' needs start.height = 0 and start.vy = 0."),
        ({"mode": "K", "slip": 0.0, "vy": 1.0}, "start.mode = 'K' needs start.height = 0 and start.vy = 0."),
        ({"mode": "R", "slip": 0.1}, "start.slip = 0.1 must be 0 with start.mode = 'R'."),
        ({"mode": "S", "slip": 0.1}, "start.slip = 0.1 must be at most 0 with start.mode = 'S'."),
        ({"mode": "K", "slip": -0.1}, "start.slip = -0.1 must be at least 0 with start.mode = 'K'."),
        ({"speed": 1.0, "mode": "R", "slip": 0.0}, "start.slip cannot be given together with start.speed."),
        ({"omega": None}, "start.omega = None must be a number."),
        ({"slip": 0.1}, "start.slip = 0.1 must be start.vx - hoop.radius start.omega = 0.0 within rounding."),
    ],
)
def test_a_slip_velocity_and_a_mode_that_contradict_the_state(start, expected):
    assert said(lambda: hh.Scenario(start=hh.Start(**start))) == expected
