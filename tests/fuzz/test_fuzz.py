"""Scenarios of any magnitude that is supported: computed, or refused in a sentence, and no law broken.

`HOPHOOP_FUZZ=100000 python -m pytest tests/fuzz -m random` tries a hundred thousand.
"""

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
from random import Random

import pytest

import hophoop as hh
from fuzz.draws import Extreme, scenario
from hophoop.kernel.native import forced
from invariants import findings
from symmetries import mirror_finding, mirrored, scaled, units_finding

ONE_IN, TURNS = 8, 200.0  # is compliant; so short that thousands of them take half a minute
PATIENCE = 20.0  # s of the processor that a motion may take, on any machine
MANY = int(os.environ.get("HOPHOOP_FUZZ", "200"))
OPEN = {"29701": ["normal force"]}  # in slip next to the paradox, after a doubt
ONCE_OPEN = Path(__file__).parents[1] / "data" / "once_open"


def digest(motion):
    """Of all that the simulation wrote."""
    tables = motion.tables
    return hashlib.sha256(tables["events"].tobytes() + tables["segments"].tobytes() + motion.status.encode()).hexdigest()


def all_findings(motion):
    """Deviations from every invariant, and from both symmetries where they are promised; nothing after time that runs back."""
    found = findings(motion)
    if found[-1].invariant != "ledger":
        return found
    if (image := mirrored(motion.scenario)) is not None:
        found.append(mirror_finding(motion, hh.simulate(image)))
    if (other := scaled(motion.scenario)) is not None:
        found.append(units_finding(motion, hh.simulate(other[0]), other[1]))
    return found


def problems(keys, file=None):
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
        found = [each for each in all_findings(motion) if each.broken]
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


AT_LENGTH = pytest.param(range(30, MANY), marks=[pytest.mark.slow, pytest.mark.random])


@pytest.mark.parametrize("seeds", [range(30), AT_LENGTH], ids=len)
def test_any_magnitude(seeds):
    found = {seed: problems(scenario(Random(seed), ONE_IN, TURNS)) for seed in seeds}
    assert {seed: wrong for seed, wrong in found.items() if wrong} == {}


def test_any_extreme():
    """Every number of any magnitude, at an end of its range or next to one."""
    found = {seed: problems(scenario(Extreme(seed), ONE_IN, TURNS)) for seed in range(160)}
    assert {seed: wrong for seed, wrong in found.items() if wrong} == {}


def test_saved_motions_of_any_magnitude(tmp_path):
    pytest.importorskip("netCDF4")
    found = {seed: problems(scenario(Random(seed), ONE_IN, TURNS), tmp_path / f"{seed}.nc") for seed in range(6)}
    assert {seed: wrong for seed, wrong in found.items() if wrong} == {}


@pytest.mark.slow
@pytest.mark.random
def test_what_once_failed(compiled):
    """The ledger was off, the mirror image had other events, or the motion took from 6 to 29 s of the processor.

    What is known to be open is so still: what gets better or worse shows here.
    """
    found = {file.stem: problems(tomllib.loads(file.read_text(encoding="utf-8"))) for file in sorted(ONCE_OPEN.glob("*.toml"))}
    open_still = {name: [getattr(one, "invariant", one) for one in wrong] for name, wrong in found.items() if wrong}
    assert open_still == OPEN


def answer(seed):
    """The motion of a scenario, to the last bit."""
    try:
        return digest(hh.simulate(hh.Scenario.from_dict(scenario(Random(seed), ONE_IN, TURNS))))
    except ValueError as error:
        return str(error)


@pytest.mark.parametrize("way", ["threads", "fork", pytest.param("spawn", marks=pytest.mark.long)])
def test_threads_and_processes_give_the_same_bits(way, compiled):
    if way != "threads" and (way not in multiprocessing.get_all_start_methods() or (way, sys.platform) == ("fork", "darwin")):
        pytest.skip(f"{way} is not for this system")  # forked processes may not use the system's libraries on macOS
    alone = [answer(seed) for seed in range(24)]
    pool = ThreadPoolExecutor(8) if way == "threads" else ProcessPoolExecutor(2, multiprocessing.get_context(way))
    with pool:
        assert list(pool.map(answer, range(24))) == alone
