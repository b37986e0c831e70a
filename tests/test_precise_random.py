"""The kernel against motions in many digits: random scenarios of every kind, all of their events."""

import pytest

import hophoop as hh
from hophoop.precise import compare
from random_scenarios import draw, scenario_of

SEED = 2026
DIGITS = 20
EVENTS = 40
LEAST, LEAST_OF_LIGHT = 8.0, 3.0  # digits beside the number or its unit; nearly massless rings lose more at the bottom


@pytest.mark.parametrize("indices", [range(10), *(pytest.param(range(k, k + 30), marks=pytest.mark.long) for k in (10, 40))])
def test_random_motions(indices):
    for index in indices:
        scenario = scenario_of(draw(SEED, index), max_events=EVENTS)
        precise = hh.simulate(scenario, digits=DIGITS)
        assert precise.digits_right >= DIGITS, index
        agreement = compare(hh.simulate(scenario), precise)
        assert not agreement.difference, index
        assert not agreement.rows or agreement.least >= (LEAST if scenario.hoop.inertia_ratio > 1e-2 else LEAST_OF_LIGHT), index
