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
    level : float, default 0
        Rise of a level line to the right in the picture [rad].
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
