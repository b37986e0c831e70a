"""Maps of what becomes of motions in the end, against single motions."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.vocabulary.colors import CODES
from hophoop.vocabulary.names import Fate, identifier

pytest.importorskip("xarray", reason="the extra 'maps' is not installed")

LEVEL = hh.Scenario(hoop=hh.Hoop.ideal(0.75), plane=hh.Plane(gravity=1.0))
SLOPE = LEVEL.replace("start", hh.Start.rolling(3.0, angle=math.pi))


def swept(base, axes, quantities, **options):
    return hh.maps.sweep(base, axes, quantities, span="settled", **options)


def lost_in(scenario):
    ledger = hh.simulate(scenario.replace("duration", 400.0)).ledger
    return ledger.friction + ledger.impact_normal + ledger.impact_tangential + ledger.rolling_resistance


def test_the_fate_of_a_cell_is_that_of_its_motion():
    rng = np.random.default_rng(3)
    mu, speed = rng.uniform(0.05, 2.0, 60), rng.uniform(0.05, 4.0, 60)
    found = hh.maps.points(LEVEL, {"plane.mu": mu, "start.speed": speed}, ["fate", "final_loss"], span="settled")
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


@pytest.mark.parametrize("mass", [1.0, 3.0])
def test_slip_that_falls_for_ever_loses_what_is_above_the_fastest_rolling(mass):
    """A revolution n loses as 1/n², so that the sum is finite: the start's energy above that of the first slip."""
    base = LEVEL.replace("hoop", hh.Hoop.ideal(0.75, radius=0.5, mass=mass))
    speeds = [0.55, 0.7, 1.65]
    found = hh.maps.points(base, {"start.speed": speeds}, ["fate", "final_loss"], span="settled")
    first = float(hh.theory.first_slip_speed(base.hoop, base.plane))
    for k, speed in enumerate(speeds):
        assert found["fate"][k] == "slips_ever_less"
        passages = hh.passages(base.replace("start", hh.Start.rolling(speed)), 4000)
        lost = sum(passages.loss(name).sum() for name in ("friction", "impact_normal", "impact_tangential"))
        final = found["final_loss"][k]
        assert final == pytest.approx(mass * (1.0 + 0.75) * (speed**2 - first**2), rel=1e-9)
        # what is left is the excess x of θ̇, with m R² D θ̇ x to come
        omega = math.sqrt((1.75 * first**2 + 2 * 0.75 * 0.5) / 0.25) / 0.5
        left = mass * 0.5**2 * 2.0 * 0.25 * omega * (passages.omega[-1] - omega)
        assert final - lost == pytest.approx(left, rel=1e-2)
        assert 0.0 < left < 2e-3 * mass


def test_a_hoop_that_rests_at_once_loses_nothing():
    found = hh.maps.points(LEVEL, {"start.speed": [0.0]}, ["fate", "final_loss"], span="settled")
    assert (found["fate"][0], found["final_loss"][0]) == ("rests", 0.0)


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


def test_units():
    small = hh.Scenario(hoop=hh.Hoop.ideal(0.5, radius=0.3, mass=2.0), plane=hh.Plane(slope=math.radians(3)))
    found = hh.maps.points(small, {"start.speed": [1.5]}, ["mean_speed", "final_hop_height"], span="settled")
    assert found["mean_speed"][0] == pytest.approx(1.8613658 * math.sqrt(0.3 * hh.Plane().gravity), rel=1e-6)
    assert found["final_hop_height"][0] == pytest.approx(0.3 * 0.1230255, rel=1e-6)


def test_a_map_is_the_same_in_memory_in_a_file_and_resumed(tmp_path):
    axes = {"plane.mu": np.linspace(0.1, 1.5, 12), "start.speed": np.linspace(0.1, 4.0, 15)}
    names = ["fate", "revolutions", "mean_speed"]
    alone = swept(LEVEL, axes, names, threads=1)
    kept = swept(LEVEL, axes, names, out=tmp_path / "map.zarr", chunk_cells=40)
    again = swept(LEVEL, axes, names, out=tmp_path / "map.zarr", resume=True, chunk_cells=40)
    for name in names:
        assert np.array_equal(alone[name], kept[name], equal_nan=True)
        assert np.array_equal(alone[name], again[name], equal_nan=True)
    assert hh.maps.words_of(kept["fate"])[0] == "rolls_ahead"


def test_landings():
    light = hh.Scenario(hoop=hh.Hoop.ideal(0.15), plane=hh.Plane(slope=math.radians(3), gravity=1.0))
    speeds = {"start.speed": [3.5, 6.1]}
    found = hh.maps.points(light, speeds, ["fate", "mean_speed", "period"], span="settled:landing")
    assert found["fate"].tolist() == ["gait", "gait"]
    assert found["mean_speed"] == pytest.approx([3.34154, 5.65743], rel=2e-6)


def test_sections_do_not_contradict_each_other():
    """On slopes many motions turn back in rolling; what then goes on at the bottom does at landings."""
    slopes, loads = np.meshgrid(np.radians(np.linspace(0.2, 20.0, 14)), np.linspace(0.3, 0.95, 14))
    axes = {"plane.slope": slopes.ravel(), "hoop.load_fraction": loads.ravel()}
    base = SLOPE.replace("start", hh.Start.rolling(3.0))
    names = ["fate", "mean_speed"]
    bottom, landing = (hh.maps.points(base, axes, names, span=span) for span in ("settled", "settled:landing"))
    lasts, rocks = ({"gait", "chaotic", "runs_away"}, {"rocks"})
    pairs = set(zip(bottom["fate"], landing["fate"], strict=True))
    assert not any((one in lasts and other in rocks) or (one in rocks and other in lasts) for one, other in pairs)
    both = (bottom["fate"] == "gait") & (landing["fate"] == "gait")
    assert both.sum() > 40
    assert bottom["mean_speed"][both] == pytest.approx(landing["mean_speed"][both], rel=1e-6)
    assert ("rocks", "rocks") in pairs


def test_colours_of_all_fates():
    assert set(CODES["fate"]) == {identifier(fate) for fate in Fate}
    assert len(set(CODES["fate"].values())) == len(Fate)


@pytest.mark.parametrize(
    ("base", "names", "span", "message"),
    [
        (
            LEVEL,
            ["fate"],
            "first_revolution",
            "span = 'first_revolution' must be settled or settled:landing with quantity fate",
        ),
        (LEVEL, ["hop"], "settled", "span = 'settled' must be first_revolution, .* with quantity hop"),
        (LEVEL, ["fate", "hop"], "settled", "with quantity hop"),
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


def test_boundaries_refuse_the_span():
    with pytest.raises(ValueError, match="span = 'settled' must be one of"):
        hh.maps.boundary(LEVEL, {"plane.mu": (0.1, 1.0), "start.speed": (1.0, 2.0)}, (0.5, 1.5), (0.5, 1.9), span="settled")
