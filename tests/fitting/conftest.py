"""A motion with a hop, and a fit to a film of it."""

import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

import hophoop as hh
from fitting_tools import filmed, hopping

# alone, as `rigid` is a benchmark as well as a folder of tests
spec = spec_from_file_location("fits", Path(__file__).parents[2] / "benchmarks" / "fits.py")
fits = sys.modules["fits"] = module_from_spec(spec)
spec.loader.exec_module(fits)


@pytest.fixture(scope="session")
def hop():
    return hopping()


@pytest.fixture(scope="session")
def found(hop):
    return hh.fit(filmed(hop))
