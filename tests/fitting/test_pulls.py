"""Errors over uncertainties of fits to many simulated films: what docs/film.md says of them."""

from itertools import product

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import TRUTH, filmed, posed
from hophoop.fitting.covariance import inverse
from hophoop.fitting.losses import influence, influence_slope
from hophoop.fitting.solving import parameters, slopes

pytestmark = [pytest.mark.compiled, pytest.mark.slow, pytest.mark.timeout(1200)]  # 400 fits take some minutes


def pulls(hop, draws, alike=0.0):
    """Pulls, and the errors that a motion linear in its parameters would have: known from the errors that were drawn."""
    actual, linear = [], []
    problem, values = posed(filmed(hop, frames=240))
    jacobian = slopes(problem, parameters(values, tuple(TRUTH)))
    estimate = (
        -inverse(jacobian.T @ jacobian) @ jacobian.T / np.mean(influence_slope(np.random.default_rng(0).normal(size=10**6)))
    )
    for seed, sign in draws:
        track = filmed(hop, seed, frames=240, alike=alike, sign=sign)
        fit = hh.fit(track)
        assert set(fit.free) == set(TRUTH), seed
        errors = np.array([fit.error(name) for name in TRUTH])
        actual.append([fit.values[name] - true for name, true in TRUTH.items()] / errors)
        linear.append(estimate @ influence(posed(track)[0].residuals(values)) / errors)
    return np.array(actual), np.array(linear)


def test_pulls_have_mean_0_and_spread_1(hop):
    """Each draw comes with both signs: what it has of a mean by itself, 0.07 in 200, cancels, and a bias stays."""
    actual, linear = pulls(hop, product(range(200), (1.0, -1.0)))
    assert np.abs(actual.mean(axis=0)).max() < 0.1
    assert np.abs(actual.std(axis=0) - 1.0).max() < 0.1
    # what the draw does is most of it; the rest is that of the motion's curvature
    assert np.abs((actual - linear).mean(axis=0)).max() < 0.05
    for k, name in enumerate(TRUTH):
        assert np.corrcoef(actual[:, k], linear[:, k])[0, 1] > (0.95 if name == "mu_excess" else 0.99), name


def test_pulls_of_errors_that_last(hop):
    actual, _ = pulls(hop, product(range(60), (1.0,)), alike=0.7)
    # without counting that neighbours are alike the spread would be about √((1 + 0.7)/(1 − 0.7)) = 2.4
    assert 0.8 < np.sqrt((actual**2).mean()) < 1.25
    assert np.abs(actual.mean(axis=0)).max() < 4 / np.sqrt(60)
