"""Passages of one hoop and plane from many starts, in units of R, m and √(R/g)."""

from __future__ import annotations

import math
from typing import NamedTuple

from hophoop.gaits.computing import FOREVER, PANELS, new_buffers
from hophoop.gaits.kernels.layout import MODE, OMEGA, SECTIONS, TURNS, Request
from hophoop.gaits.kernels.passages import follow_passages
from hophoop.kernel.native import compiled
from hophoop.kernel.physics.body import Mode
from hophoop.kernel.records.layout import new_scratch
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
        self._buffers = new_buffers(max(count, 3))
        self._request = Request(SECTIONS.index("bottom"), count, FOREVER, PANELS, False)

    def __call__(self, omega: float) -> Image:
        """Return the image of a θ̇ in rolling with the load at the bottom [√(g/R)]."""
        start = start_state(0.0, 0.0, math.pi, 0.0, 0.0, omega)
        _, count, _, _ = compiled(follow_passages)(self.body, start, BY_RULE, self._request, self._buffers, self._scratch)
        found, words = self._buffers.numbers[:count], self._buffers.words[:count].tobytes()
        if count < self.count or found[-1, MODE] != Mode.ROLL:
            return Image(math.nan, words)
        return Image(float(found[-1, OMEGA]), words + found[-1:, TURNS].tobytes())
