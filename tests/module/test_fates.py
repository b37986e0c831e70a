"""The second module judges what becomes of a motion as the library does."""

import math
from collections import Counter

import pytest

import hophoop as hh
from hophoop.gaits.computing import judged
from hophoop.gaits.kernels.layout import BOTTOM, CODES, Request
from hophoop.lab.wasm.layout import FATE_COLUMNS
from hophoop.lab.wasm.stamp import FATES
from hophoop.vocabulary.names import FATE_CODES, Fate, identifier
from module.module_tools import answered, cell_of, given_of, needs_node
from random_scenarios import rolling

MOST = 300  # passages of a motion that is not decided
SEED = 20261126


def assert_same(scenario, found):
    """Fate, period, hops and all numbers are those of the library."""
    codes, numbers = judged(cell_of(scenario).reshape(-1, 1).copy(), Request(BOTTOM, MOST, True))
    code, *others = codes[0]
    assert found["fate"] == identifier(FATE_CODES[code]), scenario.to_query()
    assert [found[name] for name in CODES[1:]] == others, scenario.to_query()
    given = [float(found[name]) for name in FATE_COLUMNS[len(CODES) :]]
    assert given == pytest.approx(list(numbers[0]), rel=1e-12, nan_ok=True), scenario.to_query()
    return FATE_CODES[code]


@needs_node
def test_fates_of_random_motions_are_the_same():
    """And of one that is chaotic."""
    chaotic = hh.Scenario(plane=hh.Plane(slope=math.radians(4.0)), start=hh.Start.rolling(2.0))
    asked = [*(rolling(SEED, index) for index in range(60)), chaotic]
    found = answered([["fate", given_of(scenario), MOST] for scenario in asked], FATES)
    fates = Counter(map(assert_same, asked, found))
    assert {Fate.ROCKS, Fate.RESTS, Fate.GAIT, Fate.RUNS_AWAY, Fate.CHAOTIC} <= fates.keys()
