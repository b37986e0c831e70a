"""Backgrounds and inks of films. Colours with a meaning are in `hophoop.vocabulary.colors`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from hophoop.vocabulary import colors


@dataclass(frozen=True)
class Theme:
    """Colours without a meaning.

    Attributes
    ----------
    background, ground, ink, muted : str
        Colours of the background, the plane, text and lines, and secondary text.
    load : str
        Load and its trace: black, or white on a black background.
    outline : str
        Outline of the ring, so that the ends of the colour map are visible.
    dark : bool
        Whether the background is dark.
    """

    background: str
    ground: str
    ink: str
    muted: str
    load: str
    outline: str
    dark: bool = False

    def visible(self, color: str) -> str:
        """Lighten a colour for a dark background, with the same hue.

        color: as ``#RRGGBB``; result: as ``#RRGGBB``.
        """
        if not self.dark:
            return color
        if color == colors.BLACK:
            return self.ink
        return colors.on_dark(color)


THEMES: Final[dict[str, Theme]] = {
    "light": Theme("#FCFCFB", "#E7E5E0", "#1B1B1B", colors.GRAY, colors.LOAD, "#3A3A3A"),
    "dark": Theme("#14161A", "#2A2E35", "#F2F2F2", "#A6ABB3", "#FFFFFF", "#E0E0E0", dark=True),
    "print": Theme("#FFFFFF", "#FFFFFF", "#000000", "#4D4D4D", colors.LOAD, "#000000"),
}
