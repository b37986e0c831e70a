"""`hophoop gait` and `hophoop diagram`."""

import json
import math

import pytest

from cli_tools import done

HOP = "gait --slope-deg 3 --gamma 0.5 --near 8.68"
DIAGRAM = "diagram --axis plane.slope=0.01:0.02:3 --gamma 0.75 --gravity 1"
FOLLOW = "gait --slope-deg 1 --gamma 0.75 --gravity 1 --near 3.41 --follow plane.slope=0.017:0.0175"


def test_the_table_and_the_json_have_the_gait():
    said = done(HOP).stdout
    assert all(word in said for word in ("RSHKR", "-0.768024", "8.68061442"))
    found = json.loads(done(f"{HOP} --json").stdout)
    assert found["schema"] == "hophoop-gaits/1"
    (gait,) = found["gaits"]
    assert gait["multipliers"][0][0] == pytest.approx(-0.768024180087, rel=1e-9)
    gain = 9.81 * math.sin(math.radians(3)) * gait["distance"]
    assert sum(gait["losses"].values()) == pytest.approx(gain, rel=1e-9)


def test_a_diagram_is_written_and_drawn(tmp_path):
    pytest.importorskip("matplotlib")
    out, picture = tmp_path / "d.csv", tmp_path / "d.png"
    assert "3 values of plane.slope" in done(DIAGRAM, "--out", out, "--plot", picture).stderr
    assert out.read_text(encoding="utf-8").startswith("plane.slope,fate,sequence,period")
    assert picture.stat().st_size > 5_000


def test_a_branch_is_followed_and_drawn_and_in_the_json(tmp_path):
    pytest.importorskip("matplotlib")
    picture = tmp_path / "branch.png"
    said = done(FOLLOW, "--plot", picture).stdout.splitlines()
    assert [line.split()[4] for line in said if "limit of the range" in line] == ["0.017", "0.0175"]
    branch = json.loads(done(f"{FOLLOW} --json").stdout)["branch"]
    assert branch["path"] == "plane.slope"
    assert [one["kind"] for one in branch["special"]] == 2 * ["limit of the range"]
    assert picture.stat().st_size > 5_000
