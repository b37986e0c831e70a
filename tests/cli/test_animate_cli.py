"""`hophoop animate`: what it writes, says and returns."""

import re

import pytest
from typer.testing import CliRunner

from animate_tools import decoded
from hophoop.cli import app

HOP = "[start]\nspeed = 3.1\n"


@pytest.fixture
def hop(tmp_path):
    file = tmp_path / "hop.toml"
    file.write_text("duration = 0.4\n" + HOP, encoding="utf-8")
    return file


def run(*words):
    return CliRunner().invoke(app, ["animate", *(str(word) for word in words)])


def test_a_refusal_is_one_line_where_no_terminal_shows_a_bar(tmp_path):
    refused = run("--out", tmp_path / "a.foo")
    assert refused.exit_code == 2
    assert refused.stderr.startswith("Error: --out = ")
    assert refused.stderr.count("\n") == 1


def test_a_film_from_a_file(hop, tmp_path):
    done = run(hop, "--out", tmp_path / "film.mp4", "--size", "320x180", "--fps", "20")
    assert done.exit_code == 0, done.output
    assert decoded(tmp_path / "film.mp4")[0].shape == (9, 180, 320, 3)
    assert done.stdout == ""
    assert "Wrote" in done.stderr


def test_a_film_from_options_quietly(tmp_path):
    done = run("--v0", 2, "--duration", 0.2, "--out", tmp_path / "a.gif", "--size", "160x90", "--quiet")
    assert done.exit_code == 0, done.output
    assert done.output == ""
    assert len(decoded(tmp_path / "a.gif")[0]) == 6


def test_3d_films_and_scenes(hop, tmp_path):
    done = run(hop, "--3d", "--out", tmp_path / "a.mp4", "--size", "128x72", "--fps", "10", "--camera", "side")
    assert done.exit_code == 0, done.output
    assert len(decoded(tmp_path / "a.mp4")[0]) == 5
    assert run(hop, "--3d", "--out", tmp_path / "a.html").exit_code == 0
    assert (tmp_path / "a.html").stat().st_size > 10_000


def test_slow_motion_makes_a_longer_film(tmp_path):
    words = ("--duration", 1.3, "--out", tmp_path / "a.mp4", "--size", "128x72", "--fps", "20")
    run(*words)
    plain = len(decoded(tmp_path / "a.mp4")[0])
    assert run(*words, "--slow-at", "takeoff", "--slow-at", "0.3").exit_code == 0
    assert len(decoded(tmp_path / "a.mp4")[0]) > plain + 20


def test_comparisons(hop, tmp_path):
    words = ("--out", tmp_path / "a.mp4", "--size", "256x144", "--fps", "10", "--quiet")
    assert run(hop, "--vary", "plane.mu=0.3,1", "--overlay", *words).exit_code == 0
    assert run(hop, "--with", hop, "--label", "one", "--label", "two", "--step", "angle", *words).exit_code == 0


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--out", "a.avi"], r"--out = 'a\.avi' must end in"),
        (["--out", "a.mp4", "--size", "wide"], "--size = wide must be a width and a height"),
        (["--out", "a.mp4", "--size", "321x181"], "must be even numbers"),
        (["--out", "a.mp4", "--slow-at", "hop"], r"--slow-at = 'hop' must be a finite time \(s\) or one of"),
        (["--out", "a.mp4", "--vary", "plane.mu"], "--vary = 'plane.mu' must be a path and values"),
        (["--out", "a.mp4", "--3d", "--overlay"], "cannot be given together with --3d"),
        (["--out", "a.mp4", "--theme", "blue"], "--theme = 'blue' must be one of"),
        (["--out", "a.mp4", "--to", "9"], "--to = 9.0 must be from the start at 0.0 s to"),
        (["--out", "a.mp4", "--panel", "speed"], "--panel = 'speed' must be one of velocity"),
        (["--out", "a.mp4", "--label", "a", "--label", "b"], "--label has 2 texts"),
        (["--out", "a.mp4", "--fps", "0"], "--fps = 0.0 must be a positive number"),
        (["--v0", "1"], "Missing option '--out'"),
    ],
)
def test_bad_input_ends_with_status_2_and_one_sentence(tmp_path, monkeypatch, words, said):
    monkeypatch.chdir(tmp_path)
    done = run("--duration", "0.2", *words)
    assert done.exit_code == 2
    assert re.search(said, " ".join(done.stderr.split())), done.stderr
    assert not list(tmp_path.iterdir())


def test_a_motion_without_an_answer_is_filmed_and_said(tmp_path):
    done = run("--set", "contact.max_events=2", "--out", tmp_path / "a.mp4", "--size", "64x64", "--fps", "5")
    assert done.exit_code == 1
    assert "event_limit" in done.stderr
    assert (tmp_path / "a.mp4").exists()
