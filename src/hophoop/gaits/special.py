"""Special points of branches: folds, period doublings, border collisions and ends."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

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
        Of a border collision the boundary, as in `GaitMargin` or 'slip at the section', and the sequences on both sides; of an
        end the boundary that is met there, if one is; else empty.
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

    def follow(self, path: str, bounds: tuple[float, float], points: int = 40) -> NDArray[np.float64]:
        """Follow a fold or a period doubling in a second parameter.

        Parameters
        ----------
        path : str
            Of the second parameter.
        bounds : (float, float)
            Its range, around its value at the point [SI].
        points : int, default 40
            Steps of the whole range [1].

        Returns
        -------
        curve : ndarray, shape (n, 3)
            Rows of second parameter, first parameter [SI] and θ̇ [rad/s], in the order of the second one; shorter than the
            range where the point ends, for instance at another sequence.

        Raises
        ------
        ValueError
            If it is a point of another kind, or an argument is not allowed.
        """
        from hophoop.gaits.curves import follow_special

        return follow_special(self, path, bounds, points)

    def switch(self) -> Gait:
        """Return a gait of twice the period, next to a point where it is born.

        Returns
        -------
        gait : Gait
            To be followed in turn.

        Raises
        ------
        ValueError
            If none is found near the point, or its period would be above 64.
        """
        from hophoop.gaits.curves import doubled

        return doubled(self)

    def __repr__(self) -> str:
        event = f" ({self.event})" if self.event else ""
        factors = " to ".join(f"{one:.6g}" for one in self.multipliers)
        return f"<{self.kind}{event} at {self.equation.path} = {self.parameter:.12g}, multiplier {factors}>"
