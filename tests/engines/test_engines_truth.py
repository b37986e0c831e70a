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
from truth import job, scored, truths

import hophoop as hh
from oracles import hybrid
from oracles.cases import Case


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


@pytest.mark.parametrize(
    "name", [name if name in ("drop", "painleve") else pytest.param(name, marks=pytest.mark.long) for name in truths()]
)
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


@pytest.mark.parametrize("name", ["slip", "hop", "drop"])
def test_states_are_those_of_an_independent_integrator(name):
    task, scenario = truths()[name].task, scenario_of(truths()[name].task)
    case = Case(
        name, inertia_ratio=scenario.hoop.inertia_ratio, mu_static=task.mu, mu_kinetic=task.mu, height=task.height,
        angle=task.angle, vx=task.vx, omega=task.omega, rolling=scenario.start.speed is not None, duration=task.duration,
    )  # fmt: skip
    end, right = hybrid.solve(case).events[-1], truths()[name].states
    for key, column in zip(("x", "height", "angle", "vx", "vy", "omega"), right[1:], strict=True):
        assert end[key] == pytest.approx(column[-1], abs=1e-9)


@pytest.mark.parametrize("name", scored())
def test_the_rule_finds_the_phases_of_the_exact_motion(name):
    """Phases of at least 20 ms, from the exact events, are those that the rule finds in samples."""
    task, right = truths()[name].task, truths()[name]
    found, _ = phases(task, run(task, 0.0))
    marks = [event for event in right.entry["events"] if event["kind"] not in ("turn", "apex", "kane_gain", "rest")]
    longer = []
    for event, following in itertools.pairwise(marks):
        begin, end = float(event["t"]), float(following["t"])
        same = longer and longer[-1][0] == event["to"]
        if end - begin >= 0.02 and not same:
            longer.append((event["to"], begin))
    assert "".join(letter for letter, _ in longer) == "".join(phase.letter for phase in found) == right.measures.sequence
    for (_, begin), phase in zip(longer, found, strict=True):
        # slip is told from rolling by 1 cm/s, which it reaches some milliseconds after it begins; flight by N
        assert phase.begin == pytest.approx(begin, abs=0.04)


def test_the_task_is_the_start_seen_from_the_centre_of_gravity():
    task = truths()["drop"].task
    body = task.body()
    states = task.states([0.0], [body])
    for value, expected in zip(states, (0.0, task.x, task.height, task.angle, task.vx, task.vy, task.omega), strict=True):
        assert value[0] == pytest.approx(expected, abs=1e-15)
    assert truths()["slope"].task.pull == pytest.approx((9.81 * math.sin(math.radians(10)), -9.81 * math.cos(math.radians(10))))
    turned = [list(body)]
    turned[0][2] = math.remainder(body.turn + 4 * math.pi, 2 * math.pi)
    assert task.states([0.0], turned, unwrap=True).angle[0] == pytest.approx(task.angle)


def test_an_adapter_reads_the_task_the_step_and_the_settings():
    task = truths()["slope"].task
    given = job(task, 0.0001, {"sweeps": 4})
    assert (given["dt"], given["every"], given["settings"]) == (0.0001, 4, {"sweeps": 4})
    assert truth.task_of(json.loads(json.dumps(given))) == task
