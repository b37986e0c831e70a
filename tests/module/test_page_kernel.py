"""The page's own kernel, its JavaScript over the module, in Node: a film's header and columns are those of the library."""

from __future__ import annotations

import hashlib
import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

import hophoop as hh
from hophoop._support.fingerprint import STATE, fingerprint
from hophoop.kernel.compliant.motion import chosen_in_si
from hophoop.kernel.physics.body import EVENT_NAMES
from hophoop.lab.wasm.layout import EVENT_COLUMNS
from hophoop.lab.wasm.stamp import HERE, MODULE
from hophoop.scenario.scenario import time_unit
from hophoop.simulation.compliant import to_compliance
from module.host import Host
from module.module_tools import cell_of, drawn, given_of
from page_films import same_columns

KERNEL = HERE.parent / "static" / "kernel.js"

pytestmark = pytest.mark.skipif(shutil.which("node") is None, reason="Node runs the page's kernel here")


def compliant() -> list[hh.Scenario]:
    base = hh.Scenario(duration=2.0)
    contacts = [
        hh.Compliant(),
        hh.Compliant(stiffness=1e5, law="hunt-crossley", friction="bristle"),
        hh.Compliant(stiffness=2e5, friction="linear", restitution=0.5, slip_speed=1e-3),
    ]
    return [
        base.with_values({"contact": contact, "start.speed": speed, "plane.slope": slope})
        for contact in contacts
        for speed, slope in ((3.1, 0.0), (2.0, 0.1))
    ]


def scenarios() -> list[hh.Scenario]:
    return [
        hh.Scenario(),
        hh.Scenario().replace("plane.restitution", 0.9),
        hh.Scenario(duration=600.0),
        hh.Scenario().replace("plane.rolling_resistance", 0.02),
        *drawn(60, 900),
    ]


@pytest.fixture(scope="module")
def answers(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    file = tmp_path_factory.mktemp("page") / "asked.json"
    file.write_text(json.dumps([given_of(scenario) for scenario in (*scenarios(), *compliant())]), encoding="utf-8")
    driver = Path(__file__).parent / "drive.mjs"
    done = subprocess.run(
        ["node", str(driver), str(KERNEL), str(HERE / MODULE), str(file)], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    answers: dict[str, Any] = json.loads(done.stdout)
    print(f"{answers['microseconds']:.1f} µs a motion")
    return answers


def computed(answers: dict[str, Any]) -> list[tuple[hh.Trajectory, dict[str, Any]]]:
    """Motions of both contact models, and what the page tells of them."""
    pairs = zip((*scenarios(), *compliant()), answers["found"], strict=True)
    return [(hh.simulate(scenario), answer) for scenario, answer in pairs]


@pytest.mark.long
def test_what_is_told_of_a_motion_is_the_same(answers: dict[str, Any]) -> None:
    for motion, answer in computed(answers):
        told = motion.to_dict()
        mine = answer["motion"]
        assert mine["duration"] == motion.duration
        assert {name: mine[name] for name in ("status", "sequence", "final", "energy")} == {
            name: told[name] for name in ("status", "sequence", "final", "energy")
        }
        for event, other in zip(told["events"], mine["events"], strict=True):
            assert other == event


@pytest.mark.long
def test_columns_of_a_film_are_the_same(answers: dict[str, Any]) -> None:
    for motion, answer in computed(answers):
        same_columns(answer["columns"], motion, motion.scenario.to_query())


def test_what_a_contact_chooses_is_the_same(answers: dict[str, Any]) -> None:
    for scenario, answer in zip(compliant(), answers["found"][len(scenarios()) :], strict=True):
        _, chosen, _, _ = to_compliance(scenario)
        hoop = scenario.hoop
        stiffness, slip_speed = chosen_in_si(chosen, hoop.radius, time_unit(hoop, scenario.plane), hoop.mass)
        assert answer["chosen"] == {"stiffness": stiffness, "slip_speed": slip_speed}


def test_fingerprints_are_those_of_the_events_of_the_module(answers: dict[str, Any]) -> None:
    host = Host(HERE / MODULE)
    places = [EVENT_COLUMNS.index(name) for name in STATE]
    for scenario, answer in zip(scenarios(), answers["found"], strict=False):
        _, rows = host.motion(cell_of(scenario))
        kinds = [EVENT_NAMES[int(kind)] for kind in rows[:, EVENT_COLUMNS.index("kind")]]
        assert answer["motion"]["fingerprint"] == fingerprint(kinds, rows[:, places])


def test_fingerprints_are_those_of_python(answers: dict[str, Any]) -> None:
    """Where doubles decide: equal bits of all events."""
    told = zip((*scenarios(), *compliant()), answers["found"], strict=True)
    pairs = [(scenario, answer["motion"]) for scenario, answer in told if answer["motion"]["doubt"] is None]
    assert len(pairs) > 45
    others = [scenario.to_query() for scenario, mine in pairs if mine["fingerprint"] != hh.simulate(scenario).fingerprint]
    assert others == []


def test_the_same_bits_in_another_engine(answers: dict[str, Any]) -> None:
    host = Host(HERE / MODULE)
    digest = hashlib.sha256()
    for scenario in scenarios():
        digest.update(host.motion(cell_of(scenario))[1].tobytes())
    assert digest.hexdigest() == answers["hash"]
