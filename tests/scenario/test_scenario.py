"""Hoop, plane, start and contact: what they accept, and what they say when they do not."""

import json
import math
import pickle
import re

import numpy as np
import pytest
from hypothesis import given
from pydantic import ValidationError

import hophoop as hh
from hophoop.kernel.records.refusals import Refusal
from hophoop.scenario import models, scenario, sentence, time_unit, to_body
from hophoop.scenario.checking import RULES, refused
from strategies import bodies, said


def alike(text):
    """A refusal with whole numbers as they were given: pydantic before 2.12 shows −1 as −1.0."""
    return re.sub(r"(= -?\d+)\.0 must", r"\1 must", text)


# What a hoop is


def test_reference_case():
    scenario = hh.Scenario()
    assert scenario.hoop == hh.Hoop.ideal(load_fraction=0.75, radius=1.0, mass=1.0)
    assert scenario.plane == hh.Plane(gravity=9.81, slope=0.0, mu=1.0, restitution=0.0)
    assert scenario.start == hh.Start.rolling(3.1)
    assert (scenario.duration, scenario.contact) == (6.0, hh.Rigid())
    assert (scenario.hoop.eccentricity, scenario.hoop.inertia_ratio) == (0.75, 0.4375)


def test_ideal_hoop_keeps_its_digits_near_the_massless_one():
    for power in (1, 6, 12):
        gamma = 1.0 - 10.0**-power
        exact = (1 - gamma) * (1 + gamma)  # 1 − γ is exact in floating point here
        assert hh.Hoop.ideal(gamma).inertia_ratio == pytest.approx(exact, rel=4e-16)


def test_massless_hoop():
    hoop = hh.Hoop.ideal(load_fraction=1.0)
    assert (hoop.eccentricity, hoop.inertia_ratio, hoop.massless) == (1.0, 0.0, True)
    assert hh.Hoop.from_parts(0.3, [hh.PointMass(0.7, at=0.3)]).massless
    assert hh.Hoop.from_parts(0.3, [hh.PointMass(0.1, at=-0.3), hh.PointMass(0.2, at=-0.3)]).massless


def test_parts_and_a_hole_against_moments_of_inertia_of_tables():
    """Each part with its place and its own moment of inertia, and Steiner's theorem; a hole has a negative mass."""
    parts = {
        hh.Ring(0.8, 0.45, 0.5): (0.0, 0.8 * (0.45**2 + 0.5**2) / 2),
        hh.Disk(1.1, 0.06, at=0.43): (0.43, 1.1 * 0.06**2 / 2),
        hh.Rod(0.3, 0.4, at=0.25): (0.25, 0.3 * 0.4**2 / 12),
        hh.Rod(0.2, 0.5, at=-0.3, direction="tangential"): (-0.3, 0.2 * 0.5**2 / 12),
        hh.PointMass(0.15, at=-0.1): (-0.1, 0.0),
        hh.Disk(-0.3, 0.1, at=-0.35): (-0.35, -0.3 * 0.1**2 / 2),
    }
    hoop = hh.Hoop.from_parts(0.5, list(parts))
    mass = sum(part.mass for part in parts)
    centre = sum(part.mass * place for part, (place, _) in parts.items()) / mass
    inertia = sum(own + part.mass * (place - centre) ** 2 for part, (place, own) in parts.items())
    assert hoop.mass == pytest.approx(2.25, rel=1e-14)
    assert hoop.eccentricity == pytest.approx(centre / 0.5, rel=1e-14)
    assert hoop.inertia == pytest.approx(inertia, rel=1e-14)
    assert hoop.gyration_radius == pytest.approx(math.sqrt(inertia / mass), rel=1e-14)
    assert hh.Scenario.from_query(hh.Scenario(hoop=hoop).to_query()).hoop == hoop


def test_the_load_is_no_hole():
    from hophoop.results.poses import load_distance

    ring, hole = hh.Ring(1.0, 0.45, 0.5), hh.PointMass(-0.2, at=-0.4)
    assert load_distance(hh.Hoop.from_parts(0.5, [ring, hole])) == 0.5
    assert load_distance(hh.Hoop.from_parts(0.5, [ring, hole, hh.PointMass(0.1, at=0.3)])) == 0.3


@given(bodies)
def test_bodies_of_parts_obey_the_bound(body):
    hoop = hh.Hoop.from_parts(*body)
    assert 0.0 <= hoop.eccentricity <= 1.0
    assert hoop.eccentricity**2 + hoop.inertia_ratio <= 1.0 + 1e-12


# Friction and starts


def test_rolling_start_has_no_slip_at_all():
    speed, radius = 2.0, 0.95
    assert speed - radius * (speed / radius) != 0.0  # what floating point makes of it
    state = hh.Start.rolling(speed, angle=0.2).state(hh.Hoop(radius=radius))
    assert (state.slip, state.vx, state.omega, state.angle) == (0.0, speed, speed / radius, 0.2)
    free = hh.Start(vx=1.0, omega=3.0, height=0.5, vy=-1.0).state(hh.Hoop(radius=0.1))
    assert free.slip == pytest.approx(0.7)
    assert (free.height, free.vy) == (0.5, -1.0)


def test_numbers_come_out_as_python_floats():
    plane = hh.Plane(gravity=np.float32(1.5), slope=np.array(0.1), restitution=1)
    assert {type(value) for value in (plane.gravity, plane.slope, plane.restitution)} == {float}
    assert type(hh.Rigid(max_events=np.int64(5)).max_events) is int


def test_copies_are_validated():
    assert hh.Hoop.ideal(0.5).model_copy(update={"load_fraction": 0.25}) == hh.Hoop.ideal(0.25)
    assert hh.PointMass(1.0, at=0.5).model_copy(update={"at": -0.5}) == hh.PointMass(1.0, at=-0.5)
    assert "must be from 1e-06 to 1e+06 m" in said(lambda: hh.Hoop().model_copy(update={"radius": 0.0}))
    with pytest.raises(TypeError):
        hh.Hoop().model_copy({"radius": 2.0})


def test_equal_models_are_one_and_pass_between_processes():
    assert len({hh.Scenario(), hh.Scenario(), hh.Scenario(duration=2.0)}) == 2
    assert pickle.loads(pickle.dumps(hh.Scenario())) == hh.Scenario()
    assert repr(hh.Start.rolling(2.0)) == "Start(x=0.0, angle=0.0, speed=2.0)"


# Refusals

PART = '{"hoop": {"parts": [%s]}}'
# texts of files, or queries of links, and what is said
REFUSED = {
    "plane.mu=-1": "plane.mu = -1 must be from 0 to 1e+06, or inf.",
    "plane.mu=nan": "plane.mu = nan must be from 0 to 1e+06, or inf.",
    "plane.mu_kinetic=1.2": "plane.mu_kinetic = 1.2 must not exceed plane.mu_static = 1.0.",
    "plane.mu=1&plane.mu_static=2": "plane.mu_static cannot be given together with plane.mu.",
    "plane.slope=-2": "plane.slope = -2.0 must lie between -pi/2 and pi/2 (radians).",
    f"plane.slope={0.5 * math.pi!r}": f"plane.slope = {0.5 * math.pi!r} must lie between -pi/2 and pi/2 (radians).",
    "plane.slope=1.5705": "plane.slope = 1.5705 must be from -1.57 to 1.57 rad.",
    "plane.gravity=inf": "plane.gravity = inf must be a finite number.",
    "plane.gravity=-9.81": "plane.gravity = -9.81 must be 0 or from 1e-06 to 1e+06 m/s².",
    "plane.gravity=1e-300": "plane.gravity = 1e-300 must be 0 or from 1e-06 to 1e+06 m/s².",
    '{"plane": {"gravity": "9.81"}}': "plane.gravity = '9.81' must be a number.",
    '{"plane": {"gravity": true}}': "plane.gravity = True must be a number.",
    '{"plane": {"gravity": 1%s}}' % (400 * "0"): "must be a finite number.",
    "plane.mu=1e300": "plane.mu = 1e+300 must be from 0 to 1e+06, or inf.",
    "plane.impact_law=hertz": "must be 'stronge', 'newton' or 'poisson'.",
    "plane.frictoin=1": "plane.frictoin is not a known key; did you mean plane.mu?",
    "plane.colour=1": "plane.colour is not a known key; known are gravity, slope, mu,",
    # a label of the lab is no other name of a key
    "start.speed upwards=1": "start.speed upwards is not a known key; known are x, height, angle, ",
    "plane.graviti=1": "plane.graviti is not a known key; did you mean plane.gravity?",
    "plane.gravity=-1&plane.restitution=2": "= -1 must be 0 or from 1e-06 to 1e+06 m/s² (and 1 more problem).",
    "hoop.radius=0": "hoop.radius = 0 must be from 1e-06 to 1e+06 m.",
    "hoop.radius=1e-12": "hoop.radius = 1e-12 must be from 1e-06 to 1e+06 m.",
    "hoop.mass=-1": "hoop.mass = -1 must be from 1e-12 to 1e+12 kg.",
    "hoop.load_fraction=1.01": "hoop.load_fraction = 1.01 must be from 0 to 1.",
    "hoop.eccentricity=0.5": "hoop.inertia_ratio is missing: hoop.eccentricity does not define",
    "hoop.eccentricity=0.5&hoop.inertia_ratio=0": "needs hoop.eccentricity = 1",
    "hoop.load_fraction=0.5&hoop.inertia_ratio=1": "hoop.inertia_ratio cannot be given together with",
    PART % "": "hoop.parts must not be empty.",
    PART % '{"shape": "point_mass", "mass": 1, "at": -1.1}': "hoop.parts.0 (point_mass) reaches 1.1 m",
    PART % '{"shape": "rod", "mass": 1, "length": 1.9, "at": 0.4, "direction": "tangential"}': "beyond the rim",
    '{"hoop": {"mass": 1, "parts": [{"shape": "point_mass", "mass": 1, "at": 1}]}}': "hoop.mass cannot be given together",
    PART % '{"shape": "ring", "mass": 1, "inner_radius": 2, "outer_radius": 1}': "must not exceed ring.outer_radius = 1.0.",
    PART % '{"shape": "disk", "mass": -1, "radius": 0.5}': "hoop.parts give hoop.mass = -1.0, which must be from",
    PART % '{"shape": "disk", "mass": 1, "radius": 0.5}, '
    '{"shape": "ring", "mass": -0.5, "inner_radius": 0.5, "outer_radius": 1}': "hoop.inertia_ratio = -0.375, which must be",
    PART % '{"shape": "ring", "mass": 1, "inner_radius": 1, "outer_radius": 1}, '
    '{"shape": "point_mass", "mass": -0.6, "at": -0.8}': "hoop.eccentricity = 1.2, which must be at most 1.",
    PART % '{"shape": "disk", "mass": 1, "radius": 0}': "radius = 0 must be from 1e-12 to 1e+06 m.",
    "start.height=-0.1": "start.height = -0.1 must be from 0 to 1e+06 m.",
    "start.speed=1&start.omega=2": "start.omega cannot be given together with start.speed.",
    "start.speed=nan": "start.speed = nan must be a finite number.",
    "start.speed=1e10": "start.speed = 10000000000.0 must be from -1e+06 to 1e+06 m/s.",
    "start.vx=1.9e278": "start.vx = 1.9e+278 must be from -1e+06 to 1e+06 m/s.",
    "contact.max_events=0": "contact.max_events = 0 must be from 1 to 1e+07.",
    "contact.max_events=1.5": "contact.max_events = 1.5 must be a whole number.",
    "contact.model=compliant&contact.damping=1&contact.restitution=0.5": "contact.restitution cannot be given together with",
    "contact.model=compliant&contact.rtol=0": "contact.rtol = 0 must be from 1e-10 to 0.1.",
    "duration=0": "duration = 0 must be from 1e-09 to 1e+09 s.",
    "hoop=3": "hoop = 3.0 must be a table of keys.",
    "hoop.load_fraction=1&plane.slope=0.1": "plane.slope = 0.1 must be 0",
    "hoop.load_fraction=1&contact.model=compliant": "must be 'rigid' for the",
    "plane.mu=inf&contact.model=compliant": "inf must be finite",
    "foo=1": "foo is not a known key; known are duration, hoop, plane, start, contact.",
    '{"contact": 3}': "contact = 3 must be a table of keys.",
    "contact.model=soft": "contact.model = 'soft' must be 'rigid' or 'compliant'.",
    '{"contact": {"model": 3}}': "contact.model = '3' must be 'rigid' or 'compliant'.",
    '{"contact": {"model": null}}': "contact.model is missing.",
    "contact.stiffness=3": "contact.stiffness is not a known key; known are model, max_events.",
    "contact.model=compliant&contact.stiffness=-3": "contact.stiffness = -3 must be from 1e-06 to 1e+18 N/m.",
    '{"hoop": {"parts": 3}}': "hoop.parts = 3 must be a list.",
    PART % "3": "hoop.parts.0 = 3 must be a table of keys.",
    PART % '{"mass": 1}': "hoop.parts.0.shape is missing.",
    PART % '{"shape": "cube"}': "hoop.parts.0.shape = 'cube' must be 'ring', 'disk', 'point_mass' or 'rod'.",
    PART % '{"shape": "point_mass", "mass": 1}': "hoop.parts.0.at is missing.",
    PART % '{"shape": "disk", "mass": 0, "radius": 1}': "hoop.parts give hoop.mass = 0",
    '{"start": {"speed": [1]}}': "start.speed = [1] must be a number.",
    "start.speed=fast": "start.speed = 'fast' must be a number.",
    "start.speed=": "start.speed = '' must be a number.",
    "start.speed=1&start.speed=2": "start.speed is given twice.",
    "duration=1&duration.x=2": "duration.x cannot be given together with a value for duration.",
    "duration.x=1&duration=2": "duration is given twice.",
    "hoop.parts.1.shape=ring": "hoop.parts.1 is out of order: parts are numbered from 0 without a gap.",
    "speed=3": "speed is not a known key",
    "&".join(f"a{i}=1" for i in range(1001)): "The query cannot be read: ",
    "&".join(f"a{i}=1" for i in range(1000)): "a0 is not a known key",
    "contact.model=compliant&contact.stiffness=1e-3": "contact.stiffness = 0.001 is 0.000102 m g/R of this hoop",
    "contact.model=compliant&contact.tangential_stiffness=1e17": "contact.tangential_stiffness = 1e+17 is 1.02e+16 m g/R",
    "contact.model=compliant&contact.slip_speed=1e-12": "contact.slip_speed = 1e-12 is 3.19e-13 √(g R)",
    "contact.model=compliant&contact.stiffness=100&start.vx=1&start.omega=1e6": "lets the rim sink some 1e+05 radii into",
    "hoop.load_fraction=0.99999999999999": "hoop.load_fraction = 0.99999999999999 gives hoop.inertia_ratio = ",
    "hoop.load_fraction=1&plane.rolling_resistance=0.1": "plane.rolling_resistance = 0.1 must be 0 for the massless hoop",
    "hoop.eccentricity=0.9&hoop.inertia_ratio=0.01&plane.rolling_resistance=0.9": "must be below 0.298969 for this hoop",
    "hoop.radius=1e-3&start.vx=1e6": "start has a speed of 1.01e+07 √(g R), with R of the hoop, and must have at most",
    "hoop.radius=0.5&start.height=1e7": "start.height = 10000000.0 must be from 0 to 1e+06 m.",
    "hoop.radius=0.5&start.height=1e6": "start.height = 1000000.0 is 2e+06 radii of this hoop and must be at most",
    "contact.model=compliant&contact.stiffness=100&start.height=1e6": "lets the rim sink some 4e+02 radii into the plane",
}


@pytest.mark.parametrize(("text", "expected"), REFUSED.items())
def test_refusals_name_field_value_and_what_is_allowed(text, expected):
    if not text.startswith("{"):
        assert alike(expected) in alike(said(lambda: hh.Scenario.from_query(text)))
        return
    assert alike(expected) in alike(said(lambda: hh.Scenario.loads(text)))
    # The web interface validates through pydantic itself, and turns its error into the same sentence.
    with pytest.raises(ValidationError) as caught:
        hh.Scenario.model_validate(json.loads(text))
    assert alike(expected) in alike(sentence(caught.value))


def test_every_rule_has_a_sentence_and_breaks(monkeypatch):
    broken = []

    def noted(code, *given):
        broken.append(Refusal(code))
        return refused(code, *given)

    for module in (models, scenario):
        monkeypatch.setattr(module, "refused", noted)
    for text in REFUSED:
        said(lambda text=text: (hh.Scenario.loads if text.startswith("{") else hh.Scenario.from_query)(text))
    assert set(broken) == {*RULES} == {rule for rule in Refusal if rule}


@pytest.mark.parametrize(
    ("build", "expected"),
    [
        (lambda: hh.Ring(1, 2, 1), "ring.inner_radius = 2.0 must not exceed ring.outer_radius = 1.0."),
        (lambda: hh.Scenario(plane=hh.Start.rolling(1.0)), "must be a Plane, not Start."),
        (lambda: hh.simulate(hh.Hoop.ideal(0.5), hh.Plane(), hh.Plane()), "must be a Start, not Plane."),
    ],
)
def test_refusals_of_models_are_the_same(build, expected):
    assert alike(expected) in alike(said(build))


NEAR = {
    hh.Plane: {
        "friction": "plane.mu", "Friction": "plane.mu", "static friction": "plane.mu_static", "μ": "plane.mu",
        "g": "plane.gravity", "e": "plane.restitution", "angle": "plane.slope", "slope_deg": "plane.slope",
        "slop": "plane.slope", "beta": "plane.slope", "law": "plane.impact_law",
    },
    hh.Hoop: {
        "gamma": "hoop.load_fraction", "γ": "hoop.load_fraction", "r": "hoop.radius", "R": "hoop.radius", "m": "hoop.mass",
        "kappa": "hoop.inertia_ratio", "friction": "plane.mu",
    },
    hh.Start: {
        "v0": "start.speed", "velocity": "start.speed", "theta": "start.angle", "angle-deg": "start.angle", "mu": "plane.mu",
        "duration": "duration",
    },
    hh.Compliant: {
        "k": "contact.stiffness", "slip speed": "contact.slip_speed",
    },
    hh.Scenario: {
        "mu": "plane.mu", "friction": "plane.mu", "time": "duration", "gamma": "hoop.load_fraction",
        "v0": "start.speed", "durations": "duration",
    },
}  # fmt: skip


@pytest.mark.parametrize(("kind", "word", "meant"), [(kind, *pair) for kind, words in NEAR.items() for pair in words.items()])
def test_a_name_that_people_use_is_understood(kind, word, meant):
    place = {"Scenario": "", "Compliant": "contact."}.get(kind.__name__, f"{kind.__name__.lower()}.")
    assert said(lambda: kind(**{word: 1})) == f"{place}{word} is not a known key; did you mean {meant}?"


@pytest.mark.parametrize(
    ("path", "meant"),
    {
        "plane.friction": "plane.mu",
        "mu": "plane.mu",
        "start.v0": "start.speed",
        "time": "duration",
        "contact.k": "contact.stiffness",
    }.items(),
)
def test_a_path_that_people_use_is_understood(path, meant):
    expected = f"{path} is not a known key; did you mean {meant}?"
    assert said(lambda: hh.scenario.parameter(path)) == expected
    if not path.startswith("contact."):  # its keys depend on the model
        assert said(lambda: hh.Scenario().with_values({path: 1.0})) == expected


def test_values_without_names_are_refused_with_the_names():
    assert said(lambda: hh.Rigid(7)) == "Rigid takes its values by name (model, max_events), not as Rigid(7)."


def test_an_assignment_is_refused_with_what_to_do():
    scenario = hh.Scenario()
    for part, name, expected in (
        (scenario, "duration", "since a Scenario never changes; with_values({'duration': 3}) returns another one."),
        (
            scenario.plane,
            "mu",
            "since a Plane never changes; model_copy(update={'mu': 3}) returns another one.",
        ),
        (scenario.plane, "friction", "plane.friction is not a known key; did you mean plane.mu?"),
        (scenario.hoop, "massless", "hoop.massless = 3 cannot be assigned"),
    ):
        assert expected in said(lambda part=part, name=name: setattr(part, name, 3))
    with pytest.raises(ValueError, match="Instance is frozen"):
        del scenario.duration
    assert scenario == hh.Scenario()


# What the kernels get


def test_the_unit_of_time_without_gravity_is_that_of_1_m_per_s2():
    weightless = hh.Plane(gravity=0.0)
    assert to_body(hh.Hoop(), weightless).gn == 0.0
    assert time_unit(hh.Hoop(radius=4.0), weightless) == 2.0
    assert time_unit(hh.Hoop(radius=2.0), hh.Plane(gravity=1.62)) == pytest.approx(math.sqrt(2.0 / 1.62), rel=1e-15)
