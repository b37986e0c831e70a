"""Mass properties of hoops assembled from parts, as rows of numbers; scenario/test_scenario.py has each shape."""

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.records import cells


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_how_far_a_part_reaches(way):
    at = 0.3 * way
    for part, reach in (
        (hh.Ring(1.0, 0.25, 0.5), 0.5),
        (hh.Disk(1.0, 0.25, at), 0.55),
        (hh.PointMass(1.0, at), 0.3),
        (hh.Rod(1.0, 0.25, at), 0.425),
        (hh.Rod(1.0, 0.25, at, "tangential"), 0.325),
    ):
        assert part.reach == pytest.approx(reach, rel=1e-15)


def test_parts_in_one_place_are_a_point_there():
    """To the last bit, whatever the weights; on the rim also where their place is rounded."""
    random = np.random.default_rng(6)
    for radius, at in random.uniform([0.1, 0.0], [3.0, 0.1], (50, 2)):
        parts = np.array([[cells.POINT_MASS, weight, 0.0, 0.0, at] for weight in random.uniform(0.1, 2.0, 3)])
        assert cells.combined(radius, parts)[1:] == (at / radius, 0.0)
    for at in (1.0 + 1e-12, -1.0 - 1e-12):
        assert cells.combined(1.0, np.array([[cells.POINT_MASS, 2.0, 0.0, 0.0, at]])) == (2.0, 1.0, 0.0)
