"""Fates of motions: what becomes of a hoop in the end, one row of a table each.

A new fate needs a member of `Fate`, a row of `FATES`, and a decision in `gaits.kernels.fates`.
"""

from __future__ import annotations

from typing import Final, NamedTuple

from hophoop.vocabulary import palette
from hophoop.vocabulary.words import Word


class Fate(Word):
    """What becomes of a motion in the end."""

    ROLLS_AHEAD = "rolls ahead"
    ROLLS_BACK = "rolls back"
    SLIPS_EVER_LESS = "slips ever less"
    ROCKS = "rocks"
    RESTS = "rests"
    SLIDES_AWAY = "slides away"
    GAIT = "gait"
    CHAOTIC = "chaotic"
    RUNS_AWAY = "runs away"
    JAM = "jam"
    UNDETERMINED = "undetermined"
    UNDECIDED = "undecided"


FATE_CODES: Final = tuple(Fate)
"""By the numbers that the kernels use for them."""


class FateFacts(NamedTuple):
    """Facts about a fate."""

    sentence: str
    lasts: bool  # whether the hoop moves for ever
    color: str


FATES: Final[dict[str, FateFacts]] = {
    Fate.ROLLS_AHEAD: FateFacts("It rolls ahead for ever, without slip.", True, palette.BLUE),
    Fate.ROLLS_BACK: FateFacts("It rolls back for ever, without slip.", True, palette.SKY),
    Fate.SLIPS_EVER_LESS: FateFacts("It goes on for ever and slips in each revolution, ever less.", True, palette.ORANGE),
    Fate.ROCKS: FateFacts("It rocks to and fro and never gets over the top again.", True, palette.GREEN),
    Fate.RESTS: FateFacts("It comes to rest.", False, palette.GRAY),
    Fate.SLIDES_AWAY: FateFacts("It slides away: friction does not hold it.", True, palette.YELLOW),
    Fate.GAIT: FateFacts("It settles on a gait: each period is like the last one.", True, palette.VERMILION),
    Fate.CHAOTIC: FateFacts(
        "It has not repeated itself so far: near motions separate exponentially. Such chaos may end later.", True, palette.BLACK
    ),
    Fate.RUNS_AWAY: FateFacts("It gets faster without bound.", True, palette.PURPLE),
    Fate.JAM: FateFacts("It jams: rigid-body mechanics has no motion beyond.", False, "#332288"),
    Fate.UNDETERMINED: FateFacts("The model does not determine the motion beyond.", False, "#9E9D24"),
    Fate.UNDECIDED: FateFacts("The run was too short to say.", False, palette.LIGHT_GRAY),
}
