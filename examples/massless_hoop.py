"""The massless hoop: it skims instead of hopping; and how hoops with ever lighter rims come to it.

Usage: python examples/massless_hoop.py [FOLDER]   (default: docs/figures)
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

SPEED = 1.0  # of the centre at the top [m/s]


def roll(gamma: float, mu: float, speed: float = SPEED, duration: float = 6.0) -> hh.Trajectory:
    """A rolling start from the top."""
    return hh.simulate(hh.Hoop.ideal(gamma), hh.Plane(mu=mu), hh.Start.rolling(speed), duration=duration)


def skimming(folder: Path) -> None:
    """Path of the load, and the contact force, of the massless hoop and of two light rims."""
    figure, axes = plt.subplots(1, 2, figsize=(10.0, 4.0), layout="constrained")
    for gamma, color, dashes in ((0.9, colors.BLUE, "-."), (0.99, colors.VERMILION, "--"), (1.0, colors.BLACK, "-")):
        motion = roll(gamma, 1.0)
        end = next((event.t for event in motion.events if event.angle >= math.pi - 1e-9), motion.duration)
        times = np.linspace(0.3, end * (1 - 1e-9), 1500)
        sample = motion.at(times)
        label = "massless, γ = 1" if gamma == 1.0 else f"γ = {gamma:g}"
        x, y = sample.x + np.sin(sample.angle), 1 + np.cos(sample.angle) + sample.height
        axes[0].plot(x, y, dashes, color=color, label=label)
        axes[1].plot(np.degrees(sample.angle), sample.normal_force, dashes, color=color, label=label)
    skim = roll(1.0, 1.0).find("skim")[0]
    axes[0].plot(skim.x + math.sin(skim.angle), 1 + math.cos(skim.angle), "o", color=colors.BLACK, ms=5)
    axes[0].annotate(
        f"the force is gone at {math.degrees(skim.angle):.2f}°:\nfree fall, the rim skims",
        (skim.x + math.sin(skim.angle), 1 + math.cos(skim.angle)), (1.2, 0.45), fontsize=9,
        arrowprops={"arrowstyle": "-", "color": colors.GRAY},
    )  # fmt: skip
    axes[0].set_xlabel("Place of the load (m)")
    axes[0].set_ylabel("Height of the load (m)")
    axes[0].set_aspect("equal")
    axes[1].set_xlabel("Rotation angle (°)")
    axes[1].set_ylabel("Normal force (N)")
    axes[1].set_xticks(range(0, 181, 30))
    axes[1].set_ylim(-1.0, 30.0)
    for ax in axes:
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, fontsize=9)
    figure.savefig(folder / "massless-skim.svg", metadata={"Date": None})
    plt.close(figure)


def limit(folder: Path) -> None:
    """First slip, stick, second slip and hop of γ = 1 − 10⁻ᵏ beside the massless loss of contact."""
    massless = math.degrees(roll(1.0, 1.0).find("skim")[0].angle)
    print(f"massless: contact lost at {massless:.9f}°")
    powers = np.arange(1, 13)
    figure, ax = plt.subplots(figsize=(7.2, 4.2), layout="constrained")
    for mu, mark, color in ((1.0, "o", colors.BLUE), (5.0, "s", colors.VERMILION)):
        gaps = []
        for k in powers:
            motion = roll(1 - 10.0 ** -int(k), mu)
            slips = motion.find("slip_start")
            hops = motion.find("takeoff")
            gaps.append(abs(math.degrees(slips[0].angle) - massless))
            print(
                f"μ = {mu:g}, γ = 1 − 1e-{k}: slip at {math.degrees(slips[0].angle):.9f}°, "
                f"stick {math.degrees(motion.find('stick')[0].angle):.7f}°, "
                f"slip {math.degrees(slips[1].angle):.7f}°, "
                f"hop {math.degrees(hops[0].angle) if hops else math.nan:.6f}°, {motion.sequence}, "
                f"residual {abs(motion.ledger.residual) / motion.ledger.range:.1e}"
            )
        ax.semilogy(powers, gaps, mark, color=color, label=f"μ = {mu:g}")
    ax.set_xlabel("k, where γ = 1 − 10⁻ᵏ")
    ax.set_ylabel("First slip, from the massless loss of contact (°)")
    ax.grid(alpha=0.15)
    ax.legend(frameon=False)
    figure.savefig(folder / "massless-limit.svg", metadata={"Date": None})
    plt.close(figure)


def literature() -> None:
    """The claims of the literature in numbers."""
    for speed in (0.1, 0.01, 0.001):
        skim = roll(1.0, 2.0, speed, 9.0).find("skim")[0]
        print(f"v0 = {speed:g} m/s: force gone at {math.degrees(skim.angle):.7f}°, omega {skim.omega:.9f} rad/s")
    for gamma in (0.5, 0.75, 0.9, 0.99):
        speeds = hh.theory.critical_speeds(hh.Hoop.ideal(gamma), hh.Plane())
        print(f"γ = {gamma:g}: {speeds}")


def main(folder: Path) -> None:
    """Draw both figures and print the numbers of the page."""
    folder.mkdir(parents=True, exist_ok=True)
    literature()
    skimming(folder)
    limit(folder)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent.parent / "docs" / "figures")
