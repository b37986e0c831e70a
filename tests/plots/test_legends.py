"""Legends stand below their axes, and no wider than these where others stand beside them."""

from __future__ import annotations

from itertools import pairwise

import matplotlib.pyplot as plt
import pytest

from hophoop.plots.style import finish

NAMES = ("compliant, normal", "compliant, friction", "rigid, Stronge", "rigid, Poisson", "rigid, Newton", "bristle, friction")


@pytest.mark.parametrize("count", [1, 2, 3])
def test_legends_side_by_side_do_not_meet(count: int) -> None:
    figure, axes = plt.subplots(1, count, figsize=(13.0, 4.0), layout="constrained", squeeze=False)
    for ax in axes[0]:
        for name in NAMES:
            ax.plot([0.0, 1.0], [0.0, 1.0], label=name)
        finish(ax, "Time (s)", "Energy (J)")
    figure.canvas.draw()
    boxes = [ax.get_legend().get_window_extent() for ax in axes[0]]
    assert all(left.x1 < right.x0 for left, right in pairwise(boxes))
    assert boxes[0].x0 >= 0.0
    assert boxes[-1].x1 <= figure.bbox.width
    if count == 1:  # where there is room, two rows do
        assert axes[0, 0].get_legend()._ncols == 3
    plt.close(figure)
