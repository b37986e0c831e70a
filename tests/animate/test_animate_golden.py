"""Pictures of films against those in tests/baseline/films; `PYTHONPATH=tests python THIS_FILE` makes them anew.

They are kept at a quarter of their size, which is enough to see whether all is in its place and has its
colour, and lets details of text and edges differ between versions of the drawing library.
"""

import numpy as np
import pytest
from PIL import Image

from animate_tools import motion
from checkout import ROOT
from hophoop.animate import Look, picture

FOLDER = ROOT / "tests/baseline/films"
PANELS = ("velocity", "energy", "utilization", "phase")
PICTURES = {
    "rolling": lambda: picture(motion(), 0.62),
    "flight-panels-dark": lambda: picture(motion(), 1.5, Look(theme="dark", panels=PANELS)),
    "slope-print": lambda: picture(motion(0.5, 1.0, 1.5, 0.25), 1.3, Look(theme="print")),
    "side-by-side": lambda: picture([motion(), motion(2.0)], 0.9),
    "overlay-hold": lambda: picture([motion(), motion(2.0)], 1.0, Look(layout="overlay", camera="hold")),
}


def shrunk(name):
    """The picture as it is drawn now, the mean of each block of 4 × 4 pixels."""
    return Image.fromarray(PICTURES[name]()).convert("RGB").reduce(4)


@pytest.mark.images
@pytest.mark.parametrize("name", list(PICTURES))
def test_pictures_are_as_they_were(name):
    with Image.open(FOLDER / f"{name}.png") as kept:
        off = np.abs(np.subtract(shrunk(name), kept.convert("RGB"), dtype=float))
    assert off.mean() < 1.0
    assert (off.max(axis=-1) > 60).mean() < 0.002


if __name__ == "__main__":
    for name in PICTURES:
        shrunk(name).save(FOLDER / f"{name}.png", optimize=True)
