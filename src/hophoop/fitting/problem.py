"""The fitted problem: from parameters to the exact motion and its residuals."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.channels import Channel, channels_of
from hophoop.fitting.parameters import STARTS
from hophoop.scenario import Hoop, InputError, Plane, Scenario, Start
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory
from hophoop.tracking import Track

Floats = NDArray[np.float64]

FAR = 1e4  # residual of an impossible motion [standard deviations]
SAME = 1e-6  # relative difference of radii that is rounding
BEYOND = 1.0 + 1e-9  # duration of the motion over that of the data


class Prior(NamedTuple):
    """Knowledge of a parameter in addition to the data."""

    value: float  # [the parameter's unit]
    error: float  # its standard deviation


@dataclass(frozen=True, eq=False)
class Problem:
    """Data and known quantities; the parameters complete them to a scenario.

    Attributes
    ----------
    t : ndarray, shape (n,)
        Times from the first frame [s].
    channels : tuple of Channel
    rows : ndarray, shape (n,) or None
        Picture row of the centre, minus the mean [pixel].
    radius : float
        [m]
    hoop : Hoop or None
        If it is known.
    general : bool
        Whether the hoop is a general one instead of an ideal one.
    start : str
        A key of STARTS.
    plane : Plane
        Gravity and the impact law.
    priors : mapping of str to Prior
        Priors of parameters; each counts as a measured number.
    computed : list of int
        Number of motions computed so far [1].
    """

    t: Floats
    channels: tuple[Channel, ...]
    rows: Floats | None
    radius: float
    hoop: Hoop | None
    general: bool
    start: str
    plane: Plane = field(default_factory=Plane)
    priors: Mapping[str, Prior] = field(default_factory=dict)
    computed: list[int] = field(default_factory=lambda: [0])

    @property
    def names(self) -> tuple[str, ...]:
        """Parameters of this problem."""
        hoop = () if self.hoop is not None else ("eccentricity", "inertia_ratio") if self.general else ("gamma",)
        return (
            *hoop, "mu_kinetic", "mu_excess", "restitution", "slope", "rolling_resistance", *STARTS[self.start],
            "scale", "tilt", "origin_y", "row_delay", "marker_angle", "marker_ratio",
        )  # fmt: skip

    @property
    def count(self) -> int:
        """Number of measured numbers [1]."""
        return sum(len(channel.values) for channel in self.channels) + len(self.priors)

    @property
    def data(self) -> Floats:
        """Measured values, channel after channel."""
        return np.concatenate([channel.values for channel in self.channels])

    @property
    def errors(self) -> Floats:
        """Standard deviations of the data."""
        return np.concatenate([channel.errors for channel in self.channels])

    def scenario(self, values: dict[str, float]) -> Scenario:
        """Return the scenario of parameters.

        values: all of `names`.
        """
        if self.hoop is not None:
            hoop = self.hoop
        elif self.general:
            hoop = Hoop(radius=self.radius, eccentricity=values["eccentricity"], inertia_ratio=values["inertia_ratio"])
        else:
            hoop = Hoop(radius=self.radius, load_fraction=values["gamma"])
        known = {name: value for name, value in self.plane.to_dict().items() if name != "mu"}
        fitted = {name: values[name] for name in ("slope", "mu_kinetic", "restitution", "rolling_resistance")}
        plane = Plane(**{**known, **fitted, "mu_static": values["mu_kinetic"] + values["mu_excess"]})
        if self.start == "rolling":
            start = Start(x=values["x0"], angle=values["angle0"], speed=values["speed"])
        else:
            free = self.start == "flying"
            start = Start(
                x=values["x0"],
                height=values["height0"] if free else 0.0,
                angle=values["angle0"],
                vx=values["vx0"],
                vy=values["vy0"] if free else 0.0,
                omega=values["omega0"],
            )
        margin = abs(values["row_delay"]) * (float(np.ptp(self.rows)) if self.rows is not None else 0.0)
        return Scenario(hoop=hoop, plane=plane, start=start, duration=float(self.t[-1]) * BEYOND + margin)

    def motion(self, values: dict[str, float]) -> Trajectory:
        """Compute the motion of parameters.

        values: all of `names`.
        """
        self.computed[0] += 1
        return simulate(self.scenario(values))

    def moments(self, motion: Trajectory, values: dict[str, float]) -> Floats:
        """Times of the motion at which the centre was exposed in each frame.

        values: all of `names`; t shape (n,) [s].
        """
        times = self.t if self.rows is None else self.t + values["row_delay"] * self.rows
        return np.clip(times, 0.0, motion.duration)

    def places(self, motion: Trajectory, values: dict[str, float]) -> dict[str, Floats]:
        """Predicted data of a motion in each frame.

        values: all of `names`; places: by name of the channel [m or rad].
        """
        state = motion.at(self.moments(motion, values))
        reach = values["marker_ratio"] * self.radius
        marked = state.angle + values["marker_angle"]
        x, y = state.x, state.height + self.radius
        cos, sin = values["scale"] * np.cos(values["tilt"]), values["scale"] * np.sin(values["tilt"])

        def rotate(a: Floats, b: Floats) -> tuple[Floats, Floats]:
            return cos * a - sin * b, values["origin_y"] + sin * a + cos * b

        first, second = rotate(x, y)
        third, fourth = rotate(x + reach * np.sin(marked), y + reach * np.cos(marked))
        return {"x": first, "y": second, "marker_x": third, "marker_y": fourth, "angle": marked - values["tilt"]}

    def residuals(self, values: dict[str, float]) -> Floats:
        """Return data minus motion, in standard deviations.

        values: all of `names`; residuals shape (count,) [1].
        """
        try:
            motion = self.motion(values)
        except InputError:
            return np.full(self.count, FAR)
        return self.distances(self.places(motion, values), values)

    def distances(self, places: dict[str, Floats], values: dict[str, float]) -> Floats:
        """Return data minus predicted data, and priors minus values, in standard deviations.

        places: as `places` gives them [m or rad]; values: all of `names`; residuals shape (count,) [1].
        """
        parts = [(channel.values - places[channel.name][channel.rows]) / channel.errors for channel in self.channels]
        parts.append(np.array([(prior.value - values[name]) / prior.error for name, prior in self.priors.items()]))
        return np.nan_to_num(np.concatenate(parts), nan=FAR, posinf=FAR, neginf=-FAR)


def problem_of(track: Track, hoop: Hoop | str, start: str, plane: Plane, sigma: tuple[float | None, float | None]) -> Problem:
    """Return the problem of a track.

    hoop: the known hoop, or the kind of an unknown one; start: a key of STARTS; plane: gravity and the impact law; sigma:
    standard deviations of places [m] and angles [rad], in place of the track's own.
    """
    radius = hoop.radius if isinstance(hoop, Hoop) else track.radius
    if not (np.isfinite(radius) and radius > 0):
        raise InputError("The radius of the hoop is missing from the data: give --radius, in m, or radius= in a Reading.")
    if isinstance(hoop, Hoop) and np.isfinite(track.radius) and abs(track.radius / radius - 1.0) > SAME:
        raise InputError(
            f"The hoop has the radius {radius:g} m and the data {track.radius:g} m: give the measured one for both."
        )
    channels = channels_of(track, sigma)
    first = min(int(channel.rows[0]) for channel in channels)
    last = max(int(channel.rows[-1]) for channel in channels)
    kept = tuple(channel._replace(rows=channel.rows - first) for channel in channels)
    rows = track.pixel[first : last + 1, 1]
    rowed = bool(np.isfinite(rows).any())
    return Problem(
        track.t[first : last + 1] - track.t[first],
        kept,
        np.nan_to_num(rows - np.nanmean(rows)) if rowed else None,
        float(radius),
        hoop if isinstance(hoop, Hoop) else None,
        hoop == "general",
        start,
        plane,
    )


def shared_errors(track: Track) -> dict[str, Prior]:
    """Priors of scale and plane from a film, whose errors are the same in all frames.

    In contact the height of the centre is R, so an error of the scale moves the plane.

    priors: by parameter; empty if the track is not of a film.
    """
    view, found = track.view, {}
    if view is not None and track.placed:
        height = float(np.hypot(view.height_error, view.scale_error * track.radius))
        found = {"scale": Prior(1.0, view.scale_error), "origin_y": Prior(0.0, height), "tilt": Prior(0.0, view.rise_error)}
        found["slope"] = Prior(track.slope, track.slope_error)
    return {name: prior for name, prior in found.items() if np.isfinite(prior).all() and prior.error > 0}


def defaults(problem: Problem, track: Track) -> tuple[dict[str, float], set[str]]:
    """Return default values of the parameters, and the parameters that are free by default."""
    measured = {channel.name for channel in problem.channels}
    values: dict[str, Any] = {
        "gamma": 0.5, "eccentricity": 0.5, "inertia_ratio": 0.75, "mu_kinetic": 0.5, "mu_excess": 0.05, "restitution": 0.3,
        "slope": float(track.slope) if np.isfinite(track.slope) else 0.0,
        "rolling_resistance": problem.plane.rolling_resistance,
        "x0": 0.0, "angle0": 0.0, "speed": 1.0, "height0": 0.0, "vx0": 1.0, "vy0": 0.0, "omega0": 1.0 / problem.radius,
        "scale": 1.0, "tilt": 0.0, "origin_y": 0.0, "row_delay": 0.0, "marker_angle": 0.0, "marker_ratio": 1.0,
    }  # fmt: skip
    if track.view is not None and np.isfinite(track.view.marker_ratio):
        values["marker_ratio"] = track.view.marker_ratio
    free = {name for name in problem.names if name in ("gamma", "eccentricity", "inertia_ratio", *STARTS[problem.start])}
    free |= {"mu_kinetic", "mu_excess", "restitution"}
    free |= set(shared_errors(track))
    if not track.placed:
        free |= {"tilt", "origin_y"} & set(problem.names)
    if "x" not in measured and "marker_x" not in measured:
        free -= {"x0", "tilt", "origin_y"}
    if "marker_x" in measured:
        free |= {"marker_ratio"}
    return {name: values[name] for name in problem.names}, free
