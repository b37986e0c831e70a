"""Text of films: at least 20 pixels at 1280 × 720, whole, and never on other text.

The distances on the plane in 3D as well.
"""

import itertools
import math
import re
from contextlib import closing

import numpy as np
import pytest

from animate_tools import motion
from hophoop.animate.film2d import Film2D
from hophoop.animate.film3d import Film3D
from hophoop.animate.frames import Timing
from hophoop.animate.look import PANELS, Look, Look3D
from hophoop.animate.sheet import FONT, MODE_FONT, Sheet

LEAST = 20.0  # [pixels] of a picture of 1280 × 720
SMALL = [(64, 64), (128, 72), (160, 480), (360, 640), (400, 300), (960, 540), (1920, 400)]
LOOKS = {
    "follow": ((3.1,), Look()),
    "hold": ((3.1,), Look(camera="hold")),
    "one panel": ((3.1,), Look(panels=PANELS[:1])),
    "panels": ((3.1,), Look(panels=PANELS)),
    "panels, hold": ((3.1,), Look(panels=PANELS[:3], camera="hold")),
    "upright": ((3.1,), Look(size=(720, 1280), panels=PANELS)),
    "small": ((3.1,), Look(size=(640, 360), panels=PANELS[:2])),
    "large": ((3.1,), Look(size=(2560, 1440), panels=PANELS)),
    "side": ((3.1, 2.0), Look()),
    "overlay": ((3.1, 2.0), Look(layout="overlay", camera="hold")),
    "three": ((3.1, 2.0, 0.5), Look(layout="overlay")),
    **{f"{w}x{h}": ((3.1,), Look(size=(w, h))) for w, h in SMALL},
    **{f"{w}x{h}, side": ((3.1, 2.0), Look(size=(w, h))) for w, h in SMALL},
    **{f"{w}x{h}, overlay": ((3.1, 2.0, 0.5), Look(size=(w, h), layout="overlay")) for w, h in SMALL},
    "3D": ((3.1,), Look3D()),
    "3D, hold": ((3.1, 2.0), Look3D(camera="hold")),
    "3D, orbit": ((3.1,), Look3D(camera="orbit")),
}


@pytest.fixture
def written(monkeypatch):
    """Texts that films write: words, size and rectangle (left, bottom, right, top) [pixels]."""
    found, write = [], Sheet.text

    def text(self, x, y, words, color, anchor="ls", bold=False):
        wide, size = self.text_width(words, bold), (MODE_FONT if bold else FONT) * self.unit
        left = x - {"l": 0.0, "m": 0.5, "r": 1.0}[anchor[0]] * wide
        low = y - {"s": 0.0, "m": 0.5}[anchor[1]] * 0.73 * size
        if words:
            found.append((words, size, (left, low, left + wide, low + 0.73 * size)))
        write(self, x, y, words, color, anchor, bold)

    monkeypatch.setattr(Sheet, "text", text)
    return found


def plotted(sheet):
    """The same of the texts of the figure."""
    drawn = [text for legend in sheet.figure.legends for text in legend.get_texts()]
    for axes in sheet.figure.axes:
        drawn += [*axes.texts, axes._left_title]
        drawn += axes.get_legend().get_texts() if axes.get_legend() else []
        for axis, (least, most) in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
            if axes.axison:
                drawn += [axis.label]
                drawn += [tick.label1 for tick in axis.get_major_ticks() if least <= tick.get_loc() <= most]
    return [
        (text.get_text(), text.get_size() * sheet.figure.dpi / 72.0, text.get_window_extent(sheet.renderer).extents)
        for text in drawn
        if text.get_visible() and text.get_text()
    ]


@pytest.mark.parametrize("name", list(LOOKS))
def test_text_can_be_read_and_never_meets(name, written):
    speeds, look = LOOKS[name]
    timing = Timing(fps=10, slow_at="takeoff") if name in ("follow", "3D") else Timing(fps=10)
    runs = [motion(speed) for speed in speeds]
    shown = Film3D(runs, timing, look) if isinstance(look, Look3D) else Film2D(runs, timing, look)
    share = min(look.size[0] / 1280.0, look.size[1] / 720.0)
    still, seen = list(written), 0
    figure = plotted(shown.sheet)
    for k in range(0, shown.count, 3 if min(look.size) > 480 else 10):
        written.clear()
        shown.draw(k)
        # letters of hoops may be outside, or at one place, where one disc hides the other
        texts = still + [one for one in written if len(one[0]) > 1] + figure
        seen += len(texts)
        assert min(size for _, size, _ in texts) >= LEAST * share - 1e-9, min((size, words) for words, size, _ in texts)
        for words, _, (left, low, right, top) in texts:
            assert -0.5 <= left < right <= look.size[0] + 0.5, words
            assert -0.5 <= low < top <= look.size[1] + 0.5, words
        for (one, _, a), (other, _, b) in itertools.combinations(texts, 2):
            across, up = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
            assert across <= 0.5 or up <= 0.5, (k, one, other, a, b)
    assert seen > 6
    if isinstance(shown, Film3D):
        shown.close()


def projected(film, k, point):
    """A point of the world in the k-th picture, from the lower left [pixels]; computed from where the camera stands."""
    eye, focus = (path[min(k, len(path) - 1)] for path in film.path)
    ahead = (focus - eye) / np.linalg.norm(focus - eye)
    right = np.cross(ahead, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    way = np.asarray(point) - eye
    scale = 0.5 * film.size[1] / math.tan(math.radians(15.0)) / (way @ ahead)
    return np.array([0.5 * film.size[0] + scale * (way @ right), 0.5 * film.size[1] + scale * (way @ np.cross(right, ahead))])


@pytest.mark.parametrize("slope", [0.0, 0.2])
@pytest.mark.parametrize("camera", ["chase", "orbit", "side", "hold"])
def test_a_distance_stands_at_its_mark(camera, slope, written):
    """Below the near edge of the track, which is 2.2 radii wide."""
    with closing(Film3D([motion(3.1, slope=slope)], Timing(fps=10), Look3D(camera=camera))) as film:
        for k in (0, 4):
            written.clear()
            film.draw(k)
            numbers = {words: box for words, _, box in written if re.fullmatch(r"-?\d+ m", words)}
            assert len(numbers) >= 2
            for words, (left, _, right, top) in numbers.items():
                along = float(words.removesuffix(" m"))
                edge = projected(film, k, (along * math.cos(slope), -1.1, -along * math.sin(slope)))
                assert 0.5 * (left + right) == pytest.approx(edge[0], abs=1.0)
                assert 4.0 < edge[1] - top < 15.0
