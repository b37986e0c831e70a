"""Where fast motion begins to grow, by examples/in_the_end.py, which leaves out the flights, against motions with them."""

import math
import runpy
from pathlib import Path

import pytest

import hophoop as hh

pytest.importorskip("matplotlib", reason="the extra 'plots' is not installed")
EXAMPLE = runpy.run_path(str(Path(__file__).parents[2] / "examples" / "in_the_end.py"))


def test_the_critical_slope_is_that_of_motions_with_their_flights():
    """34.31° ± 0.08° is from 9,000 landings a slope, computed with gravity and long flights."""
    slope, error = EXAMPLE["critical_slope"](hh.Hoop.ideal(0.75), hh.Plane(), 4_000, 7)
    assert abs(math.degrees(slope) - 34.31) < 3 * math.hypot(0.08, math.degrees(error))
