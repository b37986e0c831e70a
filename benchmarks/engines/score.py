"""Score records of any program: one CSV file per motion of the benchmark.

    python benchmarks/engines/score.py hop.csv slip.csv …
    python benchmarks/engines/score.py hop.csv --plot hop.png

A file is named after its motion, or has a line '# scenario: hop' before its header; a line '# engine: NAME' names the
program in the plot. README.md describes the columns.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, NamedTuple

from measures import Measures
from phases import slip_velocity
from record import Record, check_rates, read_record
from scores import Scores, score
from table import COMMON_STEP, KEPT, LIGHT_GRAY, VERMILION, number, score_cells
from truth import scored, truths

HEADS = ("motion", "phases", "take-off °", "hop mm", "θ °", "behind", "ahead of")
LEFT = (0, 1, 5, 6)  # columns of words
LEGEND = (
    "Nearer to 0 is better. ✓: all phases right. The engines of the page are ordered by",
    "θ, each with its better settings at 1 ms.",
)
OURS = ("hophoop", "compliant", "scipy")  # no engines
LEAST_RATE = 500  # states per second; at 240 the exact motion itself loses short bounces


class Scored(NamedTuple):
    """A record with its scores."""

    scenario: str
    record: Record
    scores: Scores
    measures: Measures


def score_text(text: str, name: str) -> Scored:
    """Score the text of a record; its name is that of its file. A ValueError says what is wrong with it."""
    record = read_record(text, name)
    scenario = record.notes.get("scenario", Path(name).stem)
    if scenario not in truths():
        raise ValueError(
            f"{name}: scenario = {scenario!r} is not one of {', '.join(truths())}; "
            "name the file after its motion, such as hop.csv, or write a line '# scenario: hop' before the header."
        )
    try:
        scores, measures = score(record, truths()[scenario])
        check_rates(record.states)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    return Scored(scenario, record, scores, measures)


def lines_of(found: Sequence[Scored]) -> list[str]:
    """Return the table: the errors are record minus truth, θ the maximum over the motion."""
    rows = [HEADS]
    for one in found:
        exact = truths()[one.scenario].measures.sequence
        phases = f"{one.measures.sequence} ✓" if one.scores.sequence_right else f"{one.measures.sequence}, not {exact}"
        rows.append(
            (one.scenario, phases, *score_cells(one.scores.to_dict()), *neighbours(one.scenario, one.scores.angle_error))
        )
    columns = [[cell.ljust if k in LEFT else cell.rjust for cell in column] for k, column in enumerate(zip(*rows, strict=True))]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = [
        "  ".join(place(width) for place, width in zip(row, widths, strict=True)).rstrip() for row in zip(*columns, strict=True)
    ]
    missing = [name for name in scored() if name not in {one.scenario for one in found}]
    absent = f"; no record of {', '.join(missing)}" if missing else ""
    sparse = ", ".join(one.scenario for one in found if len(one.record.states.t) < LEAST_RATE * one.record.states.t[-1])
    doubt = [f"Fewer than {LEAST_RATE} states per second, too few to be sure of phases: {sparse}"] if sparse else []
    return [*lines, *LEGEND, *doubt, f"{count_right(found)} of {len(scored())} right{absent}"]


def neighbours(scenario: str, error: float) -> tuple[str, str]:
    """The engines of the page next to an error of θ [°] in a motion, the better one first, each with its own error."""
    kept = json.loads(KEPT.read_text(encoding="utf-8"))
    best: dict[str, float] = {}
    for row in kept["rows"]:
        if (row["scenario"], row["dt"]) == (scenario, COMMON_STEP) and "scores" in row and row["engine"] not in OURS:
            name = kept["engines"][row["engine"]]["title"]
            best[name] = min(row["scores"]["angle_error"], best.get(name, math.inf))
    ordered = sorted((value, name) for name, value in best.items())
    better, worse = ([one for one in ordered if (one[0] < error) == side] for side in (True, False))
    cells = [f"{name} {number(value, signed=False)}" for value, name in (*better[-1:], *worse[:1])]
    return ("" if not better else cells[0]), ("" if not worse else cells[-1])


def count_right(found: Sequence[Scored]) -> int:
    """Number of motions that count and have all phases of at least 20 ms right."""
    return len({one.scenario for one in found if one.scores.sequence_right} & set(scored()))


def document_of(found: Sequence[Scored]) -> dict[str, Any]:
    """Return all scores and measures for JSON: SI units and radians, angles of scores in degrees."""
    rows = [{"scenario": one.scenario, "scores": one.scores.to_dict(), "measures": asdict(one.measures)} for one in found]
    return {"right": count_right(found), "of": len(scored()), "records": rows}


def plot(found: Sequence[Scored]) -> Any:
    """Gap and slip velocity over time, one row per record, with the exact motion; records of one motion share scales."""
    from adapters.hophoop import run
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(
        len(found), 2, figsize=(9.0, 2.4 * len(found)), sharex="row", squeeze=False, layout="constrained"
    )
    first: dict[str, Any] = {}
    for (gap, slip), one in zip(axes, found, strict=True):
        truth, mine = truths()[one.scenario], one.record.states
        exact = run(truth.task, 0.0)
        gap.fill_between(exact.t, 0.0, 1e3 * exact.y, color=LIGHT_GRAY, linewidth=0)
        gap.plot(mine.t, 1e3 * mine.y, color=VERMILION, lw=1.2)
        gap.set(title=f"{one.record.notes.get('engine', 'record')}: {one.scenario}", ylabel="gap (mm)")
        slip.plot(exact.t, slip_velocity(truth.task, exact), color="#bbbbbb", lw=4.0)
        slip.plot(mine.t, slip_velocity(truth.task, mine), color=VERMILION, lw=1.2)
        slip.set(title="gray: exact; dashed: take-off of the record", ylabel="slip velocity (m/s)")
        for measures, color, style in ((truth.measures, "#777777", "-"), (one.measures, VERMILION, "--")):
            if measures.takeoff_time is not None:
                for ax in (gap, slip):
                    ax.axvline(measures.takeoff_time, color=color, ls=style, lw=0.8)
        for ax, other in zip((gap, slip), first.setdefault(one.scenario, (gap, slip)), strict=True):
            ax.sharey(other) if ax is not other else None
    for ax in axes[-1]:
        ax.set_xlabel("time (s)")
    return figure


def main(arguments: Sequence[str] | None = None) -> None:
    """Print the table or JSON."""
    parser = argparse.ArgumentParser(description="Score records of any program: one CSV file per motion of the benchmark.")
    parser.add_argument("record", nargs="+", type=Path, help="CSV with the header t,x,y,theta,vx,vy,omega")
    parser.add_argument("--json", action="store_true", help="print all scores and measures as JSON")
    parser.add_argument(
        "--plot", type=Path, metavar="FILE", help="draw gap and slip, with the exact motion: .png, .svg or .pdf"
    )
    given = parser.parse_args(arguments)
    try:
        found = [score_text(path.read_text(encoding="utf-8"), str(path)) for path in given.record]
        found.sort(key=lambda one: list(truths()).index(one.scenario))
    except UnicodeDecodeError as error:
        sys.exit(f"Error: a record is not a text file in UTF-8: {error}.")
    except (OSError, ValueError) as error:
        sys.exit(f"Error: {error}")
    print(json.dumps(document_of(found), indent=1, ensure_ascii=False) if given.json else "\n".join(lines_of(found)))
    if given.plot is not None:
        plot(found).savefig(given.plot, dpi=150)


if __name__ == "__main__":
    main()
