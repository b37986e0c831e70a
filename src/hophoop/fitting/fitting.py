"""Parameters of a hoop from one or several records of its motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from hophoop._support.errors import check_type
from hophoop.fitting.channels import Values, evened, with_errors, with_scatter
from hophoop.fitting.guess import Candidate, candidates, guess, start_kind
from hophoop.fitting.limits import least_friction, with_limits
from hophoop.fitting.mistakes import likely_mistakes, shutter
from hophoop.fitting.parameters import HOOPS, REFUSED, SHARED, STARTS, split_number
from hophoop.fitting.problem import Problem, defaults, problem_of, run_of, shared_errors
from hophoop.fitting.result import Fit
from hophoop.fitting.solving import Solution, best_of, changed, free_of, lowest, of_rotation, parameters, unobserved
from hophoop.scenario import Hoop, InputError, Plane
from hophoop.tracking import Track, read_track
from hophoop.tracking.hints import require_above_0

if TYPE_CHECKING:
    from lmfit import Parameters

LONGEST = 120.0  # record that is fitted [s]
SEEN = 2  # minimum frames of rolling that show that a motion starts with it
CERTAIN = 9.0  # rise of the sum of squares that is more than chance: three standard deviations
OPEN = (
    "Whether the hoop rolls or slips in the first frame is open; the uncertainties allow for both. If it was released rolling, "
    "--start rolling has smaller ones."
)
NO_MISTAKE = "None of the usual mistakes explains that (tried: {}): look at the residuals (--out, or report in Python)."


@dataclass(frozen=True)
class Settings:
    """What the caller wants of a fit."""

    hoop: Hoop | str
    start: str
    fixed: Mapping[str, float]
    free: Sequence[str]
    bounds: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    tied: Mapping[str, str] = field(default_factory=dict)
    plane: Plane = field(default_factory=Plane)
    robust: bool = True
    seed: int = 0

    def of_run(self, number: int) -> Settings:
        """Return the settings of one of several runs: its own parameters without their number, and no others'."""

        def own(given: Mapping[str, Any]) -> dict[str, Any]:
            parts = {name: split_number(name) for name in given}
            return {name: given[key] for key, (name, run) in parts.items() if run in (0, number)}

        free = own(dict.fromkeys(self.free))
        return replace(self, fixed=own(self.fixed), free=list(free), bounds=own(self.bounds), tied=own(self.tied))


def fit(
    data: Track | str | Path | Sequence[Track | str | Path],
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
    sigma_omega: float | None = None,
    robust: bool = True,
    seed: int = 0,
) -> Fit:
    """Find the parameters with which the exact motion is closest to a track, or to several of one hoop on one plane.

    Parameters
    ----------
    data : Track, str, Path, or a sequence of these
        A track, or a file of one. Several runs share the hoop, friction, restitution and rolling resistance; the other
        parameters of each end in its number, such as speed_2.
    hoop : Hoop or {'ideal', 'general'}, default 'ideal'
        A known hoop, for example from its parts, so that only the contact is fitted; or an ideal hoop, described by gamma; or
        a general one, described by eccentricity and inertia_ratio.
    start : {'auto', 'rolling', 'sliding', 'flying'}, default 'auto'
        Motion of the hoop in the first frame; auto is sliding where no rolling is seen before the first slip. Flying needs
        places: angular velocities alone do not tell the height.
    fixed : dict, optional
        Known parameters and their values [SI units].
    free : sequence of str, optional
        Parameters to fit in addition to the usual ones: rolling_resistance, slope, scale, stretch, tilt, origin_y,
        row_delay, marker_angle, marker_ratio. With the track of a film, slope, scale, stretch, tilt and origin_y are always
        fitted, with the film's estimates as priors; those named here have no prior.
    bounds : dict, optional
        Minimum and maximum values of parameters [SI units].
    tied : dict, optional
        Parameters that are expressions of others.
    plane : Plane, optional
        Gravity and the impact law.
    sigma, sigma_angle, sigma_omega : float, optional
        Standard deviations of places [m], angles [rad] and angular velocities [rad/s], in place of the track's own.
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
        If lmfit is missing.

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
    if isinstance(hoop, str) and hoop not in HOOPS:
        raise InputError.of_field("hoop", hoop, "'ideal', 'general' or a Hoop")
    if start != "auto" and start not in STARTS:
        raise InputError.of_field("start", start, f"auto, {', '.join(STARTS)}")
    require_above_0(sigma=sigma, sigma_angle=sigma_angle, sigma_omega=sigma_omega)
    if isinstance(data, Track | str | Path):
        data = [data]
    check_type("data", data, Sequence)
    read = (one if isinstance(one, Track) else read_track(one) for one in data)
    errors = {"places": sigma, "angles": sigma_angle, "omegas": sigma_omega}
    tracks = [with_errors(track, errors) for track in read]
    if not tracks:
        raise InputError("There is no record to fit.")
    how = Settings(hoop, start, fixed or {}, free, bounds or {}, tied or {}, plane or Plane(), robust, seed)
    if len(tracks) == 1:
        return fit_alone(tracks[0], how)
    return _fit_together([fit_alone(track, how.of_run(k)) for k, track in enumerate(tracks, 1)], how)


def fit_alone(track: Track, how: Settings, near: Values | None = None) -> Fit:
    """Fit one run; if the data have no errors, a second time, with the scatter of the residuals.

    Where no rolling is seen before the first slip, the hoop may have slipped earlier: its slip in the first frame is fitted.

    near: values of another start.
    """
    given, (track, derived) = track, evened(track)
    problem, params = _posed(track, how)
    starts = _starts(problem, params, how.seed, near)
    if not all(piece.channel.known for piece in problem.pieces):
        # angular velocities need the whole search
        search = best_of(problem, params, starts).minimum if of_rotation(problem) else lowest(problem, params, starts)
        off = {channel.name: channel.errors * search.residuals[part] for _, channel, part in problem.pieces}
        track, scatter = with_scatter(track, off)
        problem, params = _posed(track, how)
        starts, derived = _starts(problem, params, how.seed, near), derived | scatter
    solution = best_of(problem, params, starts)
    if how.start == "auto" and _slips_at_once(solution):
        with suppress(InputError):  # the caller knows the speed, or one more parameter is too many
            return _with_slip(given, how, solution)
    return _fit_of(params, solution, (track,), how, [derived])


def _slips_at_once(solution: Solution) -> bool:
    """Return True if a motion that starts rolling slips before rolling is seen."""
    (run,), values = solution.problem.runs, solution.minimum.values
    modes = run.motion(values).at(run.t[:SEEN]).mode
    return run.start == "rolling" and bool(np.isin(modes, ["S", "K"]).any())


def _with_slip(track: Track, how: Settings, rolling: Solution) -> Fit:
    """Return a fit that starts with slip, with a note where a motion that starts rolling explains the data as well."""
    (run,), values = rolling.problem.runs, rolling.minimum.values
    near = values | {"vx0": values["speed"], "omega0": values["speed"] / run.radius}
    found = fit_alone(track, replace(how, start="sliding"), near)
    rises = found.problem.cost(found.values | near) - found.problem.cost(found.values)
    as_well = found.usable and rises < CERTAIN * max(1.0, found.reduced)
    return replace(found, notes=(*found.notes, OPEN)) if as_well else found


def fit_near(track: Track, how: Settings, values: Values) -> Fit:
    """Fit one run whose data have errors, from values near its parameters."""
    problem, params = _posed(track, how)
    return _fit_of(params, best_of(problem, params, [_start_near(params, values)]), (track,), how, [{}])


def _start_near(params: Parameters, values: Values) -> Candidate:
    """Return a start of a fit near values of its parameters."""
    return Candidate(changed(params, values).valuesdict(), "", 0.0)


def _posed(track: Track, how: Settings) -> tuple[Problem, Parameters]:
    """Return the problem of one run with its priors, and its parameters."""
    run = run_of(track, how.hoop, "rolling" if how.start == "auto" else how.start, how.plane)
    if run.t[-1] > LONGEST:
        raise InputError(
            f"{track.source or 'The record'} lasts {run.t[-1]:.4g} s, and the free motion of a hoop some seconds: give its "
            "part by --from and --to (since= and until= in a Reading). Or are its times in ms?"
        )
    if how.start == "flying" and {one.name for one in run.channels} == {"omega"}:
        raise InputError.of_field("start", how.start, "auto, rolling or sliding for angular velocities alone")
    if how.start == "auto":
        run = replace(run, start=start_kind(run))
    params = _parameters(problem_of([run]), *defaults(run, track), how)
    # parameters that the caller frees have no prior
    priors = {name: prior for name, prior in shared_errors(track).items() if params[name].vary and name not in how.free}
    return problem_of([replace(run, priors=priors)], how.robust), params


def _starts(problem: Problem, params: Parameters, seed: int, near: Values | None) -> list[Candidate]:
    """Return starts of a fit of one run, and one near some values."""
    (run,), free = problem.runs, free_of(params)
    if len(free) >= problem.count:
        raise InputError(f"{len(free)} parameters cannot be fitted to {problem.count} numbers.")
    starts = candidates(run, guess(run, params.valuesdict(), free), set(free), seed)
    if not starts:
        raise InputError("No motion could be computed from a first estimate of the parameters: fix or bound some of them.")
    return starts if near is None else [*starts, _start_near(params, near)]


def _fit_together(alone: list[Fit], how: Settings) -> Fit:
    """Fit several runs of a hoop, from the fits of each alone."""
    problem = problem_of([one.problem.runs[0] for one in alone], how.robust)
    values: Values = {}
    for run, one in zip(problem.runs, alone, strict=True):
        values |= {run.named(name): one.values[name] for name in run.names}
    usual = {run.named(name) for run, one in zip(problem.runs, alone, strict=True) for name in one.settings["free"]}
    params = _parameters(problem, values, usual, how)
    starts = []
    for one in alone:
        first = changed(params, values | {name: one.values[name] for name in SHARED if name in one.values}).valuesdict()
        starts.append(Candidate(first, problem.sequence(first), 0.0))
    tracks = tuple(one.track for one in alone)
    derived = [own for one in alone for own in one.settings["derived"]]
    return replace(_fit_of(params, best_of(problem, params, starts), tracks, how, derived), alone=tuple(alone))


def _parameters(problem: Problem, values: Values, usual: set[str], how: Settings) -> Parameters:
    """Return lmfit's parameters; a name without number is that parameter of each run."""

    def expanded(given: Mapping[str, Any]) -> dict[str, Any]:
        result: dict[str, Any] = {}
        for name, value in given.items():
            if name in REFUSED:
                raise InputError(f"{name} is no parameter of a fit: {REFUSED[name]}.")
            places = [run.named(one) for run in problem.runs for one in run.names if name in (one, run.named(one))]
            if not places:
                raise InputError(f"{name!r} is no parameter of this fit; it has {', '.join(problem.names)}.")
            result |= dict.fromkeys(places, value)
        return result

    fixed, bounds, tied = expanded(how.fixed), expanded(how.bounds), expanded(how.tied)
    free = expanded(dict.fromkeys(how.free))
    for name, value in fixed.items():
        if name in free or name in tied:
            raise InputError(f"{name} cannot be fixed and {'free' if name in free else 'tied'}.")
        if not np.isfinite(value):
            raise InputError(f"fixed {name} = {value} must be a finite number.")
    for name, (low, high) in bounds.items():
        if not low < high:
            raise InputError(f"bounds of {name} = {low}, {high} must be a lower and a greater number.")
    for run in problem.runs:
        if run.named("row_delay") in free and not run.rows.any():
            raise InputError("row_delay cannot be fitted: the data do not say in which row of the picture the hoop was.")
    chosen = [name for name in problem.names if name in {*usual, *free} - {*fixed, *tied}]
    return parameters(values | {name: float(value) for name, value in fixed.items()}, chosen, bounds, tied)


def _fit_of(params: Parameters, solution: Solution, tracks: tuple[Track, ...], how: Settings, derived: list[Values]) -> Fit:
    """Return the fit, with limits of parameters that may be at an end of their range or have no effect.

    derived: of the data of each run, what they lack: the scatter, and the rate of rounded times.
    """
    problem, wanted = solution.problem, free_of(params)
    solution, limits = with_limits(solution, wanted)
    values = solution.minimum.values
    gone, notes = unobserved(problem.motions(values)), []
    tied = {name: one.expr for name, one in params.items() if one.expr}
    if "mu_excess" in gone and {"mu_kinetic", "mu_excess"} & set(limits):
        least = least_friction(params, solution)
        limits["mu_static"] = ("≥", least)
        notes.append(f"The hoop never slips: static friction is at least {least:.3g}, and kinetic friction has no effect.")
    if "restitution" in gone & set(limits):
        notes.append("There is no impact in the record, so restitution cannot be determined.")
    notes += [f"The record does not determine {name}." for name, limit in limits.items() if not limit[0] and name not in gone]
    settings = {
        "hoop": how.hoop if isinstance(how.hoop, str) else how.hoop.to_dict(),
        "starts": [run.start for run in problem.runs],
        "gravity": how.plane.gravity,
        "law": how.plane.impact_law,
        "robust": how.robust,
        "derived": derived,
        "free": list(wanted),
        "bounds": {name: list(limits) for name, limits in how.bounds.items()},
        "tied": tied,
        "priors": [{name: list(prior) for name, prior in run.priors.items()} for run in problem.runs],
    }
    found = Fit(values, solution.free, solution.covariance, limits, tuple(notes), tracks, settings)
    if found.good:
        return found
    run = problem.runs[0]
    free = [name for name in run.names if run.named(name) in wanted]
    causes, tried = likely_mistakes(run, run.own(values), free, found.reduced, tracks[0])
    found = replace(found, mistaken=bool(causes))
    causes = causes or shutter(solution, tracks)
    notes = causes + notes if found.usable else causes or [NO_MISTAKE.format(", ".join(tried))]
    return replace(found, notes=tuple(notes))
