"""The page without a server, in Node with the WebAssembly module: its answers and files are those of Python's calls."""

import itertools
import json
import math

import numpy as np
import pytest

import hophoop as hh
from hophoop._support.fingerprint import is_fingerprint
from hophoop.kernel.compliant.motion import chosen_in_si
from hophoop.lab import presets
from hophoop.lab.limits import within
from hophoop.lab.tables import tables
from hophoop.maps import QUANTITIES
from hophoop.scenario.scenario import time_unit
from hophoop.simulation.compliant import to_compliance
from hophoop.vocabulary.colors import class_color
from hophoop.vocabulary.names import class_text
from hophoop.vocabulary.parameters import RANGES
from model.asked import asked
from model.test_page_model import answers
from page_films import number, same_columns
from random_scenarios import draw, scenario_of
from web_tools import english, needs_node

pytestmark = needs_node

BODIES = [
    {},
    {"query": "plane.mu=0.3&start.speed=0.1&plane.restitution=0.5", "changes": [["start.height", 0.3]]},
    {"scenario": {"hoop": {"load_fraction": 1}, "duration": 3}},
    {"query": "plane.slope=0.1&start.vx=1&start.angle=0.4&plane.mu=inf"},
    {"query": "start.vx=2&start.angle=2.5&plane.mu=0.2"},  # slips before it turns
]


CONTACTS = [
    hh.Compliant(),
    hh.Compliant(stiffness=1e5, law="hunt-crossley", friction="bristle"),
    hh.Compliant(stiffness=2e5, friction="linear", restitution=0.5, slip_speed=1e-3),
]


def chosen(scenario):
    """Stiffness [N/m] and slip speed [m/s] of a compliant contact, which a scenario may leave open."""
    _, numbers, _, _ = to_compliance(scenario)
    hoop = scenario.hoop
    sizes = chosen_in_si(numbers, hoop.radius, time_unit(hoop, scenario.plane), hoop.mass)
    return dict(zip(("contact.stiffness", "contact.slip_speed"), sizes, strict=True))


def of_python(body):
    return hh.simulate(within(asked(json.loads(json.dumps(body)))))


@pytest.mark.long
def test_films_are_those_of_python():
    bodies = [*BODIES, {"query": "plane.rolling_resistance=0.02&plane.mu=0.4"}]
    bodies += [{"query": preset.scenario.to_query()} for preset in presets.presets()]
    bodies += [{"query": "duration=60"}]  # sampled coarsely, and where the load passes top and bottom
    bodies += [{"query": "start.angle=0&start.vx=1&start.omega=1&duration=0.0001"}]
    bodies += [{"changes": [["contact.model", "compliant"], ["contact.stiffness", 1e5]], "query": "duration=0.5"}]
    bodies += [{"query": query} for query in ("plane.restitution=0.9", "duration=600")]
    soft = hh.Scenario.from_query("duration=2&plane.slope=0.1&start.speed=2")
    scenarios = [scenario_of(draw(20261122, index), max_events=500) for index in range(60)]
    scenarios += [soft.replace("contact", contact) for contact in CONTACTS]
    bodies += [{"scenario": json.loads(json.dumps(scenario.to_dict()))} for scenario in scenarios]
    motion = hh.simulate(hh.Scenario())
    # motions that go on from a state of another, also in slip
    starts = [hh.Start.of(motion.at(t)) for t in (0.55, 1.2, 1.9, 2.1)]
    bodies += [{"query": hh.Scenario(start=start).to_query()} for start in starts]
    for body, answer in zip(bodies, answers("film", bodies), strict=True):
        film, motion = answer["value"], of_python(body)
        written = json.loads(json.dumps(motion.to_dict()))
        for name in ("status", "sequence", "fingerprint", "events", "final", "energy"):
            assert film["header"][name] == written[name], f"{body} {name}"
        assert film["header"]["query"] == asked(body).to_query()
        assert film["header"]["duration"] == motion.duration
        if motion.scenario.contact.model == "compliant":
            assert film["header"]["automatic"].items() >= chosen(motion.scenario).items(), body
        assert len(film["arrays"]["t"]) >= 2
        same_columns(film["arrays"], motion, body)


def test_a_notebook_shows_motions_of_any_length():
    (answer,) = answers("film", [{"query": "duration=1000", "bounded": False}])
    same_columns(answer["value"]["arrays"], hh.simulate(hh.Scenario(duration=1000.0)))


def test_a_long_motion_is_sampled_where_its_speed_is_extreme():
    (answer,) = answers("film", [{"query": "duration=60"}])
    found = {name: np.array(answer["value"]["arrays"][name]) for name in ("t", "vx", "angle")}
    late = found["t"] > 57.0
    fine = hh.simulate(hh.Scenario(duration=60.0)).at(np.linspace(57.0, 60.0, 60_001))
    assert found["vx"][late].max() == pytest.approx(fine.vx.max(), rel=1e-5)
    assert np.abs(np.mod(found["angle"][late], 2.0 * np.pi) - np.pi).min() < 1e-3


# The speed at which the contact force is zero at the start: its double may lie on either side.
UNDECIDED = "start.speed=3.616628264005025"


def test_a_motion_that_doubles_do_not_decide_is_said():
    (here,) = answers("film", [{"query": UNDECIDED}])
    assert here["value"]["header"]["fingerprint"] == hh.simulate(hh.Scenario.from_query(UNDECIDED)).fingerprint
    assert english(here["value"]["header"]["doubt"]).endswith("Run it with `--digits 30` for the exact answer.")
    (decided,) = answers("film", [{}])
    assert "doubt" not in decided["value"]["header"]
    assert is_fingerprint(decided["value"]["header"]["fingerprint"])


def test_a_part_of_a_film_is_finer():
    scenario = hh.Scenario(duration=200.0)
    windows = [[0, 3.5], [100.2, 101.9], [199.5, 250]]
    asked = [{"scenario": scenario.to_dict(), "window": window} for window in windows]
    for body, answer in zip(asked, answers("samples", asked), strict=True):
        arrays, (begin, end) = answer["value"], body["window"]
        assert (arrays["t"][0], arrays["t"][-1]) == (begin, min(end, 200.0))
        same_columns(arrays, of_python(body), body)


def test_thresholds_are_those_of_theory():
    queries = (
        "", "plane.gravity=0", "hoop.load_fraction=0", "plane.slope=-0.2&plane.mu=2", "plane.slope=0.4", "plane.mu=0.5",
        "plane.mu=inf", "plane.rolling_resistance=0.01", "hoop.eccentricity=0.2&hoop.inertia_ratio=0.5",
        "hoop.load_fraction=0.4&plane.slope=0.2&hoop.radius=0.3", "hoop.load_fraction=1&start.speed=0.7&plane.mu=0.3",
    )  # fmt: skip
    found = [*(preset.scenario for preset in presets.presets()), *map(hh.Scenario.from_query, queries)]
    names = {"first_slip": "first_slip_speed", "first_hop": "first_hop_speed", "immediate_hop": "immediate_hop_speed",
             "needed_friction": "needed_friction", "painleve": "painleve_friction", "jam": "jam_angle", "rest": "stable_angle",
             "loss": "massless_loss_angle"}  # fmt: skip
    told = set()
    for scenario, answer in zip(found, answers("theory", [{"scenario": one.to_dict()} for one in found]), strict=True):
        known = {quantity.key: quantity.value for quantity in hh.theory.summary(scenario)}
        for row in answer["value"]:
            told.add(row["key"])
            if row["key"] != "uphill":
                value = known[names[row["key"]]]
                assert row["value"] == (value if math.isfinite(value) else None), (scenario.to_query(), row)
    assert told == {*names, "uphill"}


AXES = {
    "speed and friction": ({"path": "start.speed", "from": 0, "to": 5}, {"path": "plane.mu", "from": -0.2, "to": 1.5}),
    "load and slope": (
        {"path": "hoop.load_fraction", "from": 0.05, "to": 1.2}, {"path": "plane.slope", "from": -0.3, "to": 0.3},
    ),
    "radius and rotation": ({"path": "hoop.radius", "from": 0.1, "to": 2}, {"path": "start.omega", "from": -8, "to": 8}),
    "kappa and eccentricity": (
        {"path": "hoop.inertia_ratio", "from": 0.05, "to": 1}, {"path": "hoop.eccentricity", "from": 0.05, "to": 0.95},
    ),
}  # fmt: skip


SPANS = {name: known["span"] for name, known in tables()["map"]["quantities"].items()}


def test_a_class_has_one_colour_on_the_page_and_in_figures():
    """All classes of the catalogue, of the massless hoop and of other quantities, and sequences of any length."""
    sequences = {entry.sequence for fraction in (0.5, 0.75, 0.9) for entry in hh.maps.catalogue(fraction)}
    sequences |= {"".join(letters) for count in range(1, 5) for letters in itertools.product("RSKHM", repeat=count)}
    sequences |= {"RSRK" * 5, "R" + "KS" * 9 + "H"}
    classes = [(name, "sequence") for name in sorted(sequences)]
    classes += [(word, quantity.name) for quantity in QUANTITIES.values() for word in quantity.words or ()]
    assert answers("colors", [classes])[0]["value"] == [class_color(*one) for one in classes]


@pytest.mark.parametrize("what", SPANS)
def test_maps_are_those_of_python(what):
    """Also empty where a value is not allowed."""
    bodies = [{"query": "duration=3", "x": {**x, "cells": 7}, "y": {**y, "cells": 5}, "what": what} for x, y in AXES.values()]
    for body, answer in zip(bodies, answers("map", bodies), strict=True):
        header = answer["value"]["header"]
        found = np.array([number(value) for value in answer["value"]["arrays"]["values"]]).reshape(5, 7)
        assert (header["x"], header["y"], header["what"]) == (body["x"], body["y"], what)
        if header["classes"] is not None:
            found = np.array([*(one["name"] for one in header["classes"]), ""])[
                np.where(np.isnan(found), -1, found).astype(int)
            ]
        np.testing.assert_array_equal(found, of_sweep(body))
        for one in header["classes"] or ():
            assert one["color"] == class_color(one["name"], what)
            assert english(one["text"]) == class_text(one["name"], what)


def of_sweep(body):
    """The same map by Python, which refuses axes with values that no cell may have."""
    axes, masks = {}, []
    for axis in (body["y"], body["x"]):
        values = np.linspace(axis["from"], axis["to"], 2 * axis["cells"] + 1)[1::2]
        masks.append([RANGES[axis["path"]].holds(value) for value in values])
        axes[axis["path"]] = values[masks[-1]]
    map_ = hh.maps.sweep(hh.Scenario.from_query(body["query"]), axes, body["what"], SPANS[body["what"]])[body["what"]]
    values = np.array([*hh.maps.words_of(map_), ""])[map_.values] if "flag_meanings" in map_.attrs else map_.values
    whole = np.full((len(masks[0]), len(masks[1])), "" if values.dtype.kind == "U" else math.nan, values.dtype)
    whole[np.ix_(*masks)] = values
    return whole


def test_files_are_those_of_python(tmp_path):
    query = "plane.restitution=0.4&start.speed=3&duration=2"
    motion = of_python({"query": query})
    names = ("motion.toml", "motion.json", "motion.csv")
    toml, events, table = (one["value"] for one in answers("file", [{"name": name, "query": query} for name in names]))
    assert hh.Scenario.loads(toml) == hh.Scenario.from_query(query)
    assert json.loads(events) == json.loads(json.dumps(motion.to_dict()))
    hh.io.write_csv(motion, tmp_path / "motion.csv", motion.times(int(200 * motion.duration) + 1))
    theirs = (tmp_path / "motion.csv").read_bytes().decode()

    def read(text):
        head, *rows = text.split("\r\n")
        return head, [[cell if cell.isalpha() else float(cell or 0.0) for cell in row.split(",")] for row in rows]

    assert read(table) == read(theirs)


MAP = {"x": {"path": "start.speed", "from": 0, "to": 5, "cells": 4}, "y": {"path": "plane.mu", "from": 0, "to": 1, "cells": 4},
       "what": "sequence"}  # fmt: skip
REFUSALS = [
    (
        "film",
        {"query": "duration=1e4"},
        "duration = 10000 must be at most 600 s in the lab; the library itself has no such limit.",
    ),
    ("film", {"query": "plane.mu=x"}, "plane.mu = 'x' must be a number."),
    ("map", {**MAP, "y": {**MAP["y"], "path": "start.vx"}}, "start.vx and start.speed cannot both be axes: they say the same "),
    ("map", {**MAP, "query": "contact.model=compliant"}, "contact.model = 'compliant' must be 'rigid' for a map."),
]


@pytest.mark.parametrize(("call", "body", "said"), REFUSALS)
def test_refusals(call, body, said):
    (answer,) = answers(call, [body])
    assert answer["error"].startswith(said)
    if call == "film" and "x" in body["query"]:  # the library has no limit of duration
        with pytest.raises(ValueError) as caught:
            of_python(body)
        assert str(caught.value) == answer["error"]
