"""`hophoop track`, as a person or a script calls it."""

import socket
from dataclasses import replace

import numpy as np
import pytest

import hophoop as hh
from cli_tools import done
from film_maker import SMALL, article_like, make

FILM = replace(SMALL, frames=10)


@pytest.fixture(scope="module")
def film(tmp_path_factory):
    return make(tmp_path_factory.mktemp("film") / "hoop.mp4", article_like(duration=0.2), FILM)


def test_a_table_on_standard_output(film, tmp_path):
    found = done(f"track --radius 0.3 --quiet --exposure {FILM.shutter}", film)
    assert "Found in 10 of 10 frames." in found.stderr
    (tmp_path / "track.csv").write_text(found.stdout)
    track = hh.read_track(tmp_path / "track.csv")
    assert track.t == pytest.approx(np.arange(10) / 240 + 0.5 * FILM.shutter, abs=1e-5)
    assert np.isfinite(track.angle).all()


def test_a_folder_with_everything(film, tmp_path):
    folder = tmp_path / "new" / "found"
    done("track --radius 0.3 --slope-deg 2", film, "--out", folder)
    assert {path.name for path in folder.iterdir()} == {"overlay.mp4", "track.svg", "track.json", "track.csv"}
    assert np.degrees(hh.read_track(folder / "track.json").slope) == pytest.approx(2.0)


@pytest.mark.parametrize("form", ["http://127.0.0.1:{}/hoop.mp4", "tcp:127.0.0.1:{}"])
@pytest.mark.parametrize("more", ["", "--pick"])
def test_an_address_is_refused_and_nothing_connects(form, more):
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.settimeout(0.2)
        film = form.format(server.getsockname()[1])
        found = done(f"track --radius 0.3 {more}", film, status=2)
        with pytest.raises(TimeoutError):
            server.accept()
    expected = f"Error: {film} is an address; a film must be a file on this machine.\n" if "://" in film else "No such file"
    assert expected in found.stderr
