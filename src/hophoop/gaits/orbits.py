"""Passages of one hoop and plane from many starts, in units of R, m and √(R/g)."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.gaits.computing import FOREVER, PANELS
from hophoop.gaits.kernels.layout import COLUMNS, FEW_EVENTS, INTEGERS, MODE, OMEGA, SECTIONS, TURNS, Buffers, Request
from hophoop.gaits.kernels.passages import SIZE, follow_passages
from hophoop.kernel.native import compiled
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.records.layout import EVENT, SEGMENT, new_scratch
from hophoop.kernel.records.state import start_state
from hophoop.kernel.rigid.run import BY_RULE
from hophoop.results.units import Units
from hophoop.scenario import Scenario


class Image(NamedTuple):
    """What becomes of a θ̇ at the bottom after some passages.

    Attributes
    ----------
    omega : float
        θ̇ at the last of them; nan if the motion passes the bottom no more, or slips there [√(g/R)].
    word : bytes
        The phases of all passages, packed: motions with the same ones belong to one piece of the map.
    """

    omega: float
    word: bytes


class BottomMap:
    """The return map of rolling with the load at the bottom: one number, θ̇.

    Parameters
    ----------
    scenario : Scenario
        Its hoop and plane count.
    count : int
        Passages of one application [1].
    """

    def __init__(self, scenario: Scenario, count: int = 1) -> None:
        self.scenario, self.count = scenario, count
        self.body = scenario.to_body()
        self.unit = Units.of_scenario(scenario).of("omega")
        self._scratch = new_scratch()
        rows = max(count, 3)
        self._buffers = Buffers(
            np.empty((rows, len(COLUMNS))), np.zeros((rows, INTEGERS), np.uint64), np.empty(SIZE), np.empty(FEW_EVENTS, EVENT),
            np.empty(0, SEGMENT),
        )  # fmt: skip
        self._request = Request(SECTIONS.index("bottom"), count, FOREVER, PANELS, False)

    def __call__(self, omega: float) -> Image:
        """Return the image of a θ̇ in rolling with the load at the bottom.

        Parameters
        ----------
        omega : float
            [√(g/R)].

        Returns
        -------
        image : Image
        """
        found = self.rows(omega)
        words = self._buffers.words[: len(found)].tobytes()
        if len(found) < self.count or found[-1, MODE] != Mode.ROLL:
            return Image(math.nan, words)
        return Image(float(found[-1, OMEGA]), words + found[-1:, TURNS].tobytes())

    def rows(self, omega: float) -> NDArray[np.float64]:
        """Return the kernel's rows of the passages.

        Parameters
        ----------
        omega : float
            [√(g/R)].

        Returns
        -------
        rows : ndarray, shape (n, len(COLUMNS))
            Valid until the next call [1].
        """
        start = start_state(0.0, 0.0, math.pi, 0.0, 0.0, omega)
        _, found, _, _ = compiled(follow_passages)(self.body, start, BY_RULE, self._request, self._buffers, self._scratch)
        rows: NDArray[np.float64] = self._buffers.numbers[:found]
        return rows
