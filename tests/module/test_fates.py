"""The second module judges what becomes of a motion as the library does."""

import math
from collections import Counter

import numpy as np
import pytest

import hophoop as hh
from hophoop.gaits.computing import FOREVER, PANELS, judged
from hophoop.gaits.kernels.layout import BOTTOM, CODES, Request
from hophoop.lab.wasm.layout import FATE_COLUMNS
from hophoop.lab.wasm.stamp import FATES, HERE
from hophoop.vocabulary.names import FATE_CODES, Fate

pytest.importorskip("wasmtime")

from module.host import Host
from module.module_tools import cell_of

MOST = 300  # passages of a motion that is not decided
SEED = 20261126


@pytest.fixture(scope="module")
def host():
    return Host(HERE / FATES)


def scenarios(count):
    """Random motions on the level and on slopes, most of them gentle; those with friction that holds and those without."""
    random = np.random.default_rng(SEED)
    found = []
    for _ in range(count):
        slope = math.radians(random.choice([0.0, random.uniform(0.1, 5.0), random.uniform(5.0, 35.0)]))
        plane = hh.Plane(
            mu=random.choice([0.0, random.uniform(0.2, 1.2)], p=[0.05, 0.95]),
            slope=slope,
            restitution=random.choice([0.0, random.uniform(0.0, 0.6)]),
            rolling_resistance=random.choice([0.0, 0.01], p=[0.8, 0.2]),
        )
        start = hh.Start.rolling(random.uniform(-4.0, 4.0))
        found.append(hh.Scenario(hoop=hh.Hoop.ideal(random.uniform(0.1, 0.9)), plane=plane, start=start))
    return found


def assert_same(host, scenario):
    """Fate, period, hops and all numbers are those of the library."""
    cell = cell_of(scenario)
    codes, numbers = judged(cell.reshape(-1, 1).copy(), Request(BOTTOM, MOST, FOREVER, PANELS, True))
    found = host.fate(cell, MOST)
    expected = dict(zip(FATE_COLUMNS, [*codes[0], *numbers[0]], strict=True))
    for name in CODES:
        assert found[name] == expected[name], (scenario.to_query(), name)
    for name in FATE_COLUMNS[len(CODES) :]:
        assert found[name] == pytest.approx(expected[name], rel=1e-12, nan_ok=True), (scenario.to_query(), name)
    return FATE_CODES[int(found["fate"])]


def test_fates_of_random_motions_are_the_same(host):
    """And of one that is chaotic."""
    chaotic = hh.Scenario(plane=hh.Plane(slope=math.radians(4.0)), start=hh.Start.rolling(2.0))
    fates = Counter(assert_same(host, scenario) for scenario in [*scenarios(60), chaotic])
    assert {Fate.ROCKS, Fate.RESTS, Fate.GAIT, Fate.RUNS_AWAY, Fate.CHAOTIC} <= fates.keys()
