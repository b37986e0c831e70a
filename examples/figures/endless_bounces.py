"""Endlessly many bounces in a finite time: the gap, and the limit that closes the sequence."""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

HOOP = hh.Hoop.ideal(0.6)
START = hh.Start(height=0.1, angle=2.4, vx=0.5, omega=2.0)


def draw(folder: Path) -> None:
    """The gap against time, and the time that each impact leaves to the limit."""
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 3.9), layout="constrained")
    for restitution, color, mark in ((0.5, colors.SERIES[1], "o"), (0.8, colors.SERIES[2], "s"), (0.9, colors.BLACK, "^")):
        plane = hh.Plane(mu=0.3, restitution=restitution)
        motion = hh.simulate(HOOP, plane, START, duration=4.0)
        (limit,) = motion.find("bounce_limit")
        impacts = [event.t for event in motion.find("impact") if event.t < limit.t]
        times = np.sort(np.concatenate([np.linspace(0.0, 2.6, 4000), impacts]))
        label = f"e = {restitution:g}"
        axes[0].plot(times, 1e3 * motion.at(times).height, color=color, lw=1.2, label=label)
        axes[0].plot([limit.t], [0.0], mark, color=color, ms=6, mfc="white", clip_on=False, zorder=5)
        left = limit.t - np.array(impacts)
        axes[1].semilogy(np.arange(1, left.size + 1), left, mark, ms=2.5, color=color, label=label)
    axes[0].set_xlabel("Time (s)")
    axes[0].set_ylabel("Gap between rim and plane (mm)")
    axes[0].set_xlim(0.0, 2.6)
    axes[0].set_ylim(0.0, 105.0)
    axes[1].set_xlabel("Impact")
    axes[1].set_ylabel("Time left to the limit (s)")
    for ax in axes:
        ax.grid(alpha=0.15)
        ax.legend(frameon=False)
    figure.savefig(folder / "endless-bounces.svg", metadata={"Date": None})
    plt.close(figure)
