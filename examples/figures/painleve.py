"""Painlevé's paradox: where it is, what an impact without collision does, and which natural starts come to it."""

from __future__ import annotations

import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop.plots import colors

GRAVITY = 9.81
CELLS = 60  # along each side of a search
GAMMAS = 1.0 - np.geomspace(0.5, 1e-3, CELLS)
FRICTIONS = np.geomspace(0.04, 3.0, CELLS)
SLOW = np.concatenate([np.geomspace(0.01, 1.0, CELLS // 2), np.linspace(1.02, math.sqrt(GRAVITY / 0.5), CELLS)])  # m/s
FAST = np.linspace(3.2, 12.0, 2 * CELLS)  # m/s


def draw(folder: Path) -> None:
    """All of them."""
    region(folder / "painleve-region.svg")
    towards_it(folder / "painleve-limit.svg")
    starts(folder / "painleve-starts.svg")


def region(path: Path) -> None:
    """The friction from which on slip at an angle meets the paradox, for several hoops."""
    figure, ax = plt.subplots(figsize=(7.2, 4.2), layout="constrained")
    angles = np.linspace(1e-3, math.pi - 1e-3, 600)
    for gamma, color, dashes in (
        (0.5, colors.SERIES[1], "-"),
        (0.75, colors.BLACK, "-"),
        (0.9, colors.SERIES[2], "--"),
        (0.99, colors.SERIES[4], "-."),
    ):
        hoop = hh.Hoop.ideal(gamma)
        ax.plot(np.degrees(angles), hh.theory.painleve_threshold(angles, hoop), dashes, color=color, label=f"γ = {gamma:g}")
        least = hh.theory.painleve_minimum(hoop)
        ax.plot(math.degrees(least.angle), least.mu, "o", ms=4, color=color)
    ax.axhline(1.0, color=colors.GRAY, lw=0.8, ls=":")
    ax.text(178.0, 1.03, "μ = 1", ha="right", fontsize=9, color=colors.GRAY)
    ax.set_ylim(0.0, 4.0)
    ax.set_xlim(0.0, 180.0)
    ax.set_xticks(range(0, 181, 30))
    ax.set_xlabel("θ in a spin, 360° − θ in a skid (°)")
    ax.set_ylabel(r"Least friction with $p_\sigma$ ≤ 0")
    ax.grid(alpha=0.15)
    ax.legend(frameon=False)
    save(figure, path)


def towards_it(path: Path) -> None:
    """Slip with a friction just below the threshold, and the impulse that it goes over into."""
    hoop, start = hh.Hoop.ideal(0.75), hh.Start(angle=-0.7, vx=3.0, omega=1.0)
    threshold = float(hh.theory.painleve_threshold(-0.7, hoop))
    figure, axes = plt.subplots(1, 2, figsize=(9.6, 3.9), layout="constrained")
    impact = hh.simulate(hoop, hh.Plane(mu=1.000001 * threshold), start, duration=0.3).find("impact")[0]
    below = 10.0 ** -np.arange(1, 8)
    lasts, forces = [], []
    for k, share in enumerate(below):
        motion = hh.simulate(hoop, hh.Plane(mu=threshold * (1 - share)), start, duration=0.3)
        stop = motion.events[1]
        times = np.linspace(0.0, stop.t, 2001)
        sample = motion.at(times, side="left")
        force = sample.normal_force
        impulse = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(times) * (force[1:] + force[:-1]))])
        lasts.append(stop.t)
        forces.append(float(sample.normal_force[0]))
        if k < 3:
            color, dashes = ((colors.SERIES[1], "-"), (colors.SERIES[2], "--"), (colors.SERIES[4], "-."))[k]
            axes[0].plot(impulse, sample.slip, dashes, color=color, label=f"slip for {1e3 * stop.t:.3g} ms at {1 - share:g} μ*")
    straight = {"color": colors.SERIES[5], "lw": 4, "alpha": 0.5, "label": "impact without collision"}
    axes[0].plot([0.0, impact.impulse_normal], [2.0, 0.0], **straight)
    axes[0].set_xlabel("Normal impulse so far (N s)")
    axes[0].set_ylabel("Slip velocity (m/s)")
    axes[1].loglog(below, 1e3 * np.array(lasts), "o", color=colors.SERIES[1], label="slip lasts (ms)")
    axes[1].loglog(below, forces, "s", color=colors.NORMAL_FORCE, label="normal force (N)")
    axes[1].set_xlabel("1 − μ/μ*")
    for ax in axes:
        ax.grid(alpha=0.15)
        ax.legend(frameon=False, fontsize=9)
    save(figure, path)


def paradoxes(speeds: np.ndarray, base: hh.Scenario | None = None, hops: bool = False, step: int = 1) -> dict[str, np.ndarray]:
    """Over (γ, μ): `starts`, shares that have `met` p ≤ 0 or `jammed`, `lowest_speed` and `lowest_jam_speed` of those [m/s].

    With `hops` the starts that are too fast to roll at the top count as well.
    """
    base = hh.Scenario() if base is None else base
    gammas, frictions = GAMMAS[::step], FRICTIONS[::step]
    axes = {"hoop.load_fraction": gammas, "plane.mu": frictions, "start.speed": speeds}
    found = hh.maps.sweep(base, axes, quantities=("status", "painleve"), span="duration")
    rolls = speeds**2 * gammas[:, None] <= base.plane.gravity * math.cos(base.plane.slope) * base.hoop.radius
    counted = np.broadcast_to((rolls | hops)[:, None, :], found["status"].shape)
    met, jammed = (
        counted & (found[name].values == hh.maps.words_of(found[name]).index(word))
        for name, word in (("painleve", "yes"), ("status", "jammed"))
    )

    def lowest(those: np.ndarray) -> np.ndarray:
        slowest = np.where(those, speeds, np.inf).min(axis=2)
        return np.where(np.isfinite(slowest), slowest, np.nan)

    starts = counted.sum(axis=2)
    return {
        "load_fraction": gammas,
        "friction": frictions,
        "starts": starts,
        "met": met.sum(axis=2) / np.maximum(starts, 1),
        "jammed": jammed.sum(axis=2) / np.maximum(starts, 1),
        "lowest_speed": lowest(met),
        "lowest_jam_speed": lowest(jammed),
    }


def on_slope(degrees: float) -> hh.Scenario:
    """The reference plane, tilted."""
    return hh.Scenario(plane=hh.Plane(slope=math.radians(degrees)))


def starts(path: Path) -> None:
    """Which starts from the top meet the paradox, over load and friction."""
    thrown, rolling = paradoxes(FAST[::2], hops=True), paradoxes(SLOW[::2], on_slope(30.0))
    figure, axes = plt.subplots(1, 2, figsize=(10.2, 4.7), layout="constrained", sharey=True)
    panels = (
        (thrown["lowest_speed"], "level, thrown from the top", "Slowest start that meets it (m/s)", (3.0, 12.0)),
        (100.0 * rolling["met"], "30° downhill, rolling from the top", "Starts that meet it within 6 s (%)", (0.0, 100.0)),
    )
    fine = 1.0 - np.geomspace(0.5, 1e-3, 200)
    for ax, (values, title, label, limits) in zip(axes, panels, strict=True):
        shown = np.where(values > 0.0, values, np.nan)
        mesh = ax.pcolormesh(
            FRICTIONS, 1.0 - GAMMAS, shown, cmap="viridis", vmin=limits[0], vmax=limits[1], shading="nearest", rasterized=True
        )
        figure.colorbar(mesh, ax=ax, label=label)
        least = [hh.theory.painleve_minimum(hh.Hoop.ideal(float(gamma))).mu for gamma in fine]
        ax.plot(least, 1.0 - fine, color=colors.BLACK, lw=1.5, label="from here on p ≤ 0 at some angle")
        ax.plot(1.0 / fine, 1.0 - fine, "--", color=colors.BLACK, lw=1.5, label="up to here a jam: μ = 1/γ")
        ax.plot([1.0], [0.25], "D", color=colors.SERIES[5], ms=6, label="the article's hoop")
        ax.set_title(title, fontsize="medium")
        ax.set_xscale("log")
        ax.set_yscale("log")
        ax.set_xlim(FRICTIONS[0], FRICTIONS[-1])
        ax.set_ylim(1e-3, 0.5)
        ax.set_xlabel("Friction μ")
    axes[0].set_ylabel("Mass of the ring over all, 1 − γ")
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncol=3, frameon=False, fontsize=9)
    figure.savefig(path, dpi=160, metadata={"Date": None})
    plt.close(figure)


def save(figure: plt.Figure, path: Path) -> None:
    """Without a date, so that the same numbers give the same file."""
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)
