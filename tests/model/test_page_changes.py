"""What the page says of a little more of a parameter, in Node with the WebAssembly module, follows Python's derivatives."""

import math

import pytest

import hophoop as hh
from differences import halved
from hophoop.derivatives.parameters import value_of
from hophoop.derivatives.results.propagation import propagate
from hophoop.vocabulary.parameters import TABLE
from model.test_page_model import answers
from random_scenarios import rolling
from web_tools import needs_node

pytestmark = needs_node

NAMES = ("t", "x", "height", "angle", "vx")
STEPS = {row.path: row.slider.step * (math.pi / 180.0 if row.degrees else 1.0) for row in TABLE if row.slider}
RIGHT = 1e-6  # of a rate, or of the rate that would change the largest number of its kind by all of it
SCENARIOS = 60
SEED = 20261129


def drawn():
    """Random motions as visitors make them: rolling and thrown, on slopes, with bounces and with resistance."""
    for index in range(SCENARIOS):
        scenario = rolling(SEED, index)
        speed = scenario.start.speed
        yield scenario.replace("start", hh.Start(height=0.5, vx=speed, omega=2.0 - speed)) if index % 2 else scenario


def paths_of(scenario):
    """The sliders that the page offers for it."""
    free = scenario.start.speed is None
    start = ["angle", "height", "vx", "vy", "omega"] if free else ["angle", "speed"]
    plane = ["mu", "slope", "gravity", "restitution", "rolling_resistance"]
    sections = {"hoop": ["load_fraction", "radius", "mass"], "plane": plane, "start": start}
    return [f"{section}.{name}" for section, names in sections.items() for name in names]


def changes(asked):
    """What the page finds for parameters of scenarios."""
    bodies = [
        {"scenario": scenario.to_dict(), "path": path, "value": value_of(scenario, path), "step": STEPS[path]}
        for scenario, path in asked
    ]
    return [answer["value"] for answer in answers("changes", bodies)]


def of(scenario, path):
    (found,) = changes([(scenario, path)])
    assert found is not None
    return found


@pytest.mark.long
def test_rates_of_60_motions_are_the_derivatives():
    asked = [(scenario, path) for scenario in drawn() for path in paths_of(scenario)]
    compared = whole = 0
    for (scenario, path), found in zip(asked, changes(asked), strict=True):
        assert found is not None
        motion = hh.simulate(scenario)
        carried = propagate(motion, (path,), float(found["way"]))
        largest = {name: max(abs(getattr(event, name)) for event in motion.events) for name in NAMES}
        size = max(abs(value_of(scenario, path)), STEPS[path])
        for k, rates in enumerate(found["events"]):
            for name in NAMES:
                (true,) = carried.at_event(k, name).rates
                if math.isfinite(true):  # none where the least restitution makes the hoop bounce after the shown motion
                    assert abs(rates[name] - true) <= RIGHT * max(abs(true), largest[name] / size), (scenario.to_query(), path)
                    compared += 1
        whole += len(found["events"]) == len(motion.events)
    assert compared > 20_000
    assert whole > 0.7 * len(asked)


# link, parameter, how many events have rates before another one follows
OTHERS = [
    ("", "plane.restitution", 6),  # at its landing the hoop would bounce
    ("start.height=0&start.vx=1&start.omega=1&start.angle=1", "start.height", 0),  # it would fall
    ("plane.mu=0&start.speed=1&duration=0.4", "plane.mu", 0),
    ("hoop.load_fraction=1&start.speed=1&duration=1", "hoop.load_fraction", 1),  # the massless hoop loses contact otherwise
]


@pytest.mark.parametrize(("query", "path", "count"), OTHERS)
def test_nothing_is_said_beyond_an_event_that_another_one_follows(query, path, count):
    found = of(hh.Scenario.from_query(query), path)
    assert (len(found["events"]), found["edge"], found["sided"]) == (count, True, False)


def test_nothing_is_said_beyond_a_touch_that_a_little_more_avoids():
    """A hoop that spins so fast that its rim comes down and goes up again; and one that just hops."""
    hoop, plane = hh.Hoop(eccentricity=0.9, inertia_ratio=0.1), hh.Plane(mu=0.5)

    def thrown(height):
        return hh.Scenario(hoop=hoop, plane=plane, start=hh.Start(height=height, vy=1.3, omega=9.5, angle=3.88), duration=0.3)

    for height in halved(0.1, 0.3, lambda height: bool(hh.simulate(thrown(height)).find("impact"))):
        found = of(thrown(height), "start.height")
        kinds = [event.kind for event in hh.simulate(thrown(height)).events[: len(found["events"])]]
        assert kinds == ["start"]
    speed = float(hh.theory.first_hop_speed(hh.Hoop.ideal(0.75)))
    for near in (math.nextafter(speed, 0.0), speed, math.nextafter(speed, 9.0)):
        scenario = hh.Scenario(start=hh.Start.rolling(near), duration=1.4)
        found = of(scenario, "start.speed")
        kinds = [event.kind for event in hh.simulate(scenario).events[: len(found["events"])]]
        assert kinds == ["start", "slip_start", "stick", "slip_start"]


BOUNCES = "start.height=0.3&start.vx=1&start.omega=2&plane.mu=0.3&plane.restitution=0.5&duration=1.2"
DROPPED = "plane.mu=0.2&plane.restitution=0.4&start.height=0.5&start.angle=2&duration=0.4"


@pytest.mark.parametrize(
    ("query", "path", "way", "edge", "sided"),
    [
        # as long as there are as many of endless bounces on both sides they keep their rates beyond their end
        (
            "start.height=0.3&start.vx=1&start.omega=2&plane.mu=0.3&plane.restitution=0.5&duration=1.2",
            "plane.restitution",
            1,
            0,
            0,
        ),
        # at an edge the rates are those of the side that is allowed
        ("hoop.load_fraction=0.75&plane.restitution=1&duration=2", "plane.restitution", -1, True, False),
        ("duration=2", "plane.rolling_resistance", 1, True, False),
        # dropped without rotation it lands without slip: at such a corner they are those of a larger parameter
        (DROPPED, "start.vx", 1, False, True),
        (DROPPED, "start.omega", 1, False, True),
    ],
)
def test_there_are_rates_of_one_side(query, path, way, edge, sided):
    scenario = hh.Scenario.from_query(query)
    found, motion = of(scenario, path), hh.simulate(scenario)
    assert (found["way"], found["edge"], found["sided"]) == (way, edge, sided)
    assert edge or len(found["events"]) == len(motion.events)
    carried = propagate(motion, (path,), float(way))
    for k, rates in enumerate(found["events"]):
        for name in NAMES:
            assert rates[name] == pytest.approx(carried.at_event(k, name).rates[0], rel=RIGHT, abs=RIGHT), (k, name)


def test_a_parameter_that_can_be_no_other_has_no_rates():
    assert changes([(hh.Scenario.from_query("plane.mu=0&start.speed=1"), "plane.mu_kinetic")]) == [None]
