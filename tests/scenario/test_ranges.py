"""What a number of a scenario may be: both ends of every range, and a sentence beyond them."""

import math

import pytest

import hophoop as hh
from hophoop.vocabulary.parameters import RANGES, RELATIVE_SLIP_SPEED, RELATIVE_STIFFNESS
from strategies import said

# how a scenario with this value is built; what is not here follows the path itself
BUILDERS = {
    "hoop.parts.mass": lambda value: hh.PointMass(value, at=0.0),
    "hoop.parts.length": lambda value: hh.Disk(1.0, value),
    "hoop.load_fraction": lambda value: hh.Hoop.ideal(value),
    "hoop.eccentricity": lambda value: hh.Hoop(eccentricity=value, inertia_ratio=0.5),
    "hoop.inertia_ratio": lambda value: hh.Hoop(eccentricity=1.0, inertia_ratio=value),
    "plane.mu_static": lambda value: hh.Plane(mu_static=value, mu_kinetic=0.0),
    "plane.mu_kinetic": lambda value: hh.Plane(mu_static=math.inf, mu_kinetic=value),
    "start.speed": lambda value: hh.Start.rolling(value),
    "duration": lambda value: hh.Scenario(duration=value),
}
SECTIONS = {"hoop": hh.Hoop, "plane": hh.Plane, "start": hh.Start, "contact": hh.Compliant}


def build(path, value):
    """The part of a scenario that has this value."""
    if path in BUILDERS:
        return BUILDERS[path](value)
    section, _, name = path.rpartition(".")
    return SECTIONS[section](**{name: value})


def test_a_range_ends_at_a_power_of_ten():
    """Which the table shows rounded; the slope ends near the vertical."""
    kept = [allowed for path, allowed in RANGES.items() if path != "plane.slope"]
    for allowed in (*kept, RELATIVE_STIFFNESS, RELATIVE_SLIP_SPEED):
        for end in (allowed.least, allowed.most):
            assert end == 0.0 or abs(end) == float(f"1e{round(math.log10(abs(end)))}")


@pytest.mark.parametrize("path", RANGES)
def test_both_ends_are_allowed_and_beyond_them_is_refused_in_a_sentence(path):
    allowed = RANGES[path]
    for value in (allowed.least, allowed.most, *allowed.also):
        build(path, value)
    beyond = [2.0 * allowed.most + 1.0]
    if allowed.least != 0.0:
        beyond.append(0.5 * allowed.least if allowed.least > 0.0 else 2.0 * allowed.least)
    for value in beyond:
        if path == "contact.max_events":
            value = 0 if value < 1 else int(value)
        text = said(lambda value=value: build(path, value))
        name = path.rpartition(".")[2]
        named = (name, "radius", "mass") if path.startswith("hoop.parts") else (name,)
        assert any(f"{word} = {value!r} must" in text for word in named), text


def test_the_schema_has_the_ranges():
    """So what is drawn from the schema, as by the lab's tests, stays where motions are computed."""
    schema = hh.Scenario.model_json_schema()["$defs"]
    for model, name, ends in (
        ("Hoop", "radius", (1e-6, 1e6)), ("Plane", "gravity", (0.0, 1e6)), ("Rigid", "max_events", (1, 1e7)),
        ("Compliant", "max_events", (1, 1e7)),
    ):  # fmt: skip
        field = schema[model]["properties"][name]
        assert (field["minimum"], field["maximum"]) == ends
    assert schema["Compliant"]["properties"]["stiffness"]["maximum"] == 1e18
    assert schema["Plane"]["properties"]["gravity"]["unit"] == "m/s²"
    assert schema["Plane"]["additionalProperties"] is False
