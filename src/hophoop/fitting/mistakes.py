"""Likely mistakes in data that no motion explains: units, axes, times, the radius, a part that is no free motion."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hophoop.fitting.channels import Channel, Values
from hophoop.fitting.guess import COST, candidates, guess, start_kind
from hophoop.fitting.parameters import FACTORS, SHARED
from hophoop.fitting.problem import Problem, Run, defaults, problem_of, run_of
from hophoop.fitting.solving import Solution, beginnings, changed, free_of, minimize, parameters
from hophoop.scenario import InputError
from hophoop.tracking import Track

if TYPE_CHECKING:
    from lmfit import Parameters

TOP = 4  # greatest values in a row that are equal of a sensor at its limit
CLOSE = tuple(np.arange(0.8, 1.225, 0.05).round(2).tolist())  # factors of the times, or of the radius, near which one is fitted
TIMES = (1e-9, 1e-6, 1e-3, 1 / 8, 1 / 4, 1 / 2, *CLOSE, 2.0, 4.0, 8.0, 1e3, 1e6, 1e9)
UNITS = (0.01, 0.001, 0.0254)  # cm, mm and inches in m
RADII = (0.5, *CLOSE, 2.0, *UNITS)
LENGTHS, DEGREE = ("x", "y", "marker_x", "marker_y"), float(np.radians(1.0))
ANY = (*LENGTHS, "angle", "omega")
DRAWS = 24  # motions of a trial
POLISHED, STARTED, CALLS = 2, 2, 30  # trials of each kind that are minimized, starts of each, and calls of the motion
GOOD = 4.0  # cost over the degrees of freedom of a motion that fits after so few calls
BETTER = 2.0  # times the cost of the best, at least, of the fit
ALIKE = 3.0  # times the cost of the best, of others that are named as well
WORSE = 20.0  # times the cost of a window, of the whole record
SHORTEST, LONGEST = 0.05, 30.0  # motion that is tried [s]
PARTS, PIECE = 20, 4  # steps of a record in which its window is found, and of the first piece of one
WIDEST, MOST_PARTS = 0.2, 50  # step of a longer record, whose free motion takes 1 s [s]; its most steps
NUMBERS = 40  # minimum number of data of a window
MOVES = 1.0  # minimum way of the hoop in a window, over the radius
CERTAIN = 9.0  # fall of the sum of squares that is more than chance: three standard deviations
NEAR_LIMIT = 0.99  # a delay that ends there fits something else


class Trial(NamedTuple):
    """A usual mistake of records that have one of some channels, and how a record is without it."""

    channels: Sequence[str]
    kind: str
    words: str  # after 'A motion fits ', with places for what is fitted, as in the advice
    advice: str
    factors: Mapping[str, float] = {}  # of channels, times and radius; and the zero of the angle [rad]
    extra: str = ""  # a parameter that is free in addition
    names: Mapping[str, str] = {}  # of channels that have others' names
    start: str = ""  # how the hoop moves in the first frame, if not as the data show it
    calls: int = CALLS  # of the motion, at most


TRIALS = (
    *(
        Trial(
            ANY, "times", "with times multiplied by {times:.3g}",
            "is the film in slow motion? Give the frames per second as taken, hophoop track --rate 240, or correct the times."
            if 1e-3 < factor < 0.8 else "are frames per second (--rate) and times right, in s?",
            {"times": factor}, "times",
        )
        for factor in TIMES
    ),
    *(
        Trial(
            ANY, "the radius", "with a radius of {radius:.3g} m",
            "measure the outer radius of the rim." if factor in CLOSE else "is the radius in m, and no diameter?",
            {"radius": factor}, "radius",
        )
        for factor in RADII
    ),
    Trial(
        LENGTHS, "the scale", "with lengths divided by {scale:.3g}", "is the scale of lengths right? --free scale fits it.",
        extra="scale",
    ),
    *(
        Trial(LENGTHS, "units", f"with lengths multiplied by {factor:g}{also}", advice, dict.fromkeys(names, factor))
        for factor in UNITS
        for names, also, advice in (
            (LENGTHS, "", "are lengths in cm, mm, inches or pixels? Name the columns x (cm), y (cm); the radius is in m."),
            ((*LENGTHS, "radius"), " and the radius, too", "is the radius in m, and are lengths in cm, mm or inches?"),
        )
    ),
    Trial(
        ("x",), "axes", "with x and y exchanged", "is the film sideways, or are x and y exchanged?",
        names={"x": "y", "y": "x"},
    ),
    Trial(
        ("x",), "the point", "with x and y as those of the marker", "name their columns marker x and marker y.",
        names={"x": "marker_x", "y": "marker_y"}, calls=100,
    ),
    Trial(ANY, "the start", "with slip in the first frame", "give --start sliding.", start="sliding"),
    Trial(("x",), "axes", "with y in the other direction", "does y count downwards? y is the height.", {"y": -1.0}),
    Trial(
        ("x",), "axes", "with x and y in the other direction", "is the film upside down?",
        {"x": -1.0, "y": -1.0, "zero of angle": np.pi},
    ),
    Trial(
        ("angle",), "axes", "with the angle in the other direction",
        "the angle counts clockwise if x counts to the right. Does yours?", {"angle": -1.0},
    ),
    Trial(("angle",), "units", "with the angle in degrees", "is it in degrees (--unit angle=deg)?", {"angle": DEGREE}),
    Trial(("omega",), "units", "with angular velocities in degrees per second", "give --unit omega=deg/s.", {"omega": DEGREE}),
    *(
        Trial(
            ("angle",), "the zero of the angle", "with another zero of the angle",
            "is your angle zero with the load at the top? If not, give --fix marker_angle={zero:.4g}, in rad.",
            {"zero of angle": zero}, "marker_angle",
        )
        for zero in np.radians(range(45, 360, 45)).tolist()
    ),
)  # fmt: skip
AS_IT_IS = Trial(ANY, "", "", "")


class Asked(NamedTuple):
    """What the trials have in common."""

    track: Track
    values: Values  # of the fit
    held: Values  # shared parameters that are not free


class Posed(NamedTuple):
    """A record without a mistake, with its starts."""

    trial: Trial
    near: bool  # whether the fit's values may be near
    problem: Problem
    starts: list[Parameters]
    cost: float  # of the best drawn motion, over the number of data


def _posed(asked: Asked, run: Run, trial: Trial) -> Iterator[Posed]:
    """Yield a record without a mistake with its best drawn motions as starts, if it has any."""
    run = _without(run, trial)
    if not SHORTEST < run.t[-1] < LONGEST:
        return
    run = replace(run, start=trial.start or start_kind(run), priors={}, factor=trial.extra if trial.extra in FACTORS else "")
    values, free = defaults(run, asked.track)
    values, free = values | asked.held, (free - asked.held.keys()) | {trial.extra} - {""}
    if starts := candidates(run, guess(run, values, free), free, draws=DRAWS):
        near = 1.0 in trial.factors.values()
        best = [one.values for one in starts[:STARTED]] + [starts[0].values | asked.values] * near
        params = [parameters(one, sorted(free)) for one in best]
        yield Posed(trial, near, problem_of([run]), params, starts[0].cost / run.count)


def _fitted(posed: Posed) -> tuple[float, Trial]:
    """Return the cost of the best motion over the degrees of freedom, about 1 where one fits, and the trial in words."""
    problem, trial = posed.problem, posed.trial
    begun = [one for params in posed.starts for one in beginnings(problem, params, trial.calls)]
    best = min((minimize(problem, one, trial.calls) for one in begun), key=COST)
    cost, values, extra = best.cost / max(problem.count - len(free_of(best.params)), 1), best.values, trial.extra
    if cost < GOOD and extra in (*FACTORS, "scale"):
        right = changed(best.params, {extra: 1.0 / trial.factors.get(extra, 1.0)}, [extra])
        if minimize(problem, right, trial.calls).cost < BETTER * best.cost:
            return np.inf, trial  # a factor of 1 is no mistake
    found = {
        "times": trial.factors.get("times", 1.0) * values.get("times", 1.0),
        "radius": problem.runs[0].radius * values.get("radius", 1.0),
        "scale": values["scale"],
        "zero": np.angle(np.exp(1j * (trial.factors.get("zero of angle", 0.0) + values["marker_angle"]))),
    }
    return cost, trial._replace(words=trial.words.format(**found), advice=trial.advice.format(**found))


def likely_mistakes(run: Run, values: Values, free: Sequence[str], cost: float, track: Track) -> tuple[list[str], list[str]]:
    """Name the mistake that the data show, or without which a motion fits; and what was tried.

    values, free: of the fit of this run; cost: of it, over the degrees of freedom [1].
    """
    if limit := _of_limit(run):
        return limit, []
    asked = Asked(track, values, {name: values[name] for name in run.names if name in SHARED and name not in free})
    trials = [trial for trial in TRIALS if run.measured & {*trial.channels} and trial.start != run.start]
    posed = sorted((one for trial in trials for one in _posed(asked, run, trial)), key=COST)
    tried = list(dict.fromkeys(trial.kind for trial in trials))
    fitted = []
    for kind in tried:
        likely = [one for one in posed if one.trial.kind == kind]
        fitted += [_fitted(one) for k, one in enumerate(likely) if k < POLISHED or one.near]
    fitted.sort(key=itemgetter(0))
    if fitted and (best := fitted[0][0]) < min(GOOD, cost / BETTER):
        # the best of each kind, and others that the data hardly tell from it
        alike: dict[str, str] = {}
        for at, trial in fitted:
            if at <= ALIKE * best:
                alike.setdefault(trial.kind, trial.words)
        return [f"A motion fits {' or '.join(alike.values())}: {fitted[0][1].advice}"], tried
    if cost < WORSE:
        return [], tried
    return _window(run, asked, min(GOOD, cost / WORSE)), [*tried, "the window"]


def shutter(solution: Solution, tracks: Sequence[Track]) -> list[str]:
    """Name the rolling shutter if the motion is closer to films that were tracked without it, by more than chance."""
    problem, params = solution.problem, solution.minimum.params.copy()
    most = {  # a picture is read before the next one is
        run.named("row_delay"): np.median(np.diff(track.t)) / track.view.camera.height
        for run, track in zip(problem.runs, tracks, strict=True)
        if track.view is not None and not track.view.row_delay and run.rows.any()
    }
    if not most:
        return []
    for name, limit in most.items():
        params[name].set(vary=True, min=-limit, max=limit)
    better = minimize(problem, params, CALLS)
    gained = solution.minimum.cost - better.cost
    name, limit = next(iter(most.items()))
    delay, chance = better.values[name], len(most) * problem.spread(better.cost, len(solution.free))
    if gained < CERTAIN * chance or abs(delay) > NEAR_LIMIT * limit:
        return []
    return [
        "The likely cause is the shutter: the motion is closer with a delay from row to row, of about "
        f"{delay:.1g} s. Track the film with --row-delay and --exposure, with the numbers of your camera."
    ]


def _of_limit(run: Run) -> list[str]:
    """Say where a gyroscope is at its limit."""
    omega = run.channel("omega")
    if omega is None:
        return []
    size = np.abs(omega.values)
    cut = size > size.max() * (1.0 - 1e-9)
    if not np.lib.stride_tricks.sliding_window_view(cut, TOP).all(axis=-1).any():
        return []
    return [
        f"{cut.sum()} values are cut off at the top, at {size.max():.3g} rad/s ({np.degrees(size.max()):.0f}° per second): the "
        "gyroscope is at its limit. Choose a wider range or a slower run; "
        f"--to {run.t[omega.rows[cut.argmax() - 1]]:.3g} keeps the part before."
    ]


def _without(run: Run, trial: Trial) -> Run:
    """Return a run without a mistake."""
    factors = {"times": 1.0, "radius": 1.0, **trial.factors}
    time, radius = factors["times"], factors["radius"] * run.radius

    def channel(one: Channel) -> Channel:
        # a sensor has a clock of its own; among places an angular velocity comes from their times
        factor = factors.get(one.name, 1.0) / (time if one.name == "omega" and len(run.channels) > 1 else 1.0)
        values = factor * one.values - factors.get(f"zero of {one.name}", 0.0)
        return one._replace(name=trial.names.get(one.name, one.name), values=values, errors=abs(factor) * one.errors)

    hoop = run.hoop if isinstance(run.hoop, str) else run.hoop.model_copy(update={"radius": radius})
    return replace(run, t=time * run.t, channels=tuple(map(channel, run.channels)), radius=radius, hoop=hoop)


def _window(run: Run, asked: Asked, allowed: float) -> list[str]:
    """Name the longest part of the data that is free motion, such as between a hand and a catch.

    allowed: cost over the degrees of freedom [1].
    """
    begin, end = asked.track.t[[0, -1]].tolist()
    step = 0.1 * np.ceil(max(min((end - begin) / PARTS, WIDEST), (end - begin) / MOST_PARTS) / 0.1)
    places = [*np.arange(begin, end - 0.5 * step, step).tolist(), end]

    def free(first: int, last: int) -> bool:
        part = asked.track.between(places[first] - 1e-9, places[last] + 1e-9)
        try:
            own = run_of(part, run.hoop, run.start, run.plane)
        except InputError:  # too few data
            return False
        moves = own.count >= NUMBERS and _way(own) >= MOVES
        return moves and any(_fitted(one)[0] < allowed for one in _posed(asked, own, AS_IT_IS))

    first, last, before = 0, 0, False
    for one in range(len(places) - PIECE):
        now = free(one, one + PIECE)
        if now and not before:
            beyond = bisect_left(range(len(places)), True, one + PIECE + 1, key=lambda end: not free(one, end))
            first, last = max((first, last), (one, beyond - 1), key=lambda ends: ends[1] - ends[0])
        before = now
    options = {"first": f"--from {places[first]:.3g}"} if first else {}
    if 0 < last < len(places) - 1:
        options["last"] = f"--to {places[last]:.3g}"
    if not options:
        return []
    where = f"The {' and the '.join(options)} part {'is' if len(options) == 1 else 'are'}"
    return [f"{where} no free motion (a hand, a catch, a wall?), but the rest fits one: give {' '.join(options.values())}."]


def _way(run: Run) -> float:
    """Distance of the hoop over the radius, or its rotation [1]."""
    ways = {"x": run.radius, "marker_x": run.radius, "angle": 1.0}
    found = [np.ptp(one.values) / ways[one.name] for one in run.channels if one.name in ways]
    return max(found, default=float(np.abs(run.channels[0].values).mean() * run.t[-1]))  # of a phone
