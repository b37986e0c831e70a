"""HOPHOOP_LEVEL limits which of the compiled libraries is taken."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from hophoop.kernel.native.library import library

CODE = "import hophoop as hh; print(hh.simulate(hh.Scenario(duration=1.0)).fingerprint); "
CODE += "from hophoop.kernel.native.library import library; print(library().level)"


def run(**environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", CODE],
        capture_output=True, text=True, check=False, env=os.environ | {"HOPHOOP_KERNELS": "compiled"} | environment,
    )  # fmt: skip


@pytest.mark.compiled
def test_the_library_of_each_level_gives_the_same_motion() -> None:
    found = library(quiet=True)
    assert found is not None
    told = {}
    for level in found.told["files"]:
        if level <= found.level:
            done = run(HOPHOOP_LEVEL=level)
            assert done.returncode == 0, done.stderr
            fingerprint, told[level] = done.stdout.split()
            assert fingerprint == run().stdout.split()[0]
    assert told == {level: level for level in told}
    assert run().stdout.split()[1] == max(told)


@pytest.mark.compiled
def test_an_unknown_level_is_refused() -> None:
    done = run(HOPHOOP_LEVEL="v9")
    assert done.returncode == 1
    assert "HOPHOOP_LEVEL = 'v9' must be one of v" in done.stderr.splitlines()[-1]
