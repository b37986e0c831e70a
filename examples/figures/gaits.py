"""What becomes of a hoop in the end: return maps, the diagram over the slope, branches of gaits, and slip that dies away."""

from __future__ import annotations

import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

HOOP = hh.Hoop.ideal(0.75)
SLOPES = (0.5, 1.0, 1.15, 2.0, 4.0, 10.0)  # degrees


def draw(folder: Path) -> None:
    """All of them."""
    return_maps(folder / "gaits-maps.svg")
    diagram(folder / "gaits-diagram.png")
    draw_branches(folder / "gaits-branch.svg")
    slip(folder / "gaits-slip.svg")


def on_slope(degrees: float, hoop: hh.Hoop = HOOP, **plane: float) -> hh.Scenario:
    """A hoop on a slope, in units of R, m and g."""
    return hh.Scenario(hoop=hoop, plane=hh.Plane(slope=math.radians(degrees), gravity=1.0, **plane))


def return_maps(path: Path) -> None:
    """Return maps of the reference hoop at six slopes, each with the motion that it settles on."""
    figure, grid = plt.subplots(2, 3, figsize=(9.6, 6.6), layout="constrained", sharex=True, sharey=True)
    for ax, degrees in zip(grid.flat, SLOPES, strict=True):
        found = hh.gaits.return_map(on_slope(degrees), 3.0, 3.6)
        hh.plots.return_map(found, ax, start=3.4, passages=80, skip=0 if degrees == 10.0 else 300)
        ax.set_title(f"{degrees:g}°", fontsize=10)
        ax.set_ylim(2.9, 3.8)
        ax.set_xlim(3.0, 3.6)
        ax.get_legend().remove()
        ax.set_xlabel("")
        ax.set_ylabel("")
    figure.supxlabel(r"$\dot\theta$ at the bottom ($\sqrt{g/R}$)", fontsize=10)
    figure.supylabel(r"$\dot\theta$ one passage later ($\sqrt{g/R}$)", fontsize=10)
    handles, names = grid[0, 1].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside upper center", ncols=2, frameon=False, fontsize=10)
    save(figure, path)


def diagram(path: Path) -> None:
    """On what the reference hoop settles, from 0 to 20°."""
    slopes = np.radians(np.linspace(0.02, 20.0, 1000))
    found = hh.gaits.diagram(on_slope(1.0), "plane.slope", slopes)
    ax = hh.plots.diagram(found)
    ax.set_ylabel(r"$\dot\theta$ at the bottom ($\sqrt{g/R}$)")
    ax.figure.savefig(path, dpi=160, metadata={"Software": None})
    plt.close(ax.figure)


def branches() -> tuple[hh.gaits.Branch, hh.gaits.Branch]:
    """The branch of gaits of period 1, and that of period 2 born on it."""
    first = hh.gaits.find(on_slope(1.0), near=3.408)[0].follow("plane.slope", (math.radians(0.3), math.radians(1.5)))
    corner = next(one for one in first.special if one.kind == "border collision" and abs(np.diff(one.multipliers)[0]) > 0.5)
    return first, doubled(corner).follow("plane.slope", (math.radians(1.02), math.radians(1.5)))


def doubled(special: hh.gaits.Special) -> hh.gaits.Gait:
    """The gait of twice the period next to a special point, at a slope just above it."""
    gait = special.gait
    beyond = gait.scenario.replace("plane.slope", special.parameter * (1 + 1e-5))
    return hh.gaits.find(beyond, 2 * gait.period, near=special.omega)[0]


def draw_branches(path: Path) -> None:
    """Gaits of period 1 and 2 over the slope."""
    ax = hh.plots.branch(branches())
    ax.set_xlim(0.7, 1.4)
    ax.set_ylim(3.37, 3.48)
    ax.set_ylabel(r"$\dot\theta$ at the bottom ($\sqrt{g/R}$)")
    save(ax.figure, path)


def slip(path: Path) -> None:
    """How slip dies away on the level, next to the derived law."""
    plane = hh.Plane(gravity=1.0)
    decay = hh.theory.slip_decay(HOOP, plane)
    figure, ax = plt.subplots(figsize=(7.2, 3.8), layout="constrained")
    for first, color in ((0.3, colors.SERIES[0]), (0.03, colors.SERIES[1]), (0.003, colors.SERIES[2])):
        start = hh.Start.rolling(decay.omega + first, angle=math.pi)
        found = hh.passages(hh.Scenario(hoop=HOOP, plane=plane, start=start), 10_000)
        number = np.arange(1, len(found) + 1)
        shown = np.unique(np.geomspace(1, len(found), 40).astype(int)) - 1
        ax.loglog(number[shown], found.omega[shown] - decay.omega, "o", ms=4, color=color, label=f"from {first:g}")
        ax.loglog(number, first / (1 + first * decay.rate * number), color=color, linewidth=1.0)
    ax.set_xlabel("Revolutions")
    ax.set_ylabel(r"$\dot\theta$ above the first slip ($\sqrt{g/R}$)")
    ax.grid(alpha=0.15)
    ax.legend(frameon=False)
    save(figure, path)


def save(figure: plt.Figure, path: Path) -> None:
    """Without a date, so that the same numbers give the same file."""
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)
