"""The films of the article."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import closing, nullcontext
from dataclasses import dataclass, replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final

import numpy as np

from hophoop.animate.export import save_png, write
from hophoop.animate.film2d import Film2D
from hophoop.animate.film3d import Film3D
from hophoop.animate.films import FPS_2D, FPS_3D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look, Look3D
from hophoop.animate.web import scene
from hophoop.scenario import Hoop, Plane, Scenario, Start
from hophoop.simulation.simulate import simulate

SIZE: Final = (960, 540)
USUAL: Final = Timing()
CALM: Final = 0.5  # share of the usual frame rate, for slow motions


@dataclass(frozen=True)
class ArticleFilm:
    """One film: its motion and settings.

    Attributes
    ----------
    name : str
        Name of the file, without its ending.
    speed : float
        v₀ [m/s].
    mu : float
        Friction [1].
    duration : float
        Duration of the motion [s].
    three_d : bool
        Whether the film is in 3D.
    timing : Timing
    """

    name: str
    speed: float
    mu: float
    duration: float
    three_d: bool
    timing: Timing = USUAL
    still: float = 0.9
    share: float = 1.0

    @property
    def scenario(self) -> Scenario:
        """The run of the article."""
        return Scenario(
            hoop=Hoop.ideal(0.75),
            plane=Plane(mu=self.mu),
            start=Start.rolling(self.speed),
            duration=self.duration,
        )


_HOP: Final = Timing(slow_at=("takeoff", "impact"), slow_factor=4.0, slow_width=0.12)

ARTICLE_FILMS: Final = (
    # this start hardly moves for 2 s; one revolution takes about 6 s
    ArticleFilm("v0.1", 0.1, 1.0, 6.0, False, USUAL, 3.3, CALM),
    ArticleFilm("v2", 2.0, 1.0, 3.0, False),
    ArticleFilm("v2.8", 2.8, 1.0, 3.0, False),
    ArticleFilm("v3.1", 3.1, 1.0, 2.5, False, _HOP, 1.42),
    ArticleFilm("v0.1-mu0.3", 0.1, 0.3, 9.0, False, USUAL, 4.9, CALM),
    ArticleFilm("v3.1-3d", 3.1, 1.0, 2.5, True, USUAL, 1.42),
)


def article_films(
    out_dir: str | Path,
    progress: Callable[[int, int], None] | None = None,
) -> list[Path]:
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
