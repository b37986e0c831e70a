"""What the tests of films in 3D and of their texts share."""

import pytest

from hophoop.animate import film3d
from hophoop.animate.sheet import FONT, MODE_FONT, Sheet


@pytest.fixture(scope="session", autouse=True)
def quick():
    """Smooth edges take most of the time of software rendering."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(film3d, "SMOOTH", 0)
        yield


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
