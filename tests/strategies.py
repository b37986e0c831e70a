"""Hoops and scenarios for hypothesis, and the sentence of a refusal."""

import pytest
from hypothesis import reject
from hypothesis import strategies as st

import hophoop as hh
from fuzz import draws
from hophoop.scenario import sentence

RANDOMS = st.randoms(use_true_random=False)


def said(build):
    """The sentence with which `build` refuses."""
    with pytest.raises(ValueError) as caught:
        build()
    text = str(caught.value)
    assert text == sentence(caught.value)
    assert text.endswith((".", "?"))
    assert "\n" not in text
    return text


def body(random):
    """A radius and parts that lie within it."""
    radius = random.uniform(0.01, 10.0)
    hoop = hh.Scenario.from_dict({"hoop": {"radius": radius, "parts": draws.parts(random, radius)}}).hoop
    return radius, list(hoop.parts)


def allowed_scenario(random):
    """One that is allowed; some have a hoop of parts."""
    try:
        scenario = hh.Scenario.from_dict(draws.scenario(random))
        return scenario.replace("hoop", hh.Hoop.from_parts(*body(random))) if random.choice([True, False]) else scenario
    except ValueError:
        reject()


bodies = RANDOMS.map(body)
scenarios = RANDOMS.map(allowed_scenario)

# Ideal ones of any size, and other bodies.
hoops = st.builds(
    lambda gamma, radius, mass: hh.Hoop.ideal(gamma, radius=radius, mass=mass),
    st.floats(0.02, 0.98),
    st.floats(0.1, 5.0),
    st.floats(0.1, 5.0),
) | st.builds(lambda eps, kap: hh.Hoop(eccentricity=eps, inertia_ratio=kap), st.floats(0.02, 1.0), st.floats(0.02, 2.0))
