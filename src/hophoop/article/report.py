"""The report: a story on one page that holds everything but the films, which lie beside it."""

from __future__ import annotations

import base64
import math
import re
from collections.abc import Mapping, Sequence
from datetime import date
from html import escape
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path
from string import Template

from hophoop._version import __version__
from hophoop.article.facts import facts
from hophoop.article.figures import FIGURES, ArticleFigure
from hophoop.article.formulas import FORMULAS
from hophoop.article.inks import for_both
from hophoop.article.runs import Runs
from hophoop.article.scenarios import scenarios
from hophoop.article.statement import Statement
from hophoop.article.typeset import typeset
from hophoop.article.verdicts import AGREES, DIFFERS, FAILS, WITHIN_READING
from hophoop.plots.curves import phases
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import colors
from hophoop.vocabulary.modes import FLIGHT, ROLL, SKID, SPIN

ARTICLE_URL = "https://www.comsol.com/blogs/the-physics-of-a-hopping-hoop"
STARTS = ("slip_start", "takeoff")  # events of the table of motions
# in the text: the name of the file, and what is to be seen
FILMS = {
    "hop": ("v3.1", "The hop, at 3.1 m/s. It runs slower around take-off and landing, where a ring spreads."),
    "slow": ("v0.1", "A nudge of 0.1 m/s. The arrows are the forces of the floor; their scale follows them and stands above."),
    "faster": ("v2", "At 2 m/s it rolls as before, only faster and more evenly."),
    "slipping": ("v2.8", "At 2.8 m/s it slips twice a turn. Watch the word at the upper left."),
    "low": ("v0.1-mu0.3", "0.1 m/s on μ = 0.3: it slips, turns back, and rocks."),
    "hop3d": ("v3.1-3d", "The hop once more, in three dimensions."),
}
# figures beside those in the text, by the step that they belong to
MORE = {
    "rolling": ("path_slow", "velocity_time_slow", "energy_slow"),
    "slipping": ("forces_slow", "friction_slow", "path_faster", "path_slipping", "friction_slipping", "energy_slipping"),
    "landing": ("landing_restitution",),
    "low": ("path_low_friction", "velocity_low_friction", "energy_low_friction"),
}
FILM_SIZE = (960, 540)
CLASSES = {AGREES: "agrees", WITHIN_READING: "reading", DIFFERS: "differs", FAILS: "fails"}
DARK_TEXT = 0.45  # lightness of a colour from which on letters on it are black


def page(statements: Sequence[Statement], folder: Path, films: Sequence[Path], runs: Runs | None = None) -> str:
    """The whole page, with the figures in `folder` inside and links to the films.

    Parameters
    ----------
    statements : sequence of Statement
    folder : Path
        Holds ``figures/NAME.svg``.
    films : sequence of Path
        Films that are there; a picture of the same name beside one is its poster.
    runs : Runs, optional
        The motions, where they have been computed already.

    Returns
    -------
    html : str

    Raises
    ------
    ImportError
        If math-core is missing.
    """
    runs = runs or Runs()
    here = files("hophoop.article")
    story = here.joinpath("story.html").read_text(encoding="utf-8")
    style = _math_font(here) + here.joinpath("report.css").read_text(encoding="utf-8")
    numbered = {name: k + 1 for k, name in enumerate(figures_of(story))}
    drawn = {figure.name: figure for figure in FIGURES if figure.name in numbered}
    shown = {name: _figure(figure, numbered[name], folder) for name, figure in drawn.items()}
    there = {path.stem: path for path in films}
    values = {
        "article_url": ARTICLE_URL,
        "count_statements": str(len(statements)),
        "badges": _badges(statements),
        "legend": _legend(),
        "runs": _runs(runs),
        "table": _table(statements),
        **{f"formula_{name}": latex for name, latex in FORMULAS.items()},
        **{f"figure_{name}": shown.get(name, "") for name in numbered},
        **{f"more_{step}": _more([shown[name] for name in names if name in shown]) for step, names in MORE.items()},
        **{f"film_{name}": _film(*film, there, folder) for name, film in FILMS.items()},
        **_links(statements, story),
        **facts(statements, runs),
    }
    body = typeset(Template(story).substitute(values))
    return (
        "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'>"
        "<meta name='viewport' content='width=device-width, initial-scale=1'><meta name='color-scheme' content='light dark'>"
        f"<title>The hopping hoop, computed</title><style>{style}</style></head><body><main>\n"
        f"{body}\n{_footer()}\n</main></body></html>\n"
    )


def _math_font(here: Traversable) -> str:
    """The font of the formulas, in the page itself: not every reader has one for mathematics."""
    code = base64.b64encode(here.joinpath("fonts", "hoop-math.woff2").read_bytes()).decode("ascii")
    return f'@font-face {{ font-family: "Hoop Math"; src: url(data:font/woff2;base64,{code}) format("woff2"); }}\n'


def figures_of(story: str) -> list[str]:
    """Names of the figures in the order in which a reader meets them."""
    names: list[str] = []
    for kind, name in re.findall(r"\$(figure|more)_(\w+)", story):
        names += [name] if kind == "figure" else MORE[name]
    return names


def _badges(statements: Sequence[Statement]) -> str:
    counts = {verdict: sum(one.verdict == verdict for one in statements) for verdict in CLASSES}
    words = {AGREES: "agree", WITHIN_READING: "within reading accuracy", DIFFERS: "differ", FAILS: "fail"}
    return " ".join(
        f"<span class='badge {CLASSES[verdict]}'>{count} {words[verdict]}</span>" for verdict, count in counts.items() if count
    )


def _links(statements: Sequence[Statement], story: str) -> Mapping[str, str]:
    """From the text to the statements: their numbers in the colours of their verdicts."""
    numbers = {one.key: (k + 1, one.verdict) for k, one in enumerate(statements)}
    links = {}
    for key in re.findall(r"\$see_(\w+)", story):
        number, verdict = numbers.get(key, (0, ""))
        links[f"see_{key}"] = (
            f"<a class='see {CLASSES[verdict]}' href='#{key}' aria-label='Statement {number} {verdict}' "
            f"title='Statement {number} {verdict}'>{number}</a>"
            if number
            else ""
        )
    return links


def _legend() -> str:
    chips = "".join(
        f"<li><i style='background:{colors.MODES[word]}'></i><b>{escape(word)}</b> {escape(meaning)}</li>"
        for word, meaning in (
            (ROLL, "the contact point is at rest"),
            (SPIN, "slips, the rim turning too fast for the way it goes"),
            (SKID, "slides ahead"),
            (FLIGHT, "in the air"),
        )
    )
    return f"<ul class='legend' aria-label='Colours of the modes'>{chips}</ul>"


def _runs(runs: Runs) -> str:
    rows = []
    for name, scenario in scenarios().items():
        motion = runs.motion(name)
        ledger = motion.ledger
        cells = [_degrees(found[0].angle) if (found := motion.find(kind)) else "–" for kind in STARTS]
        cells += [f"{ledger.friction + ledger.impact_tangential:.4f}", f"{ledger.impact_normal:.4f}"]
        cells.append(f"{abs(ledger.residual):.0e}" if ledger.residual else "0")
        numbers = "".join(f"<td>{cell}</td>" for cell in cells)
        rows.append(
            f"<tr><td>{scenario.start.speed:g}</td><td>{scenario.plane.mu:g}</td>"
            f"<td class='l'>{_ribbon(motion)}</td>{numbers}</tr>"
        )
    return (
        "<div class='scroll' tabindex='0' role='region' aria-label='The five motions'><table class='runs'><thead><tr>"
        "<th>v₀ (m/s)</th><th>μ</th><th class='l'>phases</th><th>slips at</th><th>takes off at</th>"
        "<th>lost to<br>friction (J)</th><th>in impacts,<br>normal part (J)</th><th>unaccounted<br>for (J)</th></tr>"
        "</thead><tbody>" + "".join(rows) + "</tbody></table></div>"
    )


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.3f}°"


def _ribbon(motion: Trajectory, most: int = 12) -> str:
    pieces = phases(motion)
    marks = "".join(
        f"<i style='background:{colors.MODES[piece.word]}' title='{piece.word}'{_onto(piece.word)}>{piece.mode}</i>"
        for piece in pieces[:most]
    )
    return f"<span class='ribbon'>{marks}{'…' if len(pieces) > most else ''}</span>"


def _onto(word: str) -> str:
    return " class='onto-dark'" if colors.lightness(colors.MODES[word]) < DARK_TEXT else ""


def _table(statements: Sequence[Statement]) -> str:
    rows = []
    section = ""
    for number, one in enumerate(statements, 1):
        if one.section != section:
            section = one.section
            rows.append(f"<tr class='part'><th colspan='5'>{escape(section)}</th></tr>")
        why = f"<p class='why'>{escape(one.why)}</p>" if one.why else ""
        rows.append(
            f"<tr id='{escape(one.key)}'><td>{number}</td><td>{escape(one.statement)}</td>"
            f"<td data-of='Article'>{escape(one.article)}</td><td data-of='Ours'>{escape(one.ours)}{why}</td>"
            f"<td><span class='badge {CLASSES[one.verdict]}'>{escape(one.verdict)}</span></td></tr>"
        )
    return (
        "<table class='statements'><thead><tr><th>No.</th><th>Statement</th><th>Article</th><th>Ours</th><th>Verdict</th></tr>"
        "</thead><tbody>" + "".join(rows) + "</tbody></table>"
    )


def _figure(figure: ArticleFigure, number: int, folder: Path) -> str:
    drawing = for_both((folder / "figures" / f"{figure.name}.svg").read_text(encoding="utf-8"))
    code = base64.b64encode(drawing.encode("utf-8")).decode("ascii")
    origin = "Not in the article." if figure.ours else f"In the article's part ‘{figure.section}’."
    wide = " class='wide'" if figure.size[0] > 8.0 else ""
    width, height = (round(96.0 * side) for side in figure.size)
    return (
        f"<figure{wide} id='figure-{figure.name}'><div class='pic'><a href='figures/{figure.name}.svg'>"
        f"<img loading='lazy' width='{width}' height='{height}' "
        f"alt='{escape(figure.caption.split(':')[0], quote=True)}' src='data:image/svg+xml;base64,{code}'></a></div>"
        f"<figcaption><b>Figure {number}.</b> {escape(figure.caption)} {escape(origin)}</figcaption></figure>"
    )


def _more(figures: Sequence[str]) -> str:
    if not figures:
        return ""
    words = "One more figure" if len(figures) == 1 else f"{len(figures)} more figures"
    return f"<details><summary>{words}</summary>{''.join(figures)}</details>"


def _film(name: str, caption: str, there: Mapping[str, Path], folder: Path) -> str:
    if name not in there:
        return ""
    path = there[name]
    place = escape(path.relative_to(folder).as_posix(), quote=True)
    still = path.with_suffix(".png")
    poster = f" poster='{escape(still.relative_to(folder).as_posix(), quote=True)}'" if still.exists() else ""
    said = escape(caption, quote=True)
    return (
        f"<figure class='wide' id='film-{escape(name)}'><video controls loop muted playsinline "
        f"preload='{'none' if poster else 'metadata'}' width='{FILM_SIZE[0]}' height='{FILM_SIZE[1]}'{poster} "
        f"aria-label='{said}' src='{place}'></video><figcaption><b>Film.</b> {said}</figcaption></figure>"
    )


def _footer() -> str:
    return (
        f"<footer><p>After Henrik Sönnerlind, <a href='{ARTICLE_URL}'><cite>The Physics of a Hopping Hoop</cite></a> (2023); "
        f"figures and words are our own. Made by hophoop {escape(__version__)} on {date.today().isoformat()} with "
        "<code>hophoop reproduce</code>. The numbers behind the table, in full precision, are in "
        "<a href='statements.json'>statements.json</a>; the figures in <code>figures/</code>.</p></footer>"
    )
