"""Derivatives of random motions against differences of motions on either side, with steps halved until they agree."""

import pytest

from differences import compare_derivatives
from random_scenarios import draw, scenario_of

SEED = 59
EVENTS = 40


@pytest.mark.parametrize(
    "indices",
    [range(4), *(pytest.param(range(k, k + 50), marks=[pytest.mark.slow, pytest.mark.random]) for k in range(4, 504, 50))],
)
def test_random_motions(indices):
    """Of most motions something is compared, and nothing is wrong."""
    compared = 0
    for index in indices:
        wrong, count = compare_derivatives(scenario_of(draw(SEED, index), max_events=EVENTS))
        assert not wrong, (index, wrong[:5])
        compared += count > 0
    assert compared > 0.4 * len(indices)
