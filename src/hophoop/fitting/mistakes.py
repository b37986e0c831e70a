"""Likely mistakes in data that no motion explains: units, directions of axes and angles, slow motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.channels import Channel, Sigma
from hophoop.fitting.guess import SLIPS, candidates, guess, rates_of, start_kind
from hophoop.fitting.problem import Run, defaults, problem_of, run_of
from hophoop.fitting.solving import minimize, parameters
from hophoop.tracking import Track

Floats = NDArray[np.float64]

FAR_OFF = 8.0  # factor by which lengths or gravity are off that no loss of energy explains
LEAST_RISE = 0.02  # of the centre, over the radius, that is a hop
TIMES = (1 / 1000, 1 / 8, 1 / 4, 1 / 2, 5 / 6, 6 / 5, 2.0, 4.0, 8.0)  # usual factors of times
DRAWS = 24  # motions of a trial
POLISHED, STARTED, CALLS = 4, 2, 40  # trials that are minimized, starts of each, and calls of the motion
GOOD = 4.0  # cost over the number of data of a motion that fits after so few calls
FAR = 3.0  # times the cost of the best, of each other
WORSE = 20.0  # times the cost of a window, of the whole record
LONGEST = 30.0  # motion that is tried [s]
PARTS = 20  # of the record, for its window
SHORTEST = 40  # frames of a cut window


def likely_mistakes(problem: Run, track: Track, sigma: Sigma) -> list[str]:
    """Ask about the usual mistake that x ≈ R θ or a hop shows, or without which a motion fits; at most one sentence.

    sigma: given standard deviations.
    """
    x, y, angle = (rates_of(problem, name) for name in ("x", "y", "angle"))
    if x is None or angle is None:
        return []
    if y is not None and np.ptp(y.value) > max(2.0 * problem.radius, np.ptp(x.value)):
        return ["The centre moves more along y than along x: is the film sideways, or are x and y exchanged?"]
    if y is not None and _hops_down(y.value, problem):
        return ["The centre jumps down and not up: does y count downwards, or is the film upside down? y is the height."]
    place = np.interp(angle.t, x.t, x.value)
    ratio = float(np.polyfit(angle.value, place, 1)[0]) / problem.radius if np.ptp(angle.value) else np.inf
    return _of_units(ratio) or _cured(problem, track, sigma)


def without_shutter(tracks: Sequence[Track]) -> list[str]:
    """Name the shutter of films that were tracked without their exposure time or rolling shutter."""
    views = [track.view for track in tracks if track.view is not None]
    missing = []
    if any(not view.exposure for view in views):
        missing.append("--exposure 0.001 (the exposure time, s)")
    if any(not view.row_delay for view in views):
        missing.append("--row-delay 1e-5 (the delay from row to row, s, of a rolling shutter)")
    if not missing:
        return []
    return [f"The likely cause is the shutter: track the film with {' and '.join(missing)}, with the numbers of your camera."]


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


def _run_with(run: Run, time: float = 1.0, length: float = 1.0, radius: float = 1.0, zero: float = 0.0) -> Run:
    """Return a run with other times, lengths, radius [factors] and another zero of the angle [rad]."""

    def channel(one: Channel) -> Channel:
        if one.name == "angle":
            return one._replace(values=one.values - zero)
        if one.name == "omega":
            return one._replace(values=one.values / time, errors=one.errors / time)
        return one._replace(values=length * one.values, errors=length * one.errors)

    channels = tuple(channel(one) for one in run.channels)
    return replace(run, t=time * run.t, channels=channels, radius=radius * run.radius)


class Trial(NamedTuple):
    """A run without one mistake."""

    question: str
    run: Run
    extra: str = ""  # a parameter that is free in addition


def _trials(run: Run) -> list[Trial]:
    """Return the run without each usual mistake; the first is the run as it is."""
    slow = (
        "If times are multiplied by {:g}, a motion fits: is the film in slow motion? Give the frames per second as taken, "
        "hophoop track --rate 240, or correct the times."
    )
    fast = "If times are multiplied by {:g}, a motion fits: are frames per second (--rate) and times right, in s?"
    top = "With another zero of the angle a motion fits: is your angle zero with the load at the top? "
    top += "A known difference is --fix marker_angle=…, in rad."
    radius = "With a radius of {:.3g} m a motion fits: is the radius in m, and no diameter?"
    found = [Trial("", run)]
    found += [Trial((slow if one < 1.0 else fast).format(one), _run_with(run, time=one)) for one in TIMES]
    found += [Trial(radius.format(one * run.radius), _run_with(run, radius=one)) for one in (0.5, 2.0)]
    found += [Trial(radius.format(one * run.radius), _run_with(run, length=one, radius=one)) for one in (0.01, 0.001)]
    found += [Trial(top, _run_with(run, zero=one), "marker_angle") for one in np.radians(range(45, 360, 45))]
    found += [Trial("With other lengths a motion fits: is the scale of lengths right?", run, "scale")]
    return found


def _cost(trial: Trial, track: Track, polish: bool) -> float:
    """Return the cost of the best motion over the number of data, about 1 where a motion fits."""
    if trial.run.t[-1] > LONGEST:
        return np.inf
    run = replace(trial.run, start=start_kind(trial.run), priors={})
    values, free = defaults(run, track)
    free |= {trial.extra} - {""}
    first = values | {name: value for name, value in guess(run, values).items() if name in free}
    starts = candidates(run, first, free, draws=DRAWS)
    if not starts:
        return np.inf
    if not polish:
        return starts[0].cost / run.count
    problem, names = problem_of([run]), sorted(free)
    lowest = (minimize(problem, parameters(one.values, names), True, CALLS).cost for one in starts[:STARTED])
    return min(lowest) / run.count


def _costs(trials: list[Trial], track: Track) -> list[tuple[float, Trial]]:
    """Return the costs of the trials that are the best by drawn motions, the best first."""
    order = sorted(trials, key=lambda trial: _cost(trial, track, polish=False))[:POLISHED]
    return sorted(((_cost(trial, track, polish=True), trial) for trial in order), key=lambda pair: pair[0])


def _cured(run: Run, track: Track, sigma: Sigma) -> list[str]:
    """Ask about the mistake without which a motion fits far better than without each other; else about the window."""
    costs = _costs(_trials(run), track)
    best, trial = costs[0]
    others = [cost for cost, other in costs if other.question != trial.question]
    if best < GOOD:
        return [trial.question] if trial.question and min(others, default=np.inf) > FAR * best else []
    windows = [trial for cost, trial in _costs(_windows(run, track, sigma), track) if cost < min(GOOD, best / WORSE)]
    return [max(windows, key=lambda trial: len(trial.run.t)).question] if windows else []


def _windows(run: Run, track: Track, sigma: Sigma) -> list[Trial]:
    """Return the run without some of its first, or of its last, part."""
    hoop = run.hoop or ("general" if run.general else "ideal")
    found: list[Trial] = []
    begin, end = float(track.t[0]), float(track.t[-1])
    step = 0.1 * np.ceil((end - begin) / PARTS / 0.1)
    for time in np.arange(begin + step, end, step):
        k = int(np.searchsorted(track.t, time - 1e-9))
        at = float(track.t[k])
        part: tuple[float | None, float | None]
        if 2 * k < len(track.t) and len(track.t) - k > SHORTEST:
            said, part = f"first part is no free motion (a hand?), but the rest fits one: give --from {at:.3g}", (at, None)
        elif 2 * k > len(track.t) and k > SHORTEST:
            said, part = f"last part is no free motion (a hand, a wall?), but the rest fits one: give --to {at:.3g}", (None, at)
        else:
            continue
        found.append(Trial(f"The {said}.", run_of(track.between(*part), hoop, run.start, run.plane, sigma)))
    return found
