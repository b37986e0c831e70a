"""The massless hoop: it skims instead of hopping; and how hoops with ever lighter rims come to it."""

from __future__ import annotations

import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

SPEED = 1.0  # of the centre at the top [m/s]
POWERS = range(1, 13)


def roll(gamma: float, mu: float, speed: float = SPEED, duration: float = 6.0, angle: float = 0.0) -> hh.Trajectory:
    """A rolling start."""
    start = hh.Start.rolling(speed, angle=angle)
    return hh.simulate(hh.Hoop.ideal(gamma), hh.Plane(mu=mu), start, duration=duration)


def skimming(folder: Path) -> None:
    """Path of the load, and the contact force, of the massless hoop and of two light rims."""
    figure, axes = plt.subplots(1, 2, figsize=(10.0, 4.0), layout="constrained")
    for gamma, color, dashes in ((0.9, colors.SERIES[1], "-."), (0.99, colors.SERIES[2], "--"), (1.0, colors.BLACK, "-")):
        motion = roll(gamma, 1.0)
        end = next((event.t for event in motion.events if event.angle >= math.pi - 1e-9), motion.duration)
        sample = motion.at(np.linspace(0.3, end * (1 - 1e-9), 4000))
        down = sample.angle <= math.pi
        label = "massless, γ = 1" if gamma == 1.0 else f"γ = {gamma:g}"
        x, y = sample.x + np.sin(sample.angle), 1 + np.cos(sample.angle) + sample.height
        axes[0].plot(x[down], y[down], dashes, color=color, label=label)
        axes[1].plot(np.degrees(sample.angle[down]), sample.normal_force[down], dashes, color=color, label=label)
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
    axes[1].set_xlim(0.0, 182.0)
    axes[1].set_ylim(-1.0, 30.0)
    for ax in axes:
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, fontsize=9)
    save(figure, folder / "massless-skim.svg")


def limit(folder: Path) -> None:
    """First slip, stick, second slip and hop of γ = 1 − 10⁻ᵏ beside the massless loss of contact."""
    figure, axes = plt.subplots(1, 2, figsize=(10.1, 4.2), layout="constrained")
    cases = ((1.0, 1.0, "o", colors.SERIES[1]), (1.0, 5.0, "s", colors.SERIES[2]), (3.0, 1.0, "^", colors.BLACK))
    for speed, mu, mark, color in cases:
        massless = math.degrees(roll(1.0, mu, speed).find("skim")[0].angle)
        gaps, sticks = [], []
        for k in POWERS:
            motion = roll(1 - 10.0**-k, mu, speed, 3.0)
            stick = math.degrees(motion.find("stick")[0].angle)
            gaps.append(math.degrees(motion.find("slip_start")[0].angle) - massless)
            sticks.append(180.0 - stick)
        label = f"$v_0$ = {speed:g} m/s, μ = {mu:g}"
        for ax, values in zip(axes, (gaps, sticks), strict=True):
            ax.semilogy(list(POWERS), values, mark, ms=5, color=color, label=label)
    axes[0].set_ylabel("First slip, after the massless\nloss of contact (°)")
    axes[1].set_ylabel("End of the first slip, before 180° (°)")
    for ax in axes:
        ax.set_xlabel("k, where γ = 1 − 10⁻ᵏ")
        ax.set_xticks(range(2, 13, 2))
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, fontsize=9)
    save(figure, folder / "massless-limit.svg")


def hops(folder: Path) -> None:
    """Speeds at which ever lighter rims hop."""
    figure, ax = plt.subplots(figsize=(7.2, 4.0), layout="constrained")
    for mu, mark, color in ((1.0, "o", colors.SERIES[1]), (5.0, "s", colors.SERIES[2])):
        windows = []
        for k in range(1, 10):
            speeds = hh.theory.critical_speeds(hh.Hoop.ideal(1 - 10.0**-k), hh.Plane(mu=mu))
            windows.append(speeds.immediate_hop - speeds.first_hop)
        ax.semilogy(range(1, 10), windows, mark, ms=5, color=color, label=f"μ = {mu:g}")
    ax.set_xlabel("k, where γ = 1 − 10⁻ᵏ")
    ax.set_ylabel("Range of speeds with a later hop (m/s)")
    ax.grid(alpha=0.15)
    ax.legend(frameon=False)
    save(figure, folder / "massless-hops.svg")


def save(figure: plt.Figure, path: Path) -> None:
    """Without a date, so that the same numbers give the same file."""
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def draw(folder: Path) -> None:
    """Draw all figures."""
    skimming(folder)
    limit(folder)
    hops(folder)
