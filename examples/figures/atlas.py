"""An atlas of motions: the phase plane with true motions, where the first hop is, and the best hops.

The rows of the table in docs/atlas.md are those of `row_of` for each of `OPTIMA`.
"""

from __future__ import annotations

import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import hophoop as hh
from hophoop import maps, plots

GRAVITY = 9.81


def phase_plane(folder: Path) -> None:
    """True motions over the modes of the (θ, θ̇) plane."""
    speeds = (0.1, 1.0, 2.0, 2.8, 3.1, 3.5)
    motions = [hh.simulate(hh.Scenario(duration=2.0, start=hh.Start.rolling(speed))) for speed in speeds]
    ax = plots.phase_plane(motions=motions, labels=[f"{speed:g} m/s" for speed in speeds])
    save(ax, folder / "atlas-phase-plane.svg")


def first_hops(folder: Path, cells: int = 400) -> None:
    """Where a hop begins within the first revolution, over three pairs of parameters, and how high it is."""
    speed, mu, gamma = (
        np.linspace(0.01, 5.0, cells),
        np.linspace(0.005, 2.0, cells),
        np.linspace(0.01, 0.99, cells),
    )
    pairs = {
        "mu-v0": (hh.Scenario(), {"plane.mu": mu, "start.speed": speed}),
        "v0-gamma": (hh.Scenario(), {"start.speed": speed, "hoop.load_fraction": gamma}),
        "mu-gamma": (hh.Scenario(), {"plane.mu": mu, "hoop.load_fraction": gamma}),
    }
    for name, (base, axes) in pairs.items():
        dataset = maps.sweep(base, axes, ["sequence", "hop_height", "flight_distance", "painleve"])
        for quantity in ("sequence", "hop_height", *(["flight_distance"] if name == "v0-gamma" else [])):
            ax = plots.motion_map(dataset, quantity)
            save(ax, folder / f"atlas-{name}-{quantity.replace('_', '-')}.svg")


def save(ax, path: Path) -> None:
    ax.figure.savefig(path, dpi=160, metadata={"Date": None})
    plt.close(ax.figure)


def best_hop(
    quantity: str, most_friction: float = 1000.0, rounds: int = 40, count: int = 1500, seed: int = 7
) -> dict[str, float]:
    """The rolling start at the top that gives the best first hop, over γ, μ and v0, for R = 1 m.

    The hop must begin within the first revolution but not at once (a hoop thrown fast enough flies as high as
    one likes): v0 is sought as a part of √(g R/γ), from which on it leaves the plane at the start. Each round
    draws points in a box around the best so far, which shrinks; there are several peaks, so this is done
    from several seeds. Friction is drawn by its logarithm.
    """
    tries = [climb(quantity, most_friction, rounds, count, seed + i) for i in range(6)]
    return max(tries, key=lambda found: found[quantity])


def climb(quantity: str, most_friction: float, rounds: int, count: int, seed: int) -> dict[str, float]:
    """One search from one seed."""
    rng = np.random.default_rng(seed)
    low, high = np.array([0.01, -2.0, 0.05]), np.array([0.999, math.log10(most_friction), 1.0 - 1e-9])
    best, place, size = -np.inf, 0.5 * (low + high), high - low
    for _ in range(rounds):
        box = np.clip(place - 0.5 * size, low, high), np.clip(place + 0.5 * size, low, high)
        draws = rng.uniform(*box, (count, 3))
        found = np.nan_to_num(hops(quantity, draws[:, 0], 10.0 ** draws[:, 1], draws[:, 2]), nan=-np.inf)
        k = int(np.argmax(found))
        if found[k] > best:
            best, place = float(found[k]), draws[k]
        size = 0.75 * size
    return {
        quantity: best,
        "load_fraction": float(place[0]),
        "mu": float(10.0 ** place[1]),
        "part_of_immediate_hop": float(place[2]),
    }


def hops(quantity: str, load_fraction, mu, part):
    """First hops of starts whose speed is a part of √(g R/γ)."""
    values = {
        "hoop.load_fraction": load_fraction,
        "plane.mu": mu,
        "start.speed": part * np.sqrt(GRAVITY / load_fraction),
    }
    return maps.points(None, values, [quantity])[quantity]


# The page's table: what is sought, and the most friction.
OPTIMA = (("hop_height", 1000.0), ("hop_height", 1.0), ("flight_distance", 3.0))
WORDS = {"hop_height": "highest", "flight_distance": "longest"}


def row_of(quantity: str, most_friction: float) -> str:
    """A row of the page's table: a start as printed, and the hop that just this start gives.

    The speed is printed as a part of √(g R/γ), and cut off: a rounded speed could lie above it, where the hoop leaves
    the plane at once.
    """
    best = best_hop(quantity, most_friction)
    gamma, mu = round(best["load_fraction"], 3), float(f"{best['mu']:.3g}")
    part = math.floor(best["part_of_immediate_hop"] * 1e6) / 1e6
    hop = float(hops(quantity, np.float64(gamma), np.float64(mu), np.float64(part)))
    return f"| {WORDS[quantity]}, μ up to {most_friction:g} | {hop:.3f} m | {gamma:.3f} | {mu:g} | {part:.6f} |"


def draw(folder: Path) -> None:
    """Draw all figures."""
    phase_plane(folder)
    first_hops(folder)
