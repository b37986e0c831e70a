"""Bands around a curve: two standard deviations on each side."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hophoop.derivatives.results.uncertainty import Uncertainty
from hophoop.plots.style import Against, Axes
from hophoop.results.records import ArraySample
from hophoop.scenario import InputError

WIDTH = 2.0  # standard deviations
OPACITY = 0.25


def deviations(uncertainty: Uncertainty, sample: ArraySample, fields: Mapping[str, Any]) -> dict[str, NDArray[np.float64]]:
    """Return standard deviations at the times of a sample, which has both sides of each event."""
    left = np.append(sample.t[1:] == sample.t[:-1], False)
    found = {name: np.empty(sample.t.shape) for name in fields}
    for side, chosen in (("left", left), ("right", ~left)):
        if chosen.any():
            there = uncertainty.at(sample.t[chosen], side)
            for name, values in found.items():
                values[chosen] = getattr(there, name)
    return found


def draw_bands(
    ax: Axes, uncertainty: Uncertainty | None, sample: ArraySample, against: Against, fields: Mapping[str, tuple[float, str]]
) -> None:
    """Draw bands for fields of a sample, each with a factor and a colour; nothing without an uncertainty."""
    if uncertainty is None:
        return
    if against != "time":
        raise InputError.of_field("against", against, "'time' with an uncertainty, which is that at a time")
    found = deviations(uncertainty, sample, fields)
    for name, (factor, color) in fields.items():
        middle, half = factor * getattr(sample, name), factor * WIDTH * found[name]
        ax.fill_between(sample.t, middle - half, middle + half, color=color, alpha=OPACITY, lw=0)
