"""Set up before anything imports hophoop, for the tests and for the doctests in src/ alike."""

import os
import tempfile
from pathlib import Path

import pytest

# Tests keep their compiled kernels apart from the user's own. hophoop._jit puts them into a folder named by a
# hash of the source, so that an edited kernel is never met with an old result.
if "NUMBA_CACHE_DIR" not in os.environ:
    user = os.getuid() if hasattr(os, "getuid") else os.environ.get("USERNAME", "user")
    os.environ["NUMBA_CACHE_DIR"] = str(Path(tempfile.gettempdir()) / f"hophoop-tests-{user}")

# Figures are drawn without a display.
os.environ.setdefault("MPLBACKEND", "agg")

# the fixture `browser`, for the lab's page and for the documentation's
pytest_plugins = ["browser_tools"]


@pytest.hookimpl(tryfirst=True)  # workers start after this
def pytest_sessionstart(session):
    import compile_ahead

    if compile_ahead.asked(session.config):
        with session.config.pluginmanager.getplugin("capturemanager").global_and_fixture_disabled():
            compile_ahead.compile_ahead()
