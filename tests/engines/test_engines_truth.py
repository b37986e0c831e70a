"""The truth of the benchmark: its file, its schema, and two solutions that were not used to make it."""

import hashlib
import itertools
import json
import math

import numpy as np
import pytest
import truth
from adapters.hophoop import run, scenario_of
from make_truth import digits_of_oracle
from phases import phases
from truth import scored, truths

import hophoop as hh


@pytest.fixture(scope="module")
def document():
    return truth.read_document()


def test_the_file_keeps_to_its_schema(document):
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads(truth.DATA.with_suffix(".schema.json").read_text(encoding="utf-8"))
    validator = jsonschema.Draft202012Validator(schema)
    validator.check_schema(schema)
    validator.validate(document)
    assert not validator.is_valid(document | {"license": "MIT"})


def test_a_changed_file_is_noticed(monkeypatch):
    monkeypatch.setattr(truth.hashlib, "sha256", hashlib.md5)
    with pytest.raises(ValueError, match="does not match its checksum"):
        truth.read_document()


SOON = {"painleve": (), "hop": pytest.mark.long, "border": pytest.mark.long, "drop": pytest.mark.long}


@pytest.mark.parametrize("name", [pytest.param(name, marks=SOON.get(name, pytest.mark.slow)) for name in truths()])
def test_the_truth_is_that_of_the_oracle(document, name):
    """Solved once more by the oracle, which shares no formula with hophoop."""
    assert min(digits_of_oracle(document["scenarios"][name])) >= 29


@pytest.mark.parametrize("name", truths())
def test_states_are_those_of_the_kernel(name):
    motion, right = hh.simulate(scenario_of(truths()[name].task)), truths()[name].states
    sample = motion.at(right.t)
    for column, mine in zip(
        right[1:], (sample.x, sample.height, sample.angle, sample.vx, sample.vy, sample.omega), strict=True
    ):
        np.testing.assert_allclose(mine, column, rtol=0, atol=1e-11)


@pytest.mark.parametrize("name", scored())
def test_the_rule_finds_the_phases_of_the_exact_motion(name):
    """Phases of at least 20 ms, from the exact events, are those that the rule finds in samples."""
    right = truths()[name]
    found, _ = phases(right.task, run(right.task, 0.0))
    marks = [event for event in right.entry["events"] if event["kind"] not in ("turn", "apex", "kane_gain", "rest")]
    longer = []
    for event, following in itertools.pairwise(marks):
        begin, end = float(event["t"]), float(following["t"])
        if end - begin >= 0.02 and not (longer and longer[-1][0] == event["to"]):
            longer.append((event["to"], begin))
    # slip is told from rolling by 1 cm/s, which it reaches some milliseconds after it begins; flight by N
    assert [(phase.letter, phase.begin) for phase in found] == [
        (letter, pytest.approx(begin, abs=0.04)) for letter, begin in longer
    ]
    assert "".join(letter for letter, _ in longer) == right.measures.sequence


def test_the_task_is_the_start_seen_from_the_centre_of_gravity():
    task = truths()["drop"].task
    start = [0.0, task.x, task.height, task.angle, task.vx, task.vy, task.omega]
    for turns in (0.0, 2.0):
        body = list(task.body())
        body[2] = math.remainder(body[2] + turns * 2 * math.pi, 2 * math.pi)
        assert [column[0] for column in task.states([0.0], [body], unwrap=True)] == pytest.approx(start, abs=1e-14)
    slope = math.radians(10)
    assert truths()["slope"].task.pull == pytest.approx((9.81 * math.sin(slope), -9.81 * math.cos(slope)))
