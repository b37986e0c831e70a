"""The whole article in one go: figures, films, statements, report."""

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
from hophoop.article.figures import FIGURES, drawn
from hophoop.article.runs import Runs
from hophoop.article.statement import Statement
from hophoop.article.statements import count, statements

DPI = 160
TIDIES = 0.5  # seconds that the process of the films has to end when it is stopped

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
        return tuple(one for one in self.statements if not one.holds)


def reproduce(out: str | Path = "article", progress: Progress | None = None, with_films: bool = True) -> Reproduction:
    """Compute the article's motions, draw its figures, check its statements and write a report.

    Parameters
    ----------
    out : str or Path, default 'article'
        Folder to write to, made if it is not there: ``index.html``, ``statements.json``, ``figures/`` and
        ``films/``.
    progress : callable, optional
        Called with the name of a stage ('statements', 'figures', 'films'), how many steps are done
        and of how many.
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
    # beside figures and statements, which take as long
    with _films_beside(folder / "films") if with_films else nullcontext() as beside:
        for k, figure in enumerate(sorted(FIGURES, key=lambda figure: figure.long)):
            with _style():
                sheet = drawn(figure, runs)
                for ending in ("png", "svg"):
                    with replacing(folder / "figures" / f"{figure.name}.{ending}") as path:
                        sheet.savefig(path, dpi=DPI, metadata={"Date": None} if ending == "svg" else None)
                    sheet.set_layout_engine("none")  # it is laid out; doing so again takes half of the time
            say("figures", k + 1, len(FIGURES))
        checked = _checked(runs, say)
        _write_json(folder, checked)
        made: list[Path] = []
        reason = "they were not asked for"
        if with_films:
            try:
                made = (beside and beside.finish(say)) or films(folder / "films", say)
                reason = ""
            except MissingExtra as error:
                reason = str(error)
    with replacing(folder / "index.html") as path:
        path.write_text(report.page(checked, folder, made, runs), encoding="utf-8")
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
    need("av", "films")
    if find_spec("hophoop.animate") is None:
        raise MissingExtra("this version makes no films.")
    from hophoop.animate import article_films

    fresh = _fresh(out)
    shutil.rmtree(fresh, ignore_errors=True)  # of one that was killed
    with temporary(fresh):
        fresh.mkdir(parents=True)
        made = article_films(fresh, lambda done, total: progress("films", done, total))
        out.mkdir(exist_ok=True)
        for still in fresh.glob("*.png"):
            still.replace(out / still.name)
        return [path.replace(out / path.name) for path in made]


def _fresh(out: Path) -> Path:
    """Where films are until all are there."""
    return out.with_name(f".{out.name}-new")


class _Beside:
    """A process that makes the films."""

    def __init__(self, process: subprocess.Popen[bytes], out: Path) -> None:
        self._process = process
        self._out = out

    def finish(self, progress: Progress) -> list[Path]:
        """Wait for the films; none where the process failed."""
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
        """End it, where it is still at work because something else went wrong."""
        if self._process.poll() is None:
            self._process.terminate()
            try:
                self._process.wait(TIDIES)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
            remove(_fresh(self._out))
        if self._process.stdout is not None:
            self._process.stdout.close()


@contextmanager
def _films_beside(out: Path) -> Iterator[_Beside | None]:
    try:
        process = start_python(
            f"from hophoop.article.reproduce import films_for_another; films_for_another({str(out)!r})",
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )
    except OSError:
        yield None
        return
    beside = _Beside(process, out)
    with undoing(beside.stop):
        yield beside


def films_for_another(out: str) -> None:
    """Make the films and say on standard output, in lines of JSON, how far that is."""

    def say(_: str, done: int, total: int) -> None:
        print(json.dumps({"done": done, "total": total}), flush=True)

    with stop_on_signals(alone=True):
        made = films(Path(out), say)
        print(json.dumps({"made": [str(path) for path in made]}), flush=True)


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
        "version": __version__,
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
