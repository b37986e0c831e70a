"""How a film looks: its size, theme, camera and parts, checked once."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from hophoop.animate.themes import theme_of
from hophoop.scenario import InputError, describe
from hophoop.simulation.trajectory import Trajectory

CAMERAS = ("follow", "hold")
CAMERAS_3D = ("chase", "side", "orbit", "hold")
LAYOUTS = ("side", "overlay")
PANELS = ("velocity", "energy", "forces", "utilization", "phase")
MAX_SIDE = 16384


@dataclass(frozen=True)
class Look:
    """How a film in 2D looks.

    Attributes
    ----------
    size : (int, int)
        Width and height in pixels [1].
    theme : {'light', 'dark', 'print'}
    camera : {'follow', 'hold'}
        Goes along with the hoop, or shows the whole way at once.
    panels : str or sequence of str
        Plots of the first motion that run along: velocity, energy, forces, utilization, phase.
    layout : {'side', 'overlay'}
        Several motions in a view each, to one scale, or all in one, the first on top.
    labels : sequence of str or None
        A line for each motion; None says its parameters.
    traces, forces : bool
        Whether to draw the traces and the contact forces.
    """

    size: tuple[int, int] = (1280, 720)
    theme: str = "light"
    camera: str = "follow"
    panels: Sequence[str] | str = ()
    layout: str = "side"
    labels: Sequence[str] | None = None
    traces: bool = True
    forces: bool = True

    def __post_init__(self) -> None:
        _keep_tuples(self)
        object.__setattr__(self, "panels", _words(self.panels))
        check_size(self.size)
        theme_of(self.theme)
        one_of("camera", self.camera, CAMERAS)
        one_of("layout", self.layout, LAYOUTS)
        for panel in self.panels:
            one_of("panels", panel, PANELS)


@dataclass(frozen=True)
class Look3D:
    """How a film in 3D, or a scene that turns, looks.

    Attributes
    ----------
    size : (int, int)
        Width and height in pixels; a scene takes the room that it has [1].
    theme : {'light', 'dark', 'print'}
    camera : {'chase', 'side', 'orbit', 'hold'}
        Beside and a little behind the hoop, square to it, going round it, or at rest, seeing the whole way.
    labels : sequence of str or None
        A line for each motion; None says its parameters.
    traces, forces, shadows : bool
        Whether to draw them.
    """

    size: tuple[int, int] = (1280, 720)
    theme: str = "light"
    camera: str = "chase"
    labels: Sequence[str] | None = None
    traces: bool = True
    forces: bool = True
    shadows: bool = True

    def __post_init__(self) -> None:
        _keep_tuples(self)
        check_size(self.size)
        theme_of(self.theme)
        one_of("camera", self.camera, CAMERAS_3D)


def _keep_tuples(look: Look | Look3D) -> None:
    object.__setattr__(look, "size", tuple(look.size))
    if look.labels is not None:
        object.__setattr__(look, "labels", _words(look.labels))


def _words(words: Sequence[str] | str) -> tuple[str, ...]:
    return (words,) if isinstance(words, str) else tuple(words)


def check_size(size: tuple[int, int]) -> None:
    """Refuse a size that is not two whole numbers of pixels."""
    good = len(size) == 2 and all(isinstance(side, int) and 64 <= side <= MAX_SIDE for side in size)
    if not good:
        raise InputError.of_field("size", size, f"a width and a height from 64 to {MAX_SIDE} pixels")


def one_of(name: str, value: str, allowed: Sequence[str]) -> None:
    """Refuse a word that is not among those allowed."""
    if value not in allowed:
        raise InputError.of_field(name, value, f"one of {', '.join(allowed)}")


def labels_of(motions: Sequence[Trajectory], labels: Sequence[str] | None) -> tuple[str, ...]:
    """A line of text for each motion.

    Parameters
    ----------
    motions : sequence of Trajectory
    labels : sequence of str or None
        As given by the user.

    Returns
    -------
    labels : tuple of str

    Raises
    ------
    ValueError
        If there are not as many labels as motions.
    """
    if labels is None:
        return tuple(describe(motion.scenario) for motion in motions)
    if len(labels) != len(motions):
        raise InputError(
            f"labels holds {len(labels)} texts; the film shows {len(motions)} motions.", field="labels", value=labels
        )
    return tuple(labels)


def nice(value: float) -> float:
    """The greatest of 1, 2, 5 times a power of ten that is not above a value.

    Parameters
    ----------
    value : float
        Above 0 [1].

    Returns
    -------
    nice : float
        [1].
    """
    power = 10.0 ** math.floor(math.log10(value))
    return max(step for step in (1.0, 2.0, 5.0) if step * power <= value * (1.0 + 1e-9)) * power
