"""Likely mistakes in data that no motion explains: units, axes, times, the radius, a part that is no free motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.channels import Channel, Sigma
from hophoop.fitting.guess import Candidate, candidates, guess, start_kind
from hophoop.fitting.parameters import FACTORS, SHARED, spec
from hophoop.fitting.problem import Problem, Run, defaults, problem_of, run_of
from hophoop.fitting.solving import Solution, beginnings, minimize, parameters, spread_of
from hophoop.scenario import InputError
from hophoop.tracking import Track

Floats = NDArray[np.float64]

TOP = 4  # greatest values in a row that are equal of a sensor at its limit
CLOSE = tuple(np.arange(0.8, 1.225, 0.05).round(2).tolist())  # factors of the times, or of the radius, near which one is fitted
TIMES = (1e-9, 1e-6, 1e-3, 1 / 8, 1 / 4, 1 / 2, *CLOSE, 2.0, 4.0, 8.0, 1e3, 1e6, 1e9)
SIZES = (0.5, *CLOSE, 2.0)
UNITS = (0.01, 0.001)  # cm and mm in m
DRAWS = 24  # motions of a trial
POLISHED, STARTED, CALLS = 2, 2, 30  # trials of each kind that are minimized, starts of each, and calls of the motion
GOOD = 4.0  # cost over the number of data of a motion that fits after so few calls
ALIKE = 3.0  # times the cost of the best, of others that are named as well
WORSE = 20.0  # times the cost of a window, of the whole record
SHORTEST, LONGEST = 0.05, 30.0  # motion that is tried [s]
PARTS, PIECE = 20, 4  # steps of a record in which its window is found, and of the first piece of one
NUMBERS = 40  # minimum number of data of a window
MOVES = 1.0  # minimum way of the hoop in a window, over the radius
CERTAIN = 9.0  # fall of the sum of squares that is more than chance: three standard deviations


class Trial(NamedTuple):
    """A run without one mistake."""

    kind: str
    words: str  # after 'A motion fits ', with a place for the size
    advice: str
    run: Run
    extra: str = ""  # a parameter that is free in addition
    size: float = 1.0  # the factor of the times, or the radius [m]
    near: bool = False  # whether the fit's values may be near


class Asked(NamedTuple):
    """What the trials have in common."""

    track: Track
    sigma: Sigma  # given standard deviations
    values: dict[str, float]  # of the fit
    held: dict[str, float]  # shared parameters that are not free

    def starts(self, trial: Trial) -> tuple[Run, list[str], list[Candidate]]:
        """Return the run of a trial, its free parameters, and drawn motions, the best first."""
        if trial.run.t[-1] > LONGEST:
            return trial.run, [], []
        run = replace(trial.run, start=start_kind(trial.run), priors={}, factor=trial.extra if trial.extra in FACTORS else "")
        values, free = defaults(run, self.track)
        values, free = values | self.held, (free - self.held.keys()) | {trial.extra} - {""}
        first = values | {name: value for name, value in guess(run, values).items() if name in free}
        return run, sorted(free), candidates(run, first, free, draws=DRAWS)

    def drawn(self, trial: Trial) -> float:
        """Return the cost of the best drawn motion over the number of data [1]."""
        run, _, starts = self.starts(trial)
        return starts[0].cost / run.count if starts else np.inf

    def fitted(self, trial: Trial) -> tuple[float, Trial]:
        """Return the cost of the best motion over the number of data, about 1 where a motion fits, and the trial's size."""
        run, free, starts = self.starts(trial)
        first = [one.values for one in starts[:STARTED]]
        if starts and trial.near:
            first.append(first[0] | self.values)
        problem = problem_of([run])
        params = [one for values in first for one in beginnings(problem, parameters(values, free), True, CALLS)]
        found = [minimize(problem, one, True, CALLS) for one in params]
        if not found:
            return np.inf, trial
        best = min(found, key=lambda one: one.cost)
        return best.cost / run.count, trial._replace(size=trial.size * best.values.get(run.factor, 1.0))


def likely_mistakes(
    run: Run, values: dict[str, float], free: Sequence[str], cost: float, track: Track, sigma: Sigma
) -> tuple[list[str], list[str]]:
    """Name the mistake that the data show, or without which a motion fits; and what was tried.

    values, free: of the fit of this run; cost: of it, over the number of data [1]; sigma: given standard deviations.
    """
    asked = Asked(track, sigma, values, {name: values[name] for name in run.names if name in SHARED and name not in free})
    if limit := next(
        (said for one in run.channels if one.name == "omega" and (said := _of_limit(run.t[one.rows], one.values))), ""
    ):
        return [limit], []
    trials = _trials(run)
    drawn = sorted(((asked.drawn(trial), trial) for trial in trials), key=lambda pair: pair[0])
    tried = list(dict.fromkeys(one.kind for one in trials))
    costs = []
    for kind in tried:
        likely = [trial for at, trial in drawn if trial.kind == kind and at < np.inf]
        costs += [asked.fitted(trial) for k, trial in enumerate(likely) if k < POLISHED or trial.near]
    costs.sort(key=lambda pair: pair[0])
    best = costs[0][0] if costs else np.inf
    if best < min(GOOD, cost / ALIKE):
        # the best of each kind, and others that the data hardly tell from it
        alike = {one.kind: one for at, one in reversed(costs) if at <= ALIKE * best}
        first, *others = sorted(alike.values(), key=[one for _, one in costs].index)
        words = " or ".join(one.words.format(one.size) for one in (first, *others))
        return [f"A motion fits {words}: {first.advice}"], tried
    if cost < WORSE:
        return [], tried
    return _window(run, asked, min(GOOD, cost / WORSE)), [*tried, "the window"]


def shutter(problem: Problem, solution: Solution, tracks: Sequence[Track], robust: bool) -> list[str]:
    """Name the rolling shutter if the motion is closer to films that were tracked without it, by more than chance."""
    params = solution.minimum.params.copy()
    names = [
        run.named("row_delay")
        for run, track in zip(problem.runs, tracks, strict=True)
        if track.view is not None and not track.view.row_delay and run.rows is not None
    ]
    for name in names:
        params[name].set(vary=True, min=spec(name).low, max=spec(name).high)
    if not names:
        return []
    better = minimize(problem, params, robust, CALLS)
    if solution.minimum.cost - better.cost < CERTAIN * len(names) * spread_of(problem, better.cost, len(solution.free)):
        return []
    return [
        "The likely cause is the shutter: the motion is closer with a delay from row to row, of about "
        f"{better.values[names[0]]:.1g} s. Track the film with --row-delay and --exposure, with the numbers of your camera."
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


def _changed(run: Run, sizes: Mapping[str, float], radius: float = 1.0, time: float = 1.0, zero: float = 0.0) -> Run:
    """Return a run with other channels, radius and times [factors], and another zero of the angle [rad].

    sizes: factors of channels by name.
    """

    def channel(one: Channel) -> Channel:
        size, shift = sizes.get(one.name, 1.0), zero if one.name == "angle" else 0.0
        # a sensor has a clock of its own; among places an angular velocity comes from their times
        size /= time if one.name == "omega" and len(run.channels) > 1 else 1.0
        return one._replace(values=size * one.values - shift, errors=abs(size) * one.errors)

    hoop = run.hoop and run.hoop.model_copy(update={"radius": radius * run.radius})
    return replace(run, t=time * run.t, channels=tuple(map(channel, run.channels)), radius=radius * run.radius, hoop=hoop)


def _exchanged(run: Run) -> Run:
    """Return a run with x and y exchanged."""
    other = {"x": "y", "y": "x"}
    return replace(run, channels=tuple(one._replace(name=other.get(one.name, one.name)) for one in run.channels))


def _trials(run: Run) -> list[Trial]:
    """Return the run without each usual mistake that its kind of record may have."""
    measured = run.measured
    found = []
    for factor in TIMES:
        slow = (
            "is the film in slow motion? Give the frames per second as taken, hophoop track --rate 240, or correct the times."
        )
        advice = slow if 1e-3 < factor < 0.8 else "are frames per second (--rate) and times right, in s?"
        if SHORTEST < factor * run.t[-1] < LONGEST:
            other = _changed(run, {}, time=factor)
            found.append(Trial("times", "with times multiplied by {:.3g}", advice, other, "times", factor, factor == 1.0))
    lengths = dict.fromkeys(("x", "y", "marker_x", "marker_y"), 1.0)
    for factor in (*SIZES, *UNITS):
        advice = "measure the outer radius of the rim." if factor in CLOSE else "is the radius in m, and no diameter?"
        other = _changed(run, {}, radius=factor)
        found.append(Trial("the radius", "with a radius of {:.3g} m", advice, other, "radius", other.radius, factor == 1.0))
    degrees = np.radians(1.0)
    if measured & lengths.keys():
        found.append(Trial("the scale", "with other lengths", "is the scale of lengths right?", run, "scale"))
        for factor in UNITS:
            small, words = dict.fromkeys(lengths, factor), f"with lengths multiplied by {factor:g}"
            units = "are lengths in cm, mm or pixels? Name the columns x (cm), y (cm); the radius is in m."
            found.append(Trial("units", words, units, _changed(run, small)))
            both = "is the radius in m, and are lengths in cm or mm?"
            found.append(Trial("units", f"{words} and the radius, too", both, _changed(run, small, radius=factor)))
    if {"x", "y"} <= measured:
        turned = "with x and y exchanged", "is the film sideways, or are x and y exchanged?"
        found.append(Trial("axes", *turned, _exchanged(run)))
        down = "with y in the other direction", "does y count downwards? y is the height."
        found.append(Trial("axes", *down, _changed(run, {"y": -1.0})))
        over = "with x and y in the other direction", "is the film upside down?"
        found.append(Trial("axes", *over, _changed(run, {"x": -1.0, "y": -1.0}, zero=np.pi)))
    if "angle" in measured:
        back = "with the angle in the other direction", "the angle counts clockwise if x counts to the right. Does yours?"
        found.append(Trial("axes", *back, _changed(run, {"angle": -1.0})))
        unit = "with the angle in degrees", "is it in degrees (--unit angle=deg)?"
        found.append(Trial("units", *unit, _changed(run, {"angle": degrees})))
        top = "is your angle zero with the load at the top? A known difference is --fix marker_angle=…, in rad."
        found += [
            Trial("the zero of the angle", "with another zero of the angle", top, _changed(run, {}, zero=one), "marker_angle")
            for one in np.radians(range(45, 360, 45))
        ]
    if "omega" in measured:
        unit = "with angular velocities in degrees per second", "give --unit omega=deg/s."
        found.append(Trial("units", *unit, _changed(run, {"omega": degrees})))
    return found


def _window(run: Run, asked: Asked, allowed: float) -> list[str]:
    """Name the longest part of the data that is free motion, such as between a hand and a catch.

    allowed: cost over the number of data [1].
    """
    track = asked.track
    hoop = run.hoop or ("general" if run.general else "ideal")
    begin, end = float(track.t[0]), float(track.t[-1])
    step = 0.1 * np.ceil((end - begin) / PARTS / 0.1)
    places = [*np.arange(begin, end - 0.5 * step, step).tolist(), end]

    def free(first: int, last: int) -> bool:
        try:
            own = run_of(track.between(places[first] - 1e-9, places[last] + 1e-9), hoop, run.start, run.plane, asked.sigma)
        except InputError:  # too few data
            return False
        if own.count < NUMBERS or _way(own) < MOVES:
            return False
        return asked.fitted(Trial("", "", "", own))[0] < allowed

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
    since, until = (places[place] for place in found)
    options = " ".join([f"--from {since:.3g}"] * (found[0] > 0) + [f"--to {until:.3g}"] * (0 < found[1] < len(places) - 1))
    if not options:
        return []
    where = "first part is" if until == end else "last part is" if since == begin else "first and the last part are"
    return [f"The {where} no free motion (a hand, a catch, a wall?), but the rest fits one: give {options}."]


def _way(run: Run) -> float:
    """Distance of the hoop over the radius, or its rotation [1]."""
    ways = {"x": run.radius, "marker_x": run.radius, "angle": 1.0}
    found = [float(np.ptp(one.values)) / ways[one.name] for one in run.channels if one.name in ways]
    return max(found or [float(np.abs(one.values).mean()) * float(run.t[-1]) for one in run.channels if one.name == "omega"])
