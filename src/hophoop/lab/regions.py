"""The (θ, θ̇) plane: which mode follows contact without slip."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from hophoop import theory
from hophoop.lab.film import codes_of
from hophoop.scenario import Scenario
from hophoop.vocabulary.modes import mode_words


def regions(
    scenario: Scenario, window: tuple[float, float, float, float], columns: int = 360, rows: int = 240
) -> dict[str, Any]:
    """The mode that follows contact without slip over the (θ, θ̇) plane.

    Parameters
    ----------
    scenario : Scenario
        Its hoop and plane count.
    window : tuple of float
        θ from and to [rad], θ̇ from and to [rad/s].
    columns, rows : int
        Cells over θ, and over θ̇ [1].

    Returns
    -------
    regions : dict of ndarray
        `modes` (rows upwards): code of the mode's word, 5 where the model has no answer; `paradox`: for
        each column −1 (spin), 1 (skid) or 0, the slip that meets Painlevé's paradox there.
    """
    left, right, bottom, top = window
    angles = left + (np.arange(columns) + 0.5) * ((right - left) / columns)
    rates = bottom + (np.arange(rows) + 0.5) * ((top - bottom) / rows)
    letters = theory.mode_of(angles[None, :], rates[:, None], scenario.hoop, scenario.plane)
    codes = codes_of(mode_words(letters, rates[:, None])).astype(np.uint8)
    paradox = np.zeros(columns)
    if not scenario.hoop.massless and math.isfinite(scenario.plane.mu_kinetic):
        paradox = np.asarray(theory.painleve_region(angles, scenario.plane.mu_kinetic, scenario.hoop), float)
    return {"modes": codes, "paradox": paradox}
