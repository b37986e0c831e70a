"""What a caller sees of motions in many digits: results, text, JSON, refusals, the command line."""

import json

import pytest

import hophoop as hh
from cli_tools import HOP, done
from hophoop.precise import solve
from precise_tools import rolling


def test_digits_asked_are_digits_got():
    """15, 30 and 50 digits of one motion begin alike."""
    texts = [str(rolling(2.8, 0.3, digits=digits).events[-1].angle) for digits in (15, 30, 50)]
    assert texts[2].startswith(texts[1][:-2])
    assert texts[1].startswith(texts[0][:-2])
    assert len(texts[2]) > 45


def test_result_as_text_and_json():
    motion = rolling(3.1, duration=1.0, digits=20)
    assert "RKR" in repr(motion)
    assert "slip_start" in repr(motion)
    data = json.loads(json.dumps(motion.to_dict()))
    assert (data["schema"], data["digits"], data["sequence"]) == ("hophoop/1", 20, "RKRS")
    assert data["events"][1]["t"] == "0.26639349087571672725"
    assert data["events"][1]["digits_right"] >= 20
    assert motion.find("stick")[0].to_mode == "R"
    with pytest.raises(ValueError, match="stik"):
        motion.find("stik")


@pytest.mark.parametrize("digits", [14, 1001, 2.5, True, "30"])
def test_digits_out_of_range(digits):
    with pytest.raises(ValueError, match=r"digits = .* must be a whole number from 15 to 1000\.") as caught:
        rolling(1.0, digits=digits)
    assert "\n" not in str(caught.value)


def test_compliant_contact_has_no_more_digits():
    with pytest.raises(ValueError, match="needs rigid contact"):
        hh.simulate(hh.Scenario(contact=hh.Compliant()), digits=30)


def test_a_solution_that_stops():
    """`solve` stops after so many events or at a time in units of √(R/g)."""
    scenario = hh.Scenario(start=hh.Start.rolling(3.1))
    solution = solve(scenario, 20, max_events=3)
    assert [record.kind.name for record in solution.records] == ["START", "SLIP_START", "STICK"]
    assert float(solution.records[2].state.t * solution.body.time) == pytest.approx(
        hh.simulate(scenario).events[2].t, rel=1e-13
    )
    assert float(solve(scenario, 20, until=0.5).records[-1].state.t) == 0.5


def test_run_with_digits():
    assert "0.266393490875716727249363892232" in done(f"{HOP} --digits 30").stdout
    data = json.loads(done(f"{HOP} --digits 20 --json").stdout)
    assert data["events"][1]["t"] == "0.26639349087571672725"


def test_run_check():
    """Every event has at least 13 digits right here."""
    assert "digits of every number are right" in done(f"{HOP} --check").stdout
    data = json.loads(done(f"{HOP} --check --json").stdout)
    assert data["difference"] == ""
    assert all(event["digits"]["t"] > 13 for event in data["events"])
