"""The strips beside a skid over its saddle: their widths by theory against measured ones, and where they are looked for."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.maps.boundaries.classes import Classifier, make_window
from hophoop.maps.survey.slices import resolve
from hophoop.maps.survey.strips import across, may_hold_strips, saddle_of_skid, strips_at

# γ, μ, a speed below and one above the border of the skid, and the skid
PLACES = [
    (0.45, 0.031, 1.5, 1.6, "RSK"),
    (0.48, 0.0288, 1.53, 1.545, "RSRSK"),
    (0.48, 0.0324, 1.53, 1.545, "RSRSK"),
    (0.48, 0.0525, 1.4, 1.52, "RSKRSK"),
]


def make_classifier(gamma):
    base = hh.Scenario().replace("hoop.load_fraction", gamma)
    window = make_window(base, {"plane.mu": (1e-3, 2.0), "start.speed": (1e-3, 9.0)})
    return Classifier(base, window, ("sequence", "ending"), "first_revolution")


def measured(classify, one, skid):
    """Where the strips of a skid lie on a line, and how wide they are: reversal, revolutions."""
    classes = [tuple(classify.names[code].split(" ")) for code in one.codes]
    first = next(k for k in range(len(classes)) if {*classes[k : k + 4]} == set(across(skid)))
    strips = sorted(zip(classes[first + 1 : first + 3], np.diff(one.y)[first + 1 : first + 3], strict=True))
    return float(one.y[first + 2]), *(float(width) for _, width in strips)


def scenario(gamma, mu, speed):
    return hh.Scenario(hoop=hh.Hoop.ideal(gamma), plane=hh.Plane(mu=mu), start=hh.Start.rolling(speed), duration=60.0)


@pytest.mark.parametrize(("gamma", "mu", "low", "high", "skid"), PLACES)
def test_widths_of_strips_are_those_of_theory(gamma, mu, low, high, skid):
    """Along speed and along friction, from 1e-11 to 1e-5."""
    classify = make_classifier(gamma)
    along = resolve(classify.at, [mu], [np.linspace(low, high, 40)])[0]
    speed, reversal, revolutions = measured(classify, along, skid)
    found = strips_at(scenario(gamma, mu, speed))
    assert 10.0**found.reversal == pytest.approx(reversal, rel=0.005)
    assert 10.0**found.revolutions == pytest.approx(revolutions, rel=0.005)
    along = resolve(lambda x, y: classify.at(y, x), [speed], [mu * (1.0 + np.linspace(-1e-3, 1e-3, 201))])[0]
    place, reversal, revolutions = measured(classify, along, skid)
    assert place == pytest.approx(mu, rel=1e-9)
    found = strips_at(scenario(gamma, mu, speed), "plane.mu")
    assert 10.0**found.reversal == pytest.approx(reversal, rel=0.005)
    assert 10.0**found.revolutions == pytest.approx(revolutions, rel=0.005)


@pytest.mark.parametrize(("gamma", "mu", "low", "high"), [(0.6, 0.0166, 1.4, 1.45), (0.75, 0.0066, 1.1, 1.15)])
def test_strips_too_narrow_to_be_seen(gamma, mu, low, high):
    """From a reversal not so near: where it turns, it is a known way from the saddle and has a known v_t left."""
    classify = make_classifier(gamma)
    one = resolve(classify.at, [mu], [np.linspace(low, high, 40)])[0]
    classes = [classify.names[code] for code in one.codes]
    skid = "RSRSK" if gamma == 0.6 else "RSK"
    border = float(one.y[classes.index(f"{skid} revolutions")])
    assert classes[classes.index(f"{skid} revolutions") - 1] == f"{skid} reversal"  # no strip is seen
    distance = 1e-8 * border
    motion = hh.simulate(scenario(gamma, mu, border - distance))
    turn = next(event for event in motion.events if event.kind == "turn")
    saddle, rate = saddle_of_skid(gamma, 1.0 - gamma**2, mu)
    # turning, half of the way from the saddle grows and half decays; what is left of v_t goes at the rate μ g
    growing = 0.5 * (2.0 * math.pi + saddle - turn.angle)
    exponent = -saddle * rate**2 * (1.0 + gamma) / mu - rate * math.sqrt(9.81) * turn.vx / (mu * 9.81)
    both = math.log10(-saddle * distance / growing) + exponent / math.log(10.0)
    found = strips_at(scenario(gamma, mu, border))
    assert found.revolutions + math.log10(1.0 + 10.0 ** (found.reversal - found.revolutions)) == pytest.approx(both, abs=0.01)
    assert both < -19.0


def test_widths_scale_as_speeds_do():
    classify = make_classifier(0.48)
    speed, *_ = measured(classify, resolve(classify.at, [0.0525], [np.linspace(1.4, 1.52, 40)])[0], "RSKRSK")
    one = scenario(0.48, 0.0525, speed)
    ratio = math.sqrt(0.3 * 1.62 / 9.81)
    other = one.with_values({"hoop.radius": 0.3, "plane.gravity": 1.62, "start.speed": speed * ratio})
    for path, size in (("start.speed", math.log10(ratio)), ("plane.mu", 0.0)):
        mine, scaled = strips_at(one, path), strips_at(other, path)
        assert scaled.reversal - mine.reversal == pytest.approx(size, abs=1e-4)
        assert scaled.revolutions - mine.revolutions == pytest.approx(size, abs=1e-4)


@pytest.mark.parametrize("mu", [0.01, 0.1, 0.3])
def test_the_saddle_of_a_skid(mu):
    hoop = hh.Hoop.ideal(0.6)
    angle, rate = saddle_of_skid(hoop.eccentricity, hoop.inertia_ratio, mu)

    def torque(theta):
        return hoop.eccentricity * math.sin(theta) + mu * (1.0 + hoop.eccentricity * math.cos(theta))

    assert torque(angle) == pytest.approx(0.0, abs=1e-15)
    # θ̈ of a skid that does not turn, by difference: λ² is its slope
    slope = (torque(angle + 1e-6) - torque(angle - 1e-6)) / 2e-6 / hoop.inertia_ratio
    assert rate == pytest.approx(math.sqrt(slope), rel=1e-8)
    with pytest.raises(ValueError, match="must be below"):
        saddle_of_skid(0.6, 0.64, 0.8)


def test_where_strips_are_looked_for():
    row = across("RSK")
    assert row == (("RSK", "reversal"), ("RSKR", "reversal"), ("RSKR", "revolutions"), ("RSK", "revolutions"))
    assert all(may_hold_strips(one, other) for one in row for other in row)
    assert not may_hold_strips(("RSK", "reversal"), ("RSKS", "revolutions"))
    assert not may_hold_strips(("RSR", "reversal"), ("RSR", "revolutions"))
    assert not may_hold_strips(("R", "reversal"), ("R", "revolutions"))
    assert not may_hold_strips(("RSK", "reversal"), ("RSRSK", "revolutions"))


def test_a_motion_without_such_a_skid():
    with pytest.raises(ValueError, match=r"start\.speed = .* must lead to a skid that comes to its saddle"):
        strips_at(scenario(0.75, 1.0, 0.1).replace("plane.mu", 0.5))
    with pytest.raises(ValueError, match="start must be a rolling one"):
        strips_at(hh.Scenario(start=hh.Start(angle=0.1), duration=1.0))
