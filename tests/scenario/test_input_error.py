"""The one error for bad input: its sentence, and the field, the value and what is allowed."""

import pickle

import numpy as np
import pytest

import hophoop as hh
from hophoop.scenario import InputError


def motion():
    return hh.simulate(hh.Scenario(duration=0.5))


def parts(error):
    return error.field, error.value, error.allowed


def test_a_field_makes_the_sentence():
    error = InputError.of_field("chunk_cells", np.int64(0), "at least 1")
    assert str(error) == "chunk_cells = 0 must be at least 1."
    assert parts(error) == ("chunk_cells", 0, "at least 1")
    other = InputError.of_field("out", "a.csv", ".zarr or .nc", rule="must end in")
    assert str(other) == "out = 'a.csv' must end in .zarr or .nc."


def test_a_sentence_about_no_single_field_has_none():
    assert parts(InputError("axes must name at least two parameters.")) == (None, None, None)


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
        ({"plane": {"impact_law": "none"}}, ("plane.impact_law", "none", "'stronge', 'newton' or 'poisson'")),
        ({"contact": {"model": "soft"}}, ("contact.model", "soft", "'rigid' or 'compliant'")),
        ({"hoop": {"shape": 1}}, ("hoop.shape", None, None)),
    ],
)
def test_a_scenario_names_the_path(keys, found):
    with pytest.raises(InputError) as caught:
        hh.Scenario.from_dict(keys)
    assert parts(caught.value) == found


@pytest.mark.parametrize(
    ("call", "field"),
    [
        (lambda: motion().times(1), "n"),
        (lambda: motion().at(99.0), "t"),
        (lambda: motion().find("hop"), "kind"),
        (lambda: motion().sensitivity("hop.weight", "plane.mu"), "of"),
        (lambda: hh.Scenario().replace("plane.colour", 1), "plane.colour"),
        (lambda: hh.plots.strobe(motion(), color="red"), "color"),
        (lambda: hh.animate.Timing(fps=-1.0), "fps"),
    ],
)
def test_functions_name_their_argument(call, field):
    with pytest.raises(InputError) as caught:
        call()
    assert caught.value.field == field
