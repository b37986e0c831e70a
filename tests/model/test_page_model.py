"""The page's own scenarios, in Node: Python reads what it writes as the same scenario and refuses what it refuses."""

import atexit
import functools
import json
import math
import random
import re
import shutil
import subprocess
import tempfile
from collections import Counter
from pathlib import Path

import pytest

import hophoop as hh
from hophoop._support import errors
from hophoop.lab import tables
from hophoop.lab.wasm.stamp import HERE as MODULE_FOLDER
from hophoop.lab.wasm.stamp import MODULE
from hophoop.scenario import InputError
from model.asked import asked
from model.requests_drawn import NUMBERS, request
from module.module_tools import given_of
from scenario.test_scenario import REFUSED
from web_tools import bundled, needs_node

HERE = Path(__file__).parent
KERNEL = tables.FILE.parent / "kernel.js"
MODULE_FILE = MODULE_FOLDER / MODULE
pytestmark = needs_node


@functools.cache
def answering():
    """The program that answers, with the page's sources in it."""
    folder = tempfile.mkdtemp(prefix="hophoop-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    program = Path(folder) / "answer.mjs"
    program.write_text(bundled(HERE / "answer.mjs"), encoding="utf-8")
    return program


def answers(call, bodies):
    """What the page's code makes of bodies, in one process."""
    asked = "".join(json.dumps({"call": call, "body": body}) + "\n" for body in bodies)
    done = subprocess.run(
        ["node", answering(), KERNEL, MODULE_FILE],
        input=asked,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    # JavaScript writes doubles up to 1e21 without a point
    return [json.loads(line, parse_int=whole_number) for line in done.stdout.split("\n") if line]


def whole_number(digits):
    """An integer, or a double that is not all of its digits."""
    return int(digits) if len(digits) < 16 else float(digits)


def finite(value):
    """What JSON has of a number."""
    return value if math.isfinite(value) else None


def of_python(body):
    """The scenario by Python, or the start of the sentence that refuses it, which names the field."""
    try:
        return asked(body)
    except InputError as error:
        return field_of(str(error)).removeprefix("scenario.")


def field_of(sentence):
    """The field that a sentence names; JavaScript puts keys that are numbers in order, so these are left out."""
    return re.sub(r"\.\d+$", "", sentence.split(" ")[0].rstrip(":"))


def keys_of(query):
    return [pair.partition("=")[0] for pair in query.split("&")]


def comments_of(toml):
    """Lines without their values: keys, tables and units."""
    return [line.partition(" = ")[0] + line.partition("#")[1] + line.partition("#")[2] for line in toml.split("\n")]


def asked_of(code, monkeypatch):
    """The scenario that a program computes."""
    found = []

    def simulate(hoop, plane, start, **rest):
        found.append(hh.Scenario(hoop=hoop, plane=plane, start=start, **rest))
        raise StopIteration

    with monkeypatch.context() as patched:
        patched.setattr(hh, "simulate", simulate)
        with pytest.raises(StopIteration):
            exec(code, {})
    return found[0]


def compare(seeds, monkeypatch):
    bodies = [json.loads(json.dumps(request(seed))) for seed in seeds]
    kinds = Counter()
    for seed, body, answer in zip(seeds, bodies, answers("scenario", bodies), strict=True):
        expected, what = of_python(body), f"request({seed}) = {json.dumps(body)}"
        kinds.update(list(answer))
        if isinstance(expected, str):
            assert field_of(answer.get("error", "")) == expected, f"{what}: {answer}"
            continue
        assert "value" in answer, f"{what}: {answer}"
        page = answer["value"]
        assert page["dict"] == expected.to_dict(), what
        assert page["given"] == given_of(expected), what
        assert keys_of(page["query"]) == keys_of(expected.to_query()), what
        assert comments_of(page["toml"]) == comments_of(expected.to_toml()), what
        for read in (hh.Scenario.from_query(page["query"]), hh.Scenario.loads(page["toml"])):
            assert (read.to_dict(), read) == (expected.to_dict(), expected), what
        assert asked_of(page["code"], monkeypatch) == expected, what
    return kinds


def test_the_tables_are_what_python_would_write_now():
    written = tables.FILE.read_text(encoding="utf-8")
    assert written == tables.text(), "run `python -m hophoop.lab.tables` and `npm run build` in web/"


@pytest.mark.parametrize("seeds", [range(300), pytest.param(range(300, 6000), marks=pytest.mark.slow)], ids=len)
def test_requests_are_read_alike(seeds, monkeypatch):
    kinds = compare(seeds, monkeypatch)
    assert min(kinds["value"], kinds["error"]) > len(seeds) / 4


def test_what_breaks_a_rule_is_refused_alike():
    """One text at least for every rule, which the module knows on the page."""
    bodies = [{"scenario": json.loads(text)} if text.startswith("{") else {"query": text} for text in REFUSED]
    for body, answer in zip(bodies, answers("scenario", bodies), strict=True):
        assert field_of(answer["error"]) == of_python(body), body


# Numbers and texts


def doubles():
    draw = random.Random(3)
    values = [0.5 + k for k in range(12)] + [2.5e-5, 0.00015, 123456.5, 99.95, 1e21, 1e22, 1e-7, 5e-324, -2.0, 1e16]
    values += [draw.uniform(-1.0, 1.0) * 10.0 ** draw.uniform(-310, 308) for _ in range(3000)]
    return values


def test_numbers_are_written_with_all_their_bits_or_rounded():
    values = doubles()
    (answer,) = answers("numbers", [values])
    for value, text in zip(values, answer["value"], strict=True):
        whole, *rounded = map(float, text.split(" "))
        assert whole == value, text
        for found, digits in zip(rounded, ("g", ".3g", ".2e", ".1f"), strict=True):
            step = 0.1 if digits == ".1f" else abs(value) * 10.0 ** -{"g": 5, ".3g": 2, ".2e": 2}[digits]
            assert abs(found - value) <= max(0.5001 * step, 1e-323), (text, digits)


def test_texts_are_made_safe_and_read_as_numbers_as_python_does():
    texts = [
        *("", "a", "it's", 'say "x"', "back\\slash", "θ → ∞ 𝛾", "x" * 61, "é" * 60),
        *NUMBERS, "1__0", "_1", "1.e5", "+.5e-3",
        *("\u2003 7 \n", "0b1", "INFINITY", "-NaN"),
    ]  # fmt: skip
    (answer,) = answers("texts", [texts])
    for text, (safe, short, number) in zip(texts, answer["value"], strict=True):
        try:
            expected = finite(float(text))
        except ValueError:
            expected = None
        read = finite({"nan": math.nan, "inf": math.inf}.get(number, number)) if number is not None else None
        assert (short, read) == (errors.shortened(text), expected), text
        assert safe == text or not text.isprintable()
    (answer,) = answers("texts", [["tab\tnew\nline \x00\x7f\u200b\ue000\U000e0001"]])
    assert answer["value"][0][0].isprintable()


@pytest.mark.parametrize(
    ("query", "said"),
    [
        ("plane.gamma=1", "known are gravity, slope, mu"),
        ("hoop.radious=1", "did you mean hoop.radius?"),
        ("hoops.radius=1", "did you mean hoop?"),
        ("start.sped=1", "did you mean start.speed?"),
    ],
)
def test_a_key_that_may_have_been_meant_is_named(query, said):
    (answer,) = answers("scenario", [{"query": query}])
    assert said in answer["error"]
