"""The films of the article, made in other processes while figures are drawn and statements checked."""

from __future__ import annotations

import multiprocessing
import os
import shutil
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import closing, contextmanager, nullcontext
from dataclasses import dataclass, replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final

import numpy as np

from hophoop._support.extras import need
from hophoop._support.stopping import ignored_by_children, temporary
from hophoop.animate.export import save_png, write
from hophoop.animate.film2d import Film2D
from hophoop.animate.film3d import Film3D
from hophoop.animate.films import FPS_2D, FPS_3D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look, Look3D
from hophoop.animate.web import scene
from hophoop.article.scenarios import scenarios
from hophoop.scenario import Scenario
from hophoop.simulation.simulate import simulate

SIZE: Final = (960, 540)
USUAL: Final = Timing()
CALM: Final = 0.5  # share of the usual frame rate, for slow motions
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class ArticleFilm:
    """One film: the names of its file and of its motion, the duration of the motion and the time of its poster [s]."""

    name: str
    run: str
    duration: float
    still: float = 0.9
    timing: Timing = USUAL
    share: float = 1.0  # of the usual frame rate
    three_d: bool = False

    @property
    def scenario(self) -> Scenario:
        """The motion of the article, as long as the film."""
        return scenarios()[self.run].replace("duration", self.duration)


ARTICLE_FILMS: Final = (
    # this start hardly moves for 2 s; one revolution takes about 6 s
    ArticleFilm("v0.1", "slow", 6.0, 3.3, share=CALM),
    ArticleFilm("v2", "faster", 3.0),
    ArticleFilm("v2.8", "slipping", 3.0),
    ArticleFilm("v3.1", "hop", 2.5, 1.42, Timing(slow_at=("takeoff", "impact"), slow_factor=4.0, slow_width=0.12)),
    ArticleFilm("v0.1-mu0.3", "low_friction", 9.0, 4.9, share=CALM),
    ArticleFilm("v3.1-3d", "hop", 2.5, 1.42, three_d=True),
)


def article_films(out_dir: str | Path, progress: Progress | None = None) -> list[Path]:
    """Make all films of the article: five in 2D and one in 3D, each with a poster, a picture of the same name.

    The one in 3D is also a page that turns in a browser, and only this page without the extra ``films3d``.

    Parameters
    ----------
    out_dir : str or Path
        Folder of the films; created if missing.
    progress : callable, optional
        Called with the number of films done and of all.

    Returns
    -------
    paths : list of Path
        In the order of the article, the page last.

    Raises
    ------
    ImportError
        If the extra 'films' is not installed.
    """
    Path(out_dir).mkdir(parents=True, exist_ok=True)
    paths, steps = [], article_steps()
    for done, (film, suffix) in enumerate(steps):
        paths.append(make_film(film, suffix, Path(out_dir)))
        if progress is not None:
            progress(done + 1, len(steps))
    return paths


def article_steps() -> list[tuple[ArticleFilm, str]]:
    """Return the films that can be made here and the endings of their files: mp4, and html for a page that turns."""
    drawn = [film for film in ARTICLE_FILMS if not film.three_d or find_spec("pyvista")]
    return [*((film, "mp4") for film in drawn), *((film, "html") for film in ARTICLE_FILMS if film.three_d)]


def make_film(film: ArticleFilm, suffix: str, folder: Path) -> Path:
    """Make one film of the article and its poster, for pages that do not play it, or its page, in a folder; return its path."""
    path, motion = folder / f"{film.name}.{suffix}", simulate(film.scenario)
    if suffix == "html":
        return scene(motion, path, film.timing)
    timing = replace(film.timing, fps=film.share * (FPS_3D if film.three_d else FPS_2D))
    kind: Any = Film3D if film.three_d else Film2D
    pictures = kind((motion,), timing, Look3D(size=SIZE) if film.three_d else Look(size=SIZE))
    with closing(pictures) if film.three_d else nullcontext():
        write(pictures, path)
        k = int(np.searchsorted(pictures.clock.times[0], min(film.still, motion.duration)))
        save_png(pictures.draw(min(k, pictures.count - 1)), path.with_suffix(".png"))
    return path


@contextmanager
def started_films(out: Path) -> Iterator[Callable[[Progress], list[Path]]]:
    """Start the films in other processes; the context has a function that waits for them and returns their paths in `out`."""
    need("av", "films")
    fresh = out.with_name(f".{out.name}-new")  # until all are complete
    shutil.rmtree(fresh, ignore_errors=True)  # left by a killed process
    steps, others = article_steps(), multiprocessing.active_children()
    count = min(len(steps), os.cpu_count() or 1)
    pool = ProcessPoolExecutor(count, multiprocessing.get_context("spawn"), initializer=_end_with_parent)

    def finish(progress: Progress) -> list[Path]:
        for done, (step, made) in enumerate(zip(steps, futures, strict=True)):
            try:
                made.result()
            except BrokenProcessPool:  # another process was killed
                make_film(*step, fresh)
            progress(done + 1, len(steps))
        out.mkdir(exist_ok=True)
        for file in fresh.iterdir():
            file.replace(out / file.name)
        return [out / f"{film.name}.{suffix}" for film, suffix in steps]

    with temporary(fresh):
        fresh.mkdir(parents=True)
        try:
            with ignored_by_children():
                futures = [pool.submit(make_film, *step, fresh) for step in steps]
            yield finish
        finally:
            for child in set(multiprocessing.active_children()).difference(others):
                child.kill()
            pool.shutdown(cancel_futures=True)


def _end_with_parent() -> None:
    """Let this process end with the one that started it; else it would wait for more work for ever."""

    def watch() -> None:
        parent = multiprocessing.parent_process()
        if parent is not None:
            parent.join()
            os._exit(1)

    threading.Thread(target=watch, daemon=True).start()
