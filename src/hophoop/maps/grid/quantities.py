"""Quantities of a map, spans of a motion, and codes of sequences."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.kernel.model import EVENT_NAMES, STATUS_NAMES
from hophoop.kernel.records import STOP_AT_TAKEOFF, STOP_AT_TURN, unpacked_sequence
from hophoop.maps.grid import kernel, settled
from hophoop.scenario import InputError, Scenario
from hophoop.vocabulary.names import SEQUENCE, number_after

NOT_ALLOWED = "not_allowed"
MOST_SHORT_CODES = 2**15 - 1


class Quantity(NamedTuple):
    """One quantity of a motion that a map can hold.

    Attributes
    ----------
    name : str
    meaning : str
    unit : str
        Of a number; "" for a code.
    words : tuple of str
        Meanings of the codes 0, 1, …; empty for a number, and for the sequence until a map has found its own.
    column : int
        Column of the kernel's results.
    settled : bool
        Whether it belongs to the spans `settled`, or to the others.
    """

    name: str
    meaning: str
    unit: str
    words: tuple[str, ...]
    column: int
    settled: bool = False

    @property
    def is_code(self) -> bool:
        """Whether it is a code and not a number."""
        return self.unit == ""

    @property
    def dtype(self) -> str:
        """Type of its array."""
        if self.name == SEQUENCE:
            return "int16" if len(self.words) <= MOST_SHORT_CODES else "int32"
        return "int8" if self.is_code else "float64"

    @property
    def fill(self) -> Any:
        """Its value in a cell without one."""
        return kernel.NOT_ALLOWED if self.is_code else math.nan

    @property
    def attributes(self) -> dict[str, Any]:
        """Attributes of its array."""
        return attributes(self.meaning, self.unit, (NOT_ALLOWED, *self.words), kernel.NOT_ALLOWED)


_CODES: tuple[tuple[str, str, Sequence[str]], ...] = (
    ("status", "How the motion ended", STATUS_NAMES),
    ("ending", "What ended the span", kernel.ENDINGS),
    ("first_event", "First event after the start except the apex of a flight", EVENT_NAMES),
    ("hop", "Whether the rim leaves the plane", ("no", "yes")),
    ("painleve", "Whether Painlevé's paradox or the jam is met", ("no", "yes")),
)
_NUMBERS = (
    ("time", "Time to the end of the span, or to rest", "s"),
    ("end_angle", "Angle at the end of the span", "rad"),
    ("end_speed", "Speed of the centre along the plane at the end of the span", "m/s"),
    ("distance", "Displacement of the centre along the plane", "m"),
    ("distance_rolled", "Distance covered in rolling", "m"),
    ("revolutions_to_rolling", "Revolutions to the span's last phase, where that is rolling", "1"),
    ("energy_lost", "Energy lost in slip, in impacts and to rolling resistance", "J"),
    ("greatest_utilization", "Maximum friction utilization, abs(F)/(mu N) with mu_kinetic in slip, else mu_static", "1"),
    ("takeoff_time", "Time of the first take-off", "s"),
    ("takeoff_angle", "Angle at the first take-off", "rad"),
    ("hop_height", "Maximum gap in the first hop", "m"),
    ("flight_time", "Duration of the first hop", "s"),
    ("flight_distance", "Displacement of the centre in the first hop", "m"),
    ("landing_angle", "Angle at the landing of the first hop", "rad"),
    ("landing_loss", "Energy lost in the landing of the first hop", "J"),
)
_SETTLED = (
    ("period", "Passages of the section in a period of the gait; 0 without one", "1"),
    ("hops", "Hops in a period of the gait; 0 without one", "1"),
    ("revolutions", "Revolutions until the fate is decided", "1"),
    ("mean_speed", "Mean velocity of the centre in the end, of gaits, rolling, rocking and rest", "m/s"),
    ("final_hop_height", "Maximum gap in a period of the gait", "m"),
    ("lyapunov", "Lyapunov exponent per passage of a motion that finds no gait", "1"),
    ("final_loss", "Energy lost in all, where that is decided", "J"),
)
QUANTITIES: Mapping[str, Quantity] = {
    SEQUENCE: Quantity(SEQUENCE, "Phases over the span, one letter each; H last where it ends in take-off", "", (), -1),
    **{name: Quantity(name, meaning, "", tuple(words), kernel.WORDS.index(name)) for name, meaning, words in _CODES},
    **{name: Quantity(name, meaning, unit, (), kernel.NUMBERS.index(name)) for name, meaning, unit in _NUMBERS},
}
SETTLED: Mapping[str, Quantity] = {
    "fate": Quantity("fate", "What becomes of the motion in the end", "", settled.WORDS, 0, True),
    **{name: Quantity(name, meaning, unit, (), settled.COLUMNS.index(name), True) for name, meaning, unit in _SETTLED},
}
"""Quantities of the spans `settled` and `settled:landing`."""

_OF_FLIGHT = {*kernel.NUMBERS[-len(kernel.NO_FLIGHT) :]}


def choose_quantities(names: Sequence[str]) -> tuple[Quantity, ...]:
    """Return quantities by name."""
    if isinstance(names, str):
        names = [names]
    if not names:
        raise InputError(f"quantities must name at least one of {', '.join(QUANTITIES)}.")
    every = {**QUANTITIES, **SETTLED}
    for name in names:
        if name not in every:
            raise InputError.of_field("quantity", name, f"one of {', '.join(every)}")
    if len(set(names)) != len(names):
        raise InputError(f"quantities = {list(names)!r} must not name one twice.", field="quantities", value=list(names))
    return tuple(every[name] for name in names)


def flags_of(quantities: Sequence[Quantity]) -> int:
    """Return the flags of quantities that the kernel computes on request only."""
    names = {quantity.name for quantity in quantities}
    flags = kernel.FLIGHT_REQUESTED if names & _OF_FLIGHT else 0
    if "greatest_utilization" in names:
        flags |= kernel.UTILIZATION_REQUESTED
    return flags


class Span(NamedTuple):
    """How much of each motion counts.

    Attributes
    ----------
    name : str
    angle : float
        Rotation at which it ends [rad]; nan for no such end.
    stop : int
        The kernel's flags for turn and take-off.
    timed : bool
        Whether the scenario's duration ends it.
    """

    name: str
    angle: float
    stop: int
    timed: bool

    @property
    def settled(self) -> bool:
        """Whether it ends when the motion's fate is decided."""
        return self.name in settled.SPANS


_FIXED = {
    "first_revolution": Span("first_revolution", 2.0 * math.pi, STOP_AT_TURN | STOP_AT_TAKEOFF, False),
    "takeoff": Span("takeoff", math.nan, STOP_AT_TAKEOFF, True),
    "reversal": Span("reversal", math.nan, STOP_AT_TURN, True),
    "duration": Span("duration", math.nan, 0, True),
}
SPANS = (*_FIXED, "revolutions:N")


def make_span(name: str, *, in_the_end: bool = False) -> Span:
    """Return a span by name.

    name: ``first_revolution`` (to a full turn, a reversal or take-off, whichever comes first, without a time limit);
    ``takeoff``, ``reversal`` or ``revolutions:N`` (to that, within the scenario's duration); ``duration``; ``settled`` and
    ``settled:landing`` (until the fate is decided, by passages of the bottom or landings); in_the_end: Allow the last two.

    Examples
    --------
    >>> make_span("revolutions:3").angle / math.pi
    6.0
    """
    ends = settled.SPANS if in_the_end else ()
    turns = number_after("revolutions", name)
    if turns > 0.0:
        return Span(name, 2.0 * math.pi * turns, 0, True)
    if name in ends:
        return Span(name, math.nan, 0, False)
    if name in _FIXED:
        return _FIXED[name]
    raise InputError.of_field("span", name, f"one of {', '.join((*SPANS, *ends))}, with N above 0")


def choose(base: Scenario, names: Sequence[str], span: str) -> tuple[tuple[Quantity, ...], Span]:
    """Return quantities and a span by name; refuse those that do not go together, and a span that never ends."""
    quantities, chosen = choose_quantities(names), make_span(span, in_the_end=True)
    for quantity in quantities:
        if quantity.settled != chosen.settled:
            fitting = "settled or settled:landing" if quantity.settled else ", ".join(SPANS)
            raise InputError.of_field("span", span, f"{fitting} with quantity {quantity.name}")
    if chosen.settled and base.plane.gravity == 0.0:
        raise InputError.of_field("plane.gravity", 0.0, "above 0 with span 'settled': without it no motion comes back")
    return quantities, chosen


def distinct_sequences(keys: NDArray[np.uint64]) -> tuple[list[str], NDArray[np.int32]]:
    """Return the distinct sequences of an array of packed ones, shape (..., INTEGERS), and the index of each among them."""
    # as bytes: of rows of integers np.unique takes 20 times as long
    rows, place = np.unique(keys.view(f"V{8 * kernel.INTEGERS}"), return_inverse=True)
    texts = [unpacked_sequence(row) for row in rows.view(np.uint64).reshape(-1, kernel.INTEGERS)]
    return texts, place.reshape(keys.shape[:-1]).astype(np.int32)


def codes_of(sequences: Iterable[str]) -> dict[str, int]:
    """Return the codes of the sequences of a map, short ones first; the empty one, of a cell without a motion, has −1."""
    ordered = sorted({"", *sequences}, key=lambda text: (len(text), text))
    return {text: code for code, text in enumerate(ordered, kernel.NOT_ALLOWED)}


def sequences_with(codes: Mapping[str, int]) -> Quantity:
    """Return the quantity of sequences with those of a map, as `codes_of` returns them."""
    return QUANTITIES[SEQUENCE]._replace(words=tuple(codes)[1:])


def encode(texts: Sequence[str], place: NDArray[np.int32], codes: Mapping[str, int]) -> NDArray[np.int32]:
    """Return the codes of cells from their sequences, as `distinct_sequences` returns them."""
    return np.array([codes[text] for text in texts], np.int32)[place]


def attributes(meaning: str, unit: str, words: Sequence[str] = (), first: int = 0) -> dict[str, Any]:
    """Return the attributes of a number's array, or of an array of codes with their words, following the CF conventions.

    first: the code of the first word.
    """
    if unit:
        return {"long_name": meaning, "units": unit}
    codes = list(range(first, first + len(words)))
    return {"long_name": meaning, "units": "1", "flag_values": codes, "flag_meanings": " ".join(words)}


def words_of(array: Any) -> list[str]:
    """Return the meanings of the codes of a coded array of a map.

    Parameters
    ----------
    array : xarray.DataArray
        Such as ``dataset["sequence"]``.

    Returns
    -------
    words : list of str
        For the codes 0, 1, …, and last for −1, ``"not_allowed"``; so ``words[code]`` is right for each of them.

    Raises
    ------
    ValueError
        If the array holds no codes.
    """
    meanings = getattr(array, "attrs", {}).get("flag_meanings")
    if meanings is None:
        raise InputError(f"{getattr(array, 'name', type(array).__name__)} holds no codes.")
    not_allowed, *words = str(meanings).split(" ")
    return [*words, not_allowed]
