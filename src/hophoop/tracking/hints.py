"""Known properties of a film, given before tracking."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from hophoop.scenario import InputError


@dataclass(frozen=True)
class Hints:
    """Known properties of a film; others are found in it.

    Parameters
    ----------
    marker_color : str, default 'auto'
        Colour of the marker: a name such as 'red', '#rrggbb', or 'none'.
    ring : {'auto', 'dark', 'light'}, default 'auto'
        Whether the rim is darker or lighter than its background.
    centre : tuple of float, optional
        Column and row of the hoop's centre in a frame [pixel].
    rim : float, optional
        Radius of the rim in that frame [pixel].
    at : float, default 0
        Time of that frame [s].
    ground : tuple of float, optional
        Columns and rows of two points on the line where the rim touches the ground: column, row, column, row [pixel].
    level : float, default 0
        Angle by which a level line rises to the right in the picture [rad].
    slope : float, optional
        Slope of the plane, downhill to the right [rad].
    exposure : float, default 0
        Exposure time; times of the track are at its middle [s].
    row_delay : float, default 0
        Rolling shutter: delay of the exposure from row to row [s].
    rate : float, optional
        Frames per second as taken, if the file's own times are those of slow motion [Hz].
    since, until : float, optional
        Times between which the hoop is tracked, from the first frame of the film [s].
    tilt : tuple of float, optional
        Rotation of the plane of motion about the picture's horizontal and vertical axis; (0, 0) is straight on [rad].
    focal : float, optional
        Focal length of the lens [pixel].

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
    level: float = 0.0
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
        if self.ring not in ("auto", "dark", "light"):
            raise InputError.of_field("ring", self.ring, "auto, dark or light")
        if (self.centre is None) != (self.rim is None):
            missing, there = ("rim", "centre") if self.rim is None else ("centre", "rim")
            raise InputError(f"{missing} is missing: {there} alone does not locate the hoop.")
        for name, count in (("centre", 2), ("ground", 4), ("tilt", 2)):
            value = getattr(self, name)
            if value is not None and (len(value) != count or not np.isfinite(value).all()):
                raise InputError.of_field(name, value, f"{count} numbers")
        for name in ("rim", "rate", "focal"):
            value = getattr(self, name)
            if value is not None and not (np.isfinite(value) and value > 0):
                raise InputError.of_field(name, value, "a number above 0")
        if not 0.0 <= self.exposure < 1.0:
            raise InputError.of_field("exposure", self.exposure, "from 0 to 1 s")
        if not abs(self.row_delay) <= 1e-3:
            raise InputError.of_field("row_delay", self.row_delay, "from -0.001 to 0.001 s")
        if self.tilt is not None and max(abs(self.tilt[0]), abs(self.tilt[1])) > 0.6:
            raise InputError.of_field("tilt", self.tilt, "from -0.6 to 0.6 (radians)")
        if not abs(self.level) < 1.0:
            raise InputError.of_field("level", self.level, "between -1 and 1 (radians)")
        if self.slope is not None and not abs(self.slope) < 0.5 * np.pi:
            raise InputError.of_field("slope", self.slope, "between -pi/2 and pi/2 (radians)", rule="must lie")
