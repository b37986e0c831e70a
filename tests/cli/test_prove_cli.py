"""`hophoop prove`: what it prints and writes, and its exit status."""

from __future__ import annotations

import json
from decimal import Decimal, localcontext

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
    first, *conventions = checked.stdout.splitlines()
    assert first == "accepted  RKRSHR, completed: 8 events verified"
    assert conventions[2].strip() == "bounces are closed when what is left of them takes less than 1e-12 of the time so far"
    assert len(conventions) == 5


def test_json_is_the_certificate_and_nothing_else():
    done = run(*HOP, "--json")
    assert done.exit_code == 0
    assert json.loads(done.stdout)["schema"] == "hophoop-proof/1"


def test_a_certificate_that_closes_its_bounces_earlier_is_refused_in_one_sentence(tmp_path):
    path = tmp_path / "hop.json"
    certificate = json.loads(run(*HOP, "--json").stdout) | {"closing": "0.3"}
    path.write_text(json.dumps(certificate), encoding="utf-8")
    done = run("--check", path)
    assert done.exit_code == 1
    assert done.stderr == (
        "Refused after 0 events: it cannot be shown that bounces are closed at 1e-12 of the time so far, as the model has it.\n"
    )


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
    [(["--digits", "0"], "digits"), (["--until", "never"], "until"), (["--check", "a.json", "--json"], "only a certificate")],
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


def test_thresholds_to_thirty_digits():
    """v² = g R/γ, by the decimal digits of an independent square root."""
    done = run("--thresholds", "immediate_hop_speed,painleve_friction", "--digits", "30", "--json")
    assert done.exit_code == 0, done.output
    found = {one["key"]: one for one in json.loads(done.stdout)["thresholds"]}
    with localcontext() as context:
        context.prec = 50
        true = (Decimal.from_float(9.81) / Decimal("0.75")).sqrt()
        one = found["immediate_hop_speed"]
        assert abs(Decimal(one["middle"]) - true) <= Decimal(one["radius"]) < Decimal("1e-29")
    assert found["painleve_friction"]["middle"].startswith("0.88191710368819686350053858454")
    shown = run("--thresholds", "immediate_hop_speed", "--digits", "30")
    assert f"{one['middle']} ± " in shown.stdout


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (("--mu", "inf", "--thresholds", "first_slip_speed"), "first_slip_speed: friction is infinite."),
        (
            ("--v0", "3.1", "--thresholds", "needed_friction"),
            "needed_friction: no friction is enough, for the hoop would leave the plane.",
        ),
        (
            ("--angle", "1", "--thresholds", "needed_friction"),
            "needed_friction: the start is not a rolling one with the load up.",
        ),
    ],
)
def test_a_threshold_that_cannot_be_shown(options, sentence):
    done = run(*options)
    assert done.exit_code == 1
    assert done.stderr == f"Undecided: {sentence}\n"


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        (["--thresholds", "fastest"], "'fastest'"),
        (["--check", "a.json", "--seconds", 3], "--check cannot be given together with --seconds"),
        (["--thresholds", "all", "--seconds", 3], "--thresholds cannot be given together with --seconds"),
        (["--check", "a.json", "--thresholds", "all"], "--check cannot be given together with --thresholds"),
    ],
)
def test_what_is_refused(arguments, word):
    done = run(*arguments)
    assert done.exit_code == 2
    assert word in done.stderr


def test_a_certificate_of_an_unknown_format(tmp_path):
    path = tmp_path / "hop.json"
    path.write_text('{"schema": "hophoop-proof/2"}', encoding="utf-8")
    done = run("--check", path)
    assert done.exit_code == 2
    assert "has the format 'hophoop-proof/2', which must be hophoop-proof/1." in done.stderr
