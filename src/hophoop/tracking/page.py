"""What pages of tracks and fits share: their style, and small plots of something over time."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

STYLE = """
:root { color-scheme: light dark; --ink: #1b1b1b; --soft: #555; --line: #ccc; --paper: #fff; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8e8; --soft: #aaa; --line: #555; --paper: #16181b; } }
body { font: 16px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 1100px; padding: 0 1rem;
  color: var(--ink); background: var(--paper); }
h1 { font-size: 1.7rem; line-height: 1.25; overflow-wrap: anywhere; } h2 { font-size: 1.25rem; margin-bottom: 0.3rem; }
a { color: inherit; } footer { color: var(--soft); margin-top: 2rem; }
.stills { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(320px, 100%), 1fr)); gap: 0.8rem; }
figure { margin: 0; } figure img, video { width: 100%; display: block; } figcaption { font-size: 0.85rem; color: var(--soft); }
svg { width: 100%; height: auto; display: block; margin: 0.4rem 0 1rem; } svg.narrow { display: none; }
svg text { font: 13px system-ui, sans-serif; fill: var(--soft); } svg text.name { fill: var(--ink); font-weight: 600; }
table { border-collapse: collapse; margin: 1rem 0; }
td, th { text-align: left; padding: 0.2rem 1.2rem 0.2rem 0; vertical-align: top; }
td.value { font-variant-numeric: tabular-nums; white-space: nowrap; } th { border-bottom: 1px solid var(--line); }
.key span { margin-right: 1.2em; white-space: nowrap; }
.key i { display: inline-block; width: 1em; height: 0.6em; margin-right: 0.4em; }
code { overflow-wrap: anywhere; }
summary { cursor: pointer; } details { margin: 0.5rem 0; }
@media (max-width: 600px) {
  svg.wide { display: none; } svg.narrow { display: block; }
  body { margin: 1rem auto; } thead { display: none; }
  tr { display: grid; grid-template-columns: 1fr auto; border-top: 1px solid var(--line); }
  td { padding: 0.1rem 0; } td:nth-child(3) { grid-column: 1 / -1; color: var(--soft); font-size: 0.9rem; }
}
"""
WIDE, NARROW, TALL, LEFT, FOOT, HEAD = 900, 420, 170, 70, 20, 22


class Curve(NamedTuple):
    """What is drawn over time: points, or a line."""

    t: Floats  # [s]
    values: Floats
    colour: str
    line: bool = False


def plot(curves: Sequence[Curve], label: str, ribbon: Sequence[tuple[float, float, str]] = (), zero: bool = False) -> str:
    """A small plot over time; where a value is missing there is a gap.

    Parameters
    ----------
    curves : sequence of Curve
    label : str
        What it shows, with the unit.
    ribbon : sequence of (float, float, str)
        Pieces of time [s] and their colour, under the plot.
    zero : bool, default False
        Whether to draw a line at 0.

    Returns
    -------
    html : str
        The plot twice, of which a page shows the one that is as wide as it is.
    """
    return "".join(_drawn(curves, label, ribbon, zero, wide) for wide in (WIDE, NARROW))


def _drawn(curves: Sequence[Curve], label: str, ribbon: Sequence[tuple[float, float, str]], zero: bool, wide: int) -> str:
    known = np.concatenate([curve.values[np.isfinite(curve.values)] for curve in curves])
    low, high = (float(round(one, 9)) for one in (known.min(), known.max()))
    if high - low < 1e-9:
        low, high = low - 1.0, high + 1.0
    begin = min(float(curve.t[0]) for curve in curves)
    span = max(max(float(curve.t[-1]) for curve in curves) - begin, 1e-9)

    def across(t: Floats) -> Floats:
        return LEFT + (t - begin) / span * (wide - LEFT - 8)

    def down(values: Floats) -> Floats:
        return HEAD + 4 + (high - values) / (high - low) * (TALL - FOOT - HEAD - 12)

    foot = TALL - FOOT
    parts = [
        f"<rect x='{LEFT}' y='{HEAD}' width='{wide - LEFT - 4}' height='{foot - HEAD - 4}' fill='none' stroke='var(--line)'/>",
        f"<text x='{LEFT}' y='14' class='name'>{escape(label)}</text>",
        f"<text x='2' y='{HEAD + 10}'>{high:.4g}</text><text x='2' y='{foot - 6}'>{low:.4g}</text>",
        f"<text x='{LEFT}' y='{TALL - 4}'>{begin:.3g} s</text>",
        f"<text x='{wide - 4}' y='{TALL - 4}' text-anchor='end'>{begin + span:.3g} s</text>",
    ]
    for first, last, colour in ribbon:
        a, b = across(np.array([first, last])).tolist()
        parts.append(f"<rect x='{a:.1f}' y='{foot - 4}' width='{max(b - a, 1):.1f}' height='5' fill='{colour}'/>")
    if zero and low < 0 < high:
        level = float(down(np.array(0.0)))
        parts.append(f"<line x1='{LEFT}' x2='{wide - 4}' y1='{level:.1f}' y2='{level:.1f}' stroke='var(--line)'/>")
    for curve in curves:
        there = np.isfinite(curve.values)
        places = list(zip(across(curve.t[there]).tolist(), down(curve.values[there]).tolist(), strict=True))
        if curve.line:
            path = " ".join(f"{a:.1f},{b:.1f}" for a, b in places)
            parts.append(f"<polyline points='{path}' fill='none' stroke='{curve.colour}'/>")
        else:
            dots = "".join(f"<circle cx='{a:.1f}' cy='{b:.1f}' r='1.6'/>" for a, b in places)
            parts.append(f"<g fill='{curve.colour}'>{dots}</g>")
    words = escape(label, quote=True)
    name = "wide" if wide == WIDE else "narrow"
    return f"<svg class='{name}' viewBox='0 0 {wide} {TALL}' role='img' aria-label='{words}'>{''.join(parts)}</svg>"
