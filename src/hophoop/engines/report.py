"""What a comparison leaves in a folder: index.html, the film, pictures, the table and all scores."""

from __future__ import annotations

import base64
import io
import json
from collections.abc import Callable
from html import escape
from importlib.resources import files
from pathlib import Path
from typing import Any, cast

from hophoop._support.extras import need
from hophoop._support.files import replacing
from hophoop._version import __version__
from hophoop.engines import figures
from hophoop.engines.comparing import COMMON_STEP, LADDER_SCENARIO, Comparison
from hophoop.engines.recorded import Recorded
from hophoop.engines.scenarios import BENCHMARK, bench_scenarios
from hophoop.engines.tables import cells, compact, heads, markdown, scenario_rows, settings_words, summary
from hophoop.engines.task import task_of
from hophoop.simulation.simulate import simulate

STYLE = """
main { max-width: 1500px; }
table.scores { font-size: 0.8rem; width: auto; }
table.scores td, table.scores th { white-space: nowrap; padding-right: 1rem; font-variant-numeric: tabular-nums; }
table.scores td:nth-child(n+4), table.scores th:nth-child(n+4) { text-align: right; }
table.scores tr.first td { border-top: 2px solid var(--line); }
table.scores td.why { text-align: left !important; white-space: normal; color: var(--soft); }
details summary { cursor: pointer; font-weight: 600; margin: 0.8rem 0; }
dl { font-size: 0.9rem; } dt { font-weight: 600; margin-top: 0.8rem; } dd { margin: 0.1rem 0 0; max-width: 60rem; }
figure.wide { margin: 1.2rem 0; }
"""


def write(comparison: Comparison, folder: Path, film: bool = True, progress: Callable[[int, int], None] | None = None) -> Path:
    """Write the report of a comparison.

    Parameters
    ----------
    comparison : Comparison
    folder : Path
        Made if it is not there.
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
            figure.savefig(folder / f"{name}.svg")
            figure.savefig(folder / f"{name}.png", dpi=110)
            stream = io.BytesIO()
            figure.savefig(stream, format="svg")
            pictures[name] = base64.b64encode(stream.getvalue()).decode("ascii")
            plot.close(figure)
    shown = _film(comparison, folder, progress) if film else None
    page = folder / "index.html"
    _write(page, _page(comparison, pictures, shown))
    return page


def _json(document: dict[str, Any]) -> str:
    """JSON with a line for each row, so that two comparisons can be laid beside each other."""
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
            motions.append(Recorded(bench.scenario, task, row.states))
            labels.append(one.title)
    if len(motions) == 1:
        return None
    look = Look(size=(1920, 1080), labels=labels, forces=False)
    return make(cast("Any", motions), folder / "hops.mp4", Timing(fps=30.0, speed=0.25), look, progress)


def _page(comparison: Comparison, pictures: dict[str, str], film: Path | None) -> str:
    css = files("hophoop.article").joinpath("report.css").read_text(encoding="utf-8") + STYLE
    parts = [
        "<!doctype html><html lang='en'><head><meta charset='utf-8'>",
        "<meta name='viewport' content='width=device-width, initial-scale=1'><title>Engines and the hopping hoop</title>",
        f"<style>{css}</style></head><body><main><h1>Engines and the hopping hoop</h1>",
        "<p class='lead'>A hoop with a weight on its rim rolls, skids, spins, takes off and lands. Its motion is known to "
        "29 digits; here is what physics engines make of it.</p>",
    ]
    if film is not None:
        parts.append(
            f"<figure class='wide'><video controls loop muted playsinline autoplay src='{escape(film.name, quote=True)}'>"
            "</video><figcaption><b>The hop</b> at a quarter of its speed: the exact motion first, then each engine with its "
            "manual’s settings and a time step of 1 ms.</figcaption></figure>"
        )
    captions = {
        "hops": "The gap under the rim. An engine is right where its line follows the edge of the gray.",
        "work-precision": "The lower left is best: small error for little work.",
    }
    for name, code in pictures.items():
        parts.append(
            f"<figure class='wide'><img alt='{escape(captions[name], quote=True)}' src='data:image/svg+xml;base64,{code}'>"
            f"<figcaption>{escape(captions[name])}</figcaption></figure>"
        )
    parts.append("<section><h2>In short</h2>" + _table(*summary(comparison)))
    parts.append(
        "<p class='note'>Errors are engine minus truth. The limit is what the height of the hop goes to as the time step goes "
        "to 0, fitted; the order is that of the approach, ‘none’ where there is none. The rows named (ours) are by the authors "
        "of this benchmark.</p></section>"
    )
    for name, bench in bench_scenarios().items():
        rows = scenario_rows(comparison, name)
        if rows:
            note = "" if bench.scored else " <em>Shown, not scored.</em>"
            parts.append(
                f"<section><h2>{escape(bench.title)}</h2><p>{escape(bench.why)}{note}</p>"
                + _table(heads(), [cells(comparison, row) for row in rows])
                + "</section>"
            )
    parts.append("<section><h2>Engines and settings</h2><dl>")
    for one in comparison.engines.values():
        version = f" {one.version}" if one.version else ", not installed"
        parts.append(
            f"<dt>{escape(one.title)}{escape(version)}</dt><dd>{escape(one.model)}. {escape(one.contact)} "
            f"Manual’s step {1e3 * one.step:.4g} ms. {escape(settings_words(one))}.</dd>"
        )
    machine = comparison.to_dict()["machine"]
    parts.append(
        f"</dl></section><footer>{BENCHMARK}, made {comparison.made} with hophoop {__version__}, Python "
        f"{machine['python']}, {machine['system']} {machine['processor']}, {machine['cores']} cores. All numbers: "
        "<a href='scores.json'>scores.json</a>.</footer></main></body></html>"
    )
    return "".join(parts)


def _table(head: list[str], rows: list[list[str]]) -> str:
    lines, before = [], ""
    for row in rows:
        first = " class='first'" if row[0] != before else ""
        name = row[0] if row[0] != before else ""
        before = row[0]
        if all(cell == "" for cell in row[-2:]):  # a failure, in the place of all numbers
            place = next(k for k in range(len(row) - 1, -1, -1) if row[k])
            cell = f"<td class='why' colspan='{len(row) - place}'>{escape(row[place])}</td>"
            body = "".join(f"<td>{escape(text)}</td>" for text in [name, *row[1:place]]) + cell
        else:
            body = "".join(f"<td>{escape(text)}</td>" for text in [name, *row[1:]])
        lines.append(f"<tr{first}>{body}</tr>")
    top = "".join(f"<th>{escape(text)}</th>" for text in head)
    return (
        f"<div class='scroll'><table class='scores'><thead><tr>{top}</tr></thead><tbody>{''.join(lines)}</tbody></table></div>"
    )
