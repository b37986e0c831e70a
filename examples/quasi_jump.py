"""Rolling that cannot slip: the quasi-jump of μ = ∞, and what large friction does instead.

Usage: python examples/quasi_jump.py [FOLDER]   (default: docs/figures)
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

HOOP = hh.Hoop.ideal(0.75)
START = hh.Start.rolling(3.1)


def main(folder: Path) -> None:
    """Draw the figure and print the angles."""
    folder.mkdir(parents=True, exist_ok=True)
    ideal = hh.simulate(HOOP, hh.Plane(mu=math.inf), START, duration=2.0)
    end = ideal.events[-1]
    lift = -9.81 + 0.75 * end.omega**2 * math.cos(end.angle)
    print(f"μ = ∞: {ideal.status} at {end.t:.9f} s, {math.degrees(end.angle):.6f}°, free lift {lift:.4f} m/s²")
    figure, axes = plt.subplots(1, 2, figsize=(9.8, 4.0), layout="constrained")
    # rolling carried on beyond N = 0 would need the plane to pull
    angles = np.linspace(0.0, 2 * math.pi, 800)
    forces = hh.theory.rolling_forces(angles, HOOP, v0=3.1)
    axes[0].plot(np.degrees(angles), forces.normal, color=colors.GRAY, lw=1.2, label="rolling for ever: N < 0")
    for mu, color, dashes in ((3.0, colors.BLUE, "-"), (10.0, colors.VERMILION, "--"), (1000.0, colors.BLACK, "-.")):
        motion = hh.simulate(HOOP, hh.Plane(mu=mu), START, duration=2.0)
        slip, stick = motion.find("slip_start")[0], motion.find("stick")[0]
        until = next(event.t for event in motion.events if event.angle >= 1.9 * math.pi or event.kind == "end")
        times = np.linspace(0.0, until, 3000)
        sample = motion.at(times)
        axes[0].plot(np.degrees(sample.angle), sample.normal_force, dashes, color=color, lw=1.3, label=f"μ = {mu:g}")
        axes[1].plot(np.degrees(sample.angle), sample.slip, dashes, color=color, lw=1.3, label=f"μ = {mu:g}")
        print(
            f"μ = {mu:g}: slips from {math.degrees(slip.angle):.6f}° to {math.degrees(stick.angle):.6f}°, "
            f"loses {stick.friction:.6f} J there; {motion.sequence}"
        )
    axes[0].axhline(0.0, color="black", lw=0.6)
    axes[0].set_ylim(-12, 60)
    axes[0].set_ylabel("Normal force (N)")
    axes[1].set_ylabel("Slip velocity (m/s)")
    for ax in axes:
        ax.set_xlabel("Rotation angle (°)")
        ax.set_xlim(0, 345)
        ax.set_xticks(range(0, 331, 60))
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, fontsize=9)
    figure.savefig(folder / "quasi-jump.svg", metadata={"Date": None})
    plt.close(figure)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent / "docs" / "figures")
