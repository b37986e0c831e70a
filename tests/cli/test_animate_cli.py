"""`hophoop animate`: what it writes, says and returns."""

import pytest

from animate_tools import decoded
from cli_tools import done


@pytest.fixture
def hop(tmp_path):
    file = tmp_path / "hop.toml"
    file.write_text("duration = 0.4\n[start]\nspeed = 3.1\n", encoding="utf-8")
    return file


def test_a_film_from_a_file(hop, tmp_path):
    found = done("animate --size 320x180 --fps 20", hop, "--out", tmp_path / "film.mp4")
    assert decoded(tmp_path / "film.mp4")[0].shape == (9, 180, 320, 3)
    assert found.stdout == ""
    assert "Wrote" in found.stderr


def test_3d_films_and_scenes(hop, tmp_path):
    done("animate --3d --size 128x72 --fps 10 --camera side --out", tmp_path / "a.mp4", hop)
    assert len(decoded(tmp_path / "a.mp4")[0]) == 5
    done("animate --3d --out", tmp_path / "a.html", hop)
    assert (tmp_path / "a.html").stat().st_size > 10_000


@pytest.mark.long
def test_slow_motion_makes_a_longer_film(tmp_path):
    lengths = []
    for more in ("", "--slow-at takeoff --slow-at 0.3"):
        done(f"animate --duration 1.3 --size 128x72 --fps 20 {more} --out", tmp_path / "a.mp4")
        lengths.append(len(decoded(tmp_path / "a.mp4")[0]))
    assert lengths[1] > lengths[0] + 20


def test_comparisons(hop, tmp_path):
    line = "animate --size 256x144 --fps 10 --quiet"
    assert done(f"{line} --vary plane.mu=0.3,1 --overlay --out", tmp_path / "a.gif", hop).output == ""
    done(f"{line} --label one --label two --step angle --out", tmp_path / "a.mp4", hop, "--with", hop)


def test_a_motion_without_an_answer_is_filmed_and_said(tmp_path):
    found = done("animate --set contact.max_events=2 --size 64x64 --fps 5 --out", tmp_path / "a.mp4", status=1)
    assert "event_limit" in found.stderr
    assert (tmp_path / "a.mp4").exists()
