"""The page without a server, in Node with the WebAssembly module: its answers and files are those of Python's calls."""

from __future__ import annotations

import csv
import io
import json
import math
from typing import Any

import numpy as np
import pytest

import hophoop as hh
from hophoop._support.fingerprint import is_fingerprint
from hophoop.lab.api.limits import within
from hophoop.lab.site import presets
from hophoop.vocabulary.colors import class_color
from hophoop.vocabulary.names import class_text
from model.asked import asked
from model.test_page_model import answers
from page_films import number, same_columns
from web_tools import english, needs_node

pytestmark = needs_node

BODIES: list[dict[str, Any]] = [
    {},
    {"query": "plane.mu=0.3&start.speed=0.1&plane.restitution=0.5", "changes": [["start.height", 0.3]]},
    {"scenario": {"hoop": {"load_fraction": 1}, "duration": 3}},
    {"query": "plane.slope=0.1&start.vx=1&start.angle=0.4&plane.mu=inf"},
    {"query": "start.vx=2&start.angle=2.5&plane.mu=0.2"},  # slips before it turns
]


def of_python(body: dict[str, Any]) -> hh.Trajectory:
    return hh.simulate(within(asked(json.loads(json.dumps(body)))))


def alike(one: Any, other: Any, path: str = "") -> None:
    """Equal to the last bit."""
    if isinstance(other, dict):
        assert isinstance(one, dict), path
        assert one.keys() == other.keys(), path
        for key in other:
            alike(one[key], other[key], f"{path}.{key}")
    elif isinstance(other, list | tuple):
        assert len(one) == len(other), path
        for k, (a, b) in enumerate(zip(one, other, strict=True)):
            alike(a, b, f"{path}.{k}")
    else:
        assert one == other, path


RESULTS = ("status", "sequence", "fingerprint", "events", "final", "energy")


def test_films_are_those_of_python():
    bodies = [*BODIES, {"query": "plane.rolling_resistance=0.02&plane.mu=0.4"}]
    bodies += [{"query": preset.scenario.to_query()} for preset in presets.presets()]
    bodies += [{"query": "duration=60"}]  # sampled coarsely, and where the load passes top and bottom
    bodies += [{"changes": [["contact.model", "compliant"], ["contact.stiffness", 1e5]], "query": "duration=0.5"}]
    motion = hh.simulate(hh.Scenario())
    # motions that go on from a state of another, also in slip
    starts = [hh.Start.of(motion.at(t)) for t in (0.55, 1.2, 1.9, 2.1)]
    bodies += [{"query": hh.Scenario(start=start).to_query()} for start in starts]
    for body, answer in zip(bodies, answers("film", bodies), strict=True):
        film, motion = answer["value"], of_python(body)
        written = motion.to_dict()
        for name in RESULTS:
            alike(film["header"][name], written[name], f"{body} {name}")
        assert film["header"]["query"] == asked(body).to_query()
        assert film["header"]["duration"] == motion.duration
        same_columns(film["arrays"], motion, body)


def test_a_notebook_shows_motions_of_any_length():
    (answer,) = answers("film", [{"query": "duration=1000", "bounded": False}])
    same_columns(answer["value"]["arrays"], hh.simulate(hh.Scenario(duration=1000.0)))


def test_a_motion_without_length_has_a_frame():
    (answer,) = answers("film", [{"query": "start.angle=0&start.vx=1&start.omega=1&duration=1e-9"}])
    assert len(answer["value"]["arrays"]["t"]) >= 2


def test_a_long_motion_is_sampled_where_its_speed_is_extreme():
    motion = hh.simulate(hh.Scenario(duration=60.0))
    (answer,) = answers("film", [{"query": "duration=60"}])
    found = {name: np.array(answer["value"]["arrays"][name]) for name in ("t", "vx", "angle")}
    coarse = motion.at(np.linspace(0.0, motion.duration, 6001))
    fine = motion.at(np.linspace(57.0, 60.0, 60_001))
    late, steady = found["t"] > 57.0, coarse.t > 57.0
    assert found["vx"][late].max() == pytest.approx(fine.vx.max(), rel=1e-5)
    assert found["vx"][late].max() >= coarse.vx[steady].max()
    bottoms = np.mod(found["angle"][late], 2.0 * np.pi) - np.pi
    assert np.abs(bottoms).min() < 1e-3 < np.abs(np.mod(coarse.angle[steady], 2.0 * np.pi) - np.pi).min()


# The speed at which the contact force is zero at the start: its double may lie on either side.
UNDECIDED = "start.speed=3.616628264005025"


def test_a_motion_that_doubles_do_not_decide_is_said_and_python_makes_its_files():
    (here,) = answers("film", [{"query": UNDECIDED}])
    assert here["value"]["header"]["fingerprint"] == hh.simulate(hh.Scenario.from_query(UNDECIDED)).fingerprint
    assert english(here["value"]["header"]["doubt"]).endswith("Run it with `--digits 30` for the exact answer.")
    (decided,) = answers("film", [{}])
    assert "doubt" not in decided["value"]["header"]
    assert is_fingerprint(decided["value"]["header"]["fingerprint"])
    (served,) = answers("served", [[["motion.json", UNDECIDED], ["motion.nc", UNDECIDED], ["motion.nc", ""]]])
    scenarios = [json.loads(json.dumps(hh.Scenario.from_query(query).to_dict())) for query in (UNDECIDED, "")]
    assert served["value"]["said"] == [{"name": "motion.nc", "scenario": scenario} for scenario in scenarios]
    assert [text == "of Python" for text in served["value"]["found"]] == [False, True, True]


def test_a_part_of_a_film_is_finer():
    scenario = hh.Scenario(duration=200.0)
    windows: list[Any] = [[0, 3.5], [100.2, 101.9], [199.5, 250]]
    asked = [{"scenario": scenario.to_dict(), "window": window} for window in windows]
    for body, answer in zip(asked, answers("samples", asked), strict=True):
        arrays, (begin, end) = answer["value"], body["window"]
        assert (arrays["t"][0], arrays["t"][-1]) == (begin, min(end, 200.0))
        same_columns(arrays, of_python(body), body)


def test_thresholds_are_those_of_theory():
    found = [preset.scenario for preset in presets.presets()]
    found += [
        hh.Scenario.from_query(query)
        for query in (
            "",
            "plane.gravity=0",
            "hoop.load_fraction=0",
            "plane.slope=-0.2&plane.mu=2",
            "plane.slope=0.4",
            "plane.mu=0.5",
        )
    ]
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


@pytest.mark.parametrize("what", ["sequence", "hop_height", "energy_lost", "ending"])
def test_maps_are_made_of_the_motions(what):
    """Each cell is the motion of its scenario: by Python's own map of the cell alone, and empty where none is allowed."""
    bodies = [{"query": "duration=3", "x": {**x, "cells": 7}, "y": {**y, "cells": 5}, "what": what} for x, y in AXES.values()]
    for body, answer in zip(bodies, answers("map", bodies), strict=True):
        reply = answer["value"]
        found = np.array([number(value) for value in reply["arrays"]["values"]]).reshape(5, 7)
        header = reply["header"]
        assert (header["x"], header["y"], header["what"]) == (body["x"], body["y"], what)
        expected = by_hand(body)
        if header["classes"] is None:
            np.testing.assert_array_equal(found, expected)
            continue
        names = [[header["classes"][int(code)]["name"] if code == code else "" for code in row] for row in found]
        assert names == expected
        for one in header["classes"]:
            # of sequences, alike but for the little by which those of one length and family differ
            pairs = zip(bytes.fromhex(one["color"][1:]), bytes.fromhex(class_color(one["name"], what)[1:]), strict=True)
            assert max(abs(mine - other) for mine, other in pairs) <= (0.2 * 255 if what == "sequence" else 0)
            assert english(one["text"]) == class_text(one["name"], what)


def by_hand(body: dict[str, Any]) -> Any:
    """The same map cell by cell, through scenarios: words, or numbers."""
    base = hh.Scenario.from_query(body["query"])
    x, y, what = body["x"], body["y"], body["what"]
    spans = {"sequence": "first_revolution", "hop_height": "takeoff", "energy_lost": "duration", "ending": "duration"}
    table: list[list[Any]] = []
    for high in np.linspace(y["from"], y["to"], 2 * y["cells"] + 1)[1::2]:
        table.append([])
        for wide in np.linspace(x["from"], x["to"], 2 * x["cells"] + 1)[1::2]:
            words = what in ("sequence", "ending")
            try:
                cell = base.with_values({y["path"]: float(high), x["path"]: float(wide)})
            except ValueError:
                table[-1].append("" if words else math.nan)
                continue
            # a map of two cells, of which the first is wanted
            axes = {"duration": [cell.duration], "start.x": [0.0]}
            dataset = hh.maps.sweep(cell, axes, (what,), spans[what])
            value = dataset[what].values.ravel()[0]
            table[-1].append(hh.maps.words_of(dataset[what])[int(value)] if words else float(value))
    return table


def test_files_are_those_of_python(tmp_path):
    query = "plane.restitution=0.4&start.speed=3&duration=2"
    scenario = hh.Scenario.from_query(query)
    names = ("motion.toml", "motion.json", "motion.csv")
    toml, events, table = (one["value"] for one in answers("file", [{"name": name, "query": query} for name in names]))
    assert hh.Scenario.loads(toml) == scenario
    motion = hh.simulate(within(scenario))
    alike(json.loads(events), json.loads(json.dumps(motion.to_dict())))
    ours = list(csv.reader(io.StringIO(table, newline="")))
    hh.io.write_csv(motion, tmp_path / "motion.csv", motion.times(int(200 * motion.duration) + 1))
    with open(tmp_path / "motion.csv", encoding="utf-8", newline="") as stream:
        theirs = list(csv.reader(stream))
    assert ours[0] == theirs[0]
    assert table.endswith("\r\n")
    assert len(ours) == len(theirs)
    for mine, other in zip(ours[1:], theirs[1:], strict=True):
        assert [value if value.isalpha() else float(value) for value in mine] == [
            value if value.isalpha() else float(value) for value in other
        ]


def test_what_python_alone_makes_is_refused_in_a_sentence():
    (answer,) = answers("file", [{"name": "motion.mp4", "query": ""}])
    assert answer == {"error": "motion.mp4 needs Python: run hophoop lab."}


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ({"query": "duration=1e4"}, "duration = 10000 must be at most 600 s in the lab; the library itself has no such limit."),
        ({"query": "plane.mu=x"}, "plane.mu = 'x' must be a number."),
    ],
)
def test_refusals_of_films(body, said):
    assert answers("film", [body]) == [{"error": said}]
    with pytest.raises(ValueError) as caught:
        of_python(body)
    assert str(caught.value) == said


MAP = {"x": {"path": "start.speed", "from": 0, "to": 5, "cells": 4}, "y": {"path": "plane.mu", "from": 0, "to": 1, "cells": 4},
       "what": "sequence"}  # fmt: skip


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"y": MAP["x"]}, "x.path and y.path are both 'start.speed' and must differ."),
        ({"y": {**MAP["y"], "path": "start.vx"}}, "start.vx and start.speed cannot both be axes: they say the same thing"),
        ({"x": {**MAP["x"], "cells": 4096}, "y": {**MAP["y"], "cells": 4096}}, "x.cells times y.cells = 16777216 must be at"),
        ({"query": "contact.model=compliant"}, "contact.model = 'compliant' must be 'rigid' for a map."),
    ],
)  # fmt: skip
def test_refusals_of_maps(changes, said):
    body = {**MAP, **changes}
    (answer,) = answers("map", [body])
    assert answer["error"].startswith(said)
