"""`hophoop prove`: what it prints and writes, and its exit status."""

import json
from decimal import Decimal

import pytest

from cli_tools import done

pytest.importorskip("flint")

HOP = "prove --v0 3.1 --duration 2 --digits 12"


def test_it_prints_enclosures_and_writes_them(tmp_path):
    path = tmp_path / "hop.json"
    said = done(HOP, "--out", path).stdout
    assert "5.508908425382 ± 3e-13" in said or "5.508908425382 ± 2e-13" in said
    assert "phases  RKRSHR\nverdict proved" in said
    written = json.loads(path.read_text(encoding="utf-8"))
    assert written == json.loads(done(f"{HOP} --json").stdout)
    assert (written["schema"], written["verdict"], written["ending"]) == ("hophoop-proof/2", "proved", "duration")
    takeoff = written["events"][4]
    middle, radius = map(Decimal, takeoff["angle"])
    assert takeoff["kind"] == "takeoff"
    assert abs(middle - Decimal("5.508908425381762464555592")) <= radius < Decimal("1e-12")


def test_what_is_undecided_ends_with_status_1(tmp_path):
    assert "massless" in done("prove --gamma 1", "--out", tmp_path / "none.json", status=1).stderr
    assert json.loads((tmp_path / "none.json").read_text(encoding="utf-8"))["verdict"] == "undecided"


def test_thresholds_to_thirty_digits():
    line = "prove --thresholds immediate_hop_speed --digits 30"
    (one,) = json.loads(done(f"{line} --json").stdout)["thresholds"]
    assert Decimal(one["radius"]) < Decimal("1e-29")
    assert one["middle"].startswith("3.6166282640050")
    assert f"{one['middle']} ± " in done(line).stdout


def test_a_threshold_that_cannot_be_shown():
    for words, sentence in (
        ("--mu inf --thresholds first_slip_speed", "first_slip_speed: friction is infinite."),
        ("--v0 3.1 --thresholds needed_friction", "needed_friction: no friction is enough, for the hoop would leave"),
        ("--angle 1 --thresholds needed_friction", "needed_friction: the start is not a rolling one with the load up."),
    ):
        assert done(f"prove {words}", status=1).stderr.startswith(f"Undecided: {sentence}")
