"""Scenarios as files, links and parameters by path."""

import itertools
import json
import math
import tomllib

import numpy as np
import pytest
from hypothesis import given

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
    duration = 2.0                 # s

    [hoop]
    radius = 0.3
    parts = [{ shape = "ring", mass = 1.0, inner_radius = 0.28, outer_radius = 0.3 },
             { shape = "disk", mass = 2.0, radius = 0.02, at = 0.25 }]
    [plane]
    mu_static = 0.5
    mu_kinetic = 0.4
    [start]
    speed = 1.0
    """
    written, keys = tomllib.loads(text), hh.Scenario.loads(text).to_dict()
    assert keys["hoop"] == written["hoop"]
    assert {"mu_static", "mu_kinetic"} < set(keys["plane"])
    assert "mu" not in keys["plane"]
    equal = hh.Scenario.loads(text.replace("0.4", "0.5"))
    assert equal == hh.Scenario.loads(equal.to_toml()) == hh.Scenario(**{**keys, "plane": {"mu": 0.5}})
    assert equal.to_dict()["plane"]["mu"] == 0.5  # equal planes are written alike
    assert keys["start"] == {"x": 0.0, "angle": 0.0, "speed": 1.0}
    assert keys["contact"] == {"model": "rigid", "max_events": 100_000}
    assert hh.Scenario.loads("") == hh.Scenario()


def test_saved_files(tmp_path):
    scenario = hh.Scenario(plane=hh.Plane(mu=math.inf), start=hh.Start(height=0.5))
    for name in ("hop.toml", "hop.json", "HOP.TOML"):
        scenario.save(tmp_path / name)
        assert hh.Scenario.load(tmp_path / name) == scenario
    text = (tmp_path / "hop.toml").read_text(encoding="utf-8")
    assert "gravity = 9.81                 # m/s²\n" in text
    assert "mu = inf\n" in text
    assert '\nmodel = "rigid"\n' in text
    assert '{\n  "duration": 6.0,\n  "hoop": {\n    "radius": 1.0,' in (tmp_path / "hop.json").read_text(encoding="utf-8")


def test_links_are_short_and_readable():
    for scenario, query in (
        (hh.Scenario(), ""),
        (hh.Scenario(start=hh.Start.rolling(2.0), plane=hh.Plane(mu=0.3)), "plane.mu=0.3&start.speed=2"),
        (hh.Scenario(plane=hh.Plane(mu=-0.0)), "plane.mu=0"),  # which is equal to 0
        (hh.Scenario(plane=hh.Plane(mu=math.inf)), "plane.mu=inf"),
        (
            hh.Scenario(hoop=hh.Hoop(mass=100.0), contact=hh.Compliant(stiffness=1e16)),
            "hoop.mass=100&contact.model=compliant&contact.stiffness=1e16",
        ),
    ):
        assert scenario.to_query() == query
        assert hh.Scenario.from_query(query) == scenario
    # At rest at the top is not the usual start, and must not be left out.
    assert hh.Scenario.from_query(hh.Scenario(start=hh.Start()).to_query()).start == hh.Start()


# Parameters by path


DISK = hh.Disk(1.0, 0.1, at=0.5)
RING = "hoop.parts.0.shape=ring&hoop.parts.0.mass=1&hoop.parts.0.inner_radius=0.9&hoop.parts.0.outer_radius=1"
PARTS = f"{RING}&hoop.parts.1.shape=point_mass&hoop.parts.1.mass=2&hoop.parts.1.at=0.9"
BASE, OF_PARTS = "hoop.radius=0.5&hoop.mass=2&start.angle=0.1&start.speed=3", hh.Scenario.from_query(PARTS)
GENERAL, SLIPPING = f"{BASE}&hoop.eccentricity=0.75&hoop.inertia_ratio=0.3", BASE.replace("speed=3", "vx=3&start.omega=7")
TWO_FRICTIONS = f"{BASE}&plane.mu_static=1&plane.mu_kinetic=0.8"
ONE_DISK = {"hoop": {"radius": 0.5}, "hoop.parts": [hh.PointMass(1.0, at=0.5)], "hoop.parts.0.mass": 2.0}
COMPLIANT = {"contact": hh.Rigid(max_events=5), "contact.model": "compliant", "contact.rtol": 1e-6, "plane.mu": 0.5}


@pytest.mark.parametrize(
    ("base", "values", "changed"),
    [
        ("", {"start.speed": 2.8}, "start.speed=2.8"),
        ("", {"duration": np.float64(2.0)}, "duration=2"),
        ("", {"contact": hh.Compliant()}, "contact.model=compliant"),
        ("", {"contact.model": "compliant"}, "contact.model=compliant"),
        # in another way than given
        (BASE, {"hoop.inertia_ratio": 0.3}, GENERAL),
        (GENERAL, {"hoop.load_fraction": 0.75}, BASE),
        (BASE, {"plane.mu_kinetic": 0.8}, TWO_FRICTIONS),
        (TWO_FRICTIONS, {"plane.mu": 0.3}, f"{BASE}&plane.mu=0.3"),
        (BASE, {"start.omega": 7.0}, SLIPPING),
        (SLIPPING, {"start.speed": 3.0}, BASE),
        (
            "contact.model=compliant&contact.restitution=0.5", {"contact.damping": 3.0},
            "contact.model=compliant&contact.damping=3",
        ),
        # parts
        (PARTS, {"hoop.parts.1.mass": 3.0}, PARTS.replace("mass=2", "mass=3")),
        (
            PARTS, {"hoop.parts.1": DISK},
            f"{RING}&hoop.parts.1.shape=disk&hoop.parts.1.mass=1&hoop.parts.1.radius=0.1&hoop.parts.1.at=0.5",
        ),
        (PARTS, {"hoop.load_fraction": 0.5}, "hoop.mass=3&hoop.load_fraction=0.5"),
        # whole sections, and what stands in them; what is not named is as in the new section
        ("", {"start": hh.Start.rolling(2.0, angle=0.5), "start.omega": 5.0}, "start.angle=0.5&start.vx=2&start.omega=5"),
        (
            "", {"hoop": {"load_fraction": 0.5, "mass": 3.0}, "hoop.inertia_ratio": 0.3},
            "hoop.mass=3&hoop.eccentricity=0.5&hoop.inertia_ratio=0.3",
        ),
        ("", {"plane": hh.Plane(mu=0.5), "plane.mu_kinetic": 0.3}, "plane.mu_static=0.5&plane.mu_kinetic=0.3"),
        ("", ONE_DISK, "hoop.radius=0.5&hoop.parts.0.shape=point_mass&hoop.parts.0.mass=2&hoop.parts.0.at=0.5"),
        ("", COMPLIANT, "plane.mu=0.5&contact.model=compliant&contact.rtol=1e-6"),
        # the inertia of 0 only with the eccentricity of 1, the kinetic friction above the one before, rolling as the new hoop
        (
            "",
            {
                "hoop.radius": 0.5, "hoop.eccentricity": 1.0, "hoop.inertia_ratio": 0.0, "plane.mu_static": 1.5,
                "plane.mu_kinetic": 1.2, "start.vx": 2.0, "contact.max_events": 7,
            },
            "hoop.radius=0.5&hoop.eccentricity=1&hoop.inertia_ratio=0&plane.mu_static=1.5&plane.mu_kinetic=1.2&start.vx=2"
            "&start.omega=6.2&contact.max_events=7",
        ),
    ],
)  # fmt: skip
def test_values_are_replaced_in_any_order(base, values, changed):
    """From one link to another."""
    before, given, expected = repr(values), hh.Scenario.from_query(base), hh.Scenario.from_query(changed)
    for order in itertools.islice(itertools.permutations(values), 0, None, 97 if len(values) > 5 else 1):
        assert given.with_values({path: values[path] for path in order}) == expected
    assert repr(values) == before


def test_the_scenario_has_no_such_part():
    for step in ("2", "-1", "last"):
        for path in (f"hoop.parts.{step}", f"hoop.parts.{step}.mass"):
            assert f"the scenario has no {step!r}" in said(lambda path=path: OF_PARTS.replace(path, DISK))


def test_every_parameter_has_a_meaning_and_a_unit():
    assert paths()[:4] == ["duration", "hoop.radius", "hoop.mass", "hoop.load_fraction"]
    assert all(parameter(path).description for path in paths())
    known = {"plane.mu": "1", "start.omega": "rad/s", "plane.impact_law": "", "hoop.parts.3.at": "m"}
    assert {path: parameter(path).unit for path in known} == known


# Refusals of files


@pytest.mark.parametrize(
    ("text", "form", "expected"),
    [
        ("{", None, "the text is not valid JSON: "),
        ("[1]", "json", "the text must hold a table of keys, not [1]."),
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
    assert "must end in .toml or .json." in said(lambda: hh.Scenario().save(tmp_path / "hop.yaml"))


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ({"plane.mux": 1.0}, "plane.mux is not a known key; did you mean plane.mu?"),
        ({"wall.mu": 1.0}, "wall is not a known key; known are"),
        ({"duration.long": 1.0}, "duration.long is not a parameter of a scenario"),
        ({"hoop.parts.0.mass": 1.0}, "hoop.parts.0.mass is not there to be replaced"),
        ({"plane.mu.static": 1.0}, "plane.mu.static is not there to be replaced"),
        ({"start.speed": 1.0, "start.vx": 2.0}, "start.speed = 1.0 and start.vx = 2.0 cannot be given together."),
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
