"""Set up before anything imports hophoop, for the tests and for the doctests in src/ alike."""

import gc
import os
import signal
import tempfile
from pathlib import Path

import pytest

# Tests keep their compiled kernels apart from the user's own. hophoop._jit puts them into a folder named by a
# hash of the source, so that an edited kernel is never met with an old result.
if "NUMBA_CACHE_DIR" not in os.environ:
    user = os.getuid() if hasattr(os, "getuid") else os.environ.get("USERNAME", "user")
    os.environ["NUMBA_CACHE_DIR"] = str(Path(tempfile.gettempdir()) / f"hophoop-tests-{user}")

# They are about the sources: a library of compiled kernels is used by those that build one, or where it is named.
os.environ.setdefault("HOPHOOP_LIBRARY", str(Path(tempfile.gettempdir()) / "no hophoop library"))

# Some tests are about Ctrl-C, which a shell has what it starts in the background ignore; workers take over what is set here.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# Figures are drawn without a display.
os.environ.setdefault("MPLBACKEND", "agg")

# the fixture `browser`, for the lab's page and for the documentation's
pytest_plugins = ["browser_tools"]


def pytest_addoption(parser):
    parser.addoption("--other-tables", type=int, metavar="SEED", help="tables of the solver off by a rounding")


def pytest_configure(config):
    if (seed := config.getoption("other_tables", None)) is not None:
        import other_tables

        other_tables.move_tables(seed)


@pytest.hookimpl(tryfirst=True)  # workers start after this
def pytest_sessionstart(session):
    import compile_ahead

    if compile_ahead.asked(session.config):
        with session.config.pluginmanager.getplugin("capturemanager").global_and_fixture_disabled():
            compile_ahead.compile_ahead()


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_collection():
    gc.disable()  # it makes millions of objects that stay: to look through them, then and at the end, took half of the time
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()
