"""`hophoop prove`: what it prints and writes, and its exit status."""

from __future__ import annotations

import json
from decimal import Decimal, localcontext

import pytest

from cli_tools import done, run

pytest.importorskip("flint")

HOP = "prove --v0 3.1 --duration 2 --digits 12"


@pytest.fixture(scope="module")
def certificate():
    return json.loads(done(f"{HOP} --json").stdout)


def test_it_prints_enclosures_and_writes_a_certificate_that_is_accepted(tmp_path, certificate):
    path = tmp_path / "hop.json"
    said = done(HOP, "--out", path).stdout
    assert "5.50890842538176 ± 6e-12" in said or "5.5089084253818 ± 6e-12" in said
    assert "phases  RKRSHR\nverdict proved" in said
    assert json.loads(path.read_text(encoding="utf-8"))["schema"] == certificate["schema"] == "hophoop-proof/1"
    first, *conventions = done("prove --check", path).stdout.splitlines()
    assert first == "accepted  RKRSHR, completed: 8 events verified"
    assert conventions[2].strip() == "bounces are closed when what is left of them takes less than 1e-12 of the time so far"
    assert len(conventions) == 5


def test_a_false_certificate_is_refused_in_one_sentence(tmp_path, certificate):
    path = tmp_path / "hop.json"
    start = certificate["scenario"]["start"] | {"speed": 3.2}
    for changed, said in (
        (
            {"closing": "0.3"},
            "Refused after 0 events: it cannot be shown that bounces are closed at 1e-12 of the time",
        ),
        ({"scenario": certificate["scenario"] | {"start": start}}, "Refused after "),
    ):
        path.write_text(json.dumps(certificate | changed), encoding="utf-8")
        found = run("prove --check", path)
        assert found.exit_code == 1
        assert found.stderr.startswith(said)
        assert found.stderr.count("\n") == 1


def test_what_is_undecided_ends_with_status_1(tmp_path):
    found = run("prove --gamma 1", "--out", tmp_path / "none.json")
    assert found.exit_code == 1
    assert "massless" in found.stderr
    assert not (tmp_path / "none.json").exists()


def test_thresholds_to_thirty_digits():
    """v² = g R/γ, by the decimal digits of an independent square root."""
    line = "prove --thresholds immediate_hop_speed --digits 30"
    (one,) = json.loads(done(f"{line} --json").stdout)["thresholds"]
    with localcontext() as context:
        context.prec = 50
        true = (Decimal.from_float(9.81) / Decimal("0.75")).sqrt()
        assert abs(Decimal(one["middle"]) - true) <= Decimal(one["radius"]) < Decimal("1e-29")
    assert f"{one['middle']} ± " in done(line).stdout


def test_a_threshold_that_cannot_be_shown():
    for words, sentence in (
        ("--mu inf --thresholds first_slip_speed", "first_slip_speed: friction is infinite."),
        ("--v0 3.1 --thresholds needed_friction", "needed_friction: no friction is enough, for the hoop would leave"),
        ("--angle 1 --thresholds needed_friction", "needed_friction: the start is not a rolling one with the load up."),
    ):
        found = run(f"prove {words}")
        assert found.exit_code == 1
        assert found.stderr.startswith(f"Undecided: {sentence}")
