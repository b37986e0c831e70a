"""Tables of `hophoop run`: what is left out of long ones, and errors of events."""

import json
import re

import pytest

import hophoop as hh
from cli_tools import HOP, done, hop, run


def test_a_long_table_says_what_it_leaves_out():
    line = "run --v0 2.8 --duration 60"
    count = len(hh.simulate(hh.Scenario(start=hh.Start.rolling(2.8), duration=60.0)).events)
    brief, whole = run(line).stdout, run(f"{line} --all").stdout
    assert f"… {count - 80} events are left out where the dots are; --all prints them." in brief
    times = re.compile(r"^ *\d+\.\d{6} ", re.MULTILINE)
    assert (len(times.findall(brief)), len(times.findall(whole))) == (80, count)
    assert "left out" not in whole
    assert times.findall(brief)[-20:] == times.findall(whole)[-20:]
    # JSON is the whole result in any case
    assert len(json.loads(run(f"{line} --json").stdout)["events"]) == count


@pytest.mark.parametrize("words", ["--errors", "--digits 16", "--check"])
def test_so_do_tables_of_errors_and_digits(monkeypatch, words):
    monkeypatch.setattr("hophoop.cli._motion.FIRST_ROWS", 3)
    monkeypatch.setattr("hophoop.cli._motion.LAST_ROWS", 2)
    events = hop().events
    kinds = sorted({event.kind.replace("_", " ") for event in events}, key=len, reverse=True)
    rows = re.compile(rf"^.*?\b({'|'.join(kinds)}) .*$", re.MULTILINE)
    brief, whole = (run(f"{HOP} {words} {more}").stdout for more in ("", "--all"))
    tables = 2 if words == "--errors" else 1
    assert len(events) == 8
    assert brief.count("… 3 events are left out where the dots are; --all prints them.") == tables
    assert "left out" not in whole
    shown, every = (rows.findall(text) for text in (brief, whole))
    assert every == tables * [event.kind.replace("_", " ") for event in events]
    assert shown == tables * [every[k] for k in (0, 1, 2, 6, 7)]


def test_an_explanation_that_is_cut_says_so(monkeypatch):
    monkeypatch.setattr("hophoop.cli._motion.FIRST_ROWS", 3)
    brief, whole = (run(f"{HOP} --explain {more}").stdout for more in ("", "--all"))
    said = "… These are the first 3 phases; --all explains the others, too.\n"
    assert brief.endswith(said)
    assert said not in whole
    assert brief.count("begins with") == 3
    assert whole.count("begins with") == len(list(hh.phases(hop().scenario)))
    monkeypatch.setattr("hophoop.cli._motion.FIRST_ROWS", whole.count("begins with"))
    assert said[:10] not in run(f"{HOP} --explain").stdout  # nothing is cut


def test_errors_are_told_of_every_event():
    motion = hop()
    said = done(f"{HOP} --errors").stdout
    lines = said[said.index("± t (s)") :].splitlines()[2 : 2 + len(motion.events)]
    for k, line in enumerate(lines):
        found = motion.errors
        numbers = (found.t[k], found.angle[k], found.x[k], found.vx[k], found.omega[k])
        assert line.split()[0] == f"{motion.events[k].t:.15g}"
        assert line.split()[-5:] == [f"{number:.0e}" for number in numbers]


LOSSES = re.compile(
    r"kinetic (?P<kinetic>\S+) J, potential (?P<potential>\S+) J; "
    r"lost: to friction (?P<friction>\S+) J \(in slip (?P<slip>\S+) J, in impacts (?P<along>\S+) J\), "
    r"in (?P<where>impacts, normal part|the damper) (?P<normal>\S+) J"
    r"(, to rolling resistance (?P<rolling>\S+) J)?; residual \S+ J"
)


@pytest.mark.parametrize(
    ("query", "where"),
    [
        ("", "impacts, normal part"),
        ("plane.rolling_resistance=0.01", "impacts, normal part"),
        ("contact.model=compliant&duration=1.5", "the damper"),
    ],
)
def test_what_is_lost_to_friction_is_what_the_page_says(query, where, tmp_path):
    """Slip, and impacts along the plane; the sum of all losses is what kinetic and potential energy lack."""
    scenario = hh.Scenario.from_query(query)
    scenario.save(tmp_path / "scenario.toml")
    found = LOSSES.search(" ".join(done("run", tmp_path / "scenario.toml").output.split()))
    assert found["where"] == where
    motion = hh.simulate(scenario)
    ledger = motion.ledger
    shown = {name: float(found[name]) for name in ("kinetic", "potential", "friction", "slip", "along", "normal")}
    near = {"rel": 1e-5}
    assert shown["friction"] == pytest.approx(shown["slip"] + shown["along"], **near)
    # the diagram of the page draws the same column of the samples
    assert shown["friction"] == pytest.approx(motion.at(motion.duration).friction_loss, **near)
    assert shown["slip"] == pytest.approx(ledger.friction, **near)
    assert (found["rolling"] is not None) == (scenario.plane.rolling_resistance > 0.0)
    rolling = float(found["rolling"] or 0.0)
    start = motion.at(0.0)
    lost = shown["friction"] + shown["normal"] + rolling
    held = shown["kinetic"] + shown["potential"]
    stored = motion.at(motion.duration).spring
    assert held + lost + stored == pytest.approx(start.kinetic + start.potential, rel=1e-5)
    assert (shown["along"] > 0.1) == (where != "the damper")
