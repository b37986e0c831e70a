"""Rules between fields: one function of the kernel decides for scenarios, whole maps and the page's module."""

import math
import random
from collections import Counter

import numpy as np

import hophoop as hh
from hophoop.kernel.records.cells import Cell
from hophoop.kernel.records.refusals import Refusal, refusal
from hophoop.maps.grid.cells import make_cells
from hophoop.scenario import InputError


def draw(seed):
    random_ = random.Random(seed)
    hoop = random_.choice(
        [
            {"load_fraction": random_.choice([1.0, 1.0 - 2.0 ** -random_.randint(1, 53), random_.random()])},
            {
                "eccentricity": random_.choice([1.0, random_.random()]),
                "inertia_ratio": random_.choice([0.0, random_.random() + 1e-3]),
            },
        ]
    )
    static = random_.choice([0.0, 0.5, math.inf])
    plane = {
        "mu_static": static,
        "mu_kinetic": random_.choice([static, 0.4]),
        "slope": random_.choice([0.0, 1.57, -0.2, 1.571]),
    }
    plane["rolling_resistance"] = random_.choice([0.0, random_.random(), 1e-9])
    start = {"vx": random_.uniform(-1.0, 1.0) * 10.0 ** random_.randint(0, 5), "height": random_.choice([0.0, 1e5])}
    return hoop, plane, start


def test_maps_and_scenarios_refuse_the_same_cells():
    """Before, maps computed an ideal hoop whose inertia is too small for a scenario."""
    verdicts = Counter()
    for seed in range(1500):
        hoop, plane, start = draw(seed)
        values = {f"hoop.{name}": value for name, value in hoop.items()}
        values |= {f"plane.{name}": value for name, value in plane.items()} | {f"start.{name}": v for name, v in start.items()}
        cells = make_cells(hh.Scenario(), {path: np.array([value]) for path, value in values.items()}, 1)
        allowed = bool(cells[Cell.ALLOWED, 0])
        try:
            hh.Scenario(hoop=hh.Hoop(**hoop), plane=hh.Plane(**plane), start=hh.Start(**start))
        except InputError:
            assert not allowed, values
        else:
            assert allowed, values
        assert allowed == (refusal(cells[:, 0], ())[0] == Refusal.NONE)
        verdicts[allowed] += 1
    assert min(verdicts[True], verdicts[False]) > 250
