"""Runs and tables: three engines against the kept table, failures, the worked example, the scripts themselves."""

import json
import math
import re
import subprocess
import sys
from pathlib import Path

import pytest
import run
import score
import table
from adapters.hophoop import run as exact
from record import Record, record_text
from truth import job, scored, truths

from checkout import text_of

PAGE = text_of("docs/engines.md")
KEPT = json.loads(table.KEPT.read_text(encoding="utf-8"))
HOP = truths()["hop"]
# What a number may be off with another processor or mathematical library: the motion after many contacts, and thus the error
# of the place; not the sequence.
SAME = 1e-6


def assert_same(mine, right, tolerance):
    """Numbers are equal to the tolerance, words and missing numbers are equal."""
    assert mine == {
        name: pytest.approx(value, rel=tolerance, abs=tolerance) if isinstance(value, float) else value
        for name, value in right.items()
    }


# The kept table


@pytest.mark.parametrize("name", ["mujoco", "pymunk", "box2d"])
def test_the_kept_table_comes_out_again(name):
    one = run.engines()[name]
    if one.version != KEPT["engines"][name]["version"]:
        pytest.skip(f"{one.title} {one.version or 'not installed'}; the table has {KEPT['engines'][name]['version']}")
    for row in run.rows_of(list(run.runs_of([one], ["hop"], [0.001])), dict.fromkeys(truths(), 1.0)):
        head = ("engine", "dt", "setting", "scenario")
        (before,) = (kept for kept in KEPT["rows"] if all(kept[name] == row[name] for name in head))
        for part in ("scores", "measures"):
            assert_same(row[part] | {"wall_seconds": 0}, before[part] | {"wall_seconds": 0}, SAME)


def test_the_kept_limits_come_out_again():
    found = table.limits(KEPT["rows"])
    assert [one["quantity"] for one in found] == [one["quantity"] for one in KEPT["limits"]]
    for mine, right in zip(found, KEPT["limits"], strict=True):
        assert_same(mine, right, 1e-9)


def test_the_kept_table_is_that_of_the_engines():
    assert KEPT["benchmark"] == "hophoop-bench/1"
    assert {row["scenario"] for row in KEPT["rows"]} == set(truths())
    kept = {name: one | {"version": ""} for name, one in KEPT["engines"].items()}
    assert kept == {name: one.describe() | {"version": ""} for name, one in run.engines().items()}


def test_the_figure_of_the_page_shows_the_hops_of_the_table():
    """A panel for each engine, with its errors at 1 ms."""
    words = re.findall(r"<!-- (.+) -->", text_of("docs/figures/engines-hops.svg"))
    for name, one in KEPT["engines"].items():
        drawn = [table.hop_words(row["scores"]["hop_height"]) for row in table._shown_hops(KEPT["rows"], name)]
        place = words.index(one["title"])
        assert drawn == words[place - len(drawn) : place]


# What fails is a row


@pytest.mark.parametrize(
    ("code", "limit", "said"),
    [
        ("raise ValueError('too stiff')", 60.0, "too stiff"),
        ("import os; os.kill(os.getpid(), 9)", 60.0, "its process crashed"),
        ("import time; time.sleep(60)", 0.5, "it took more than 0.5 s"),
        ("print('hello')", 60.0, "what it wrote must start with the header"),
        ("import sys; sys.exit(3)", 60.0, "it ended without a word"),
    ],
)
def test_a_run_that_fails_says_why(code, limit, said):
    with pytest.raises(run.Failure, match=said):
        run.record_of([sys.executable, "-c", code], job(HOP.task, 0.01, {}), limit)


def test_a_failure_takes_the_place_of_scores(monkeypatch):
    text = record_text(Record(exact(HOP.task, 0.0)))
    short = "\n".join(text.splitlines()[:100])
    monkeypatch.setattr(run.Engine, "command", [sys.executable, "-c", f"print({short!r})"])
    (row,) = run.rows_of(list(run.runs_of([run.engines()["drake"]], ["hop"], [0.01]))[:1], {"hop": 1.0})
    assert row["failure"].startswith("the record ends at")
    assert "the record ends at" in table.row_line(row)


# The scripts


def test_run_writes_scores_that_the_figures_can_be_made_of(tmp_path, capsys):
    run.main(["hophoop", "--scenario", "hop", "--dt", "0.001", "--out", str(tmp_path)])
    assert "✓" in capsys.readouterr().out
    document = json.loads((tmp_path / "scores.json").read_text(encoding="utf-8"))
    (row,) = document["rows"]
    assert set(document) == set(KEPT)
    assert row["scores"]["sequence_right"] is True
    assert row["relative_wall"] > 0.2
    name = table.record_name(row)
    found = score.score_text((tmp_path / name).read_text(encoding="utf-8"), str(tmp_path / "hop.csv"))
    pytest.importorskip("matplotlib")
    for figure in (table.hops(document, {name: found.record.states}), table.work_precision(document)):
        assert "hophoop (ours)" in table.drawing(figure)


def test_what_is_not_installed_or_known_is_said(monkeypatch, capsys):
    monkeypatch.setattr(run.Engine, "version", "")
    for arguments in (["drake", "jolt"], ["physx"], ["hophoop", "--dt", "0"]):
        with pytest.raises(SystemExit):
            run.main(arguments)
    said = "".join(capsys.readouterr())
    assert "Drake is not installed: pip install -r " in said
    assert "Jolt is not installed: npm install --prefix " in said
    assert "engine = 'physx' is not one of hophoop, " in said
    assert "--dt must be above 0" in said


@pytest.mark.long
def test_the_example_of_the_page_is_scored(tmp_path, capsys):
    """Its program runs without hophoop, in its own process; the page shows what its scores are."""
    alone = tmp_path / "alone"
    for words in ([tmp_path], [alone, "--only", "rolling"]):
        subprocess.run([sys.executable, "-I", "-S", run.HERE / "example.py", *words], check=True)
    assert [path.name for path in alone.iterdir()] == ["rolling.csv"]
    score.main(sorted(str(path) for path in tmp_path.glob("*.csv")))
    printed = capsys.readouterr().out
    assert printed.splitlines()[-1] == "6 of 7 right"
    assert printed in PAGE


def test_the_next_engines_stand_beside_a_score():
    """At an engine's own error it is behind the next better one; at none it is ahead of the best."""
    assert score.neighbours("hop", 0.0)[0] == ""
    best = score.neighbours("hop", 0.0)[1]
    assert score.neighbours("hop", math.inf)[1] == ""
    name, error = best.rsplit(" ", 1)
    kept = [row for row in KEPT["rows"] if row["dt"] == 0.001 and row["scenario"] == "hop" and "scores" in row]
    (engine,) = (key for key, one in KEPT["engines"].items() if one["title"] == name)
    assert float(error) == pytest.approx(min(row["scores"]["angle_error"] for row in kept if row["engine"] == engine), rel=0.05)
    assert score.neighbours("hop", 1.5 * float(error))[0] == best


def test_a_record_of_one_motion(tmp_path, capsys):
    hop = str(tmp_path / "hop.csv")
    Path(hop).write_text(record_text(Record(exact(HOP.task, 0.0))), encoding="utf-8")
    score.main([hop])
    said = capsys.readouterr().out
    assert "RKRSHR ✓" in said
    assert "1 of 7 right; no record of rolling, slip, " in said
    assert "Fewer than" not in said
    Path(hop).write_text(record_text(Record(exact(HOP.task, 1 / 240))), encoding="utf-8")
    score.main([hop])
    assert "sure of phases: hop\n" in capsys.readouterr().out
    score.main([hop, "--json"])
    document = json.loads(capsys.readouterr().out)
    assert (document["right"], document["of"]) == (1, len(scored()))
    pytest.importorskip("matplotlib")
    score.main([hop, "--plot", str(tmp_path / "plot.svg")])
    assert (tmp_path / "plot.svg").stat().st_size > 10_000


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("slip.csv", None, "slip.csv: the record starts with vx = 3.1, the motion 'slip' with 2.8"),
        ("hop.csv", b"\xff\xfe", "not a text file in UTF-8"),
    ],
)
def test_a_file_that_is_no_record_is_one_sentence(name, text, said, tmp_path):
    path = tmp_path / name
    path.write_bytes(text or record_text(Record(exact(HOP.task, 0.0))).encode())
    with pytest.raises(SystemExit, match=r"^Error: ") as ended:
        score.main([str(path)])
    assert said in str(ended.value.code)
