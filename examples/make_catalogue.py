"""Make the catalogue of first revolutions that hophoop ships (src/hophoop/maps/catalogue.json).

    python examples/make_catalogue.py [--out catalogue.json] [--resume]
    python examples/make_catalogue.py --figures docs/figures    # draw what is shipped
    python examples/make_catalogue.py --tables                  # print the table of docs/catalogue.md
    python examples/make_catalogue.py --fingerprints            # compute the examples' fingerprints again, in half a minute

For each γ the borders between classes are followed through the window of friction and speed, and the places where
classes meet to rounding (`hophoop.maps.survey.survey`). Classes narrower than CHECKED are computed again from Taylor series
in 40 digits (tests/oracles); what these refute is not counted but listed.
"""

from __future__ import annotations

import argparse
import itertools
import json
import math
import multiprocessing
import os
import sys
import time
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path

import numpy as np

import hophoop as hh
from hophoop import maps
from hophoop.maps.grid.evaluate import thread_limit
from hophoop.maps.survey.survey import NARROWEST, survey
from hophoop.vocabulary import colors

ROOT = Path(__file__).resolve().parents[1]
HOOPS = (0.75, *(k / 50 for k in range(1, 50)), 0.95, 0.99, 0.995, 0.999)
FINEST = 0.75  # the article's hoop is looked at more closely
CHECKED = 1e-9  # narrower classes are checked in 40 digits, in parts of the window
LEAST_SHARE = 5e-3  # of the window: classes that the table lists


def class_in_digits(gamma: float, mu: float, speed: float, digits: int = 40) -> tuple[str, str]:
    """Sequence and ending of the first revolution, from Taylor series in so many digits."""
    sys.path.insert(0, str(ROOT / "tests"))
    from oracles.cases import rolling
    from oracles.precise import solve

    sys.path.pop(0)
    hoop = hh.Hoop.ideal(gamma)
    place = {"hoop.load_fraction": gamma, "plane.mu": mu, "start.speed": speed}
    duration = 1.1 * float(maps.points(None, place, ["time"])["time"]) + 0.5
    letters = {"roll": "R", "spin": "S", "skid": "K", "flight": "H"}
    for _ in range(8):
        case = rolling("checked", speed, mu, eccentricity=gamma, inertia_ratio=hoop.inertia_ratio, duration=duration)
        sequence = ""
        for event in solve(case, digits).events:
            if event["angle"] > 2 * math.pi:
                return sequence, "revolutions"
            if event["kind"] == "turn":
                return sequence, "reversal"
            if event["kind"] != "end":
                mode = event["to"]
                sequence += letters.get(mode, mode)
                if sequence[-1] == "H":
                    return sequence, "takeoff"
        duration *= 1.5
    return sequence, "unended"


def fingerprint_of(gamma: float, entry: dict) -> str:
    """The fingerprint of an entry's example."""
    example = maps.Entry(**{**entry, "load_fraction": gamma, "fingerprint": ""})
    return hh.simulate(example.scenario()).fingerprint


def hoop_of(task: tuple[float, int, float, bool]) -> dict:
    """The catalogue of one γ, as it is stored."""
    gamma, lines, part, check = task
    began = time.perf_counter()
    with thread_limit(1):  # a process a core
        done = survey(gamma, lines, part)
    entries, refuted = [], []
    for one in done.found:
        entry = {
            "sequence": one.sequence,
            "ending": one.ending,
            "area": float(f"{one.area:.4g}"),
            "width": float(f"{one.width:.3g}"),
            "mu": one.mu,
            "speed": one.speed,
        }
        entry["fingerprint"] = fingerprint_of(gamma, entry)
        if check and one.width < CHECKED:
            truth = class_in_digits(gamma, one.mu, one.speed)
            if truth != (one.sequence, one.ending):
                refuted.append({**entry, "truth": " ".join(truth)})
                continue
        entries.append(entry)
    known = {(entry["sequence"], entry["ending"]) for entry in entries}
    too_narrow = [{**one._asdict(), "log10_width": round(one.log10_width, 2)} for one in done.too_narrow]
    hoop = {
        "load_fraction": gamma,
        "mu_range": list(done.mu_range),
        "speed_range": list(done.speed_range),
        "lines": lines,
        "part": part,
        "motions": done.motions,
        "complete": done.complete,
        "strips": [" ".join(strip) for strip in done.strips],
        "too_narrow": too_narrow,
        "refuted": refuted,
        "unexplained": [[" ".join(a), " ".join(b), x, y] for a, b, x, y in done.unexplained],
        "entries": entries,
        "seconds": time.perf_counter() - began,
    }
    if gamma == FINEST:
        known = {(entry["sequence"], entry["ending"]) for entry in entries}
        met = [[x, y, [" ".join(pair) for pair in classes if pair in known]] for x, y, classes in done.meetings]
        hoop["meetings"] = [one for one in met if len(one[2]) > 1]
    return hoop


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lines", type=int, default=50, help="lines laid by ratio, and as many by difference")
    parser.add_argument("--part", type=float, default=1e-10, help="part of μ to which meeting classes are followed")
    parser.add_argument("--finer", type=float, default=3.0, help="times the lines for γ = 3/4")
    parser.add_argument("--no-check", action="store_true", help="leave out the computation in 40 digits")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--resume", action="store_true", help="keep the hoops that the file has already")
    parser.add_argument("--out", type=Path, default=ROOT / "src" / "hophoop" / "maps" / "catalogue.json")
    parser.add_argument("--figures", type=Path, help="only draw the shipped catalogue, into this folder")
    parser.add_argument("--tables", action="store_true", help="only print the tables of the page")
    parser.add_argument("--fingerprints", action="store_true", help="only compute the fingerprints in the file again")
    options = parser.parse_args()
    if options.fingerprints:
        renew_fingerprints(options.out)
        return
    if options.figures or options.tables:
        if options.figures:
            draw(options.figures)
        if options.tables:
            print_tables()
        return
    began = time.perf_counter()
    hoops = {}
    if options.resume and options.out.exists():
        hoops = json.loads(options.out.read_text(encoding="utf-8"))["hoops"]
    left = [gamma for gamma in HOOPS if repr(gamma) not in hoops]
    tasks = []
    for gamma in left:
        finest = gamma == FINEST
        lines = round(options.lines * options.finer) if finest else options.lines
        part = max(options.part * 1e-3, 1e-13) if finest else options.part
        tasks.append((gamma, lines, part, not options.no_check))
    if tasks:  # compiled once, before the workers ask for it
        maps.points(None, {"start.speed": 1.0}, ["sequence", "ending"])
    workers = min(options.workers, len(tasks))
    if workers > 1:
        with ProcessPoolExecutor(workers, multiprocessing.get_context("spawn")) as pool:
            running = as_completed([pool.submit(hoop_of, task) for task in tasks])
            collect(options.out, hoops, len(left), (future.result() for future in running), began)
    else:
        collect(options.out, hoops, len(left), map(hoop_of, tasks), began)


def collect(out: Path, hoops: dict, left: int, found: Iterable[dict], began: float) -> None:
    """Write each hoop as it comes, and say so."""
    for done, hoop in enumerate(found, 1):
        seconds, gamma = hoop.pop("seconds"), hoop.pop("load_fraction")
        hoops[repr(gamma)] = hoop
        sequences = {entry["sequence"] for entry in hoop["entries"]}
        notes = "".join(f", {len(hoop[name])} {name}" for name in ("refuted", "unexplained") if hoop[name]) + (
            "" if hoop["complete"] else ", not complete"
        )
        print(
            f"{done}/{left} γ = {gamma}: {len(sequences)} sequences, {len(hoop['entries'])} with their endings, "
            f"{hoop['motions']:,} motions in {seconds:.0f} s{notes}; {time.perf_counter() - began:.0f} s so far",
            flush=True,
        )
        write(out, hoops)


def write(out: Path, hoops: dict) -> None:
    """The file, with one line per hoop."""
    ordered = {repr(one): hoops[repr(one)] for one in HOOPS if repr(one) in hoops}
    lines = [f"{json.dumps(key)}:{json.dumps(value, separators=(',', ':'))}" for key, value in ordered.items()]
    text = f'{{"hophoop":{json.dumps(hh.__version__)},"hoops":{{\n' + ",\n".join(lines) + "\n}}\n"
    out.write_text(text, encoding="utf-8")


def renew_fingerprints(out: Path) -> None:
    """Compute the fingerprints of all examples in the file again, after a change of the kernels' bits."""
    hoops = json.loads(out.read_text(encoding="utf-8"))["hoops"]
    changed = 0
    for key, hoop in hoops.items():
        for entry in hoop["entries"]:
            before = entry.get("fingerprint")
            entry["fingerprint"] = fingerprint_of(float(key), entry)
            changed += entry["fingerprint"] != before
    write(out, hoops)
    print(f"{changed} fingerprints of {sum(len(hoop['entries']) for hoop in hoops.values())} have changed: {out}")


def counts(gamma: float, width: float) -> tuple[int, int]:
    """Sequences, and sequences with their endings, of a width at least."""
    entries = maps.catalogue(gamma, width)
    return len({entry.sequence for entry in entries}), len(entries)


def print_tables() -> None:
    """The table of docs/catalogue.md."""
    print("| sequence | ending | share of the window | width | example μ | example $v_0$ (m/s) |")
    print("| --- | --- | --- | --- | --- | --- |")
    for entry in maps.catalogue():
        if entry.area < LEAST_SHARE:
            continue
        print(
            f"| {entry.sequence} | {entry.ending} | {100 * entry.area:.3g} % | {entry.width:.2g} "
            f"| {entry.mu:.10g} | {entry.speed:.10g} |"
        )


def union(width: float) -> tuple[int, int]:
    """Sequences, and with their endings, that one hoop or another shows at this width."""
    pairs = {(entry.sequence, entry.ending) for gamma in maps.catalogued() for entry in maps.catalogue(gamma, width)}
    return len({sequence for sequence, _ in pairs}), len(pairs)


def draw(folder: Path) -> None:
    """All figures of the page."""
    import matplotlib.pyplot as plt

    plt.rcParams["svg.hashsalt"] = "hophoop"  # the same picture is the same file
    folder.mkdir(parents=True, exist_ok=True)
    draw_over_gamma(folder / "catalogue-load-fraction.svg")
    draw_counts(folder / "catalogue-counts.svg")
    draw_plane(folder / "catalogue-plane.svg")


def draw_over_gamma(path: Path) -> None:
    """Which sequences a hoop shows, over γ, and how much of the window each fills."""
    import matplotlib.pyplot as plt

    from hophoop.plots import class_color
    from hophoop.plots.style import ON_COLOR

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
        ax.fill_between(edges, row - thick, row + thick, step="post", color=class_color(name), lw=0, gid=f"{ON_COLOR}-{name}")
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
    print(path)


def draw_counts(path: Path) -> None:
    """How many classes there are, over the width from which on they count."""
    import matplotlib.pyplot as plt

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
    print(path)


def draw_plane(path: Path, lines: int = 220) -> None:
    """The borders of γ = 3/4 and the places where classes meet."""
    import matplotlib.pyplot as plt
    from matplotlib.collections import PolyCollection
    from matplotlib.patheffects import withStroke

    from hophoop.plots import class_color
    from hophoop.plots.style import ON_COLOR
    from hophoop.vocabulary.labels import PARAMETERS, with_unit

    done = survey(FINEST, lines, 1e-9)
    slices = done.arrangement.slices
    quads, paint, borders = [], [], []
    for left, right in itertools.pairwise(slices):
        for code, quad in strips(left, right):
            quads.append(quad)
            paint.append(class_color(done.classes[code][0]))
            borders += [*quad[:2], (math.nan, math.nan)]
        borders += upright(left, right)
    places = [one[:2] for one in done.meetings]
    fig, axes = plt.subplots(1, 2, figsize=(11.0, 5.6), layout="constrained")
    for ax in axes:
        ax.add_collection(PolyCollection(quads, facecolors=paint, edgecolors="none", antialiased=False, rasterized=True))
        ax.plot(*zip(*borders, strict=True), color="black", lw=0.5, gid=f"{ON_COLOR}-borders")
        ax.plot(*zip(*places, strict=True), "o", ms=3.2, mfc="white", mec="black", mew=0.7, gid=f"{ON_COLOR}-places")
        ax.set_xlabel(PARAMETERS["plane.mu"])
        ax.set_ylabel(with_unit(PARAMETERS["start.speed"], "m/s"))
        ax.set_xlim(*done.mu_range)
        ax.set_ylim(*done.speed_range)
    white = [withStroke(linewidth=1.6, foreground="white")]
    for k, ((sequence, ending), (mu, speed)) in enumerate(names_in_the_plane(done).items()):
        text = sequence + "\nreversal" * (ending == "reversal")
        axes[0].text(
            mu, speed, text, fontsize=6.5, ha="center", va="center", linespacing=0.9, path_effects=white, gid=f"{ON_COLOR}-{k}"
        )
    axes[0].set_xlim(done.mu_range[0], 0.45)
    axes[1].set_xscale("log")
    axes[1].set_yscale("log")
    fig.savefig(path, dpi=160, metadata={"Date": None})
    plt.close(fig)
    print(path)


def strips(left, right):
    """Each class between two neighbouring lines: a quadrangle that begins with its upper border.

    Where the lines list the same classes, borders run straight from one to the other; elsewhere each line has its half.
    """
    half = 0.5 * (left.x + right.x)
    if left.codes.size == right.codes.size and (left.codes == right.codes).all():
        parts = [(left.codes, (left.x, right.x), (left.y, right.y))]
    else:
        parts = [(left.codes, (left.x, half), (left.y, left.y)), (right.codes, (half, right.x), (right.y, right.y))]
    for codes, (x0, x1), (y0, y1) in parts:
        for k, code in enumerate(codes):
            yield code, [(x0, y0[k + 1]), (x1, y1[k + 1]), (x1, y1[k]), (x0, y0[k])]


def upright(left, right) -> list[tuple[float, float]]:
    """Borders halfway between two lines, where one line has another class than its neighbour at the same speed."""
    found: list[tuple[float, float]] = []
    half, steps = 0.5 * (left.x + right.x), np.union1d(left.y, right.y)
    if left.codes.size == right.codes.size and (left.codes == right.codes).all():
        return found
    for low, high in itertools.pairwise(steps):
        here, there = (one.codes[np.searchsorted(one.y, 0.5 * (low + high)) - 1] for one in (left, right))
        if here != there:
            found += [(half, low), (half, high), (math.nan, math.nan)]
    return found


def names_in_the_plane(done) -> dict[tuple[str, str], tuple[float, float]]:
    """Where to write the name of each class that is wide enough, as (μ, v0)."""
    named = {(one.sequence, one.ending): (one.mu, one.speed) for one in done.found if one.width > 0.0135 and one.mu < 0.4}
    right = min(done.arrangement.slices, key=lambda one: abs(one.x - 0.4))
    for code, low, high in zip(right.codes, right.y[:-1], right.y[1:], strict=True):
        if high - low > 0.1:
            named.setdefault(done.classes[code], (right.x, 0.5 * (low + high)))
    return named


if __name__ == "__main__":
    main()
