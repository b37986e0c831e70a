"""Settings of a film's appearance, validated: size, theme, camera and parts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from hophoop.animate.themes import THEMES
from hophoop.plots.curves import PANELS
from hophoop.scenario import InputError, describe
from hophoop.simulation.trajectory import Trajectory

CAMERAS = ("follow", "hold")
CAMERAS_3D = ("chase", "side", "orbit", "hold")
LAYOUTS = ("side", "overlay")
MAX_SIDE = 16384
FORCE_LENGTH, LONGEST = 1.3, 4.0  # of the arrow of the film's maximum force, in radii; of longer ones, over it
LANE = 1.6  # between several motions in 3D, in radii
TAGS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"  # of motions in one view


@dataclass(frozen=True)
class Look:
    """Appearance of a film in 2D.

    Attributes
    ----------
    size : (int, int)
        Width and height in pixels [1].
    theme : {'light', 'dark', 'print'}
    camera : {'follow', 'hold'}
        Follows the hoop, or shows the whole path.
    panels : str or sequence of str
        Animated plots of the first motion: velocity, energy, forces, utilization, phase.
    layout : {'side', 'overlay'}
        One view per motion, to one scale, or all in one view, the first on top.
    labels : sequence of str or None
        One line per motion; None for its parameters.
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
        object.__setattr__(self, "panels", as_tuple(self.panels))
        _check(self, camera=CAMERAS, layout=LAYOUTS, panels=tuple(PANELS))


@dataclass(frozen=True)
class Look3D:
    """Appearance of a film or scene in 3D.

    Attributes
    ----------
    size : (int, int)
        Width and height in pixels; a scene fills its window [1].
    theme : {'light', 'dark', 'print'}
        Colours.
    camera : {'chase', 'side', 'orbit', 'hold'}
        Next to the hoop and a little behind, perpendicular to it, orbiting it, or at rest with a view of the whole path.
    labels : sequence of str or None
        One line per motion; None for its parameters.
    traces : bool
        Draw the traces.
    forces : bool
        Draw the contact forces.
    shadows : bool
        Cast shadows, in 3D.
    """

    size: tuple[int, int] = (1280, 720)
    theme: str = "light"
    camera: str = "chase"
    labels: Sequence[str] | None = None
    traces: bool = True
    forces: bool = True
    shadows: bool = True

    def __post_init__(self) -> None:
        _check(self, camera=CAMERAS_3D)


def _check(look: Look | Look3D, **allowed: Sequence[str]) -> None:
    """Refuse a size that is not two integers, and words that are not allowed."""
    size = tuple(look.size)
    object.__setattr__(look, "size", size)
    if look.labels is not None:
        object.__setattr__(look, "labels", as_tuple(look.labels))
    if len(size) != 2 or not all(isinstance(side, int) and 64 <= side <= MAX_SIDE for side in size):
        raise InputError.of_field("size", size, f"a width and a height from 64 to {MAX_SIDE} pixels")
    for name, words in {"theme": tuple(THEMES), **allowed}.items():
        for word in as_tuple(getattr(look, name)):
            if word not in words:
                raise InputError.of_field(name, word, f"one of {', '.join(words)}")


def as_tuple(given: Any) -> tuple[Any, ...]:
    """Return one word or number, or several, as a tuple."""
    return (given,) if isinstance(given, str | float | int) else tuple(given)


def labels_of(motions: Sequence[Trajectory], labels: Sequence[str] | None) -> tuple[str, ...]:
    """Return one line of text per motion.

    labels: as given by the user.
    """
    if labels is None:
        return tuple(describe(motion.scenario) for motion in motions)
    if len(labels) != len(motions):
        raise InputError(
            f"labels has {len(labels)} texts; the film shows {len(motions)} motions.", field="labels", value=labels
        )
    return tuple(labels)


def bounded(way: Any, longest: float) -> Any:
    """Return an arrow, at most `longest` long: in a jam forces are unbounded."""
    return way * min(1.0, longest / max(float(np.hypot(*way)), 1e-300))


def nice(value: float) -> float:
    """Return the largest of 1, 2, 5 times a power of ten up to a value.

    value: above 0 [1].
    """
    power = 10.0 ** math.floor(math.log10(value))
    return max(step for step in (1.0, 2.0, 5.0) if step * power <= value * (1.0 + 1e-9)) * power
