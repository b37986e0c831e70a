"""Likely mistakes in data that no motion explains: units, axes, times, the radius, a part that is no free motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop._support.extras import need
from hophoop.fitting.channels import Channel, Sigma
from hophoop.fitting.guess import SLIPS, candidates, guess, rates_of, start_kind
from hophoop.fitting.parameters import SHARED, spec
from hophoop.fitting.problem import Problem, Run, defaults, problem_of, run_of
from hophoop.fitting.solving import Solution, minimize, parameters, spread_of
from hophoop.scenario import InputError
from hophoop.tracking import Track

Floats = NDArray[np.float64]

FAR_OFF = 8.0  # factor by which lengths or gravity are off that no loss of energy explains
LEAST_RISE = 0.02  # of the centre, over the radius, that is a hop
TOP = 4  # greatest values in a row that are equal of a sensor at its limit
TIMES = (1e-9, 1e-6, 1e-3, 1 / 8, 1 / 4, 1 / 2, 5 / 6, 6 / 5, 2.0, 4.0, 8.0, 1e3, 1e6, 1e9)  # usual factors of times
STEP = 0.05
NEAR = (1.05, 0.95, 1.1, 0.9, 1.15, 0.85, 1.2, 0.8)  # other factors of the times, or of the radius
FEW_STEPS, CLOSE = 7, 1e-3  # of the search for this factor, and its accuracy
DRAWS = 24  # motions of a trial
POLISHED, STARTED, CALLS = 4, 2, 40  # trials that are minimized, starts of each, and calls of the motion
GOOD = 4.0  # cost over the number of data of a motion that fits after so few calls
WELL = 1.5  # of one that fits so well that no other times or radius are searched
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
    words: str  # after 'A motion fits '
    advice: str
    run: Run
    extra: str = ""  # a parameter that is free in addition


def likely_mistakes(
    run: Run, values: dict[str, float], free: Sequence[str], cost: float, track: Track, sigma: Sigma
) -> tuple[list[str], list[str]]:
    """Name the mistake that the data show, or without which a motion fits; and what was tried.

    values, free: of the fit of this run; cost: of it, over the number of data [1]; sigma: given standard deviations.
    """
    held = {name: values[name] for name in run.names if name in SHARED and name not in free}
    shown = _shown(run)
    if shown:
        return [shown], []
    trials = _trials(run)
    costs = _costs(trials, track, held)
    if not costs or costs[0][0] > WELL:
        # both: a record of a phone hardly tells one from the other
        near = (_nearby(run, values, free, kind, track, held) for kind in ("radius", "times"))
        costs = sorted([*costs, *near], key=lambda pair: pair[0])
    tried = list(dict.fromkeys([*(["axes"] if run.measured & {"x", "y"} else []), *(one.kind for one in trials)]))
    best = costs[0][0]
    if best < min(GOOD, cost / ALIKE):
        # the best of each kind, and others that the data hardly tell from it
        alike = {one.kind: one for at, one in reversed(costs) if at <= ALIKE * best}
        first, *others = sorted(alike.values(), key=[one for _, one in costs].index)
        return [f"A motion fits {' or '.join(one.words for one in (first, *others))}: {first.advice}"], tried
    if cost < WORSE:
        return [], tried
    return _window(run, track, sigma, held, min(GOOD, cost / WORSE)), [*tried, "the window"]


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


def _shown(run: Run) -> str:
    """Return the question about axes, units or the sensor that the data show without a fit; '' if none."""
    x, y, angle = (rates_of(run, name) for name in ("x", "y", "angle"))
    if x is not None and y is not None and np.ptp(y.value) > max(2.0 * run.radius, np.ptp(x.value)):
        return "The centre moves more along y than along x: is the film sideways, or are x and y exchanged?"
    if y is not None and _hops_down(y.value, run):
        return "The centre jumps down and not up: does y count downwards, or is the film upside down? y is the height."
    if x is not None and angle is not None:
        place = np.interp(angle.t, x.t, x.value)
        ratio = float(np.polyfit(angle.value, place, 1)[0]) / run.radius if np.ptp(angle.value) else np.inf
        if said := _of_units(ratio):
            return said[0]
    return next((_of_limit(run.t[one.rows], one.values) for one in run.channels if one.name == "omega"), "")


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


def _hops_down(height: Floats, problem: Run) -> bool:
    """True if the centre leaves its usual height downwards."""
    low, usual, high = np.quantile(height, [0.02, 0.5, 0.98])
    noise = next(float(np.median(one.errors)) for one in problem.channels if one.name == "y")
    return bool(usual - low > max(2.0 * (high - usual), LEAST_RISE * problem.radius, SLIPS * noise))


def _of_units(ratio: float) -> list[str]:
    """Ask about units, and the direction of the angle; `ratio` is the way of the centre over radius and angle, about 1."""
    if abs(ratio) > FAR_OFF:
        return [
            f"The centre goes {abs(ratio):.2g} times as far as radius and angle let it: are lengths in cm or pixels? "
            "Name the columns x (cm), y (cm); the radius is in m."
        ]
    if abs(ratio) < 1.0 / FAR_OFF:
        return [
            f"The angle goes {1.0 / max(abs(ratio), 1e-9):.2g} times as far as radius and x let it: is it in degrees "
            "(--angle-unit deg), or the radius in cm? The radius is in m."
        ]
    if ratio < 0:
        return ["x grows while the angle falls: the angle counts clockwise if x counts to the right. Does yours?"]
    return []


def _run_with(
    run: Run, time: float = 1.0, length: float = 1.0, radius: float = 1.0, zero: float = 0.0, rate: float = 1.0
) -> Run:
    """Return a run with other times, lengths, radius, angular velocities [factors] and another zero of the angle [rad]."""
    # a sensor has a clock of its own; among places an angular velocity comes from their times
    turning = rate / time if len(run.channels) > 1 else rate

    def channel(one: Channel) -> Channel:
        if one.name == "angle":
            return one._replace(values=one.values - zero)
        factor = turning if one.name == "omega" else length
        return one._replace(values=factor * one.values, errors=factor * one.errors)

    channels, size = tuple(channel(one) for one in run.channels), radius * run.radius
    hoop = run.hoop and run.hoop.model_copy(update={"radius": size})
    return replace(run, t=time * run.t, channels=channels, radius=size, hoop=hoop, priors={})


def _of_times(run: Run, factor: float) -> Trial:
    slow = "is the film in slow motion? Give the frames per second as taken, hophoop track --rate 240, or correct the times."
    fast = "are frames per second (--rate) and times right, in s?"
    advice = slow if 1e-3 < factor < 0.8 else fast
    return Trial("times", f"with times multiplied by {factor:.3g}", advice, _run_with(run, time=factor))


def _of_radius(run: Run, factor: float, length: float = 1.0) -> Trial:
    advice = (
        "is the radius in m, and no diameter?" if not min(NEAR) < factor < max(NEAR) else "measure the outer radius of the rim."
    )
    words = f"with a radius of {factor * run.radius:.3g} m"
    return Trial("the radius", words, advice, _run_with(run, length=length, radius=factor))


def _trials(run: Run) -> list[Trial]:
    """Return the run without each usual mistake that its kind of record may have."""
    measured = run.measured
    found = [_of_times(run, one) for one in TIMES if SHORTEST < one * run.t[-1] < LONGEST]
    found += [_of_radius(run, one) for one in (0.5, 2.0)]
    if measured & {"x", "marker_x"}:
        found += [_of_radius(run, one, one) for one in (0.01, 0.001)]
        found.append(Trial("the scale", "with other lengths", "is the scale of lengths right?", run, "scale"))
        if "angle" not in measured:
            units = "are lengths in cm or mm? Name the columns x (cm), y (cm)."
            found += [
                Trial("units", f"with lengths multiplied by {one:g}", units, _run_with(run, length=one))
                for one in (0.01, 0.001)
            ]
    else:
        found += [_of_radius(run, one) for one in (0.01, 0.001)]
    if "angle" in measured:
        top = "is your angle zero with the load at the top? A known difference is --fix marker_angle=…, in rad."
        found += [
            Trial("the zero of the angle", "with another zero of the angle", top, _run_with(run, zero=one), "marker_angle")
            for one in np.radians(range(45, 360, 45))
        ]
    if "omega" in measured:
        degrees = "with angular velocities in degrees per second", "name their unit in the head, or give --angle-unit deg."
        found.append(Trial("units", *degrees, _run_with(run, rate=np.radians(1.0))))
    return found


def _nearby(
    run: Run, values: dict[str, float], free: Sequence[str], kind: str, track: Track, held: dict[str, float]
) -> tuple[float, Trial]:
    """Return the run with the times, or the radius, with which a motion fits best, and its cost over the number of data.

    values, free: of the fit, near which there may be a minimum as well; held: parameters by name.
    """
    make = _of_times if kind == "times" else _of_radius

    def cost(factor: float) -> float:
        trial = make(run, factor)
        near = minimize(problem_of([trial.run]), parameters(values, free), True, CALLS).cost / run.count
        return min(near, _cost(trial, track, held, polish=True))

    middle, lowest = 1.0, np.inf  # valleys are narrow: first which one, then where its bottom is
    for factor in NEAR:
        here = cost(factor)
        if here < lowest:
            middle, lowest = factor, here
        if lowest < GOOD:
            break
    found = need("scipy.optimize", "fit").minimize_scalar(
        cost, bounds=(middle - STEP, middle + STEP), method="bounded", options={"maxiter": FEW_STEPS, "xatol": CLOSE}
    )
    return float(found.fun), make(run, float(found.x))


def _cost(trial: Trial, track: Track, held: dict[str, float], polish: bool) -> float:
    """Return the cost of the best motion over the number of data, about 1 where a motion fits; held: parameters by name."""
    if trial.run.t[-1] > LONGEST:
        return np.inf
    run = replace(trial.run, start=start_kind(trial.run), priors={})
    values, free = defaults(run, track)
    values, free = values | held, (free - held.keys()) | {trial.extra} - {""}
    first = values | {name: value for name, value in guess(run, values).items() if name in free}
    starts = candidates(run, first, free, draws=DRAWS)
    if not starts:
        return np.inf
    if not polish:
        return starts[0].cost / run.count
    problem, names = problem_of([run]), sorted(free)
    lowest = (minimize(problem, parameters(one.values, names), True, CALLS).cost for one in starts[:STARTED])
    return min(lowest) / run.count


def _costs(trials: list[Trial], track: Track, held: dict[str, float]) -> list[tuple[float, Trial]]:
    """Return the costs of the trials that are the best by drawn motions, the best first."""
    order = sorted(trials, key=lambda trial: _cost(trial, track, held, polish=False))[:POLISHED]
    return sorted(((_cost(trial, track, held, polish=True), trial) for trial in order), key=lambda pair: pair[0])


def _window(run: Run, track: Track, sigma: Sigma, held: dict[str, float], allowed: float) -> list[str]:
    """Name the longest part of the data that is free motion, such as between a hand and a catch.

    held: parameters by name; allowed: cost over the number of data [1].
    """
    hoop = run.hoop or ("general" if run.general else "ideal")
    begin, end = float(track.t[0]), float(track.t[-1])
    step = 0.1 * np.ceil((end - begin) / PARTS / 0.1)
    places = [*np.arange(begin, end - 0.5 * step, step).tolist(), end]

    def free(first: int, last: int) -> bool:
        try:
            own = run_of(track.between(places[first] - 1e-9, places[last] + 1e-9), hoop, run.start, run.plane, sigma)
        except InputError:  # too few data
            return False
        if own.count < NUMBERS or _way(own) < MOVES:
            return False
        return _cost(Trial("", "", "", own), track, held, polish=True) < allowed

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
