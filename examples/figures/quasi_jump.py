"""Rolling that cannot slip: the quasi-jump of μ = ∞, and what large friction does instead."""

from __future__ import annotations

import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

HOOP = hh.Hoop.ideal(0.75)
START = hh.Start.rolling(3.1)


def draw(folder: Path) -> None:
    """Draw the figure."""
    ideal = hh.simulate(HOOP, hh.Plane(mu=math.inf), START, duration=2.0)
    end = ideal.events[-1]
    figure, axes = plt.subplots(1, 2, figsize=(9.8, 4.0), layout="constrained")
    angles = np.linspace(0.0, math.pi, 800)
    normal = hh.theory.rolling_forces(angles, HOOP, v0=3.1).normal
    axes[0].fill_between(np.degrees(angles), normal, 0.0, where=normal < 0.0, color=colors.GRAY, alpha=0.4, lw=0)
    axes[0].plot(np.degrees(angles), normal, color=colors.GRAY, lw=4.0, alpha=0.45, label="rolling, even where N < 0")
    axes[0].plot(math.degrees(end.angle), 0.0, "X", color="black", ms=8, label="μ = ∞ ends here")
    for mu, color, dashes in (
        (3.0, colors.SERIES[1], "-"),
        (10.0, colors.SERIES[2], "--"),
        (100.0, colors.SERIES[3], ":"),
        (1000.0, colors.BLACK, "-."),
    ):
        motion = hh.simulate(HOOP, hh.Plane(mu=mu), START, duration=2.0)
        until = next(event.t for event in motion.events if event.angle >= 1.9 * math.pi or event.kind == "end")
        sample = motion.at(np.linspace(0.0, until, 6000))
        down = sample.angle <= math.pi
        axes[0].plot(
            np.degrees(sample.angle[down]), sample.normal_force[down], dashes, color=color, lw=1.4, label=f"μ = {mu:g}"
        )
        axes[1].plot(np.degrees(sample.angle), sample.slip, dashes, color=color, lw=1.4, label=f"μ = {mu:g}")
    axes[0].axhline(0.0, color="black", lw=0.6)
    axes[0].set_xlim(0, 150)
    axes[0].set_xticks(range(0, 151, 30))
    axes[0].set_ylim(-1, 10)
    axes[0].set_ylabel("Normal force (N)")
    axes[1].set_ylabel("Slip velocity (m/s)")
    axes[1].set_xlim(0, 345)
    axes[1].set_xticks(range(0, 331, 60))
    for ax in axes:
        ax.set_xlabel("Rotation angle (°)")
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, fontsize=9)
    figure.savefig(folder / "quasi-jump.svg", metadata={"Date": None})
    plt.close(figure)
