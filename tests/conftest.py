"""How hypothesis looks for counterexamples, and how long a test may take."""

import itertools
import math
import os

import pytest
from hypothesis import settings

# Interpreted kernels and a busy machine make any deadline unfair; CI repeats the same examples every time.
settings.register_profile("hophoop", deadline=None, print_blob=True)
settings.register_profile("ci", parent=settings.get_profile("hophoop"), derandomize=True)
settings.load_profile("ci" if os.environ.get("CI") else "hophoop")


@pytest.hookimpl(trylast=True)  # what is not asked for is left out before
def pytest_collection_modifyitems(items):
    """Let slow and long tests take more than the usual limit (pyproject.toml), and each worker begin with the longest ones."""
    longest = [item for item in items[::-1] if item.get_closest_marker("random") or item.get_closest_marker("timeout")]
    others = iter([item for item in items if item not in longest])
    workers = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", "1"))
    share = math.ceil(len(items) / workers)  # as xdist deals them
    parts = [longest[worker::workers] for worker in range(workers)]
    items[:] = [item for part in parts for item in (*part, *itertools.islice(others, share - len(part)))]
    for item in items:
        if (item.get_closest_marker("slow") or item.get_closest_marker("long")) and not item.get_closest_marker("timeout"):
            item.add_marker(pytest.mark.timeout(3600))  # several share a processor
