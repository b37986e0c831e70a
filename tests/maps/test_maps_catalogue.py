"""The shipped catalogue: its examples do what they say, its areas add up, and the page has its numbers."""

import importlib.util
import json
import math
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

import hophoop as hh
from hophoop import maps, theory
from oracles.cases import rolling
from oracles.precise import solve

ROOT = Path(__file__).parents[2]
NEAR = (1e-4, 1e-6, 1e-8)  # relative distances from a meeting: of wedges some are thin, and some short
HOOPS = json.loads(files("hophoop.maps").joinpath("catalogue.json").read_text(encoding="utf-8"))["hoops"]


def script(path):
    """A script of the source folder as a module."""
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


FIGURES = script(ROOT / "examples" / "catalogue_figures.py")
FINGERPRINTS = script(ROOT / "tests" / "data" / "catalogue_fingerprints.py")


def class_in_digits(gamma, mu, speed, digits=40):
    """Sequence and ending of the first revolution, from Taylor series in so many digits."""
    hoop = hh.Hoop.ideal(gamma)
    place = {"hoop.load_fraction": gamma, "plane.mu": mu, "start.speed": speed}
    duration = 1.1 * float(maps.points(None, place, ["time"])["time"]) + 0.5
    case = rolling("checked", speed, mu, eccentricity=gamma, inertia_ratio=hoop.inertia_ratio, duration=duration)
    sequence = ""
    for event in solve(case, digits).events:
        if event["angle"] > 2 * math.pi:
            return sequence, "revolutions"
        if event["kind"] == "turn":
            return sequence, "reversal"
        if event["kind"] != "end":
            sequence += event["to"]
            if sequence[-1] == "H":
                return sequence, "takeoff"
    return sequence, "unended"


@pytest.mark.parametrize("gamma", maps.catalogued())
def test_examples_do_what_they_say(gamma):
    entries = maps.catalogue(gamma)
    found = maps.points(
        hh.Scenario(),
        {
            "hoop.load_fraction": gamma,
            "plane.mu": [entry.mu for entry in entries],
            "start.speed": [entry.speed for entry in entries],
        },
        ["sequence", "ending"],
    )
    for entry, sequence, ending in zip(entries, found["sequence"], found["ending"], strict=True):
        assert (sequence, ending) == (entry.sequence, entry.ending)
    # after a change of the kernels' bits: `python tests/data/catalogue_fingerprints.py`
    assert [one for one in entries if hh.simulate(one.scenario()).fingerprint != one.fingerprint] == []


def test_fingerprints_are_renewed(tmp_path):
    stored = {"hophoop": hh.__version__, "hoops": {"0.02": HOOPS["0.02"], "0.999": HOOPS["0.999"]}}
    out = tmp_path / "catalogue.json"
    stale = json.loads(json.dumps(stored))
    del stale["hoops"]["0.02"]["entries"][0]["fingerprint"]
    stale["hoops"]["0.999"]["entries"][-1]["fingerprint"] = "0123456789abcdef"
    out.write_text(json.dumps(stale), encoding="utf-8")
    assert FINGERPRINTS.renew(out).startswith("2 fingerprints of ")
    assert json.loads(out.read_text(encoding="utf-8")) == stored


@pytest.mark.parametrize("gamma", maps.catalogued())
def test_areas_fill_the_window(gamma):
    entries = maps.catalogue(gamma)
    assert sum(entry.area for entry in entries) == pytest.approx(1.0, abs=2e-4)  # each to four digits
    assert len({(entry.sequence, entry.ending) for entry in entries}) == len(entries)
    assert [entry.area for entry in entries] == sorted((entry.area for entry in entries), reverse=True)
    for entry in entries:
        assert 0.0 < entry.width < 1.0
        # an example in the middle of a cross so wide and high; the region about it may be thinner
        assert entry.area > 0.0


def test_every_difference_was_followed_and_explained():
    for gamma, hoop in HOOPS.items():
        assert hoop["complete"], gamma
        assert hoop["unexplained"] == [], gamma


@pytest.mark.parametrize("gamma", [0.2, 0.48, 0.6, 0.75, 0.9])
def test_no_motion_is_missing_from_the_catalogue(gamma):
    """Starts all over the window, and by ratio, close to the edges of friction and speed."""
    rng = np.random.default_rng(5)
    mu, speed = (
        np.concatenate([rng.uniform(0.001, most, 10000), 10.0 ** rng.uniform(*decades, 10000)])
        for most, decades in ((2.0, (-5.5, 0.0)), (3.8, (-4.0, 0.5)))
    )
    values = {"hoop.load_fraction": gamma, "plane.mu": mu, "start.speed": speed}
    found = maps.points(None, values, ["sequence", "ending"])
    pairs = set(zip(found["sequence"].tolist(), found["ending"].tolist(), strict=True))
    assert pairs <= {(entry.sequence, entry.ending) for entry in maps.catalogue(gamma)}
    assert len(pairs) > 15


def meeting(*sequences):
    found = [(x, y) for x, y, classes in HOOPS["0.75"]["meetings"] if {one.split(" ")[0] for one in classes} == set(sequences)]
    assert len(found) == 1
    return found[0]


def test_where_rolling_alone_begins():
    """Where the first slip is at the least speed of the window."""

    def excess(mu):
        return float(theory.first_slip_speed(hh.Hoop.ideal(0.75), hh.Plane(mu=mu))) - HOOPS["0.75"]["speed_range"][0]

    mu, speed = meeting("R", "RKRSR")
    assert mu == pytest.approx(brentq(excess, 0.377, 0.38, xtol=1e-16), rel=1e-11)
    assert speed == pytest.approx(HOOPS["0.75"]["speed_range"][0], rel=1e-5)


def test_where_a_hop_meets_the_immediate_one():
    assert meeting("H", "RKSH", "RKRSH")[1] == pytest.approx(math.sqrt(9.81 / 0.75), rel=1e-10)


def test_classes_meet_where_the_catalogue_says():
    """Motions close to a meeting show all its classes."""
    inner = [one for one in HOOPS["0.75"]["meetings"] if len(one[2]) == 4]
    assert len(inner) > 20
    random = np.random.default_rng(3)
    for x, y, classes in inner:
        seen = set()
        for reach in NEAR:
            mu, speed = (value * (1.0 + reach * random.uniform(-1.0, 1.0, 2000)) for value in (x, y))
            found = maps.points(None, {"plane.mu": mu, "start.speed": speed}, ["sequence", "ending"])
            seen |= {f"{sequence} {ending}" for sequence, ending in zip(found["sequence"], found["ending"], strict=True)}
        assert seen >= set(classes), (x, y)


@pytest.mark.long
def test_a_narrow_class_in_forty_digits():
    entry = min(maps.catalogue(), key=lambda entry: entry.width)
    assert class_in_digits(0.75, entry.mu, entry.speed) == (entry.sequence, entry.ending)


def test_the_page_holds_the_tables_of_the_data(capsys):
    page = (ROOT / "docs" / "catalogue.md").read_text(encoding="utf-8")
    FIGURES.print_tables()
    for line in capsys.readouterr().out.splitlines():
        assert line in page
    sequences, endings = FIGURES.counts(0.75, 0.0)
    assert f"{sequences} sequences, {endings} with their endings" in page
    assert "{} sequences, {} with their endings".format(*FIGURES.union(0.0)) in page


def test_an_unknown_hoop():
    with pytest.raises(ValueError, match=r"load_fraction = 0\.77 must be one of"):
        maps.catalogue(0.77)
