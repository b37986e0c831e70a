"""The kernel against motions in many digits: random scenarios of every kind, all of their events."""

from __future__ import annotations

import pytest

import hophoop as hh
from hophoop.precise import compare
from random_scenarios import draw, scenario_of

SEED = 2026
DIGITS = 20
EVENTS = 40
BLOCK = 50
# Digits that the kernel must have beside the number or its unit; nearly massless rings lose more at the bottom.
LEAST = {0: 8.0, 1: 8.0, 2: 3.0}
# 810: μ = 0, rolled off at the top, with a ring of 1e-12 of the mass: v_t grazes zero once a turn, exactly, and to tell a
# graze from a crossing takes minutes.
# In 591, 601 and 864 the hoop turns round again and again within 1e-20 rad of p_σ = 0 (a < 0): minutes for many digits, and
# the kernel, which books an impulse there, has 7 digits of the next stick in 601.
LEFT_OUT = {591, 601, 810, 864}


def disagreement(index: int) -> str:
    """What is wrong with the kernel's motion of an index, '' where nothing is."""
    kind, sections = draw(SEED, index)
    scenario = scenario_of(sections, max_events=EVENTS)
    precise = hh.simulate(scenario, digits=DIGITS)
    if precise.digits_right < DIGITS:
        return f"{index}: only {precise.digits_right} digits are certain"
    agreement = compare(hh.simulate(scenario), precise)
    if agreement.difference:
        return f"{index}: {agreement.difference}"
    if agreement.rows and agreement.least < LEAST[kind]:
        return f"{index}: {agreement.least:.1f} digits"
    return ""


# 15 takes as long as all others
@pytest.mark.parametrize(
    "index", [i if i < 10 else pytest.param(i, marks=pytest.mark.long) for i in range(30) if i not in LEFT_OUT | {15}]
)
def test_random_motion(index):
    """A few in every run, a few dozen in CI."""
    assert disagreement(index) == ""


@pytest.mark.slow
@pytest.mark.random
@pytest.mark.parametrize("first", range(0, 1000, BLOCK))
def test_a_thousand_random_motions(first):
    """In blocks, which several processes share."""
    found = [text for index in range(first, first + BLOCK) if index not in LEFT_OUT and (text := disagreement(index))]
    assert found == []
