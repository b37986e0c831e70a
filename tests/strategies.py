"""Hoops and scenarios for hypothesis, and the sentence of a refusal."""

import pytest
from hypothesis import reject
from hypothesis import strategies as st

import hophoop as hh
from fuzz import draws
from fuzz.draws import USUAL
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


class Drawn:
    """A source of numbers for `fuzz.draws` that hypothesis chooses."""

    kinds = USUAL

    def __init__(self, draw):
        self._draw = draw

    def between(self, least, most):
        return float(self._draw(st.floats(least, most)))

    def choice(self, values):
        return values[self._draw(st.integers(0, len(values) - 1))]


@st.composite
def scenarios(draw):
    """Those that are allowed; some have a hoop of parts."""
    try:
        scenario = hh.Scenario.from_dict(draws.scenario(Drawn(draw)))
        if draw(st.booleans()):
            scenario = scenario.replace("hoop", hh.Hoop.from_parts(*draw(bodies())))
    except ValueError:
        reject()
    return scenario


# Ideal ones of any size, and other bodies.
hoops = st.builds(
    lambda gamma, radius, mass: hh.Hoop.ideal(gamma, radius=radius, mass=mass),
    st.floats(0.02, 0.98),
    st.floats(0.1, 5.0),
    st.floats(0.1, 5.0),
) | st.builds(lambda eps, kap: hh.Hoop(eccentricity=eps, inertia_ratio=kap), st.floats(0.02, 1.0), st.floats(0.02, 2.0))
