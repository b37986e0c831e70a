"""Rows of the passages of a section, and what is asked of a motion."""

from __future__ import annotations

from typing import Any, NamedTuple

from hophoop.kernel.model import Mode

# One row per passage, in kernel units: the state, whose times, positions and losses count from the start, as do the hops, and
# what is known of the motion since the last passage.
COLUMNS = (
    "t", "t_low", "x", "x_low", "height", "turns", "theta", "theta_low", "slip", "vy", "omega",
    "friction", "impact_normal", "impact_tangential", "rolling_resistance", "hops", "letters", "doubt", "highest",
    "mode", "branches", "ahead",
)  # fmt: skip
(
    T, T_LOW, X, X_LOW, HEIGHT, TURNS, THETA, THETA_LOW, SLIP, VY, OMEGA,
    FRICTION, IMPACT_NORMAL, IMPACT_TANGENTIAL, ROLLING_RESISTANCE, HOPS, LETTERS, DOUBT, HIGHEST, MODE, BRANCHES, AHEAD,
) = range(len(COLUMNS))  # fmt: skip
COORDINATES = [THETA, OMEGA, SLIP, VY]
PIECE = slice(MODE, AHEAD + 1)  # what is the same on a piece of the map: the mode, the branches of impacts, whether θ̇ > 0

INTEGERS = 2  # of a word: the phases since the last passage, packed as records.layout says

ROLL = float(Mode.ROLL)  # in the column `mode`: Numba compares no float with a member of an enum

BOTTOM, LANDING = 0, 1
SECTIONS = ("bottom", "landing")

# Results of a cell of `judge_cells`: integers (`turns`: whole revolutions of a gait in a period), and numbers in SI units, nan
# where there is none.
CODES = ("fate", "period", "hops", "passages", "status", "turns")
NUMBERS = ("revolutions", "mean_speed", "final_hop_height", "lyapunov", "final_loss", "final_omega")
REVOLUTIONS, MEAN_SPEED, FINAL_HOP_HEIGHT, LYAPUNOV, FINAL_LOSS, FINAL_OMEGA = range(len(NUMBERS))


class Request(NamedTuple):
    """What is asked of a motion."""

    section: int  # BOTTOM or LANDING
    most: int  # passages
    stops: bool  # True: ends as soon as the fate is decided


class Buffers(NamedTuple):
    """What a computation of passages fills and works in."""

    numbers: Any  # shape (n, len(COLUMNS)): passage k is in row k modulo n
    words: Any  # of uint64, shape (n, INTEGERS), likewise
    memory: Any  # shape (passages.SIZE,)
    events: Any  # of records.EVENT, shape (FEW_EVENTS,): those of one step
    segments: Any  # of records.SEGMENT, length 0


FEW_EVENTS = 32
