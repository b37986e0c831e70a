"""Colours and names of the classes of motions in maps, the same in figures and in the lab."""

from __future__ import annotations

import zlib
from typing import Final

from hophoop.vocabulary import modes, palette, words
from hophoop.vocabulary.events import EVENTS
from hophoop.vocabulary.fates import FATES
from hophoop.vocabulary.statuses import STATUSES

SEQUENCE: Final = "sequence"

# Colours of words of coded quantities, by quantity.
CODES: Final[dict[str, dict[str, str]]] = {
    "hop": {"no": palette.LIGHT_GRAY, "yes": palette.VERMILION},
    "painleve": {"no": palette.LIGHT_GRAY, "yes": palette.BLACK},
    "ending": {
        "duration": palette.GRAY, "revolutions": palette.BLUE, "reversal": palette.GREEN,
        "takeoff": palette.VERMILION, "rest": palette.SKY, "jam": palette.BLACK,
        "undetermined": palette.YELLOW, "event_limit": palette.PURPLE,
    },
    "status": {str(status): facts.color for status, facts in STATUSES.items()},
    "first_event": {str(kind): facts.color for kind, facts in EVENTS.items() if facts.color},
    "fate": {words.identifier(fate): facts.color for fate, facts in FATES.items()},
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
    ('#c6ebeb', False)
    >>> class_color("yes", "hop")
    '#D55E00'
    """
    if quantity != SEQUENCE:
        return CODES.get(quantity, {}).get(name, palette.GRAY)
    first = next((letter for letter in name if letter in "SK"), "R")
    if "M" in name:
        does = [word for word, there in (("rolls", name.startswith("R")), ("slips", "S" in name or "K" in name)) if there]
        ink = MASSLESS[", ".join(does)]
    else:
        ink = HOPS if name.endswith("H") else FAMILIES.get(first + name[-1:], ROLLS)
    base = [int(ink[i : i + 2], 16) / 255.0 for i in (1, 3, 5)]
    middle = sum(base) / 3.0
    depth = min(len(name) - 1, 9) / 9.0
    # classes of equal length and family differ slightly, by their names
    drift = (zlib.crc32(name.encode()) % 1000) / 1000.0
    light, dark = 0.62 - 0.62 * min(2.0 * depth, 1.0), max(2.0 * depth - 1.0, 0.0) * 0.5
    shades = []
    for part in base:
        mixed = (1.0 - 0.2 * drift) * part + 0.2 * drift * middle
        shades.append(min(max((mixed + (1.0 - mixed) * light) * (1.0 - dark), 0.0), 1.0))
    return "#" + "".join(f"{round(255 * shade):02x}" for shade in shades)


def class_text(name: str, quantity: str = SEQUENCE) -> str:
    """Return a class in words.

    Parameters
    ----------
    name : str
        As in `class_color`.
    quantity : str, default 'sequence'

    Returns
    -------
    text : str
        Spin and skid are those of a hoop that turns forward; the letters do not tell which way it turns.

    Examples
    --------
    >>> class_text("RKH"), class_text("event_limit", "ending")
    ('roll → skid → flight', 'event limit')
    """
    if quantity != SEQUENCE:
        return words.plain(name)
    return " → ".join(modes.LETTERS[letter] for letter in name)
