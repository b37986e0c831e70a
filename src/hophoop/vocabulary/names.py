"""Names and words of what the kernels number: modes, events, statuses, laws of impact and fates.

The numbers and the letters of modes are the kernel's (`kernel.physics.body`); files and results have its names in lower case.

A mode's letter gives the sign of the slip velocity: S for v_t < 0, K for v_t > 0. Its word follows the rotation as well: a hoop
spins where v_t θ̇ < 0 (the rim turns too fast for its motion along the plane) and skids where v_t θ̇ > 0 (it slides ahead) or
θ̇ = 0. With θ̇ > 0, S is spin and K is skid; with θ̇ < 0 it is the other way round. Colours follow the words.

A new mode, event, status or law needs a member of the kernel's enum and a row here; docs/architecture.md has recipes. A new
fate needs a member of `Fate`, a row of `FATES`, and a decision in `gaits.kernels.fates`. Colours are in `vocabulary.colors`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from enum import IntEnum, StrEnum
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Final, NamedTuple

from hophoop._support.errors import InputError
from hophoop.kernel.physics.body import MODE_LETTERS, PASSING, Event, ImpactLaw, Mode, Status

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


def identifier(word: Any) -> str:
    """Return words as an identifier of the file format, such as slips_ever_less for 'slips ever less'."""
    return str(word).replace(" ", "_")


def plain(word: Any) -> str:
    """Return an identifier of the file format as words, such as 'slip start' for slip_start."""
    return str(word).replace("_", " ")


# --- modes ------------------------------------------------------------------------------------------

ROLL, SPIN, SKID, FLIGHT, SKIM = "roll", "spin", "skid", "flight", "skim"


class WordFacts(NamedTuple):
    """Verb and participle of a mode's word."""

    verb: str
    participle: str


WORDS: Final[dict[str, WordFacts]] = {
    ROLL: WordFacts("rolls", "rolling"),
    SPIN: WordFacts("spins", "spinning"),
    SKID: WordFacts("skids", "skidding"),
    FLIGHT: WordFacts("flies", "in flight"),
    SKIM: WordFacts("skims the plane", "skimming"),  # of the massless hoop
}
"""The words for modes that people are shown."""


class ModeFacts(NamedTuple):
    """Words of a mode, by the direction of rotation."""

    ahead: str  # for θ̇ > 0
    back: str  # for θ̇ < 0
    at_rest: str  # for θ̇ = 0


MODES: Final[dict[Mode, ModeFacts]] = {
    Mode.ROLL: ModeFacts(ROLL, ROLL, ROLL),
    Mode.SPIN: ModeFacts(SPIN, SKID, SKID),
    Mode.SKID: ModeFacts(SKID, SPIN, SKID),
    Mode.FLIGHT: ModeFacts(FLIGHT, FLIGHT, FLIGHT),
    Mode.SKIM: ModeFacts(SKIM, SKIM, SKIM),
}

MODE_WORDS: Final = tuple(facts.ahead for facts in MODES.values())
"""Words in the order of the letters, for θ̇ > 0; also the names of the modes in files."""
LETTERS: Final = dict(zip(MODE_LETTERS, MODE_WORDS, strict=True)) | {"+": "…"}
"""Words for the letters of a sequence, for θ̇ > 0; '+' is the end of one that is too long."""


def mode_word(letter: str, omega: float) -> str:
    """Return the word for a mode at an angular velocity.

    letter: R, S, K, H or M; S and K are the sign of the slip velocity v_t; omega: θ̇ [rad/s]; word: roll, spin, skid, flight or
    skim.

    Examples
    --------
    >>> mode_word("S", 3.1), mode_word("S", -0.8)
    ('spin', 'skid')
    """
    for known, facts in zip(MODE_LETTERS, MODES.values(), strict=True):
        if known == letter:
            return facts.ahead if omega > 0.0 else facts.back if omega < 0.0 else facts.at_rest
    raise InputError.of_field("letter", letter, f"one of {', '.join(MODE_LETTERS)}")


def mode_words(letters: ArrayLike, omega: ArrayLike) -> NDArray[np.str_]:
    """Return the words for modes at angular velocities, each as `mode_word` gives it.

    letters: R, S, K, H or M; any other stays as it is; omega: θ̇ [rad/s].
    """
    import numpy as np  # here: `hophoop --help` needs names alone

    signs, rate = np.broadcast_arrays(np.asarray(letters), np.asarray(omega, dtype=float))
    words = signs.astype("U6")
    for letter, facts in zip(MODE_LETTERS, MODES.values(), strict=True):
        here = signs == letter
        words[here] = facts.at_rest
        words[here & (rate > 0.0)], words[here & (rate < 0.0)] = facts.ahead, facts.back
    return words


def coming_rotation(omega: ArrayLike) -> NDArray[np.float64]:
    """Return directions of rotation in order of time; a zero takes the direction of the next value that is not zero.

    omega: shape (n,), θ̇ [rad/s]; direction: shape (n,), −1, 0 or 1 [1]; zeros at the end take the last direction.
    """
    import numpy as np

    sign: NDArray[np.float64] = np.sign(np.nan_to_num(np.asarray(omega, dtype=float)))
    turning = np.flatnonzero(sign)
    if turning.size == 0:
        return sign
    following = np.searchsorted(turning, np.arange(sign.size))
    found: NDArray[np.float64] = sign[turning[np.minimum(following, turning.size - 1)]]
    return found


# --- events and sequences ---------------------------------------------------------------------------


class EventFacts(NamedTuple):
    """Facts about a kind of event."""

    noun: str  # in figures and films
    label: str  # in the lab
    when: str  # in the documentation
    mark: tuple[int, str] | None = None  # in figures: priority among many marks, and Matplotlib's marker
    sign: tuple[int, str] | None = None  # on the lab's time bar: priority and character
    filmed: bool = False  # whether films mark it
    summed_up: bool = True  # whether a summary of the motion mentions it


_EVENTS: Final[dict[Event, EventFacts]] = {
    Event.START: EventFacts("start", "start", "at the beginning"),
    Event.SLIP_START: EventFacts("slip starts", "slip starts", "rolling ends, and the rim slips"),
    Event.STICK: EventFacts("slip ends", "slip ends", "slip ends, and the hoop rolls"),
    Event.SLIP_REVERSAL: EventFacts("slip reverses", "slip reverses", "slip goes over into slip the other way"),
    Event.TAKEOFF: EventFacts("take-off", "take-off", "contact ends", (4, "^"), (7, "▲"), filmed=True),
    Event.IMPACT: EventFacts(
        "landing", "landing", "velocities jump: a landing, or an impact without collision (`collision` false)",
        (3, "v"), (8, "▼"), filmed=True,
    ),
    Event.TURN: EventFacts(
        "turns back", "turns back", "the hoop turns back, θ̇ = 0; the mode stays", (5, "<"), (9, "↺"), summed_up=False,
    ),
    Event.APEX: EventFacts(
        "apex", "highest point", "the centre is highest in a flight; the mode stays", (7, "d"), (10, "•"), summed_up=False,
    ),
    Event.BOUNCE_LIMIT: EventFacts(
        "end of the bounces", "bounces end", "bounces that become shorter and shorter have come to their end", sign=(4, "≋"),
    ),
    Event.PAINLEVE_INCONSISTENT: EventFacts(
        "Painlevé", "Painlevé: no solution", "Painlevé's paradox: no force obeys all the laws", (1, "X"), (1, "◆"), filmed=True,
    ),
    Event.PAINLEVE_INDETERMINATE: EventFacts(
        "Painlevé", "Painlevé: several solutions", "Painlevé's paradox: several motions obey them",
        (2, "X"), (2, "◇"), filmed=True,
    ),
    Event.JAM: EventFacts(
        "jam", "jam", "the normal force grows beyond all bounds; the motion ends", (0, "X"), (0, "✖"), filmed=True,
    ),
    Event.KANE_GAIN: EventFacts(
        "gain of energy", "energy gain (Kane)", "Newton's law has created energy in an impact; `gain` says how much",
        sign=(3, "✚"),
    ),
    Event.SKIM: EventFacts(
        "skims", "skimming starts", "the massless hoop loses the contact force, and its rim touches without one",
        (6, "s"), (5, "◗"),
    ),
    Event.REST: EventFacts("rest", "at rest", "the hoop comes to rest", sign=(6, "■")),
    Event.END: EventFacts("end", "end", "at the end", summed_up=False),
}  # fmt: skip
EVENTS: Final = {kind.name.lower(): facts for kind, facts in _EVENTS.items()}
"""By name."""


def _ranked(facts: dict[str, tuple[int, str] | None]) -> dict[str, str]:
    ordered = sorted((fact, kind) for kind, fact in facts.items() if fact)
    return {kind: shown for (_, shown), kind in ordered}


MARKS: Final = _ranked({kind: facts.mark for kind, facts in EVENTS.items()})
"""Matplotlib's markers by kind, highest priority first."""
SIGNS: Final = _ranked({kind: facts.sign for kind, facts in EVENTS.items()})
"""Characters by kind, the rarest first."""


def phase_starts(kinds: Sequence[int]) -> list[int]:
    """Return the indices of the events that end a phase and start the next.

    kinds: Members of the kernel's `Event`, in order.

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

    kinds: Of the events in order, members of the kernel's `Event`; modes: The mode after each event; times: Time of each event,
    in any arithmetic with <; takes_off: Whether a take-off ended the motion; its flight counts although it has no duration;
    sequence: R roll, S slip with v_t < 0, K with v_t > 0, H flight (hop), M skim. Without a phase of nonzero duration, the mode
    after the last event; empty without events.

    Examples
    --------
    >>> from hophoop.kernel.physics.body import Event, Mode
    >>> kinds = [Event.START, Event.TURN, Event.SLIP_START, Event.END]
    >>> sequence_of(kinds, [Mode.ROLL, Mode.ROLL, Mode.SKID, Mode.SKID], [0.0, 1.0, 2.0, 3.0])
    'RK'
    """
    if not kinds:
        return MODE_LETTERS[Mode.FLIGHT] if takes_off else ""
    marks = [*phase_starts(kinds[:-1]), len(kinds) - 1]
    letters = "".join(MODE_LETTERS[modes[a]] for a, b in pairwise(marks) if times[a] < times[b])
    if takes_off:
        return letters + MODE_LETTERS[Mode.FLIGHT]
    return letters or MODE_LETTERS[modes[-1]]


SEQUENCE: Final = "sequence"
"""The quantity of a map whose classes are sequences."""


def class_text(name: str, quantity: str = SEQUENCE) -> str:
    """Return a class in words.

    name: As in `class_color`; text: Spin and skid are those of a hoop that turns forward; the letters do not tell which way it
    turns.

    Examples
    --------
    >>> class_text("RKH"), class_text("event_limit", "ending")
    ('roll → skid → flight', 'event limit')
    """
    if quantity != SEQUENCE:
        return plain(name)
    return " → ".join(LETTERS[letter] for letter in name)


# --- statuses ---------------------------------------------------------------------------------------


class StatusFacts(NamedTuple):
    """Facts about a status."""

    sentence: str  # empty if the motion reached its duration
    means: str  # in the documentation
    stopped: str = ""  # in films, if the motion has no answer beyond; the command line then exits with status 1

    @property
    def ok(self) -> bool:
        """Whether the motion reached its end."""
        return not self.stopped


_STATUSES: Final[dict[Status, StatusFacts]] = {
    Status.COMPLETED: StatusFacts("", "it was followed to the end of its duration"),
    Status.AT_REST: StatusFacts("It has come to rest.", "it came to rest before"),
    Status.JAMMED: StatusFacts(
        "The normal force grows without bound (dynamic jam): rigid-body mechanics has no motion beyond.",
        "it ran into the jam, where the rigid model ends", "jammed",
    ),
    Status.UNDETERMINED: StatusFacts(
        "The model does not determine the motion beyond.", "the model does not say how it goes on", "no answer"
    ),
    Status.EVENT_LIMIT: StatusFacts(
        "The limit of events (contact.max_events), or of work for one motion, was reached before the end.",
        "it used up the events or steps that it may take ({doc}`testing`)", "stopped",
    ),
}  # fmt: skip
STATUSES: Final = {status.name.lower(): facts for status, facts in _STATUSES.items()}
"""By name."""


# --- laws of impact ---------------------------------------------------------------------------------


LAWS: Final = {
    ImpactLaw.STRONGE: "Stronge (energy)",
    ImpactLaw.NEWTON: "Newton (velocity)",
    ImpactLaw.POISSON: "Poisson (impulse)",
}
"""Labels in the lab; the default first."""
LAW_CODES: Final = {law.name.lower(): int(law) for law in LAWS}
"""The kernels' numbers by name in scenarios."""
NAMED_LAWS: Final = f"{', '.join(list(LAW_CODES)[:-1])} or {list(LAW_CODES)[-1]}"
"""All names in words, for help texts."""


# --- spans ------------------------------------------------------------------------------------------


def number_after(word: str, text: object) -> float:
    """Return the number in a text such as ``revolutions:3``.

    word: Before the colon; number: nan if the text does not start with the word, or no finite number follows.

    Examples
    --------
    >>> number_after("revolutions", "revolutions:3")
    3.0
    """
    found, _, number = str(text).partition(":")
    try:
        value = float(number) if found == word else math.nan
    except ValueError:
        return math.nan
    return value if math.isfinite(value) else math.nan


# --- fates ------------------------------------------------------------------------------------------


class Fate(StrEnum):
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

    def __repr__(self) -> str:
        return repr(self.value)


FATE_CODES: Final = tuple(Fate)
"""By the numbers that the kernels use for them."""


def _numbered(words: type[StrEnum]) -> Any:
    """Return the members of an enum of words as an IntEnum, numbered in their order."""
    return IntEnum(f"{words.__name__}Code", [(word.name, code) for code, word in enumerate(words)])


FateCode: Final = _numbered(Fate)
"""The number that the kernels use for each fate."""


class FateFacts(NamedTuple):
    """Facts about a fate."""

    sentence: str
    lasts: bool  # whether the hoop moves for ever


FATES: Final[dict[str, FateFacts]] = {
    Fate.ROLLS_AHEAD: FateFacts("It rolls ahead for ever, without slip.", True),
    Fate.ROLLS_BACK: FateFacts("It rolls back for ever, without slip.", True),
    Fate.SLIPS_EVER_LESS: FateFacts("It goes on for ever and slips in each revolution, ever less.", True),
    Fate.ROCKS: FateFacts("It rocks to and fro and never gets over the top again.", True),
    Fate.RESTS: FateFacts("It comes to rest.", False),
    Fate.SLIDES_AWAY: FateFacts("It slides away: friction does not hold it.", True),
    Fate.GAIT: FateFacts("It settles on a gait: each period is like the last one.", True),
    Fate.CHAOTIC: FateFacts(
        "It has not repeated itself so far: near motions separate exponentially. Such chaos may end later.", True
    ),
    Fate.RUNS_AWAY: FateFacts("It gets faster without bound.", True),
    Fate.JAM: FateFacts("It jams: rigid-body mechanics has no motion beyond.", False),
    Fate.UNDETERMINED: FateFacts("The model does not determine the motion beyond.", False),
    Fate.UNDECIDED: FateFacts("The run was too short to say.", False),
}
