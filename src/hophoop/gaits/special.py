"""Special points of branches: folds, period doublings, border collisions and ends."""

from __future__ import annotations

from typing import NamedTuple

from hophoop.gaits.equation import GaitEquation, Pair
from hophoop.gaits.gait import Gait

FOLD, DOUBLING, BORDER, JOINS, TOP, END, LIMIT = (
    "fold", "period doubling", "border collision", "joins a shorter period", "top of the hill", "end", "limit of the range",
)  # fmt: skip


class Special(NamedTuple):
    """A special point of a branch.

    Attributes
    ----------
    kind : str
        'fold', 'period doubling', 'border collision', 'joins a shorter period', 'top of the hill', 'end' or 'limit of
        the range'.
    event : str
        Of a border collision the boundary, ('slip starts', 'take-off', 'hop vanishes', 'phase vanishes', 'impact: slip just
        stops', 'turns back' or 'slip at the section'), and the sequences on both sides; of an end the boundary that is met
        there, if one is; else empty.
    parameter : float
        [SI].
    omega : float
        θ̇ at the section [rad/s].
    multipliers : tuple of float
        Before and after it along the branch; one where they are the same [1].
    gait : Gait
        At or just before it.
    equation : GaitEquation
        Of the branch that it is on.
    place : ndarray
        Its point in the equation.
    """

    kind: str
    event: str
    parameter: float
    omega: float
    multipliers: tuple[float, ...]
    gait: Gait
    equation: GaitEquation
    place: Pair

    def __repr__(self) -> str:
        event = f" ({self.event})" if self.event else ""
        factors = " to ".join(f"{one:.6g}" for one in self.multipliers)
        return f"<{self.kind}{event} at {self.equation.path} = {self.parameter:.12g}, multiplier {factors}>"
