"""Errors over uncertainties of fits to many simulated films; run as a program it prints the numbers of docs/film.md."""

from itertools import product

import numpy as np
import pytest

import hophoop as hh
from hophoop.fitting.channels import Sigma
from hophoop.fitting.covariance import inverse
from hophoop.fitting.losses import influence, influence_slope
from hophoop.fitting.problem import defaults, problem_of, run_of
from hophoop.fitting.solving import parameters, slopes
from hophoop.tracking.table import track_of

pytestmark = [pytest.mark.compiled, pytest.mark.slow, pytest.mark.timeout(1200)]  # 400 fits take some minutes

RADIUS = 0.3
SIGMA, SIGMA_ANGLE = 1e-3, 3e-3
TRUTH = {"gamma": 0.6, "mu_kinetic": 0.45, "mu_excess": 0.1, "restitution": 0.3, "x0": 0.0, "angle0": 0.1, "speed": 1.9}
PLANE = hh.Plane(mu_static=0.55, mu_kinetic=0.45, restitution=0.3)
NAMES = tuple(TRUTH)


def motion():
    return hh.simulate(hh.Hoop.ideal(0.6, radius=RADIUS), PLANE, hh.Start.rolling(1.9, angle=0.1), 1.01)


def filmed(hop, seed, alike=0.0, sign=1.0):
    """240 frames with errors of which neighbours may correlate."""
    rng = np.random.default_rng(seed)
    t = np.arange(240) / 240.0
    state = hop.at(t)
    errors = rng.normal(0, 1, (3, 240))
    for k in range(1, 240):
        errors[:, k] = alike * errors[:, k - 1] + np.sqrt(1 - alike**2) * errors[:, k]
    sizes = {"x": SIGMA, "y": SIGMA, "angle": SIGMA_ANGLE}
    true = {"x": state.x, "y": state.height + RADIUS, "angle": state.angle}
    columns = {name: true[name] + sign * sizes[name] * errors[k] for k, name in enumerate(true)}
    columns |= {f"sigma_{name}": np.full(240, size) for name, size in sizes.items()}
    return track_of(t, columns, radius=RADIUS, placed=True)


def pulls(hop, seeds, alike=0.0, signs=(1.0, -1.0)):
    """Pulls, and what they would be if the motion were linear in its parameters: known from the errors that were drawn."""
    actual, linear = [], []
    estimate = None
    for seed, sign in product(seeds, signs):
        track = filmed(hop, seed, alike, sign)
        fit = hh.fit(track)
        assert set(fit.free) == set(NAMES), seed
        problem = problem_of([run_of(track, "ideal", "rolling", PLANE, Sigma())])
        values, _ = defaults(problem.runs[0], track)
        values |= TRUTH
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
def hop():
    return motion()


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
    hop = motion()
    for words, seeds, alike in (
        ("200 draws, both signs", range(200), 0.0),
        ("30 of errors that last, ρ = 0.7", range(30), 0.7),
    ):
        actual, linear = pulls(hop, seeds, alike)
        print(words)
        for k, name in enumerate(NAMES):
            print(f"| {name} | {actual[:, k].mean():+.3f} | {actual[:, k].std():.3f} |")
