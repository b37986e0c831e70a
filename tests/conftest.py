"""How hypothesis looks for counterexamples, and how long a test may take."""

import os

import pytest
from hypothesis import settings

# Interpreted kernels and a busy machine make any deadline unfair; CI repeats the same examples every time.
settings.register_profile("hophoop", deadline=None, print_blob=True)
settings.register_profile("ci", parent=settings.get_profile("hophoop"), derandomize=True)
settings.load_profile("ci" if os.environ.get("CI") else "hophoop")


def pytest_collection_modifyitems(items):
    """Tests marked slow or long may take more than the usual limit (pyproject.toml): several share a processor."""
    for item in items:
        if (item.get_closest_marker("slow") or item.get_closest_marker("long")) and not item.get_closest_marker("timeout"):
            item.add_marker(pytest.mark.timeout(3600))
