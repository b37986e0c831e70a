"""One impact under three laws of restitution: what bounces, what is lost, and what Newton's law creates.

Usage: python examples/impact_laws.py [FOLDER]   (default: docs/figures)

A block-like body (ε = 1/2, κ = 0.39, sin θ = −4/5) strikes at v = (−1, −3) m/s. With μ = 1/2 its slip stops during
compression and it sticks; with μ = 1/8 the slip reverses.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

BODY = hh.Hoop(radius=1.0, mass=1.0, eccentricity=0.5, inertia_ratio=0.39)
LAWS = {
    "newton": ("Newton", colors.VERMILION, "--"),
    "poisson": ("Poisson", colors.BLUE, "-."),
    "stronge": ("Stronge", colors.BLACK, "-"),
}


def strike(law: str, restitution: float, mu: float) -> hh.trajectory.EventRecord:
    """The impact."""
    plane = hh.Plane(mu=mu, restitution=restitution, impact_law=law)
    start = hh.Start(angle=math.atan2(-0.8, 0.6), vx=-1.0, vy=-3.0)
    return hh.simulate(BODY, plane, start, duration=1e-3, contact=hh.Rigid(max_events=12)).find("impact")[0]


def main(folder: Path) -> None:
    """Draw the figure and print the numbers at e = 1."""
    folder.mkdir(parents=True, exist_ok=True)
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 4.0), layout="constrained")
    grid = np.linspace(0.0, 1.0, 81)
    for law, (name, color, dashes) in LAWS.items():
        for mu, width in ((0.5, 2.0), (0.125, 1.0)):
            impacts = [strike(law, float(e), mu) for e in grid]
            lost = [impact.impact_normal + impact.impact_tangential for impact in impacts]
            label = f"{name}, μ = {mu:g}"
            axes[0].plot(grid, [impact.vy for impact in impacts], dashes, color=color, lw=width, label=label)
            axes[1].plot(grid, lost, dashes, color=color, lw=width)
            print(f"{label}: e = 1 gives v_n = {impacts[-1].vy:.9f} m/s, loses {lost[-1]:.9f} J")
    axes[0].set_ylabel("Velocity of separation (m/s)")
    axes[1].set_ylabel("Energy lost in the impact (J)")
    axes[1].axhline(0.0, color=colors.GRAY, lw=0.8)
    axes[1].annotate(
        "below zero Newton's law\ncreates energy (Kane)", (0.93, -0.33), (0.30, -0.1), fontsize=9,
        arrowprops={"arrowstyle": "-", "color": colors.GRAY},
    )  # fmt: skip
    axes[0].legend(frameon=False, fontsize=9)
    for ax in axes:
        ax.set_xlabel("Restitution e")
        ax.grid(alpha=0.15)
    figure.savefig(folder / "impact-laws.svg", metadata={"Date": None})
    plt.close(figure)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent / "docs" / "figures")
