"""Calls of kernels from Python: by the library where there is one, else interpreted, with the same bits."""

from __future__ import annotations

import json
import math
import os

import numpy as np
import pytest

import hophoop as hh
from hophoop.kernel.native import compiled, forced, mode
from hophoop.kernel.native.library import BUILD, Library
from hophoop.theory.kernels.phase_plane import lift_off
from hophoop.vocabulary.names import LAW_CODES
from kernel_tools import python

FIRST = """
import json, sys
import hophoop as hh
motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
sample = motion.at([0.5, 1.1])
print(json.dumps([motion.to_dict(), sample.omega.tolist()]))
assert "numba" not in sys.modules
"""


# Which of both


@pytest.mark.parametrize("wanted", ["auto", "interpreted"])
def test_a_motion_without_a_library(wanted, tmp_path):
    """It is the same, with one message where that was not asked for."""
    done = python(FIRST, HOPHOOP_LIBRARY=str(tmp_path), HOPHOOP_KERNELS=wanted)
    assert done.returncode == 0, done.stderr
    assert done.stderr.count(BUILD) == done.stderr.count("\n") == (wanted == "auto")
    found, omega = json.loads(done.stdout)
    motion = hh.simulate(hh.Hoop.ideal(0.75), hh.Plane(), hh.Start.rolling(3.1), duration=2.0)
    assert found == json.loads(json.dumps(motion.to_dict()))
    assert omega == motion.at([0.5, 1.1]).omega.tolist()


def test_compiled_kernels_that_there_are_not(tmp_path):
    done = python(FIRST, HOPHOOP_LIBRARY=str(tmp_path), HOPHOOP_KERNELS="compiled")
    assert done.returncode == 1
    said = done.stderr.splitlines()[-1]
    assert said.startswith(
        "hophoop._support.errors.InputError: HOPHOOP_KERNELS = 'compiled': hophoop was installed without compiled kernels."
    )
    assert BUILD in said


@pytest.mark.compiled
def test_a_motion_imports_no_numba():
    done = python(FIRST, HOPHOOP_KERNELS="compiled")
    assert (done.returncode, done.stderr) == (0, "")


def test_a_mode_that_there_is_not():
    body = hh.Scenario().to_body()
    with (
        forced("fast"),
        pytest.raises(ValueError, match="HOPHOOP_KERNELS = 'fast' must be one of auto, compiled, interpreted"),
    ):
        compiled(lift_off)(body, 0.0)


def test_a_mode_that_is_forced_ends():
    before, asked = mode(), os.environ.get("HOPHOOP_KERNELS")
    with forced("interpreted"):
        assert mode() == "interpreted"
        with pytest.raises(ZeroDivisionError), forced("compiled"):
            1 / 0  # noqa: B018
        assert mode() == "interpreted"
    assert (mode(), os.environ.get("HOPHOOP_KERNELS")) == (before, asked)


@pytest.fixture
def called(monkeypatch):
    """The entries that are called from now on."""
    found = []
    call = Library.call

    def noted(self, name):
        function = call(self, name)

        def counted(*arguments):
            found.append(name.removeprefix("hophoop."))
            return function(*arguments)

        return counted

    monkeypatch.setattr(Library, "call", noted)
    with forced("compiled"):
        yield found


@pytest.mark.compiled
def test_a_motion_and_its_samples_are_few_calls(called):
    motion = hh.simulate(hh.Scenario(duration=2.0))
    assert called == ["kernel.rigid.run.run_cell"]
    motion.at(1.0)
    assert called == ["kernel.rigid.run.run_cell", "kernel.records.writing.kernel_times", "kernel.rigid.sampling.sample"]


# The same bits


def bits(scenario, samples):
    """Everything that a motion is, as bytes."""
    motion = hh.simulate(scenario)
    sample = motion.at(motion.times(samples))
    columns = [np.asarray(getattr(sample, name)).tobytes() for name in sample.__dataclass_fields__]
    return motion.status, motion._events.tobytes(), motion._segments.tobytes(), columns


def same_bits(scenario, samples=33):
    with forced("interpreted"):
        plain = bits(scenario, samples)
    with forced("compiled"):
        return bits(scenario, samples) == plain


@pytest.mark.compiled
@pytest.mark.parametrize("name", hh.article.scenarios())
def test_equal_bits_for_the_article(name):
    assert same_bits(hh.article.scenarios()[name])


@pytest.mark.compiled
def test_equal_bits_for_what_the_lab_offers():
    from hophoop.lab.site.presets import presets

    rigid = [preset for preset in presets() if preset.scenario.contact.model == "rigid"]
    assert len(rigid) > 10
    assert [preset.key for preset in rigid if not same_bits(preset.scenario)] == []


def random_scenario(rng):
    """Hoops, planes and starts of ordinary size, each kind often enough."""
    if rng.random() < 0.5:
        hoop = hh.Hoop.ideal(rng.uniform(0.0, 1.0), radius=rng.uniform(0.2, 2.0), mass=rng.uniform(0.1, 3.0))
    else:
        eps = rng.uniform(0.0, 0.99)
        hoop = hh.Hoop(eccentricity=eps, inertia_ratio=rng.uniform(0.01, 1.0) * (1.0 - eps * eps))
    plane = hh.Plane(
        mu=float(rng.choice([0.0, 0.05, 0.2, 0.5, 1.0, 3.0, math.inf])),
        slope=rng.uniform(-0.5, 0.5) if rng.random() < 0.3 else 0.0,
        restitution=rng.uniform(0.0, 1.0) if rng.random() < 0.3 else 0.0,
        impact_law=str(rng.choice(sorted(LAW_CODES))),
    )
    angle, vx, omega = rng.uniform(-3.0, 3.0), rng.uniform(-6.0, 6.0), rng.uniform(-8.0, 8.0)
    start = (
        hh.Start.rolling(vx, angle=angle if rng.random() < 0.5 else 0.0),
        hh.Start(angle=angle, vx=vx, omega=omega),
        hh.Start(height=rng.uniform(0.0, 1.0), angle=angle, vx=vx, vy=rng.uniform(-3.0, 3.0), omega=omega),
    )[int(rng.integers(3))]
    return hh.Scenario(hoop=hoop, plane=plane, start=start, duration=rng.uniform(0.5, 6.0), contact=hh.Rigid(max_events=300))


@pytest.mark.compiled
@pytest.mark.parametrize("count", [60, pytest.param(1000, marks=pytest.mark.slow)])
def test_equal_bits_at_random(count):
    rng = np.random.default_rng(count)
    different = []
    for _ in range(count):
        scenario = random_scenario(rng)
        if not same_bits(scenario, samples=9):
            different.append(scenario.to_query())
    assert different == []


@pytest.mark.compiled
def test_equal_bits_for_maps():
    values = {"start.speed": np.linspace(0.1, 5.0, 12), "plane.mu": np.linspace(0.2, 1.4, 12)}
    wanted = ("sequence", "hop_height", "energy_lost", "greatest_utilization", "takeoff_angle")
    with forced("interpreted"):
        plain = hh.maps.points(None, values, wanted)
    with forced("compiled"):
        fast = hh.maps.points(None, values, wanted)
    for name in wanted:
        np.testing.assert_array_equal(plain[name], fast[name])
