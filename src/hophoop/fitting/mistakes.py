"""Likely mistakes in data that no motion explains: units, axes, times, the radius, a part that is no free motion."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from operator import itemgetter
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from hophoop.fitting.channels import Channel, Floats, Sigma, Values
from hophoop.fitting.guess import COST, candidates, guess, start_kind
from hophoop.fitting.parameters import FACTORS, SHARED
from hophoop.fitting.problem import Problem, Run, defaults, problem_of, run_of
from hophoop.fitting.solving import Solution, beginnings, free_of, minimize, parameters
from hophoop.scenario import InputError
from hophoop.tracking import Track

if TYPE_CHECKING:
    from lmfit import Parameters

TOP = 4  # greatest values in a row that are equal of a sensor at its limit
CLOSE = tuple(np.arange(0.8, 1.225, 0.05).round(2).tolist())  # factors of the times, or of the radius, near which one is fitted
TIMES = (1e-9, 1e-6, 1e-3, 1 / 8, 1 / 4, 1 / 2, *CLOSE, 2.0, 4.0, 8.0, 1e3, 1e6, 1e9)
UNITS = (0.01, 0.001)  # cm and mm in m
RADII = (0.5, *CLOSE, 2.0, *UNITS)
LENGTHS, DEGREE = ("x", "y", "marker_x", "marker_y"), float(np.radians(1.0))
# Mistakes of one channel, or of two: the channels, the kind, after 'A motion fits ', advice, and factors without the mistake.
PLAIN: Sequence[tuple[set[str], str, str, str, Values]] = (
    ({"x", "y"}, "axes", "with y in the other direction", "does y count downwards? y is the height.", {"y": -1.0}),
    (
        {"x", "y"}, "axes", "with x and y in the other direction", "is the film upside down?",
        {"x": -1.0, "y": -1.0, "zero": np.pi},
    ),
    (
        {"angle"}, "axes", "with the angle in the other direction",
        "the angle counts clockwise if x counts to the right. Does yours?", {"angle": -1.0},
    ),
    ({"angle"}, "units", "with the angle in degrees", "is it in degrees (--unit angle=deg)?", {"angle": DEGREE}),
    (
        {"omega"}, "units", "with angular velocities in degrees per second",
        "give --unit omega=deg/s.", {"omega": DEGREE},
    ),
)  # fmt: skip
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
    """A run without one mistake."""

    kind: str
    words: str  # after 'A motion fits ', with a place for the size
    advice: str
    run: Run
    extra: str = ""  # a parameter that is free in addition
    size: float = 1.0  # the factor of the times, or the radius [m]
    near: bool = False  # whether the fit's values may be near


class Posed(NamedTuple):
    """A trial with its starts."""

    trial: Trial
    problem: Problem
    starts: list[Parameters]
    cost: float  # of the best drawn motion, over the number of data


class Asked(NamedTuple):
    """What the trials have in common."""

    track: Track
    sigma: Sigma  # given standard deviations
    values: Values  # of the fit
    held: Values  # shared parameters that are not free


def _posed(asked: Asked, trial: Trial) -> Iterator[Posed]:
    """Yield a trial with its best drawn motions as starts, if it has any."""
    if trial.run.t[-1] > LONGEST:
        return
    run = replace(trial.run, start=start_kind(trial.run), priors={}, factor=trial.extra if trial.extra in FACTORS else "")
    values, free = defaults(run, asked.track)
    values, free = values | asked.held, (free - asked.held.keys()) | {trial.extra} - {""}
    first = values | {name: value for name, value in guess(run, values).items() if name in free}
    if starts := candidates(run, first, free, draws=DRAWS):
        best = [one.values for one in starts[:STARTED]] + [starts[0].values | asked.values] * trial.near
        params = [parameters(one, sorted(free)) for one in best]
        yield Posed(trial, problem_of([run]), params, starts[0].cost / run.count)


def _fitted(posed: Posed) -> tuple[float, Trial]:
    """Return the cost of the best motion over the degrees of freedom, about 1 where one fits, and the trial with its size."""
    problem, trial = posed.problem, posed.trial
    begun = [one for params in posed.starts for one in beginnings(problem, params, CALLS)]
    best = min((minimize(problem, one, CALLS) for one in begun), key=COST)
    cost = best.cost / max(problem.count - len(free_of(best.params)), 1)
    return cost, trial._replace(size=trial.size * best.values.get(problem.runs[0].factor, 1.0))


def likely_mistakes(
    run: Run, values: Values, free: Sequence[str], cost: float, track: Track, sigma: Sigma
) -> tuple[list[str], list[str]]:
    """Name the mistake that the data show, or without which a motion fits; and what was tried.

    values, free: of the fit of this run; cost: of it, over the degrees of freedom [1]; sigma: given standard deviations.
    """
    omega = run.channel("omega")
    if omega is not None and (limit := _of_limit(run.t[omega.rows], omega.values)):
        return [limit], []
    asked = Asked(track, sigma, values, {name: values[name] for name in run.names if name in SHARED and name not in free})
    trials = _trials(run)
    posed = sorted((one for trial in trials for one in _posed(asked, trial)), key=COST)
    tried = list(dict.fromkeys(trial.kind for trial in trials))
    fitted = []
    for kind in tried:
        likely = [one for one in posed if one.trial.kind == kind]
        fitted += [_fitted(one) for k, one in enumerate(likely) if k < POLISHED or one.trial.near]
    fitted.sort(key=itemgetter(0))
    if fitted and (best := fitted[0][0]) < min(GOOD, cost / BETTER):
        # the best of each kind, and others that the data hardly tell from it
        alike: dict[str, Trial] = {}
        for at, trial in fitted:
            if at <= ALIKE * best:
                alike.setdefault(trial.kind, trial)
        words = " or ".join(trial.words.format(trial.size) for trial in alike.values())
        return [f"A motion fits {words}: {fitted[0][1].advice}"], tried
    if cost < WORSE:
        return [], tried
    return _window(run, asked, min(GOOD, cost / WORSE)), [*tried, "the window"]


def shutter(solution: Solution, tracks: Sequence[Track]) -> list[str]:
    """Name the rolling shutter if the motion is closer to films that were tracked without it, by more than chance."""
    problem, params = solution.problem, solution.minimum.params.copy()
    most = {  # a picture is read before the next one is
        run.named("row_delay"): float(np.median(np.diff(track.t))) / track.view.camera.height
        for run, track in zip(problem.runs, tracks, strict=True)
        if track.view is not None and not track.view.row_delay and run.rows.any()
    }
    if not most:
        return []
    for name, limit in most.items():
        params[name].set(vary=True, min=-limit, max=limit)
    better = minimize(problem, params, CALLS)
    gained = solution.minimum.cost - better.cost
    if gained < CERTAIN * len(most) * problem.spread(better.cost, len(solution.free)):
        return []
    first, limit = next(iter(most.items()))
    if abs(better.values[first]) > NEAR_LIMIT * limit:
        return []
    return [
        "The likely cause is the shutter: the motion is closer with a delay from row to row, of about "
        f"{better.values[first]:.1g} s. Track the film with --row-delay and --exposure, with the numbers of your camera."
    ]


def _of_limit(t: Floats, omega: Floats) -> str:
    """Return what there is to say of a gyroscope at its limit; '' if it is not."""
    top = float(np.abs(omega).max())
    cut = np.abs(omega) > top * (1.0 - 1e-9)
    if not (np.lib.stride_tricks.sliding_window_view(cut, TOP).all(axis=-1)).any():
        return ""
    return (
        f"{int(cut.sum())} values are cut off at the top, at {top:.3g} rad/s ({np.degrees(top):.0f}° per second): the "
        "gyroscope is at its limit. Choose a wider range or a slower run; "
        f"--to {t[int(cut.argmax()) - 1]:.3g} keeps the part before."
    )


def _changed(run: Run, factors: Values) -> Run:
    """Return a run with other channels, radius and times.

    factors: by name of the channel, radius or t; and zero: what angles lose [rad].
    """
    time, size = factors.get("t", 1.0), factors.get("radius", 1.0)

    def channel(one: Channel) -> Channel:
        factor, zero = factors.get(one.name, 1.0), factors.get("zero", 0.0) if one.name == "angle" else 0.0
        # a sensor has a clock of its own; among places an angular velocity comes from their times
        factor /= time if one.name == "omega" and len(run.channels) > 1 else 1.0
        return one._replace(values=factor * one.values - zero, errors=abs(factor) * one.errors)

    hoop = run.hoop if isinstance(run.hoop, str) else run.hoop.model_copy(update={"radius": size * run.radius})
    return replace(run, t=time * run.t, channels=tuple(map(channel, run.channels)), radius=size * run.radius, hoop=hoop)


def _trials(run: Run) -> list[Trial]:
    """Return the run without each usual mistake that its kind of record may have."""
    found = []
    for factor in TIMES:
        slow = (
            "is the film in slow motion? Give the frames per second as taken, hophoop track --rate 240, or correct the times."
        )
        advice = slow if 1e-3 < factor < 0.8 else "are frames per second (--rate) and times right, in s?"
        if SHORTEST < factor * run.t[-1] < LONGEST:
            other = _changed(run, {"t": factor})
            found.append(Trial("times", "with times multiplied by {:.3g}", advice, other, "times", factor, factor == 1.0))
    for factor in RADII:
        advice = "measure the outer radius of the rim." if factor in CLOSE else "is the radius in m, and no diameter?"
        other = _changed(run, {"radius": factor})
        found.append(Trial("the radius", "with a radius of {:.3g} m", advice, other, "radius", other.radius, factor == 1.0))
    if run.measured & set(LENGTHS):
        found.append(Trial("the scale", "with other lengths", "is the scale of lengths right?", run, "scale"))
        for factor in UNITS:
            small, words = dict.fromkeys(LENGTHS, factor), f"with lengths multiplied by {factor:g}"
            units = "are lengths in cm, mm or pixels? Name the columns x (cm), y (cm); the radius is in m."
            both = "is the radius in m, and are lengths in cm or mm?"
            found.append(Trial("units", words, units, _changed(run, small)))
            found.append(Trial("units", f"{words} and the radius, too", both, _changed(run, small | {"radius": factor})))
    if {"x", "y"} <= run.measured:
        names = {"x": "y", "y": "x"}
        other = replace(run, channels=tuple(one._replace(name=names.get(one.name, one.name)) for one in run.channels))
        found.append(Trial("axes", "with x and y exchanged", "is the film sideways, or are x and y exchanged?", other))
    for channels, kind, words, advice, factors in PLAIN:
        if channels <= run.measured:
            found.append(Trial(kind, words, advice, _changed(run, factors)))
    if "angle" in run.measured:
        top = "is your angle zero with the load at the top? A known difference is --fix marker_angle=…, in rad."
        for zero in np.radians(range(45, 360, 45)).tolist():
            other = _changed(run, {"zero": zero})
            found.append(Trial("the zero of the angle", "with another zero of the angle", top, other, "marker_angle"))
    return found


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
            own = run_of(part, run.hoop, run.start, run.plane, asked.sigma)
        except InputError:  # too few data
            return False
        moves = own.count >= NUMBERS and _way(own) >= MOVES
        return moves and any(_fitted(one)[0] < allowed for one in _posed(asked, Trial("", "", "", own)))

    found, before = (0, 0), False
    for first in range(len(places) - PIECE):
        now = free(first, first + PIECE)
        if now and not before:
            last, beyond = first + PIECE, len(places)
            while beyond - last > 1:
                middle = (last + beyond) // 2
                last, beyond = (middle, beyond) if free(first, middle) else (last, middle)
            found = max(found, (first, last), key=lambda ends: ends[1] - ends[0])
        before = now
    first, last = found
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
    found = [float(np.ptp(one.values)) / ways[one.name] for one in run.channels if one.name in ways]
    return max(found or [float(np.abs(one.values).mean()) * float(run.t[-1]) for one in run.channels if one.name == "omega"])
