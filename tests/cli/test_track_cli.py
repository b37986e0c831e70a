"""`hophoop track`, as a person or a script calls it."""

import socket

import numpy as np
import pytest
from typer.testing import CliRunner

import hophoop as hh
from film_maker import Film, article_like, make
from hophoop.cli import app

FILM = Film(size=(320, 192), scale=130.0, origin=(60.0, 170.0), frames=10, marker_size=0.05)


@pytest.fixture(scope="module")
def film(tmp_path_factory):
    return make(tmp_path_factory.mktemp("film") / "hoop.mp4", article_like(duration=0.2), FILM)


def call(*arguments):
    return CliRunner().invoke(app, ["track", *map(str, arguments)])


def test_a_table_on_standard_output(film, tmp_path):
    done = call(film, "--radius", 0.3, "--quiet", "--exposure", FILM.shutter)
    assert done.exit_code == 0, done.output
    assert "Found in 10 of 10 frames." in done.stderr
    (tmp_path / "track.csv").write_text(done.stdout)
    track = hh.read_track(tmp_path / "track.csv")
    assert track.t == pytest.approx(np.arange(10) / 240 + 0.5 * FILM.shutter, abs=1e-5)
    assert np.isfinite(track.angle).all()


def test_a_folder_with_everything(film, tmp_path):
    done = call(film, "--radius", 0.3, "--out", tmp_path / "new" / "found", "--slope-deg", 2)
    assert done.exit_code == 0, done.output
    assert {path.name for path in (tmp_path / "new" / "found").iterdir()} == {
        "index.html",
        "overlay.mp4",
        "track.json",
        "track.csv",
    }
    assert np.degrees(hh.read_track(tmp_path / "new" / "found" / "track.json").slope) == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--radius", 0], "--radius = 0.0 must be a number above 0"),
        (["--radius", 0.3, "--marker-color", "gray"], "--marker-color = 'gray' must be auto, none, red"),
        (["--radius", 0.3, "--centre", "1,2"], "rim is missing"),
        (["--radius", 0.3, "--centre", "a,b"], "--centre = 'a,b' must be 2 numbers"),
        (["--radius", 0.3, "--row-delay", 1], "--row-delay = 1.0 must be from -0.001 to 0.001"),
        (["--radius", 0.3, "--save", "a.xls"], "--save = a.xls must end in .json or .csv"),
        (["--radius", 0.3, "--overlay", "a.avi"], "--overlay = a.avi must end in .mp4"),
        (["--radius", 0.3, "--save", "gone/a.csv"], "in an existing folder; gone does not exist"),
        ([], "Missing option '--radius'"),
    ],
)
def test_bad_input_is_one_sentence(film, tmp_path, monkeypatch, arguments, message):
    monkeypatch.chdir(tmp_path)
    done = call(film, *arguments)
    assert done.exit_code == 2
    assert message in " ".join(done.output.split())
    assert list(tmp_path.iterdir()) == []


def test_the_film_is_not_written_over(film):
    done = call(film, "--radius", 0.3, "--overlay", film)
    assert done.exit_code == 2
    assert "is the film itself" in done.output


@pytest.mark.parametrize(
    "form", ["http://127.0.0.1:{}/hoop.mp4", "tcp://127.0.0.1:{}", "tcp:127.0.0.1:{}", "http:127.0.0.1:{}/hoop.mp4"]
)
@pytest.mark.parametrize("more", [(), ("--pick",)])
def test_an_address_is_refused_and_nothing_connects(form, more):
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(0.2)
        film = form.format(server.getsockname()[1])
        done = call(film, "--radius", 0.3, *more)
        with pytest.raises(TimeoutError):
            server.accept()
    assert done.exit_code == 2
    if "://" in film:
        assert done.stderr == f"Error: {film} is an address; a film must be a file on this machine.\n"
    else:
        assert "No such file" in done.stderr
