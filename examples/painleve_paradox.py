"""Painlevé's paradox: where it is, what an impact without collision does, and which natural starts come to it.

Usage: python examples/painleve_paradox.py [FOLDER] [--cells 40]   (default: docs/figures)
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.maps import paradoxes
from hophoop.plots import colors


def region(folder: Path) -> None:
    """The friction from which on slip at an angle meets the paradox, for several hoops."""
    figure, ax = plt.subplots(figsize=(7.2, 4.2), layout="constrained")
    angles = np.linspace(1e-3, math.pi - 1e-3, 600)
    for gamma, color, dashes in (
        (0.5, colors.BLUE, "-"),
        (0.75, colors.BLACK, "-"),
        (0.9, colors.VERMILION, "--"),
        (0.99, colors.GREEN, "-."),
    ):
        hoop = hh.Hoop.ideal(gamma)
        ax.plot(np.degrees(angles), hh.theory.painleve_threshold(angles, hoop), dashes, color=color, label=f"γ = {gamma:g}")
        least = hh.theory.painleve_minimum(hoop)
        ax.plot(math.degrees(least.angle), least.mu, "o", ms=4, color=color)
        print(f"γ = {gamma:g}: μ from {least.mu:.6f}, at {math.degrees(least.angle):.3f}°")
    ax.axhline(1.0, color=colors.GRAY, lw=0.8, ls=":")
    ax.text(178.0, 1.03, "μ = 1", ha="right", fontsize=9, color=colors.GRAY)
    ax.set_ylim(0.0, 4.0)
    ax.set_xlim(0.0, 180.0)
    ax.set_xticks(range(0, 181, 30))
    ax.set_xlabel("Rotation angle of spin; of skid 360° − angle (°)")
    ax.set_ylabel("Friction from which on p ≤ 0")
    ax.grid(alpha=0.15)
    ax.legend(frameon=False)
    figure.savefig(folder / "painleve-region.svg", metadata={"Date": None})
    plt.close(figure)


def towards_it(folder: Path) -> None:
    """Slip with a friction just below the threshold, and the impulse that it goes over into."""
    hoop, start = hh.Hoop.ideal(0.75), hh.Start(angle=-0.7, vx=3.0, omega=1.0)
    threshold = float(hh.theory.painleve_threshold(-0.7, hoop))
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 3.9), layout="constrained")
    for step, color, dashes in ((1e-1, colors.BLUE, "-"), (1e-2, colors.VERMILION, "--"), (1e-3, colors.BLACK, "-.")):
        motion = hh.simulate(hoop, hh.Plane(mu=threshold * (1 - step)), start, duration=0.3)
        stop = motion.events[1].t
        times = np.concatenate([np.linspace(0, stop, 300)[:-1], np.linspace(stop, 0.3, 300)])
        sample = motion.at(times)
        label = f"μ = {1 - step:g} of the threshold"
        axes[0].plot(1e3 * times, sample.slip, dashes, color=color, label=label)
        sliding = times < stop
        axes[1].semilogy(1e3 * times[sliding], sample.normal_force[sliding], dashes, color=color, label=label)
        print(f"{label}: slip ends after {stop:.6f} s")
    impact = hh.simulate(hoop, hh.Plane(mu=1.001 * threshold), start, duration=0.3).find("impact")[0]
    print(f"just above: an impulse of {impact.impulse_normal:.6f} N s at t = {impact.t:g} s, without collision")
    axes[0].plot([0, 0], [3.0 - 1.0, 0.0], color=colors.PURPLE, lw=3, label="above it: impact without collision")
    axes[0].set_ylabel("Slip velocity (m/s)")
    axes[0].set_xlim(-2, 80)
    axes[1].set_xlim(-2, 80)
    axes[1].set_ylabel("Normal force in slip (N)")
    for ax in axes:
        ax.set_xlabel("Time (ms)")
        ax.grid(alpha=0.15)
    axes[0].legend(frameon=False, fontsize=9)
    figure.savefig(folder / "painleve-limit.svg", metadata={"Date": None})
    plt.close(figure)


def search(folder: Path, cells: int) -> None:
    """Which rolling starts from the top meet the paradox, over load and friction."""
    gammas = 1.0 - np.geomspace(0.5, 1e-3, cells)
    frictions = np.geomspace(0.05, 10.0, cells)
    speeds = np.geomspace(0.01, 4.4, 60)
    found = paradoxes(gammas, frictions, speeds)
    share = 100.0 * found["met"].values
    figure, ax = plt.subplots(figsize=(7.2, 4.6), layout="constrained")
    mesh = ax.pcolormesh(frictions, 1.0 - gammas, np.where(share > 0.0, share, np.nan), cmap="viridis", shading="nearest")
    figure.colorbar(mesh, ax=ax, label="Rolling starts that meet it within 6 s (%)")
    fine = 1.0 - np.geomspace(0.5, 1e-3, 200)
    least = [hh.theory.painleve_minimum(hh.Hoop.ideal(float(gamma))).mu for gamma in fine]
    ax.plot(least, 1.0 - fine, color=colors.BLACK, lw=1.5, label="least friction with p ≤ 0 at any angle")
    ax.plot([1.0], [0.25], "D", color=colors.VERMILION, ms=6, label="the article's hoop")
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_xlabel("Friction μ")
    ax.set_ylabel("Mass of the ring over all, 1 − γ")
    ax.legend(frameon=True, edgecolor="none", fontsize=9, loc="lower left")
    figure.savefig(folder / "painleve-starts.png", dpi=130)
    plt.close(figure)
    met = found["met"].values > 0
    print(f"{int(found['starts'].sum())} rolling starts; cells with any that meets it: {met.sum()} of {met.size}")
    print(f"cells with a jam: {(found['jammed'].values > 0).sum()}")
    if met.any():
        rows, columns = np.nonzero(met)
        print(
            f"least load fraction {gammas[rows].min():.4f}, friction {frictions[columns].min():.3f}"
            f" to {frictions[columns].max():.3f}, slowest {np.nanmin(found['lowest_speed'].values):.4f} m/s"
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=Path(__file__).parent.parent / "docs" / "figures")
    parser.add_argument("--cells", type=int, default=40)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    region(arguments.folder)
    towards_it(arguments.folder)
    search(arguments.folder, arguments.cells)


if __name__ == "__main__":
    main()
