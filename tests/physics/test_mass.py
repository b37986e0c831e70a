"""Mass properties of parts: against the scenario's own sums, and the parallel axis theorem by quadrature."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.physics import mass


def table_of(hoop: hh.Hoop) -> np.ndarray:
    rows = []
    for part in hoop.parts or ():
        if isinstance(part, hh.Ring):
            rows.append([mass.RING, part.mass, part.inner_radius, part.outer_radius, 0.0])
        elif isinstance(part, hh.Disk):
            rows.append([mass.DISK, part.mass, part.radius, 0.0, part.at])
        elif isinstance(part, hh.PointMass):
            rows.append([mass.POINT_MASS, part.mass, 0.0, 0.0, part.at])
        else:
            kind = mass.RADIAL_ROD if part.direction == "radial" else mass.TANGENTIAL_ROD
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
        whole, eccentricity, inertia = mass.combined.interpreted(hoop.radius, table_of(hoop))
        assert whole == hoop.mass
        assert eccentricity == pytest.approx(hoop.eccentricity, rel=1e-14, abs=1e-16)
        assert inertia == pytest.approx(hoop.inertia_ratio, rel=1e-14)
        reaches = [mass.part_reach.interpreted(row[0], row[2], row[3], row[4]) for row in table_of(hoop)]
        assert reaches == [part.reach for part in hoop.parts or ()]


def test_inertias_by_quadrature() -> None:
    nodes, weights = np.polynomial.legendre.leggauss(40)
    inner, outer = 0.3, 1.1
    radii = inner + 0.5 * (outer - inner) * (1 + nodes)
    ring = float(np.sum(weights * radii**3) / np.sum(weights * radii))  # ∫ r² r dr / ∫ r dr
    assert mass.part_inertia.interpreted(mass.RING, 2.0, inner, outer) == pytest.approx(2.0 * ring, rel=1e-13)
    radii = 0.5 * outer * (1 + nodes)
    disk = float(np.sum(weights * radii**3) / np.sum(weights * radii))
    assert mass.part_inertia.interpreted(mass.DISK, 2.0, outer, 0.0) == pytest.approx(2.0 * disk, rel=1e-13)
    rod = float(np.sum(weights * (0.5 * outer * nodes) ** 2) / np.sum(weights))
    assert mass.part_inertia.interpreted(mass.RADIAL_ROD, 2.0, outer, 0.0) == pytest.approx(2.0 * rod, rel=1e-13)


def test_the_ideal_hoop_is_a_ring_and_a_point() -> None:
    for gamma in (0.1, 0.5, 0.75, 0.99):
        parts = np.array([[mass.RING, 1.0 - gamma, 1.0, 1.0, 0.0], [mass.POINT_MASS, gamma, 0.0, 0.0, 1.0]])
        _, eccentricity, inertia = mass.combined.interpreted(1.0, parts)
        assert eccentricity == pytest.approx(gamma, rel=1e-15)
        assert inertia == pytest.approx(mass.ideal_inertia.interpreted(gamma), rel=1e-14)
        assert inertia == pytest.approx(math.fsum([1.0, -gamma * gamma]), rel=1e-14)
