"""Mass properties of parts: against the scenario's own sums, and the parallel axis theorem by quadrature."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.records import cells


def table_of(hoop: hh.Hoop) -> np.ndarray:
    rows = []
    for part in hoop.parts or ():
        if isinstance(part, hh.Ring):
            rows.append([cells.RING, part.mass, part.inner_radius, part.outer_radius, 0.0])
        elif isinstance(part, hh.Disk):
            rows.append([cells.DISK, part.mass, part.radius, 0.0, part.at])
        elif isinstance(part, hh.PointMass):
            rows.append([cells.POINT_MASS, part.mass, 0.0, 0.0, part.at])
        else:
            kind = cells.RADIAL_ROD if part.direction == "radial" else cells.TANGENTIAL_ROD
            rows.append([kind, part.mass, part.length, 0.0, part.at])
    return np.array(rows)


def hoops() -> list[hh.Hoop]:
    random = np.random.default_rng(5)
    found = []
    for _ in range(200):
        radius = float(10 ** random.uniform(-2, 1))
        parts = [hh.Ring(float(random.uniform(0.1, 2)), 0.9 * radius, radius)]
        for _ in range(int(random.integers(0, 4))):
            at, size = (float(each) * radius for each in (random.uniform(-0.6, 0.6), random.uniform(0.01, 0.3)))
            weight = float(random.uniform(0.01, 1))
            parts.append(
                [
                    hh.Disk(weight, size, at),
                    hh.PointMass(weight, at),
                    hh.Rod(weight, size, at),
                    hh.Rod(weight, size, at, "tangential"),
                ][int(random.integers(4))]
            )
        found.append(hh.Hoop.from_parts(radius, parts))
    return found


def test_parts_add_up_as_in_the_scenario() -> None:
    for hoop in hoops():
        whole, eccentricity, inertia = cells.combined(hoop.radius, table_of(hoop))
        assert whole == hoop.mass
        assert eccentricity == pytest.approx(hoop.eccentricity, rel=1e-14, abs=1e-16)
        assert inertia == pytest.approx(hoop.inertia_ratio, rel=1e-14)
        reaches = [cells.part_reach(row[0], row[2], row[3], row[4]) for row in table_of(hoop)]
        assert reaches == [part.reach for part in hoop.parts or ()]


def points_of(part: object) -> np.ndarray:
    """(mass, along, across) of points that a part may be taken for: on rings of equal area, on pieces of equal length."""
    share = (np.arange(200) + 0.5) / 200
    if isinstance(part, hh.PointMass):
        return np.array([[part.mass, part.at, 0.0]])
    if isinstance(part, hh.Rod):
        place, nothing = part.length * (share - 0.5), np.zeros(200)
        along, across = (place, nothing) if part.direction == "radial" else (nothing, place)
        return np.stack([np.full(200, part.mass / 200), part.at + along, across], axis=1)
    assert isinstance(part, hh.Ring | hh.Disk)
    inner, outer = (part.inner_radius, part.outer_radius) if isinstance(part, hh.Ring) else (0.0, part.radius)
    radii = np.sqrt(inner**2 + share * (outer**2 - inner**2))[:, None]
    angles = 0.5 * np.pi * np.arange(4)
    along, across = part.at + radii * np.cos(angles), radii * np.sin(angles)
    return np.stack([np.full(800, part.mass / 800), along.ravel(), across.ravel()], axis=1)


def test_parts_add_up_as_their_points_do() -> None:
    for hoop in hoops():
        whole, eccentricity, inertia = cells.combined(hoop.radius, table_of(hoop))
        points = np.concatenate([points_of(part) for part in hoop.parts or ()])
        weights, along, across = (points / [1.0, hoop.radius, hoop.radius]).T
        centre = np.sum(weights * along) / np.sum(weights)
        assert whole == pytest.approx(np.sum(weights), rel=1e-12)
        assert eccentricity == pytest.approx(abs(centre), rel=1e-10, abs=1e-14)
        assert inertia == pytest.approx(np.sum(weights * ((along - centre) ** 2 + across**2)) / np.sum(weights), rel=2e-5)


def test_parts_in_one_place_are_a_point_there() -> None:
    """To the last bit, whatever the weights."""
    random = np.random.default_rng(6)
    for _ in range(50):
        radius, at = float(random.uniform(0.1, 3.0)), float(random.uniform(0.0, 0.1))
        parts = np.array([[cells.POINT_MASS, weight, 0.0, 0.0, at] for weight in random.uniform(0.1, 2.0, 3)])
        assert cells.combined(radius, parts)[1:] == (at / radius, 0.0)


def test_how_far_a_part_reaches() -> None:
    """To its farthest point: of a disk's edge, of a rod's ends."""
    for at in (0.3, -0.3):
        assert cells.part_reach(cells.RING, 0.25, 0.5, 0.0) == 0.5
        edge = np.hypot(at + 0.25 * np.cos(np.linspace(0.0, 2.0 * np.pi, 9)), 0.25 * np.sin(np.linspace(0.0, 2.0 * np.pi, 9)))
        assert cells.part_reach(cells.DISK, 0.25, 0.0, at) == pytest.approx(np.max(edge), rel=1e-15)
        assert cells.part_reach(cells.POINT_MASS, 0.0, 0.0, at) == 0.3
        ends = [abs(at + half) for half in (0.125, -0.125)]
        assert cells.part_reach(cells.RADIAL_ROD, 0.25, 0.0, at) == pytest.approx(max(ends), rel=1e-15)
        across = math.sqrt(at * at + 0.125 * 0.125)
        assert cells.part_reach(cells.TANGENTIAL_ROD, 0.25, 0.0, at) == pytest.approx(across, rel=1e-15)


def test_inertias_by_quadrature() -> None:
    nodes, weights = np.polynomial.legendre.leggauss(40)
    inner, outer = 0.3, 1.1
    radii = inner + 0.5 * (outer - inner) * (1 + nodes)
    ring = float(np.sum(weights * radii**3) / np.sum(weights * radii))  # ∫ r² r dr / ∫ r dr
    assert cells.part_inertia(cells.RING, 2.0, inner, outer) == pytest.approx(2.0 * ring, rel=1e-13)
    radii = 0.5 * outer * (1 + nodes)
    disk = float(np.sum(weights * radii**3) / np.sum(weights * radii))
    assert cells.part_inertia(cells.DISK, 2.0, outer, 0.0) == pytest.approx(2.0 * disk, rel=1e-13)
    rod = float(np.sum(weights * (0.5 * outer * nodes) ** 2) / np.sum(weights))
    assert cells.part_inertia(cells.RADIAL_ROD, 2.0, outer, 0.0) == pytest.approx(2.0 * rod, rel=1e-13)


def test_the_ideal_hoop_is_a_ring_and_a_point() -> None:
    for gamma in (0.1, 0.5, 0.75, 0.99):
        parts = np.array([[cells.RING, 1.0 - gamma, 1.0, 1.0, 0.0], [cells.POINT_MASS, gamma, 0.0, 0.0, 1.0]])
        _, eccentricity, inertia = cells.combined(1.0, parts)
        assert eccentricity == pytest.approx(gamma, rel=1e-15)
        assert inertia == pytest.approx(cells.ideal_inertia(gamma), rel=1e-14)
        assert inertia == pytest.approx(math.fsum([1.0, -gamma * gamma]), rel=1e-14)


def test_a_load_on_the_rim_is_not_beyond_it() -> None:
    """Where its place is rounded: no ε is above 1, to either side."""
    for at in (1.0 + 1e-12, -1.0 - 1e-12):
        whole, eccentricity, inertia = cells.combined(1.0, np.array([[cells.POINT_MASS, 2.0, 0.0, 0.0, at]]))
        assert (whole, eccentricity, inertia) == (2.0, 1.0, 0.0)
