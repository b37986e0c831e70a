"""`hophoop gait`."""

import json
import math
from functools import wraps

import pytest

from cli_tools import run
from hophoop.gaits import finding

HOP = ["gait", "--slope-deg", "3", "--gamma", "0.5", "--near", "8.68"]


def test_the_table_has_the_gait():
    found = run(*HOP)
    assert found.exit_code == 0
    assert "RSHKR" in found.stdout
    assert "-0.768024" in found.stdout
    assert "8.68061442" in found.stdout


def test_json_is_the_whole_gait():
    found = json.loads(run(*HOP, "--json").stdout)
    assert found["schema"] == "hophoop-gaits/1"
    (gait,) = found["gaits"]
    assert gait["sequence"] == "RSHKR"
    assert gait["multipliers"][0][0] == pytest.approx(-0.768024180087, rel=1e-9)
    gain = 9.81 * math.sin(math.radians(3)) * gait["distance"]
    assert sum(gait["losses"].values()) == pytest.approx(gain, rel=1e-9)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--period", "70"], "--period = 70 must be an integer from 1 to 64."),
        (["--section", "top"], "--section = 'top' must be one of bottom, landing."),
        (["--slope-deg", "0"], "plane.slope = 0.0 must be other than 0"),
        (["--near", "2"], "No gait of period 1 was found"),
        (["--gamma", "0"], "hoop.load_fraction = 0.0 must be above 0"),
    ],
)
def test_bad_input_ends_with_one_sentence(arguments, message):
    found = run(*HOP, *arguments)
    assert found.exit_code == 2
    assert message in found.stderr
    assert len(found.stderr.strip().splitlines()) == 1


DIAGRAM = ["diagram", "--axis", "plane.slope=0.01:0.02:3", "--gamma", "0.75", "--gravity", "1"]


def test_a_diagram_is_written_and_drawn(tmp_path):
    pytest.importorskip("matplotlib", reason="the extra 'plots' is not installed")
    out, picture = tmp_path / "d.csv", tmp_path / "d.png"
    found = run(*DIAGRAM, "--out", out, "--plot", picture)
    assert found.exit_code == 0, found.stderr
    assert "3 values of plane.slope" in found.stderr
    assert out.read_text(encoding="utf-8").startswith("plane.slope,fate,sequence,period")
    assert picture.stat().st_size > 5_000


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "--out or --plot must name a file"),
        (["--out", "d.txt"], "--out = d.txt must end in .nc or .csv."),
        (["--out", "d.csv", "--passages", "3"], "--passages = 3 must be an integer from 650"),
        (["--out", "d.csv", "--axis", "plane.impact_law=newton,stronge"], "must have numbers"),
        (["--out", "d.csv", "--axis", "plane.tilt=1:2:3"], "plane.tilt"),
    ],
)
def test_bad_input_of_a_diagram(arguments, message, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = run(*DIAGRAM, *arguments)
    assert found.exit_code == 2
    assert message in found.stderr
    assert not list(tmp_path.iterdir())


FOLLOW = ["gait", "--slope-deg", "1", "--gamma", "0.75", "--gravity", "1", "--near", "3.41"]


def test_a_branch_is_followed_and_drawn(tmp_path):
    pytest.importorskip("matplotlib", reason="the extra 'plots' is not installed")
    picture = tmp_path / "branch.png"
    found = run(*FOLLOW, "--follow", "plane.slope=0.01:0.03", "--plot", picture)
    assert found.exit_code == 0, found.stderr
    assert "0.0203717918" in found.stdout
    assert picture.stat().st_size > 5_000
    branch = json.loads(run(*FOLLOW, "--follow", "plane.slope=0.01:0.03", "--json").stdout)["branch"]
    assert branch["path"] == "plane.slope"
    assert sum(one["kind"] == "fold" for one in branch["special"]) == 2


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--plot", "b.png"], "--plot needs --follow"),
        (["--follow", "plane.slope"], "--follow = 'plane.slope' must be PATH=LOW:HIGH"),
        (["--follow", "plane.slope=a:b"], "must be PATH=LOW:HIGH"),
        (["--follow", "plane.slope=0.1:0.2"], "on both sides of plane.slope"),
        (["--follow", "plane.slope=nan:0.2"], "must be finite"),
        (["--follow", "plane.slope=0.2:0.001"], "on both sides of plane.slope"),
        (["--follow", "plane.slope=-0.1:0.2"], "slopes of one sign"),
        (["--follow", "plane.tilt=0.001:0.2"], "plane.tilt is not a known key; did you mean slope?"),
        (["--follow", "plane.gravity=0.5:2"], "a parameter other than hoop.radius, hoop.mass and plane.gravity"),
        (["--digits", "3"], "--digits = 3 must be an integer from 16 to 40"),
    ],
)
def test_what_cannot_be_followed_is_refused_before_the_search(arguments, message, monkeypatch):
    monkeypatch.setattr(finding, "find", wraps(finding.find)(lambda *_, **__: pytest.fail("it looks for gaits")))
    found = run(*FOLLOW, *arguments)
    assert found.exit_code == 2
    assert message in found.stderr
