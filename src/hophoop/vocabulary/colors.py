"""One meaning for each colour, in plots, films, maps and the lab. The set is that of Okabe and Ito (2008),
told apart with every kind of colour blindness; modes also differ in lightness.

Plain strings and numbers, without Matplotlib, so that any front end can use them.
"""

from __future__ import annotations

from typing import Final

from hophoop.vocabulary import words

# Okabe and Ito's eight
BLACK: Final = "#000000"
ORANGE: Final = "#E69F00"
SKY: Final = "#56B4E9"
GREEN: Final = "#009E73"
YELLOW: Final = "#F0E442"
BLUE: Final = "#0072B2"
VERMILION: Final = "#D55E00"
PURPLE: Final = "#CC79A7"

GRAY: Final = "#6E6E6E"
LIGHT_GRAY: Final = "#D9D9D9"

MODES: Final[dict[str, str]] = {
    words.ROLL: BLUE,
    words.SPIN: ORANGE,
    words.SKID: PURPLE,
    words.FLIGHT: VERMILION,
    words.SKIM: YELLOW,  # of the massless hoop
}
"""Colour of each mode, by its word: what spins is orange whichever way the hoop rolls."""

LOAD: Final = BLACK  # trace of the load, and the load itself
GRAVITY_CENTER: Final = GREEN  # trace of the centre of gravity in contact
GRAVITY_CENTER_AIRBORNE: Final = "#CC1F1A"  # the same while airborne: red, as in the article

# Quantities in plots against time or angle: dark inks that are no mode's colour, told apart by dashes as well
CENTER_SPEED: Final = BLACK  # v, velocity of the centre
ROTATION_SPEED: Final = "#00857A"  # Rθ̇
KINETIC: Final = "#1B3A78"
POTENTIAL: Final = "#00857A"
TOTAL: Final = BLACK
FRICTION_LOSS: Final = "#8F3B0A"
IMPACT_LOSS: Final = "#8E1B5F"
NORMAL_FORCE: Final = "#1B3A78"
FRICTION_FORCE: Final = "#8F3B0A"
LIMIT: Final = GRAY  # a limit that is not to be crossed, such as full use of friction

RING_SPEED_MAP: Final = "viridis"
"""Matplotlib's name of the colour map by which the ring's points show their speed."""

SHADE: Final = 0.18
"""Opacity of a mode's colour as a background."""


def mode_color(word: str) -> str:
    """Colour of a mode.

    Parameters
    ----------
    word : str
        roll, spin, skid, flight or skim, as `words.mode_word` gives it: the colour follows the word, not the
        letter.

    Returns
    -------
    color : str
        As ``#RRGGBB``.

    Raises
    ------
    ValueError
        If there is no such mode.
    """
    try:
        return MODES[word]
    except KeyError:
        raise ValueError(f"word = {word!r} must be one of {', '.join(MODES)}.") from None
