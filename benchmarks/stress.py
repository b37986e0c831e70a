"""Random motions by the million: how they end, and the worst violation of any law of the model.

    python benchmarks/stress.py                        # a million
    python benchmarks/stress.py --motions 20000 --jobs 2 --json stress.json
    python benchmarks/stress.py --markdown docs/tables/stress.md    # the tables of the documentation
    python benchmarks/stress.py --show 1234            # one of them, as a scenario and its events

Every motion runs through the kernel that `simulate` runs and is sampled at `SAMPLES` times as `at` does. The checks
are made with formulas of their own: energies, the gap in flight, the friction cone. A motion is drawn from
(seed, index) alone, so any of them can be had again.
"""

from __future__ import annotations

import argparse
import collections
import json
import math
import multiprocessing
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

import hophoop as hh
from hophoop.kernel.native import compiled
from hophoop.kernel.physics.body import EVENT_NAMES, Event, ImpactLaw, Status
from hophoop.kernel.records.cells import CELL, Cell, body_of, second_of, start_of
from hophoop.kernel.records.layout import COLUMNS, EVENT, SEGMENT, new_scratch
from hophoop.kernel.rigid.run import BY_RULE, run
from hophoop.kernel.rigid.sampling import find_segment, sample

sys.path.append(str(Path(__file__).resolve().parents[1] / "tests"))
from random_scenarios import EVENTS, draw, draw_beside_a_border, scenario_of

SAMPLES = 24
BLOCK = 500
SEGMENTS = 150_000

MEASURES = ("ledger at the end", "ledger at any time", "penetration", "pull", "cone", "friction along slip", "mirror")
LEDGER, ALWAYS, GAP, PULL, CONE, POWER, MIRROR = range(len(MEASURES))
KINDS = (
    "ideal, 1 − γ ≥ 0.001",
    "general",
    "nearly massless, 1 − γ from 0.001 to 1e-12",
    "beside a border of theory",
)
BESIDE = 3


def drawn_at(seed: int, index: int) -> tuple[int, dict[str, Any]]:
    """(kind, sections) of a motion: every tenth starts within a few roundings of a border that theory knows."""
    if index % 10 == 9:
        return BESIDE, draw_beside_a_border(seed, index)[1]
    return draw(seed, index)


def cell_of(sections: dict[str, Any], sign: float = 1.0) -> np.ndarray:
    """The scenario, or its mirror image, as a column for the kernel."""
    hoop, plane, start = sections["hoop"], sections["plane"], sections["start"]
    if "load_fraction" in hoop:
        gamma = hoop["load_fraction"]
        eccentricity, inertia_ratio = gamma, (1 - gamma) * (1 + gamma)
    else:
        eccentricity, inertia_ratio = hoop["eccentricity"], hoop["inertia_ratio"]
    radius = hoop["radius"]
    omega = start["speed"] / radius if "speed" in start else start["omega"]
    slip = 0.0 if "speed" in start else start["vx"] - radius * omega
    values = {
        "radius": radius,
        "mass": hoop["mass"],
        "eccentricity": eccentricity,
        "inertia_ratio": inertia_ratio,
        **{name: plane[name] for name in ("gravity", "mu_static", "mu_kinetic", "restitution")},
        "slope": sign * plane["slope"],
        "law": int(ImpactLaw[plane["impact_law"].upper()]),
        "painleve_impact": plane["painleve"] == "impact",
        "x": 0.0,
        "height": start.get("height", 0.0),
        "angle": sign * start["angle"],
        "vy": start.get("vy", 0.0),
        "omega": sign * omega,
        "slip": sign * slip,
        "mode": BY_RULE,
        "duration": sections["duration"],
        "max_events": EVENTS,
        "ideal": "load_fraction" in hoop,
        "rolling_resistance": plane.get("rolling_resistance", 0.0),
        "allowed": 1,
    }
    return np.array([float(values[name]) for name in CELL]) + 0.0


def energies(body, height, x, angle, low, slip, vy, omega):
    """Kinetic and potential energy, from the velocity of G; θ is angle + low."""
    s, c = math.sin(angle), math.cos(angle)
    half = math.cos(0.5 * angle)
    along = slip + omega * ((1.0 - body.eps) + body.eps * (2.0 * half * half - s * low))
    s, c = s + c * low, c - s * low
    up = vy - body.eps * omega * s
    kinetic = 0.5 * (along * along + up * up + body.kap * omega * omega)
    potential = body.gn * (height + body.eps * (c - 1.0)) - body.gt * (x + body.eps * s)
    return kinetic, potential


def measure(body, events, count, segments, pieces, out, times, worst):
    """Fill `worst` with the largest violations of one motion, each beside what it is to be judged by."""
    first = events[0]
    end = segments[pieces - 1]["t_end"]
    for k in range(times.shape[0]):
        times[k] = end * k / (times.shape[0] - 1)
    compiled(sample)(body, segments[:pieces], times, False, out)
    kinetic, potential = energies(
        body,
        first["height"],
        first["x"],
        first["theta"],
        first["theta_low"],
        first["before_slip"],
        first["before_vy"],
        first["before_omega"],
    )
    whole = kinetic + potential
    size = max(kinetic, body.gn + abs(body.gt))
    fastest = 0.0
    for k in range(times.shape[0]):
        fastest = max(fastest, out[k, 6] * out[k, 6])
    last = out[times.shape[0] - 1]
    ended, low = energies(body, last[2], last[1], last[13], last[14], last[7], last[5], last[6])
    size = max(size, ended, abs(low), last[10])
    force = body.gn + abs(body.gt) + fastest
    for k in range(times.shape[0]):
        row = out[k]
        mode = int(row[0])
        kinetic, potential = energies(body, row[2], row[1], row[13], row[14], row[7], row[5], row[6])
        residual = abs(kinetic + potential + row[10] + row[11] + row[12] - whole) / size
        if not residual <= worst[ALWAYS]:
            worst[ALWAYS] = residual
        if k == times.shape[0] - 1:
            worst[LEDGER] = residual
        if mode == 3:
            segment = segments[find_segment(segments["t"][:pieces], times[k], False)]
            tau = times[k] - segment["t"]
            rise = segment["vy"] - body.eps * math.sin(segment["angle"]) * segment["omega"]
            top = segment["height"] + body.eps * math.cos(segment["angle"])
            gap = top + rise * tau - 0.5 * body.gn * tau * tau - body.eps * math.cos(row[3])
            worst[GAP] = max(worst[GAP], -gap / (1.0 + abs(rise * tau)))
            continue
        friction, normal = row[8], row[9]
        worst[PULL] = max(worst[PULL], -normal / force)
        if not math.isinf(body.mu_s):
            excess = abs(friction) - body.mu_s * max(normal, 0.0)
            worst[CONE] = max(worst[CONE], excess / (force * (1.0 + body.mu_s) + abs(friction)))
        worst[POWER] = max(worst[POWER], friction * row[7] / ((force + abs(friction)) * (1.0 + abs(row[7]))))


def one_motion(cell, events, segments, scratch):
    """Status and numbers of events and segments."""
    second = second_of(cell)
    body = body_of(cell)
    start = start_of(cell, second)
    return compiled(run)(body, start, BY_RULE, cell[Cell.DURATION] / second, math.nan, 0, events, segments, scratch)


def evaluate(cells, mirrors, kinds, worst, doubts):
    """Rows of statuses, numbers of events of each kind, and worst violations."""
    scratch = new_scratch()
    events = np.empty(EVENTS, EVENT)
    other = np.empty(EVENTS, EVENT)
    segments = np.empty(SEGMENTS, SEGMENT)
    times = np.empty(SAMPLES)
    out = np.empty((SAMPLES, len(COLUMNS)))
    statuses = np.empty(cells.shape[0], np.int64)
    for i in range(cells.shape[0]):
        cell = cells[i]
        status, count, pieces = one_motion(cell, events, segments, scratch)
        statuses[i] = status
        doubts[i] = scratch.doubt[0]
        for k in range(count):
            kinds[i, events[k]["kind"]] += 1
        if pieces > 0:
            measure(body_of(cell), events, count, segments, pieces, out, times, worst[i])
        mirror = mirrors[i]
        again, number, _ = one_motion(mirror, other, segments, scratch)
        differs = 0.0
        if again != status or number != count:
            differs = math.inf
        else:
            for k in range(count):
                scale = 1.0 + abs(events[k]["angle"]) + abs(events[k]["omega"])
                differs = max(differs, abs(events[k]["angle"] + other[k]["angle"]) / scale)
                differs = max(differs, abs(events[k]["omega"] + other[k]["omega"]) / scale)
        worst[i, MIRROR] = differs
    return statuses


def work(task: tuple[int, int, int]) -> dict[str, Any]:
    """One block of motions."""
    seed, low, high = task
    drawn = [drawn_at(seed, index) for index in range(low, high)]
    cells = np.array([cell_of(sections) for _, sections in drawn])
    mirrors = np.array([cell_of(sections, -1.0) for _, sections in drawn])
    kinds = np.zeros((high - low, len(EVENT_NAMES)), np.int64)
    worst = np.zeros((high - low, len(MEASURES)))
    doubts = np.zeros(high - low)
    statuses = evaluate(cells, mirrors, kinds, worst, doubts)
    hoops = np.array([kind for kind, _ in drawn])
    endless = np.array([math.isinf(sections["plane"]["mu_static"]) for _, sections in drawn])
    newton = np.array([sections["plane"]["impact_law"] == "newton" for _, sections in drawn])
    gain = kinds[:, Event.KANE_GAIN] > 0
    result: dict[str, Any] = {
        "statuses": collections.Counter(),
        "events": collections.Counter(),
        "odd": collections.defaultdict(list),
        "worst": {},
        "above": collections.Counter(),
    }
    for kind in range(len(KINDS)):
        for rough, tail in ((False, ""), (True, ", μ = ∞")):
            chosen = statuses[(hoops == kind) & (endless == rough)]
            asked = int(np.isfinite(doubts[(hoops == kind) & (endless == rough)]).sum())
            if asked:
                result["statuses"][kind, "in doubt" + tail] += asked
            for status, number in zip(*np.unique(chosen, return_counts=True), strict=True):
                result["statuses"][kind, Status(status).name.lower() + tail] += int(number)
        mine = np.flatnonzero(hoops == kind)
        for m in range(len(MEASURES)):
            if len(mine):
                at = mine[np.argmax(np.nan_to_num(worst[mine, m], nan=math.inf))]
                result["worst"][kind, m] = (float(worst[at, m]), low + int(at))
                result["above"][kind, m] += int(np.sum(~(worst[mine, m] <= 1e-11)))
    for name, number in zip(EVENT_NAMES, np.count_nonzero(kinds, axis=0), strict=True):
        result["events"][name] = int(number)
    for name in ("jammed", "undetermined", "event_limit", "buffer"):
        where = np.flatnonzero((statuses == Status[name.upper()]) & ~endless)
        result["odd"][name] = [low + int(i) for i in where[:5]]
    result["odd"]["gain without Newton"] = [low + int(i) for i in np.flatnonzero(gain & ~newton)[:5]]
    return result


def together(results: list[dict[str, Any]]) -> dict[str, Any]:
    """Add the blocks up."""
    total: dict[str, Any] = {
        "statuses": collections.Counter(),
        "events": collections.Counter(),
        "odd": collections.defaultdict(list),
        "worst": {},
        "above": collections.Counter(),
    }
    for result in results:
        for name in ("statuses", "events", "above"):
            total[name].update(result[name])
        for name, found in result["odd"].items():
            total["odd"][name] = (total["odd"][name] + found)[:8]
        for key, (value, index) in result["worst"].items():
            if not value <= total["worst"].get(key, (-1.0, 0))[0]:
                total["worst"][key] = (value, index)
    return total


def report(total: dict[str, Any], motions: int, seconds: float) -> str:
    """The result in words and columns."""
    lines = [f"{motions} motions, each also mirrored, in {seconds:.0f} s", ""]
    for kind, title in enumerate(KINDS):
        of_kind = {name: number for (k, name), number in total["statuses"].items() if k == kind}
        lines.append(f"{title}: {sum(n for name, n in of_kind.items() if not name.startswith('in doubt'))}")
        lines += [f"    {name:20s} {number:9d}" for name, number in sorted(of_kind.items(), key=lambda item: -item[1])]
        for m, measure_name in enumerate(MEASURES):
            if (kind, m) in total["worst"]:
                value, index = total["worst"][kind, m]
                above = total["above"][kind, m]
                lines.append(f"    worst {measure_name:20s} {value:9.2e}  (motion {index}; {above} above 1e-11)")
    lines.append("motions with at least one event of a kind:")
    lines += [f"    {name:24s} {number:9d}" for name, number in total["events"].items()]
    lines += [f"{name}: first {found}" for name, found in total["odd"].items() if found]
    return "\n".join(lines)


def plainly(total: dict[str, Any], asked: argparse.Namespace, seconds: float) -> dict[str, Any]:
    """The result with names in place of numbers, as JSON can hold it."""

    def by_name(found: dict[tuple[int, Any], Any], names: Sequence[str] | None = None) -> dict[str, dict[str, Any]]:
        return {
            kind: {names[name] if names else name: value for (j, name), value in found.items() if j == k}
            for k, kind in enumerate(KINDS)
        }

    return {
        "motions": asked.motions,
        "first": asked.first,
        "seed": asked.seed,
        "jobs": asked.jobs,
        "seconds": seconds,
        "version": hh.__version__,
        "statuses": by_name(total["statuses"]),
        "worst": by_name(total["worst"], MEASURES),
        "above 1e-11": by_name(total["above"], MEASURES),
        "events": dict(total["events"]),
        "odd": {name: found for name, found in total["odd"].items() if found},
    }


def markdown(plain: dict[str, Any]) -> str:
    """The tables of docs/testing.md, from what `--json` writes."""

    def row(*cells: object) -> str:
        return "| " + " | ".join(str(cell) for cell in cells) + " |"

    def count(number: int) -> str:
        return f"{number:,}"

    def power(value: float) -> str:
        if value == 0.0 or not math.isfinite(value):
            return "0" if value == 0.0 else "different events"
        exponent = math.floor(math.log10(value))
        return f"{value / 10.0**exponent:.1f}·10{str(exponent).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}"

    motions = plain["motions"]
    # those in doubt are counted under what they ended with, too
    numbers = {
        kind: sum(number for name, number in plain["statuses"][kind].items() if not name.startswith("in doubt"))
        for kind in KINDS
    }
    titles = [f"{kind} ({count(numbers[kind])})" for kind in KINDS]
    lines = [
        f"{count(motions)} motions, numbers {count(plain['first'])} to {count(plain['first'] + motions - 1)} of seed "
        f"{plain['seed']}, each also mirrored, with version {plain['version']}: {plain['seconds']:,.0f} s "
        f"with {plain['jobs']} process{'es' if plain['jobs'] > 1 else ''}.",
        "",
        row("Ended with", *titles),
        row(*["---"] * (1 + len(KINDS))),
    ]
    names = dict.fromkeys(name for kind in KINDS for name in plain["statuses"][kind])
    for name in sorted(names, key=lambda name: ("∞" in name, -sum(plain["statuses"][kind].get(name, 0) for kind in KINDS))):
        status, _, rough = name.partition(", ")
        cells = [count(plain["statuses"][kind].get(name, 0)) for kind in KINDS]
        lines.append(row(f"`{status}`{', ' + rough if rough else ''}", *cells))
    lines += ["", row("Worst violation (motion)", *KINDS), row(*["---"] * (1 + len(KINDS)))]
    for name in MEASURES:
        cells = []
        for kind in KINDS:
            if name not in plain["worst"][kind]:
                cells.append("–")
                continue
            value, index = plain["worst"][kind][name]
            above = plain["above 1e-11"][kind][name]
            number = f" ({index})" if value else ""
            cells.append(power(value) + number + (f"; {count(above)} above 10⁻¹¹" if above else ""))
        lines.append(row(name, *cells))
    lines += ["", row("Event", "motions in which it occurs", "share"), row(*["---"] * 3)]
    for name, number in sorted(plain["events"].items(), key=lambda item: -item[1]):
        lines.append(row(f"`{name}`", count(number), f"{100.0 * number / motions:.3g} %"))
    lines.append("")
    for name, found in plain["odd"].items():
        if found:
            lines.append(f"* {name}: the first are motions {', '.join(str(index) for index in found)}.")
    return "\n".join(lines).rstrip() + "\n"


def show(seed: int, index: int) -> None:
    """One motion, in full."""
    kind, sections = drawn_at(seed, index)
    print(KINDS[kind])
    print(json.dumps(sections, indent=2))
    motion = hh.simulate(scenario_of(sections))
    print(motion, motion.ledger)
    for event in motion.events[:60]:
        print(
            f"{event.t:.12g} {event.kind} {event.from_mode}→{event.to_mode} angle {event.angle:.12g} "
            f"omega {event.omega:.6g} slip {event.slip:.6g} vy {event.vy:.6g}"
        )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--motions", type=int, default=1_000_000)
    parser.add_argument("--first", type=int, default=0, help="index of the first motion")
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--jobs", type=int, default=multiprocessing.cpu_count())
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--markdown", metavar="FILE", help="write the tables of docs/testing.md there")
    parser.add_argument("--show", type=int, metavar="INDEX")
    arguments = parser.parse_args()
    if arguments.show is not None:
        show(arguments.seed, arguments.show)
        return 0
    begin = time.perf_counter()
    work((arguments.seed, 0, 1))  # compiles before the processes part
    end = arguments.first + arguments.motions
    tasks = [(arguments.seed, low, min(low + BLOCK, end)) for low in range(arguments.first, end, BLOCK)]
    with multiprocessing.Pool(arguments.jobs) as pool:
        results = []
        for result in pool.imap_unordered(work, tasks):
            results.append(result)
            if sys.stderr.isatty():
                print(f"\r{len(results) * BLOCK} / {arguments.motions}", end="", file=sys.stderr)
    total = together(results)
    seconds = time.perf_counter() - begin
    print(report(total, arguments.motions, seconds))
    plain = plainly(total, arguments, seconds)
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(plain, file, indent=2)
    if arguments.markdown:
        with open(arguments.markdown, "w", encoding="utf-8") as file:
            file.write(markdown(plain))
    return int(bool(total["odd"]["gain without Newton"] or total["odd"]["buffer"]))


if __name__ == "__main__":
    sys.exit(main())
