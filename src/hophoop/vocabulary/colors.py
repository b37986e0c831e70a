"""One meaning for each colour, in plots, films, maps and the lab. Modes also differ in lightness.

Plain strings and numbers, without Matplotlib, so that any front end can use them.
"""

from __future__ import annotations

from typing import Final

from hophoop._support.errors import InputError
from hophoop.vocabulary.modes import WORDS

# other packages use these as `colors.GRAY`
from hophoop.vocabulary.palette import (  # isort: skip
    BLACK as BLACK, BLUE as BLUE, GRAY as GRAY, GREEN as GREEN, LIGHT_GRAY as LIGHT_GRAY, ORANGE as ORANGE,
    PURPLE as PURPLE, SKY as SKY, VERMILION as VERMILION, YELLOW as YELLOW,
)  # fmt: skip

MODES: Final = {word: facts.color for word, facts in WORDS.items()}
"""Colour of each mode, by its word: what spins is orange in both directions of rolling."""

LOAD: Final = BLACK  # trace of the load, and the load itself
GRAVITY_CENTER: Final = GREEN  # trace of the centre of gravity in contact
GRAVITY_CENTER_AIRBORNE: Final = "#CC1F1A"  # the same while airborne: red, as in the article

# Quantities in plots against time or angle: dark colours that no mode has, with different dashes. Brown is friction, both force
# and loss; black needs no colour.
CENTER_SPEED: Final = BLACK  # v, velocity of the centre
ROTATION_SPEED: Final = "#00857A"  # Rθ̇
KINETIC: Final = "#1B3A78"
POTENTIAL: Final = "#667300"
TOTAL: Final = BLACK
FRICTION_LOSS: Final = "#8F3B0A"
IMPACT_LOSS: Final = "#8E1B5F"
NORMAL_FORCE: Final = "#5B3FA8"
FRICTION_FORCE: Final = FRICTION_LOSS
LIMIT: Final = GRAY  # a limit, such as a friction utilization of 1

SERIES: Final = (BLACK, "#4A7A8C", "#A0522D", "#6A5A8C", "#5A7A3A", "#9A4A6A", GRAY)
"""Lines without a meaning of their own, such as several motions; markers and dashes differ too."""

RING_SPEED_MAP: Final = "viridis"
"""Matplotlib's colour map for the speed of the ring's points."""

SHADE: Final = 0.18
"""Opacity of a mode's colour as a background."""

LEAST_LIGHTNESS: Final = 0.48
"""Of a colour on a dark background, from 0 to 1."""


def lightness(color: str) -> float:
    """Return the perceived lightness of a colour.

    color: as ``#RRGGBB``; lightness: from 0 to 1 [1].
    """
    parts = [int(color[i : i + 2], 16) for i in (1, 3, 5)]
    return (0.30 * parts[0] + 0.59 * parts[1] + 0.11 * parts[2]) / 255.0


def on_dark(color: str) -> str:
    """Return a colour light enough for a dark background: the same hue, with more white.

    Parameters
    ----------
    color : str
        As ``#RRGGBB``.

    Returns
    -------
    color : str
        As ``#RRGGBB``.

    Examples
    --------
    >>> on_dark("#1B3A78"), on_dark(YELLOW)
    ('#677CA5', '#F0E442')
    """
    parts = [int(color[i : i + 2], 16) for i in (1, 3, 5)]
    light = lightness(color)
    share = max(0.0, LEAST_LIGHTNESS - light) / max(1.0 - light, 1e-9)
    return "#" + "".join(f"{round(part + share * (255 - part)):02X}" for part in parts)


def mode_color(word: str) -> str:
    """Return the colour of a mode.

    word: roll, spin, skid, flight or skim, as `modes.mode_word` returns it: the colour follows the word, not the letter; color:
    as ``#RRGGBB``.
    """
    if word not in MODES:
        raise InputError.of_field("word", word, f"one of {', '.join(MODES)}")
    return MODES[word]
