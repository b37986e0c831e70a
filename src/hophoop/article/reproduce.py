"""Reproduce the article: figures, films, statements, report."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from hophoop._support.extras import MissingExtra, need
from hophoop._support.files import replacing
from hophoop._support.processes import start_python
from hophoop._support.stopping import remove, stop_on_signals, temporary, undoing
from hophoop._version import __version__
from hophoop.article import report
from hophoop.article.figures import FIGURES, draw_figure
from hophoop.article.runs import Runs
from hophoop.article.statement import Statement
from hophoop.article.statements import count, statements

DPI = 160
TIDIES = 0.5  # s for the process of the films to end when it is stopped

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
        Whether to make films, if the extra ``films`` is installed.

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
    say = progress or _no_progress
    runs = Runs()
    # in parallel with figures and statements, which take as long
    with _films_in_background(folder / "films") if with_films else nullcontext() as process:
        for k, figure in enumerate(sorted(FIGURES, key=lambda figure: figure.long)):
            with _style():
                sheet = draw_figure(figure, runs)
                for ending in ("png", "svg"):
                    with replacing(folder / "figures" / f"{figure.name}.{ending}") as path:
                        sheet.savefig(path, dpi=DPI, metadata={"Date": None} if ending == "svg" else None)
                    sheet.set_layout_engine("none")  # a second layout would take half of the time
            say("figures", k + 1, len(FIGURES))
        checked = _check_statements(runs, say)
        _write_json(folder, checked)
        made: list[Path] = []
        reason = "they were not requested"
        if with_films:
            try:
                made = (process and process.finish(say)) or films(folder / "films", say)
                reason = ""
            except MissingExtra as error:
                reason = str(error)
    with replacing(folder / "index.html") as path:
        path.write_text(report.page(checked, folder, made, runs), encoding="utf-8")
    return Reproduction(folder, checked, tuple(made), reason)


def films(out: Path, progress: Progress) -> list[Path]:
    """Make the article's films.

    Parameters
    ----------
    out : Path
    progress : callable
        As in `reproduce`.

    Returns
    -------
    paths : list of Path

    Raises
    ------
    ImportError
        If the extra ``films`` is not installed.
    """
    need("av", "films")
    if find_spec("hophoop.animate") is None:
        raise MissingExtra("this version makes no films.")
    from hophoop.animate import article_films

    fresh = _unfinished_folder(out)
    shutil.rmtree(fresh, ignore_errors=True)  # left by a killed process
    with temporary(fresh):
        fresh.mkdir(parents=True)
        made = article_films(fresh, lambda done, total: progress("films", done, total))
        out.mkdir(exist_ok=True)
        for still in fresh.glob("*.png"):
            still.replace(out / still.name)
        return [path.replace(out / path.name) for path in made]


def _unfinished_folder(out: Path) -> Path:
    """Folder of the films until all are complete."""
    return out.with_name(f".{out.name}-new")


class _FilmProcess:
    """A process that makes the films."""

    def __init__(self, process: subprocess.Popen[bytes], out: Path) -> None:
        self._process = process
        self._out = out

    def finish(self, progress: Progress) -> list[Path]:
        """Wait for the films; none if the process failed."""
        assert self._process.stdout is not None
        made: list[Path] = []
        with self._process, self._process.stdout as lines:
            for line in lines:
                said = json.loads(line)
                if "made" in said:
                    made = [Path(name) for name in said["made"]]
                else:
                    progress("films", said["done"], said["total"])
        return made

    def stop(self) -> None:
        """End the process if it is still running."""
        if self._process.poll() is None:
            self._process.terminate()
            try:
                self._process.wait(TIDIES)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
            remove(_unfinished_folder(self._out))
        if self._process.stdout is not None:
            self._process.stdout.close()


@contextmanager
def _films_in_background(out: Path) -> Iterator[_FilmProcess | None]:
    try:
        process = start_python(
            f"from hophoop.article.reproduce import report_films; report_films({str(out)!r})",
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )
    except OSError:
        yield None
        return
    films = _FilmProcess(process, out)
    with undoing(films.stop):
        yield films


def report_films(out: str) -> None:
    """Make the films and report progress on standard output, in lines of JSON."""

    def say(_: str, done: int, total: int) -> None:
        print(json.dumps({"done": done, "total": total}), flush=True)

    with stop_on_signals(alone=True):
        made = films(Path(out), say)
        print(json.dumps({"made": [str(path) for path in made]}), flush=True)


def _check_statements(runs: Runs, progress: Progress) -> tuple[Statement, ...]:
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
        "version": __version__,
        "statements": [one.to_dict() for one in checked],
    }
    with replacing(folder / "statements.json") as path:
        path.write_text(json.dumps(data, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")


@contextmanager
def _style() -> Iterator[None]:
    """Style of figures for a page: reproducible files, letters as outlines."""
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


def _no_progress(stage: str, done: int, total: int) -> None:
    pass
