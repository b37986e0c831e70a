"""The shipped catalogue and docs/atlas.md: their examples do what they say."""

import json
import runpy
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest

import hophoop as hh
from hophoop import maps

ROOT = Path(__file__).parents[2]
NEAR = (1e-4, 1e-6, 1e-8)  # relative distances from a meeting: of wedges some are thin, and some short
HOOPS = json.loads(files("hophoop.maps").joinpath("catalogue.json").read_text(encoding="utf-8"))["hoops"]


@pytest.mark.parametrize("gamma", maps.catalogued())
def test_examples_do_what_they_say(gamma):
    entries = maps.catalogue(gamma)
    place = {"plane.mu": [entry.mu for entry in entries], "start.speed": [entry.speed for entry in entries]}
    found = maps.points(None, {"hoop.load_fraction": gamma, **place}, ["sequence", "ending"])
    for entry, sequence, ending in zip(entries, found["sequence"], found["ending"], strict=True):
        assert (sequence, ending) == (entry.sequence, entry.ending)
    # after a change of the kernels' bits: `python tests/data/catalogue_fingerprints.py`
    assert [one for one in entries if hh.simulate(one.scenario()).fingerprint != one.fingerprint] == []
    assert sum(entry.area for entry in entries) == pytest.approx(1.0, abs=2e-4)  # each to four digits
    assert [entry.area for entry in entries] == sorted((entry.area for entry in entries), reverse=True)


@pytest.mark.parametrize("gamma", [0.2, 0.48, 0.75, 0.9])
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


def test_classes_meet_where_the_catalogue_says():
    """Motions close to a meeting show all its classes."""
    inner = [one for one in HOOPS["0.75"]["meetings"] if len(one[2]) == 4]
    assert len(inner) > 20
    random = np.random.default_rng(3)
    for x, y, classes in inner[::3]:
        seen = set()
        for reach in NEAR:
            mu, speed = (value * (1.0 + reach * random.uniform(-1.0, 1.0, 2000)) for value in (x, y))
            found = maps.points(None, {"plane.mu": mu, "start.speed": speed}, ["sequence", "ending"])
            seen |= {f"{sequence} {ending}" for sequence, ending in zip(found["sequence"], found["ending"], strict=True)}
        assert seen >= set(classes), (x, y)


def test_the_atlas_holds_what_is_computed():
    atlas = runpy.run_path(str(ROOT / "examples" / "figures" / "atlas.py"))
    page = (ROOT / "docs" / "atlas.md").read_text(encoding="utf-8")
    rows = [line.strip("| ").split(" | ") for line in page.splitlines() if line.startswith(("| highest", "| longest"))]
    for (what, hop, *place), (quantity, most_friction) in zip(rows, atlas["OPTIMA"], strict=True):
        assert what == f"{atlas['WORDS'][quantity]}, μ up to {most_friction:g}"
        assert hop == f"{float(atlas['hops'](quantity, *map(float, place))):.3f} m"


def test_an_unknown_hoop():
    with pytest.raises(ValueError, match=r"load_fraction = 0\.77 must be one of"):
        maps.catalogue(0.77)
