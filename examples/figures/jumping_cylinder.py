"""A jumping cylinder on an incline: where it leaves slopes of 15°, 30° and 45°, and which bodies jump without slipping.

A foam cylinder with a brass rod along it near its surface, made of parts; then all bodies (ε, κ) on one slope.
"""

from __future__ import annotations

import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

import hophoop as hh
from hophoop.plots import colors

RADIUS = 0.05
KINDS = (
    ("slips ahead first (skid)", colors.mode_color("skid")),
    ("over-rotates first (spin)", colors.mode_color("spin")),
    ("jumps without slip", colors.mode_color("flight")),
    ("N = 0 and cannot jump (quasi-jump)", colors.GRAY),
    ("rolls for 4 s", colors.mode_color("roll")),
)


def cylinder(share: float) -> hh.Hoop:
    """A cylinder of 80 g, that share of it in the rod, 80 % out."""
    return hh.Hoop.from_parts(
        radius=RADIUS,
        parts=[hh.Disk(0.08 * (1 - share), RADIUS), hh.Disk(0.08 * share, 0.06 * RADIUS, at=0.8 * RADIUS)],
    )


def release(hoop: hh.Hoop, degrees: float, mu: float, duration: float = 3.0) -> hh.Trajectory:
    """From rest, the rod a hair downhill of the highest place."""
    slope = math.radians(degrees)
    return hh.simulate(hoop, hh.Plane(mu=mu, slope=slope), hh.Start(angle=-slope + 0.02), duration=duration)


def jumps(folder: Path) -> None:
    """Where the cylinder first jumps, over the share of its mass in the rod."""
    figure, axes = plt.subplots(1, 2, figsize=(9.8, 4.2), layout="constrained", sharey=True)
    shares = np.linspace(0.1, 0.95, 171)
    for degrees, color, dashes in ((15, colors.SERIES[1], "-"), (30, colors.SERIES[2], "--"), (45, colors.BLACK, "-.")):
        for ax, mu in zip(axes, (1.0, 3.0), strict=True):
            places = []
            for share in shares:
                found = release(cylinder(float(share)), degrees, mu).find("takeoff")
                places.append(found[0].angle / (2 * math.pi) if found else math.nan)
            turns = np.array(places)
            turns[1:][np.abs(np.diff(turns)) > 0.5] = math.nan  # another turn: no line between the two
            ax.plot(shares, turns, dashes, color=color, label=f"{degrees}°")
            ax.set_title(f"μ = {mu:g}", fontsize="medium")
    axes[0].set_ylabel("First jump (turns from the normal)")
    for ax in axes:
        ax.set_xlabel("Share of the mass in the rod")
        ax.set_ylim(0, 4)
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, title="Slope", fontsize=9)
    figure.savefig(folder / "jumping-cylinder.svg", metadata={"Date": None})
    plt.close(figure)


def kinds_of(eccentricity: np.ndarray, inertia: np.ndarray, degrees: float, mu: float) -> np.ndarray:
    """What ends the first rolling of many bodies, as indices of `KINDS`."""
    slope = math.radians(degrees)
    base = hh.Scenario(
        hoop=hh.Hoop(radius=RADIUS, mass=0.08, eccentricity=0.5, inertia_ratio=0.3),
        plane=hh.Plane(mu=mu, slope=slope),
        start=hh.Start(angle=-slope + 0.02),
        duration=4.0,
    )
    values = {"hoop.eccentricity": eccentricity, "hoop.inertia_ratio": inertia}
    found = hh.maps.points(base, values, ("sequence", "status"), span="takeoff")
    kinds = np.full(found["sequence"].shape, 4)
    for kind, letters in enumerate(("RK", "RS", "RH")):
        kinds[np.char.startswith(found["sequence"].astype(str), letters)] = kind
    kinds[(found["sequence"] == "R") & (found["status"] == "undetermined")] = 3
    return kinds


def without_slip(folder: Path) -> None:
    """Which bodies jump straight from rolling: all (ε, κ) released on a slope of 30°."""
    eccentricities = np.linspace(0.005, 0.995, 199)
    shares = np.linspace(0.005, 1.0, 200)
    figure, axes = plt.subplots(1, 3, figsize=(11.4, 4.6), layout="constrained", sharey=True)
    palette = ListedColormap([color for _, color in KINDS])
    for ax, mu in zip(axes, (1.0, 3.0, math.inf), strict=True):
        inertia = shares[:, None] * (1 - eccentricities**2)
        found = kinds_of(np.broadcast_to(eccentricities, inertia.shape), inertia, 30.0, mu)
        ax.pcolormesh(
            eccentricities, shares, found, cmap=palette, vmin=-0.5, vmax=len(KINDS) - 0.5, shading="nearest", rasterized=True
        )
        ax.plot(*(0.6, cylinder(0.75).inertia_ratio / (1 - 0.36)), "o", color="white", mec="black", ms=7)
        ax.set_title(f"μ = {'∞' if math.isinf(mu) else f'{mu:g}'}", fontsize="medium")
        ax.set_xlabel("Eccentricity ε")
    axes[0].set_ylabel("Inertia κ over its greatest, 1 − ε²")
    handles = [Patch(color=color, label=name) for name, color in KINDS[:4]]
    figure.legend(handles=handles, loc="outside lower center", ncol=2, frameon=False)
    figure.savefig(folder / "slope-first.svg", dpi=160, metadata={"Date": None})
    plt.close(figure)


def draw(folder: Path) -> None:
    """Draw both figures."""
    jumps(folder)
    without_slip(folder)
