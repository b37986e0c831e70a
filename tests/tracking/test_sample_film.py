"""The sample film that ships: its track is what the tracker finds, and the page says what its fit gives."""

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import ROOT, is_told
from hophoop.tracking import Hints, read_track

FOLDER = ROOT / "examples" / "film"


def test_the_track_lies_on_the_motion():
    """The circle that the tracker found, against the motion that was rendered, to a millimetre."""
    track = read_track(FOLDER / "track.json")
    motion = hh.simulate(hh.Scenario.load(FOLDER / "truth.toml"))
    states = motion.at(track.t)
    x, y = track.centre.T
    apart = np.hypot(x - x[0] - (states.x - states.x[0]), y - states.height - 0.3)
    assert len(track.t) == track.found.sum() == 264
    assert np.median(apart) < 1e-3
    turned = np.unwrap(track.angle)
    assert np.abs(turned - turned[0] - (states.angle - states.angle[0])).max() < 0.05


@pytest.mark.long
def test_a_fit_of_the_film_gives_what_the_page_says():
    track = hh.track(FOLDER / "hoop.mp4", radius=0.3, hints=Hints(exposure=0.0005, row_delay=8e-6))
    fit = hh.fit(track)
    is_told(fit, "docs/film.md", ("gamma", "mu_kinetic", "mu_excess", "restitution"))


def test_a_film_on_its_side_is_doubted(tmp_path):
    """As a phone writes it that was held upright, if no program has turned it."""
    av = pytest.importorskip("av")
    film = tmp_path / "sideways.mp4"
    with av.open(str(FOLDER / "hoop.mp4")) as source, av.open(str(film), "w") as out:
        stream = out.add_stream("libx264", rate=60, options={"crf": "18"})
        stream.width, stream.height = source.streams.video[0].height, source.streams.video[0].width
        for k, frame in enumerate(source.decode(video=0)):
            if k % 4 == 0:
                picture = np.ascontiguousarray(np.rot90(frame.to_ndarray(format="rgb24")))
                out.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="rgb24")))
        out.mux(stream.encode())
    track = hh.track(film, 0.3)
    assert any("Doubtful: the hoop moves up or down the picture. Is the film sideways?" in note for note in track.notes)
    assert not any("stays in one place" in note for note in track.notes)
