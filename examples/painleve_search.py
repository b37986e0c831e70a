"""How many natural starts meet Painlevé's paradox, as docs/painleve.md says; some minutes."""

from __future__ import annotations

import numpy as np
from figures.painleve import FAST, SLOW, on_slope, paradoxes


def table(name: str, found: dict[str, np.ndarray]) -> None:
    """One row for a search."""
    starts = found["starts"]
    met, jammed = np.sum(found["met"] * starts), np.sum(found["jammed"] * starts)
    ends = "– | – | –"
    if jammed > 0:
        rows, columns = np.nonzero(found["jammed"] > 0)
        gammas, frictions = found["load_fraction"][rows], found["friction"][columns]
        slowest = np.nanmin(found["lowest_jam_speed"])
        ends = f"{slowest:.2f} | {gammas.min():.4f} to {gammas.max():.4f} | {frictions.min():.3f} to {frictions.max():.3f}"
    print(f"| {name} | {starts.sum():,} | {met:,.0f} | {jammed:,.0f} | {ends} |")


if __name__ == "__main__":
    print("| starts | searched | meet p ≤ 0 | end in a jam | slowest that jams (m/s) | γ of those that jam | μ of those |")
    table("level, roll first", paradoxes(SLOW))
    table("level, thrown: hop at once", paradoxes(FAST, hops=True))
    table("10° downhill, roll first", paradoxes(SLOW[::2], on_slope(10.0), step=2))
    table("30° downhill, roll first", paradoxes(SLOW[::2], on_slope(30.0)))
