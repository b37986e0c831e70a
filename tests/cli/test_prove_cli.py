"""`hophoop prove`: what it prints and writes, and its exit status."""

from __future__ import annotations

import json
from decimal import Decimal, localcontext

import pytest
from typer.testing import CliRunner

import hophoop as hh
from hophoop.cli import app
from hophoop.prove import prove_map

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


def test_boxes_of_parameters(tmp_path):
    """The window as the library divides it: rolling below the first slip at 2.043 m/s, undecided across it."""
    path = tmp_path / "boxes.json"
    window = ["--boxes", "plane.mu=0.9:1.1", "--boxes", "start.speed=1.0:1.8"]
    done = run(*window, "--depth", "2", "--out", path)
    assert done.exit_code == 0, done.output
    told = json.loads(path.read_text(encoding="utf-8"))
    found = prove_map(hh.Scenario(), {"plane.mu": (0.9, 1.1), "start.speed": (1.0, 1.8)}, depth=2)
    assert {key: told[key] for key in found.to_dict()} == json.loads(json.dumps(found.to_dict()))
    assert 0.0 < told["share"] == told["sequences"]["R"] <= 1.0
    assert f"proved  {100 * found.share():.4g} % of the window, in " in done.stdout
    assert json.loads(run(*window, "--depth", "2", "--json").stdout) == told


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


@pytest.mark.slow
def test_statements_of_the_article():
    done = run("--article")
    assert done.exit_code == 0, done.output
    assert "proved  18 of 18" in done.stdout
    assert "undecided" not in done.stdout


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        (["--boxes", "plane.mu"], "PATH=LOW:HIGH"),
        (["--boxes", "plane.mu=1:b"], "PATH=LOW:HIGH"),
        (["--boxes", "plane.mu=1:2", "--boxes", "plane.mu=1:2"], "twice"),
        (["--boxes", "plane.mu=2:1"], "least value first"),
        (["--boxes", "hoop.mass=1:2"], "--boxes holds hoop.mass"),
        (["--boxes", "plane.mu=1:2", "--depth", "-1"], "--depth = -1"),
        (["--thresholds", "fastest"], "'fastest'"),
        (["--thresholds", "all", "--article"], "cannot be given together with --article"),
        (["--v0", 3.1, "--depth", 3], "--depth needs --boxes"),
        (["--article", "--seconds", 3], "--article cannot be given together with --seconds"),
        (["--check", "a.json", "--boxes", "plane.mu=1:2"], "cannot be given together with --boxes"),
    ],
)
def test_what_is_refused(arguments, word):
    done = run(*arguments)
    assert done.exit_code == 2
    assert word in done.stderr


def test_a_gait_is_proved_and_printed(tmp_path):
    path = tmp_path / "gait.json"
    done = run("--gamma", 0.5, "--slope-deg", 3, "--gravity", 1, "--gait", "2.7714:2.7716", "--out", path)
    assert done.exit_code == 0
    first, second, third = done.stdout.splitlines()
    assert first == "proved      one gait, RSHKR, which attracts all from 2.7714 to 2.7716 rad/s"
    assert "2.77150688780492" in second
    assert "-0.76802418" in third
    assert json.loads(path.read_text(encoding="utf-8"))["interval"] == [2.7714, 2.7716]


@pytest.mark.slow
def test_chaos_is_proved_and_printed():
    done = run("--slope-deg", 4, "--chaos", "10.03:10.57", "--chaos", "10.745:11.031")
    assert done.exit_code == 0
    first, second, third = done.stdout.splitlines()
    assert first == "proved      chaos, with a topological entropy of 0.481211 a revolution at least"
    assert " ".join(second.split()) == "RSRKR 10.03 to 10.57 rad/s is taken over 10.745 to 11.031"
    assert " ".join(third.split()) == ("RSHKR 10.745 to 11.031 rad/s is taken over 10.03 to 10.57 and 10.745 to 11.031")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--gait", "2.7716:2.7718"], "Not proved: the return map leads out of the interval"),
        (["--chaos", "2.7:2.71", "--chaos", "2.8:2.81"], "Not proved: the coverings have no two different loops"),
    ],
)
def test_what_is_not_proved_is_said(arguments, said):
    done = run("--gamma", 0.5, "--slope-deg", 3, "--gravity", 1, *arguments)
    assert done.exit_code == 1
    assert done.stdout == ""
    assert done.stderr.startswith(said)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--gait", "2.7"], "--gait 2.7 must be LOW:HIGH"),
        (["--gait", "2.8:2.7"], "--gait = 2.8 to 2.7 rad/s must be a range"),
        (["--chaos", "2.7:2.8"], "--chaos = 1 must be 2 to 100"),
        (["--chaos", "2.7:2.8", "--gait", "2.7:2.8"], "--gait cannot be given together with --chaos"),
    ],
)
def test_intervals_that_cannot_be_read(arguments, said):
    done = run("--slope-deg", 3, *arguments)
    assert done.exit_code == 2
    assert said in done.stderr


GAIT = ["--gamma", 0.25, "--slope-deg", 5, "--gravity", 1, "--gait", "3.02:3.05"]


def test_a_gait_is_certified_and_checked(tmp_path):
    path = tmp_path / "gait.json"
    assert run(*GAIT, "--certify", path).exit_code == 0
    checked = run("--check", path)
    assert checked.exit_code == 0
    first, *said = checked.stdout.splitlines()
    assert first == "accepted  gait: 16 events verified"
    assert said[0].strip() == "the return map takes all θ̇ from 3.02 to 3.05 rad/s into that interval"
    certificate = json.loads(path.read_text(encoding="utf-8"))
    path.write_text(json.dumps(certificate | {"words": ["RSHKR"]}), encoding="utf-8")
    refused = run("--check", path)
    assert refused.exit_code == 1
    assert refused.stderr == (
        "Refused after 4 events: it cannot be shown that the phases from an interval are those that are named, not RSHR.\n"
    )


def test_a_certificate_of_an_unknown_format(tmp_path):
    path = tmp_path / "gait.json"
    path.write_text('{"schema": "hophoop-map-proof/2"}', encoding="utf-8")
    done = run("--check", path)
    assert done.exit_code == 2
    assert "has the format 'hophoop-map-proof/2', which must be hophoop-proof/1 or hophoop-map-proof/1." in done.stderr


def test_what_is_not_proved_has_no_certificate(tmp_path):
    path = tmp_path / "gait.json"
    done = run("--gamma", 0.5, "--slope-deg", 3, "--gravity", 1, "--gait", "2.7716:2.7718", "--certify", path)
    assert done.exit_code == 1
    assert not path.exists()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--certify", "a.json"], "--certify needs --gait or --chaos"),
        ([*GAIT, "--certify", "none/a.json"], "--certify = none/a.json must be in an existing folder"),
        ([*GAIT, "--certify", "a.json", "--out", "a.json"], "a.json is used for two outputs"),
    ],
)
def test_a_certificate_that_cannot_be_written(arguments, said):
    done = run(*arguments)
    assert done.exit_code == 2
    assert said in done.stderr
