"""Plan a film, or a record of a phone in the hoop: the uncertainties of a fit to it, predicted from the motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from operator import attrgetter

import numpy as np

from hophoop._support import tables
from hophoop._support.errors import check_type
from hophoop.fitting.channels import Sigma
from hophoop.fitting.covariance import inverse
from hophoop.fitting.guess import merge_bounces
from hophoop.fitting.judging import correlations, least_static_friction
from hophoop.fitting.limits import NOT_SEEN, with_limits
from hophoop.fitting.parameters import PATHS, REFUSED
from hophoop.fitting.problem import Prior, defaults, problem_of, run_of
from hophoop.fitting.result import format_value, row_of
from hophoop.fitting.solving import Minimum, Solution, changed, free_of, insensitive, parameters, slopes
from hophoop.scenario import InputError, Scenario
from hophoop.simulation.simulate import simulate
from hophoop.tracking import Track
from hophoop.tracking.hints import require_above_0
from hophoop.tracking.table import track_of

MOST_FRAMES = 200_000


@dataclass(frozen=True)
class Plan:
    """Predicted result of a fit.

    Attributes
    ----------
    values : dict of float
        The parameters of the motion [SI units].
    errors : dict of float
        Standard deviations of the fit [SI units].
    limits : dict
        "≤" or "≥" and the limit at 95 % of each parameter that may be at an end of its range [its unit].
    unseen : tuple of str
        Parameters that the data would not determine.
    correlated : list
        Pairs that the data would hardly distinguish, with their correlation [1].
    sequence : str
        Of the motion.
    frames : int
        [1]
    least_static_friction : float
        Lower limit of the static friction if the hoop never slips; nan if it does [1].
    """

    values: dict[str, float]
    errors: dict[str, float]
    limits: dict[str, tuple[str, float]]
    unseen: tuple[str, ...]
    correlated: list[tuple[str, str, float]]
    sequence: str
    frames: int
    least_static_friction: float

    def __repr__(self) -> str:
        return tables.report("Plan of a fit", self.rows(), self.sentences(), left=(0, 1, 2))

    def _repr_html_(self) -> str:
        return tables.html(self.rows(), left=(0, 2), before=[" ".join(self.sentences())])

    def rows(self) -> list[tuple[str, str, str]]:
        """Parameters for people: name, value with uncertainty, meaning.

        Returns
        -------
        rows : list of (str, str, str)
        """
        limits = self.limits | dict.fromkeys(self.unseen, NOT_SEEN)
        if np.isfinite(self.least_static_friction):
            limits["mu_static"] = "≥", self.least_static_friction
        found = [row_of(name, format_value(self.values[name], error)) for name, error in self.errors.items()]
        return found + [row_of(name, "", limit) for name, limit in limits.items()]

    def sentences(self) -> list[str]:
        """Notes on the table.

        Returns
        -------
        sentences : list of str
        """
        rows = "values" if "omega_offset" in self.values else "frames"
        said = [f"{self.frames} {rows} of the sequence {merge_bounces(self.sequence)}."]
        said += [
            f"{first} and {second} could hardly be distinguished (correlation {size:+.3f})."
            for first, second, size in self.correlated
        ]
        return said


def plan(
    scenario: Scenario,
    rate: float = 240.0,
    sigma: float = 2e-4,
    sigma_angle: float | None = 2e-3,
    free: Sequence[str] = (),
    fixed: Sequence[str] = (),
    hoop_known: bool = False,
    sigma_scale: float = 1e-3,
    sigma_omega: float | None = None,
) -> Plan:
    """Predict the uncertainties of a fit to a film of a motion, or to the record of a phone in the hoop.

    Parameters
    ----------
    scenario : Scenario
        The expected motion.
    rate : float, default 240
        Frames, or values of the phone, per second [Hz].
    sigma : float, default 2e-4
        Standard deviation of each coordinate of the centre in a frame [m].
    sigma_angle : float, optional
        The same of the angle; None without marker [rad].
    free : sequence of str, optional
        Parameters to fit in addition to the usual ones.
    fixed : sequence of str, optional
        Known parameters.
    hoop_known : bool, default False
        Whether the hoop is known from its parts, so that only the contact and the start are fitted.
    sigma_scale : float, default 1e-3
        Relative standard deviation of the film's scale, one error for all frames, such as 0.1 pixel of a radius of 100. With 0
        the scale is known [1].
    sigma_omega : float, optional
        Standard deviation of the angular velocity that a phone in the hoop records, instead of a film [rad/s].

    Returns
    -------
    plan : Plan

    Raises
    ------
    ValueError
        If a name is unknown, a number out of range, or the motion too short.

    Examples
    --------
    >>> import hophoop as hh
    >>> scenario = hh.Scenario(hoop=hh.Hoop.ideal(0.6, radius=0.3), start=hh.Start.rolling(1.5), duration=0.3)
    >>> hh.plan(scenario, rate=120.0).unseen
    ('mu_kinetic', 'mu_excess', 'restitution')
    """
    require_above_0(rate=rate, sigma=sigma, sigma_angle=sigma_angle, sigma_omega=sigma_omega)
    if not (np.isfinite(sigma_scale) and sigma_scale >= 0):
        raise InputError.of_field("sigma_scale", sigma_scale, "a number of at least 0")
    require_above_0(sigma_scale=sigma_scale or None)
    check_type("scenario", scenario, Scenario)
    motion = simulate(scenario)
    count = int(motion.duration * rate) + 1
    if not 12 <= count <= MOST_FRAMES:
        raise InputError(f"The record would have {count} frames; a plan needs 12 to {MOST_FRAMES:,}.")
    track = _record(scenario, np.arange(count) / rate, sigma, sigma_angle, sigma_omega)
    ideal = scenario.hoop.load_fraction is not None
    hoop = scenario.hoop if hoop_known or scenario.hoop.massless else "ideal" if ideal else "general"
    run = run_of(track, hoop, _start(scenario), scenario.plane, Sigma())
    values, usual = defaults(run, track)
    values |= _known(scenario, values)
    for name in (*free, *fixed):
        if name in REFUSED or name not in run.names:
            raise InputError(f"{name!r} is no parameter of this plan; it has {', '.join(run.names)}.")
    priors = {}
    if sigma_scale and sigma_omega is None:
        # R below the centre, the plane has an error that follows from that of the scale
        shared = {"scale": Prior(1.0, sigma_scale), "origin_y": Prior(0.0, sigma_scale * run.radius)}
        priors = {name: prior for name, prior in shared.items() if name not in (*free, *fixed)}
    problem = problem_of([replace(run, priors=priors)])
    chosen = {*usual, *free, *priors} - set(fixed)
    names = tuple(name for name in run.names if name in chosen)
    params = parameters(values, names)
    blind = tuple(insensitive(problem, params))
    seen = changed(params, {}, [name for name in names if name not in blind])
    jacobian = slopes(problem, seen)
    whole = Solution(Minimum(seen, 0.0, np.zeros(0)), free_of(seen), inverse(jacobian.T @ jacobian))
    solution, limits, _ = with_limits(problem, whole, names, blind, False)
    errors = {name: float(np.sqrt(solution.covariance[k, k])) for k, name in enumerate(solution.free)}
    unseen = tuple(name for name in names if name in limits and not limits[name][0])
    limits = {name: limit for name, limit in limits.items() if limit[0]}
    never = not set(motion.sequence) & {"S", "K"}
    least = least_static_friction(motion) if never else float("nan")
    return Plan(values, errors, limits, unseen, correlations(solution, set(problem.priors)), motion.sequence, count, least)


def _record(scenario: Scenario, t: np.ndarray, sigma: float, sigma_angle: float | None, sigma_omega: float | None) -> Track:
    """Return the track that a film, or with sigma_omega a phone in the hoop, would give."""
    state = simulate(scenario).at(t)
    radius = scenario.hoop.radius
    spread = np.full(len(t), sigma)
    columns = {"x": state.x, "y": state.height + radius, "sigma_x": spread, "sigma_y": spread}
    if sigma_omega is not None:
        columns = {"omega": state.omega, "sigma_omega": np.full(len(t), sigma_omega)}
    elif sigma_angle is not None:
        columns |= {"angle": state.angle, "sigma_angle": np.full(len(t), sigma_angle)}
    return track_of(t, columns, radius=radius, slope=scenario.plane.slope, placed=True)


def _start(scenario: Scenario) -> str:
    start = scenario.start
    if start.speed is not None:
        return "rolling"
    if start.height > 0 or start.vy > 0:
        return "flying"
    return "rolling" if start.state(scenario.hoop).slip == 0.0 else "sliding"


def _known(scenario: Scenario, values: dict[str, float]) -> dict[str, float]:
    """Values of the parameters in a scenario."""
    known = {name: attrgetter(paths[-1])(scenario) for name, paths in PATHS.items() if name in values}
    known["mu_excess"] -= known["mu_kinetic"]
    known |= {"speed": scenario.start.vx} if "speed" in known else {}
    return {name: float(value) for name, value in known.items() if value is not None}
