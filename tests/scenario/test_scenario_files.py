"""Scenarios as files, links and parameters by path."""

import itertools
import json
import math
import random
import tomllib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import hophoop as hh
from hophoop.scenario import parameter, paths, sentence
from strategies import said, scenarios

# Files and links


@given(scenarios)
def test_files_and_links_give_the_same_scenario(scenario):
    keys = scenario.to_dict()
    assert hh.Scenario.from_dict(keys) == scenario
    assert hh.Scenario.loads(scenario.to_toml()) == scenario
    # Strict JSON: an infinity would not get through.
    assert hh.Scenario.loads(json.dumps(keys, allow_nan=False)) == scenario
    query = scenario.to_query()
    assert hh.Scenario.from_query(query) == scenario
    assert hh.Scenario.from_query("?" + query).to_query() == query
    assert query.isascii()
    assert " " not in query


def test_keys_stay_as_the_user_wrote_them():
    text = """
    duration = 2.0
    [hoop]
    radius = 0.3
    parts = [{ shape = "ring", mass = 1.0, inner_radius = 0.28, outer_radius = 0.3 },
             { shape = "disk", mass = 2.0, radius = 0.02, at = 0.25 }]
    [plane]
    mu_static = 0.5
    mu_kinetic = 0.5
    [start]
    speed = 1.0
    """
    written, keys = tomllib.loads(text), hh.Scenario.loads(text).to_dict()
    assert keys["hoop"] == written["hoop"]
    assert {"mu_static", "mu_kinetic"} < set(keys["plane"])
    assert "mu" not in keys["plane"]
    assert keys["start"] == {"x": 0.0, "angle": 0.0, "speed": 1.0}
    assert keys["contact"] == {"model": "rigid", "max_events": 100_000}


def test_the_file_of_the_design():
    text = """
    duration = 6.0                 # s

    [hoop]
    radius = 1.0                   # m
    mass = 1.0                     # kg
    load_fraction = 0.75

    [plane]
    mu = 1.0

    [start]
    speed = 3.1

    [contact]
    model = "rigid"
    """
    assert hh.Scenario.loads(text) == hh.Scenario() == hh.Scenario.loads("")


def test_saved_files(tmp_path, monkeypatch):
    scenario = hh.Scenario(plane=hh.Plane(mu=math.inf), start=hh.Start(height=0.5))
    for name in ("hop.toml", "hop.json", "HOP.TOML"):
        scenario.save(tmp_path / name)
        assert hh.Scenario.load(tmp_path / name) == scenario
    text = (tmp_path / "hop.toml").read_text(encoding="utf-8")
    assert "gravity = 9.81                 # m/s²\n" in text
    assert "mu = inf\n" in text
    (tmp_path / "with_mark.txt").write_text("\ufeff" + text, encoding="utf-8")
    assert hh.Scenario.load(tmp_path / "with_mark.txt") == scenario
    with (tmp_path / "hop.json").open(encoding="utf-8") as stream:
        monkeypatch.setattr("sys.stdin", stream)
        assert hh.Scenario.load("-") == scenario


def test_equal_scenarios_have_equal_links():
    zero, minus = hh.Scenario(start=hh.Start(x=0.0)), hh.Scenario(start=hh.Start(x=-0.0))
    assert zero == minus
    assert zero.to_query() == minus.to_query()
    assert hh.Scenario(plane=hh.Plane(mu=-0.0)).to_query() == hh.Scenario(plane=hh.Plane(mu=0)).to_query()


def test_links_are_short_and_readable():
    assert hh.Scenario().to_query() == ""
    scenario = hh.Scenario(start=hh.Start.rolling(2.0), plane=hh.Plane(mu=0.3))
    assert scenario.to_query() == "plane.mu=0.3&start.speed=2"
    assert hh.Scenario(contact=hh.Compliant()).to_query() == "contact.model=compliant"
    # At rest at the top is not the usual start, and must not be left out.
    assert hh.Scenario.from_query(hh.Scenario(start=hh.Start()).to_query()).start == hh.Start()
    assert hh.Scenario.from_query("plane.mu=inf").plane.mu == math.inf
    stiff = hh.Scenario(hoop=hh.Hoop(mass=100.0), contact=hh.Compliant(stiffness=1e16))
    assert stiff.to_query() == "hoop.mass=100&contact.model=compliant&contact.stiffness=1e16"


# Parameters by path


def test_replacing_a_parameter():
    base = hh.Scenario()
    assert base.replace("start.speed", 2.8).start == hh.Start.rolling(2.8)
    assert base.replace("duration", np.float64(2.0)).duration == 2.0
    assert base.replace("plane.slope", 0.1).plane == hh.Plane(slope=0.1)
    assert base.replace("hoop.load_fraction", 0.5).hoop == hh.Hoop.ideal(0.5)
    assert base.replace("contact", hh.Compliant()).contact == hh.Compliant()
    assert base.replace("contact.model", "compliant").contact == hh.Compliant()
    assert base == hh.Scenario()


def test_replacing_in_another_way_than_given():
    base = hh.Scenario(hoop=hh.Hoop.ideal(0.75, radius=0.5, mass=2.0), start=hh.Start.rolling(3.0, angle=0.1))
    free = base.replace("hoop.inertia_ratio", 0.3)
    assert free.hoop == hh.Hoop(radius=0.5, mass=2.0, eccentricity=0.75, inertia_ratio=0.3)
    assert free.replace("hoop.load_fraction", 0.75) == base
    assert base.replace("plane.mu_kinetic", 0.8).plane == hh.Plane(mu_static=1.0, mu_kinetic=0.8)
    assert base.replace("plane.mu_kinetic", 0.8).replace("plane.mu", 0.5).plane == hh.Plane(mu=0.5)
    slipping = base.replace("start.omega", 7.0)
    assert slipping.start == hh.Start(vx=3.0, omega=7.0, angle=0.1)
    assert slipping.replace("start.speed", 3.0) == base
    damped = hh.Scenario(contact=hh.Compliant(restitution=0.5)).replace("contact.damping", 3.0)
    assert damped.contact == hh.Compliant(damping=3.0)


def test_replacing_a_part_of_a_hoop():
    parts = [hh.Ring(1.0, 0.9, 1.0), hh.PointMass(2.0, at=0.9)]
    base = hh.Scenario(hoop=hh.Hoop.from_parts(1.0, parts))
    heavier = base.replace("hoop.parts.1.mass", 3.0)
    assert heavier.hoop == hh.Hoop.from_parts(1.0, [parts[0], hh.PointMass(3.0, at=0.9)])
    assert base.replace("hoop.load_fraction", 0.5).hoop == hh.Hoop.ideal(0.5, radius=1.0, mass=3.0)
    assert "the scenario has no '2'" in said(lambda: base.replace("hoop.parts.2.mass", 1.0))


def test_every_parameter_has_a_meaning_and_a_unit():
    assert paths()[:4] == ["duration", "hoop.radius", "hoop.mass", "hoop.load_fraction"]
    for path in paths():
        assert parameter(path).description
    units = {path: parameter(path).unit for path in paths()}
    assert (units["plane.mu"], units["start.omega"], units["plane.impact_law"]) == ("1", "rad/s", "")
    assert parameter("hoop.parts.3.at").unit == "m"
    assert "plane.nu is not a parameter of a scenario" in said(lambda: parameter("plane.nu"))


def test_schema_says_units_and_forbids_the_rest():
    schema = hh.Scenario.model_json_schema()
    assert schema["$defs"]["Plane"]["properties"]["gravity"]["unit"] == "m/s²"
    assert schema["additionalProperties"] is False


# Refusals of files


@pytest.mark.parametrize(
    ("text", "form", "expected"),
    [
        ("duration =", None, "the text is not valid TOML: "),
        ("{", None, "the text is not valid JSON: "),
        ("[1]", "json", "the text must hold a table of keys, not [1]."),
        ('{"duration": 1, "duration": 2}', None, "The key 'duration' is given twice."),
        ("[" * 100_000, "json", "the text is not valid JSON: "),
        ("duration = 1", "yaml", "format = 'yaml' must be 'toml' or 'json'."),
        ("duration = 2020-01-01", None, "must be a number."),
        ("duration = nan", None, "duration = nan must be a finite number."),
    ],
)
def test_refusals_of_texts(text, form, expected):
    assert expected in said(lambda: hh.Scenario.loads(text, form))


def test_refusals_of_paths(tmp_path):
    with pytest.raises(OSError, match=r"none\.toml") as caught:
        hh.Scenario.load(tmp_path / "none.toml")
    assert sentence(caught.value) == f"{tmp_path / 'none.toml'}: No such file or directory."
    (tmp_path / "picture.toml").write_bytes(b"\x89PNG\xff")
    assert "is not a text file in UTF-8." in said(lambda: hh.Scenario.load(tmp_path / "picture.toml"))
    assert "must end in .toml or .json." in said(lambda: hh.Scenario().save(tmp_path / "hop.yaml"))


# Several values at once

TOGETHER = {
    "duration": 2.0,
    "hoop.radius": 0.5,
    "hoop.eccentricity": 1.0,
    "hoop.inertia_ratio": 0.0,  # only with an eccentricity of 1
    "plane.mu_static": 1.5,
    "plane.mu_kinetic": 1.2,  # above the friction of before
    "plane.impact_law": "newton",
    "start.vx": 2.0,
    "start.height": 0.1,
    "contact.max_events": 7,
}


@pytest.mark.parametrize("seed", range(8))
def test_the_order_of_several_values_does_not_count(seed):
    paths = list(TOGETHER)
    random.Random(seed).shuffle(paths)
    made = hh.Scenario().with_values({path: TOGETHER[path] for path in paths})
    assert made == hh.Scenario().with_values(TOGETHER)
    assert made.hoop.massless
    assert (made.plane.mu_static, made.plane.mu_kinetic) == (1.5, 1.2)
    assert made.start.omega == 3.1 / 0.5  # as the new hoop would roll
    assert made.contact.max_events == 7


@given(mu=st.floats(0.0, 2.0), speed=st.floats(0.1, 5.0), slope=st.floats(0.0, 0.5), load=st.floats(0.05, 0.95))
def test_several_values_are_those_of_one_replacement_after_the_other(mu, speed, slope, load):
    values = {"plane.mu": mu, "start.speed": speed, "plane.slope": slope, "hoop.load_fraction": load}
    one_by_one = hh.Scenario()
    for path, value in values.items():
        one_by_one = one_by_one.replace(path, value)
    assert hh.Scenario().with_values(values) == one_by_one


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ({"plane.mux": 1.0}, "plane.mux is not a known key; did you mean mu?"),
        ({"plane.mux": 1.0, "plane.mu": 0.3}, "plane.mux is not a known key"),
        ({"wall.mu": 1.0}, "wall is not a known key; known are"),
        ({"wall": 1.0}, "wall is not a known key; known are"),
        ({"duration.long": 1.0}, "duration.long is not a parameter of a scenario"),
        ({"hoop.parts.0.mass": 1.0}, "hoop.parts.0.mass is not there to be replaced"),
        ({"plane.mu.static": 1.0}, "plane.mu.static is not there to be replaced"),
        ({"start.height": -1.0}, "start.height = -1.0 must be from 0 to 1e+06 m."),
        ({"start.speed": 1.0, "start.vx": 2.0}, "start.speed = 1.0 and start.vx = 2.0 cannot be given together."),
        ({"start.vx": 2.0, "start.speed": 1.0}, "start.vx = 2.0 and start.speed = 1.0 cannot be given together."),
        ({"hoop.load_fraction": 0.5, "hoop.eccentricity": 0.2}, "cannot be given together"),
        ({"hoop.load_fraction": 0.5, "hoop.parts.0.mass": 0.2}, "cannot be given together"),
        ({"plane.mu": 1.0, "plane.mu_static": 2.0}, "cannot be given together"),
        ({"plane.mu_static": 1.0, "plane.mu_kinetic": 2.0}, "plane.mu_kinetic = 2.0 must not exceed"),
        # a hoop that is not allowed is said also where its start follows from it
        ({"hoop.radius": -1.0, "start.omega": 2.0}, "hoop.radius = -1.0 must be from 1e-06 to 1e+06 m."),
        ({"hoop": {"radius": -1.0}, "hoop.eccentricity": 0.5}, "hoop.radius = -1.0 must be from 1e-06 to 1e+06 m."),
    ],
)
def test_refusals_of_several_values(values, expected):
    assert expected in said(lambda: hh.Scenario().with_values(values))


def test_a_whole_section_and_what_stands_in_it():
    made = hh.Scenario().with_values({"start.angle": 0.5, "start": hh.Start.rolling(2.0), "plane": {"mu": 0.3}})
    assert made == hh.Scenario(start=hh.Start.rolling(2.0, angle=0.5), plane=hh.Plane(mu=0.3))


def test_a_section_given_whole_is_the_one_that_is_changed():
    """What a parameter in it does not name is as in the new section, not as in the old one."""
    base = hh.Scenario()
    start = base.with_values({"start.omega": 5.0, "start": hh.Start.rolling(2.0, angle=0.5)}).start
    assert start == hh.Start(vx=2.0, omega=5.0, angle=0.5)
    start = base.with_values({"start": hh.Start(height=1.0, vx=3.0), "start.omega": 2.0}).start
    assert start == hh.Start(height=1.0, vx=3.0, omega=2.0)
    hoop = base.with_values({"hoop.inertia_ratio": 0.3, "hoop": {"load_fraction": 0.5, "mass": 3.0}}).hoop
    assert hoop == hh.Hoop(mass=3.0, eccentricity=0.5, inertia_ratio=0.3)
    assert base.with_values({"plane": hh.Plane(mu=0.5), "plane.mu_kinetic": 0.3}).plane == hh.Plane(
        mu_static=0.5, mu_kinetic=0.3
    )


def test_wholes_come_before_what_stands_in_them_in_any_order():
    values = {"contact.rtol": 1e-6, "plane.mu": 0.5, "contact.model": "compliant", "contact": hh.Rigid(max_events=5)}
    expected = hh.Scenario(plane=hh.Plane(mu=0.5), contact=hh.Compliant(rtol=1e-6))
    for order in itertools.permutations(values):
        assert hh.Scenario().with_values({path: values[path] for path in order}) == expected
    values = {"hoop.parts.0.mass": 2.0, "hoop.parts": [hh.PointMass(1.0, at=0.5)], "hoop": {"radius": 0.5}}
    expected = hh.Scenario(hoop=hh.Hoop.from_parts(0.5, (hh.PointMass(2.0, at=0.5),)))
    for order in itertools.permutations(values):
        assert hh.Scenario().with_values({path: values[path] for path in order}) == expected


def test_values_that_are_given_stay_as_they_are():
    given = {"plane": {"mu": 0.5}, "plane.slope": 0.1, "hoop.parts": [{"shape": "disk", "mass": 1.0, "radius": 0.1, "at": 0.5}]}
    copy = json.loads(json.dumps(given))
    hh.Scenario().with_values({**given, "hoop.parts.0.mass": 2.0})
    assert given == copy


def test_replacing_a_whole_part():
    base = hh.Scenario(hoop=hh.Hoop.from_parts(1.0, [hh.Ring(1.0, 0.9, 1.0), hh.PointMass(2.0, at=0.9)]))
    disk = hh.Disk(1.0, 0.1, at=0.5)
    assert base.replace("hoop.parts.1", disk).hoop.parts == (hh.Ring(1.0, 0.9, 1.0), disk)
    for step in ("2", "-1", "last"):
        assert f"the scenario has no {step!r}" in said(lambda step=step: base.replace(f"hoop.parts.{step}", disk))
