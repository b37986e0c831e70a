"""Bands around a curve: two standard deviations on each side."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from hophoop.derivatives.results.uncertainty import Uncertainty
from hophoop.plots.style import Against, Axes
from hophoop.results.records import ArraySample
from hophoop.scenario import InputError

WIDTH = 2.0  # standard deviations
OPACITY = 0.25


def draw_bands(
    ax: Axes, uncertainty: Uncertainty | None, sample: ArraySample, against: Against, fields: Mapping[str, tuple[float, str]]
) -> None:
    """Draw bands for fields of a sample, each with a factor and a colour; nothing without an uncertainty."""
    if uncertainty is None:
        return
    if against != "time":
        raise InputError.of_field("against", against, "'time' with an uncertainty, which is that at a time")
    left = np.append(sample.t[1:] == sample.t[:-1], False)  # a sample has both sides of each event
    sides = [uncertainty.at(sample.t, side) for side in ("left", "right")]
    for name, (factor, color) in fields.items():
        deviation = np.where(left, *(getattr(side, name) for side in sides))
        middle, half = factor * getattr(sample, name), factor * WIDTH * deviation
        ax.fill_between(sample.t, middle - half, middle + half, color=color, alpha=OPACITY, lw=0)
