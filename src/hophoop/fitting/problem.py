"""The fitted problem: from parameters to the exact motion of each run, and its residuals."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.channels import Channel, Sigma, channels_of
from hophoop.fitting.parameters import FACTORS, SHARED, STARTS
from hophoop.scenario import Hoop, InputError, Plane, Scenario, Start
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory
from hophoop.tracking import Track

Floats = NDArray[np.float64]
Values = dict[str, float]

FAR = 1e4  # residual of an impossible motion [standard deviations]
SAME = 1e-6  # relative difference of radii that is rounding
RIM_ERROR = 0.1  # error of the rim's radius that changes along the film [pixel]
BEYOND = 1.0 + 1e-9  # duration of the motion over that of the data


class Prior(NamedTuple):
    """Knowledge of a parameter in addition to the data."""

    value: float  # [the parameter's unit]
    error: float  # its standard deviation


@dataclass(frozen=True, eq=False)
class Run:
    """Data of one motion; parameters complete them to a scenario.

    `values` of its methods are all of its `names`, without suffix.
    """

    t: Floats  # times from the first frame [s]
    channels: tuple[Channel, ...]
    rows: Floats | None  # picture row of the centre, minus the mean [pixel]
    radius: float  # [m]
    hoop: Hoop | None  # if it is known
    general: bool  # a general hoop instead of an ideal one
    start: str  # key of STARTS
    plane: Plane  # gravity and the impact law
    priors: Mapping[str, Prior] = field(default_factory=dict)  # each counts as a measured number
    suffix: str = ""  # of its own parameters, among several runs
    factor: str = ""  # a key of FACTORS that a trial fits as well

    @property
    def names(self) -> tuple[str, ...]:
        """Parameters of this run."""
        hoop = () if self.hoop is not None else ("eccentricity", "inertia_ratio") if self.general else ("gamma",)
        return (
            *hoop, "mu_kinetic", "mu_excess", "restitution", "slope", "rolling_resistance", *STARTS[self.start],
            "scale", "stretch", "tilt", "origin_y", "row_delay", "marker_angle", "marker_ratio",
            *(["omega_offset"] if "omega" in self.measured else []), *([self.factor] if self.factor else []),
        )  # fmt: skip

    @property
    def measured(self) -> set[str]:
        """Names of the channels."""
        return {channel.name for channel in self.channels}

    def named(self, name: str) -> str:
        """Return the name of a parameter of this run in the problem."""
        return name if name in SHARED else name + self.suffix

    def own(self, values: Mapping[str, float]) -> Values:
        """Return the values of this run from those of the problem."""
        return {name: values[self.named(name)] for name in self.names}

    @property
    def count(self) -> int:
        """Number of measured numbers [1]."""
        return sum(len(channel.values) for channel in self.channels) + len(self.priors)

    def until(self, end: float) -> Run:
        """Return the part of a run up to a time [s]."""
        count = max(int(np.searchsorted(self.t, end)), 2)

        def cut(one: Channel) -> Channel:
            kept = one.rows < count
            return one._replace(rows=one.rows[kept], values=one.values[kept], errors=one.errors[kept])

        rows = None if self.rows is None else self.rows[:count]
        return replace(self, t=self.t[:count], rows=rows, channels=tuple(map(cut, self.channels)))

    def scenario(self, values: Values) -> Scenario:
        """Return the scenario of parameters."""
        if self.hoop is not None:
            hoop = self.hoop
        elif self.general:
            hoop = Hoop(radius=self.radius, eccentricity=values["eccentricity"], inertia_ratio=values["inertia_ratio"])
        else:
            hoop = Hoop(radius=self.radius, load_fraction=values["gamma"])
        known = {name: value for name, value in self.plane.to_dict().items() if name != "mu"}
        fitted = {name: values[name] for name in ("slope", "mu_kinetic", "restitution", "rolling_resistance")}
        plane = Plane(**{**known, **fitted, "mu_static": values["mu_kinetic"] + values["mu_excess"]})
        # 'x0' is the field 'x' of a start, and 'speed' the field 'speed'
        start = Start(**{name.removesuffix("0"): values[name] for name in STARTS[self.start]})
        margin = abs(values["row_delay"]) * (float(np.ptp(self.rows)) if self.rows is not None else 0.0)
        duration = float(self.t[-1]) * self.pace(values) * BEYOND + margin
        return Scenario(hoop=hoop, plane=plane, start=start, duration=duration)

    def pace(self, values: Mapping[str, Any]) -> Any:
        """Time of the motion over that of the data [1]: a hoop of another radius moves alike, at times as its root."""
        return values.get("times", 1.0) / np.sqrt(values.get("radius", 1.0))

    def motion(self, values: Values) -> Trajectory:
        """Compute the motion of parameters."""
        return simulate(self.scenario(values))

    def moments(self, motion: Trajectory, values: Values) -> Floats:
        """Times of the motion at which the centre was exposed in each frame, shape (n,) [s]."""
        times = self.t if self.rows is None else self.t + values["row_delay"] * self.rows
        return np.asarray(np.clip(times * self.pace(values), 0.0, motion.duration))

    def places(self, motion: Trajectory, values: Values) -> dict[str, Floats]:
        """Predicted data of a motion in each frame, by name of the channel [m, rad or rad/s]."""
        return self.seen(motion.at(self.moments(motion, values)), values)

    def seen(self, state: Any, values: Values) -> dict[str, Floats]:
        """Predicted data of states (x, height, angle, omega), by name of the channel [m, rad or rad/s]."""
        reach = values["marker_ratio"] * self.radius
        marked = state.angle + values["marker_angle"]
        x, y = state.x * (1.0 + values["stretch"] * state.x), state.height + self.radius
        size = values["scale"] * values.get("radius", 1.0)
        cos, sin = size * np.cos(values["tilt"]), size * np.sin(values["tilt"])

        def rotate(a: Floats, b: Floats) -> tuple[Floats, Floats]:
            return cos * a - sin * b, values["origin_y"] + sin * a + cos * b

        first, second = rotate(x, y)
        third, fourth = rotate(x + reach * np.sin(marked), y + reach * np.cos(marked))
        # a sensor has a clock of its own; among places an angular velocity comes from their times
        pace = self.pace(values) if len(self.channels) > 1 else self.pace(values) / values.get("times", 1.0)
        omega = pace * state.omega + values.get("omega_offset", 0.0)
        return {
            "x": first,
            "y": second,
            "marker_x": third,
            "marker_y": fourth,
            "angle": marked - values["tilt"],
            "omega": omega,
        }

    def residuals(self, values: Values) -> Floats:
        """Return data minus motion, shape (count,) [standard deviations]."""
        try:
            motion = self.motion(values)
        except InputError:
            return np.full(self.count, FAR)
        return self.distances(self.places(motion, values), values)

    def distances(self, places: dict[str, Floats], values: Values) -> Floats:
        """Return data minus predicted data, and priors minus values, shape (count,) [standard deviations]."""
        parts = [(channel.values - places[channel.name][..., channel.rows]) / channel.errors for channel in self.channels]
        parts += [np.atleast_1d((prior.value - values[name]) / prior.error) for name, prior in self.priors.items()]
        return np.nan_to_num(np.concatenate(parts, axis=-1), nan=FAR, posinf=FAR, neginf=-FAR)


class Piece(NamedTuple):
    """The residuals of one channel of one run, among all."""

    run: int
    channel: Channel
    part: slice


@dataclass(frozen=True, eq=False)
class Problem:
    """One run, or several runs of one hoop on one plane; `values` are all of `names`."""

    runs: tuple[Run, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Parameters of this problem, with the number of the run if there are several."""
        return tuple(dict.fromkeys(run.named(name) for run in self.runs for name in run.names))

    @property
    def count(self) -> int:
        """Number of measured numbers [1]."""
        return sum(run.count for run in self.runs)

    @property
    def pieces(self) -> Iterator[Piece]:
        """The residuals, channel by channel."""
        begin = 0
        for k, run in enumerate(self.runs):
            for channel in run.channels:
                yield Piece(k, channel, slice(begin, begin + len(channel.rows)))
                begin += len(channel.rows)
            begin += len(run.priors)

    @property
    def priors(self) -> dict[str, Prior]:
        """Priors of all runs."""
        return {run.named(name): prior for run in self.runs for name, prior in run.priors.items()}

    def motions(self, values: Mapping[str, float]) -> list[Trajectory]:
        """Compute the motion of each run."""
        return [run.motion(run.own(values)) for run in self.runs]

    def residuals(self, values: Mapping[str, float]) -> Floats:
        """Return data minus motions, run after run, shape (count,) [standard deviations]."""
        return np.concatenate([run.residuals(run.own(values)) for run in self.runs])


def run_of(track: Track, hoop: Hoop | str, start: str, plane: Plane, sigma: Sigma) -> Run:
    """Return the run of a track.

    hoop: the known hoop, or the kind of an unknown one; start: a key of STARTS; plane: gravity and the impact law; sigma:
    standard deviations in place of the track's own.
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
    rows = track.pixel[first : last + 1, 1]
    return Run(
        t=track.t[first : last + 1] - track.t[first],
        channels=tuple(channel._replace(rows=channel.rows - first) for channel in channels),
        rows=np.nan_to_num(rows - np.nanmean(rows)) if np.isfinite(rows).any() else None,
        radius=float(radius),
        hoop=hoop if isinstance(hoop, Hoop) else None,
        general=hoop == "general",
        start=start,
        plane=plane,
    )


def problem_of(runs: list[Run]) -> Problem:
    """Return the problem of some runs; of several each has its number as a suffix."""
    if len(runs) == 1:
        return Problem((replace(runs[0], suffix=""),))
    return Problem(tuple(replace(run, suffix=f"_{k}") for k, run in enumerate(runs, 1)))


def shared_errors(track: Track) -> dict[str, Prior]:
    """Priors of scale and plane from a film, whose errors are the same in all frames.

    In contact the height of the centre is R, so an error of the scale moves the plane.

    priors: by parameter; empty if the track is not of a film.
    """
    view, found = track.view, {}
    if view is not None and track.placed:
        height = float(np.hypot(view.height_error, view.scale_error * track.radius))
        # the tilt of the plane of motion is found from sizes of the rim
        stretch = RIM_ERROR / (view.scale * track.radius * float(np.nanmax(track.centre[:, 0]) - np.nanmin(track.centre[:, 0])))
        found = {
            "stretch": Prior(0.0, stretch),
            "scale": Prior(1.0, view.scale_error),
            "origin_y": Prior(0.0, height),
            "tilt": Prior(0.0, view.rise_error),
        }
        found["slope"] = Prior(track.slope, track.slope_error)
    return {name: prior for name, prior in found.items() if np.isfinite(prior).all() and prior.error > 0}


def defaults(run: Run, track: Track) -> tuple[Values, set[str]]:
    """Return default values of a run's parameters, and those that are free by default."""
    values: dict[str, Any] = dict.fromkeys(run.names, 0.0) | {
        "gamma": 0.5, "eccentricity": 0.5, "inertia_ratio": 0.75, "mu_kinetic": 0.5, "mu_excess": 0.05, "restitution": 0.3,
        "slope": float(track.slope) if np.isfinite(track.slope) else 0.0,
        "rolling_resistance": run.plane.rolling_resistance,
        "speed": 1.0, "vx0": 1.0, "omega0": 1.0 / run.radius, "scale": 1.0, "marker_ratio": 1.0,
        **dict.fromkeys(FACTORS, 1.0),
    }  # fmt: skip
    if track.view is not None and np.isfinite(track.view.marker_ratio):
        values["marker_ratio"] = track.view.marker_ratio
    free = {"gamma", "eccentricity", "inertia_ratio", "mu_kinetic", "mu_excess", "restitution", *STARTS[run.start]}
    free |= {"omega_offset", run.factor, *shared_errors(track)}
    if not track.placed:
        free |= {"tilt", "origin_y"}
    if not run.measured & {"x", "marker_x"}:
        free -= {"x0", "tilt", "origin_y"}
    if "marker_x" in run.measured:
        free |= {"marker_ratio"}
    return {name: values[name] for name in run.names}, free & set(run.names)
