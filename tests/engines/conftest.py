"""The scripts of the benchmark are no package: its tests import them from their folder."""

import sys

from checkout import ROOT

sys.path.insert(0, str(ROOT / "benchmarks" / "engines"))
