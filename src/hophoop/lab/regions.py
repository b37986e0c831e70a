"""The (θ, θ̇) plane: the mode that follows contact without slip."""

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
    """Return the mode that follows contact without slip over the (θ, θ̇) plane.

    Parameters
    ----------
    scenario : Scenario
        Only its hoop and plane matter.
    window : tuple of float
        Range of θ [rad] and of θ̇ [rad/s].
    columns, rows : int
        Numbers of cells in θ and θ̇ [1].

    Returns
    -------
    regions : dict of ndarray
        `modes` (rows upward): code of the mode's word, 5 if the model has no answer; `paradox`: for each column −1 (spin), 1
        (skid) or 0, the slip with Painlevé's paradox. With rolling resistance it is 0 everywhere, since the paradox then
        depends on the direction of rotation too.
    """
    left, right, bottom, top = window
    angles = left + (np.arange(columns) + 0.5) * ((right - left) / columns)
    rates = bottom + (np.arange(rows) + 0.5) * ((top - bottom) / rows)
    letters = theory.mode_of(angles[None, :], rates[:, None], scenario.hoop, scenario.plane)
    codes = codes_of(mode_words(letters, rates[:, None])).astype(np.uint8)
    paradox = np.zeros(columns)
    hoop, plane = scenario.hoop, scenario.plane
    if not hoop.massless and math.isfinite(plane.mu_kinetic) and plane.rolling_resistance == 0.0:
        paradox = np.asarray(theory.painleve_region(angles, plane.mu_kinetic, hoop), float)
    return {"modes": codes, "paradox": paradox}
