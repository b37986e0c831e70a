"""Text of films: at least 20 pixels at 1280 × 720, whole, and never on other text."""

import itertools

import pytest
from matplotlib.text import Text

from animate_tools import motion
from hophoop.animate.film2d import Film2D
from hophoop.animate.film3d import Film3D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look, Look3D
from hophoop.plots.curves import PANELS as TABLE

PANELS = tuple(TABLE)
LEAST = 20.0  # [pixels] of a picture of 1280 × 720
HOPS, PAIR, THREE = (3.1,), (3.1, 2.0), (3.1, 2.0, 0.5)
LOOKS = {
    "hold": (HOPS, Look(camera="hold")),
    "one panel": (HOPS, Look(panels=PANELS[:1])),
    "panels": (HOPS, Look(panels=PANELS)),
    "upright": (HOPS, Look(size=(720, 1280), panels=PANELS)),
    "large": (HOPS, Look(size=(2560, 1440), panels=PANELS)),
    "side": (PAIR, Look()),
    "overlay": (PAIR, Look(layout="overlay", camera="hold")),
    "three": (THREE, Look(layout="overlay")),
    "3D": (HOPS, Look3D(size=(640, 360))),
    "3D, hold": (PAIR, Look3D(size=(640, 360), camera="hold")),
    **{
        f"{size}, {len(speeds)}": (speeds, Look(size=size, layout=layout))
        for size in ((64, 64), (160, 480), (1920, 400))
        for speeds, layout in ((HOPS, "side"), (PAIR, "side"), (THREE, "overlay"))
    },
}


def plotted(sheet):
    """Words, sizes and rectangles of the texts that the figure draws."""
    drawn = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Text, "draw", lambda text, renderer: drawn.append(text))
        sheet.figure.draw(sheet.renderer)
    return [
        (text.get_text(), text.get_size() * sheet.figure.dpi / 72.0, text.get_window_extent(sheet.renderer).extents)
        for text in drawn
        if text.get_visible() and text.get_text()
    ]


@pytest.mark.parametrize("name", list(LOOKS))
def test_text_can_be_read_and_never_meets(name, written):
    speeds, look = LOOKS[name]
    kind = Film3D if isinstance(look, Look3D) else Film2D
    shown = kind([motion(speed) for speed in speeds], Timing(fps=3, slow_at="takeoff"), look)
    share = min(look.size[0] / 1280.0, look.size[1] / 720.0)
    always = written + plotted(shown.sheet)
    for k in range(0, shown.count, 2):
        written.clear()
        shown.draw(k)
        # letters of hoops may be outside, or at one place, where one disc hides the other
        texts = always + [one for one in written if len(one[0]) > 1]
        for words, size, (left, low, right, top) in texts:
            assert size >= LEAST * share - 1e-9, words
            assert -0.5 <= left < right <= look.size[0] + 0.5, words
            assert -0.5 <= low < top <= look.size[1] + 0.5, words
        for (one, _, a), (other, _, b) in itertools.combinations(texts, 2):
            across, up = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
            assert across <= 0.5 or up <= 0.5, (k, one, other, a, b)
    letters = sorted(words for words, _, _ in written if len(words) == 1)
    assert letters == sorted(2 * "ABC"[: len(speeds)] * shown.head.tagged)
    if kind is Film3D:
        shown.close()
