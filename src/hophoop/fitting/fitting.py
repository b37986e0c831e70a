"""Parameters of a filmed hoop."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from hophoop.fitting.covariance import autocorrelations
from hophoop.fitting.guess import candidates, guess, start_kind
from hophoop.fitting.judging import WORDS, correlations, least_static_friction, misfits, shares
from hophoop.fitting.limits import NOT_SEEN, least_friction, one_sided_limits, unobserved
from hophoop.fitting.losses import influence
from hophoop.fitting.mistakes import likely_mistakes
from hophoop.fitting.parameters import PARAMETERS, REFUSED, STARTS
from hophoop.fitting.problem import Problem, defaults, problem_of, shared_errors
from hophoop.fitting.result import HOPELESS, WORST, Fit
from hophoop.fitting.solving import Choice, Solution, best_of
from hophoop.scenario import Hoop, InputError, Plane
from hophoop.tracking import Track, read_track

Floats = NDArray[np.float64]
NO_MISTAKE = "No usual mistake of units, axes or times explains that: look at the residuals (--out, or report in Python)."


def fit(
    data: Track | str | Path,
    hoop: Hoop | str = "ideal",
    *,
    start: str = "auto",
    fixed: Mapping[str, float] | None = None,
    free: Sequence[str] = (),
    bounds: Mapping[str, tuple[float, float]] | None = None,
    tied: Mapping[str, str] | None = None,
    plane: Plane | None = None,
    sigma: float | None = None,
    sigma_angle: float | None = None,
    robust: bool = True,
    seed: int = 0,
) -> Fit:
    """Find the parameters with which the exact motion is closest to a track.

    Parameters
    ----------
    data : Track, str or Path
        A track, or a file of one.
    hoop : Hoop or {'ideal', 'general'}, default 'ideal'
        A known hoop, for example from its parts, so that only the contact is fitted; or an ideal hoop, described by gamma; or
        a general one, described by eccentricity and inertia_ratio.
    start : {'auto', 'rolling', 'sliding', 'flying'}, default 'auto'
        Motion of the hoop in the first frame.
    fixed : dict, optional
        Known parameters and their values [SI units].
    free : sequence of str, optional
        Parameters to fit in addition to the usual ones: rolling_resistance, slope, scale, tilt, origin_y, row_delay,
        marker_angle, marker_ratio. With the track of a film, slope, scale, tilt and origin_y are always fitted, with the film's
        estimates as priors; those named here have no prior.
    bounds : dict, optional
        Minimum and maximum values of parameters [SI units].
    tied : dict, optional
        Parameters that are expressions of others.
    plane : Plane, optional
        Gravity and the impact law.
    sigma, sigma_angle : float, optional
        Standard deviations of places [m] and angles [rad], in place of the track's own.
    robust : bool, default True
        Let outliers count less than by their square.
    seed : int, default 0
        Seed of the drawn starts [1].

    Returns
    -------
    fit : Fit

    Raises
    ------
    ValueError
        If a name is unknown or cannot be fitted, or there are too few data.
    ImportError
        If SciPy or asteval is missing.

    Examples
    --------
    >>> import numpy as np
    >>> import hophoop as hh
    >>> from hophoop.tracking.table import track_of
    >>> motion = hh.simulate(hh.Hoop.ideal(0.6, radius=0.3), hh.Plane(mu=0.9), hh.Start.rolling(1.5), duration=0.4)
    >>> t = np.linspace(0.0, 0.4, 60)
    >>> state = motion.at(t)
    >>> data = {"x": state.x, "y": state.height + 0.3, "angle": state.angle}
    >>> found = hh.fit(track_of(t, data, radius=0.3, placed=True), sigma=1e-4, sigma_angle=1e-3)
    >>> round(found.values["gamma"], 3), found.limits["mu_static"][0]
    (0.6, '≥')
    """
    track = data if isinstance(data, Track) else read_track(data)
    if isinstance(hoop, str) and hoop not in ("ideal", "general"):
        raise InputError.of_field("hoop", hoop, "'ideal', 'general' or a Hoop")
    if start != "auto" and start not in STARTS:
        raise InputError.of_field("start", start, f"auto, {', '.join(STARTS)}")
    plane = plane or Plane()
    problem = problem_of(track, hoop, "rolling" if start == "auto" else start, plane, (sigma, sigma_angle))
    if start == "auto" and (kind := start_kind(problem)) != "rolling":
        problem = problem_of(track, hoop, kind, plane, (sigma, sigma_angle))
    choice = _choice(problem, track, fixed or {}, free, bounds or {}, tied or {})
    # parameters that the caller frees have no prior
    priors = {name: prior for name, prior in shared_errors(track).items() if name in choice.free and name not in free}
    problem = replace(problem, priors=priors)
    found = guess(problem, choice.values)
    first = {name: found[name] if name in choice.free else value for name, value in choice.values.items()}
    if len(choice.free) >= problem.count:
        raise InputError(f"{len(choice.free)} parameters cannot be fitted to {problem.count} numbers.")
    starts = candidates(problem, first, set(choice.free), seed)
    if not starts:
        raise InputError("No motion could be computed from a first estimate of the parameters: fix or bound some of them.")
    solution, blind = best_of(problem, choice, starts, robust)
    settings: dict[str, object] = {
        "hoop": hoop if isinstance(hoop, str) else hoop.to_dict(),
        "start": problem.start,
        "gravity": plane.gravity,
        "law": plane.impact_law,
        "robust": robust,
        "sigma": sigma,
        "sigma_angle": sigma_angle,
        "free": list(choice.free),
        "bounds": {name: list(limits) for name, limits in choice.bounds.items()},
        "tied": dict(choice.tied),
        "priors": {name: list(prior) for name, prior in priors.items()},
    }
    return _fit_of(problem, choice, solution, blind, track, settings)


def _choice(
    problem: Problem,
    track: Track,
    fixed: Mapping[str, float],
    free: Sequence[str],
    bounds: Mapping[str, tuple[float, float]],
    tied: Mapping[str, str],
) -> Choice:
    values, usual = defaults(problem, track)
    for name in (*fixed, *free, *bounds, *tied):
        if name in REFUSED:
            raise InputError(f"{name} is no parameter of a fit: {REFUSED[name]}.")
        if name not in problem.names:
            raise InputError(f"{name!r} is no parameter of this fit; it has {', '.join(problem.names)}.")
    for name in fixed:
        if name in free or name in tied:
            raise InputError(f"{name} cannot be fixed and {'free' if name in free else 'tied'}.")
        if not np.isfinite(fixed[name]):
            raise InputError(f"fixed {name} = {fixed[name]} must be a finite number.")
    for name, (low, high) in bounds.items():
        if not low < high:
            raise InputError(f"bounds of {name} = {low}, {high} must be a lower and a greater number.")
    if "row_delay" in free and problem.rows is None:
        raise InputError("row_delay cannot be fitted: the data do not say in which row of the picture the hoop was.")
    chosen = tuple(name for name in problem.names if (name in usual or name in free) and name not in fixed and name not in tied)
    values |= {name: float(value) for name, value in fixed.items()}
    for name in chosen:
        low, high = bounds.get(name, (PARAMETERS[name].low, PARAMETERS[name].high))
        values[name] = float(np.clip(values[name], low, high))
    return Choice(values, chosen, dict(bounds), dict(tied))


def _fit_of(
    problem: Problem, choice: Choice, solution: Solution, blind: list[str], track: Track, settings: dict[str, object]
) -> Fit:
    """Return the fit, with limits of parameters that may be at an end of their range or have no effect."""
    robust, wanted = bool(settings["robust"]), choice
    gone = unobserved(problem.motion(solution.values)) & set(blind)
    names = [name for name in choice.free if name not in gone]
    solution, limits = one_sided_limits(problem, choice.only(solution.free), solution, names, robust)
    limits |= {name: NOT_SEEN for name in choice.free if name in gone or name not in (*solution.free, *limits)}
    motion = problem.motion(solution.values)
    gone = unobserved(motion)
    notes = []
    if "mu_excess" in gone and {"mu_kinetic", "mu_excess"} & set(limits):
        least = least_static_friction(motion)
        if not choice.tied:
            least = least_friction(problem, wanted, solution, least, robust)
        limits["mu_static"] = ("≥", least)
        notes.append(f"The hoop never slips: static friction is at least {least:.3g}, and kinetic friction has no effect.")
    if "restitution" in gone & set(limits):
        notes.append("There is no impact in the film, so restitution cannot be determined.")
    notes += [f"The film does not determine {name}." for name, limit in limits.items() if not limit[0] and name not in gone]
    chi_square = float((solution.residuals**2).sum())
    degrees_of_freedom = problem.count - len(solution.free)
    worse = chi_square / max(degrees_of_freedom, 1)
    mistakes = likely_mistakes(problem) if worse > WORST else []
    if worse > HOPELESS:
        notes = mistakes or [NO_MISTAKE]
    else:
        notes = mistakes + notes + _correlated_errors(problem, influence(solution.residuals) if robust else solution.residuals)
    scale = max(1.0, float(np.sqrt(worse)))
    return Fit(
        solution.values,
        solution.free,
        solution.covariance,
        chi_square,
        degrees_of_freedom,
        limits,
        shares(problem, solution, scale),
        correlations(solution, set(problem.priors)),
        misfits(problem, motion, solution.residuals),
        tuple(notes),
        track,
        settings,
        problem.computed[0],
    )


def _correlated_errors(problem: Problem, pulls: Floats) -> list[str]:
    return [
        f"Errors of {WORDS[name]} are correlated ({memory.frames:.1f} frames have the information of one); "
        "the uncertainties include that."
        for name, memory in autocorrelations(problem, pulls).items()
        if memory.share
    ]
