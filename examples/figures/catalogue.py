"""The classes of the catalogue that hophoop ships: over the load fraction, over their width, and in the window of γ = 3/4."""

from __future__ import annotations

import json
from importlib.resources import files
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.patheffects import withStroke

from hophoop import maps
from hophoop.plots import class_color
from hophoop.vocabulary import colors
from hophoop.vocabulary.parameters import FIGURE_LABELS
from hophoop.vocabulary.quantities import with_unit

REFERENCE = 0.75  # γ of the article's hoop, whose window is drawn
NARROWEST = 1e-14  # width down to which the catalogue goes
CELLS = 700  # along each side of the drawn window
MOST_LINEAR = 0.45  # friction up to which the left panel goes
NAMED_AT = 0.4  # friction at which the names of classes with wider examples are written
NAMED = 0.0135  # width of the classes whose names are written


def counts(gamma: float, width: float) -> tuple[int, int]:
    """Sequences, and sequences with their endings, of a width at least."""
    entries = maps.catalogue(gamma, width)
    return len({entry.sequence for entry in entries}), len(entries)


def draw(folder: Path) -> None:
    """All figures of the page."""
    draw_over_gamma(folder / "catalogue-load-fraction.svg")
    draw_counts(folder / "catalogue-counts.svg")
    draw_plane(folder / "catalogue-plane.svg")


def draw_over_gamma(path: Path) -> None:
    """Which sequences a hoop shows, over γ, and how much of the window each fills."""
    hoops = maps.catalogued()
    areas: dict[str, dict[float, float]] = {}
    for gamma in hoops:
        for entry in maps.catalogue(gamma):
            shares = areas.setdefault(entry.sequence, {})
            shares[gamma] = shares.get(gamma, 0.0) + entry.area
    # from the first that appear to the last
    order = sorted(areas, key=lambda name: (-len(areas[name]), min(areas[name])))
    edges = np.concatenate(([0.0], 0.5 * (np.array(hoops[1:]) + np.array(hoops[:-1])), [1.0]))
    fig, (count, ax) = plt.subplots(
        2, 1, figsize=(8.2, 2.4 + 0.165 * len(order)), sharex=True, height_ratios=(1, 6), layout="constrained"
    )
    for row, name in enumerate(order):
        sizes = np.array([max(areas[name].get(gamma, 0.0), 1e-14 * (gamma in areas[name])) for gamma in hoops])
        thick = np.where(sizes > 0.0, 0.16 + 0.74 * (np.log10(np.maximum(sizes, 1e-14)) + 14) / 14, 0.0)
        thick = 0.5 * np.append(thick, thick[-1])
        ax.fill_between(edges, row - thick, row + thick, step="post", color=class_color(name), lw=0)
    ax.set_yticks(range(len(order)), order, fontsize=7.5)
    ax.set_ylim(len(order) - 0.4, -0.6)
    ax.set_xlim(0.0, 1.0)
    ax.set_xlabel("Load fraction γ")
    ax.set_ylabel("Sequence; a bar's thickness is the logarithm of its share, from $10^{-14}$ to 1")
    for values, label, line in (
        ([counts(g, 0.0)[0] for g in hoops], "sequences", "-"),
        ([counts(g, 0.0)[1] for g in hoops], "with their endings", "--"),
    ):
        count.step(hoops, values, line, where="mid", color="black", label=label)
    count.set_ylabel("Number")
    count.set_ylim(0, None)
    count.legend(frameon=False, ncols=2, loc="lower center")
    fig.savefig(path, metadata={"Date": None})
    plt.close(fig)


def draw_counts(path: Path) -> None:
    """How many classes there are, over the width from which on they count."""
    widths = np.geomspace(NARROWEST, 1.0, 561)
    fig, ax = plt.subplots(figsize=(8.2, 4.6), layout="constrained")
    for gamma, color in zip((0.75, 0.48, 0.2, 0.9), colors.SERIES, strict=False):
        pairs = [counts(gamma, float(width)) for width in widths]
        ax.plot(widths, [b for _, b in pairs], color=color, drawstyle="steps-post", label=f"γ = {gamma}")
        ax.plot(widths, [a for a, _ in pairs], color=color, drawstyle="steps-post", ls=":")
    ax.axhline(36, color=colors.GRAY, lw=0.8)
    ax.text(0.8, 36.4, "36", color=colors.GRAY)
    ax.set_xscale("log")
    ax.set_xlim(1.0, NARROWEST)
    ax.set_ylim(0, None)
    ax.set_xlabel("Least width of a class that counts, as part of the window")
    ax.set_ylabel("Classes: with their endings (full), sequences (dotted)")
    ax.legend(frameon=False, loc="lower right")
    fig.savefig(path, metadata={"Date": None})
    plt.close(fig)


def draw_plane(path: Path) -> None:
    """The window of γ = 3/4, linear up to μ = 0.45 and by ratio, with the places where classes meet."""
    hoop = json.loads(files("hophoop.maps").joinpath("catalogue.json").read_text(encoding="utf-8"))["hoops"][repr(REFERENCE)]
    (least, most), (slowest, fastest) = hoop["mu_range"], hoop["speed_range"]
    fig, axes = plt.subplots(1, 2, figsize=(11.0, 5.6), layout="constrained")
    frictions, speeds = maps.linear(least, MOST_LINEAR, CELLS), maps.linear(slowest, fastest, CELLS)
    draw_classes(axes[0], frictions, speeds)
    axes[1].set_xscale("log")
    axes[1].set_yscale("log")
    draw_classes(axes[1], maps.logarithmic(least, most, CELLS), maps.logarithmic(slowest, fastest, CELLS))
    places = [one[:2] for one in hoop["meetings"]]
    for ax in axes:
        limits = ax.get_xlim(), ax.get_ylim()
        ax.plot(*zip(*places, strict=True), "o", ms=3.2, mfc="white", mec="black", mew=0.7)
        ax.set(xlim=limits[0], ylim=limits[1])
        ax.set_xlabel(FIGURE_LABELS["plane.mu"])
        ax.set_ylabel(with_unit(FIGURE_LABELS["start.speed"], "m/s"))
    white = [withStroke(linewidth=1.6, foreground="white")]
    for sequence, ending, mu, speed in names_in_the_plane(speeds):
        text = sequence + "\nreversal" * (ending == "reversal")
        axes[0].text(mu, speed, text, fontsize=6.5, ha="center", va="center", linespacing=0.9, path_effects=white)
    fig.savefig(path, dpi=160, metadata={"Date": None})
    plt.close(fig)


def draw_classes(ax, mu: np.ndarray, speed: np.ndarray) -> None:
    """Each class in its colour, and black where a neighbour has another sequence or ending."""
    found = maps.sweep(None, {"start.speed": speed, "plane.mu": mu}, ["sequence", "ending"])
    sequence, ending = found["sequence"].values.astype(int), found["ending"].values.astype(int)
    paint = np.array([to_rgb(class_color(word)) for word in maps.words_of(found["sequence"])[:-1]])
    shown = paint[sequence]
    for code in (sequence, ending):
        shown[:-1][code[:-1] != code[1:]] = 0.0
        shown[1:][code[:-1] != code[1:]] = 0.0
        shown[:, :-1][code[:, :-1] != code[:, 1:]] = 0.0
    ax.pcolormesh(mu, speed, shown, shading="nearest", rasterized=True)
    ax.set(xlim=(mu[0], mu[-1]), ylim=(speed[0], speed[-1]))


def names_in_the_plane(speeds: np.ndarray) -> list[tuple[str, str, float, float]]:
    """Where to write the name of each class that is wide enough: (sequence, ending, μ, v0)."""
    found = maps.points(None, {"plane.mu": NAMED_AT, "start.speed": speeds}, ["sequence", "ending"])
    pairs = list(zip(found["sequence"].tolist(), found["ending"].tolist(), strict=True))
    named = []
    for entry in maps.catalogue(REFERENCE, NAMED):
        if entry.mu < NAMED_AT:
            named.append((entry.sequence, entry.ending, entry.mu, entry.speed))
        elif (entry.sequence, entry.ending) in pairs:
            inside = [speed for speed, pair in zip(speeds, pairs, strict=True) if pair == (entry.sequence, entry.ending)]
            named.append((entry.sequence, entry.ending, NAMED_AT, float(np.mean(inside))))
    return named
