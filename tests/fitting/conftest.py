"""A motion with a hop, and a fit to a film of it."""

import pytest

import hophoop as hh
from fitting_tools import filmed, hopping


@pytest.fixture(scope="session")
def hop():
    return hopping()


@pytest.fixture(scope="session")
def found(hop):
    return hh.fit(filmed(hop))
