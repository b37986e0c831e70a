"""Kinds of events, one row of a table each, and the sequence of letters that they make.

A new kind of event needs a member of the kernel's `Event` (and of `PASSING`, where it does not end a phase), a member of
`EventKind` and a row of `EVENTS`. Its sentence on the page is in web/words, by `story.` and its name.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any, Final, NamedTuple

from hophoop.kernel.physics.body import PASSING
from hophoop.vocabulary import palette
from hophoop.vocabulary.modes import ModeLetter, letter_of
from hophoop.vocabulary.words import Word


class EventKind(Word):
    """Kind of an event, in the order in which simultaneous ones are written."""

    START = "start"
    SLIP_START = "slip_start"
    STICK = "stick"
    SLIP_REVERSAL = "slip_reversal"
    TAKEOFF = "takeoff"
    IMPACT = "impact"
    TURN = "turn"
    APEX = "apex"
    BOUNCE_LIMIT = "bounce_limit"
    PAINLEVE_INCONSISTENT = "painleve_inconsistent"
    PAINLEVE_INDETERMINATE = "painleve_indeterminate"
    JAM = "jam"
    KANE_GAIN = "kane_gain"
    SKIM = "skim"
    REST = "rest"
    END = "end"


EVENT_KINDS: Final = tuple(EventKind)
"""By the numbers that the kernels use for them."""


class EventFacts(NamedTuple):
    """Facts about a kind of event."""

    noun: str  # in figures and films
    label: str  # in the lab
    color: str | None = None  # of maps of the first event
    mark: tuple[int, str] | None = None  # in figures: priority among many marks, and Matplotlib's marker
    sign: tuple[int, str] | None = None  # on the lab's time bar: priority and character
    filmed: bool = False  # whether films mark it
    summed_up: bool = True  # whether a summary of the motion mentions it


EVENTS: Final[dict[str, EventFacts]] = {
    EventKind.START: EventFacts("start", "start"),
    EventKind.SLIP_START: EventFacts("slip starts", "slip starts", palette.ORANGE),
    EventKind.STICK: EventFacts("slip ends", "slip ends", palette.BLUE),
    EventKind.SLIP_REVERSAL: EventFacts("slip reverses", "slip reverses", palette.PURPLE),
    EventKind.TAKEOFF: EventFacts("take-off", "take-off", palette.VERMILION, (4, "^"), (7, "▲"), filmed=True),
    EventKind.IMPACT: EventFacts("landing", "landing", palette.YELLOW, (3, "v"), (8, "▼"), filmed=True),
    EventKind.TURN: EventFacts("turns back", "turns back", palette.GREEN, (5, "<"), (9, "↺"), summed_up=False),
    EventKind.APEX: EventFacts("apex", "highest point", None, (7, "d"), (10, "•"), summed_up=False),
    EventKind.BOUNCE_LIMIT: EventFacts("end of the bounces", "bounces end", sign=(4, "≋")),
    EventKind.PAINLEVE_INCONSISTENT: EventFacts("Painlevé", "Painlevé: no solution", None, (1, "X"), (1, "◆"), filmed=True),
    EventKind.PAINLEVE_INDETERMINATE: EventFacts(
        "Painlevé", "Painlevé: several solutions", None, (2, "X"), (2, "◇"), filmed=True
    ),
    EventKind.JAM: EventFacts("jam", "jam", palette.BLACK, (0, "X"), (0, "✖"), filmed=True),
    EventKind.KANE_GAIN: EventFacts("gain of energy", "energy gain (Kane)", sign=(3, "✚")),
    EventKind.SKIM: EventFacts("skims", "skimming starts", None, (6, "s"), (5, "◗")),
    EventKind.REST: EventFacts("rest", "at rest", palette.LIGHT_GRAY, None, (6, "■")),
    EventKind.END: EventFacts("end", "end", palette.SKY, summed_up=False),
}


def _ranked(facts: dict[str, tuple[int, str] | None]) -> dict[str, str]:
    ordered = sorted((fact, kind) for kind, fact in facts.items() if fact)
    return {kind: shown for (_, shown), kind in ordered}


MARKS: Final = _ranked({kind.value: EVENTS[kind].mark for kind in EVENT_KINDS})
"""Matplotlib's markers by kind, highest priority first."""
SIGNS: Final = _ranked({kind.value: EVENTS[kind].sign for kind in EVENT_KINDS})
"""Characters by kind, the rarest first."""
PASSING_KINDS: Final = tuple(EVENT_KINDS[kind] for kind in PASSING)
"""Kinds that do not end a phase."""


def phase_starts(kinds: Sequence[int]) -> list[int]:
    """Return the indices of the events that end a phase and start the next.

    Parameters
    ----------
    kinds : sequence of int
        Members of the kernel's `Event`, in order.

    Returns
    -------
    indices : list of int

    Examples
    --------
    >>> from hophoop.kernel.physics.body import Event
    >>> phase_starts([Event.START, Event.TURN, Event.SLIP_START, Event.END])
    [0, 2, 3]
    """
    return [place for place, kind in enumerate(kinds) if kind not in PASSING]


def sequence_of(kinds: Sequence[int], modes: Sequence[int], times: Sequence[Any], takes_off: bool = False) -> str:
    """Return the letters of all phases of nonzero duration, in order.

    The kernel of maps (`maps.grid.kernel.reduce_motion`) and the page have their own implementations.

    Parameters
    ----------
    kinds : sequence of int
        Of the events in order, members of the kernel's `Event`.
    modes : sequence of int
        The mode after each event.
    times : sequence
        Time of each event, in any arithmetic with <.
    takes_off : bool, default False
        Whether a take-off ended the motion; its flight counts although it has no duration.

    Returns
    -------
    sequence : str
        R roll, S slip with v_t < 0, K with v_t > 0, H flight (hop), M skim. Without a phase of nonzero duration, the mode
        after the last event; empty without events.

    Examples
    --------
    >>> from hophoop.kernel.physics.body import Event, Mode
    >>> kinds = [Event.START, Event.TURN, Event.SLIP_START, Event.END]
    >>> sequence_of(kinds, [Mode.ROLL, Mode.ROLL, Mode.SKID, Mode.SKID], [0.0, 1.0, 2.0, 3.0])
    'RK'
    """
    if not kinds:
        return ModeLetter.FLIGHT if takes_off else ""
    marks = [*phase_starts(kinds[:-1]), len(kinds) - 1]
    letters = "".join(letter_of(modes[a]) for a, b in pairwise(marks) if times[a] < times[b])
    if takes_off:
        return letters + ModeLetter.FLIGHT
    return letters or letter_of(modes[-1])
