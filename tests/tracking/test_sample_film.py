"""The sample film that ships: its track is what the tracker finds, and the page says what its fit gives."""

import numpy as np
import pytest

import hophoop as hh
from checkout import ROOT
from fitting_tools import is_told
from hophoop.tracking import Hints, read_track

FOLDER = ROOT / "examples" / "film"


def test_the_track_lies_on_the_motion():
    """The circle that the tracker found, against the motion that was rendered, to a millimetre."""
    track = read_track(FOLDER / "track.json")
    states = hh.simulate(hh.Scenario.load(FOLDER / "truth.toml")).at(track.t)
    x, y = track.centre.T
    apart = np.hypot(x - x[0] - (states.x - states.x[0]), y - states.height - 0.3)
    assert track.found.sum() == 264
    assert np.median(apart) < 1e-3
    turned = np.unwrap(track.angle)
    assert np.abs(turned - turned[0] - (states.angle - states.angle[0])).max() < 0.05


@pytest.mark.long
def test_a_fit_of_the_film_gives_what_the_page_says():
    track = hh.track(FOLDER / "hoop.mp4", radius=0.3, hints=Hints(exposure=0.0005, row_delay=8e-6, slope=0.0))
    fit = hh.fit(track)
    is_told(fit, "docs/film.md", ("gamma", "mu_kinetic", "mu_excess", "restitution"))
