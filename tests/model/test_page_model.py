"""The page's own scenarios, in Node, beside Python's: same keys, links, files, code, numbers and sentences."""

from __future__ import annotations

import atexit
import difflib
import functools
import json
import math
import random
import shutil
import subprocess
import tempfile
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

import hophoop as hh
import random_scenarios
from hophoop import theory
from hophoop._support import errors
from hophoop.lab import calls, presets, tables, thresholds, typescript, words
from hophoop.lab.python_code import python_code
from hophoop.lab.wasm.stamp import DERIVATIVES, MODULE
from hophoop.lab.wasm.stamp import HERE as MODULE_FOLDER
from hophoop.scenario import InputError
from model.requests_drawn import NUMBERS, given_of, request
from web_tools import bundled, needs_node

HERE = Path(__file__).parent
KERNEL = tables.FILE.parent / "kernel.js"
MODULE_FILE = MODULE_FOLDER / MODULE
DERIVATIVES_FILE = MODULE_FOLDER / DERIVATIVES
pytestmark = needs_node


@functools.cache
def answering() -> Path:
    """The program that answers, with the page's sources in it."""
    folder = tempfile.mkdtemp(prefix="hophoop-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    program = Path(folder) / "answer.mjs"
    program.write_text(bundled(HERE / "answer.mjs"), encoding="utf-8")
    return program


def answers(call: str, bodies: list[Any]) -> list[dict[str, Any]]:
    """What the page's code makes of bodies, in one process."""
    asked = "".join(json.dumps({"call": call, "body": body}) + "\n" for body in bodies)
    done = subprocess.run(
        ["node", answering(), KERNEL, MODULE_FILE, DERIVATIVES_FILE],
        input=asked,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return [json.loads(line) for line in done.stdout.split("\n") if line]


def of_python(body: Any) -> dict[str, Any]:
    """The same by Python."""
    try:
        scenario = calls.read("code", body).scenario
    except InputError as error:
        return {"error": str(error)}
    return {
        "value": {
            "dict": scenario.to_dict(),
            "query": scenario.to_query(),
            "toml": scenario.to_toml(),
            "code": python_code(scenario),
            "given": given_of(scenario),
        }
    }


def compare(seeds: range) -> Counter[str]:
    bodies = [json.loads(json.dumps(request(seed))) for seed in seeds]
    kinds: Counter[str] = Counter()
    for seed, body, answer in zip(seeds, bodies, answers("scenario", bodies), strict=True):
        expected = of_python(body)
        assert answer == expected, f"request({seed}) = {json.dumps(body)}"
        kinds.update(list(answer))
    return kinds


def test_the_tables_are_what_python_would_write_now():
    written = tables.FILE.read_text(encoding="utf-8")
    assert written == tables.text(), "run `python -m hophoop.lab.tables` and `npm run build` in web/"


def test_the_types_are_those_of_the_models_now():
    assert typescript.FILE.read_text(encoding="utf-8") == typescript.text(), "run `python -m hophoop.lab.tables`"


def test_a_thousand_requests_are_read_alike():
    kinds = compare(range(1000))
    assert min(kinds["value"], kinds["error"]) > 250


@pytest.mark.slow
def test_many_more_requests_are_read_alike():
    kinds = compare(range(1000, 31_000))
    assert min(kinds["value"], kinds["error"]) > 7500


# Numbers and texts


def test_numbers_are_written_as_python_writes_them():
    draw = random.Random(3)
    values = (
        [0.5 + k for k in range(12)] + [k / 8 for k in range(-40, 40)] + [2.5e-5, 0.00015, 123456.5, 9.5, 99.95, 1e21, 1e22]
    )
    values += [draw.uniform(-1.0, 1.0) * 10.0 ** draw.uniform(-310, 308) for _ in range(3000)]
    values += [round(draw.uniform(-1e3, 1e3), draw.randint(0, 4)) for _ in range(2000)]
    form = "{0!r} {0:g} {0:.3g} {0:.6g} {0:.0e} {0:.2e} {0:.1f} {0:.0f}"
    (answer,) = answers("numbers", [values])
    for value, text in zip(values, answer["value"], strict=True):
        assert text == form.format(float(value))


def test_texts_are_quoted_and_read_as_numbers_as_python_does():
    texts = [
        *("", "a", "it's", 'say "x"', "'\"", "back\\slash", "tab\tnew\nline", "θ → ∞ 𝛾", "x" * 61, "é" * 60),
        "\x00\x7f\x85\u00a0\u200b\ue000\U000e0001",
        *(*NUMBERS, "1__0", "_1", "1_", "1.e5", "+.5e-3", "\u2003 7 \n", "0b1", "1e5_0", "INFINITY", "-NaN"),
    ]
    (answer,) = answers("texts", [texts])
    for text, found in zip(texts, answer["value"], strict=True):
        try:
            number = calls.finite(float(text))
        except ValueError:
            number = None
        read = calls.finite({"nan": math.nan, "inf": math.inf}.get(found[4], found[4])) if found[4] is not None else None
        assert [*found[:4], read] == [repr(text), errors.plain(text), errors.shortened(text), json.dumps(text), number]


def test_a_key_that_was_meant_is_the_one_that_python_finds():
    draw = random.Random(4)
    known = [name for model in tables.tables()["scenario"]["models"].values() for name in model["fields"]]
    words = ["".join(draw.sample(word, len(word))[: draw.randint(1, 9)]) for word in known * 10]
    words += [word[:k] + draw.choice("aeiou_") + word[k + draw.randint(0, 2) :] for word in known for k in range(len(word))]
    (answer,) = answers("closest", [{"words": words, "known": known}])
    for word, found in zip(words, answer["value"], strict=True):
        assert [found] * (found is not None) == difflib.get_close_matches(word, known, n=1), word


# Words


def motions() -> list[hh.Trajectory]:
    """Three hundred: of presets, of every kind drawn, and of starts that do not turn, whose words are those of what comes."""
    still = [
        {"start": {"angle": angle, "vx": speed, "omega": 0.0}, "plane": {"mu": mu}, "duration": 1.5}
        for angle in (0.3, 2.0, -1.2) for speed in (-1.0, 0.7) for mu in (0.05, 0.4, 1.1)
    ]  # fmt: skip
    bouncing = [{"plane": {"restitution": e}, "start": {"height": 0.5, "vx": 1.0}, "duration": 3.0} for e in (0.3, 0.6, 0.9)]
    found = [preset.scenario for preset in presets.presets()]
    found += [hh.Scenario.from_dict(keys) for keys in (*still, *bouncing)]
    found += [random_scenarios.scenario_of(random_scenarios.draw(7, index)[1], 300) for index in range(300 - len(found))]
    return [hh.simulate(scenario) for scenario in found]


def test_three_hundred_motions_are_told_alike():
    computed = motions()
    bodies = []
    for motion in computed:
        still = [k for k, event in enumerate(motion.events[:-1]) if event.omega == 0.0]
        halfway = {k: motion.at(0.5 * (motion.events[k].t + motion.events[k + 1].t)).omega for k in still}
        result = motion.to_dict()
        bodies.append({"events": result["events"], "status": result["status"], "halfway": halfway})
    kinds = set()
    for motion, answer in zip(computed, answers("words", bodies), strict=True):
        assert answer["value"]["summary"] == words.summary(motion), motion.scenario.to_query()
        assert answer["value"]["story"] == words.story(motion), motion.scenario.to_query()
        kinds |= {event.kind for event in motion.events}
    assert {"turn", "takeoff", "apex", "jam", "kane_gain", "skim", "rest", "slip_reversal", "bounce_limit"} <= kinds
    assert any(body["halfway"] for body in bodies)


def known_of(scenario: hh.Scenario) -> dict[str, Any]:
    """What the module gives, as Python computes it."""
    found = {quantity.key: quantity.value for quantity in theory.summary(scenario)}
    names = (
        "first_slip_speed", "first_hop_speed", "immediate_hop_speed", "needed_friction", "painleve_friction",
        "painleve_angle", "stable_angle", "massless_loss_angle",
    )  # fmt: skip
    known: dict[str, Any] = {name: found.get(name) for name in names}
    known["jam_angles"] = [value for key, value in found.items() if key.startswith("jam_angle")]
    level = scenario.hoop.massless and scenario.plane.gravity > 0.0
    loss = theory.massless_loss(scenario.start.speed or 0.0, scenario.hoop.radius, scenario.plane) if level else None
    known["massless_loss_by_friction"] = loss is not None and bool(loss.by_friction)
    return {name: "inf" if value == math.inf else value for name, value in known.items()}


@pytest.mark.long
def test_thresholds_are_told_alike():
    found = [preset.scenario for preset in presets.presets()]
    found += [random_scenarios.scenario_of(random_scenarios.draw(8, index)[1]) for index in range(24)]
    found += [
        hh.Scenario.from_query(query) for query in ("plane.gravity=0", "hoop.load_fraction=0", "plane.slope=-0.2&plane.mu=2")
    ]
    bodies = [{"scenario": scenario.to_dict(), "known": known_of(scenario)} for scenario in found]
    told = set()
    for scenario, answer in zip(found, answers("thresholds", bodies), strict=True):
        expected = thresholds.thresholds(scenario)
        assert answer["value"] == expected, scenario.to_query()
        told |= {one["key"] for one in expected}
    assert told >= {"first_slip", "first_hop", "immediate_hop", "needed_friction", "painleve", "jam", "rest", "loss"}
