"""`hophoop prove`: what it prints and writes, and its exit status."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner

from hophoop.cli import app

pytest.importorskip("flint")

HOP = ["--v0", "3.1", "--duration", "2", "--digits", "12"]


def run(*arguments):
    return CliRunner().invoke(app, ["prove", *map(str, arguments)])


def test_it_prints_enclosures_and_writes_a_certificate_that_is_accepted(tmp_path):
    path = tmp_path / "hop.json"
    done = run(*HOP, "--out", path)
    assert done.exit_code == 0
    assert "5.50890842538176 ± 6e-12" in done.stdout or "5.5089084253818 ± 6e-12" in done.stdout
    assert "phases  RKRSHR\nverdict proved" in done.stdout
    checked = run("--check", path)
    assert checked.exit_code == 0
    assert checked.stdout == "accepted  RKRSHR, completed: 8 events verified\n"


def test_json_is_the_certificate_and_nothing_else():
    done = run(*HOP, "--json")
    assert done.exit_code == 0
    assert json.loads(done.stdout)["schema"] == "hophoop-proof/1"


def test_a_false_certificate_is_refused(tmp_path):
    path = tmp_path / "hop.json"
    certificate = json.loads(run(*HOP, "--json").stdout)
    certificate["scenario"]["start"]["speed"] = 3.2
    path.write_text(json.dumps(certificate), encoding="utf-8")
    done = run("--check", path)
    assert done.exit_code == 1
    assert done.stderr.startswith("Refused after ")


def test_what_is_undecided_ends_with_status_1(tmp_path):
    done = run("--gamma", "1", "--out", tmp_path / "none.json")
    assert done.exit_code == 1
    assert "massless" in done.stderr
    assert not (tmp_path / "none.json").exists()


@pytest.mark.parametrize(
    ("arguments", "word"),
    [(["--digits", "0"], "digits"), (["--until", "never"], "until"), (["--check", "a.json", "--json"], "alone")],
)
def test_bad_input_ends_with_status_2(arguments, word):
    done = CliRunner().invoke(app, ["prove", *arguments])
    assert done.exit_code == 2
    assert word in done.stderr


def test_a_file_that_is_no_certificate(tmp_path):
    path = tmp_path / "text.json"
    for text in ("no json", "[]"):
        path.write_text(text, encoding="utf-8")
        done = run("--check", path)
        assert done.exit_code == 2
        assert "certificate" in done.stderr
