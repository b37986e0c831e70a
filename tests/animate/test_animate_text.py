"""Text of films: at least 20 pixels at 1280 × 720, whole, and never on other text.

All text is written on the canvas, also the distances on the plane in 3D.
"""

import itertools
import math
import re
from types import SimpleNamespace

import numpy as np
import pytest

from animate_tools import motion
from hophoop.animate.canvas import Canvas
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look, Look3D
from hophoop.animate.mpl import Film2D
from hophoop.animate.scene3d import Film3D
from hophoop.animate.words import StateLine, draw_state

LEAST = 20.0  # [pixels] of a picture of 1280 × 720
PANELS = ("velocity", "energy", "forces", "utilization", "phase")
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
    "3D": ((3.1,), Look3D()),
    "3D, hold": ((3.1, 2.0), Look3D(camera="hold")),
    "3D, orbit": ((3.1,), Look3D(camera="orbit")),
}


@pytest.fixture
def written(monkeypatch):
    """Texts that the canvas writes: words, size and rectangle (left, bottom, right, top) [pixels]."""
    found, write = [], Canvas.text

    def text(self, x, y, words, style):
        wide, high = self.text_width(words, style.size, style.weight), 0.73 * style.size * self.unit
        left = x - {"left": 0.0, "center": 0.5, "right": 1.0}[style.anchor] * wide
        low = y - {"baseline": 0.0, "center": 0.5, "top": 1.0}[style.vertical] * high
        found.append((words, style.size * self.unit, (left, low, left + wide, low + high)))
        write(self, x, y, words, style)

    monkeypatch.setattr(Canvas, "text", text)
    return found


def plotted(canvas):
    """The same of the texts of the canvas's figure."""
    drawn = []
    for axes in canvas.figure.axes:
        spans = ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim()))
        drawn += [axes.xaxis.label, axes.yaxis.label]
        for axis, (least, most) in spans:
            drawn += [tick.label1 for tick in axis.get_major_ticks() if least <= tick.get_loc() <= most]
    return [
        (text.get_text(), text.get_size() * canvas.figure.dpi / 72.0, text.get_window_extent(canvas._renderer).extents)
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
    for k in range(0, shown.count, 3):
        written.clear()
        shown.draw(k)
        texts = still + written + plotted(shown.canvas)
        seen += len(texts)
        assert min(size for _, size, _ in texts) >= LEAST * share - 1e-9, min((size, words) for words, size, _ in texts)
        for words, _, (left, low, right, top) in texts:
            assert left >= -0.5, words
            assert low >= -0.5, words
            assert right <= look.size[0] + 0.5, words
            assert top <= look.size[1] + 0.5, words
        for (one, _, a), (other, _, b) in itertools.combinations(texts, 2):
            if {one, other} <= {"A", "B"}:
                continue  # letters of hoops at one place: the disc of the first one hides the other
            across, up = min(a[2], b[2]) - max(a[0], b[0]), min(a[3], b[3]) - max(a[1], b[1])
            assert across <= 0.5 or up <= 0.5, (k, one, other, a, b)
    assert seen > 6
    if isinstance(shown, Film3D):
        shown.close()


def projected(film, k, point):
    """A point of the world in the k-th picture, from the lower left [pixels]; computed from where the camera stands."""
    eye, focus = (path[min(k, len(path) - 1)] for path in film._path)
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
    with Film3D([motion(3.1, slope=slope)], Timing(fps=10), Look3D(camera=camera)) as film:
        for k in (0, 4):
            written.clear()
            film.draw(k)
            numbers = {words: box for words, _, box in written if re.fullmatch(r"−?\d+ m", words)}
            assert len(numbers) >= 2
            for words, (left, _, right, top) in numbers.items():
                along = float(words.removesuffix(" m").replace("−", "-"))
                edge = projected(film, k, (along * math.cos(slope), -1.1, -along * math.sin(slope)))
                assert 0.5 * (left + right) == pytest.approx(edge[0], abs=1.0)
                assert 4.0 < edge[1] - top < 15.0


def test_distances_leave_room_for_labels_of_events(written):
    """The label of the landing at 9.2 m takes the place of a number; those beside it stay."""
    with Film3D([motion(3.1)], Timing(fps=10), Look3D(camera="hold")) as film:
        film.draw(0)
        before = {words for words, _, _ in written if words.endswith(" m")}
        written.clear()
        film.draw(film.count - 1)
        after = {words for words, _, _ in written if words.endswith(" m")}
    assert after < before
    assert len(after) >= len(before) - 2


def test_words_of_a_narrow_view_stay_in_it():
    drawn = []
    canvas = SimpleNamespace(
        unit=1.0,
        disc=lambda *_: None,
        text=lambda x, y, words, *_, **__: drawn.append(words),
        text_width=lambda words, size, *_: 0.6 * size * len(words),
    )
    line = StateLine("roll", t=0.5, angle=0.3, extra="v = 1.00 m/s")
    for room, count in ((1000.0, 4), (400.0, 2), (288.0, 1)):
        drawn.clear()
        draw_state(canvas, SimpleNamespace(ink="#000000"), (0.0, 0.0), line, room)
        assert len(drawn) == count
