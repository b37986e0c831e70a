"""The report of a comparison: index.html, the film, figures, the table and all scores."""

from __future__ import annotations

import base64
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple, cast

from hophoop._support.extras import need
from hophoop._support.files import replacing
from hophoop._support.pages import render
from hophoop._version import __version__
from hophoop.engines import figures
from hophoop.engines.comparing import COMMON_STEP, LADDER_SCENARIO, Comparison
from hophoop.engines.recorded import RecordedMotion
from hophoop.engines.scenarios import BENCHMARK, bench_scenarios
from hophoop.engines.tables import cells, compact, heads, markdown, scenario_rows, settings_words, summary
from hophoop.engines.task import task_of
from hophoop.simulation.simulate import simulate

CAPTIONS = {
    "hops": "The gap under the rim. An engine is right where its line follows the edge of the gray.",
    "work-precision": "The lower left is best: small error for little work.",
}


def write(comparison: Comparison, folder: Path, film: bool = True, progress: Callable[[int, int], None] | None = None) -> Path:
    """Write the report of a comparison.

    Parameters
    ----------
    comparison : Comparison
    folder : Path
        Created if missing.
    film : bool, default True
        Whether to make the film of the hoops side by side.
    progress : callable, optional
        Called with the number of the film's pictures done and of all.

    Returns
    -------
    page : Path
        index.html.

    Raises
    ------
    ImportError
        If Matplotlib is missing, or for the film the extra 'films'.
    """
    folder.mkdir(parents=True, exist_ok=True)
    _write(folder / "scores.json", _json(comparison.to_dict()))
    made = f"\n*{BENCHMARK}, made {comparison.made} with hophoop {__version__}.*\n"
    _write(folder / "summary.md", markdown(*compact(*summary(comparison))) + made)
    pictures = {}
    plot = need("matplotlib.pyplot", "plots")
    if any(row.scenario == LADDER_SCENARIO and row.states is not None for row in comparison.rows):
        for name, figure in (("hops", figures.hops(comparison)), ("work-precision", figures.work_precision(comparison))):
            drawn = figures.drawing(figure)
            _write(folder / f"{name}.svg", drawn)
            figure.savefig(folder / f"{name}.png", dpi=110)
            pictures[name] = base64.b64encode(drawn.encode()).decode("ascii")
            plot.close(figure)
    shown = _film(comparison, folder, progress) if film else None
    page = folder / "index.html"
    _write(page, _page(comparison, pictures, shown))
    return page


def _json(document: dict[str, Any]) -> str:
    """Format JSON with one line per row, so that two comparisons can be compared by lines."""
    parts = []
    for key, value in document.items():
        if isinstance(value, list):
            lines = ",\n".join("  " + json.dumps(item, ensure_ascii=False, allow_nan=False) for item in value)
            parts.append(f" {json.dumps(key)}: [\n{lines}\n ]")
        else:
            parts.append(f" {json.dumps(key)}: {json.dumps(value, ensure_ascii=False, allow_nan=False)}")
    return "{\n" + ",\n".join(parts) + "\n}\n"


def _write(path: Path, text: str) -> None:
    with replacing(path) as fresh:
        fresh.write_text(text, encoding="utf-8")


def _film(comparison: Comparison, folder: Path, progress: Callable[[int, int], None] | None) -> Path | None:
    """The hop of every engine with its manual's settings at 1 ms, and the exact one first."""
    from hophoop.animate import Look, Timing
    from hophoop.animate import film as make

    bench = bench_scenarios()[LADDER_SCENARIO]
    task = task_of(bench)
    motions: list[Any] = [simulate(bench.scenario)]
    labels = ["exact"]
    for name, one in comparison.engines.items():
        row = comparison.row(name, next(iter(one.settings)), LADDER_SCENARIO, COMMON_STEP)
        if one.name != "hophoop" and row is not None and row.states is not None:
            motions.append(RecordedMotion(bench.scenario, task, row.states))
            labels.append(one.title)
    if len(motions) == 1:
        return None
    look = Look(size=(1920, 1080), labels=labels, forces=False)
    return make(cast("Any", motions), folder / "hops.mp4", Timing(fps=30.0, speed=0.25), look, progress)


def _page(comparison: Comparison, pictures: dict[str, str], film: Path | None) -> str:
    scenarios = []
    for name, bench in bench_scenarios().items():
        rows = scenario_rows(comparison, name)
        if rows:
            scenarios.append((bench, _rows([cells(comparison, row) for row in rows])))
    titles, short = summary(comparison)
    return render(
        need("jinja2", "engines"),
        "engines/comparison.html",
        version=__version__,
        benchmark=BENCHMARK,
        made=comparison.made,
        machine=comparison.to_dict()["machine"],
        film=None if film is None else film.name,
        pictures=[(code, CAPTIONS[name]) for name, code in pictures.items()],
        summary=(titles, _rows(short)),
        heads=heads(),
        scenarios=scenarios,
        engines=[(one, settings_words(one)) for one in comparison.engines.values()],
    )


class _Row(NamedTuple):
    """One row of a table on the page; a failure takes the place of all numbers."""

    cells: list[str]
    first: bool  # of an engine
    failure: str = ""


def _rows(table: list[list[str]]) -> list[_Row]:
    rows, before = [], ""
    for engine, *others in table:
        first, before = engine != before, engine
        words = [engine if first else "", *others]
        if any(words[-2:]):
            rows.append(_Row(words, first))
        else:
            last = max(k for k, word in enumerate(words) if word)
            rows.append(_Row(words[:last], first, words[last]))
    return rows
