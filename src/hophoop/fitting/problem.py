"""The fitted problem: from parameters to the exact motion of each run, and its residuals."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

import numpy as np

from hophoop.fitting.channels import Channel, Floats, Values, channels_of
from hophoop.fitting.losses import loss
from hophoop.fitting.parameters import HOOPS, SHARED, STARTS, spec
from hophoop.scenario import Hoop, InputError, Plane, Scenario, Start
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory
from hophoop.tracking import Track

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

    first: int  # row of the track with the first data
    t: Floats  # times from there on [s]
    channels: tuple[Channel, ...]
    rows: Floats  # picture row of the centre, minus the mean; 0 if unknown [pixel]
    radius: float  # [m]
    hoop: Hoop | str  # known, or a key of HOOPS
    start: str  # key of STARTS
    plane: Plane  # gravity and the impact law
    priors: Mapping[str, Prior] = field(default_factory=dict)  # each counts as a measured number
    suffix: str = ""  # of its own parameters, among several runs
    factor: str = ""  # a key of FACTORS that a trial fits as well

    @property
    def names(self) -> tuple[str, ...]:
        """Parameters of this run."""
        hoop = HOOPS[self.hoop] if isinstance(self.hoop, str) else ()
        return (
            *hoop, "mu_kinetic", "mu_excess", "restitution", "slope", "rolling_resistance", *STARTS[self.start],
            "scale", "stretch", "tilt", "origin_y", "row_delay", "marker_angle", "marker_ratio",
            *(["omega_offset"] if "omega" in self.measured else []), *([self.factor] if self.factor else []),
        )  # fmt: skip

    @property
    def measured(self) -> set[str]:
        """Names of the channels."""
        return {channel.name for channel in self.channels}

    def channel(self, name: str) -> Channel | None:
        """Return a channel; None if it was not measured."""
        return next((one for one in self.channels if one.name == name), None)

    def named(self, name: str) -> str:
        """Return the name of a parameter of this run in the problem."""
        return name if name in SHARED else name + self.suffix

    def own(self, values: Values) -> Values:
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

        return replace(self, t=self.t[:count], rows=self.rows[:count], channels=tuple(map(cut, self.channels)))

    def scenario(self, values: Values) -> Scenario:
        """Return the scenario of parameters."""
        known = self.plane.model_dump(include={"gravity", "impact_law", "painleve"})
        parts: dict[str, dict[str, Any]] = {"hoop": {"radius": self.radius}, "plane": known, "start": {}}
        for name in self.names:
            for path in spec(name).paths:
                part, number = path.split(".")
                parts[part][number] = parts[part].get(number, 0.0) + values[name]
        hoop = self.hoop if isinstance(self.hoop, Hoop) else Hoop(**parts["hoop"])
        duration = float(self.t[-1]) * self.pace(values) * BEYOND + abs(values["row_delay"]) * float(np.ptp(self.rows))
        return Scenario(hoop=hoop, plane=Plane(**parts["plane"]), start=Start(**parts["start"]), duration=duration)

    def pace(self, values: Mapping[str, Any]) -> Any:
        """Time of the motion over that of the data [1]: a hoop of another radius moves alike, at times as its root."""
        return values.get("times", 1.0) / np.sqrt(values.get("radius", 1.0))

    def motion(self, values: Values) -> Trajectory:
        """Compute the motion of parameters."""
        return simulate(self.scenario(values))

    def moments(self, motion: Trajectory, values: Values) -> Floats:
        """Times of the motion at which the centre was exposed in each frame, shape (n,) [s]."""
        times = (self.t + values["row_delay"] * self.rows) * self.pace(values)
        return np.asarray(np.clip(times, 0.0, motion.duration))

    def places(self, motion: Trajectory, values: Values) -> dict[str, Floats]:
        """Predicted data of a motion in each frame, by name of the channel [m, rad or rad/s]."""
        return self.seen(motion.at(self.moments(motion, values)), values)

    def seen(self, state: Any, values: Values) -> dict[str, Floats]:
        """Predicted data of states (x, height, angle, omega), by name of the channel [m, rad or rad/s]."""
        marked = state.angle + values["marker_angle"]
        # a sensor has a clock of its own; among places an angular velocity comes from their times
        pace = self.pace(values) / (1.0 if len(self.channels) > 1 else values.get("times", 1.0))
        result = {"angle": marked - values["tilt"], "omega": pace * state.omega + values.get("omega_offset", 0.0)}
        # places are complex: x and y
        centre = state.x * (1.0 + values["stretch"] * state.x) + 1j * (state.height + self.radius)
        arm = values["marker_ratio"] * self.radius * (np.sin(marked) + 1j * np.cos(marked))
        axes = values["scale"] * values.get("radius", 1.0) * np.exp(1j * values["tilt"])
        for mark, place in (("", axes * centre), ("marker_", axes * (centre + arm))):
            result |= {f"{mark}x": place.real, f"{mark}y": values["origin_y"] + place.imag}
        return result

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
    robust: bool = True  # outliers count less

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
    def jumps(self) -> bool:
        """True with an angular velocity, which jumps at an impact: where that passes a value, the sum of squares has a step."""
        return any("omega" in run.measured for run in self.runs)

    @property
    def priors(self) -> dict[str, Prior]:
        """Priors of all runs."""
        return {run.named(name): prior for run in self.runs for name, prior in run.priors.items()}

    def motions(self, values: Values) -> list[Trajectory]:
        """Compute the motion of each run."""
        return [run.motion(run.own(values)) for run in self.runs]

    def sequence(self, values: Values) -> str:
        """Return the sequence of each run, bounces in a row as one 'H+'."""
        return ", ".join(merge_bounces(motion.sequence) for motion in self.motions(values))

    def residuals(self, values: Values) -> Floats:
        """Return data minus motions, run after run, shape (count,) [standard deviations]."""
        return np.concatenate([run.residuals(run.own(values)) for run in self.runs])

    def cost(self, values: Values) -> float:
        """Return the sum of squares, or the robust loss."""
        return loss(self.residuals(values), self.robust)

    def spread(self, cost: float, free: int) -> float:
        """Return the sum of squares over the degrees of freedom, at least 1."""
        return max(1.0, cost / max(self.count - free, 1))


def merge_bounces(sequence: str) -> str:
    """Merge bounces in a row into one 'H+': their number depends on the last digit."""
    return re.sub("HH+", "H+", sequence)


def run_of(track: Track, hoop: Hoop | str, start: str, plane: Plane) -> Run:
    """Return the run of a track.

    hoop: the known hoop, or the kind of an unknown one; start: a key of STARTS; plane: gravity and the impact law.
    """
    radius = track.radius
    if isinstance(hoop, Hoop):
        radius = hoop.radius
        if abs(track.radius / radius - 1.0) > SAME:
            raise InputError(
                f"The hoop has the radius {radius:g} m and the data {track.radius:g} m: give the measured one for both."
            )
    if not 0.0 < radius < np.inf:
        raise InputError("The radius of the hoop is missing from the data: give --radius, in m, or radius= in a Reading.")
    channels = channels_of(track)
    used = np.concatenate([channel.rows for channel in channels])
    first, last = int(used.min()), int(used.max())
    t, rows = track.t[first : last + 1], track.pixel[first : last + 1, 1]
    return Run(
        first=first,
        t=t - t[0],
        channels=tuple(channel._replace(rows=channel.rows - first) for channel in channels),
        rows=np.nan_to_num(rows - np.nanmean(rows)) if np.isfinite(rows).any() else np.zeros_like(t),
        radius=float(radius),
        hoop=hoop,
        start=start,
        plane=plane,
    )


def problem_of(runs: Sequence[Run], robust: bool = True) -> Problem:
    """Return the problem of some runs; of several each has its number as a suffix."""
    return Problem(tuple(replace(run, suffix=f"_{k}" * (len(runs) > 1)) for k, run in enumerate(runs, 1)), robust)


def shared_errors(track: Track) -> dict[str, Prior]:
    """Priors of scale and plane from a film, whose errors are the same in all frames.

    In contact the height of the centre is R, so an error of the scale moves the plane.

    priors: by parameter; empty if the track is not of a film.
    """
    view = track.view
    if view is None or not track.placed:
        return {}
    height = np.hypot(view.height_error, view.scale_error * track.radius)
    # the tilt of the plane of motion is found from sizes of the rim
    way = np.nanmax(track.centre[:, 0]) - np.nanmin(track.centre[:, 0])
    found = {
        "stretch": Prior(0.0, RIM_ERROR / (view.scale * track.radius * way)),
        "scale": Prior(1.0, view.scale_error),
        "origin_y": Prior(0.0, height),
        "tilt": Prior(0.0, view.rise_error),
        "slope": Prior(track.slope, track.slope_error),
    }
    return {name: prior for name, prior in found.items() if np.isfinite(prior).all() and prior.error > 0}


def defaults(run: Run, track: Track) -> tuple[Values, set[str]]:
    """Return default values of a run's parameters, and those that are free by default."""
    values = {name: spec(name).usual for name in run.names}
    known = {"slope": track.slope, "marker_ratio": track.view.marker_ratio if track.view is not None else np.nan}
    known |= {"rolling_resistance": run.plane.rolling_resistance, "omega0": 1.0 / run.radius}
    values |= {name: float(value) for name, value in known.items() if name in values and np.isfinite(value)}
    free = {*SHARED, *STARTS[run.start], "omega_offset", run.factor, *shared_errors(track)} - {"rolling_resistance"}
    if not track.placed:
        free |= {"tilt", "origin_y"}
    if not run.measured & {"x", "marker_x"}:
        free -= {"x0", "tilt", "origin_y"}
    if "marker_x" in run.measured:
        free |= {"marker_ratio"}
    return values, free & set(values)
