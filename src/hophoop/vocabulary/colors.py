"""One meaning for each colour, in plots, films, maps and the lab. Modes also differ in lightness.

Plain strings and numbers, without Matplotlib, so that any front end can use them.
"""

from __future__ import annotations

from functools import reduce
from typing import Final

from hophoop._support.errors import InputError
from hophoop.kernel.physics.body import Event, Status
from hophoop.vocabulary.names import FLIGHT, ROLL, SEQUENCE, SKID, SKIM, SPIN, Fate, identifier

# The colours of Okabe and Ito (2008), distinct with every kind of colour blindness, and two grays.
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

MODES: Final = {ROLL: BLUE, SPIN: ORANGE, SKID: PURPLE, FLIGHT: VERMILION, SKIM: YELLOW}
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


def rgb(color: str) -> tuple[int, int, int]:
    """Return red, green and blue of a colour, from 0 to 255; color: as ``#RRGGBB``."""
    return int(color[1:3], 16), int(color[3:5], 16), int(color[5:7], 16)


def mix(color: str, other: str, share: float) -> str:
    """Interpolate between two colours."""
    return "#" + "".join(f"{round(a + share * (b - a)):02X}" for a, b in zip(rgb(color), rgb(other), strict=True))


def lightness(color: str) -> float:
    """Return the perceived lightness of a colour.

    color: as ``#RRGGBB``; lightness: from 0 to 1 [1].
    """
    red, green, blue = rgb(color)
    return (0.30 * red + 0.59 * green + 0.11 * blue) / 255.0


def on_dark(color: str) -> str:
    """Return a colour light enough for a dark background: the same hue, with more white.

    color, result: as ``#RRGGBB``.

    Examples
    --------
    >>> on_dark("#1B3A78"), on_dark(YELLOW)
    ('#677CA5', '#F0E442')
    """
    light = lightness(color)
    return mix(color, "#FFFFFF", max(0.0, LEAST_LIGHTNESS - light) / max(1.0 - light, 1e-9))


def mode_color(word: str) -> str:
    """Return the colour of a mode.

    word: roll, spin, skid, flight or skim, as `modes.mode_word` returns it: the colour follows the word, not the letter; color:
    as ``#RRGGBB``.
    """
    if word not in MODES:
        raise InputError.of_field("word", word, f"one of {', '.join(MODES)}")
    return MODES[word]


# --- maps -------------------------------------------------------------------------------------------

STATUSES: Final = {
    Status.COMPLETED: BLUE,
    Status.AT_REST: SKY,
    Status.JAMMED: BLACK,
    Status.UNDETERMINED: YELLOW,
    Status.EVENT_LIMIT: PURPLE,
}
FIRST_EVENTS: Final = {
    Event.SLIP_START: ORANGE,
    Event.STICK: BLUE,
    Event.SLIP_REVERSAL: PURPLE,
    Event.TAKEOFF: VERMILION,
    Event.IMPACT: YELLOW,
    Event.TURN: GREEN,
    Event.JAM: BLACK,
    Event.REST: LIGHT_GRAY,
    Event.END: SKY,
}
FATES: Final = {
    Fate.ROLLS_AHEAD: BLUE,
    Fate.ROLLS_BACK: SKY,
    Fate.SLIPS_EVER_LESS: ORANGE,
    Fate.ROCKS: GREEN,
    Fate.RESTS: GRAY,
    Fate.SLIDES_AWAY: YELLOW,
    Fate.GAIT: VERMILION,
    Fate.CHAOTIC: BLACK,
    Fate.RUNS_AWAY: PURPLE,
    Fate.JAM: "#332288",
    Fate.UNDETERMINED: "#9E9D24",
    Fate.UNDECIDED: LIGHT_GRAY,
}
# Colours of words of coded quantities, by quantity.
CODES: Final[dict[str, dict[str, str]]] = {
    "hop": {"no": LIGHT_GRAY, "yes": VERMILION},
    "painleve": {"no": LIGHT_GRAY, "yes": BLACK},
    "ending": {
        "duration": GRAY, "revolutions": BLUE, "reversal": GREEN,
        "takeoff": VERMILION, "rest": SKY, "jam": BLACK,
        "undetermined": YELLOW, "event_limit": PURPLE,
    },
    "status": {status.name.lower(): color for status, color in STATUSES.items()},
    "first_event": {kind.name.lower(): color for kind, color in FIRST_EVENTS.items()},
    "fate": {identifier(fate): color for fate, color in FATES.items()},
}  # fmt: skip
# Colours of sequences, none of them a single mode's; told apart with every kind of colour blindness.
HOPS: Final = "#332288"  # indigo
ROLLS: Final = "#66CCCC"  # cyan
# Of motions that do not hop, by their first slip and their last phase.
FAMILIES: Final = {
    "SR": "#009966", "SS": "#9E9D24", "SK": "#CCCC99",
    "KR": "#663300", "KS": "#1A1A40", "KK": "#3366FF",
}  # fmt: skip
# Of massless motions, by whether they roll before they skim, and whether they slip.
MASSLESS: Final = {"rolls": "#9E9D24", "rolls, slips": "#663300", "": "#009966", "slips": "#332288"}


def class_color(name: str, quantity: str = SEQUENCE) -> str:
    """Return the colour of a class of motion, the same in every map.

    A class is given by letters alone, which determine its colour; it is no mode's colour.

    Parameters
    ----------
    name : str
        A sequence such as ``"RKRSH"``, or a word of another quantity.
    quantity : str, default 'sequence'
        The map's quantity that the name is one of.

    Returns
    -------
    color : str
        As ``#RRGGBB``. Sequences that hop are indigo and those that only roll cyan; the others differ by
        their first slip and by how they end, and the more phases, the darker they are.

    Examples
    --------
    >>> class_color("R"), class_color("RKRSH") == class_color("RKRSR")
    ('#c5ebeb', False)
    >>> class_color("yes", "hop")
    '#D55E00'
    """
    if quantity != SEQUENCE:
        return CODES.get(quantity, {}).get(name, GRAY)
    first = next((letter for letter in name if letter in "SK"), "R")
    if "M" in name:
        does = [word for word, there in (("rolls", name.startswith("R")), ("slips", "S" in name or "K" in name)) if there]
        ink = MASSLESS[", ".join(does)]
    else:
        ink = HOPS if name.endswith("H") else FAMILIES.get(first + name[-1:], ROLLS)
    base = [part / 255.0 for part in rgb(ink)]
    middle = (base[0] + base[1] + base[2]) / 3.0  # `sum` rounds otherwise from Python 3.12 on
    depth = min(len(name) - 1, 9) / 9.0
    # classes of equal length and family differ slightly, by their names
    drift = 0.2 * (reduce(lambda total, letter: (131 * total + ord(letter)) % 997, name, 0) / 997)
    light, dark = 0.62 - 0.62 * min(2.0 * depth, 1.0), max(2.0 * depth - 1.0, 0.0) * 0.5
    mixed = [(1.0 - drift) * part + drift * middle for part in base]
    shades = [255 * (part + (1.0 - part) * light) * (1.0 - dark) for part in mixed]
    return "#" + "".join(f"{int(shade + 0.5):02x}" for shade in shades)  # halves up, as on the page
