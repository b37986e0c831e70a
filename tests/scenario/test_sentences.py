"""Sentences to the letter: how long a text is shown, what is counted, what a word stands beside."""

import json
import pickle

import numpy as np
import pytest
from pydantic import ValidationError
from pydantic_core import PydanticCustomError

import hophoop as hh
from hophoop._support.errors import shortened
from hophoop.scenario import InputError, parameter, sentence
from hophoop.scenario.formats import MOST_BYTES
from strategies import said


def test_sixty_characters_are_shown_and_the_last_three_of_more_are_dots():
    assert shortened(60 * "k") == 60 * "k"
    assert shortened("k" * 55 + "lmnopq") == "k" * 55 + "lm..."


def test_any_message_shows_sixty_characters_of_a_value_of_thousands():
    name = 2000 * "k l "
    message = str(InputError(f"engine = {name!r} is not one of hophoop, scipy."))
    assert message == f"engine = {shortened(repr(name))} is not one of hophoop, scipy."


def test_a_problem_of_another_kind_is_said_in_its_own_words():
    finding = {"type": PydanticCustomError("other", "IT is so"), "loc": ("start", "x"), "input": 3}
    assert sentence(ValidationError.from_exception_data("Scenario", [finding])) == "start.x = 3: iT is so."


def test_every_finding_stays_with_the_error_without_the_links_of_pydantic():
    with pytest.raises(InputError) as caught:
        hh.Scenario.from_dict({"plane": {"gravity": -1, "slope": "x"}})
    assert [finding["loc"] for finding in caught.value.errors] == [("plane", "gravity"), ("plane", "slope")]
    assert "url" not in caught.value.errors[0]


@pytest.mark.parametrize(
    ("value", "shown"),
    [(np.array([1.0, 2.0]), "array([1., 2.])"), (np.array("x"), "'x'"), (np.array(None), "None"), (np.float32(-0.5), None)],
)
def test_arrays_are_shown_as_they_are_and_scalars_as_numbers(value, shown):
    expected = f"= {shown} must be a number." if shown else "= -0.5 must be from 0 to 1."
    assert said(lambda: hh.Plane(restitution=value)) == f"plane.restitution {expected}"


def test_an_array_in_place_of_a_number_is_shown():
    refused = "plane.mu = array([1., 2.]) must be a number."
    assert said(lambda: hh.Scenario().replace("plane.mu", np.array([1.0, 2.0]))) == refused
    assert hh.Scenario().replace("plane.impact_law", np.str_("newton")).plane.impact_law == "newton"


def test_what_is_no_table_is_shown_up_to_forty_characters():
    for length, shown in ((40, f'"{38 * "x"}"'), (41, "a text or number")):
        text = json.dumps((length - 2) * "x")
        assert said(lambda text=text: hh.Scenario.loads(text, "json")) == f"the text must hold a table of keys, not {shown}."


def test_a_file_may_have_a_million_bytes(tmp_path):
    assert MOST_BYTES == 1_000_000
    path = tmp_path / "long.toml"
    path.write_bytes(b"duration = 2.0".ljust(MOST_BYTES))
    assert hh.Scenario.load(path).duration == 2.0


def test_only_parts_have_four_steps():
    for path in ("a.b.0.mass", "hoop.ports.0.mass", "hoop.parts.first.mass", "plane.mu.0.mass", "parts.0"):
        expected = f"{path} is not a parameter of a scenario; known are duration, "
        assert said(lambda path=path: parameter(path)).startswith(expected)


def test_the_schema_says_what_is_taken_where_nothing_is_given():
    for usual in (hh.Hoop(), hh.Plane(), hh.Start(), hh.Rigid(), hh.Compliant(), hh.Disk(1.0, 0.1), hh.Rod(1.0, 0.1)):
        for name, field in type(usual).model_fields.items():
            if field.default is not None and not field.is_required():
                assert getattr(usual, name) == field.default, name


# The error


def parts(error):
    return error.field, error.value, error.allowed


def test_a_field_makes_the_sentence():
    error = InputError.of_field("chunk_cells", np.int64(0), "at least 1")
    assert str(error) == "chunk_cells = 0 must be at least 1."
    assert parts(error) == ("chunk_cells", 0, "at least 1")
    other = InputError.of_field("out", "a.csv", ".zarr or .nc", rule="must end in")
    assert str(other) == "out = 'a.csv' must end in .zarr or .nc."


def test_another_name_replaces_that_of_the_field_alone():
    error = InputError.of_field("theme", "a theme = b", "light or dark").renamed("--theme")
    assert str(error) == "--theme = 'a theme = b' must be light or dark."
    assert parts(error) == ("--theme", "a theme = b", "light or dark")


def test_it_passes_between_processes():
    error = pickle.loads(pickle.dumps(InputError.of_field("n", 1, "at least 2")))
    assert str(error) == "n = 1 must be at least 2."
    assert parts(error) == ("n", 1, "at least 2")


@pytest.mark.parametrize(
    ("keys", "found"),
    [
        ({"plane": {"gravity": -1.0}}, ("plane.gravity", -1.0, "0 or from 1e-06 to 1e+06 m/s²")),
        ({"contact": {"model": "soft"}}, ("contact.model", "soft", "'rigid' or 'compliant'")),
        ({"hoop": {"shape": 1}}, ("hoop.shape", None, None)),
    ],
)
def test_a_scenario_names_the_path(keys, found):
    with pytest.raises(InputError) as caught:
        hh.Scenario.from_dict(keys)
    assert parts(caught.value) == found


def test_functions_name_their_argument():
    motion = hh.simulate(hh.Scenario(duration=0.5))
    for field, call in {
        "t": lambda: motion.at(99.0),
        "of": lambda: motion.sensitivity("hop.weight", "plane.mu"),
        "plane.colour": lambda: motion.scenario.replace("plane.colour", 1),
        "color": lambda: hh.plots.strobe(motion, color="red"),
    }.items():
        with pytest.raises(InputError) as caught:
            call()
        assert caught.value.field == field
