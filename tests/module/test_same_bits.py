"""Every other entry of the WebAssembly module gives the bits of the library's public functions; motions have the kept ones."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import hophoop as hh
from hophoop import maps
from hophoop.lab.wasm.stamp import HERE, MODULE
from hophoop.maps.grid.cells import make_cells
from hophoop.maps.grid.kernel import NUMBERS as MAP_NUMBERS
from hophoop.maps.grid.kernel import WORDS as MAP_WORDS
from hophoop.maps.grid.quantities import QUANTITIES, choose_quantities, flags_of, make_span
from hophoop.scenario.parts import combine
from hophoop.vocabulary.names import MODE_WORDS, mode_words

pytest.importorskip("wasmtime")

from module.host import Host
from module.module_tools import cell_of, same


@pytest.fixture(scope="module")
def host() -> Host:
    return Host(HERE / MODULE)


@pytest.mark.parametrize(
    "query",
    [
        "",
        "plane.mu=0.4&plane.slope=0.3&hoop.radius=0.3",
        "plane.mu=0.9&plane.rolling_resistance=0.1",
        "hoop.load_fraction=1",
        "plane.gravity=0",
        "plane.mu=inf",
    ],
)
def test_regions(host: Host, query: str) -> None:
    scenario = hh.Scenario.from_query(query)
    window = (-3.0, 7.0, -12.0, 12.0)
    codes, paradox = host.regions(cell_of(scenario), window, 90, 60)
    angles = -3.0 + (np.arange(90) + 0.5) * (10.0 / 90)
    rates = (-12.0 + (np.arange(60) + 0.5) * (24.0 / 60))[:, None]
    hoop, plane = scenario.hoop, scenario.plane
    words = mode_words(hh.theory.mode_of(angles, rates, hoop, plane), rates)
    places = {word: code for code, word in enumerate(MODE_WORDS)}
    assert codes.ravel().tolist() == [places.get(word, len(MODE_WORDS)) for word in words.ravel()]
    sides = np.zeros((2, 90))
    if not hoop.massless and math.isfinite(plane.mu_kinetic):
        couple, turning = plane.rolling_resistance, np.array([[-1.0], [1.0]])
        sides[:] = hh.theory.painleve_region(angles, plane.mu_kinetic, hoop, rolling_resistance=couple, omega=turning)
    assert np.array_equal(paradox, sides.ravel())


def parts_within(radius: float, draw: np.random.Generator) -> list[Any]:
    """A ring, and one part of each other shape."""
    one = draw.uniform(0.05, 0.3, 12).tolist()
    return [
        hh.Ring(one[0], radius * (1.0 - one[1]), radius),
        hh.Disk(one[2], radius * one[3], at=radius * one[4]),
        hh.PointMass(one[5], at=-radius * one[6]),
        hh.Rod(one[7], radius * one[8], at=radius * one[9]),
        hh.Rod(one[10], radius * one[11], at=radius * one[9], direction="tangential"),
    ]


def test_hoops(host: Host) -> None:
    draw = np.random.default_rng(5)
    for load_fraction in draw.uniform(0.0, 1.0, 40).tolist():
        hoop = hh.Hoop.ideal(load_fraction)
        assert same(host.number("ideal_hoop", load_fraction), hoop.inertia_ratio)
    for _ in range(60):
        radius = float(draw.uniform(0.1, 2.0))
        parts = parts_within(radius, draw)
        found, reaches = host.hoop_of_parts(radius, np.array([part.row for part in parts], float))
        assert same(found, combine(radius, parts))
        assert same(reaches, [part.reach for part in parts])


@pytest.mark.parametrize("span", ["first_revolution", "takeoff", "reversal", "duration"])
def test_maps(host: Host, span: str) -> None:
    base = hh.Scenario(duration=4.0)
    mu, speed = np.linspace(0.2, 1.2, 9), np.linspace(0.1, 4.0, 11)
    grid = np.meshgrid(mu, speed, indexing="ij")
    cells = make_cells(base, {"plane.mu": grid[0].ravel(), "start.speed": grid[1].ravel()}, mu.size * speed.size)
    names = tuple(name for name in QUANTITIES if name in (*MAP_NUMBERS, *MAP_WORDS))
    taken = make_span(span)
    wanted = flags_of(choose_quantities(names))
    numbers, words, _ = host.map_cells(cells, taken.angle, taken.stop, taken.timed, wanted)
    theirs = maps.sweep(base, {"plane.mu": mu, "start.speed": speed}, names, span)
    for name in names:
        column = numbers[:, MAP_NUMBERS.index(name)] if name in MAP_NUMBERS else words[:, MAP_WORDS.index(name)]
        values = theirs[name].values.ravel()
        assert same(column, values.astype(float)), name
