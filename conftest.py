"""Set up before anything imports hophoop, for the tests and for the doctests in src/ alike."""

import gc
import os
import signal

import pytest

# Some tests are about Ctrl-C, which a shell has what it starts in the background ignore; workers take over what is set here.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)

# Figures are drawn without a display.
os.environ.setdefault("MPLBACKEND", "agg")

# the fixture `browser`, for the lab's page and for the documentation's
pytest_plugins = ["browser_tools"]


@pytest.hookimpl(optionalhook=True)  # of pytest-xdist
def pytest_xdist_auto_num_workers(config):
    """One worker for each processor; pytest-xdist itself counts cores, which may be half as many."""
    return os.cpu_count() or 1


@pytest.hookimpl(tryfirst=True)  # workers start after this
def pytest_sessionstart(session):
    if hasattr(session.config, "workerinput") or session.config.option.collectonly:
        return
    from hophoop.kernel.native.library import mode, why_missing

    if mode() != "interpreted" and (why := why_missing()):
        raise pytest.UsageError(f"{why} The tests take hours without; HOPHOOP_KERNELS=interpreted asks for that.")


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_collection():
    gc.disable()  # it makes millions of objects that stay: to look through them, then and at the end, took half of the time
    try:
        return (yield)
    finally:
        gc.freeze()
        gc.enable()
