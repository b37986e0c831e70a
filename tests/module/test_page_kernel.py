"""The page's own kernel, its JavaScript over the module, in Node: a film's header and columns are those of the library."""

from __future__ import annotations

import hashlib
import json
import math
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hophoop as hh
from hophoop._fingerprint import STATE, fingerprint
from hophoop.lab import film
from hophoop.module.layout import EVENT_COLUMNS
from hophoop.module.stamp import HERE, MODULE
from hophoop.physics.body import EVENT_NAMES
from module.host import Host
from module.module_tools import cell_of, drawn

KERNEL = HERE.parent / "lab" / "static" / "kernel.js"

pytestmark = pytest.mark.skipif(shutil.which("node") is None, reason="Node runs the page's kernel here")


def given_of(scenario: hh.Scenario) -> dict[str, Any]:
    """A scenario as the page hands it to the kernel (`Given` of web/types.d.ts)."""
    hoop, plane, start = scenario.hoop, scenario.plane, scenario.start
    state = start.state(hoop)
    return {
        "radius": hoop.radius, "mass": hoop.mass, "eccentricity": hoop.eccentricity, "inertia_ratio": hoop.inertia_ratio,
        "ideal": hoop.load_fraction is not None, "gravity": plane.gravity, "slope": plane.slope,
        "rolling_resistance": plane.rolling_resistance,
        "mu_static": plane.mu_static if math.isfinite(plane.mu_static) else "inf",
        "mu_kinetic": plane.mu_kinetic if math.isfinite(plane.mu_kinetic) else "inf",
        "restitution": plane.restitution, "impact_law": plane.impact_law, "painleve": plane.painleve,
        "x": state.x, "height": state.height, "angle": state.angle, "vx": state.vx, "vy": state.vy, "omega": state.omega,
        "slip": state.slip, "rolling": start.speed is not None, "duration": scenario.duration,
        "max_events": scenario.contact.max_events, "contact": contact_of(scenario.contact),
    }  # fmt: skip


def contact_of(contact: hh.Rigid | hh.Compliant) -> dict[str, Any] | None:
    if isinstance(contact, hh.Rigid):
        return None
    names = (
        "stiffness", "damping", "restitution", "law", "friction", "slip_speed", "tangential_stiffness", "rtol",
    )  # fmt: skip
    return {name: getattr(contact, name) for name in names}


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


def decided(answers: dict[str, Any]) -> list[tuple[hh.Scenario, hh.Trajectory, dict[str, Any]]]:
    """Those that doubles decide and that make little of a rounding."""
    found = []
    for scenario, answer in zip(scenarios(), answers["found"], strict=False):
        motion = hh.simulate(scenario)
        if answer["motion"]["doubt"] is None and float(np.max(motion.errors.t)) < 1e-11:
            found.append((scenario, motion, answer))
    assert len(found) > 40
    return found


@pytest.mark.long
def test_what_is_told_of_a_motion_is_the_same(answers: dict[str, Any]) -> None:
    for _, motion, answer in decided(answers):
        told = motion.to_dict()
        mine = answer["motion"]
        assert (mine["status"], mine["sequence"]) == (told["status"], told["sequence"])
        assert mine["duration"] == pytest.approx(motion.duration, rel=1e-12)
        for event, other in zip(told["events"], mine["events"], strict=True):
            assert event.keys() == other.keys()
            assert (event["kind"], event["from"], event["to"]) == (other["kind"], other["from"], other["to"])
            for name in ("t", "x", "angle", "vx", "omega"):
                assert other[name] == pytest.approx(event[name], rel=1e-9, abs=1e-9)
        assert mine["final"].keys() == told["final"].keys()
        assert mine["final"].pop("mode") == told["final"].pop("mode")
        assert mine["final"] == pytest.approx(told["final"], rel=1e-9, abs=1e-9)
        size = motion.ledger.range
        for name, value in told["energy"].items():
            assert mine["energy"][name] == pytest.approx(value, abs=1e-9 * size, rel=1e-9), name


@pytest.mark.long
def test_columns_of_a_film_are_the_same(answers: dict[str, Any]) -> None:
    for _, motion, answer in decided(answers):
        mine = {name: np.array([float(each) for each in column]) for name, column in answer["columns"].items()}
        theirs = film.columns(motion)
        assert mine.keys() == theirs.keys()
        assert mine["t"].size == theirs["t"].size
        assert np.allclose(mine["t"], theirs["t"], rtol=1e-12, atol=1e-12)
        assert np.mean(mine["mode"] == theirs["mode"]) > 0.99
        for name in ("x", "angle", "omega", "kinetic", "friction_loss", "normal_force"):
            size = max(float(np.nanmax(np.abs(theirs[name]))), 1e-3)
            close = np.isclose(mine[name], theirs[name], rtol=1e-7, atol=1e-7 * size, equal_nan=True)
            assert close.mean() > 0.99, name


def test_compliant_motions_are_the_same(answers: dict[str, Any]) -> None:
    for scenario, answer in zip(compliant(), answers["found"][len(scenarios()) :], strict=True):
        motion = hh.simulate(scenario)
        mine = answer["motion"]
        assert (mine["status"], mine["sequence"]) == (motion.status, motion.sequence)
        for event, other in zip(motion.events, mine["events"], strict=True):
            assert other["t"] == pytest.approx(event.t, abs=1e-7)
        told = motion.to_dict()["energy"]
        size = motion.ledger.range
        assert mine["energy"] == pytest.approx(told, abs=1e-6 * size)
        theirs = film.columns(motion)
        assert np.allclose(answer["columns"]["x"], theirs["x"], atol=1e-5)
        chosen = film.header(motion)["automatic"]
        assert answer["compliance"]["automatic"]["stiffness"] == pytest.approx(chosen["contact.stiffness"], rel=1e-12)
        assert answer["compliance"]["automatic"]["slip_speed"] == pytest.approx(chosen["contact.slip_speed"], rel=1e-12)


def test_fingerprints_are_those_of_the_events_of_the_module(answers: dict[str, Any]) -> None:
    host = Host(HERE / MODULE)
    places = [EVENT_COLUMNS.index(name) for name in STATE]
    for scenario, answer in zip(scenarios(), answers["found"], strict=False):
        heads, rows = host.motion(cell_of(scenario))
        decided = math.isnan(heads["doubt_from"])
        kinds = [EVENT_NAMES[int(kind)] for kind in rows[:, EVENT_COLUMNS.index("kind")]]
        assert answer["motion"]["fingerprint"] == (fingerprint(kinds, rows[:, places]) if decided else None)


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
