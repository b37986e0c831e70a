"""`hophoop gait`."""

import json
import math

import pytest

from cli_tools import run

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
    assert gait["word"] == ["RSHKR"]
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
        (["--digits", "3"], "--digits = 3 must be an integer from 16 to 40"),
    ],
)
def test_bad_input_ends_with_one_sentence(arguments, message):
    found = run(*HOP, *arguments)
    assert found.exit_code == 2
    assert message in found.stderr
    assert len(found.stderr.strip().splitlines()) == 1
