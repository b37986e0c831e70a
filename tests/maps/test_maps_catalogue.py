"""The shipped catalogue: its examples do what they say, its areas add up, and its script makes it."""

import importlib.util
import json
from pathlib import Path

import numpy as np
import pytest

import hophoop as hh
from hophoop import maps

ROOT = Path(__file__).parents[2]


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
        # regions that fill next to nothing may lie within rounding of their border
        if entry.area > 1e-6:
            assert (sequence, ending) == (entry.sequence, entry.ending)


def test_an_example_is_a_scenario():
    entry = next(entry for entry in maps.catalogue() if entry.sequence == "RSKSR")
    motion = hh.simulate(entry.scenario())
    assert motion.sequence.startswith("RSKSR")


@pytest.mark.parametrize("gamma", maps.catalogued())
def test_areas_fill_the_window(gamma):
    entries = maps.catalogue(gamma)
    assert sum(entry.area for entry in entries) == pytest.approx(1.0, abs=2e-3)
    assert len({(entry.sequence, entry.ending) for entry in entries}) == len(entries)
    assert [entry.area for entry in entries] == sorted((entry.area for entry in entries), reverse=True)


def test_no_motion_is_missing_from_the_catalogue():
    rng = np.random.default_rng(11)
    values = {"plane.mu": rng.uniform(0.001, 2.0, 20000), "start.speed": rng.uniform(0.001, 3.8, 20000)}
    # half of them where the classes are many
    values["plane.mu"][::2] *= 0.2
    found = maps.points(None, values, ["sequence", "ending"])
    pairs = set(zip(found["sequence"].tolist(), found["ending"].tolist(), strict=True))
    known = {(entry.sequence, entry.ending) for entry in maps.catalogue()}
    assert pairs <= known
    assert len(pairs) > 25


def test_the_script_makes_it(tmp_path, monkeypatch, capsys):
    spec = importlib.util.spec_from_file_location("make_catalogue", ROOT / "examples" / "make_catalogue.py")
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)
    monkeypatch.setattr(script, "HOOPS", (0.75,))
    out = tmp_path / "catalogue.json"
    monkeypatch.setattr("sys.argv", ["make_catalogue.py", "--levels", "3", "--cells", "32", "--out", str(out)])
    script.main()
    made = json.loads(out.read_text(encoding="utf-8"))["hoops"]["0.75"]["entries"]
    shipped = {(entry.sequence, entry.ending): entry for entry in maps.catalogue()}
    coarse = {(entry["sequence"], entry["ending"]): entry for entry in made}
    assert set(coarse) <= set(shipped)
    assert len(coarse) > 28
    for key, entry in coarse.items():
        assert abs(entry["area"] - shipped[key].area) <= entry["uncertainty"] + 1e-4
    assert "sequences" in capsys.readouterr().out


def test_the_page_counts_what_the_data_hold():
    page = (ROOT / "docs" / "catalogue.md").read_text(encoding="utf-8")
    entries = maps.catalogue()
    sequences = {entry.sequence for entry in entries}
    assert f"{len(sequences)} sequences, {len(entries)} with their endings" in page
    for entry in entries:
        assert f"| {entry.sequence} | {entry.ending} |" in page


def test_an_unknown_hoop():
    with pytest.raises(ValueError, match=r"load_fraction = 0\.77 must be one of"):
        maps.catalogue(0.77)
