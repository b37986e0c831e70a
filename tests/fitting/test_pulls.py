"""Errors over uncertainties of fits to many records: what docs/film.md says of them."""

from itertools import product

import numpy as np
import pytest

import hophoop as hh
from fitting_tools import TRUTH, filmed, pulls

pytestmark = [pytest.mark.slow, pytest.mark.timeout(1200)]  # 400 fits take some minutes


@pytest.mark.parametrize(
    ("seeds", "signs", "alike", "mean", "spread"), [(200, (1, -1), 0.0, 0.1, 0.15), (60, (1,), 0.7, 0.5, 0.25)]
)
def test_pulls_of_films_have_mean_0_and_spread_1(hop, seeds, signs, alike, mean, spread):
    """Draws with both signs: what they have of a mean by themselves, 0.07 in 200, cancels, and a bias stays.

    The spread of 200 has a standard deviation of 0.05.

    Without counting that neighbours are alike the spread would be about √((1 + 0.7)/(1 − 0.7)) = 2.4.
    """
    found = [
        pulls(hh.fit(filmed(hop, seed, frames=240, alike=alike, sign=sign)), TRUTH)
        for seed, sign in product(range(seeds), signs)
    ]
    assert np.isfinite(found).all()
    assert np.abs(np.mean(found, axis=0)).max() < mean
    assert np.abs(np.std(found, axis=0) - 1.0).max() < spread
