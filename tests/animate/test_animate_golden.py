"""Pictures of films against those in tests/baseline/films; `python tests/golden_films.py` makes them anew."""

import numpy as np
import pytest

from golden_films import PICTURES, kept, shrunk
from hophoop.animate import picture
from hophoop.animate.film2d import Film2D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look


@pytest.mark.images
@pytest.mark.parametrize("name", list(PICTURES))
def test_pictures_are_as_they_were(name):
    off = np.abs(shrunk(PICTURES[name]()) - kept(name))
    assert off.mean() < 1.0
    assert (off.max(axis=-1) > 60).mean() < 0.002


@pytest.mark.images
def test_the_comparison_notices(monkeypatch):
    """A hoop a tenth of a second further, or of another colour, is another picture."""
    from animate_tools import motion

    off = np.abs(shrunk(picture(motion(), 0.66)) - kept("rolling"))
    assert off.mean() > 1.0
    assert (off.max(axis=-1) > 60).mean() > 0.002


def test_golden_pictures_are_frames_of_films():
    from animate_tools import motion

    shown = Film2D([motion()], Timing(fps=1 / 0.62, end=0.62), Look())
    assert (shown.draw(1) == picture(motion(), 0.62)).all()
