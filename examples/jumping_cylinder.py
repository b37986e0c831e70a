"""A jumping cylinder on an incline: where it leaves slopes of 15°, 30° and 45°, and whether it slips before.

Usage: python examples/jumping_cylinder.py [FOLDER]   (default: docs/figures)

A foam cylinder with a brass rod along it near its surface, made of parts.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

RADIUS = 0.05


def cylinder(share: float) -> hh.Hoop:
    """A cylinder of 80 g, that share of it in the rod, 80 % out."""
    return hh.Hoop.from_parts(
        radius=RADIUS,
        parts=[hh.Disk(0.08 * (1 - share), RADIUS), hh.Disk(0.08 * share, 0.06 * RADIUS, at=0.8 * RADIUS)],
    )


def release(hoop: hh.Hoop, degrees: float, mu: float) -> hh.Trajectory:
    """From rest, the rod a hair downhill of the highest place."""
    slope = math.radians(degrees)
    return hh.simulate(hoop, hh.Plane(mu=mu, slope=slope), hh.Start(angle=-slope + 0.02), duration=3.0)


def main(folder: Path) -> None:
    """Draw the figure and print the table."""
    folder.mkdir(parents=True, exist_ok=True)
    figure, axes = plt.subplots(1, 2, figsize=(9.8, 4.2), layout="constrained")
    shares = np.linspace(0.1, 0.95, 69)
    for degrees, color, dashes in ((15, colors.BLUE, "-"), (30, colors.VERMILION, "--"), (45, colors.BLACK, "-.")):
        for ax, mu in zip(axes, (1.0, 3.0), strict=True):
            places = []
            for share in shares:
                jumps = release(cylinder(float(share)), degrees, mu).find("takeoff")
                places.append(jumps[0].angle / (2 * math.pi) if jumps else math.nan)
            ax.plot(shares, places, dashes, color=color, label=f"{degrees}°")
            ax.set_title(f"μ = {mu:g}", fontsize="medium")
        for mu in (0.5, 1.0, 3.0, math.inf):
            motion = release(cylinder(0.75), degrees, mu)
            jumps = motion.find("takeoff")
            first = jumps[0] if jumps else motion.events[-1]
            print(
                f"{degrees}°, μ = {mu:g}: {motion.sequence[:8]} {motion.status}; "
                f"{'jumps' if jumps else 'ends'} at {math.degrees(first.angle):.4f}° from {first.from_mode}, "
                f"{first.omega:.4f} rad/s, {first.t:.6f} s"
            )
    axes[0].set_ylabel("First jump (turns from the normal)")
    for ax in axes:
        ax.set_xlabel("Share of the mass in the rod")
        ax.set_ylim(0, 4)
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, title="Slope", fontsize=9)
    figure.savefig(folder / "jumping-cylinder.svg", metadata={"Date": None})
    plt.close(figure)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent / "docs" / "figures")
