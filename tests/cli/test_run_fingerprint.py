"""`hophoop run --check-fingerprint`: whether this machine gets the same bits."""

import json

import pytest

import hophoop as hh
from cli_tools import HOP, hop, run

OTHER = "0123456789abcdef"


def test_the_table_ends_with_the_fingerprint():
    assert run("run", *HOP).stdout.splitlines()[-1].split() == ["fingerprint", hop().fingerprint]


@pytest.mark.parametrize("spell", [str.lower, str.upper])
def test_equal_bits_are_confirmed(spell):
    done = run("run", *HOP, "--check-fingerprint", spell(hop().fingerprint))
    assert (done.exit_code, done.stderr) == (0, "")
    assert done.stdout.endswith(f"\nThis machine gets the same bits: the fingerprint is {hop().fingerprint}.\n")


def test_json_stays_alone_on_standard_output():
    done = run("run", *HOP, "--json", "--check-fingerprint", hop().fingerprint)
    assert json.loads(done.stdout) == hop().to_dict()
    assert done.stderr == f"This machine gets the same bits: the fingerprint is {hop().fingerprint}.\n"


def test_other_bits_end_with_status_1_and_the_output_is_written(tmp_path):
    result = tmp_path / "hop.json"
    done = run("run", *HOP, "--check-fingerprint", OTHER, "--out", result, "--quiet")
    assert (done.exit_code, done.stdout) == (1, "")
    assert done.stderr == (
        f"hophoop {hh.__version__} gets other bits on this machine: the fingerprint is {hop().fingerprint}, not {OTHER}. "
        "Only the same version of hophoop and the same scenario give the same bits.\n"
    )
    assert json.loads(result.read_text(encoding="utf-8")) == hop().to_dict()


def test_a_motion_without_an_answer_has_a_fingerprint_too():
    scenario = hh.Scenario().with_values({"contact.max_events": 3, "start.speed": 3.1, "duration": 2.0})
    same = run("run", *HOP, "--set", "contact.max_events=3", "--check-fingerprint", hh.simulate(scenario).fingerprint)
    assert same.exit_code == 1  # the motion has no answer, though its bits are the same
    assert "This machine gets the same bits" in same.stdout
    assert "The motion ends at t = " in same.stderr


@pytest.mark.parametrize("text", ["", "12", OTHER[:-1] + "g", OTHER + "0", f" {OTHER}", f"{OTHER}\n"])
def test_what_is_no_fingerprint_is_refused(text, tmp_path):
    done = run("run", *HOP, f"--check-fingerprint={text}", "--out", tmp_path / "hop.json")
    assert done.exit_code == 2
    assert done.stderr == f"Error: --check-fingerprint = {text!r} must be 16 hexadecimal digits.\n"
    assert not (tmp_path / "hop.json").exists()


@pytest.mark.parametrize("option", [("--digits", "20"), ("--check",)])
def test_a_motion_in_more_digits_has_none(option):
    done = run("run", *HOP, *option, "--check-fingerprint", OTHER)
    assert done.exit_code == 2
    assert done.stderr == f"Error: --check-fingerprint cannot be given together with {option[0]}.\n"
