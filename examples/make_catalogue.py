"""Make the catalogue of first revolutions that hophoop ships (src/hophoop/maps/catalogue.json).

    python examples/make_catalogue.py [--levels 7] [--out catalogue.json]
    python examples/make_catalogue.py --figure docs/figures/catalogue-load-fraction.svg    # draw what is shipped

For each γ the window of friction and speed is cut into squares of one class, halved again and again where the
class changes (`hophoop.maps.refine`), so that what counts is how thin a region is, not where a grid's points
fall. Around every place where three classes meet, smaller and smaller circles are looked at for classes that
only live there.
"""

from __future__ import annotations

import argparse
import json
import math
import time
from pathlib import Path

import numpy as np

import hophoop as hh
from hophoop import maps
from hophoop.maps.classes import Classifier, make_window
from hophoop.maps.refinement import refine

# μ and v0 above 0: on the edges themselves the hoop rests or nothing is friction. The immediate hop begins at
# √(g R/γ) whatever the friction; beyond it there is nothing but H.
MU = (1e-3, 2.0)
FASTEST = 1.06
RADII = (1e-3, 1e-5, 1e-7, 1e-9)
HOOPS = (0.75, *(k / 50 for k in range(1, 50)), 0.95, 0.99, 0.995, 0.999)


def catalogue_of(gamma: float, levels: int, cells: int) -> dict:
    base = hh.Scenario().replace("hoop.load_fraction", gamma)
    ranges = {"plane.mu": MU, "start.speed": (1e-3, FASTEST * math.sqrt(9.81 / gamma))}
    quantities = ("sequence", "ending")
    refined = refine(base, ranges, levels, cells, quantities)
    examples = examples_of(refined)
    shares = refined.shares()
    window = make_window(base, ranges)
    looked = around_junctions(Classifier(base, window, quantities, "first_revolution"), refined)
    for name, place in looked.items():
        if name not in examples:
            examples[name] = tuple(float(value[0]) for value in window.values(*place))
    entries = []
    for name in sorted(examples, key=lambda name: -shares.get(name, (0.0, 0.0))[0]):
        sequence, ending = name.split(" ")
        area, doubt = shares.get(name, (0.0, 0.0))
        mu, speed = examples[name]
        entries.append(
            {
                "sequence": sequence,
                "ending": ending,
                "area": float(f"{area:.4g}"),
                "uncertainty": float(f"{doubt:.2g}"),
                "mu": float(f"{mu:.12g}"),
                "speed": float(f"{speed:.12g}"),
            }
        )
    return {
        "mu_range": list(MU),
        "speed_range": list(ranges["start.speed"]),
        "smallest_square": 1.0 / (cells << levels),
        "motions": refined.evaluated,
        "entries": entries,
    }


def examples_of(refined) -> dict[str, tuple[float, float]]:
    """The middle of the largest pure square of each class, or a corner where there is none."""
    found = {}
    mixed = refined.mixed
    for code, name in enumerate(refined.classes):
        pure = np.flatnonzero(~mixed & (refined.codes[:, 0] == code))
        if pure.size:
            # of the squares that are largest, the one amid the others
            best = pure[refined.level[pure] == refined.level[pure].min()]
            k = best[best.size // 2]
            found[name] = (
                float(refined.x[k] + refined.width[k] / 2),
                float(refined.y[k] + refined.height[k] / 2),
            )
            continue
        squares, corners = np.nonzero(refined.codes == code)
        if squares.size:
            k, corner = squares[0], corners[0]
            found[name] = (
                float(refined.x[k] + refined.width[k] * (corner & 1)),
                float(refined.y[k] + refined.height[k] * (corner >> 1)),
            )
    return found


def around_junctions(classify, refined) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Classes on small circles around the squares in which three or more classes meet, each with a place."""
    found = {}
    count = np.array([np.unique(row).size for row in refined.codes])
    window = refined.window
    phi = 2 * math.pi * np.arange(64) / 64
    for k in np.flatnonzero(count >= 3):
        u, v = window.places(refined.x[k] + refined.width[k] / 2, refined.y[k] + refined.height[k] / 2)
        for radius in RADII:
            ring = np.clip(u + radius * np.cos(phi), 0, 1), np.clip(v + radius * np.sin(phi), 0, 1)
            codes = classify(*ring)
            for code in np.unique(codes):
                m = int(np.flatnonzero(codes == code)[0])
                found.setdefault(classify.names[code], (ring[0][m : m + 1], ring[1][m : m + 1]))
            # towards where most classes meet
            kinds = np.array([np.unique(codes[np.arange(i - 4, i + 5) % 64]).size for i in range(64)])
            best = int(np.argmax(kinds))
            if kinds[best] >= 3:
                u, v = ring[0][best], ring[1][best]
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--levels", type=int, default=7)
    parser.add_argument("--cells", type=int, default=96)
    parser.add_argument("--fewer", type=int, default=3, help="levels less for the hoops other than γ = 3/4")
    parser.add_argument("--out", type=Path, default=Path("src/hophoop/maps/catalogue.json"))
    parser.add_argument("--figure", type=Path, help="only draw the shipped catalogue over γ, into this file")
    options = parser.parse_args()
    if options.figure:
        draw(options.figure)
        return
    hoops = {}
    for gamma in HOOPS:
        began = time.perf_counter()
        levels = options.levels if gamma == 0.75 else max(options.levels - options.fewer, 0)
        hoops[repr(gamma)] = catalogue_of(gamma, levels, options.cells)
        found = hoops[repr(gamma)]["entries"]
        sequences = {entry["sequence"] for entry in found}
        print(
            f"γ = {gamma}: {len(sequences)} sequences, {len(found)} with their endings, "
            f"{hoops[repr(gamma)]['motions']:,} motions in {time.perf_counter() - began:.0f} s",
            flush=True,
        )
        # a line a hoop
        lines = [f"{json.dumps(key)}:{json.dumps(value, separators=(',', ':'))}" for key, value in hoops.items()]
        text = f'{{"hophoop":{json.dumps(hh.__version__)},"hoops":{{\n' + ",\n".join(lines) + "\n}}\n"
        options.out.write_text(text, encoding="utf-8")


def draw(path: Path) -> None:
    """Which sequences a hoop shows, over γ, and how much of the window each fills."""
    import matplotlib.pyplot as plt

    from hophoop.plots import class_color

    hoops = maps.catalogued()
    areas: dict[str, dict[float, float]] = {}
    for gamma in hoops:
        for entry in maps.catalogue(gamma):
            shares = areas.setdefault(entry.sequence, {})
            shares[gamma] = shares.get(gamma, 0.0) + entry.area
    # from the first that appear to the last
    order = sorted(areas, key=lambda name: (-len(areas[name]), min(areas[name])))
    edges = np.concatenate(([0.0], 0.5 * (np.array(hoops[1:]) + np.array(hoops[:-1])), [1.0]))
    fig, (count, ax) = plt.subplots(2, 1, figsize=(8.2, 9.6), sharex=True, height_ratios=(1, 6), layout="constrained")
    for row, name in enumerate(order):
        for k, gamma in enumerate(hoops):
            if gamma in areas[name]:
                size = math.log10(max(areas[name][gamma], 1e-7))
                thick = 0.16 + 0.74 * (size + 7) / 7
                ax.barh(row, edges[k + 1] - edges[k], thick, left=edges[k], color=class_color(name), lw=0)
    ax.set_yticks(range(len(order)), order, fontsize=7.5)
    ax.set_ylim(len(order) - 0.4, -0.6)
    ax.set_xlim(0.0, 1.0)
    ax.set_xlabel("Load fraction γ")
    ax.set_ylabel("Sequence; a bar's thickness is the logarithm of its share, from $10^{-7}$ to 1")
    for values, label, line in (
        ([len({e.sequence for e in maps.catalogue(g)}) for g in hoops], "sequences", "-"),
        ([len(maps.catalogue(g)) for g in hoops], "with their endings", "--"),
    ):
        count.step(hoops, values, line, where="mid", color="black", label=label)
    count.set_ylabel("Number")
    count.set_ylim(0, None)
    count.legend(frameon=False, ncols=2, loc="lower center")
    fig.savefig(path)
    plt.close(fig)
    print(path)


if __name__ == "__main__":
    main()
