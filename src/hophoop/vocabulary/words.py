"""Words for modes, as people are shown them.

A mode's letter says how the rim slips: S where v_t < 0, K where v_t > 0. Its word says what the hoop does, and
follows the rotation: it spins where the rim turns too fast for the way it goes (v_t θ̇ < 0), and skids where it
slides ahead (v_t θ̇ > 0), or does not turn at all. For a hoop that rolls ahead S is spin and K is skid; for one
that rolls back it is the other way round. Colours follow the words.
"""

from __future__ import annotations

from enum import StrEnum
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hophoop._support.errors import InputError


class Word(StrEnum):
    """A string of the file format that type checkers and editors know; it is printed as a plain string."""

    def __repr__(self) -> str:
        return repr(self.value)


class ModeLetter(Word):
    """Letter of a mode; S and K are the sign of the slip velocity v_t."""

    ROLL = "R"
    SLIP_NEGATIVE = "S"
    SLIP_POSITIVE = "K"
    FLIGHT = "H"
    SKIM = "M"


# By the numbers that the kernels use for them.
MODE_LETTERS: Final = tuple(ModeLetter)

ROLL, SPIN, SKID, FLIGHT, SKIM = "roll", "spin", "skid", "flight", "skim"
MODES: Final = (ROLL, SPIN, SKID, FLIGHT, SKIM)
"""Words for the modes, in the order of the letters 'RSKHM' of a hoop that rolls ahead."""

VERBS: Final = {ROLL: "rolls", SPIN: "spins", SKID: "skids", FLIGHT: "flies", SKIM: "skims the plane"}
PARTICIPLES: Final = {
    ROLL: "rolling", SPIN: "spinning", SKID: "skidding", FLIGHT: "in flight", SKIM: "skimming",
}  # fmt: skip

LETTERS: Final = {"R": ROLL, "S": "slip −", "K": "slip +", "H": FLIGHT, "M": SKIM, "+": "…"}
"""What the letters of a sequence stand for where the direction is not known: slip by the sign of v_t."""
LETTERS_SENTENCE: Final = "R roll, S slip with v_t < 0, K slip with v_t > 0, H flight (a hop), M skim"


def mode_word(letter: str, omega: float) -> str:
    """The word for a mode at an angular velocity.

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
    if letter == "S":
        return SPIN if omega > 0.0 else SKID
    if letter == "K":
        return SPIN if omega < 0.0 else SKID
    if letter not in ("R", "H", "M"):
        raise InputError.of_field("letter", letter, "one of R, S, K, H, M")
    return {"R": ROLL, "H": FLIGHT, "M": SKIM}[letter]


def mode_words(letters: ArrayLike, omega: ArrayLike) -> NDArray[np.str_]:
    """The words for modes at angular velocities, as `mode_word` gives each.

    Parameters
    ----------
    letters : array_like of str
        R, S, K, H or M; another one stays as it is.
    omega : array_like
        θ̇ [rad/s].

    Returns
    -------
    words : ndarray of str
    """
    signs, rate = np.broadcast_arrays(np.asarray(letters), np.asarray(omega, dtype=float))
    words = signs.astype("U6")
    words[signs == "R"], words[signs == "H"], words[signs == "M"] = ROLL, FLIGHT, SKIM
    slip = (signs == "K").astype(int) - (signs == "S").astype(int)
    words[slip != 0] = SKID
    words[slip * np.sign(rate) < 0.0] = SPIN
    return words


def coming_rotation(omega: ArrayLike) -> NDArray[np.float64]:
    """Angular velocities in order of time, where one that is zero has the direction of the next that is not.

    Parameters
    ----------
    omega : array_like, shape (n,)
        θ̇ [rad/s].

    Returns
    -------
    direction : ndarray, shape (n,)
        −1, 0 or 1 [1]; at the end of a motion that stops that of the last one that turns.
    """
    sign: NDArray[np.float64] = np.sign(np.nan_to_num(np.asarray(omega, dtype=float)))
    turning = np.flatnonzero(sign)
    if turning.size == 0:
        return sign
    following = np.searchsorted(turning, np.arange(sign.size))
    found: NDArray[np.float64] = sign[turning[np.minimum(following, turning.size - 1)]]
    return found


def plain(word: Any) -> str:
    """An identifier of the file format as words, such as 'slip start' for slip_start."""
    return str(word).replace("_", " ")
