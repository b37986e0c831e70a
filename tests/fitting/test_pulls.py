"""Errors over uncertainties of fits to many simulated films; run as a program it prints the numbers of docs/film.md."""

from itertools import product

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import TRUTH, filmed, hopping, posed
from hophoop.fitting.covariance import inverse
from hophoop.fitting.losses import influence, influence_slope
from hophoop.fitting.solving import parameters, slopes

pytestmark = [pytest.mark.compiled, pytest.mark.slow, pytest.mark.timeout(1200)]  # 400 fits take some minutes

NAMES = tuple(TRUTH)


def pulls(hop, seeds, alike=0.0, signs=(1.0, -1.0)):
    """Pulls, and what they would be if the motion were linear in its parameters: known from the errors that were drawn."""
    actual, linear = [], []
    estimate = None
    for seed, sign in product(seeds, signs):
        track = filmed(hop, seed, frames=240, alike=alike, sign=sign)
        fit = hh.fit(track)
        assert set(fit.free) == set(NAMES), seed
        problem, values = posed(track)
        if estimate is None:
            jacobian = slopes(problem, parameters(values, NAMES))
            nodes, weights = np.polynomial.hermite_e.hermegauss(40)
            slope = weights @ influence_slope(nodes) / weights.sum()
            estimate = -inverse(jacobian.T @ jacobian) @ jacobian.T / slope
            size = np.sqrt((estimate**2).sum(axis=1) * (weights @ influence(nodes) ** 2) / weights.sum())
        actual.append([(fit.values[name] - TRUTH[name]) / fit.error(name) for name in NAMES])
        linear.append(estimate @ influence(problem.residuals(values)) / size)
    return np.array(actual), np.array(linear)


@pytest.fixture(scope="module")
def drawn(hop):
    return pulls(hop, range(200))


def test_pulls_have_mean_0_and_spread_1(drawn):
    """Each draw comes with both signs: what it has of a mean by itself, 0.07 in 200, cancels, and a bias stays."""
    actual, _ = drawn
    assert np.abs(actual.mean(axis=0)).max() < 0.1
    assert np.abs(actual.std(axis=0) - 1.0).max() < 0.1


def test_what_the_draw_does_is_most_of_it(drawn):
    """Pulls less what a motion linear in its parameters would have had tell what its curvature does."""
    actual, linear = drawn
    assert np.abs((actual - linear).mean(axis=0)).max() < 0.05
    for k, name in enumerate(NAMES):
        assert np.corrcoef(actual[:, k], linear[:, k])[0, 1] > (0.95 if name == "mu_excess" else 0.99), name
    # the spread of the fits over that of the same draw in a linear motion
    assert np.abs(actual.std(axis=0) / linear.std(axis=0) - 1.0).max() < 0.1


def test_pulls_of_errors_that_last(hop):
    actual, _ = pulls(hop, range(60), alike=0.7, signs=(1.0,))
    # without counting that neighbours are alike the spread would be about √((1 + 0.7)/(1 − 0.7)) = 2.4
    assert 0.8 < np.sqrt((actual**2).mean()) < 1.25
    assert np.abs(actual.mean(axis=0)).max() < 4 / np.sqrt(60)


if __name__ == "__main__":
    hop = hopping()
    for words, seeds, alike in (
        ("200 draws, both signs", range(200), 0.0),
        ("30 of errors that last, ρ = 0.7", range(30), 0.7),
    ):
        actual, linear = pulls(hop, seeds, alike)
        print(words)
        for k, name in enumerate(NAMES):
            print(f"| {name} | {actual[:, k].mean():+.3f} | {actual[:, k].std():.3f} |")
