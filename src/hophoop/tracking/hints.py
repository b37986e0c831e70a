"""Known properties of a film, given before tracking."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from hophoop.scenario import InputError

TINY, HUGE = 1e-30, 1e30  # limits of sizes and errors in SI units; their fourth powers are still doubles
LIMITS = (  # of hints: how many numbers, their largest amount
    ("centre", 2, HUGE, "2 numbers"),
    ("ground", 4, HUGE, "4 numbers"),
    ("row_delay", 1, 1e-3, "from -0.001 to 0.001 s"),
    ("tilt", 2, 0.6, "2 numbers from -0.6 to 0.6 (radians)"),
    ("level", 1, 1.0, "between -1 and 1 (radians)"),
    ("slope", 1, 1.57, "between -pi/2 and pi/2 (radians)"),
)


@dataclass(frozen=True)
class Hints:
    """Known properties of a film; others are found in it.

    Parameters
    ----------
    marker_color : str, default 'auto'
        Colour of the marker: auto, none, a name such as red, or #rrggbb.
    ring : {'auto', 'dark', 'light'}, default 'auto'
        The rim against its background.
    centre : tuple of float, optional
        The hoop's centre in a frame [pixels].
    rim : float, optional
        Radius of the rim in that frame [pixels].
    at : float, default 0
        Time of that frame [s].
    ground : tuple of float, optional
        Two points of the ground line below the rim [pixels]: column, row, column, row.
    level : float, optional
        Rise of a level line to the right in the picture [rad]. By default the picture's rows are level to 2°.
    slope : float, optional
        Slope of the plane, downhill to the right [rad].
    exposure : float, default 0
        Exposure time [s]; the times of the track are at its middle.
    row_delay : float, default 0
        Rolling shutter: delay from row to row [s].
    rate : float, optional
        Frames per second as taken, if the file is in slow motion [1].
    since : float, optional
        Time from which to track [s], from the first frame of the film.
    until : float, optional
        Time up to which to track [s].
    tilt : tuple of float, optional
        Rotation of the plane of motion about the picture's horizontal and vertical axis [rad]; 0,0 is without tilt. By
        default it is found from the film.
    focal : float, optional
        Focal length [pixels].

    Raises
    ------
    ValueError
        If a value is not allowed.
    """

    marker_color: str = "auto"
    ring: str = "auto"
    centre: tuple[float, float] | None = None
    rim: float | None = None
    at: float = 0.0
    ground: tuple[float, float, float, float] | None = None
    level: float | None = None
    slope: float | None = None
    exposure: float = 0.0
    row_delay: float = 0.0
    rate: float | None = None
    since: float | None = None
    until: float | None = None
    tilt: tuple[float, float] | None = None
    focal: float | None = None

    def __post_init__(self) -> None:
        if self.marker_color not in ("auto", "none"):
            from hophoop.tracking.marker import colour_chroma

            colour_chroma(self.marker_color)
        if (self.centre is None) != (self.rim is None):
            missing, there = ("rim", "centre") if self.rim is None else ("centre", "rim")
            raise InputError(f"{missing} is missing: {there} alone does not locate the hoop.")
        require_above_0(rim=self.rim, rate=self.rate, focal=self.focal)
        if self.ring not in ("auto", "dark", "light"):
            raise InputError.of_field("ring", self.ring, "auto, dark or light")
        if not 0.0 <= self.exposure < 1.0:
            raise InputError.of_field("exposure", self.exposure, "from 0 to 1 s")
        for name, count, most, allowed in LIMITS:
            value = getattr(self, name)
            if value is not None and not (np.size(value) == count and np.all(np.abs(value) <= most)):
                raise InputError.of_field(name, value, allowed)


def require_above_0(**values: float | None) -> None:
    """Refuse numbers that are not above 0, or so small that their squares vanish, by their fields; None is allowed."""
    for name, value in values.items():
        if value is not None and not TINY <= value <= HUGE:
            positive = 0.0 < value < np.inf
            raise InputError.of_field(name, value, f"from {TINY:g} to {HUGE:g}" if positive else "a number above 0")
