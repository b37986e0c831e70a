"""The whole article in one go: figures, films, statements, report."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import hophoop
from hophoop._extras import need
from hophoop._files import replacing
from hophoop.article import report
from hophoop.article.figures import FIGURES, drawn
from hophoop.article.runs import Runs
from hophoop.article.statement import FAILS, Statement
from hophoop.article.statements import count, statements

DPI = 160

Progress = Callable[[str, int, int], None]


@dataclass(frozen=True)
class Reproduction:
    """What `reproduce` made.

    Attributes
    ----------
    folder : Path
        Where it lies; open ``index.html`` in it.
    statements : tuple of Statement
    films : tuple of Path
    without_films : str
        Why there are none, else empty.
    """

    folder: Path
    statements: tuple[Statement, ...]
    films: tuple[Path, ...]
    without_films: str

    @property
    def failed(self) -> tuple[Statement, ...]:
        """Statements that are neither confirmed nor explained."""
        return tuple(one for one in self.statements if one.verdict == FAILS)


def reproduce(out: str | Path = "article", progress: Progress | None = None, with_films: bool = True) -> Reproduction:
    """Compute the article's motions, draw its figures, check its statements and write a report.

    Parameters
    ----------
    out : str or Path, default 'article'
        Folder to write to, made if it is not there: ``index.html``, ``statements.json``, ``figures/`` and
        ``films/``.
    progress : callable, optional
        Called with the name of a stage ('statements', 'figures', 'films'), how many steps are done and of
        how many.
    with_films : bool, default True
        Whether films are made, where the extra ``films`` is installed.

    Returns
    -------
    reproduction : Reproduction

    Raises
    ------
    OSError
        If a file cannot be written.
    ImportError
        If Matplotlib is missing.
    """
    folder = Path(out)
    need("matplotlib.figure", "plots")
    (folder / "figures").mkdir(parents=True, exist_ok=True)
    say = progress or _silent
    runs = Runs()
    checked = _checked(runs, say)
    _write_json(folder, checked)
    for k, figure in enumerate(FIGURES):
        with _style():
            sheet = drawn(figure, runs)
            for ending in ("png", "svg"):
                with replacing(folder / "figures" / f"{figure.name}.{ending}") as path:
                    sheet.savefig(path, dpi=DPI, metadata={"Date": None} if ending == "svg" else None)
        say("figures", k + 1, len(FIGURES))
    made: list[Path] = []
    reason = "they were not asked for"
    if with_films:
        try:
            made, reason = films(folder / "films", say), ""
        except ImportError as error:
            reason = str(error)
    with replacing(folder / "index.html") as path:
        path.write_text(report.page(checked, folder, made), encoding="utf-8")
    return Reproduction(folder, checked, tuple(made), reason)


def films(out: Path, progress: Progress) -> list[Path]:
    """The article's films, into a folder of their own.

    Parameters
    ----------
    out : Path
    progress : callable
        As `reproduce` takes it.

    Returns
    -------
    paths : list of Path

    Raises
    ------
    ImportError
        If what films need is not installed.
    """
    need("imageio_ffmpeg", "films")
    if find_spec("hophoop.animate") is None:
        raise ImportError("this version makes no films.")
    from hophoop.animate import article_films

    fresh = out.with_name(f".{out.name}-new")
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir(parents=True)
    try:
        made = article_films(fresh, lambda done, total: progress("films", done, total))
        out.mkdir(exist_ok=True)
        return [path.replace(out / path.name) for path in made]
    finally:
        shutil.rmtree(fresh, ignore_errors=True)


def _checked(runs: Runs, progress: Progress) -> tuple[Statement, ...]:
    total = count()
    done = 0

    def step(_: str) -> None:
        nonlocal done
        done += 1
        progress("statements", done, total)

    progress("statements", 0, total)
    return statements(runs, step)


def _write_json(folder: Path, checked: tuple[Statement, ...]) -> None:
    data: dict[str, Any] = {
        "schema": "hophoop-article/1",
        "version": hophoop.__version__,
        "statements": [one.to_dict() for one in checked],
    }
    with replacing(folder / "statements.json") as path:
        path.write_text(json.dumps(data, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")


@contextmanager
def _style() -> Iterator[None]:
    """Figures for a page: the same bits each time, letters as outlines so that they look alike everywhere."""
    look = {
        "svg.hashsalt": "hophoop",
        "svg.fonttype": "path",
        "font.size": 10.0,
        "font.family": "DejaVu Sans",
        "axes.labelsize": 10.0,
        "path.simplify_threshold": 0.2,
    }
    with need("matplotlib", "plots").rc_context(look):
        yield


def _silent(stage: str, done: int, total: int) -> None:
    pass
