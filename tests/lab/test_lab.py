"""The lab without a browser: frames, requests, limits, maps, files, controls, the script."""

import json
import math
import re
from dataclasses import replace

import numpy as np
import pytest

import hophoop as hh
from hophoop.lab.api import calls, files, limits, packing
from hophoop.lab.api.motion import columns as motion_columns
from hophoop.lab.site import controls, export
from hophoop.scenario import InputError, paths

HOP = hh.Scenario()


@pytest.fixture(scope="module")
def motion():
    return hh.simulate(HOP)


def answered(call, body, bounds=limits.USUAL):
    return calls.answer(calls.read(call, body, bounds), bounds)


# Frames


def test_packed_arrays_come_back():
    arrays = {
        "t": np.array([0.0, 1e-17, 3.0]),
        "vx": np.array([1.5, np.inf]),
        "modes": np.eye(3, dtype=np.uint8),
    }
    header, back = packing.unpack(packing.pack({"words": "θ̇ → ∞"}, arrays))
    assert header == {"words": "θ̇ → ∞"}
    assert back["t"].dtype == np.float64
    for name, array in arrays.items():
        np.testing.assert_array_equal(back[name], array)


def test_every_array_starts_where_a_browser_can_read_it():
    block = packing.pack({}, {"modes": np.zeros(3, np.uint8), "t": np.zeros(2), "vx": np.zeros(1)})
    length = int.from_bytes(block[:4], "little")
    assert (length + 4) % 8 == 0
    listed = json.loads(block[4 : 4 + length])["arrays"]
    assert [entry["place"] % 8 for entry in listed] == [0, 0, 0]


def test_the_film_holds_both_sides_of_each_event(motion):
    columns = motion_columns(motion)
    landing = motion.find("impact")[0]
    before, after = np.flatnonzero(columns["t"] == landing.t)
    assert columns["vy"][before] == pytest.approx(landing.before.vy)
    assert columns["vy"][after] == 0.0
    assert columns["mode"][before] == 3
    assert columns["mode"][after] == 0
    assert (np.diff(columns["t"]) >= 0.0).all()
    assert columns["t"][0] == 0.0
    assert columns["t"][-1] == motion.duration
    for event in motion.events[1:-1]:
        assert np.count_nonzero(columns["t"] == event.t) == 2, event.kind


def test_frames_are_the_motion(motion):
    columns = motion_columns(motion)
    places = np.flatnonzero(np.diff(columns["t"], append=np.inf) > 0.0)[::50]
    sample = motion.at(columns["t"][places])
    for name in ("x", "height", "angle", "omega", "normal_force", "kinetic"):
        np.testing.assert_array_equal(columns[name][places], getattr(sample, name), name)


def test_utilization_is_one_in_slip_and_nowhere_above(motion):
    columns = motion_columns(motion)
    slip = np.isin(columns["mode"], (1, 2))
    np.testing.assert_allclose(columns["utilization"][slip], 1.0, rtol=1e-12)
    assert np.isnan(columns["utilization"][columns["mode"] == 3]).all()
    assert np.nanmax(columns["utilization"]) <= 1.0 + 1e-12


def test_a_motion_without_length_has_a_frame():
    jammed = hh.simulate(hh.Scenario(start=hh.Start(angle=0.0, vx=1.0, omega=1.0), duration=1e-9))
    assert len(motion_columns(jammed)["t"]) >= 2


# Requests


def test_changes_follow_the_rules_of_a_scenario():
    request = calls.read("motion", {"changes": [["start.omega", 2.0], ["plane.mu", 0.5]]})
    assert request.scenario.start.vx == 3.1
    assert request.scenario.start.omega == 2.0
    assert request.scenario.plane.mu == 0.5


def test_equal_requests_have_equal_tags():
    spelt_out = {"scenario": {"plane": {"mu": 1}, "start": {"speed": 3.1}, "duration": 6}}
    assert calls.read("simulate", {}).tag == calls.read("simulate", spelt_out).tag
    others = [
        calls.read("simulate", {"samples": 2}),
        calls.read("theory", {}),
        calls.read("simulate", {"query": "start.speed=3"}),
    ]
    assert len({request.tag for request in [*others, calls.read("simulate", {})]}) == 4


@pytest.mark.parametrize(
    ("call", "body", "said"),
    [
        ("fly", {}, "call = 'fly' must be one of simulate, theory"),
        ("motion", [], r"The body must be a JSON object, not \[\]\."),
        ("motion", {"scenario": 3}, "scenario = 3 must be a table of keys."),
        ("motion", {"scenario": {"hop": {}}}, "hop is not a known key; did you mean hoop?"),
        ("motion", {"changes": {}}, "changes = {} must be a list"),
        ("motion", {"changes": [["plane.mu"]]}, "not a pair of path and value"),
        ("motion", {"changes": [["plane.mu", -1]]}, "plane.mu = -1 must be at least 0"),
        ("motion", {"query": "plane.mu=x"}, "plane.mu = 'x' must be a number"),
        ("simulate", {"samples": 1}, "samples = 1 must be a whole number from 0 and not 1."),
        ("simulate", {"samples": True}, "samples = True must be a number"),
        ("motion", {"window": [3]}, "window = [3] must be two times"),
        ("motion", {"window": [2, 1]}, "window = [2, 1] must be two times"),
        ("motion", {"window": [True, 1]}, "window.0 = True must be a number."),
        ("file", {"name": "../../etc/passwd"}, "must be one of motion.toml"),
        ("map", {}, "x is missing (and 1 more problem)."),
        ("map", {"x": 3, "y": {}}, "x = 3 must be a table of keys"),
        ("map", {"x": {"pat": 3}, "y": {}}, "pat is not a known key; did you mean path?"),
        ("map", {"x": {"path": "plane.colour"}, "y": {}}, "plane.colour is not a parameter"),
        ("map", {"x": {"path": "plane.impact_law", "from": 0, "to": 1}, "y": {}}, "not that of a word"),
        (
            "map",
            {"x": {"path": "plane.mu", "from": 0, "to": "1"}, "y": {}},
            "x.to = '1' must be a number (and 3 more problems).",
        ),
    ],
)
def test_bad_requests_are_refused_in_one_sentence(call, body, said):
    with pytest.raises(InputError, match=said if "\\" in said else re.escape(said)) as error:
        calls.read(call, body)
    assert str(error.value).endswith((".", "?"))
    assert "\n" not in str(error.value)


def test_map_options_are_checked():
    axis = {"path": "plane.mu", "from": 0, "to": 1}
    other = {"path": "start.speed", "from": 0, "to": 1}
    with pytest.raises(InputError, match="must differ"):
        calls.read("map", {"x": axis, "y": axis})
    with pytest.raises(InputError, match=r"what = .* must be one of sequence"):
        calls.read("map", {"x": axis, "y": other, "what": "luck"})
    with pytest.raises(InputError, match="z is not a known key"):
        calls.read("map", {"x": axis, "y": other, "z": 1})
    with pytest.raises(limits.TooMuch, match=r"x\.cells times y.cells = 90000 must be at most 65536"):
        calls.read("map", {"x": {**axis, "cells": 300}, "y": {**other, "cells": 300}})
    with pytest.raises(limits.TooMuch, match=r"revolutions in all, and must be at most"):
        answered(
            "map",
            {
                "x": {**axis, "cells": 200},
                "y": {**other, "cells": 200},
                "what": "ending",
                "scenario": {"duration": 500},
            },
        )
    with pytest.raises(InputError, match="must be 'rigid' for a map"):
        answered("map", {"x": axis, "y": other, "scenario": {"contact": {"model": "compliant"}}})


# Limits


def test_limits_bound_a_motion():
    with pytest.raises(limits.TooMuch, match="duration = 601 must be at most 600 s"):
        limits.within(hh.Scenario(duration=601))
    with pytest.raises(limits.TooMuch, match="65 parts"):
        limits.within(hh.Scenario(hoop=hh.Hoop.from_parts(1, [hh.PointMass(1, at=1)] + 64 * [hh.Ring(1, 0.9, 1)])))
    stiff = hh.Scenario(contact=hh.Compliant(stiffness=1e14))
    with pytest.raises(limits.TooMuch, match=r"about .* million steps; at most 3 million"):
        limits.within(stiff)
    assert limits.within(HOP).contact.max_events == limits.USUAL.events
    own = hh.Scenario(contact=hh.Rigid(max_events=7))
    assert limits.within(own) is own


def test_too_many_events_are_said():
    few = replace(limits.USUAL, events=5)
    with pytest.raises(limits.TooMuch, match="5 events within"):
        answered("simulate", {}, few)
    # the page shows what there is
    assert answered("motion", {}, few).header["status"] == "event_limit"
    # and who asks for few gets few
    own = {"scenario": {"contact": {"max_events": 3}}}
    assert answered("simulate", own, few).header["status"] == "event_limit"


# What surrounds a motion


@pytest.mark.parametrize(
    "query",
    ["plane.gravity=0", "plane.slope=-0.2", "plane.slope=1.2", "hoop.load_fraction=0", "plane.mu=inf",
     "plane.mu=0", "hoop.load_fraction=1&plane.gravity=0", "contact.model=compliant", "start.height=0.3"],
)  # fmt: skip
def test_theory_and_motion_answer_at_the_edges(query):
    body = {"query": query}
    json.loads(answered("theory", body).json())
    packing.unpack(answered("motion", body).packed())
    json.loads(answered("simulate", {**body, "samples": 5}).json())


def test_a_map_holds_the_motions_of_its_cells():
    body = {
        "x": {"path": "start.speed", "from": 2.0, "to": 3.4, "cells": 6},
        "y": {"path": "plane.mu", "from": 0.3, "to": 1.2, "cells": 4},
        "what": "hop_height",
    }
    reply = answered("map", body)
    assert reply.arrays["values"].shape == (4, 6)
    for row, column in [(3, 5), (2, 0), (0, 5)]:
        speed = 2.0 + (column + 0.5) * 1.4 / 6
        mu = 0.3 + (row + 0.5) * 0.9 / 4
        single = hh.simulate(HOP.replace("start.speed", speed).replace("plane.mu", mu))
        hop = next((e for e in single.events if e.kind == "takeoff"), None)
        value = reply.arrays["values"][row, column]
        if hop is None:
            assert math.isnan(value)
        else:
            landing = next(e.t for e in single.events if e.kind == "impact" and e.t > hop.t)
            heights = single.at(np.linspace(hop.t, landing, 2001)).height
            assert value == pytest.approx(heights.max(), rel=1e-5)


def test_classes_of_a_map_have_words_and_colours():
    axes = {
        "x": {"path": "start.speed", "from": 0.1, "to": 5.0},
        "y": {"path": "plane.mu", "from": 0.05, "to": 1.5},
    }
    reply = answered("map", axes)
    classes = reply.header["classes"]
    values = reply.arrays["values"]
    assert values.shape == (48, 48)
    assert set(np.unique(values)) == set(range(len(classes)))
    named = {entry["name"]: entry for entry in classes}
    assert named["RKRSH"]["text"] == "roll → skid → roll → spin → flight"
    assert all(re.fullmatch(r"#[0-9a-fA-F]{6}", entry["color"]) for entry in classes)


# Controls


def test_controls_are_parameters_with_valid_ends():
    offered = controls.controls()
    known = set(paths())
    for group in offered["groups"].values():
        for slider in group:
            assert slider["path"] in known
            for end in (slider["least"], slider["most"]):
                value = math.radians(end) if slider["degrees"] else end
                base = HOP
                if slider["path"].startswith("contact."):
                    base = HOP.replace("contact.model", "compliant")
                if slider["path"] == "plane.mu_static":
                    base = HOP.replace("plane.mu_kinetic", 0.0)
                if slider["path"] == "plane.mu_kinetic":
                    base = HOP.replace("plane.mu", 2.0)
                base.replace(slider["path"], value)
    for choice in offered["choices"]:
        for option, _ in choice["options"]:
            base = HOP
            if choice["path"] in ("contact.law", "contact.friction"):
                base = HOP.replace("contact.model", "compliant")
            base.replace(choice["path"], option)
    for axis in offered["map_axes"]:
        assert axis["path"] in known


# Files


def test_files_hold_the_motion(tmp_path, motion):
    made = {name: kind.make(HOP, limits.USUAL) for name, kind in files.KINDS.items() if not kind.slow}
    assert hh.Scenario.loads(made["motion.toml"].decode()) == HOP
    assert json.loads(made["motion.json"])["sequence"] == motion.sequence
    rows = made["motion.csv"].decode().splitlines()
    assert rows[0].startswith("t [s],mode,x [m]")
    assert len(rows) == 1202
    (tmp_path / "motion.nc").write_bytes(made["motion.nc"])
    loaded = hh.load(tmp_path / "motion.nc")
    assert loaded.at(1.3).x == motion.at(1.3).x


def test_a_film_is_made_and_has_its_limit():
    pytest.importorskip("av")
    short = hh.Scenario(duration=0.2)
    assert files.KINDS["motion.gif"].make(short, limits.USUAL)[:4] == b"GIF8"
    with pytest.raises(limits.TooMuch, match="at most 20 s for a film"):
        files.KINDS["motion.mp4"].make(hh.Scenario(duration=21), limits.USUAL)


# The script


def test_the_script_is_one_module_without_imports():
    script = export.static_text("lab.js")
    assert not re.search(r"(^|[;}])import\b", script, re.MULTILINE)
    (exported,) = re.findall(r"\bexport\{([^}]*)\}", script)
    words = {"current", "languageMenu", "name", "repeat", "say", "speakFrom", "t"}  # for the page that makes tags
    assert set(re.findall(r" as (\w+)", exported)) == {"default", "mount", *words}


def test_the_page_asks_for_nothing_from_elsewhere():
    for text in (export.static_text("lab.js"), export.static_text("lab.css"), export.static_text("index.html")):
        text = text.replace("\\\n", "")  # long lines are broken, also within a string
        assert not re.findall(r"https?://(?!www\.w3\.org/(?:2000/(?:svg|xmlns)|1999/xlink)\b)[^\s\"'`]+", text)


def test_every_file_of_the_page_is_used():
    folder = files.Path(export.__file__).parents[1] / "static"
    assert {path.name for path in folder.iterdir()} == {
        "index.html", "pick.html", "tables.json", "backdrop.js", "service_worker.js", "widget.js",
        *(f"words.{code}.json" for code in export.languages()), *export.STATIC, *export.PAGES,
    }  # fmt: skip


def test_a_long_motion_is_sampled_where_its_speed_is_extreme():
    motion = hh.simulate(hh.Scenario(duration=60.0))
    found = motion_columns(motion)
    coarse = motion.at(np.linspace(0.0, motion.duration, 6001))
    fine = motion.at(np.linspace(57.0, 60.0, 60_001))
    late = found["t"] > 57.0
    steady = coarse.t > 57.0
    exact = fine.vx.max()
    assert found["vx"][late].max() == pytest.approx(exact, rel=1e-5)
    assert found["vx"][late].max() >= coarse.vx[steady].max()
    bottoms = np.mod(found["angle"][late], 2.0 * np.pi) - np.pi
    assert np.abs(bottoms).min() < 1e-3 < np.abs(np.mod(coarse.angle[steady], 2.0 * np.pi) - np.pi).min()
