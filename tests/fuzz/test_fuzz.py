"""Scenarios of any magnitude that is supported: computed, or refused in a sentence, and no law broken.

`tests/fuzz/night.py` does the same a hundred thousand times.
"""

from __future__ import annotations

import multiprocessing
import sys
import tomllib
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import HealthCheck, given, note, settings
from hypothesis import strategies as st

import hophoop as hh
from fuzz.checks import PATIENCE, digest, outcome, warm_up
from fuzz.draws import EXTREME, USUAL, Seeded, scenario
from hophoop.kernel.native import forced
from invariants import rounding_energy

TURNS = 200.0  # so short that thousands of them take half a minute
ONE_IN = 8  # is compliant
# s of the processor that one may take here, on any machine. The night counts what takes over 5.
LONGEST = 20.0


class Drawn:
    """A source of numbers that hypothesis chooses."""

    kinds = USUAL

    def __init__(self, draw: Any) -> None:
        self._draw = draw

    def between(self, least: float, most: float) -> float:
        return float(self._draw(st.floats(least, most)))

    def choice(self, values: Sequence[Any]) -> Any:
        return values[self._draw(st.integers(0, len(values) - 1))]


@st.composite
def drawn(draw: Any) -> dict[str, Any]:
    """The keys of a scenario."""
    return scenario(Drawn(draw), ONE_IN, TURNS)


def check(keys: dict[str, Any]) -> None:
    """No broken law."""
    note(str(keys))
    assert outcome(keys, patience=LONGEST).problems == ()


@pytest.mark.compiled
@settings(max_examples=150, derandomize=True, suppress_health_check=list(HealthCheck))
@given(drawn())
def test_any_magnitude(keys):
    check(keys)


@pytest.mark.slow
@pytest.mark.random
@settings(max_examples=2_000, derandomize=True, suppress_health_check=list(HealthCheck))
@given(drawn())
def test_any_magnitude_at_length(keys):
    check(keys)


@pytest.mark.compiled
@pytest.mark.parametrize("seed", [1, 2])
def test_any_extreme(seed):
    """Every number of any magnitude, at an end of its range or next to one; the night draws every tenth scenario so."""
    problems = {index: outcome(scenario(Seeded(seed, index, EXTREME), ONE_IN, TURNS)).problems for index in range(200)}
    assert {index: found for index, found in problems.items() if found} == {}


@pytest.mark.compiled
@pytest.mark.parametrize("index", range(0, 60, 10))
def test_a_saved_motion_of_any_magnitude(index):
    pytest.importorskip("netCDF4", reason="netCDF4 is not installed")
    assert outcome(scenario(Seeded(1, index), ONE_IN, TURNS), with_file=True).problems == ()


def answer(index: int) -> str:
    """What a scenario's motion is, to the last bit."""
    try:
        chosen = hh.Scenario.from_dict(scenario(Seeded(2, index), ONE_IN, TURNS))
    except ValueError as error:
        return str(error)
    return digest(hh.simulate(chosen))


@pytest.fixture
def compiled():
    """The last bits of a compliant motion with extreme numbers are others where its complex divisions are interpreted."""
    with forced("compiled"):
        yield


@pytest.mark.compiled
def test_eight_threads_give_the_same_bits(compiled):
    indices = list(range(48))
    alone = [answer(index) for index in indices]
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(answer, indices * 4)) == alone * 4


@pytest.mark.compiled
@pytest.mark.parametrize("method", [pytest.param("spawn", marks=pytest.mark.long), "fork"])
def test_other_processes_give_the_same_bits(method, compiled):
    if method not in multiprocessing.get_all_start_methods():
        pytest.skip(f"this system has no {method}")
    if method == "fork" and sys.platform == "darwin":
        pytest.skip("forked processes may not use the system's libraries on macOS")
    indices = list(range(24))
    alone = [answer(index) for index in indices]
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context(method)) as pool:
        assert list(pool.map(answer, indices)) == alone


@pytest.fixture
def compiled_before(compiled):
    """Compiled kernels that are loaded before the clock runs, as at night."""
    warm_up()


# of seed 2029
SINCE = [
    10235, 18857, 24344, 27754, 32718, 33093, 33627, 37953, 40938, 41262, 48219,
    48516, 53696, 68751, 68904, 69273, 71595, 81453, 86610, 86688, 92268, 98343,
]  # fmt: skip
NEWER = [22919, 23243, 24580, 29701, 30166, 31349, 39492, 61257, 67403, 112714, 136452, 145977, 203221]


@pytest.mark.slow
@pytest.mark.random
@pytest.mark.compiled
@pytest.mark.parametrize("index", [557, 744, 1019, 1391, 4033, 5406, 6134, 6770, 11925, 14960, 15191, 15746, *NEWER, *SINCE])
def test_scenarios_of_a_night_that_once_failed(compiled_before, index):
    """Their ledger was off, their mirror image had other events, or they took from 6 to 29 s of the processor."""
    assert outcome(kept(index), patience=2.0 * PATIENCE).problems == ()  # of a machine that other work shares


SPINNING = [38901]  # a balanced ring at 10⁶ rad/s, whose mass moves at 1 m/s


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("index", SPINNING)
def test_what_rounds_away_where_velocities_nearly_cancel(compiled_before, index):
    """Their ledger is off by what two velocities lose as doubles, panel by panel: in more digits it closes."""
    assert outcome(kept(index), patience=60.0).problems == ()
    motion = hh.simulate(hh.Scenario.from_dict(kept(index)))
    assert abs(motion.ledger.residual) > 1e-7 * motion.ledger.range  # else they need no law of their own
    with mpmath.workdps(50):
        body = motion.scenario.to_body()
        first, last = (
            {name: mpmath.mpf(float(row[name])) for name in row.dtype.names} for row in motion.tables["events"][[0, -1]]
        )
        sigma = mpmath.sign(first["slip"])
        gn, gt, kap = (mpmath.mpf(value) for value in (body.gn, body.gt, body.kap))
        friction = sigma * mpmath.mpf(body.mu_k) * gn  # ε is as good as 0
        time = last["t"] + last["t_low"]
        before = first["slip"] + first["omega"]
        spin = first["omega"] + friction / kap * time
        after = before + (gt - friction) * time
        along = (before + 0.5 * (after - before)) * time
        kinetic = 0.5 * (before**2 - after**2 + kap * (first["omega"] ** 2 - spin**2))
        residual = float((kinetic + gt * along) * motion.units.energy) - motion.ledger.friction
        slip, panels = after - spin, len(motion.tables["segments"])
        lost = abs(last["slip"] - slip) / (0.5 * np.spacing(abs(float(slip))))
    assert abs(residual) < 1e-14 * motion.ledger.range
    assert 0.1 * panels < lost < panels  # halves of the last bit of v_t: they go the same way


def test_what_may_round_away_is_nothing_in_an_ordinary_motion():
    motion = hh.simulate(hh.Hoop(), hh.Plane(restitution=0.4), hh.Start.rolling(3.1), duration=2.0)
    assert (motion.tables["segments"]["slip"] != 0.0).any()
    assert 0.0 < rounding_energy(motion) < 1e-13 * motion.ledger.range


def kept(index: int) -> dict[str, Any]:
    """The keys of a scenario that a night found."""
    path = Path(__file__).parents[1] / "data" / "once_open" / f"{index}.toml"
    return tomllib.loads(path.read_text(encoding="utf-8"))
