"""Maps of what becomes of motions in the end, against single motions."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.vocabulary.names import Fate, identifier

pytest.importorskip("xarray")

LEVEL = hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=hh.Plane(gravity=1.0))
SLOPE = LEVEL.replace("start", hh.Start.rolling(3.0, angle=math.pi))


def lost_in(scenario):
    ledger = hh.simulate(scenario.replace("duration", 400.0)).ledger
    return ledger.friction + ledger.impact_normal + ledger.impact_tangential + ledger.rolling_resistance


def test_the_fate_of_a_cell_is_that_of_its_motion():
    rng = np.random.default_rng(3)
    mu, speed = rng.uniform(0.05, 2.0, 60), rng.uniform(0.05, 4.0, 60)
    found = hh.maps.points(LEVEL, {"plane.mu": mu, "start.speed": speed}, ["fate", "final_loss"], span="settled")
    assert hh.maps.points(LEVEL, {"start.speed": [0.0]}, ["final_loss"], span="settled")["final_loss"] == [0.0]  # it rests
    for k in range(60):
        scenario = LEVEL.replace("plane.mu", float(mu[k])).replace("start", hh.Start.rolling(float(speed[k])))
        fate = hh.gaits.fates([scenario]).fates[0]
        assert found["fate"][k] == identifier(fate)
        lost = found["final_loss"][k]
        if fate in (Fate.ROLLS_AHEAD, Fate.ROLLS_BACK):
            assert lost == pytest.approx(lost_in(scenario), rel=1e-9, abs=1e-12)
        elif fate == Fate.SLIPS_EVER_LESS:
            assert lost > lost_in(scenario)
        elif not math.isnan(lost):
            assert fate == Fate.ROCKS
            assert lost == pytest.approx(lost_in(scenario), rel=1e-9, abs=1e-12)


def test_slip_that_falls_for_ever_loses_what_is_above_the_fastest_rolling():
    """A revolution n loses as 1/n², so that the sum is finite: the start's energy above that of the first slip."""
    mass, speeds = 3.0, [0.55, 0.7, 1.65]
    base = LEVEL.replace("hoop", hh.Hoop.ideal(0.75, radius=0.5, mass=mass))
    found = hh.maps.points(base, {"start.speed": speeds}, ["fate", "final_loss"], span="settled")
    first = float(hh.theory.first_slip_speed(base.hoop, base.plane))
    for speed, fate, final in zip(speeds, found["fate"], found["final_loss"], strict=True):
        assert fate == "slips_ever_less"
        assert final == pytest.approx(mass * (1.0 + 0.75) * (speed**2 - first**2), rel=1e-9)
        # what is left after 1,000 revolutions is a thousandth
        passages = hh.passages(base.replace("start", hh.Start.rolling(speed)), 1000)
        lost = sum(passages.loss(name).sum() for name in ("friction", "impact_normal", "impact_tangential"))
        assert 0.0 < final - lost < 0.01 * mass


def test_numbers_of_gaits_and_chaos():
    slopes = np.radians([0.5, 1.18, 4.0, 10.0])
    names = ["fate", "period", "hops", "revolutions", "mean_speed", "final_hop_height", "lyapunov", "final_loss"]
    found = hh.maps.points(SLOPE.replace("start.speed", 3.45), {"plane.slope": slopes}, names, span="settled")
    assert found["fate"].tolist() == ["gait", "gait", "chaotic", "rocks"]
    assert found["period"].tolist() == [1, 2, 0, 0]
    assert found["hops"].tolist() == [0, 2, 0, 0]
    for k, near in ((0, 3.31), (1, 3.46)):
        case = SLOPE.replace("plane.slope", float(slopes[k]))
        gait = next(gait for gait in hh.gaits.find(case, k + 1, near=near) if gait.stable)
        assert found["mean_speed"][k] == pytest.approx(gait.speed, rel=1e-8)
        assert found["final_hop_height"][k] == pytest.approx(gait.hop_height, rel=1e-6, abs=1e-12)
    assert found["lyapunov"][2] == pytest.approx(0.575, abs=0.06)
    assert np.isnan(found["lyapunov"][[0, 1, 3]]).all()
    assert np.isnan(found["final_loss"][:3]).all()
    assert (found["revolutions"] > 3).all()


def test_landings():
    light = hh.Scenario(hoop=hh.Hoop.ideal(0.15), plane=hh.Plane(slope=math.radians(3), gravity=1.0))
    speeds = {"start.speed": [3.5, 6.1]}
    found = hh.maps.points(light, speeds, ["fate", "mean_speed", "period"], span="settled:landing")
    assert found["fate"].tolist() == ["gait", "gait"]
    assert found["mean_speed"] == pytest.approx([3.34154, 5.65743], rel=2e-6)


@pytest.mark.parametrize(
    ("base", "names", "span", "message"),
    [
        (LEVEL, ["fate"], "first_revolution", "span = 'first_revolution' must be settled or .* with quantity fate"),
        (LEVEL, ["hop"], "settled", "span = 'settled' must be first_revolution, .* with quantity hop"),
        (LEVEL.replace("plane.gravity", 0.0), ["fate"], "settled", "plane.gravity = 0.0 must be above 0"),
        (LEVEL.replace("contact", hh.Compliant()), ["fate"], "settled", "contact.model"),
        (LEVEL, ["fates"], "settled", "quantity = 'fates' must be one of"),
    ],
)
def test_refusals(base, names, span, message):
    with pytest.raises(ValueError, match=message):
        hh.maps.sweep(base, {"plane.mu": [0.1, 0.2], "start.speed": [1.0, 2.0]}, names, span=span)
    if "contact" not in message:
        with pytest.raises(ValueError, match=message):
            hh.maps.points(base, {"plane.mu": [0.1, 0.2]}, names, span=span)
