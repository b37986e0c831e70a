"""Rules between fields: one function of the kernel decides for scenarios, whole maps and the page's module."""

from __future__ import annotations

import math
import random
from collections import Counter

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.records.cells import Cell
from hophoop.kernel.records.refusal import Refusal, hoop_refusal, plane_refusal, refusal
from hophoop.maps.grid.cells import make_cells
from hophoop.scenario import InputError, cell_of
from hophoop.scenario.rules import RULES
from hophoop.scenario.texts import TEXTS

COMPLIANT = "contact.model=compliant"
BROKEN = {
    Refusal.HOOP_MASS: "hoop.parts.0.shape=point_mass&hoop.parts.0.mass=1e12&hoop.parts.0.at=0&"
    "hoop.parts.1.shape=point_mass&hoop.parts.1.mass=1e12&hoop.parts.1.at=1",
    Refusal.PARTS_CENTER: "hoop.parts.0.shape=ring&hoop.parts.0.mass=1&hoop.parts.0.inner_radius=1&hoop.parts.0.outer_radius=1&"
    "hoop.parts.1.shape=point_mass&hoop.parts.1.mass=-0.6&hoop.parts.1.at=-0.8",
    Refusal.LOAD_INERTIA: "hoop.load_fraction=0.99999999999999",
    Refusal.PARTS_INERTIA: "hoop.parts.0.shape=disk&hoop.parts.0.mass=1&hoop.parts.0.radius=1e-9",
    Refusal.MASSLESS_ECCENTRICITY: "hoop.eccentricity=0.4&hoop.inertia_ratio=0",
    Refusal.KINETIC_ABOVE_STATIC: "plane.mu_static=0.4&plane.mu_kinetic=0.5",
    Refusal.VERTICAL: "plane.slope=1.6",
    Refusal.SLOPE: "plane.slope=1.5702",
    Refusal.MASSLESS_SLOPE: "hoop.load_fraction=1&plane.slope=0.1",
    Refusal.MASSLESS_RESISTANCE: "hoop.load_fraction=1&plane.rolling_resistance=0.1",
    Refusal.RESISTANCE: "hoop.eccentricity=0.9&hoop.inertia_ratio=0.01&plane.rolling_resistance=0.9",
    Refusal.MASSLESS_COMPLIANT: f"hoop.load_fraction=1&{COMPLIANT}",
    Refusal.COMPLIANT_FRICTION: f"plane.mu=inf&{COMPLIANT}",
    Refusal.STIFFNESS: f"{COMPLIANT}&contact.stiffness=1e-3",
    Refusal.TANGENTIAL_STIFFNESS: f"{COMPLIANT}&contact.tangential_stiffness=1e17",
    Refusal.SLIP_SPEED: f"{COMPLIANT}&contact.slip_speed=1e-12",
    Refusal.TOO_SOFT: f"{COMPLIANT}&contact.stiffness=100&start.height=1e6",
    Refusal.TOO_FAST: "hoop.radius=1e-3&start.vx=1e6",
    Refusal.TOO_HIGH: "hoop.radius=0.5&start.height=1e6",
}


def test_every_rule_has_a_sentence_and_breaks():
    assert [*BROKEN] == [*RULES] == [rule for rule in Refusal if rule]
    for code, query in BROKEN.items():
        rule = RULES[code]
        begin = TEXTS[rule.sentence].format_map({**rule.known, **dict.fromkeys(rule.values, 0.0), rule.number: 0.0})
        with pytest.raises(InputError) as caught:
            hh.Scenario.from_query(query)
        assert str(caught.value).split(" ")[0] == begin.split(" ")[0]


def expected(hoop, plane, start, contact):
    """The verdict of the models."""
    try:
        hh.Scenario(hoop=hh.Hoop(**hoop), plane=hh.Plane(**plane), start=hh.Start(**start), contact=contact)
    except InputError:
        return False
    return True


def draw(seed):
    random_ = random.Random(seed)
    hoop = random_.choice(
        [
            {"load_fraction": random_.choice([1.0, 1.0 - 2.0 ** -random_.randint(1, 53), random_.random()])},
            {
                "eccentricity": random_.choice([1.0, random_.random()]),
                "inertia_ratio": random_.choice([0.0, random_.random() + 1e-3]),
            },
        ]
    )
    static = random_.choice([0.0, 0.5, math.inf])
    plane = {
        "mu_static": static,
        "mu_kinetic": random_.choice([static, 0.4]),
        "slope": random_.choice([0.0, 1.57, -0.2, 1.571]),
    }
    plane["rolling_resistance"] = random_.choice([0.0, random_.random(), 1e-9])
    start = {"vx": random_.uniform(-1.0, 1.0) * 10.0 ** random_.randint(0, 5), "height": random_.choice([0.0, 1e5])}
    return hoop, plane, start


def test_maps_and_scenarios_refuse_the_same_cells():
    """Before, maps computed an ideal hoop whose inertia is too small for a scenario."""
    verdicts = Counter()
    for seed in range(3000):
        hoop, plane, start = draw(seed)
        values = {f"hoop.{name}": value for name, value in hoop.items()}
        values |= {f"plane.{name}": value for name, value in plane.items()} | {f"start.{name}": v for name, v in start.items()}
        cells = make_cells(hh.Scenario(), {path: np.array([value]) for path, value in values.items()}, 1)
        allowed = bool(cells[Cell.ALLOWED, 0])
        assert allowed == expected(hoop, plane, start, hh.Rigid()), values
        assert allowed == (refusal(cells[:, 0], ())[0] == Refusal.NONE)
        verdicts[allowed] += 1
    assert min(verdicts[True], verdicts[False]) > 500


@pytest.mark.parametrize("ends", [(1e-12, 1e12), (math.nextafter(1e-12, 0.0), 1.0), (1.0, math.nextafter(1e12, math.inf))])
def test_a_range_holds_both_ends(ends):
    for mass in ends:
        inside = 1e-12 <= mass <= 1e12
        assert (hoop_refusal(mass, 0.5, 0.5, False) == Refusal.NONE) == inside
    assert plane_refusal(0.5, 0.5, math.nextafter(1.57, 2.0)) == Refusal.SLOPE
    assert plane_refusal(0.5, 0.5, -1.57) == Refusal.NONE


def test_numbers_go_into_the_sentences():
    cell = cell_of(hh.Scenario(hoop=hh.Hoop(eccentricity=0.9, inertia_ratio=0.01)))
    broken = [*cell]
    broken[Cell.ROLLING_RESISTANCE] = 0.9
    code, most = refusal(broken, ())
    assert code == Refusal.RESISTANCE
    assert f"must be below {most:.6g}" in str(_said(BROKEN[Refusal.RESISTANCE]))


def _said(query):
    with pytest.raises(InputError) as caught:
        hh.Scenario.from_query(query)
    return caught.value
