"""The films that users call for: one function for 2D, one for 3D, one picture, and a player for notebooks."""

from __future__ import annotations

import base64
import html
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from hophoop.animate.canvas import Bytes
from hophoop.animate.export import Pictures, Progress, check_film, format_of, write
from hophoop.animate.frames import Timing
from hophoop.animate.look import Look
from hophoop.animate.mpl import Film2D
from hophoop.animate.scene3d import Film3D, Look3D
from hophoop.trajectory import Trajectory

# 4 hundredths of a second a picture: a gif cannot say 1/30 s
GIF_FPS = 25.0
FPS_2D, FPS_3D = 60.0, 30.0

Motions = Trajectory | Sequence[Trajectory]


def film(
    motions: Motions,
    path: str | Path,
    *,
    fps: float | None = None,
    speed: float = 1.0,
    slow_at: Sequence[str | float] | str | float = (),
    slow_factor: float = 8.0,
    slow_width: float | None = None,
    start: float = 0.0,
    end: float | None = None,
    step: str = "time",
    size: tuple[int, int] = (1280, 720),
    theme: str = "light",
    camera: str = "follow",
    panels: Sequence[str] | str = (),
    layout: str = "side",
    labels: Sequence[str] | None = None,
    traces: bool = True,
    forces: bool = True,
    progress: Progress | None = None,
) -> Path:
    """A film in 2D of one or several motions.

    The ring is coloured by the speed of its points; the load draws a black trace and the centre of gravity a
    green one, red while airborne; arrows to scale are the contact forces.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
    path : str or Path
        Ends in .mp4, .webm, .gif or .png, or is a folder for PNG pictures.
    fps : float, optional
        Pictures a second of film; 60, and 25 in a gif [1/s].
    speed : float, default 1
        Seconds of motion a second of film: real time by default [1].
    slow_at : sequence of str or float, optional
        Kinds of events, such as 'takeoff', or times [s], around which the film is slow.
    slow_factor : float, default 8
        How many times slower [1].
    slow_width : float, optional
        How long before and after it is slow, in the motion's time; √(R/g)/2 by default [s].
    start, end : float, optional
        Part of the motion to show [s].
    step : {'time', 'angle'}
        What several motions have in common at each picture.
    size : (int, int), default (1280, 720)
        Width and height [pixels].
    theme : {'light', 'dark', 'print'}
    camera : {'follow', 'hold'}
        Goes along with the hoop, or shows the whole way at once.
    panels : sequence of str, optional
        Plots of the first motion that run along: velocity, energy, forces, utilization, phase.
    layout : {'side', 'overlay'}
        Several motions in a view each, or all in one, the first on top.
    labels : sequence of str, optional
        A line for each motion; its parameters by default.
    traces, forces : bool, default True
        Whether to draw the traces and the contact forces.
    progress : callable, optional
        Called with the number of pictures done and of all.

    Returns
    -------
    path : Path
        Where the film is.

    Raises
    ------
    ValueError
        If an argument is not among those allowed.
    ImportError
        If the extra 'films' is not installed.

    Examples
    --------
    >>> import hophoop as hh, tempfile
    >>> motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=0.2)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     film(motion, f"{folder}/hop.mp4", fps=30, size=(320, 180)).name
    'hop.mp4'
    """
    timing = _timing(path, fps, FPS_2D, speed, slow_at, slow_factor, slow_width, start, end, step)
    look = Look(
        _pair(size),
        theme,
        camera,
        _words(panels),
        layout,
        None if labels is None else tuple(labels),
        traces,
        forces,
    )
    check_film(format_of(path), look.size, timing.fps)
    return write(Film2D(_several(motions), timing, look), path, progress)


def picture(
    motions: Motions,
    t: float,
    *,
    size: tuple[int, int] = (1280, 720),
    theme: str = "light",
    camera: str = "follow",
    panels: Sequence[str] | str = (),
    layout: str = "side",
    labels: Sequence[str] | None = None,
    traces: bool = True,
    forces: bool = True,
) -> Bytes:
    """One picture of a film in 2D.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
    t : float
        Time [s].
    size : (int, int), default (1280, 720)
        Width and height [pixels].
    theme, camera, panels, layout, labels, traces, forces
        As in `film`.

    Returns
    -------
    picture : ndarray of uint8, shape (height, width, 4)
        Red, green, blue and opacity, from 0 to 255 [1].

    Raises
    ------
    ValueError
        If an argument is not among those allowed.
    ImportError
        If Matplotlib is not installed.
    """
    look = Look(
        _pair(size),
        theme,
        camera,
        _words(panels),
        layout,
        None if labels is None else tuple(labels),
        traces,
        forces,
    )
    several = _several(motions)
    longest = max((motion.duration for motion in several), default=0.0)
    if not 0.0 <= t <= longest:
        raise ValueError(f"t = {t!r} must be from 0 to the motion's end at {longest!r} s.")
    # A film of two pictures: the start, and the one that is asked for.
    timing = Timing(fps=1.0 / t, end=t) if t >= 1e-3 else Timing(end=max(t, 0.0))
    shown = Film2D(several, timing, look)
    return shown.draw(shown.count - 1).copy()


def film_3d(
    motions: Motions,
    path: str | Path,
    *,
    fps: float | None = None,
    speed: float = 1.0,
    slow_at: Sequence[str | float] | str | float = (),
    slow_factor: float = 8.0,
    slow_width: float | None = None,
    start: float = 0.0,
    end: float | None = None,
    step: str = "time",
    size: tuple[int, int] = (1280, 720),
    theme: str = "light",
    camera: str = "chase",
    labels: Sequence[str] | None = None,
    traces: bool = True,
    forces: bool = True,
    shadows: bool = True,
    progress: Progress | None = None,
) -> Path:
    """A film in 3D of one or several motions, rendered without a display.

    The ring is a torus, the load a sphere; colours as in `film`. Several motions run in lanes.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
    path : str or Path
        Ends in .mp4, .webm, .gif or .png, or is a folder for PNG pictures.
    fps : float, optional
        Pictures a second of film; 30, and 25 in a gif [1/s].
    speed : float, default 1
        Seconds of motion a second of film [1].
    slow_at : sequence of str or float, optional
        Kinds of events, or times [s], around which the film is slow.
    slow_factor : float, default 8
        How many times slower [1].
    slow_width : float, optional
        How long before and after it is slow, in the motion's time [s].
    start, end : float, optional
        Part of the motion to show [s].
    step : {'time', 'angle'}
        What several motions have in common at each picture.
    size : (int, int), default (1280, 720)
        Width and height [pixels].
    theme : {'light', 'dark', 'print'}
    camera : {'chase', 'side', 'orbit', 'hold'}
        Beside and a little behind the hoop, square to it, going round it, or at rest, seeing the whole way.
    labels : sequence of str, optional
        A line for each motion; its parameters by default.
    traces, forces, shadows : bool, default True
        Whether to draw them.
    progress : callable, optional
        Called with the number of pictures done and of all.

    Returns
    -------
    path : Path
        Where the film is.

    Raises
    ------
    ValueError
        If an argument is not among those allowed.
    ImportError
        If the extra 'films' is not installed.
    """
    timing = _timing(path, fps, FPS_3D, speed, slow_at, slow_factor, slow_width, start, end, step)
    look = Look3D(
        _pair(size), theme, camera, None if labels is None else tuple(labels), traces, forces, shadows
    )
    check_film(format_of(path), look.size, timing.fps)
    with Film3D(_several(motions), timing, look) as pictures:
        return write(pictures, path, progress)


@dataclass(frozen=True)
class Player:
    """A film that plays where a notebook shows it, without the network.

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
        """The film as an element of an HTML page, its data inside.

        Parameters
        ----------
        title : str
            What a screen reader says.

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


def player(
    motions: Motions, *, three_d: bool = False, size: tuple[int, int] = (960, 540), **options: object
) -> Player:
    """A film that plays in place in a notebook; it takes all else that `film` or `film_3d` takes.

    Parameters
    ----------
    motions : Trajectory or sequence of Trajectory
    three_d : bool, default False
        Whether in 3D.
    size : (int, int), default (960, 540)
        Width and height [pixels].

    Returns
    -------
    player : Player

    Raises
    ------
    ValueError
        If an option is not among those allowed.
    ImportError
        If the extra 'films' is not installed.
    """
    make = film_3d if three_d else film
    with tempfile.TemporaryDirectory() as folder:
        path = make(motions, Path(folder) / "film.mp4", size=size, **options)  # type: ignore[arg-type]
        return Player(path.read_bytes(), _pair(size))


def _timing(
    path: str | Path,
    fps: float | None,
    usual: float,
    speed: float,
    slow_at: Sequence[str | float] | str | float,
    slow_factor: float,
    slow_width: float | None,
    start: float,
    end: float | None,
    step: str,
) -> Timing:
    if fps is None:
        fps = GIF_FPS if format_of(path) == "gif" else usual
    marks = (slow_at,) if isinstance(slow_at, str | float | int) else tuple(slow_at)
    return Timing(float(fps), speed, marks, slow_factor, slow_width, start, end, step)


def _pair(size: Sequence[int]) -> tuple[int, int]:
    pair = tuple(size)
    if len(pair) != 2:
        raise ValueError(f"size = {pair!r} must be a width and a height in pixels.")
    return pair[0], pair[1]


def _words(panels: Sequence[str] | str) -> tuple[str, ...]:
    return (panels,) if isinstance(panels, str) else tuple(panels)


def _several(motions: Motions) -> tuple[Trajectory, ...]:
    return (motions,) if isinstance(motions, Trajectory) else tuple(motions)


__all__ = ["FPS_2D", "FPS_3D", "Pictures", "Player", "film", "film_3d", "picture", "player"]
