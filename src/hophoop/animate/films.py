"""Public functions: films in 2D and 3D, one picture, and a player for notebooks."""

from __future__ import annotations

import base64
import html
from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path

from hophoop._support.stopping import temporary_folder
from hophoop.animate.export import Progress, format_of, write
from hophoop.animate.film2d import Film2D
from hophoop.animate.film3d import Film3D
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look, Look3D
from hophoop.animate.sheet import Bytes
from hophoop.scenario import InputError
from hophoop.simulation.trajectory import Trajectory

# 0.04 s per picture: a gif counts in 0.01 s
GIF_FPS = 25.0
FPS_2D, FPS_3D = 60.0, 30.0
PLAYER_SIZE = (960, 540)

Motions = Trajectory | Sequence[Trajectory]


def film(
    motions: Motions,
    path: str | Path,
    timing: Timing = Timing(),
    look: Look = Look(),
    progress: Progress | None = None,
) -> Path:
    """Make a film in 2D of one or several motions.

    The ring is coloured by the speed of its points. The load draws a black trace and the centre of gravity a green one, red
    while airborne. Arrows to scale are the contact forces.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
    path : str or Path
        Ends in .mp4, .webm, .gif or .png, or is a folder for PNG pictures.
    timing : Timing
        Part of the motion, speed, slow motion, frame rate; by default 60 pictures per second, in a gif 25.
    look : Look
        Size, theme, camera, panels, and arrangement of several motions.
    progress : callable, optional
        Called with the number of pictures done and of all.

    Returns
    -------
    path : Path
        The film.

    Raises
    ------
    ValueError
        If the settings do not fit the motions or the format.
    ImportError
        If the extra 'films' is not installed.

    Examples
    --------
    >>> import hophoop as hh, tempfile
    >>> motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=0.2)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     film(motion, f"{folder}/hop.mp4", Timing(fps=30), Look(size=(320, 180))).name
    'hop.mp4'
    """
    return write(Film2D(_several(motions), _with_frame_rate(timing, path, FPS_2D), look), path, progress)


def picture(motions: Motions, t: float, look: Look = Look()) -> Bytes:
    """Draw one picture of a film in 2D.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
    t : float
        Time [s].
    look : Look
        As in `film`.

    Returns
    -------
    picture : ndarray of uint8, shape (height, width, 4)
        Red, green, blue and opacity, from 0 to 255 [1].

    Raises
    ------
    ValueError
        If the time is outside of the motions, or the look does not fit them.
    ImportError
        If Matplotlib is not installed.
    """
    several = _several(motions)
    longest = max((motion.duration for motion in several), default=0.0)
    if not 0.0 <= t <= longest:
        raise InputError.of_field("t", t, f"from 0 to the motion's end at {longest!r} s")
    # a film of two pictures: the start, and the wanted one
    timing = Timing(fps=1.0 / t, end=t) if t >= 1e-3 else Timing(end=max(t, 0.0))
    shown = Film2D(several, timing, look)
    return shown.draw(shown.count - 1).copy()


def film_3d(
    motions: Motions,
    path: str | Path,
    timing: Timing = Timing(),
    look: Look3D = Look3D(),
    progress: Progress | None = None,
) -> Path:
    """Make a film in 3D of one or several motions, rendered without a display.

    The ring is a torus, the load a sphere; colours as in `film`. Several motions run in lanes.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
    path : str or Path
        Ends in .mp4, .webm, .gif or .png, or is a folder for PNG pictures.
    timing : Timing
        As in `film`, by default with 30 pictures per second.
    look : Look3D
        Size, theme, camera and drawn parts.
    progress : callable, optional
        Called with the number of pictures done and of all.

    Returns
    -------
    path : Path
        The film.

    Raises
    ------
    ValueError
        If the settings do not fit the motions or the format.
    ImportError
        If the extra 'films3d' is not installed.
    """
    with closing(Film3D(_several(motions), _with_frame_rate(timing, path, FPS_3D), look)) as pictures:
        return write(pictures, path, progress)


@dataclass(frozen=True)
class Player:
    """A film that plays in a notebook, without network.

    Attributes
    ----------
    data : bytes
        The film, mp4.
    size : (int, int)
        Width and height [pixels].
    """

    data: bytes
    size: tuple[int, int]

    def _repr_html_(self) -> str:
        return self.html()

    def html(self, title: str = "Film of a loaded hoop") -> str:
        """Return the film as an HTML element with its data.

        Parameters
        ----------
        title : str
            Text for screen readers.

        Returns
        -------
        html : str
        """
        content = base64.b64encode(self.data).decode("ascii")
        return (
            f'<video controls loop muted playsinline autoplay aria-label="{html.escape(title, quote=True)}" '
            f'style="max-width:100%;height:auto" width="{self.size[0]}" height="{self.size[1]}" '
            f'src="data:video/mp4;base64,{content}"></video>'
        )


def player(motions: Motions, timing: Timing = Timing(), look: Look | Look3D = Look(size=PLAYER_SIZE)) -> Player:
    """Make a film that plays in a notebook.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
    timing : Timing
        As in `film`.
    look : Look or Look3D
        In 2D by default, 960 by 540 pixels; a `Look3D` makes the film in 3D.

    Returns
    -------
    player : Player

    Raises
    ------
    ValueError
        If the settings do not fit the motions.
    ImportError
        If the extra 'films' is not installed; for a `Look3D`, 'films3d'.
    """
    with temporary_folder() as folder:
        path = folder / "film.mp4"
        if isinstance(look, Look3D):
            film_3d(motions, path, timing, look)
        else:
            film(motions, path, timing, look)
        return Player(path.read_bytes(), look.size)


def _with_frame_rate(timing: Timing, path: str | Path, usual: float) -> Timing:
    if timing.fps is not None:
        return timing
    return replace(timing, fps=GIF_FPS if format_of(path) == "gif" else usual)


def _several(motions: Motions) -> tuple[Trajectory, ...]:
    return (motions,) if isinstance(motions, Trajectory) else tuple(motions)
