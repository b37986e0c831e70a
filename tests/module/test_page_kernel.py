"""The page's own kernel, its JavaScript over the module, in Node: random motions and their films are those of the library."""

from __future__ import annotations

import json
import math
import shutil
import subprocess
from pathlib import Path

import pytest

import hophoop as hh
from hophoop.kernel.compliant.motion import chosen_in_si
from hophoop.lab.wasm.stamp import HERE, MODULE
from hophoop.scenario.scenario import time_unit
from hophoop.simulation.compliant import to_compliance
from module.module_tools import drawn, given_of
from page_films import same_columns

KERNEL = HERE.parent / "static" / "kernel.js"
CONTACTS = [
    hh.Compliant(),
    hh.Compliant(stiffness=1e5, law="hunt-crossley", friction="bristle"),
    hh.Compliant(stiffness=2e5, friction="linear", restitution=0.5, slip_speed=1e-3),
]

pytestmark = pytest.mark.skipif(shutil.which("node") is None, reason="Node runs the page's kernel here")


def test_motions_and_films_are_those_of_the_library(tmp_path: Path) -> None:
    queries = ("plane.restitution=0.9", "duration=600", "plane.rolling_resistance=0.02")
    scenarios = [hh.Scenario.from_query(query) for query in queries] + drawn(60, 900)
    soft = hh.Scenario.from_query("duration=2&plane.slope=0.1&start.speed=2")
    scenarios += [soft.replace("contact", contact) for contact in CONTACTS]
    asked = tmp_path / "asked.json"
    asked.write_text(json.dumps([given_of(scenario) for scenario in scenarios]), encoding="utf-8")
    command = ["node", Path(__file__).parent / "drive.mjs", KERNEL, HERE / MODULE, asked]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    decided = 0
    for scenario, answer in zip(scenarios, json.loads(done.stdout), strict=True):
        motion, mine, what = hh.simulate(scenario), answer["motion"], scenario.to_query()
        told = motion.to_dict()
        for name in ("status", "sequence", "final", "energy", "events"):
            assert mine[name] == told[name], (what, name)
        assert mine["duration"] == motion.duration, what
        if math.isinf(motion.doubt):
            assert (mine["doubt"], mine["fingerprint"]) == (None, motion.fingerprint), what
            decided += 1
        same_columns(answer["columns"], motion, what)
        if scenario.contact.model == "compliant":
            _, chosen, _, _ = to_compliance(scenario)
            hoop = scenario.hoop
            stiffness, slip_speed = chosen_in_si(chosen, hoop.radius, time_unit(hoop, scenario.plane), hoop.mass)
            assert answer["chosen"] == {"stiffness": stiffness, "slip_speed": slip_speed}, what
    assert decided > 45
