"""The page's own scenarios, in Node, beside Python's: same keys, links, files, code, numbers and sentences."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from hophoop.lab import calls, tables
from hophoop.lab.limits import USUAL, within
from hophoop.lab.python_code import python_code
from hophoop.scenario import InputError
from model.requests_drawn import given_of, plain, request

HERE = Path(__file__).parent
pytestmark = pytest.mark.skipif(shutil.which("node") is None, reason="Node runs the page's own code here")


def answers(call: str, bodies: list[Any]) -> list[dict[str, Any]]:
    """What the page's code makes of bodies, in one process."""
    asked = "".join(json.dumps({"call": call, "body": body}) + "\n" for body in bodies)
    done = subprocess.run(
        ["node", "--no-warnings", HERE / "answer.mjs"], input=asked, capture_output=True, text=True, check=False, timeout=120
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return [json.loads(line) for line in done.stdout.splitlines()]


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


def test_a_thousand_requests_are_read_alike():
    kinds = compare(range(1000))
    assert min(kinds["value"], kinds["error"]) > 250


@pytest.mark.slow
def test_many_more_requests_are_read_alike():
    kinds = compare(range(1000, 31_000))
    assert min(kinds["value"], kinds["error"]) > 7500
