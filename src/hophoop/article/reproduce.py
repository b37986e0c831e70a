"""Reproduce the article: figures, films, statements, report."""

from __future__ import annotations

import json
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from itertools import count
from pathlib import Path

from hophoop._support.extras import MissingExtra, need
from hophoop._support.files import replacing
from hophoop._version import __version__
from hophoop.article import report
from hophoop.article.figures import FIGURES, draw_figure
from hophoop.article.films import started_films
from hophoop.article.runs import Runs
from hophoop.article.statement import Statement
from hophoop.article.statements import STATED, statements

DPI = 160
# of figures for a page: reproducible files, letters as outlines
STYLE = {
    "svg.hashsalt": "hophoop",
    "svg.fonttype": "path",
    "font.size": 10.0,
    "font.family": "DejaVu Sans",
    "axes.labelsize": 10.0,
    "path.simplify_threshold": 0.2,
}

Progress = Callable[[str, int, int], None]


@dataclass(frozen=True)
class Reproduction:
    """Results of `reproduce`.

    Attributes
    ----------
    folder : Path
        Folder of the report; open ``index.html`` in it.
    statements : tuple of Statement
    films : tuple of Path
        Films, and the page that turns.
    without_films : str
        Reason for missing films, otherwise empty.
    """

    folder: Path
    statements: tuple[Statement, ...]
    films: tuple[Path, ...]
    without_films: str

    @property
    def failed(self) -> tuple[Statement, ...]:
        """Statements that are neither confirmed nor explained."""
        return tuple(one for one in self.statements if not one.holds)


def reproduce(out: str | Path = "article", progress: Progress | None = None, with_films: bool = True) -> Reproduction:
    """Compute the article's motions, draw its figures, check its statements and write a report.

    Parameters
    ----------
    out : str or Path, default 'article'
        Folder to write to, created if missing: ``index.html``, ``statements.json``, ``figures/`` and
        ``films/``.
    progress : callable, optional
        Called with the name of a stage ('statements', 'figures', 'films'), the number of steps done and of all.
    with_films : bool, default True
        Whether to make films, if the extra ``films`` is installed, and the one in 3D with ``films3d``. Other processes make
        them, so a script that calls this needs the usual ``if __name__ == "__main__":``.

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
    say = progress or (lambda stage, done, total: None)
    runs = Runs()
    made: list[Path] = []
    finish, reason = None, "they were not requested"
    with ExitStack() as open_ones:
        if with_films:
            try:
                # in parallel with figures and statements, which take as long
                finish, reason = open_ones.enter_context(started_films(folder / "films")), ""
            except MissingExtra as error:
                reason = str(error)
        for k, figure in enumerate(sorted(FIGURES, key=lambda figure: figure.long)):
            with need("matplotlib", "plots").rc_context(STYLE):
                sheet = draw_figure(figure, runs)
                for ending in ("png", "svg"):
                    with replacing(folder / "figures" / f"{figure.name}.{ending}") as path:
                        sheet.savefig(path, dpi=DPI, metadata={"Date": None} if ending == "svg" else None)
                    sheet.set_layout_engine("none")  # a second layout would take half of the time
            say("figures", k + 1, len(FIGURES))
        say("statements", 0, len(STATED))
        done = count(1)
        checked = statements(runs, lambda key: say("statements", next(done), len(STATED)))
        data = {"schema": "hophoop-article/1", "version": __version__, "statements": [one.to_dict() for one in checked]}
        with replacing(folder / "statements.json") as path:
            path.write_text(json.dumps(data, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
        if finish is not None:
            made = finish(lambda done, total: say("films", done, total))
    with replacing(folder / "index.html") as path:
        path.write_text(report.page(checked, folder, made, runs), encoding="utf-8")
    return Reproduction(folder, checked, tuple(made), reason)
