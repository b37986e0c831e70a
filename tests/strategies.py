"""Hoops and scenarios for hypothesis, and the sentence of a refusal."""

import math

import pytest
from hypothesis import strategies as st

import hophoop as hh
from hophoop.kernel.physics.body import MOST_HEIGHT, MOST_SPEED
from hophoop.scenario import sentence
from hophoop.vocabulary.names import LAW_CODES
from hophoop.vocabulary.parameters import RANGES


def said(build):
    """The sentence with which `build` refuses."""
    with pytest.raises(ValueError) as caught:
        build()
    text = str(caught.value)
    assert text == sentence(caught.value)
    assert text.endswith((".", "?"))
    assert "\n" not in text
    return text


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


unit = st.floats(0.0, 1.0)
fractions = st.floats(0.0, 0.999999) | st.just(1.0)  # a ring lighter than that has a range of its own


def ranged(name):
    """Any number that a scenario may have there, its single values included."""
    allowed = RANGES[name]
    return st.one_of(st.floats(allowed.least, allowed.most), *(st.just(value) for value in allowed.also))


@st.composite
def scenarios(draw):
    radius, parts = draw(bodies())
    hoop = draw(
        st.sampled_from(
            [
                hh.Hoop.ideal(draw(fractions), draw(ranged("hoop.radius")), draw(ranged("hoop.mass"))),
                hh.Hoop(radius=radius, mass=2.0, eccentricity=draw(unit), inertia_ratio=draw(st.floats(1e-12, 1e6))),
                hh.Hoop.from_parts(radius, parts),
            ]
        )
    )
    friction = draw(ranged("plane.mu"))
    ratio = draw(unit)
    plane = draw(
        st.sampled_from(
            [
                hh.Plane(mu=friction, gravity=draw(ranged("plane.gravity")), restitution=draw(unit)),
                hh.Plane(mu_static=friction, mu_kinetic=min(ratio * 1e6, friction), painleve="impact"),
                hh.Plane(impact_law=draw(st.sampled_from(list(LAW_CODES)))),
            ]
        )
    )
    fastest = min(0.9 * MOST_SPEED * math.sqrt(hoop.radius * (plane.gravity or 1.0)), RANGES["start.speed"].most)
    speed = st.floats(-fastest, fastest)
    start = draw(
        st.sampled_from(
            [
                hh.Start.rolling(draw(speed), angle=draw(ranged("start.angle"))),
                hh.Start(
                    x=draw(ranged("start.x")),
                    height=draw(st.floats(0.0, min(MOST_HEIGHT * hoop.radius, RANGES["start.height"].most))),
                    vy=draw(speed),
                    omega=draw(speed) / max(hoop.radius, 1.0),
                ),
                hh.Start(),
            ]
        )
    )
    contact = draw(st.sampled_from([hh.Rigid(), hh.Rigid(max_events=7), hh.Compliant(law="hunt-crossley", rtol=1e-6)]))
    if hoop.massless or plane.mu_static == math.inf:
        contact = hh.Rigid()
    parts = {"hoop": hoop, "plane": plane, "start": start, "duration": draw(ranged("duration"))}
    try:
        return hh.Scenario(**parts, contact=contact)
    except ValueError:  # a spring that sinks too deep at this speed
        return hh.Scenario(**parts)


# Ideal ones of any size, and other bodies.
hoops = st.builds(
    lambda gamma, radius, mass: hh.Hoop.ideal(gamma, radius=radius, mass=mass),
    st.floats(0.02, 0.98),
    st.floats(0.1, 5.0),
    st.floats(0.1, 5.0),
) | st.builds(lambda eps, kap: hh.Hoop(eccentricity=eps, inertia_ratio=kap), st.floats(0.02, 1.0), st.floats(0.02, 2.0))
