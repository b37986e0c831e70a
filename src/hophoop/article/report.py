"""The report: one page that holds everything but the films, which lie beside it."""

from __future__ import annotations

import base64
import math
from collections.abc import Sequence
from datetime import date
from html import escape
from importlib.resources import files
from pathlib import Path

import hophoop
from hophoop.article.figures import FIGURES, ArticleFigure
from hophoop.article.scenarios import scenarios
from hophoop.article.statement import VERDICTS, Statement
from hophoop.plots.curves import phases
from hophoop.simulation import simulate
from hophoop.trajectory import Trajectory
from hophoop.vocabulary import colors
from hophoop.vocabulary.words import FLIGHT, ROLL, SKID, SPIN

# wide tables scroll by themselves, by the keyboard too
SCROLL = "<div class='scroll' tabindex='0' role='group' aria-label='table'>"

SECTIONS = {
    "The Problem": "A thin ring of radius 1 m carries three quarters of its mass, 1 kg in all, in one point. "
    "It starts with the load at the top and rolls along a level plane with friction μ = 1. Does it hop?",
    "A First Attempt": "Rolled off at 0.1 m/s it turns over once, and everything follows from the "
    "conservation of energy. The formulas are not put in by hand: they come out of the computed motion.",
    "Increase the Speed": "At 2 m/s it still rolls, by a small margin. At 2.8 m/s it slips twice a turn.",
    "Let's Hop!": "At 3.1 m/s the spinning hoop leaves the plane late in its first turn.",
    "Revisiting Low Friction": "On μ = 0.3 even the slow hoop slips, and cannot get over the top again.",
}

FILMS = {
    "A First Attempt": ("v0.1",),
    "Increase the Speed": ("v2", "v2.8"),
    "Let's Hop!": ("v3.1", "v3.1-3d"),
    "Revisiting Low Friction": ("v0.1-mu0.3",),
}
STARTS = ("slip_start", "takeoff")  # events of the table of motions
FILM_CAPTIONS = {
    "v0.1": "v₀ = 0.1 m/s.",
    "v2": "v₀ = 2 m/s.",
    "v2.8": "v₀ = 2.8 m/s.",
    "v3.1": "v₀ = 3.1 m/s, slower around take-off and landing.",
    "v3.1-3d": "v₀ = 3.1 m/s in three dimensions.",
    "v0.1-mu0.3": "v₀ = 0.1 m/s on μ = 0.3.",
}

SOURCE = "Henrik Sönnerlind, <cite>The Physics of a Hopping Hoop</cite> (2023); figures and words are our own."
CLASSES = dict(zip(VERDICTS, ("agrees", "reading", "differs", "fails"), strict=True))


def page(statements: Sequence[Statement], folder: Path, films: Sequence[Path]) -> str:
    """The whole page, with the figures in `folder` inside and links to the films.

    Parameters
    ----------
    statements : sequence of Statement
    folder : Path
        Holds ``figures/NAME.svg``.
    films : sequence of Path
        Films that are there.

    Returns
    -------
    html : str
    """
    style = files("hophoop.article").joinpath("report.css").read_text(encoding="utf-8")
    number = {figure.name: k + 1 for k, figure in enumerate(FIGURES)}
    body = [_head(statements), _legend(), _runs(), _table(statements)]
    there = {path.stem: path for path in films}
    for section, text in SECTIONS.items():
        body.append(f"<section id='{_anchor(section)}'><h2>{escape(section)}</h2><p>{escape(text)}</p>")
        body += [_figure(figure, number[figure.name], folder) for figure in FIGURES if figure.section == section]
        shown = [name for name in FILMS.get(section, ()) if name in there]
        if shown:
            players = "".join(_film(name, there[name], folder) for name in shown)
            body.append(f"<div class='films'>{players}</div>")
        body.append("</section>")
    body.append(
        f"<footer><p>After {SOURCE} Made by hophoop {escape(hophoop.__version__)} on "
        f"{date.today().isoformat()} with <code>hophoop reproduce</code>. The numbers behind the table, "
        "in full "
        "precision, are in <a href='statements.json'>statements.json</a>; the figures in "
        "<code>figures/</code>.</p>"
        "</footer>"
    )
    return (
        "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'>"
        "<meta name='viewport' content='width=device-width, initial-scale=1'>"
        f"<title>The hopping hoop, computed</title><style>{style}</style></head><body><main>"
        + "\n".join(body)
        + "</main></body></html>\n"
    )


def _anchor(section: str) -> str:
    return "".join(letter for letter in section.lower().replace(" ", "-") if letter.isalnum() or letter == "-")


def _head(statements: Sequence[Statement]) -> str:
    counts = {verdict: sum(one.verdict == verdict for one in statements) for verdict in VERDICTS}
    badges = " ".join(
        f"<span class='badge {CLASSES[verdict]}'>{count} {'agree' if verdict == 'agrees' else escape(_plural(verdict))}</span>"
        for verdict, count in counts.items()
        if count
    )
    sections = " · ".join(f"<a href='#{_anchor(name)}'>{escape(name)}</a>" for name in SECTIONS)
    return (
        "<header><h1>The hopping hoop, computed</h1>"
        "<p class='lead'>A well-known article simulates a loaded hoop that rolls, slips and hops, with a "
        "penalty "
        "contact in finite elements. Here its five motions are computed again, each phase in closed form "
        "or by quadrature and each change of phase to rounding; its figures are drawn anew and its "
        f"{len(statements)} checkable statements laid beside ours.</p>"
        f"<p class='badges'>{badges}</p><nav><a href='#statements'>Statements</a> · {sections}</nav></header>"
    )


def _plural(verdict: str) -> str:
    return {
        "agrees within reading accuracy": "within reading accuracy",
        "differs": "differ",
        "fails": "fail",
    }[verdict]


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


def _runs() -> str:
    rows = []
    for scenario in scenarios().values():
        motion = simulate(scenario)
        ledger = motion.ledger
        cells = [_degrees(found[0].angle) if (found := motion.find(kind)) else "–" for kind in STARTS]
        cells += [f"{ledger.friction + ledger.impact_tangential:.4f}", f"{ledger.impact_normal:.4f}"]
        cells.append(f"{abs(ledger.residual):.0e}")
        numbers = "".join(f"<td>{cell}</td>" for cell in cells)
        rows.append(
            f"<tr><td>{scenario.start.speed:g}</td><td>{scenario.plane.mu:g}</td>"
            f"<td class='l'>{_ribbon(motion)}</td>{numbers}</tr>"
        )
    return (
        f"<h2 id='motions'>The five motions</h2>{SCROLL}<table class='runs'><thead><tr>"
        "<th>v₀ (m/s)</th><th>μ</th><th class='l'>phases</th><th>slips at</th><th>takes off at</th>"
        "<th>lost to friction (J)</th><th>in impacts, normal part (J)</th><th>unaccounted for (J)</th></tr></thead><tbody>"
        + "".join(rows)
        + "</tbody></table></div>"
    )


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.3f}°"


def _ribbon(motion: Trajectory, most: int = 16) -> str:
    pieces = phases(motion)
    marks = "".join(
        f"<i style='background:{colors.MODES[piece.word]}' title='{piece.word}'>{piece.mode}</i>" for piece in pieces[:most]
    )
    return f"<span class='ribbon'>{marks}{'…' if len(pieces) > most else ''}</span>"


def _table(statements: Sequence[Statement]) -> str:
    rows = []
    section = ""
    for one in statements:
        if one.section != section:
            section = one.section
            rows.append(f"<tr class='part'><th colspan='4'>{escape(section)}</th></tr>")
        why = f"<p class='why'>{escape(one.why)}</p>" if one.why else ""
        rows.append(
            f"<tr id='{escape(one.key)}'><td>{escape(one.statement)}</td><td>{escape(one.article)}</td>"
            f"<td>{escape(one.ours)}{why}</td>"
            f"<td><span class='badge {CLASSES[one.verdict]}'>{escape(one.verdict)}</span></td></tr>"
        )
    return (
        f"<h2 id='statements'>What the article says, and what we find</h2>{SCROLL}"
        "<table "
        "class='statements'><thead><tr><th>Statement</th><th>Article</th><th>Ours</th><th>Verdict</th></tr>"
        "</thead><tbody>" + "".join(rows) + "</tbody></table></div>"
        "<p class='note'>‘Differs’ means that the article is not confirmed and that the reason given has "
        "itself been "
        "checked on the computed motion. A statement that is neither confirmed nor explained would be marked "
        "‘fails’, and the program would say so with its exit status.</p>"
    )


def _figure(figure: ArticleFigure, number: int, folder: Path) -> str:
    code = base64.b64encode((folder / "figures" / f"{figure.name}.svg").read_bytes()).decode("ascii")
    new = " <em>Not in the article.</em>" if figure.ours else ""
    wide = " class='wide'" if figure.size[0] > 8.0 else ""
    return (
        f"<figure{wide} id='figure-{figure.name}'><img loading='lazy' "
        f"alt='{escape(figure.caption, quote=True)}' "
        f"src='data:image/svg+xml;base64,{code}'><figcaption><b>Figure {number}.</b> "
        f"{escape(figure.caption)}{new}"
        "</figcaption></figure>"
    )


def _film(name: str, path: Path, folder: Path) -> str:
    place = escape(path.relative_to(folder).as_posix(), quote=True)
    return (
        "<figure class='wide'><video controls loop muted playsinline preload='metadata' "
        f"src='{place}'></video>"
        f"<figcaption><b>Film.</b> {escape(FILM_CAPTIONS[name])}</figcaption></figure>"
    )
