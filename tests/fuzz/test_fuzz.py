"""Scenarios of any magnitude that is supported: computed, or refused in a sentence, and no law broken.

`HOPHOOP_FUZZ=100000 python -m pytest tests/fuzz -m random` tries a hundred thousand.
"""

from __future__ import annotations

import hashlib
import json
import multiprocessing
import os
import sys
import time
import tomllib
import warnings
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, note, settings
from hypothesis import strategies as st

import hophoop as hh
from fuzz.draws import EXTREME, Seeded, scenario
from hophoop.kernel.native import forced
from invariants import Finding, findings
from strategies import Drawn
from symmetries import mirror_finding, mirrored, scaled, units_finding

TURNS = 200.0  # so short that thousands of them take half a minute
ONE_IN = 8  # is compliant
PATIENCE = 20.0  # s of the processor that a motion may take, on any machine
MANY = int(os.environ.get("HOPHOOP_FUZZ", "200"))
ONCE_OPEN = sorted((Path(__file__).parents[1] / "data" / "once_open").glob("*.toml"))


@st.composite
def drawn(draw: Any) -> dict[str, Any]:
    """The keys of a scenario."""
    return scenario(Drawn(draw), ONE_IN, TURNS)


def digest(motion: hh.Trajectory) -> str:
    """Of all that the simulation wrote."""
    tables = motion.tables
    return hashlib.sha256(tables["events"].tobytes() + tables["segments"].tobytes() + motion.status.encode()).hexdigest()


def all_findings(motion: hh.Trajectory) -> list[Finding]:
    """Deviations from every invariant, and from both symmetries where they are promised; nothing after time that runs back."""
    found = findings(motion)
    if found[-1].invariant != "ledger":
        return found
    if (image := mirrored(motion.scenario)) is not None:
        found.append(mirror_finding(motion, hh.simulate(image)))
    if (other := scaled(motion.scenario)) is not None:
        found.append(units_finding(motion, hh.simulate(other[0]), other[1]))
    return found


def problems(keys: dict[str, Any], file: Path | None = None) -> list[str]:
    """What is wrong with the motion of a scenario file's keys; with a file, also where that does not give it back to the bit.

    Anything that is raised is a failure, except for a ValueError in one sentence where the scenario is refused.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            given = hh.Scenario.from_dict(keys)
        except ValueError as error:
            plain = str(error).endswith((".", "?")) and "\n" not in str(error)
            return [] if plain else [f"no plain sentence: {error}"]
        began = time.process_time()
        motion = hh.simulate(given)
        seconds = time.process_time() - began
        found = [
            f"{f.invariant}: {f.words} at {f.t!r} s ({f.value:.1e}, allowed {f.allowed:.1e})"
            for f in all_findings(motion)
            if f.broken
        ]
        json.dumps(motion.to_dict(), allow_nan=False)
        if file is not None:
            motion.save(file)
            if digest(hh.load(file)) != digest(motion):
                found.append("a loaded motion has other bits")
    if seconds > PATIENCE:
        found.append(f"{seconds:.0f} s of the processor")
    return found


@pytest.fixture
def compiled():
    """The last bits of a compliant motion with extreme numbers are others where its complex divisions are interpreted."""
    with forced("compiled"):
        for contact in (hh.Rigid(), hh.Compliant()):  # loaded before a clock runs
            hh.simulate(hh.Scenario(contact=contact, duration=0.1)).at(0.05)
        yield


@pytest.mark.compiled
@settings(max_examples=100, derandomize=True, suppress_health_check=list(HealthCheck))
@given(drawn())
def test_any_magnitude(keys):
    note(str(keys))
    assert problems(keys) == []


@pytest.mark.slow
@pytest.mark.random
@settings(max_examples=MANY, derandomize=MANY < 1000, suppress_health_check=list(HealthCheck))
@given(drawn())
def test_any_magnitude_at_length(keys):
    note(str(keys))
    assert problems(keys) == []


@pytest.mark.compiled
@pytest.mark.parametrize("seed", [1, 2])
def test_any_extreme(seed):
    """Every number of any magnitude, at an end of its range or next to one."""
    found = {index: problems(scenario(Seeded(seed, index, EXTREME), ONE_IN, TURNS)) for index in range(80)}
    assert {index: wrong for index, wrong in found.items() if wrong} == {}


@pytest.mark.compiled
def test_saved_motions_of_any_magnitude(tmp_path):
    pytest.importorskip("netCDF4", reason="netCDF4 is not installed")
    found = {index: problems(scenario(Seeded(1, index), ONE_IN, TURNS), tmp_path / f"{index}.nc") for index in range(0, 60, 10)}
    assert {index: wrong for index, wrong in found.items() if wrong} == {}


@pytest.mark.slow
@pytest.mark.random
@pytest.mark.compiled
def test_what_once_failed(compiled):
    """The ledger was off, the mirror image had other events, or the motion took from 6 to 29 s of the processor."""
    found = {file.stem: problems(tomllib.loads(file.read_text(encoding="utf-8"))) for file in ONCE_OPEN}
    assert {name: wrong for name, wrong in found.items() if wrong} == {}


def answer(index: int) -> str:
    """The motion of a scenario, to the last bit."""
    try:
        chosen = hh.Scenario.from_dict(scenario(Seeded(2, index), ONE_IN, TURNS))
    except ValueError as error:
        return str(error)
    return digest(hh.simulate(chosen))


@pytest.mark.compiled
@pytest.mark.parametrize("way", ["threads", "fork", pytest.param("spawn", marks=pytest.mark.long)])
def test_threads_and_processes_give_the_same_bits(way, compiled):
    if way == "fork" and sys.platform == "darwin":
        pytest.skip("forked processes may not use the system's libraries on macOS")
    indices = list(range(24))
    alone = [answer(index) for index in indices]
    if way == "threads":
        pool = ThreadPoolExecutor(8)
    elif way in multiprocessing.get_all_start_methods():
        pool = ProcessPoolExecutor(2, mp_context=multiprocessing.get_context(way))
    else:
        pytest.skip(f"this system has no {way}")
    with pool:
        assert list(pool.map(answer, indices)) == alone
