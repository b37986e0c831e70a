"""The built pages, as CI's part `docs` makes them; elsewhere these tests are left out."""

import os
from pathlib import Path

import pytest

from browser_tools import served


@pytest.fixture(scope="session")
def site():
    """The folder of the pages."""
    folder = os.environ.get("HOPHOOP_BUILT_SITE")
    if folder is None:
        pytest.skip("HOPHOOP_BUILT_SITE names no built documentation (.ci/run docs does)")
    return Path(folder)


@pytest.fixture(scope="session")
def address(site):
    """The pages on loopback."""
    with served(site) as address:
        yield address
