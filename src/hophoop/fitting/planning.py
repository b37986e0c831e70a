"""Plan a film, or a record of a phone in the hoop: a fit to the record without errors."""

from __future__ import annotations

from collections.abc import Sequence
from operator import attrgetter

import numpy as np

from hophoop._support.errors import check_type
from hophoop.fitting.channels import Values, with_errors
from hophoop.fitting.fitting import Settings, fit_near
from hophoop.fitting.parameters import PARAMETERS
from hophoop.fitting.problem import RIM_ERROR
from hophoop.fitting.result import Fit
from hophoop.scenario import InputError, Scenario
from hophoop.simulation.simulate import simulate
from hophoop.tracking import Camera, View
from hophoop.tracking.hints import require_above_0
from hophoop.tracking.table import track_of

MOST_FRAMES = 200_000


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
) -> Fit:
    """Predict a fit to a film of a motion, or to the record of a phone in the hoop: its uncertainties and limits.

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
    plan : Fit
        To the record without errors.

    Raises
    ------
    ValueError
        If a name is unknown, a number out of range, or the motion too short.

    Examples
    --------
    >>> import hophoop as hh
    >>> scenario = hh.Scenario(hoop=hh.Hoop.ideal(0.6, radius=0.3), start=hh.Start.rolling(1.5), duration=0.3)
    >>> sorted(hh.plan(scenario, rate=120.0).limits)
    ['mu_excess', 'mu_kinetic', 'mu_static', 'restitution']
    """
    require_above_0(rate=rate, sigma=sigma, sigma_angle=sigma_angle, sigma_omega=sigma_omega)
    if not 0.0 <= sigma_scale < np.inf:
        raise InputError.of_field("sigma_scale", sigma_scale, "a number of at least 0")
    require_above_0(sigma_scale=sigma_scale or None)
    check_type("scenario", scenario, Scenario)
    motion = simulate(scenario)
    count = int(motion.duration * rate) + 1
    if not 12 <= count <= MOST_FRAMES:
        raise InputError(f"The record would have {count} frames; a plan needs 12 to {MOST_FRAMES:,}.")
    t, radius, view = np.arange(count) / rate, scenario.hoop.radius, None
    state = motion.at(t)
    if sigma_omega is not None:
        columns = {"omega": state.omega}
    else:
        columns = {"x": state.x, "y": state.height + radius} | ({} if sigma_angle is None else {"angle": state.angle})
    if sigma_scale and sigma_omega is None:
        pixels = RIM_ERROR / (sigma_scale * radius)  # per metre
        view = View(Camera(2, 2, 1.0), pixels, 0.0, 0.0, 0.0, scale_error=sigma_scale, height_error=0.0)
    track = track_of(t, columns, radius=radius, slope=scenario.plane.slope, placed=True, view=view)
    ideal = scenario.hoop.load_fraction is not None
    hoop = scenario.hoop if hoop_known or scenario.hoop.massless else "ideal" if ideal else "general"
    known = _known(scenario)
    how = Settings(hoop, _start(scenario), {name: known.get(name, 0.0) for name in fixed}, free, plane=scenario.plane)
    errors = {"places": sigma, "angles": sigma_angle, "omegas": sigma_omega}
    return fit_near(with_errors(track, errors), how, known)


def _start(scenario: Scenario) -> str:
    start = scenario.start
    if start.height > 0 or start.vy > 0:
        return "flying"
    return "rolling" if start.state(scenario.hoop).slip == 0.0 else "sliding"


def _known(scenario: Scenario) -> Values:
    """Values of the parameters, those in a scenario and others."""
    known = {name: attrgetter(one.paths[-1])(scenario) if one.paths else one.usual for name, one in PARAMETERS.items()}
    known |= {"speed": scenario.start.vx, "mu_excess": known["mu_excess"] - known["mu_kinetic"]}
    return {name: float(value) for name, value in known.items() if value is not None}
