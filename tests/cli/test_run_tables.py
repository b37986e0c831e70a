"""Tables of `hophoop run`: what is left out of long ones, and errors of events."""

import re

import pytest

import hophoop as hh
from cli_tools import HOP, done, hop, run


@pytest.mark.parametrize("words", ["", "--errors", "--digits 16", "--check"])
def test_a_long_table_says_what_it_leaves_out(monkeypatch, words):
    monkeypatch.setattr("hophoop.cli._motion.FIRST_ROWS", 3)
    monkeypatch.setattr("hophoop.cli._motion.LAST_ROWS", 2)
    events = [event.kind.replace("_", " ") for event in hop().events]
    rows = re.compile(rf"^.*?\b({'|'.join(sorted(set(events), key=len, reverse=True))}) .*$", re.MULTILINE)
    brief, whole = (run(f"{HOP} {words} {more}").stdout for more in ("", "--all"))
    tables = 2 if words == "--errors" else 1
    assert brief.count("… 3 events are left out where the dots are; --all prints them.") == tables
    assert "left out" not in whole
    assert rows.findall(whole) == tables * events
    assert rows.findall(brief) == tables * [events[k] for k in (0, 1, 2, 6, 7)]


def test_an_explanation_that_is_cut_says_so(monkeypatch):
    monkeypatch.setattr("hophoop.cli._motion.FIRST_ROWS", 3)
    brief, whole = (run(f"{HOP} --explain {more}").stdout for more in ("", "--all"))
    said = "… These are the first 3 phases; --all explains the others, too.\n"
    assert brief.endswith(said)
    assert brief.count("begins with") == 3
    assert said not in whole
    assert whole.count("begins with") == len(list(hh.phases(hop().scenario)))


def test_errors_are_told_of_every_event():
    motion, found = hop(), hop().errors
    said = done(f"{HOP} --errors").stdout
    lines = said[said.index("± t (s)") :].splitlines()[2 : 2 + len(motion.events)]
    for line, event, *numbers in zip(lines, motion.events, found.t, found.angle, found.x, found.vx, found.omega, strict=True):
        assert line.split()[0] == f"{event.t:.15g}"
        assert line.split()[-5:] == [f"{number:.0e}" for number in numbers]


@pytest.mark.parametrize(
    ("query", "normal", "rolling"),
    [
        ("plane.rolling_resistance=0.01", "impacts, normal part", ", to rolling resistance {0.rolling_resistance:.6g} J"),
        ("contact.model=compliant&duration=1.5", "the damper", ""),
    ],
)
def test_what_is_lost_to_friction_is_what_the_page_says(query, normal, rolling, tmp_path):
    """Slip, and impacts along the plane; the diagram of the page draws the same column of the samples."""
    scenario = hh.Scenario.from_query(query)
    scenario.save(tmp_path / "scenario.toml")
    motion = hh.simulate(scenario)
    expected = (
        "lost: to friction {1:.6g} J (in slip {0.friction:.6g} J, in impacts {0.impact_tangential:.6g} J), "
        f"in {normal} {{0.normal_loss:.6g}} J{rolling}; residual"
    )
    said = " ".join(done("run", tmp_path / "scenario.toml").output.split())
    assert expected.format(motion.ledger, motion.at(motion.duration).friction_loss) in said
