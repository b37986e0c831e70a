"""Calls of kernels from Python: by the library where there is one, else interpreted; tests/test_bits.py compares both."""

import json
import os

import pytest

import hophoop as hh
from hophoop.kernel.native import compiled, forced, mode
from hophoop.kernel.native.library import BUILD, Library
from hophoop.theory.kernels.phase_plane import lift_off
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
    assert "HOPHOOP_KERNELS = 'compiled': hophoop was installed without compiled kernels." in done.stderr.splitlines()[-1]
    assert BUILD in done.stderr


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


def test_a_motion_and_its_samples_are_few_calls(monkeypatch):
    found, call = [], Library.call
    monkeypatch.setattr(Library, "call", lambda self, name: found.append(name.rpartition(".")[2]) or call(self, name))
    with forced("compiled"):
        hh.simulate(hh.Scenario(duration=2.0)).at(1.0)
    assert found == ["run_cell", "kernel_times", "sample"]
