"""Modes of the hoop, one row of a table each: letter, words and colours.

A mode's letter gives the sign of the slip velocity: S for v_t < 0, K for v_t > 0. Its word follows the rotation as well: a hoop
spins where v_t θ̇ < 0 (the rim turns too fast for its motion along the plane) and skids where v_t θ̇ > 0 (it slides ahead) or
θ̇ = 0. Forward, with θ̇ > 0, S is spin and K is skid; backward it is the other way round. Colours follow the words.

A new mode needs a member of the kernel's `Mode`, a member of `ModeLetter` and a row of `MODES`.
A new word needs a row of `WORDS`.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support.errors import InputError
from hophoop.kernel.physics.body import Mode
from hophoop.vocabulary import palette
from hophoop.vocabulary.words import Word


class ModeLetter(Word):
    """Letter of a mode; S and K are the sign of the slip velocity v_t."""

    ROLL = "R"
    SLIP_NEGATIVE = "S"
    SLIP_POSITIVE = "K"
    FLIGHT = "H"
    SKIM = "M"


ROLL, SPIN, SKID, FLIGHT, SKIM = "roll", "spin", "skid", "flight", "skim"


class WordFacts(NamedTuple):
    """Verb, participle and colour of a mode's word."""

    verb: str
    participle: str
    color: str


WORDS: Final[dict[str, WordFacts]] = {
    ROLL: WordFacts("rolls", "rolling", palette.BLUE),
    SPIN: WordFacts("spins", "spinning", palette.ORANGE),
    SKID: WordFacts("skids", "skidding", palette.PURPLE),
    FLIGHT: WordFacts("flies", "in flight", palette.VERMILION),
    SKIM: WordFacts("skims the plane", "skimming", palette.YELLOW),  # of the massless hoop
}
"""The words for modes that people are shown."""


class ModeFacts(NamedTuple):
    """Letter and words of a mode."""

    letter: ModeLetter
    forward: str  # word for θ̇ > 0
    backward: str  # word for θ̇ < 0
    at_rest: str  # word for θ̇ = 0
    legend: str  # in the legend of a sequence


MODES: Final[dict[Mode, ModeFacts]] = {
    Mode.ROLL: ModeFacts(ModeLetter.ROLL, ROLL, ROLL, ROLL, "roll"),
    Mode.SPIN: ModeFacts(ModeLetter.SLIP_NEGATIVE, SPIN, SKID, SKID, "slip backward"),
    Mode.SKID: ModeFacts(ModeLetter.SLIP_POSITIVE, SKID, SPIN, SKID, "slip forward"),
    Mode.FLIGHT: ModeFacts(ModeLetter.FLIGHT, FLIGHT, FLIGHT, FLIGHT, "flight (a hop)"),
    Mode.SKIM: ModeFacts(ModeLetter.SKIM, SKIM, SKIM, SKIM, "skim"),
}
"""By the numbers that the kernels use for them."""

MODE_LETTERS: Final = tuple(facts.letter for facts in MODES.values())
MODE_WORDS: Final = tuple(facts.forward for facts in MODES.values())
"""Words in the order of the letters, for a hoop that rolls forward; also the names of the modes in files."""
VERBS: Final = {word: facts.verb for word, facts in WORDS.items()}
PARTICIPLES: Final = {word: facts.participle for word, facts in WORDS.items()}
LETTERS: Final = {str(facts.letter): facts.forward for facts in MODES.values()} | {"+": "…"}
"""Words for the letters of a sequence, of a hoop that turns forward; '+' is the end of one that is too long."""
LETTERS_SENTENCE: Final = ", ".join(f"{facts.letter} {facts.legend}" for facts in MODES.values())


def letter_of(mode: int) -> ModeLetter:
    """Return the letter of a mode.

    Parameters
    ----------
    mode : int
        A member of the kernel's `Mode`; larger numbers are phases of the massless hoop in `precise`, which skim.

    Returns
    -------
    letter : ModeLetter

    Examples
    --------
    >>> letter_of(Mode.FLIGHT)
    'H'
    """
    return MODE_LETTERS[min(mode, Mode.SKIM)]


def mode_word(letter: str, omega: float) -> str:
    """Return the word for a mode at an angular velocity.

    Parameters
    ----------
    letter : str
        R, S, K, H or M; S and K are the sign of the slip velocity v_t.
    omega : float
        θ̇ [rad/s].

    Returns
    -------
    word : str
        roll, spin, skid, flight or skim.

    Raises
    ------
    ValueError
        If there is no such letter.

    Examples
    --------
    >>> mode_word("S", 3.1), mode_word("S", -0.8)
    ('spin', 'skid')
    """
    for facts in MODES.values():
        if facts.letter == letter:
            return facts.forward if omega > 0.0 else facts.backward if omega < 0.0 else facts.at_rest
    raise InputError.of_field("letter", letter, f"one of {', '.join(MODE_LETTERS)}")


def mode_words(letters: ArrayLike, omega: ArrayLike) -> NDArray[np.str_]:
    """Return the words for modes at angular velocities, each as `mode_word` gives it.

    letters: R, S, K, H or M; any other stays as it is; omega: θ̇ [rad/s].
    """
    signs, rate = np.broadcast_arrays(np.asarray(letters), np.asarray(omega, dtype=float))
    words = signs.astype("U6")
    for facts in MODES.values():
        here = signs == facts.letter
        words[here] = facts.at_rest
        words[here & (rate > 0.0)], words[here & (rate < 0.0)] = facts.forward, facts.backward
    return words


def coming_rotation(omega: ArrayLike) -> NDArray[np.float64]:
    """Return directions of rotation in order of time; a zero takes the direction of the next value that is not zero.

    omega: shape (n,), θ̇ [rad/s]; direction: shape (n,), −1, 0 or 1 [1]; zeros at the end take the last direction.
    """
    sign: NDArray[np.float64] = np.sign(np.nan_to_num(np.asarray(omega, dtype=float)))
    turning = np.flatnonzero(sign)
    if turning.size == 0:
        return sign
    following = np.searchsorted(turning, np.arange(sign.size))
    found: NDArray[np.float64] = sign[turning[np.minimum(following, turning.size - 1)]]
    return found
