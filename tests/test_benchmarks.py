"""The commands of benchmarks/ that write tables of the documentation run with today's kernels."""

import argparse
import importlib.util
import sys
from pathlib import Path

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.native import forced
from random_scenarios import scenario_of

FOLDER = Path(__file__).parents[1] / "benchmarks"


@pytest.fixture
def stress():
    spec = importlib.util.spec_from_file_location("stress", FOLDER / "stress.py")
    module = importlib.util.module_from_spec(spec)
    path = list(sys.path)
    spec.loader.exec_module(module)
    yield module
    sys.path[:] = path


def test_random_motions_keep_the_laws_and_are_those_of_simulate(stress):
    numbers = range(4, 10)  # the last one is beside a border
    with forced("interpreted"), np.errstate(all="ignore"):
        result = stress.work((2026, numbers.start, numbers.stop))
        ended = [hh.simulate(scenario_of(stress.drawn_at(2026, index)[1])).status for index in numbers]
    total = stress.together([result])
    told = sum(number for (_, name), number in total["statuses"].items() if name.startswith("completed"))
    in_doubt = sum(number for (_, name), number in total["statuses"].items() if name.startswith("in doubt"))
    assert abs(told - ended.count("completed")) <= in_doubt
    assert all(value < 1e-11 for value, _ in total["worst"].values())
    assert max(value for (_, measure), (value, _) in total["worst"].items() if measure == stress.LEDGER) > 0.0  # it is measured
    assert total["events"]["start"] == len(numbers)
    asked = argparse.Namespace(motions=6, first=4, seed=2026, jobs=1)
    table = stress.markdown(stress.plainly(total, asked, 1.0))
    assert table.startswith("6 motions, numbers 4 to 9 of seed 2026")
    assert "| `start` | 6 | 100 % |" in table
