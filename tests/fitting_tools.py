"""Motions of a known hoop, tracks of them as films would give them, and what a page says of a fit."""

import re

import numpy as np

import hophoop as hh
from checkout import text_of
from hophoop.fitting.problem import defaults, problem_of, run_of
from hophoop.tracking.table import track_of

RADIUS = 0.3
SIGMA, SIGMA_ANGLE = 1e-3, 3e-3
TRUTH = {"gamma": 0.6, "mu_kinetic": 0.45, "mu_excess": 0.1, "restitution": 0.3, "x0": 0.0, "angle0": 0.1, "speed": 1.9}
PLANE = hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3)


def hopping(hoop=None, plane=PLANE, start=None, duration=1.01):
    return hh.simulate(hoop or hh.Hoop.ideal(0.6, radius=RADIUS), plane, start or hh.Start.rolling(1.9, angle=0.1), duration)


def filmed(motion, seed=1, rate=240.0, angle=True, sigma=SIGMA, sigma_angle=SIGMA_ANGLE, frames=None, alike=0.0):
    """A track as a film of a motion would give it; errors of neighbouring frames may correlate."""
    n = frames or int(motion.duration * rate)
    t, errors = np.arange(n) / rate, lasting(np.random.default_rng(seed).normal(0, 1, (3, n)), alike)
    state, radius = motion.at(t), motion.scenario.hoop.radius
    columns = {"x": state.x + sigma * errors[0], "y": state.height + radius + sigma * errors[1]}
    columns |= {"sigma_x": np.full(n, sigma), "sigma_y": np.full(n, sigma)}
    if angle:
        columns |= {"angle": state.angle + sigma_angle * errors[2], "sigma_angle": np.full(n, sigma_angle)}
    return track_of(t, columns, radius=radius, slope=motion.scenario.plane.slope, placed=True, source="a film")


def lasting(errors, alike):
    """Errors of which neighbours correlate, along the last axis, from independent ones."""
    errors = errors.copy()
    for k in range(1, errors.shape[-1]):
        errors[..., k] = alike * errors[..., k - 1] + np.sqrt(1 - alike**2) * errors[..., k]
    return errors


def posed(track, start="rolling", hoop="ideal", plane=PLANE, **known):
    """The problem of a track, and values of its parameters: the truth, and others that are known."""
    problem = problem_of([run_of(track, hoop, start, plane)])
    values, _ = defaults(problem.runs[0], track)
    return problem, values | {name: value for name, value in (TRUTH | known).items() if name in values}


def pulls(fit, truth):
    """Errors over uncertainties; nan where the data do not determine a parameter."""
    return [(fit.values[name] - true) / fit.error(name) if name in fit.free else np.nan for name, true in truth.items()]


def read_again(fit, folder):
    """The fit from its file, which has and says the same."""
    fit.save(folder / "fit.json")
    back = hh.load_fit(folder / "fit.json")
    np.testing.assert_array_equal(back.covariance, fit.covariance)
    np.testing.assert_equal(back.residuals, fit.residuals)
    for one in ("values", "limits", "shares", "correlated", "misfits", "notes", "settings"):
        assert getattr(back, one) == getattr(fit, one)
    for one in ("rows", "sentences", "details", "comparison"):
        assert getattr(back, one)() == getattr(fit, one)()
    return back


ROW = re.compile(r"^\| `(\w+)` \| ([\d.]+) \| ([\d.]+) ± ([\d.]+)", re.MULTILINE)


def is_told(fit, page, names):
    """The table of a page has truth, values and errors of a fit."""
    told = {name: map(float, numbers) for name, *numbers in ROW.findall(text_of(page))}
    assert set(told) == set(names)
    for name, (truth, value, error) in told.items():
        assert truth == TRUTH[name]
        assert abs(fit.values[name] - value) < 0.3 * error
        assert 0.7 * error < fit.error(name) < 1.3 * error
        assert abs(value - truth) < 3 * error
