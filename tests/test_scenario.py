"""Scenarios: what they accept, what they say when they do not, and their files and links."""

import json
import math
import pickle
import tomllib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

import hophoop as hh
from hophoop.scenario import InputError, parameter, paths, sentence, time_unit, to_body


def said(build):
    """The sentence with which `build` refuses."""
    with pytest.raises(ValueError) as caught:
        build()
    text = str(caught.value)
    assert text == sentence(caught.value)
    assert text.endswith((".", "?"))
    assert "\n" not in text
    return text


# What a hoop is


def test_reference_case():
    scenario = hh.Scenario()
    assert scenario.hoop == hh.Hoop.ideal(load_fraction=0.75, radius=1.0, mass=1.0)
    assert scenario.plane == hh.Plane(gravity=9.81, slope=0.0, mu=1.0, restitution=0.0)
    assert scenario.start == hh.Start.rolling(3.1)
    assert (scenario.duration, scenario.contact) == (6.0, hh.Rigid())
    assert (scenario.hoop.eccentricity, scenario.hoop.inertia_ratio) == (0.75, 0.4375)


@pytest.mark.parametrize("power", [1, 6, 12])
def test_ideal_hoop_keeps_its_digits_near_the_massless_one(power):
    gamma = 1.0 - 10.0**-power
    exact = (1 - gamma) * (1 + gamma)  # 1 − γ is exact in floating point here
    assert hh.Hoop.ideal(gamma).inertia_ratio == pytest.approx(exact, rel=4e-16)
    assert not hh.Hoop.ideal(gamma).massless


def test_massless_hoop():
    hoop = hh.Hoop.ideal(load_fraction=1.0)
    assert (hoop.eccentricity, hoop.inertia_ratio, hoop.massless) == (1.0, 0.0, True)
    assert hh.Hoop.from_parts(0.3, [hh.PointMass(0.7, at=0.3)]).massless
    assert hh.Hoop.from_parts(0.3, [hh.PointMass(0.1, at=-0.3), hh.PointMass(0.2, at=-0.3)]).massless


def test_an_ideal_hoop_from_its_parts():
    hoop = hh.Hoop.from_parts(0.4, [hh.Ring(0.5, 0.4, 0.4), hh.PointMass(1.5, at=0.4)])
    ideal = hh.Hoop.ideal(load_fraction=0.75, radius=0.4, mass=2.0)
    assert hoop.mass == ideal.mass
    assert hoop.eccentricity == pytest.approx(ideal.eccentricity, rel=1e-15)
    assert hoop.inertia_ratio == pytest.approx(ideal.inertia_ratio, rel=1e-15)


def mass_points(part, count=400):
    """Point masses spread over a part: (mass, along, across) in its own plane."""
    if isinstance(part, hh.PointMass):
        return [(part.mass, part.at, 0.0)]
    if isinstance(part, hh.Rod):
        along = (np.arange(count) + 0.5) / count - 0.5
        place = part.length * along
        zero = np.zeros(count)
        pair = (part.at + place, zero) if part.direction == "radial" else (part.at + zero, place)
        return [(part.mass / count, x, y) for x, y in zip(*pair, strict=True)]
    inner, outer = (part.inner_radius, part.outer_radius) if isinstance(part, hh.Ring) else (0.0, part.radius)
    angles = 2 * np.pi * np.arange(8) / 8
    share = (np.arange(count) + 0.5) / count
    radii = np.sqrt(inner**2 + share * (outer**2 - inner**2))  # equal areas
    return [
        (part.mass / (count * 8), part.at + r * math.cos(a), r * math.sin(a)) for r in radii for a in angles
    ]


def test_parts_against_a_sum_over_mass_points():
    parts = [
        hh.Ring(0.8, 0.45, 0.5),
        hh.Disk(1.1, 0.06, at=0.43),
        hh.Rod(0.3, 0.4, at=0.25),
        hh.Rod(0.2, 0.5, at=-0.3, direction="tangential"),
        hh.PointMass(0.15, at=-0.1),
    ]
    hoop = hh.Hoop.from_parts(0.5, parts)
    mass, along, across = np.array([point for part in parts for point in mass_points(part)]).T
    centre = np.sum(mass * along) / np.sum(mass)
    inertia = np.sum(mass * ((along - centre) ** 2 + across**2))
    assert hoop.mass == pytest.approx(np.sum(mass), rel=1e-12)
    assert hoop.eccentricity == pytest.approx(centre / 0.5, rel=1e-9)
    # Midpoints of rods and of equal areas leave an error of order 1 / count².
    assert hoop.inertia == pytest.approx(inertia, rel=1e-5)
    assert hoop.gyration_radius == pytest.approx(math.sqrt(inertia / np.sum(mass)), rel=1e-5)


@st.composite
def bodies(draw):
    """A radius and parts that lie within it."""
    radius = draw(st.floats(0.01, 10.0))
    share = st.floats(0.0, 1.0)
    mass = st.floats(1e-3, 1e3)

    def part():
        kind = draw(st.sampled_from(["ring", "disk", "point_mass", "rod"]))
        size, place, sign = draw(share), draw(share), draw(st.sampled_from([-1, 1]))
        size = max(size, 1e-3)
        at = sign * place * radius
        if kind == "ring":
            return hh.Ring(draw(mass), place * size * radius, size * radius)
        if kind == "disk":
            return hh.Disk(draw(mass), size * radius, at=at * (1 - size))
        if kind == "rod":
            return hh.Rod(draw(mass), 2 * size * radius, at=at * (1 - size))
        return hh.PointMass(draw(mass), at=at)

    # The ring keeps clear of the bodies of a single point inside the rim, which have no inertia.
    parts = [hh.Ring(draw(mass), 0.9 * radius, radius), *(part() for _ in range(draw(st.integers(0, 4))))]
    return radius, parts


@given(bodies())
def test_bodies_of_parts_obey_the_bound(body):
    radius, parts = body
    hoop = hh.Hoop.from_parts(radius, parts)
    assert 0.0 <= hoop.eccentricity <= 1.0
    assert hoop.eccentricity**2 + hoop.inertia_ratio <= 1.0 + 1e-12
    turned = hh.Hoop.from_parts(
        radius, [part.model_copy(update={"at": -part.at}) if part.shape != "ring" else part for part in parts]
    )
    assert (turned.eccentricity, turned.inertia_ratio) == (hoop.eccentricity, hoop.inertia_ratio)


# Friction and starts


def test_friction_given_once_or_apart():
    assert hh.Plane(mu=0.4) == hh.Plane(mu_static=0.4, mu_kinetic=0.4)
    apart = hh.Plane(mu_static=0.5, mu_kinetic=0.4)
    assert (apart.mu, apart.mu_static, apart.mu_kinetic) == (None, 0.5, 0.4)
    assert hh.Plane(mu=math.inf).mu_static == math.inf


def test_rolling_start_has_no_slip_at_all():
    speed, radius = 2.0, 0.95
    assert speed - radius * (speed / radius) != 0.0  # what floating point makes of it
    state = hh.Start.rolling(speed, angle=0.2).state(hh.Hoop(radius=radius))
    assert (state.slip, state.vx, state.omega, state.angle) == (0.0, speed, speed / radius, 0.2)
    hoop = hh.Hoop(radius=0.1)
    free = hh.Start(vx=1.0, omega=3.0, height=0.5, vy=-1.0).state(hoop)
    assert free.slip == pytest.approx(0.7)
    assert (free.height, free.vy) == (0.5, -1.0)
    assert hh.Start().state(hoop) == (0.0,) * 7


def test_numbers_come_out_as_python_floats():
    plane = hh.Plane(gravity=np.float32(1.5), mu=np.float64(0.3), slope=np.array(0.1), restitution=1)
    assert {type(value) for value in (plane.gravity, plane.mu_static, plane.slope, plane.restitution)} == {
        float
    }
    assert type(hh.Rigid(max_events=np.int64(5)).max_events) is int


def test_copies_are_validated():
    assert hh.Hoop.ideal(0.5).model_copy(update={"load_fraction": 0.25}) == hh.Hoop.ideal(0.25)
    assert hh.Scenario().model_copy(update={"duration": 1.0}) == hh.Scenario(duration=1.0)
    assert hh.PointMass(1.0, at=0.5).model_copy(update={"at": -0.5}) == hh.PointMass(1.0, at=-0.5)
    assert "must be greater than 0" in said(lambda: hh.Hoop().model_copy(update={"radius": 0.0}))


def test_models_never_change():
    with pytest.raises(ValidationError):
        hh.Plane().gravity = 1.0
    assert len({hh.Scenario(), hh.Scenario(), hh.Scenario(duration=2.0)}) == 2
    assert pickle.loads(pickle.dumps(hh.Scenario())) == hh.Scenario()


# Refusals

REFUSED = [
    (lambda: hh.Plane(mu=-1), "plane.mu = -1 must be at least 0 (inf is allowed)."),
    (lambda: hh.Plane(mu=math.nan), "plane.mu = nan must be at least 0 (inf is allowed)."),
    (lambda: hh.Plane(mu_kinetic=1.2), "plane.mu_kinetic = 1.2 must not exceed plane.mu_static = 1.0."),
    (lambda: hh.Plane(mu=1, mu_static=2), "plane.mu_static cannot be given together with plane.mu."),
    (lambda: hh.Plane(slope=-2), "plane.slope = -2.0 must lie between -pi/2 and pi/2 (radians)."),
    (lambda: hh.Plane(gravity=math.inf), "plane.gravity = inf must be a finite number."),
    (lambda: hh.Plane(gravity=-9.81), "plane.gravity = -9.81 must be at least 0."),
    (lambda: hh.Plane(gravity="9.81"), "plane.gravity = '9.81' must be a number."),
    (lambda: hh.Plane(gravity=True), "plane.gravity = True must be a number."),
    (lambda: hh.Plane(gravity=10**400), "must be a number."),
    (lambda: hh.Plane(restitution=np.float64(1.5)), "plane.restitution = 1.5 must be at most 1."),
    (lambda: hh.Plane(impact_law="hertz"), "must be 'stronge', 'newton' or 'poisson'."),
    (lambda: hh.Plane(frictoin=1), "plane.frictoin is not a known key; known are gravity, slope, mu,"),
    (lambda: hh.Plane(graviti=1), "plane.graviti is not a known key; did you mean gravity?"),
    (lambda: hh.Plane(gravity=-1, restitution=2), "= -1 must be at least 0 (and 1 more problem)."),
    (lambda: hh.Hoop(radius=0), "hoop.radius = 0 must be greater than 0."),
    (lambda: hh.Hoop(mass=-1), "hoop.mass = -1 must be greater than 0."),
    (lambda: hh.Hoop.ideal(load_fraction=1.01), "hoop.load_fraction = 1.01 must be at most 1."),
    (lambda: hh.Hoop(eccentricity=0.5), "hoop.inertia_ratio is missing: hoop.eccentricity does not define"),
    (lambda: hh.Hoop(eccentricity=0.5, inertia_ratio=0), "needs hoop.eccentricity = 1"),
    (lambda: hh.Hoop(load_fraction=0.5, inertia_ratio=1), "hoop.inertia_ratio cannot be given together with"),
    (lambda: hh.Hoop.from_parts(1, []), "hoop.parts must not be empty."),
    (lambda: hh.Hoop.from_parts(1, [hh.PointMass(1, at=-1.1)]), "hoop.parts.0 (point_mass) reaches 1.1 m"),
    (lambda: hh.Hoop.from_parts(1, [hh.Rod(1, 1.9, at=0.4, direction="tangential")]), "beyond the rim"),
    (lambda: hh.Hoop(mass=1, parts=[hh.PointMass(1, at=1)]), "hoop.mass cannot be given together with"),
    (lambda: hh.Ring(1, 2, 1), "ring.inner_radius = 2.0 must not exceed ring.outer_radius = 1.0."),
    (lambda: hh.Disk(1, 0), "disk.radius = 0 must be greater than 0."),
    (lambda: hh.Start(height=-0.1), "start.height = -0.1 must be at least 0."),
    (lambda: hh.Start(speed=1, omega=2), "start.omega cannot be given together with start.speed."),
    (lambda: hh.Start.rolling(math.nan), "start.speed = nan must be a finite number."),
    (lambda: hh.Rigid(max_events=0), "contact.max_events = 0 must be at least 1."),
    (lambda: hh.Rigid(max_events=1.5), "contact.max_events = 1.5 must be a whole number."),
    (lambda: hh.Compliant(damping=1, restitution=0.5), "contact.restitution cannot be given together with"),
    (lambda: hh.Compliant(rtol=0), "contact.rtol = 0 must be greater than 0."),
    (lambda: hh.Scenario(duration=0), "duration = 0 must be greater than 0."),
    (lambda: hh.Scenario(hoop=3), "hoop = 3 must be a table of keys."),
    (lambda: hh.Scenario(hoop=hh.Hoop.ideal(1), plane=hh.Plane(slope=0.1)), "plane.slope = 0.1 must be 0"),
    (lambda: hh.Scenario(hoop=hh.Hoop.ideal(1), contact=hh.Compliant()), "must be 'rigid' for the"),
    (lambda: hh.Scenario(plane=hh.Plane(mu=math.inf), contact=hh.Compliant()), "inf must be finite"),
]  # fmt: skip


@pytest.mark.parametrize(("build", "expected"), REFUSED)
def test_refusals_name_field_value_and_what_is_allowed(build, expected):
    assert expected in said(build)


REFUSED_KEYS = [
    ({"foo": 1}, "foo is not a known key; known are duration, hoop, plane, start, contact."),
    ({"contact": 3}, "contact = 3 must be a table of keys."),
    ({"contact": {"model": "soft"}}, "contact.model = 'soft' must be 'rigid' or 'compliant'."),
    ({"contact": {"stiffness": 3}}, "contact.stiffness is not a known key; known are model, max_events."),
    ({"contact": {"model": "compliant", "stiffness": -3}}, "contact.stiffness = -3 must be greater than 0."),
    ({"hoop": {"parts": 3}}, "hoop.parts = 3 must be a list."),
    ({"hoop": {"parts": [3]}}, "hoop.parts.0 = 3 must be a table of keys."),
    ({"hoop": {"parts": [{"mass": 1}]}}, "hoop.parts.0.shape is missing."),
    ({"hoop": {"parts": [{"shape": "cube"}]}}, "hoop.parts.0.shape = 'cube' must be 'ring',"),
    ({"hoop": {"parts": [{"shape": "point_mass", "mass": 1}]}}, "hoop.parts.0.at is missing."),
    ({"hoop": {"parts": [{"shape": "disk", "mass": 0, "radius": 1}]}}, "hoop.parts.0.mass = 0 must be"),
    ({"start": {"speed": [1]}}, "start.speed = [1] must be a number."),
]  # fmt: skip


@pytest.mark.parametrize(("keys", "expected"), REFUSED_KEYS)
def test_refusals_of_files(keys, expected):
    assert expected in said(lambda: hh.Scenario.from_dict(keys))
    assert expected in said(lambda: hh.Scenario.loads(json.dumps(keys)))
    # The web interface validates through pydantic itself, and turns its error into the same sentence.
    with pytest.raises(ValidationError) as caught:
        hh.Scenario.model_validate(keys)
    assert expected in sentence(caught.value)


def test_every_finding_stays_with_the_error():
    with pytest.raises(InputError) as caught:
        hh.Scenario.from_dict({"plane": {"gravity": -1, "slope": "x"}})
    assert [finding["loc"] for finding in caught.value.errors] == [("plane", "gravity"), ("plane", "slope")]


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


# Files and links

finite = st.floats(allow_nan=False, allow_infinity=False)
positive = st.floats(1e-300, 1e300)
unit = st.floats(0.0, 1.0)


@st.composite
def scenarios(draw):
    radius, parts = draw(bodies())
    hoop = draw(
        st.sampled_from(
            [
                hh.Hoop.ideal(draw(unit), draw(positive), draw(positive)),
                hh.Hoop(radius=radius, mass=2.0, eccentricity=draw(unit), inertia_ratio=draw(positive)),
                hh.Hoop.from_parts(radius, parts),
            ]
        )
    )
    friction = draw(st.floats(0.0, allow_infinity=True, allow_nan=False))
    ratio = draw(unit)
    plane = draw(
        st.sampled_from(
            [
                hh.Plane(mu=friction, gravity=draw(st.floats(0.0, 1e300)), restitution=draw(unit)),
                hh.Plane(mu_static=friction, mu_kinetic=min(ratio * 1e300, friction), painleve="impact"),
                hh.Plane(impact_law=draw(st.sampled_from(["stronge", "newton", "poisson"]))),
            ]
        )
    )
    start = draw(
        st.sampled_from(
            [
                hh.Start.rolling(draw(finite), angle=draw(finite)),
                hh.Start(x=draw(finite), height=abs(draw(finite)), vy=draw(finite), omega=draw(finite)),
                hh.Start(),
            ]
        )
    )
    contact = draw(
        st.sampled_from([hh.Rigid(), hh.Rigid(max_events=7), hh.Compliant(law="hunt-crossley", rtol=1e-6)])
    )
    if hoop.massless or plane.mu_static == math.inf:
        contact = hh.Rigid()
    return hh.Scenario(hoop=hoop, plane=plane, start=start, duration=draw(positive), contact=contact)


@given(scenarios())
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
    assert hh.Scenario(duration=1e22).to_query() == "duration=1e22"


@pytest.mark.parametrize(
    ("query", "expected"),
    [
        ("start.speed=fast", "start.speed = 'fast' must be a number."),
        ("start.speed=", "start.speed = '' must be a number."),
        ("start.speed=1&start.speed=2", "start.speed is given twice."),
        ("duration=1&duration.x=2", "duration.x cannot stand beside a value for duration."),
        ("duration.x=1&duration=2", "duration is given twice."),
        ("hoop.parts.1.shape=ring", "hoop.parts.1 is out of order: parts are numbered from 0 without a gap."),
        ("plane.mu=nan", "plane.mu = nan must be at least 0 (inf is allowed)."),
        ("speed=3", "speed is not a known key"),
        ("&".join(f"a{i}=1" for i in range(2000)), "The query cannot be read: "),
    ],
)
def test_refusals_of_links(query, expected):
    assert expected in said(lambda: hh.Scenario.from_query(query))


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


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("plane.mux", "plane.mux is not a known key; did you mean mu?"),
        ("wall.mu", "wall is not a known key; known are"),
        ("wall", "wall is not a known key; known are"),
        ("duration.long", "duration.long is not a parameter of a scenario"),
        ("hoop.parts.0.mass", "hoop.parts.0.mass is not there to be replaced"),
        ("plane.mu.static", "plane.mu.static is not there to be replaced"),
        ("start.height", "start.height = -1.0 must be at least 0."),
    ],
)
def test_refusals_of_replacements(path, expected):
    assert expected in said(lambda: hh.Scenario().replace(path, -1.0))


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


# What the kernels get


def test_body_and_unit_of_time():
    plane = hh.Plane(
        gravity=1.62, slope=0.3, mu_static=0.7, mu_kinetic=0.6, restitution=0.2, impact_law="poisson"
    )
    body = to_body(hh.Hoop.ideal(0.5, radius=2.0), plane)
    assert (body.eps, body.kap, body.mu_s, body.mu_k, body.rest) == (0.5, 0.75, 0.7, 0.6, 0.2)
    assert (body.gn, body.gt) == (math.cos(0.3), math.sin(0.3))
    assert (body.law, body.strike) == (1, False)
    assert time_unit(hh.Hoop(radius=2.0), plane) == pytest.approx(math.sqrt(2.0 / 1.62), rel=1e-15)
    weightless = hh.Scenario(plane=hh.Plane(gravity=0.0, painleve="impact"))
    assert (weightless.to_body().gn, weightless.to_body().strike) == (0.0, True)
    assert time_unit(hh.Hoop(radius=4.0), weightless.plane) == 2.0
