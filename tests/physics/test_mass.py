"""Mass properties of hoops assembled from parts: against sums over points."""

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.records import cells


def points_of(part):
    """Places along and across of points of equal mass that a part may be taken for."""
    share = (np.arange(200) + 0.5) / 200
    if isinstance(part, hh.PointMass):
        return np.array([part.at]), np.zeros(1)
    if isinstance(part, hh.Rod):
        place, nothing = part.length * (share - 0.5), np.zeros(200)
        along, across = (place, nothing) if part.direction == "radial" else (nothing, place)
        return part.at + along, across
    inner, outer = (part.inner_radius, part.outer_radius) if isinstance(part, hh.Ring) else (0.0, part.radius)
    radii, turns = np.sqrt(inner**2 + share * (outer**2 - inner**2)), 0.5 * np.pi * np.arange(4)[:, None]
    return part.at + radii * np.cos(turns), radii * np.sin(turns)


def test_parts_add_up_as_their_points_do():
    random = np.random.default_rng(5)
    for _ in range(200):
        radius = 10 ** random.uniform(-2, 1)
        parts = [hh.Ring(random.uniform(0.1, 2), 0.9 * radius, radius)]
        for kind in random.integers(4, size=3):
            weight, size, at = random.uniform(0.01, 1), radius * random.uniform(0.01, 0.3), radius * random.uniform(-0.6, 0.6)
            make = [hh.Disk, lambda weight, _, at: hh.PointMass(weight, at), hh.Rod, lambda *one: hh.Rod(*one, "tangential")]
            parts.append(make[kind](weight, size, at))
        hoop = hh.Hoop.from_parts(radius, parts)
        points = [(part.mass, *points_of(part)) for part in parts]
        whole = sum(part.mass for part in parts)
        centre = sum(mass * np.mean(along) for mass, along, _ in points) / whole
        spread = sum(mass * np.mean((along - centre) ** 2 + across**2) for mass, along, across in points) / whole
        assert hoop.mass == pytest.approx(whole, rel=1e-12)
        assert hoop.eccentricity == pytest.approx(abs(centre) / radius, rel=1e-10, abs=1e-14)
        assert hoop.inertia_ratio == pytest.approx(spread / radius**2, rel=2e-5)


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


def test_the_ideal_hoop_is_a_ring_and_a_point():
    for gamma in (0.1, 0.75, 0.99):
        parts = np.array([[cells.RING, 1.0 - gamma, 1.0, 1.0, 0.0], [cells.POINT_MASS, gamma, 0.0, 0.0, 1.0]])
        assert cells.combined(1.0, parts) == pytest.approx((1.0, gamma, cells.ideal_inertia(gamma)), rel=1e-14)
        assert cells.ideal_inertia(gamma) == pytest.approx(math.fsum([1.0, -gamma * gamma]), rel=1e-14)
