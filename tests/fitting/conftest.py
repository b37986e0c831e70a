"""A motion with a hop, and a fit to a film of it."""

import sys
from pathlib import Path

import pytest

import hophoop as hh
from fitting_tools import filmed, hopping

sys.path.append(str(Path(__file__).parents[2] / "benchmarks"))


@pytest.fixture(scope="session")
def hop():
    return hopping()


@pytest.fixture(scope="session")
def found(hop):
    return hh.fit(filmed(hop))
