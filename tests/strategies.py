"""Hoops and scenarios for hypothesis, and the sentence of a refusal."""

import math

import pytest
from hypothesis import strategies as st

import hophoop as hh
from hophoop.scenario import sentence


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
    contact = draw(st.sampled_from([hh.Rigid(), hh.Rigid(max_events=7), hh.Compliant(law="hunt-crossley", rtol=1e-6)]))
    if hoop.massless or plane.mu_static == math.inf:
        contact = hh.Rigid()
    return hh.Scenario(hoop=hoop, plane=plane, start=start, duration=draw(positive), contact=contact)


# Ideal ones of any size, and other bodies.
hoops = st.builds(
    lambda gamma, radius, mass: hh.Hoop.ideal(gamma, radius=radius, mass=mass),
    st.floats(0.02, 0.98),
    st.floats(0.1, 5.0),
    st.floats(0.1, 5.0),
) | st.builds(lambda eps, kap: hh.Hoop(eccentricity=eps, inertia_ratio=kap), st.floats(0.02, 1.0), st.floats(0.02, 2.0))
