"""Derivatives through every kind of event, against motions in 30 digits."""

import json
import math

import numpy as np
import pytest

import hophoop as hh
from hophoop.derivatives.parameters import value_of
from hophoop.derivatives.results.propagation import propagate
from hophoop.kernel.physics.body import EVENT_NAMES
from oracles.derivatives import CASES, FILE, PARTS, scenario_of

TRUE = json.loads(FILE.read_text(encoding="utf-8"))
AGREEMENT = 1e-9  # beside the derivative, or beside 1
NAMES = {"before_omega": "before.omega", "before_slip": "before.slip", "before_vy": "before.vy"}


pytestmark = pytest.mark.usefixtures("interpreted")


def compare(scenario, path, found):
    """Our derivatives of a parameter beside those of the differences: the largest difference beside them or 1, and where."""
    motion = hh.simulate(scenario)
    carried = propagate(motion, [path])
    kinds = motion.tables["events"]["kind"]
    errors = []
    for key, fields in found.items():
        kind, place = key.split()
        places = np.flatnonzero(kinds == EVENT_NAMES.index(kind))
        if int(place) >= len(places):
            assert kind in ("turn", "rest"), f"{kind} is missing"  # of a start at rest
            continue
        for field, digits in fields.items():
            if kind == "bounce_limit" and field.startswith("before"):
                continue  # zero at the limit, which doubles close a little before
            ours, true = float(carried.at_event(places[int(place)], NAMES.get(field, field)).rates[0]), float(digits)
            error = abs(ours - true) / max(1.0, abs(true))
            errors.append((error if error <= math.inf else math.inf, f"{key} {field}: {ours!r}, not {true!r}"))
    assert len(errors) >= 10
    return max(errors)


@pytest.mark.parametrize("name", [*CASES, "parts"])
def test_each_derivative_is_that_of_thirty_digits(name):
    scenario = scenario_of(name)
    assert set(TRUE[name]) == set(PARTS if name == "parts" else CASES[name][1])
    for path, found in TRUE[name].items():
        worst, where = compare(scenario, path, found)
        assert worst < AGREEMENT, f"{path}: {where}"


def test_the_cases_have_every_kind_of_event():
    met = {key.split()[0] for case in TRUE.values() for found in case.values() for key in found}
    assert met >= set(EVENT_NAMES) - {"painleve_inconsistent", "painleve_indeterminate", "kane_gain"} - {"bounce_limit"}
    assert "bounce_limit 0" in TRUE["endless_bounces"]["plane.restitution"]


def test_the_reference_in_natural_units():
    # R = m = g = 1: found by three programs of others that share no code with this one
    scenario = hh.Scenario(plane=hh.Plane(gravity=1.0), start=hh.Start.rolling(3.1 / math.sqrt(9.81)), duration=6.5)
    result = hh.sensitivity(scenario, "takeoff.angle", ["start.speed", "hoop.load_fraction", "plane.mu"])
    assert result.derivatives[0] == pytest.approx([-3.1987967, -5.14606248, 0.22178816], rel=3e-8)


@pytest.mark.parametrize("name", ["hop", "skid", "stronge", "rest_in_the_valley", "massless_slides", "resisted_hop"])
def test_energies_and_times_follow_differences_of_doubles(name):
    """The state at fixed times, with its energies, against four motions beside this one."""
    scenario = scenario_of(name)
    motion = hh.simulate(scenario)
    paths = [path for path in CASES[name][1][:4] if path != "plane.gravity"]
    carried = propagate(motion, paths)
    events = np.array(sorted({event.t for event in motion.events}))
    times = np.sort(np.concatenate([0.5 * (events[1:] + events[:-1]), events[:-1] + 0.123 * np.diff(events)]))
    motions = ("x", "height", "angle", "vx", "vy", "omega", "slip")
    fields = (*motions, "kinetic", "potential", "total", "friction", "impact_normal", "rolling_resistance")
    rated = carried.at_times(times, fields)
    for k, path in enumerate(paths):
        value = value_of(scenario, path)
        step = 2.0**-14 * (abs(value) or 1.0)
        beside = [hh.simulate(scenario.with_values({path: value + side * step})).at(times) for side in (-2, -1, 1, 2)]
        for field in fields:
            low, less, more, high = (np.asarray(getattr(each, field)) for each in beside)
            true = (low - 8 * less + 8 * more - high) / (12 * step)
            assert rated[field][1][:, k] == pytest.approx(true, rel=2e-6, abs=2e-6), (path, field)
            assert rated[field][0] == pytest.approx(np.asarray(getattr(motion.at(times), field)), abs=1e-14)


MAPPED = (
    "time", "end_angle", "end_speed", "distance", "distance_rolled", "revolutions_to_rolling", "energy_lost",
    "greatest_utilization",
)  # fmt: skip
OF_HOPS = ("takeoff_time", "takeoff_angle", "hop_height", "flight_time", "flight_distance", "landing_angle", "landing_loss")
USE = ("greatest_utilization",)
PATHS = ("start.speed", "start.angle", "plane.mu", "plane.gravity", "plane.slope", "duration")
RESISTED = ("start.speed", "plane.slope", "plane.rolling_resistance")
HELD = "duration=2&plane.slope=0.1&start.speed=0&start.angle=3&plane.mu=0.5&plane.rolling_resistance=0.1"


@pytest.mark.parametrize(
    ("query", "names", "paths"),
    [
        ("duration=1.95", MAPPED + OF_HOPS, PATHS[:1]),
        ("duration=4&plane.mu=0.3&start.speed=0.1", MAPPED, PATHS[:1]),  # it rolls back
        # of rolling the most friction: it grows up to the end
        ("duration=0.5&start.speed=1&start.angle=0.3", USE, PATHS),
        ("duration=0.3&start.speed=1&start.angle=1.3", USE, PATHS),  # inside
        ("duration=3&start.speed=1&start.angle=0.3&hoop.load_fraction=0.4", USE, PATHS[:4]),  # in every turn anew
        ("duration=5&hoop.load_fraction=0.3&start.speed=0.3&start.angle=2", USE, PATHS[:4]),  # to and fro
        ("duration=2&hoop.load_fraction=0.3&start.speed=0.3&start.angle=2&plane.rolling_resistance=0.02", USE, RESISTED),
        (HELD, USE, ("start.angle", *RESISTED[1:])),
    ],
)
def test_quantities_of_maps_are_those_of_maps_and_follow_differences(query, names, paths):
    """Their values are those of a map's cell, their derivatives differences of such values of motions beside this one."""
    scenario = hh.Scenario.from_query(query)
    motion = hh.simulate(scenario)
    assert motion.sequence == "R" or names != USE
    result = motion.sensitivity(names, paths)
    for k, path in enumerate(paths):
        value = value_of(scenario, path)
        step = 2e-4 * (abs(value) or 1.0)
        cells = hh.maps.points(scenario, {path: value + step * np.arange(-2, 3)}, names, "duration")
        low, less, same, more, high = np.transpose([cells[name] for name in names])
        assert result.values == pytest.approx(same, rel=1e-12), path
        assert result.derivatives[:, k] == pytest.approx(
            (low - 8 * less + 8 * more - high) / (12 * step), rel=1e-8, abs=1e-9
        ), path


def test_the_potential_energy_of_a_hoop_that_slides_without_rotation_follows_its_position():
    """It is proportional to the mass, and its position changes while it slides."""
    motion = hh.simulate(
        hh.Scenario.from_query(
            "duration=1&hoop.mass=2&hoop.eccentricity=0&hoop.inertia_ratio=0.5&plane.slope=0.3&plane.mu=0&start.vx=1"
        )
    )
    found = motion.sensitivity("at(0.7).potential", "hoop.mass").derivatives[0, 0]
    assert found == pytest.approx(motion.at(0.7).potential / 2.0, rel=1e-12)
