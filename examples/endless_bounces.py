"""Endlessly many bounces in a finite time: the gap, and the limit that closes the sequence.

Usage: python examples/endless_bounces.py [FOLDER]   (default: docs/figures)
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

HOOP = hh.Hoop.ideal(0.6)
START = hh.Start(height=0.1, angle=2.4, vx=0.5, omega=2.0)


def main(folder: Path) -> None:
    """Draw the figure and print the limits."""
    folder.mkdir(parents=True, exist_ok=True)
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 3.9), layout="constrained")
    for restitution, color, dashes in (
        (0.5, colors.BLUE, "-"),
        (0.8, colors.VERMILION, "--"),
        (0.9, colors.BLACK, "-."),
    ):
        plane = hh.Plane(mu=0.3, restitution=restitution)
        motion = hh.simulate(HOOP, plane, START, duration=4.0)
        limits = motion.find("bounce_limit")
        end = limits[0].t if limits else motion.duration
        times = np.linspace(0.0, min(1.3 * end, motion.duration), 4000)
        label = f"e = {restitution:g}"
        axes[0].plot(times, 1e3 * motion.at(times).height, dashes, color=color, lw=1.3, label=label)
        impacts = [event.t for event in motion.find("impact") if event.t < end]
        left = end - np.array(impacts)
        axes[1].semilogy(np.arange(1, left.size + 1), left, "o", ms=3, color=color, label=label)
        print(
            f"{label}: {left.size} impacts, limit {end:.12f} s, then {limits[0].to_mode if limits else '-'}; "
            f"residual {abs(motion.ledger.residual) / motion.ledger.range:.1e} of the range"
        )
    axes[0].set_xlabel("Time (s)")
    axes[0].set_ylabel("Gap between rim and plane (mm)")
    axes[1].set_xlabel("Impact")
    axes[1].set_ylabel("Time left to the limit (s)")
    for ax in axes:
        ax.grid(alpha=0.15)
        ax.legend(frameon=False)
    figure.savefig(folder / "endless-bounces.svg", metadata={"Date": None})
    plt.close(figure)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent / "docs" / "figures")
