"""The kernel against motions in many digits: random scenarios of every kind, all of their events."""

from __future__ import annotations

import pytest

import hophoop as hh
from hophoop.precise import compare
from random_scenarios import draw, scenario_of

SEED = 2026
DIGITS = 20
EVENTS = 40
LEAST, LEAST_OF_LIGHT = 8.0, 3.0  # digits beside the number or its unit; nearly massless rings lose more at the bottom


def disagreement(index: int) -> str:
    """What is wrong with the kernel's motion of an index, '' where nothing is."""
    scenario = scenario_of(draw(SEED, index), max_events=EVENTS)
    precise = hh.simulate(scenario, digits=DIGITS)
    if precise.digits_right < DIGITS:
        return f"{index}: only {precise.digits_right} digits are certain"
    agreement = compare(hh.simulate(scenario), precise)
    if agreement.difference:
        return f"{index}: {agreement.difference}"
    if agreement.rows and agreement.least < (LEAST if scenario.hoop.inertia_ratio > 1e-2 else LEAST_OF_LIGHT):
        return f"{index}: {agreement.least:.1f} digits"
    return ""


def test_ten_random_motions():
    found = {index: disagreement(index) for index in range(10)}
    assert {index: text for index, text in found.items() if text} == {}


@pytest.mark.long
@pytest.mark.parametrize("first", range(10, 70, 30))
def test_random_motions(first):
    """In blocks, which several processes share."""
    found = {index: disagreement(index) for index in range(first, first + 30)}
    assert {index: text for index, text in found.items() if text} == {}
