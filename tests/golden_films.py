"""The pictures of films that are kept, and the program that makes them again: `python tests/golden_films.py`.

They are kept at a quarter of their size, which is enough to see whether all is in its place and has its
colour, and lets details of text and edges differ between versions of the drawing library.
"""

from pathlib import Path

import numpy as np
from PIL import Image

from animate_tools import motion
from hophoop.animate import Look, picture

FOLDER = Path(__file__).parent / "baseline" / "films"
SHRINK = 4

PANELS = ("velocity", "energy", "utilization", "phase")
PICTURES = {
    "rolling": lambda: picture(motion(), 0.62),
    "flight-panels-dark": lambda: picture(motion(), 1.5, Look(theme="dark", panels=PANELS)),
    "slope-print": lambda: picture(motion(0.5, 1.0, 1.5, 0.25), 1.3, Look(theme="print")),
    "side-by-side": lambda: picture([motion(), motion(2.0)], 0.9),
    "overlay-hold": lambda: picture([motion(), motion(2.0)], 1.0, Look(layout="overlay", camera="hold")),
}


def shrunk(drawn):
    """Mean of each block of pixels, height/4 × width/4 × 3."""
    high, wide = drawn.shape[0] // SHRINK, drawn.shape[1] // SHRINK
    blocks = drawn[: high * SHRINK, : wide * SHRINK, :3].reshape(high, SHRINK, wide, SHRINK, 3)
    return blocks.mean(axis=(1, 3))


def kept(name):
    """The picture as it was kept."""
    with Image.open(FOLDER / f"{name}.png") as image:
        return np.asarray(image.convert("RGB"), dtype=float)


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name, draw in PICTURES.items():
        Image.fromarray(np.rint(shrunk(draw())).astype(np.uint8)).save(FOLDER / f"{name}.png", optimize=True)
        print(FOLDER / f"{name}.png")
