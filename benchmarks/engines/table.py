"""Tables and figures of the page docs/engines.md, from the scores.json and the records that run.py writes.

    python benchmarks/engines/table.py DIR   # DIR of run.py --out: the page's data and figures become those of this run

The build of the documentation makes both tables from docs/tables/engines.json.
"""

from __future__ import annotations

import argparse
import io
import json
import math
import re
import shutil
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from record import read_record
from task import States
from truth import scored, truths

DOCS = Path(__file__).parents[2] / "docs"
KEPT = DOCS / "tables" / "engines.json"
HOP = "hop"
COMMON_STEP = 0.001
FITTED = {"hop_height": "m", "takeoff_angle": "rad"}
ORDERS = np.arange(0.25, 4.01, 0.05)
VERMILION, BLUE, LIGHT_GRAY = "#d55e00", "#0072b2", "#d9d9d9"
PANELS = 3  # in a row: a page of 736 px shows them at their size
SPAN = (0.95, 1.95)  # s, around the hop
FLOOR = 1e-3  # mm, the resolution of the record

Row = dict[str, Any]  # of scores.json


# The limit as the time step goes to 0


class Limit(NamedTuple):
    """The fit q(dt) = limit + c dt^order, in the unit of q.

    `order` is None if the quantity scatters or does not change. `scatter` is the deviation of the values from the fit, or
    their range without a fit.
    """

    limit: float
    order: float | None
    scatter: float


def limit_of(steps: ArrayLike, values: ArrayLike) -> Limit | None:
    """Fit the limit of a quantity over the time step [s]; None for fewer than four finite values.

    The order, from 0.25 to 4, is that of the best fit to the values of the five smallest steps. It counts only if it is from
    0.4 to 3, the values are monotonic, the fit leaves less than 5 % of their change, and their relative change is above 1e-6.
    """
    dt, q = np.asarray(steps, dtype=float), np.asarray(values, dtype=float)
    dt, q = dt[np.isfinite(q)], q[np.isfinite(q)]
    if len(dt) < 4:
        return None
    finest = np.argsort(dt)[:5]
    dt, q = dt[finest], q[finest]
    spread = float(np.ptp(q))
    if spread <= 1e-6 * max(abs(float(q[0])), 1e-12):
        return Limit(float(q[0]), None, spread)
    fits = []
    for order in ORDERS:
        columns = np.stack([np.ones_like(dt), (dt / dt[-1]) ** order], axis=1)
        solution, *_ = np.linalg.lstsq(columns, q, rcond=None)
        fits.append((float(np.sqrt(np.mean((columns @ solution - q) ** 2))), float(order), float(solution[0])))
    off, order, limit = min(fits)
    one_way = bool((np.diff(q) > 0.0).all() or (np.diff(q) < 0.0).all())
    if off > 0.05 * spread or not 0.4 <= order <= 3.0 or not one_way:
        return Limit(float(q[0]), None, float(np.std(q[:3])))
    return Limit(limit, order, off)


def limits(rows: Sequence[Row]) -> list[Row]:
    """Return the limits of the hop for each engine and its settings, as in scores.json."""
    found = []
    for engine, setting in dict.fromkeys((row["engine"], row["setting"]) for row in rows):
        ladder = [row for row in _scored_hops(rows, engine) if row["setting"] == setting]
        for quantity, unit in FITTED.items():
            values = [row["measures"][quantity] for row in ladder]
            one = limit_of([row["dt"] for row in ladder], [math.nan if value is None else value for value in values])
            if one is not None:
                error = one.limit - getattr(truths()[HOP].measures, quantity)
                head = {"engine": engine, "setting": setting, "scenario": HOP, "quantity": quantity, "unit": unit}
                found.append(head | {"limit": one.limit, "error": error, "order": one.order, "scatter": one.scatter})
    return found


def _scored_hops(rows: Sequence[Row], engine: str) -> list[Row]:
    """Runs of the hop with scores, from coarse to fine time steps."""
    found = [row for row in rows if (row["engine"], row["scenario"]) == (engine, HOP) and "scores" in row]
    return sorted(found, key=lambda row: -row["dt"])


# Words


def number(value: Any, scale: float = 1.0, signed: bool = True) -> str:
    """Format an error with two significant digits."""
    if value is None:
        return "–"
    if value == "missing" or math.isnan(value):
        return "none"
    scaled = value * scale
    if abs(scaled) < 5e-4:
        return "0"
    text = f"{scaled:+.2g}" if signed else f"{scaled:.2g}"
    if "e" in text or abs(scaled) >= 100:
        text = f"{scaled:+,.0f}" if signed else f"{scaled:,.0f}"
    return text.replace("-", "−")


def score_cells(scores: dict[str, Any]) -> list[str]:
    """Take-off (°), hop (mm) and θ at most (°)."""
    return [
        number(scores["takeoff_angle"]),
        number(scores["hop_height"], 1e3),
        number(scores["angle_error"], signed=False),
    ]


def row_line(row: Row) -> str:
    """Return a row of scores.json in one line for a terminal."""
    start = f"{row['engine']:10} {row['setting']:8} {row['scenario']:9} {1e3 * row['dt']:6.4g} ms  "
    if "failure" in row:
        return start + str(row["failure"])
    lift, hop, angle = score_cells(row["scores"])
    mark = "✓" if row["scores"]["sequence_right"] else " "
    return start + f"{mark} take-off {lift:>8}°  hop {hop:>6} mm  θ {angle:>6}°  {row['measures']['sequence']}"


def record_name(row: Row) -> str:
    """Return the file name of a run's record."""
    return f"{row['engine']}-{row['setting']}-{row['scenario']}.csv"


def markdown(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """Format a table as Markdown."""
    lines = [list(head), *(list(row) for row in rows)]
    lines.insert(1, ["---"] * len(lines[0]))
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines) + "\n"


def _titled(engine: dict[str, Any]) -> str:
    """Title and version of an engine; ours have none, and Box2D has its version in its title."""
    return engine["title"] if engine["ours"] else f"{engine['title'].removesuffix(' 2.3')} {engine['version']}"


def _relative(row: Row) -> str:
    """Wall time in units of ours."""
    value = row.get("relative_wall")
    return "–" if value is None else f"{value:.2g}" if value < 100 else f"{value:,.0f}"


# The tables


def short(document: dict[str, Any]) -> str:
    """One row per engine: the manual's settings, and the better ones at two steps."""
    lines = []
    for name, one in document["engines"].items():
        rows = [row for row in document["rows"] if row["engine"] == name and "scores" in row]
        manual = [row for row in rows if (row["setting"], row["dt"]) == ("default", COMMON_STEP)]
        right = [row["scores"]["sequence_right"] for row in manual if row["scenario"] in scored()]
        hops = {(row["setting"], row["dt"]): row["scores"]["hop_height"] for row in rows if row["scenario"] == HOP}
        found = [each for each in document["limits"] if (each["engine"], each["quantity"]) == (name, "hop_height")]
        lines.append(
            [
                _titled(one),
                f"{sum(right)}/{len(right)}" if right else "–",
                _millimetres(hops.get(("default", COMMON_STEP))),
                _best(hops, COMMON_STEP),
                _best(hops, 0.0001),
                _best_limit(found),
                next((_relative(row) for row in manual if row["scenario"] == HOP), "–"),
            ]
        )
    head = ["engine", "phases right", "manual's, 1 ms (mm)", "best, 1 ms (mm)", "best, 0.1 ms (mm)", "limit (mm), order"]
    return markdown([*head, "÷ hophoop"], lines)


def _millimetres(value: float | str | None) -> str:
    if not isinstance(value, float):
        return "–" if value is None else "no hop"
    text = f"{1e3 * value:+.2g}" if abs(value) < 0.1 else f"{1e3 * value:+.0f}"
    return "0" if abs(value) < 5e-7 else text.replace("-", "−")


def _best(hops: dict[tuple[str, float], Any], dt: float) -> str:
    """The smaller error at a step, and whose settings give it."""
    known = {setting: value for (setting, step), value in hops.items() if step == dt and isinstance(value, float)}
    if not known:
        return "–"
    setting = min(known, key=lambda each: abs(known[each]))
    return _millimetres(known[setting]) + (" (ours)" if setting == "tuned" else "")


def _best_limit(found: list[Row]) -> str:
    """The smaller error of both settings, and whether it is approached with an order."""
    if not found:
        return "–"
    best = min(found, key=lambda each: abs(each["error"]))
    return f"{_millimetres(best['error'])}, {'none' if best['order'] is None else format(best['order'], '.1f')}"


def full(document: dict[str, Any]) -> str:
    """All settings at the time steps that all motions have."""
    lines, before = [], ""
    for name, one in document["engines"].items():
        for setting in one["settings"]:
            rows = [row for row in document["rows"] if (row["engine"], row["setting"]) == (name, setting)]
            for dt in _common_steps(rows):
                title = _titled(one)
                start = [title if title != before else "", f"{setting}, {1e3 * dt:.3g}\u00a0ms"]
                lines.append(start + _full_cells(document, one, [row for row in rows if row["dt"] == dt]))
                before = title
    head = ["engine", "settings, step", "right", "take-off (°)", "hop (mm)", "θ (°)", "limit (mm)", "order", "÷ ours"]
    return markdown(head, lines) + f"\n*{document['benchmark']}, made {document['made']} with hophoop {document['hophoop']}.*\n"


def _common_steps(rows: list[Row]) -> list[float]:
    counts = {dt: sum(row["dt"] == dt for row in rows) for dt in {row["dt"] for row in rows}}
    return sorted((dt for dt, count in counts.items() if count == max(counts.values())), reverse=True)


def _full_cells(document: dict[str, Any], one: dict[str, Any], rows: list[Row]) -> list[str]:
    """Cells of an engine with one set of settings at one step."""
    counted = [row for row in rows if row["scenario"] in scored()]
    done = [row for row in counted if "scores" in row]
    if not done:
        return [next((row["failure"] for row in counted), "not run"), *[""] * 6]
    good = sum(row["scores"]["sequence_right"] for row in done)
    ran = f"{good}/{len(counted)}" if len(done) == len(counted) else f"{good}/{len(done)} run"
    hop = next((row for row in done if row["scenario"] == HOP), None)
    head = (rows[0]["engine"], rows[0]["setting"], "hop_height")
    limit = next((each for each in document["limits"] if (each["engine"], each["setting"], each["quantity"]) == head), None)
    shown, order = "–", "–"
    if limit is not None:
        shown = number(limit["error"], 1e3)
        order = "none" if limit["order"] is None else f"{limit['order']:.1f}"
        if limit["order"] is None and limit["scatter"] > 1e-4:
            shown += f" ± {float(format(1e3 * limit['scatter'], '.1g')):g}"
    if one["ours"] or rows[0]["engine"] == "scipy":
        order = "–"
    cells = ["–"] * 3 if hop is None else score_cells(hop["scores"])
    return [ran, *cells, shown, order, "–" if hop is None else _relative(hop)]


# The figures


def hops(document: dict[str, Any], records: dict[str, States]) -> Any:
    """Gap over time in the hop, one panel per engine, with the exact motion; records by `record_name`."""
    engines = document["engines"]
    shown = {name: _shown_hops(document["rows"], name) for name in engines}
    shown = {name: [row for row in rows if record_name(row) in records] for name, rows in shown.items()}
    shown = {name: rows for name, rows in shown.items() if rows}
    figure, axes = _panels(len(shown), (2.55, 1.95))
    for ax, (name, rows) in zip(axes, shown.items(), strict=True):
        draw_exact(ax, HOP, SPAN)
        for k, (row, color, dashes) in enumerate(zip(rows, (VERMILION, BLUE), ("-", (0, (4, 2))), strict=False)):
            states = records[record_name(row)]
            inside = np.flatnonzero((states.t >= SPAN[0]) & (states.t <= SPAN[1]))
            inside = inside[:: max(1, len(inside) // 400)]
            ax.plot(states.t[inside], 1e3 * states.y[inside], color=color, lw=1.6, ls=dashes)
            words = hop_words(row["scores"]["hop_height"])
            ax.text(0.03, 0.96 - 0.15 * k, words, transform=ax.transAxes, va="top", fontsize=8, color=color)
        ax.set_title(engines[name]["title"], fontsize=10, loc="left", pad=4)
        ax.set_xlim(*SPAN)
        ax.set_ylim(-20.0, 420.0)
    for ax in axes[::PANELS]:
        ax.set_ylabel("gap (mm)")
    _label_below(axes, "time (s)")
    figure.suptitle(
        f"The hop in each engine with steps of {1e3 * COMMON_STEP:g} ms. Gray: the exact motion. Red: the manual’s settings.\n"
        "Blue, dashed: our settings, where they come closer at this step.",
        fontsize=10.5, x=0.01, ha="left",
    )  # fmt: skip
    return figure


def draw_exact(ax: Any, name: str, span: tuple[float, float]) -> None:
    """Fill the gap [mm] of the exact motion over a span [s]."""
    from adapters.hophoop import run

    exact = run(truths()[name].task, 0.0)
    near = np.flatnonzero((exact.t >= span[0]) & (exact.t <= span[1]))[::5]
    ax.fill_between(exact.t[near], 0.0, 1e3 * exact.y[near], color=LIGHT_GRAY, linewidth=0)


def hop_words(error: Any) -> str:
    """Error of the hop's height [m] in words of a figure."""
    if error is None or error == "missing" or math.isnan(error):
        return "no hop"
    return f"{1e3 * error:+.1f} mm".replace("-", "−") if abs(error) >= 5e-5 else "exact"


def work_precision(document: dict[str, Any]) -> Any:
    """Error of the hop's height against wall time for all time steps, one panel per engine."""
    curves = {name: _scored_hops(document["rows"], name) for name in document["engines"]}
    curves = {name: rows for name, rows in curves.items() if rows}
    figure, axes = _panels(len(curves), (2.55, 2.1))
    for ax, (name, rows) in zip(axes, curves.items(), strict=True):
        for setting, color, mark in (("default", VERMILION, "o"), ("tuned", BLUE, "s")):
            points = [row for row in rows if row["setting"] == setting]
            if not points:
                continue
            work, errors = [row["scores"]["wall_seconds"] or math.nan for row in points], [_error(row) for row in points]
            ax.plot(work, errors, color=color, marker=mark, ms=3.2, lw=1.4)
            for k, row in enumerate(points):
                if row["dt"] == COMMON_STEP:
                    ax.plot(work[k], errors[k], color=color, marker=mark, ms=7.5, mfc="white", mew=1.4)
        ax.set_title(document["engines"][name]["title"], fontsize=10, loc="left", pad=4)
        ax.set_xscale("log")
        ax.set_yscale("log")
        ax.set_ylim(0.2 * FLOOR, 2000.0)
    for ax in axes[::PANELS]:
        ax.set_ylabel("error of hop (mm)")
    _label_below(axes, "wall time (s)")
    figure.suptitle(
        "Error of the hop’s height against work, for steps from 10 ms to 0.01 ms. Red: the manual’s settings.\n"
        "Blue: our settings. Large marks: 1 ms. At the top: no hop.",
        fontsize=10.5, x=0.01, ha="left",
    )  # fmt: skip
    return figure


def _error(row: Row) -> float:
    """Error of the hop's height [mm], all of it without a hop."""
    error = row["scores"]["hop_height"]
    return max(1e3 * abs(error), FLOOR) if isinstance(error, float) else 292.0


def _shown_hops(rows: Sequence[Row], engine: str) -> list[Row]:
    """The run with the manual's settings, and the one with ours if it comes closer at this step."""
    found = [row for row in _scored_hops(rows, engine) if row["dt"] == COMMON_STEP]
    found.sort(key=lambda row: row["setting"])
    return found[:1] + [row for row in found[1:] if _error(row) < _error(found[0])]


def _panels(count: int, size: tuple[float, float]) -> tuple[Any, list[Any]]:
    from matplotlib import pyplot

    rows = -(-count // PANELS)
    figure, axes = pyplot.subplots(
        rows, PANELS, figsize=(PANELS * size[0], rows * size[1]), sharex=True, sharey=True, layout="constrained", squeeze=False
    )
    flat = [ax for line in axes for ax in line]
    for ax in flat[count:]:
        ax.set_axis_off()
    for ax in flat[:count]:
        ax.grid(True, color="#000000", alpha=0.1, linewidth=0.6)
        for side in ("top", "right"):
            ax.spines[side].set_visible(False)
    return figure, flat[:count]


def _label_below(axes: list[Any], words: str) -> None:
    for k, ax in enumerate(axes):
        ax.tick_params(labelbottom=k + PANELS >= len(axes))
        if k >= PANELS * ((len(axes) - 1) // PANELS):  # a label in a higher row would push the rows apart
            ax.set_xlabel(words)


def drawing(figure: Any) -> str:
    """Return a figure as SVG: the same for the same numbers, its lines to a tenth of a point."""
    import matplotlib

    stream = io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": "hophoop"}):
        figure.savefig(stream, format="svg", metadata={"Date": None})
    lines = re.compile(r' d="[ML\d\s.z-]+"')  # letters of text and marks are curves, and keep their digits
    return lines.sub(lambda path: re.sub(r"-?\d+\.\d+", lambda number: f"{float(number[0]):.1f}", path[0]), stream.getvalue())


def main(arguments: Sequence[str] | None = None) -> None:
    """Write the page's data and figures."""
    parser = argparse.ArgumentParser(description="Make the data and the figures of docs/engines.md those of a run.")
    parser.add_argument("folder", type=Path, metavar="DIR", help="folder of run.py --out")
    folder = parser.parse_args(arguments).folder
    document = json.loads((folder / "scores.json").read_text(encoding="utf-8"))
    records = {path.name: read_record(path.read_text(encoding="utf-8"), path.name).states for path in folder.glob("*.csv")}
    for name, figure in (("hops", hops(document, records)), ("work-precision", work_precision(document))):
        (DOCS / "figures" / f"engines-{name}.svg").write_text(drawing(figure), encoding="utf-8")
    shutil.copyfile(folder / "scores.json", KEPT)


if __name__ == "__main__":
    main()
