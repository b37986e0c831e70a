"""How hypothesis looks for counterexamples."""

import os

from hypothesis import settings

# The first example compiles kernels, so that no deadline is fair; CI repeats the same examples every time.
settings.register_profile("hophoop", deadline=None, print_blob=True)
settings.register_profile("ci", parent=settings.get_profile("hophoop"), derandomize=True)
settings.load_profile("ci" if os.environ.get("CI") else "hophoop")
