"""Where fast motion begins to grow, by examples/runaway.py, which leaves out the flights, against motions with them."""

import math
import runpy
from pathlib import Path

import pytest

import hophoop as hh

EXAMPLE = runpy.run_path(str(Path(__file__).parents[2] / "examples" / "runaway.py"))


@pytest.mark.parametrize(("degrees", "least", "most"), [(33.3, -math.inf, -2.0), (34.31, -3.0, 3.0), (35.3, 2.0, math.inf)])
def test_the_critical_slope_is_that_of_motions_with_their_flights(degrees, least, most):
    """34.31° ± 0.08° is from 9,000 landings a slope, computed with gravity and long flights."""
    rate, error = EXAMPLE["growth"](hh.Hoop.ideal(0.75), hh.Plane(), math.radians(degrees), 1_000, 7)
    assert least < rate / error < most
